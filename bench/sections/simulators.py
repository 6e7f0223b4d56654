"""Files for simulators: their sizes, and what their consumers get."""

import json

from .section import block, section
from .text import megabytes, percent, plain, table

EXTENSIONS = {"astm": "astm", "bird": "json", "csv": "csv", "eradiate": "nc", "merl": "binary", "openmaterial": "json",
              "radiance": "xml", "rgl": "bsdf", "ssdd": "ssdd", "zemax": "bsdf"}
SPECTRUM = "garnet-red-spectrum"
MONOCHROME = ["brown-vinyl", "garnet-red-paint", "white-ptfe", "yellow-retro-sheeting"]
NAMES = {"brown-vinyl": "brown vinyl", "garnet-red-paint": "garnet red paint", "white-ptfe": "white PTFE",
         "yellow-retro-sheeting": "yellow retro-reflective sheeting",
         SPECTRUM: "garnet red paint, spectrum (five bands as colours)"}
SIMULATORS_PYTHON = ".build/python/simulators/bin/python3"


def measured(program, material, format_name):
    """What `validate` says of the file that `generate` writes at its defaults."""
    file = f"{material}.{EXTENSIONS[format_name]}"
    path = program.materials[material]
    program.brdftab("generate", "-q", path, "--format", format_name, "-o", file, "--force")
    # A verdict is not a figure: a file that the format holds badly has its errors in the table all the same.
    carried = ["--material", path] if format_name == "merl" else []
    found = json.loads(program.brdftab("validate", "-q", file, "--json", *carried, may_fail=True))
    return {"bytes": (program.folder / file).stat().st_size,
            **{kind: {key: found[kind][key] for key in ("median", "95_percent")} for kind in ("uniform", "near_peaks")},
            "reciprocity_median": found["reciprocity"]["median"]}


@section()
def simulators(program):
    """Sizes of the files for simulators at their defaults, and their errors as validate gives them."""
    figures = {name: {material: measured(program, material, name) for material in MONOCHROME} for name in EXTENSIONS}
    figures["rgl"][SPECTRUM] = measured(program, SPECTRUM, "rgl")
    return figures


def both(errors):
    return f"{percent(errors['median'])}; {percent(errors['95_percent'])}"


@block
def simulator_errors(results):
    """A row for formats of the same errors: they hold the same samples."""
    rows = {}
    for name, found in results["simulators"].items():
        errors = tuple(both(found[material]["uniform"]) for material in MONOCHROME)
        rows.setdefault(errors, []).append((f"`{name}`", megabytes(found["garnet-red-paint"]["bytes"])))
    return table(["format", "file", *(NAMES[material] for material in MONOCHROME)],
                 [[*map(", ".join, zip(*files)), *errors] for errors, files in rows.items()])


@block
def rgl_errors(results):
    found = results["simulators"]["rgl"]
    return table(["material", "median; at 95 %", "near the mirror and retro directions: median; at 95 %"],
                 [[NAMES[material], both(errors["uniform"]), both(errors["near_peaks"])] for material, errors in found.items()])


@block
def reciprocity_defect(results):
    medians = [found["reciprocity_median"] for found in results["simulators"]["merl"].values()]
    return f"{plain(min(medians))} to {plain(max(medians))}"


@section()
def mitsuba_weights(program):
    """How far weights of Mitsuba's samples deviate from their mean, drawn by its measured BSDF and evenly."""
    return json.loads(program.run(program.root / SIMULATORS_PYTHON, program.root / "bench/mitsuba_weights.py",
                                  program.build / "brdftab", *program.materials.values()))


def deviations(results, kind):
    values = [x for found in results["mitsuba-weights"].values() for x in found[kind]]
    return f"{plain(100 * min(values), 1)} to {percent(max(values))}"


@block
def weights_sampled(results):
    return deviations(results, "sampled")


@block
def weights_even(results):
    return deviations(results, "even")
