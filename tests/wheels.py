"""Modules that come as wheels of PyPI, from the environments that tests/make-environment makes."""

import pathlib
import sys
import unittest

ENVIRONMENTS = pathlib.Path(__file__).resolve().parent.parent / ".build" / "python"


def interpreter(name):
    """The interpreter of an environment. Skips the tests where its wheels could not be had."""
    missing = ENVIRONMENTS / f"{name}.missing"
    if missing.exists():
        raise unittest.SkipTest(missing.read_text().strip())
    python = ENVIRONMENTS / name / "bin" / "python3"
    if not python.exists():
        raise FileNotFoundError(f"{python}: tests/run makes it")
    return python


def use(name):
    """Makes an environment's wheels importable here; Debian's modules come first."""
    library = interpreter(name).parent.parent / "lib" / f"python{sys.version_info.major}.{sys.version_info.minor}" / "site-packages"
    if not library.is_dir():
        raise FileNotFoundError(f"{library}: made by another Python")
    if str(library) not in sys.path:
        sys.path.append(str(library))
