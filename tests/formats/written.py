"""What tests of simulators' files share: a golden direction, angles, and files that `generate` writes."""

import json
import math

import scalar_reference
from program import DONE, VINYL, InFolder, run

# A golden direction off the specular one and off the plane of incidence. It is a node of every file whose axes are free:
# its value says where specular sits, and tells degrees from radians, f from f cos and pi f, a centre from a node.
THETA_I, THETA_S, PHI = 60, 31.71, -7.17
AXES = ["--theta-i", f"0,{THETA_I}", "--theta-s", f"0,{THETA_S},80", "--phi-s", f"-180,{PHI},0,100,180"]

BANDS = """
[[band]]
wavelength_nm = 450.0
sigma_bulk = 0.03

[[band]]
wavelength_nm = 550.5

[[band]]
wavelength_nm = 650.0
sigma_bulk = 0.21
"""


def golden():
    """f at that direction, of scalar_reference.VINYL, by an independent implementation."""
    return scalar_reference.golden(THETA_I, THETA_S, PHI)


def unit(theta, phi):
    theta, phi = math.radians(theta), math.radians(phi)
    return [math.sin(theta) * math.cos(phi), math.sin(theta) * math.sin(phi), math.cos(theta)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def model_angles(to_light, to_viewer):
    """theta_i, theta_s and phi (0 forward) of vectors away from the surface: the mirrored light is forward."""
    forward = [-to_light[0], -to_light[1]]
    phi = math.atan2(to_viewer[1], to_viewer[0]) - math.atan2(forward[1], forward[0])
    return math.degrees(math.acos(to_light[2])), math.degrees(math.acos(to_viewer[2])), math.degrees(phi)


class Written(InFolder):
    """generate, validate and refusals, with one material of one band and one of three."""

    def setUp(self):
        super().setUp()
        self.bands = self.folder / "bands.toml"
        self.bands.write_text(VINYL.read_text() + BANDS)

    def generate(self, name, *options, material=VINYL):
        file = self.folder / name
        result = run("generate", material, "-o", file, "--force", *options)
        self.assertEqual(result.returncode, DONE, result.stderr)
        self.said = result.stderr
        return file

    def assert_close(self, value, expected, digits):
        self.assertLess(abs(value / expected - 1), 10.0**-digits, f"{value!r} against {expected!r}")

    def validate(self, file, *options):
        result = run("validate", file, "--json", "--samples", 2000, *options)
        self.assertEqual(result.returncode, DONE, result.stderr)
        return json.loads(result.stdout)
