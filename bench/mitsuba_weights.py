"""How far weights of Mitsuba 3's samples deviate from their mean: drawn as its measured BSDF draws, and evenly.

usage: .build/python/simulators/bin/python3 bench/mitsuba_weights.py BRDFTAB MATERIAL.toml...

tests/run makes that environment. Prints JSON: for each material the standard deviations over the mean, by view.
"""

import json
import pathlib
import subprocess
import sys
import tempfile

import drjit
import mitsuba
import numpy

VIEWS = [10, 30, 45, 60, 75, 85]  # degrees
COUNT = 200_000
mitsuba.set_variant("llvm_ad_rgb")


def deviation(weights):
    return float(weights.std() / weights.mean())


def deviations(bsdf, view):
    surface, context = drjit.zeros(mitsuba.SurfaceInteraction3f, COUNT), mitsuba.BSDFContext()
    angle = numpy.radians(view)
    surface.wi = mitsuba.Vector3f(float(numpy.sin(angle)), 0, float(numpy.cos(angle)))
    random = mitsuba.load_dict({"type": "independent"})
    random.seed(7, COUNT)
    _, weight = bsdf.sample(context, surface, random.next_1d(), random.next_2d())
    light = mitsuba.warp.square_to_uniform_hemisphere(random.next_2d())
    return deviation(numpy.array(weight)[0]), deviation(numpy.array(bsdf.eval(context, surface, light))[0])


def main():
    program, *materials = sys.argv[1:]
    figures = {}
    with tempfile.TemporaryDirectory() as folder:
        for material in map(pathlib.Path, materials):
            file = pathlib.Path(folder) / f"{material.stem}.bsdf"
            subprocess.run([program, "generate", "-q", material, "--format", "rgl", "-o", file], check=True)
            bsdf = mitsuba.load_dict({"type": "measured", "filename": str(file)})
            sampled, even = zip(*(deviations(bsdf, view) for view in VIEWS))
            figures[material.stem] = {"views_deg": VIEWS, "sampled": sampled, "even": even}
    print(json.dumps(figures))


if __name__ == "__main__":
    main()
