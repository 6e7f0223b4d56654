"""Axes that --interpolation-error chooses."""

import re
import sys

from .section import block, section
from .simulators import NAMES
from .text import power, table

ASKED = "2%"
FOUND = re.compile(r"^(\S+): asked .*?: (\d+) nodes; largest error at \d+ random directions (\S+) at .*; the table says (\S+)$",
                   re.MULTILINE)
UNIFORM = {"alone": "uniform axes, each alone within", "together": "uniform axes, together within"}


def chosen_figures(measured, dry_runs):
    """From what bench/interpolation_error.py prints, and the texts of --dry-run by material."""
    figures = {}
    for name, nodes, from_file, told in FOUND.findall(measured):
        figures[name] = {"nodes": int(nodes), "largest": float(told), "largest_from_file": float(from_file)}
        for key, words in UNIFORM.items():
            sizes = re.findall(rf"^ *(\d+) .*{words} [\d.]+(, at uniform directions only)?$", dry_runs[name], re.MULTILINE)
            figures[name] |= {f"uniform_{key}{'_uniform_directions' if only else ''}": int(size) for size, only in sizes}
    return figures


@section(long=True)
def chosen_axes(program):
    """Nodes and errors of axes chosen for 2 %, and of uniform ones; the last material's table has some 200 million nodes."""
    names = ("brown-vinyl", "white-ptfe", "garnet-red-paint", "yellow-retro-sheeting")
    materials = {name: program.materials[name] for name in names}
    measured = program.run(sys.executable, program.root / "bench/interpolation_error.py", program.build / "brdftab", ASKED,
                           *materials.values())
    dry_runs = {name: program.brdftab("generate", path, "-o", "table.h5", "--interpolation-error", ASKED, "--dry-run")
                for name, path in materials.items()}
    return chosen_figures(measured, dry_runs)


@block
def chosen_axes_table(results):
    rows = [[NAMES[name], f"{found['nodes']:,}".replace(",", " "), f"{100 * found['largest']:.2f} %",
             f"{100 * found['largest_from_file']:.2f} %", f"{power(found['uniform_alone'])}; {power(found['uniform_together'])}",
             f"{power(found['uniform_alone_uniform_directions'])}; {power(found['uniform_together_uniform_directions'])}"]
            for name, found in results["chosen-axes"].items()]
    return table(["material", "nodes chosen", "largest error", "largest at 10 000 uniform directions, from the file",
                  "uniform grid: at least; one that does", "the same, at uniform directions only"], rows)
