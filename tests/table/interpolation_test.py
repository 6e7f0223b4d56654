"""Axes that `generate --interpolation-error` chooses, measured from outside at directions between the nodes."""

import json
import re
import sys
import unittest

import h5py
import numpy

from program import BAD_INPUT, DONE, MATERIALS, PROGRAM, ROOT, VINYL, InFolder, run

sys.path.insert(0, str(ROOT / "bench"))
from interpolation_error import FLOOR, measure  # noqa: E402

PTFE = MATERIALS / "white-ptfe.toml"


class Measured(unittest.TestCase):
    def check(self, material, error, count=10_000):
        nodes, errors, points, attributes = measure(PROGRAM, error, material, count)
        asked = float(error.rstrip("%")) / 100
        self.assertEqual(len(errors), count)
        self.assertLessEqual(errors.max(), asked, [x[errors.argmax()] for x in points])
        # The error is not far below either, for nodes would be wasted.
        self.assertGreater(errors.max(), asked / 5)
        self.assertEqual(attributes["interpolation_error_asked"], asked)
        self.assertLessEqual(attributes["interpolation_error_reached"], asked)
        self.assertGreater(attributes["interpolation_error_reached"], asked / 5)
        self.assertEqual(attributes["interpolation_floor"], FLOOR)

    def test_broad_lobes(self):
        self.check(VINYL, "2%")
        self.check(PTFE, "2%")

    def test_narrow_lobes(self):
        # There are fewer random directions, since each costs N at its own theta_i.
        self.check(MATERIALS / "garnet-red-paint.toml", "10%", 2000)
        self.check(MATERIALS / "yellow-retro-sheeting.toml", "10%", 2000)


class Choice(InFolder):
    def make(self, material, *options):
        table = self.folder / "table.h5"
        result = run("generate", material, "-o", table, "--force", *options)
        self.assertEqual(result.returncode, DONE, result.stderr)
        return table

    def test_ends_stay_and_steps_follow_the_lobes(self):
        table = self.make(VINYL, "--interpolation-error", "5%", "--theta-i", "10,60", "--theta-s", "2,88", "--phi-i", "20",
                          "--phi-s=-160,200")
        with h5py.File(table) as file:
            axes = {name: file[name][:] for name in ("theta_i", "phi_i", "theta_s", "phi_s")}
        for name, first, last in (("theta_i", 10, 60), ("phi_i", 20, 20), ("theta_s", 2, 88), ("phi_s", -160, 200)):
            self.assertEqual((axes[name][0], axes[name][-1]), (first, last))
        # phi is folded about the plane of incidence.
        steps = numpy.diff(axes["phi_s"])
        self.assertLess(numpy.max(abs(steps - steps[::-1])), 1e-5)
        self.assertGreater(steps.max() / steps.min(), 5)
        self.assertIn(20, axes["phi_s"])
        found = run("validate", table, "--json")
        self.assertEqual(found.returncode, DONE, found.stderr)
        centres = json.loads(found.stdout)["interpolation"]
        self.assertEqual(centres["floor"], FLOOR)
        self.assertLess(centres["cell_centres"]["linear"]["95_percent"], 0.05)

    def test_an_axis_of_one_node_stays(self):
        with h5py.File(self.make(VINYL, "--interpolation-error", "0.05", "--theta-i", "45")) as file:
            self.assertEqual(list(file["theta_i"]), [45])
            self.assertGreater(len(file["theta_s"]), 5)

    def test_every_band_and_polarisation_counts(self):
        spectral = self.folder / "spectral.toml"
        narrow = "[[band]]\nwavelength_nm = 450\n[[band]]\nwavelength_nm = 650\nrho_surface = 0.1\n"
        spectral.write_text(VINYL.read_text() + narrow)
        with h5py.File(self.make(VINYL, "--interpolation-error", "5%")) as file:
            one = file["brdf"].size
        with h5py.File(self.make(spectral, "--interpolation-error", "5%", "--polarization", "p")) as file:
            self.assertGreater(file["brdf_p"][0].size, 4 * one)

    def test_finer_takes_more(self):
        sizes = []
        for error in ("20%", "5%"):
            with h5py.File(self.make(PTFE, "--interpolation-error", error)) as file:
                sizes.append(file["brdf"].size)
        # With linear interpolation along three axes, the number of nodes goes with error^-1.5.
        self.assertGreater(sizes[1] / sizes[0], 3)
        self.assertLess(sizes[1] / sizes[0], 24)

    def test_dry_run(self):
        result = run("generate", VINYL, "-o", self.folder / "t.h5", "--interpolation-error", "5%", "--dry-run")
        self.assertEqual(result.returncode, DONE, result.stderr)
        self.assertEqual(list(self.folder.iterdir()), [])
        rows = [line.split() for line in result.stdout.splitlines() if re.match(r" *\d+ ", line)]
        sizes = [int(row[0]) for row in rows]
        errors = [float(row[8]) for row in rows[:-4]]
        self.assertEqual(sizes[:6], sorted(sizes[:6]))
        self.assertEqual(errors[:6], sorted(errors[:6], reverse=True))
        chosen, *uniform = sizes[6:]
        self.assertLessEqual(errors[6], 0.05)
        self.assertIn("chosen for 0.05", result.stdout)
        self.assertEqual(len(uniform), 4)
        self.assertLess(chosen, min(uniform) / 4)

    def test_refusals(self):
        def refused(*options):
            return run("generate", VINYL, "-o", self.folder / "t.h5", *options)

        for value in ("0", "2", "-1%", "x", "nan", "0.001%", "%"):
            self.assert_refused(refused("--interpolation-error=" + value), BAD_INPUT, "--interpolation-error", value)
        self.assert_refused(refused("--dry-run"), BAD_INPUT, "--interpolation-error")
        self.assert_refused(refused("--interpolation-error", "2%", "--max-nodes", "0"), BAD_INPUT, "--max-nodes 0")
        self.assert_refused(refused("--interpolation-error", "2%", "--phi-i", "0,90"), BAD_INPUT, "phi_i has 2 nodes")
        result = refused("--interpolation-error", "2%", "--max-nodes", "1e4")
        self.assert_refused(result, BAD_INPUT, "2 %", "nodes", "1e+04", "--max-nodes")
        reached = float(re.search(r"with which ([\d.]+) % is reached", result.stderr).group(1))
        self.assertTrue(2 < reached < 50, result.stderr)
        self.assertEqual(list(self.folder.iterdir()), [])


if __name__ == "__main__":
    unittest.main()
