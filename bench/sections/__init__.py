"""What bench/figures measures: a module for each part of the texts."""

from . import accuracy, axes, fits, simulators, speed, storage  # noqa: F401: they register their sections and blocks
from .section import BLOCKS, SECTIONS  # noqa: F401
