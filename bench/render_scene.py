"""Renders the shipped materials with Mitsuba 3, each from its RGL file, to a PNG picture.

usage: .build/python/simulators/bin/python3 bench/render_scene.py BRDFTAB MATERIAL.toml... PICTURE.png

tests/run makes that environment. Upper row: a lamp to the left and behind, and a little light from everywhere. Lower row:
a lamp beside the camera, whose light only retro-reflection and a material's even part send back.
"""

import pathlib
import subprocess
import sys
import tempfile

import mitsuba
import numpy

WIDTH, HEIGHT = 960, 460
mitsuba.set_variant("llvm_ad_rgb")
from mitsuba import ScalarTransform4f as Transform  # noqa: E402


def scene(files, lamps, samples):
    """A row of spheres on a dark ground."""
    camera = [0, 1.5, 3 * len(files)]
    result = {
        "type": "scene",
        "integrator": {"type": "path", "max_depth": 3, "hide_emitters": True},
        "sensor": {"type": "perspective", "fov": 40, "fov_axis": "x",
                   "to_world": Transform().look_at(camera, [0, 0.12, 0], [0, 1, 0]),
                   "film": {"type": "hdrfilm", "width": WIDTH, "height": HEIGHT // 2, "pixel_format": "rgb"},
                   "sampler": {"type": "multijitter", "sample_count": samples}},
        "ground": {"type": "rectangle", "to_world": Transform().translate([0, -1, 0]).rotate([1, 0, 0], -90).scale(60),
                   "bsdf": {"type": "diffuse", "reflectance": 0.08}},
    } | lamps
    for k, file in enumerate(files):
        result[f"sphere_{k}"] = {"type": "sphere", "center": [2.15 * (k - (len(files) - 1) / 2), 0, 0], "radius": 1,
                                 "bsdf": {"type": "measured", "filename": str(file)}}
    return mitsuba.load_dict(result)


def lamp(place, radius, radiance):
    return {"type": "sphere", "center": place, "radius": radius, "emitter": {"type": "area", "radiance": radiance}}


def main(brdftab, *materials, picture, samples=144):
    with tempfile.TemporaryDirectory() as folder:
        files = []
        for material in materials:
            files.append(pathlib.Path(folder) / f"{pathlib.Path(material).stem}.bsdf")
            subprocess.run([brdftab, "generate", material, "--format", "rgl", "-o", files[-1]], check=True)
        beside_camera = lamp([0, 2.3, 3 * len(files) + 0.6], 0.35, 16 * len(files) ** 2)
        rows = [{"side": lamp([-12, 9, -6], 1.5, 60), "sky": {"type": "constant", "radiance": 0.25}},
                {"camera_lamp": beside_camera, "sky": {"type": "constant", "radiance": 0.02}}]
        images = [numpy.array(mitsuba.render(scene(files, lamps, samples))) for lamps in rows]
    radiance = numpy.concatenate(images)
    image = mitsuba.Bitmap((radiance / (0.8 + radiance)).astype(numpy.float32))  # Reinhard's tone curve
    image.convert(mitsuba.Bitmap.PixelFormat.RGB, mitsuba.Struct.Type.UInt8, srgb_gamma=True).write(picture)


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    main(*sys.argv[1:-1], picture=sys.argv[-1])
