"""Eradiate's files, judged by Eradiate in a simulation, and by the rules that its reader has."""

import json
import math
import random
import re
import subprocess
import unittest

import numpy
import xarray

import scalar_reference
import wheels
from program import BAD_INPUT, DONE, ROOT, InFolder, run
from scalar_reference import VINYL

# The scene has parallel light from one direction and is seen from many: Eradiate finds f from radiances.
SIMULATION = """
import json, sys
import numpy
import eradiate
from eradiate import unit_registry as ureg
from eradiate.experiments import AtmosphereExperiment

eradiate.set_mode("mono")
asked = json.load(sys.stdin)
experiment = AtmosphereExperiment(
    atmosphere=None,
    surface={"type": "basic", "bsdf": {"type": "mqdiffuse", "data": asked["file"]}},
    illumination={"type": "directional", "zenith": asked["light"][0], "azimuth": asked["light"][1],
                  "irradiance": {"type": "uniform", "value": 2.0}},
    measures={"type": "mdistant", "construct": "from_angles", "angles": numpy.array(asked["viewers"]) * ureg.deg, "spp": 1,
              "srf": {"type": "delta", "wavelengths": 550 * ureg.nm}})
result = eradiate.run(experiment)
json.dump(result.brdf.values.ravel().tolist(), open(asked["out"], "w"))
"""

# The kernel interpolates in double precision between the file's float32.
ROUNDED = 1e-6


class Written(InFolder):
    def written(self, material=VINYL, *options, name="file.nc"):
        file = self.folder / name
        result = run("generate", material, "--format", "eradiate", "-o", file, "--force", *options)
        self.assertEqual(result.returncode, DONE, result.stderr)
        return file

    def simulated(self, file, theta_i, pairs):
        """f in 1/sr at theta_i and the pairs (theta_s, phi) of the model."""
        out = self.folder / "out.json"
        light = 70.0  # the azimuth of the vector to the light; forward is opposite
        viewers = [(theta_s, (light + 180 + phi) % 360) for theta_s, phi in pairs]
        asked = {"file": str(file), "light": (theta_i, light), "viewers": viewers, "out": str(out)}
        result = subprocess.run([wheels.interpreter("eradiate"), "-c", SIMULATION], capture_output=True, text=True, timeout=300,
                                input=json.dumps(asked))
        self.assertEqual(result.returncode, 0, result.stderr[-2000:])
        return json.loads(out.read_text())


class Simulation(Written):
    def test_golden_direction(self):
        (theta_i, theta_s, phi), expected = scalar_reference.off_plane()
        found, = self.simulated(self.written(), theta_i, [(theta_s, phi)])
        self.assertAlmostEqual(found / expected, 1, delta=2e-3)

    def test_nodes(self):
        file = self.written(VINYL, "--eradiate-cosines", 11, "--eradiate-azimuths", 12)
        draw = random.Random(5)
        theta_i = math.degrees(math.acos(0.7))
        pairs = [(math.degrees(math.acos(draw.randrange(1, 10) / 10)), 30.0 * draw.randrange(12)) for _ in range(40)]
        f = scalar_reference.brdf(VINYL, [(theta_i, theta_s, phi) for theta_s, phi in pairs])
        for pair, found, expected in zip(pairs, self.simulated(file, theta_i, pairs), f, strict=True):
            self.assertAlmostEqual(found / expected, 1, delta=10 * ROUNDED, msg=f"theta_s, phi = {pair}")

    def test_between_nodes_and_where_specular_lies(self):
        draw = random.Random(5)
        pairs = [(draw.uniform(0, 75), draw.uniform(0, 360)) for _ in range(200)] + [(60, 0), (60, 180)]
        found = self.simulated(self.written(), 60.0, pairs)
        f = scalar_reference.brdf(VINYL, [(60, theta_s, phi) for theta_s, phi in pairs])
        errors = sorted(abs(a / b - 1) for a, b in zip(found, f, strict=True))
        self.assertLess(errors[100], 2e-3)
        self.assertLess(errors[190], 0.02)
        forward, backward = found[-2:]
        self.assertGreater(forward, 5 * backward)


class Readme(Written):
    def test_usage(self):
        (self.folder / ".build").mkdir()
        result = run("generate", VINYL, "--format", "eradiate", "-o", self.folder / ".build" / "vinyl.nc")
        self.assertEqual(result.returncode, DONE, result.stderr)
        script = re.search(r"```python\n(import eradiate.*?)```", (ROOT / "README.md").read_text(), re.DOTALL).group(1)
        result = subprocess.run([wheels.interpreter("eradiate"), "-c", script], capture_output=True, text=True, timeout=300,
                                cwd=self.folder)
        self.assertEqual(result.returncode, 0, result.stderr[-2000:])
        found = [float(line.split()[1]) for line in result.stdout.splitlines() if re.match(r"\d", line)]
        # Light comes from 30 degrees at azimuth 0, and negative viewing angles lie opposite.
        f = scalar_reference.brdf(VINYL, [(30, 60, 0), (30, 30, 0), (30, 0, 0), (30, 30, 180), (30, 60, 180)])
        for a, b in zip(found, f, strict=True):
            self.assertAlmostEqual(a / b, 1, delta=5e-3)


class Rules(Written):
    """What Eradiate's MQDiffuseBSDF documents and checks: names, even coordinates, units."""

    def test_coordinates_and_samples(self):
        with xarray.open_dataset(self.written()) as data:
            self.assertEqual(data.brdf.dims, ("cos_theta_o", "phi_d", "cos_theta_i"))
            self.assertEqual(data.brdf.attrs["units"], "sr-1")
            for name in ("cos_theta_o", "cos_theta_i"):
                numpy.testing.assert_allclose(data[name], numpy.linspace(0, 1, 91), rtol=0, atol=1e-12)
                self.assertEqual(data[name].attrs["units"], "1")
            numpy.testing.assert_allclose(data.phi_d, numpy.linspace(0, 2 * math.pi, 180, endpoint=False), rtol=0, atol=1e-12)
            self.assertEqual(data.phi_d.attrs["units"], "rad")
            draw = random.Random(1)
            nodes = [(draw.randrange(1, 91), draw.randrange(180), draw.randrange(1, 91)) for _ in range(200)]
            nodes += [(0, 20, 45), (45, 20, 0)]  # at a cosine of 0: half way to the next
            theta = [math.degrees(math.acos(max(k, 0.5) / 90)) for k in range(91)]
            # The difference of azimuths away from the surface is 180 degrees at the specular direction.
            f = scalar_reference.brdf(VINYL, [(theta[i], theta[o], 2 * d - 180) for o, d, i in nodes])
            for node, expected in zip(nodes, f, strict=True):
                self.assertAlmostEqual(float(data.brdf[node]) / expected, 1, delta=ROUNDED, msg=f"{node}")
            self.assertEqual(data.attrs["material"], VINYL.read_text())

    def test_one_band_of_several(self):
        spectrum = self.folder / "spectrum.toml"
        text = VINYL.read_text()
        spectrum.write_text(text + "[[band]]\nwavelength_nm = 450.0\nsigma_bulk = 0.2\n[[band]]\nwavelength_nm = 650.0\n")
        refused = run("generate", spectrum, "--format", "eradiate", "-o", self.folder / "file.nc")
        self.assert_refused(refused, BAD_INPUT, spectrum, "--wavelength")
        with xarray.open_dataset(self.written(spectrum, "--wavelength", 650)) as one, xarray.open_dataset(
                self.written(name="plain.nc")) as plain:
            numpy.testing.assert_array_equal(one.brdf, plain.brdf)
            self.assertEqual(one.attrs["wavelength_nm"], 650)


if __name__ == "__main__":
    unittest.main()
