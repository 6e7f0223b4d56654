"""Zemax BSDF files, read by a parser of its own here, written from the format's description, not from the program."""

import csv
import math
import unittest

import scalar_reference
from program import BAD_INPUT, MATERIALS, VINYL, run
from written import PHI, THETA_I, THETA_S, Written, dot, golden, unit


class Zemax(Written):
    def parse(self, file):
        """Axes and blocks: {content: [(TIS, rows of azimuth)] by incidence}."""
        lines = [line for line in file.read_text().split("\n") if not line.startswith("#")]
        self.assertTrue(all(line == line.strip() and "  " not in line for line in lines), "one tab between numbers, none at the end")
        keywords = dict(line.split("\t") for line in lines[:4])
        axes, k = {}, 4
        while lines[k]:
            name, count = lines[k].split("\t")
            axes[name] = [float(x) for x in lines[k + 1].split("\t")]
            self.assertEqual(len(axes[name]), int(count))
            k += 2
        blocks, content = {}, None
        for line in lines[k + 1 :]:
            if line.startswith(("Monochrome", "Tristimulus")):
                content = blocks.setdefault(line, [])
            elif line.startswith("TIS"):
                content.append((float(line.split("\t")[1]), []))
            elif line and line not in ("DataBegin", "DataEnd"):
                content[-1][1].append([float(x) for x in line.split("\t")])
        return keywords, axes, blocks

    def specular_angles(self, theta_i, theta_s, phi):
        """Radial angle from the specular direction, and azimuth about it, 0 toward the normal, of the model's angles."""
        specular, viewer = unit(theta_i, 0), unit(theta_s, phi)
        toward_normal = unit(theta_i - 90, 0)  # at right angles to the specular direction, in plane
        return math.degrees(math.acos(dot(specular, viewer))), math.degrees(math.atan2(abs(viewer[1]), dot(toward_normal, viewer)))

    def test_golden_direction(self):
        radial, azimuth = self.specular_angles(THETA_I, THETA_S, PHI)
        self.assertTrue(20 < radial < 40 and 1 < azimuth < 30)
        file = self.generate("a.bsdf", "--format", "zemax", "--zemax-incidence", f"0,{THETA_I}", "--zemax-radial", f"0,{radial!r},50", "--zemax-azimuth", f"0,{azimuth!r},180", material=scalar_reference.VINYL)
        keywords, axes, blocks = self.parse(file)
        self.assertEqual(keywords, {"Source": "Measured", "Symmetry": "PlaneSymmetrical", "SpectralContent": "Monochrome", "ScatterType": "BRDF"})
        self.assertEqual(axes["AngleOfIncidence"], [0, THETA_I])
        tis, rows = blocks["Monochrome"][1]
        self.assert_close(rows[1][1], golden(), 6)

    def test_tis_is_the_reflectance(self):
        _, axes, blocks = self.parse(self.generate("a.bsdf", "--format", "zemax"))
        result = run("integrate", VINYL, "--engine", "reference", "--theta-i", "0,30,60,85")
        rows = list(csv.DictReader(line for line in result.stdout.splitlines() if not line.startswith("#")))
        for row in rows:
            tis, _ = blocks["Monochrome"][axes["AngleOfIncidence"].index(float(row["theta_i_deg"]))]
            self.assert_close(tis, float(row["dhr"]), 7)

    def test_below_the_horizon_is_nothing(self):
        _, axes, blocks = self.parse(self.generate("a.bsdf", "--format", "zemax"))
        i, r = axes["AngleOfIncidence"].index(60), axes["ScatterRadial"].index(40)
        rows = blocks["Monochrome"][i][1]
        self.assertGreater(rows[0][r], 0)  # theta_s = 20
        self.assertEqual(rows[-1][r], 0)  # theta_s = 100

    def test_several_bands_are_xyz(self):
        file = self.generate("a.bsdf", "--format", "zemax", material=self.bands)
        keywords, _, blocks = self.parse(file)
        self.assertEqual(keywords["SpectralContent"], "XYZ")
        self.assertEqual(list(blocks), ["TristimulusX", "TristimulusY", "TristimulusZ"])
        self.assertGreater(blocks["TristimulusX"][0][1][0][0], blocks["TristimulusZ"][0][1][0][0])
        self.assertLess(self.validate(file)["uniform"]["median"], 0.01)

    def test_reflectance_above_one_is_said(self):
        self.generate("a.bsdf", "--format", "zemax", material=MATERIALS / "white-ptfe.toml")
        self.assertRegex(self.said, r"TIS, the model's DHR, is above 1 at \d+ of 35 incidences")

    def test_axes_that_miss_the_plane_of_symmetry(self):
        result = run("generate", VINYL, "-o", self.folder / "a.bsdf", "--format", "zemax", "--zemax-azimuth", "0:90:5")
        self.assertEqual(result.returncode, BAD_INPUT)
        self.assertIn("--zemax-azimuth 0:90:5", result.stderr)


if __name__ == "__main__":
    unittest.main()
