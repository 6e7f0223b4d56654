"""fit of MERL files: directions over the hemisphere, a stated and seeded choice, compared with the model's own means."""

import re
import tomllib
import unittest

from program import DONE, MATERIALS, InFolder, run


class MerlFit(InFolder):
    def setUp(self):
        super().setUp()
        self.file = self.folder / "x.binary"

    def fit(self, *options):
        material = self.folder / "x.toml"
        result = run("fit", self.file, "-o", material, "--force", "--channel", "R", "--starts", "6", "--intervals", "linear", *options)
        self.assertEqual(result.returncode, DONE, result.stderr)
        return result, tomllib.loads(material.read_text())["parameters"]

    def test_a_shipped_material_comes_back(self):
        truth = MATERIALS / "garnet-red-paint.toml"
        self.assertEqual(run("generate", truth, "--format", "merl", "-o", self.file, "-q").returncode, DONE)
        fixed = [word for name in ("sigma_retro=0", "rho_retro=1", "w_a=0", "w_b=0", "gamma=0", "delta=0") for word in ("--fix", name)]
        result, fitted = self.fit("--merl-samples", "450", *fixed)
        self.assertRegex(result.stderr, r"x.binary: 450 directions over the hemisphere \(--merl-samples\), drawn with seed 1 "
                                        r"\(--merl-seed\), .* in 1458000 cells: .*mean over about a degree")
        # The file is the mean over exchanges of a material that is not reciprocal: only a fit that knows it finds the material.
        self.assertLess(float(re.search(r"each incidence alike: (\S+)", result.stdout).group(1)), 5e-3)
        for name, value in tomllib.loads(truth.read_text())["parameters"].items():
            self.assertAlmostEqual(fitted[name], value, delta=0.02 * abs(value) + 1e-12, msg=name)
        again, same = self.fit("--merl-samples", "450", *fixed)
        self.assertEqual(same, fitted)
        self.assertEqual(again.stdout, result.stdout)
        _, other = self.fit("--merl-samples", "450", "--merl-seed", "2", *fixed)
        self.assertNotEqual(other, fitted)

    def test_shadowing_comes_back(self):
        """V_m of the light's side and of the view's differ, and the azimuth that it takes has no meaning at the normal."""
        truth = MATERIALS / "brown-vinyl.toml"
        self.assertEqual(run("generate", truth, "--format", "merl", "-o", self.file, "-q").returncode, DONE)
        parameters = tomllib.loads(truth.read_text())["parameters"]
        free = ("sigma_bulk", "w_a", "gamma")
        fixed = [word for name, value in parameters.items() if name not in free for word in ("--fix", f"{name}={value}")]
        result, fitted = self.fit("--merl-samples", "400", *fixed)
        self.assertLess(float(re.search(r"each incidence alike: (\S+)", result.stdout).group(1)), 2e-3)
        for name in free:
            self.assertAlmostEqual(fitted[name] / parameters[name], 1, delta=2e-3, msg=name)

    def test_pictures_show_the_plane_of_incidence(self):
        material = MATERIALS / "brown-vinyl.toml"
        self.assertEqual(run("generate", material, "--format", "merl", "-o", self.file, "-q").returncode, DONE)
        result = run("plot", material, "-o", self.folder / "x.svg", "--data", self.file, "--channel", "G")
        self.assertEqual(result.returncode, DONE, result.stderr)
        self.assertIn("729 directions in plane, in 1458000 cells", result.stderr)
        self.assertNotIn("warning", result.stderr)


if __name__ == "__main__":
    unittest.main()
