"""Tables: their sizes by option, and the error of interpolation on the default grid."""

import json

from .section import block, section
from .text import megabytes, percent, plain, table

GRID = ["--phi-i", "0:350:10", "--phi-s", "0:360:0.25"]
OPTIONS = ["", "--compress deflate", "--compress deflate --keep-bits 15", "--compress deflate --keep-bits 12", "--layout virtual",
           "--layout virtual --compress deflate --keep-bits 12"]


def size_of_table(program, options):
    file = program.folder / "table.h5"
    program.brdftab("generate", "-q", program.materials["garnet-red-paint"], "-o", file.name, "--force", *GRID, *options.split())
    return file.stat().st_size


@section()
def table_sizes(program):
    """Bytes of a table of all four angles of garnet red paint, by option."""
    return {options: size_of_table(program, options) for options in OPTIONS}


@block
def table_sizes_table(results):
    sizes = results["table-sizes"]
    return table(["options", "file", "ratio"],
                 [[f"`{options}`" if options else "none", megabytes(size), plain(sizes[""] / size)]
                  for options, size in sizes.items()])


def error_at_cell_centres(program, material):
    program.brdftab("generate", "-q", program.materials[material], "-o", "table.h5", "--force")
    found = json.loads(program.brdftab("validate", "-q", "table.h5", "--json"))["interpolation"]["cell_centres"]["linear"]
    return {key: found[key] for key in ("median", "95_percent", "max")}


@section()
def cell_centres(program):
    """The error of linear interpolation at the cell centres of each shipped material's default grid."""
    return {material: error_at_cell_centres(program, material) for material in program.materials}


def span(values, show):
    low, high = show(min(values)), show(max(values))
    return f"{low.removesuffix(' %')} to {high}"


@block
def cell_centres_median(results):
    return span([found["median"] for found in results["cell-centres"].values()], lambda x: percent(x, 1))


@block
def cell_centres_95_percent(results):
    return span([found["95_percent"] for found in results["cell-centres"].values()], lambda x: percent(x, 1))


@block
def cell_centres_max(results):
    return plain(max(found["max"] for found in results["cell-centres"].values()), 1)
