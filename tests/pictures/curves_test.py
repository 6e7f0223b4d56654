"""Curves of `plot`: what is drawn is what `evaluate` and the table say."""

import csv
import io
import math
import tomllib
import unittest

import h5py
import numpy
from scipy.special import gammaincc

from drawing import Drawing
from picture import place
from program import MATERIALS, VINYL, run

YELLOW = MATERIALS / "yellow-retro-sheeting.toml"
GARNET = MATERIALS / "garnet-red-paint.toml"

LARGEST_PRINTED_ERROR = 1e-7  # angles and f are printed to nine digits; narrow lobes are steep
LARGEST_DRAWN_ERROR = 0.0101  # user units: coordinates are printed to hundredths


class Curves(Drawing):
    def assert_drawn_as_said(self, picture):
        """The pixels of curves are at the values of the metadata."""
        curves, paths = picture.curves(), picture.paths()
        self.assertEqual(len(curves), len(paths))
        for (panel, series), path in zip(curves, paths):
            self.assertEqual(len(series["x"]), len(path))
            for x, y, (at_x, at_y) in zip(series["x"], series["y"], path):
                self.assertAlmostEqual(place(panel["x"], x), at_x, delta=LARGEST_DRAWN_ERROR)
                if panel["y"]["low"] <= y <= panel["y"]["high"]:
                    self.assertAlmostEqual(place(panel["y"], y), at_y, delta=LARGEST_DRAWN_ERROR)

    def test_values_equal_evaluate(self):
        for material in sorted(MATERIALS.glob("*.toml")):
            for polarization, column in (("unpolarized", "brdf"), ("p", "brdf_p")):
                with self.subTest(material=material.name, polarization=polarization):
                    picture = self.picture(material, "--polarization", polarization)
                    self.assert_drawn_as_said(picture)
                    series = [s for _, s in picture.curves()]
                    self.assertEqual([s["label"] for s in series], [f"{k}°" for k in range(0, 90, 10)])
                    for curve in series:
                        incidence = float(curve["label"].removesuffix("°"))
                        expected = self.evaluated(material, [(incidence, x, 0) for x in curve["x"]], column)
                        numpy.testing.assert_allclose(curve["y"], expected, rtol=LARGEST_PRINTED_ERROR)
                        self.assertEqual((curve["x"][0], curve["x"][-1]), (-89.9, 89.9))

    def test_narrow_peaks_are_smooth(self):
        narrow = self.folder / "narrow.toml"
        narrow.write_text(YELLOW.read_text().replace("rho_retro = 0.033", "rho_retro = 0.001").replace("rho_surface = 0.010", "rho_surface = 0.002"))
        for material in (YELLOW, GARNET, narrow):
            picture = self.picture(material, "--theta-i", "20,70")
            for panel, curve in picture.curves():
                with self.subTest(material=material.name, curve=curve["label"]):
                    self.assertIn(float(curve["label"].removesuffix("°")), curve["x"])
                    # What is drawn half way between samples is within half a unit of the curve.
                    incidence = float(curve["label"].removesuffix("°"))
                    x = numpy.array(curve["x"])
                    f = self.evaluated(material, [(incidence, s, 0) for s in (x[1:] + x[:-1]) / 2])
                    for k, value in enumerate(f):
                        if abs(x[k]) > 80:
                            continue
                        ends = [(place(panel["x"], x[j]), place(panel["y"], curve["y"][j])) for j in (k, k + 1)]
                        at = (place(panel["x"], (x[k] + x[k + 1]) / 2), place(panel["y"], value))
                        (x1, y1), (x2, y2) = ends
                        off = abs((x2 - x1) * (at[1] - y1) - (y2 - y1) * (at[0] - x1)) / math.hypot(x2 - x1, y2 - y1)
                        self.assertLess(off, 0.5)

    def test_lobes_add_up(self):
        picture = self.picture(YELLOW, "--kind", "lobes", "--theta-i", "50")
        self.assert_drawn_as_said(picture)
        panels = {panel["title"]: panel["series"][0] for panel in picture.data["panels"]}
        logs = {}
        for title, series in panels.items():
            logs[title] = dict(zip(series["x"], series["y"]))
        shared = set.intersection(*(set(values) for values in logs.values()))
        self.assertGreater(len(shared), 150)
        for x in shared:
            parts = sum(values[x] for title, values in logs.items() if title != "all lobes")
            self.assertAlmostEqual(parts / logs["all lobes"][x], 1, delta=1e-7)

    def test_dots_are_the_nodes_of_a_table(self):
        table = self.table(YELLOW, "--polarization", "s")
        picture = self.picture(table, "--theta-i", "30")
        dots = [s for s in picture.data["panels"][0]["series"] if s["marks"] == "dots"][0]
        with h5py.File(table) as file:
            f = file["brdf_s"][6, 0]
            expected = numpy.concatenate([f[:0:-1, 90], f[:, 0]])
            theta = file["theta_s"][:]
        numpy.testing.assert_array_equal(dots["x"], numpy.concatenate([-theta[:0:-1], theta]))
        numpy.testing.assert_allclose(dots["y"], expected, rtol=1e-8)

    def test_measured_points(self):
        data = self.folder / "data.csv"
        data.write_text("theta_i_deg,theta_s_deg,phi_deg,brdf_per_sr\n25,-30,0,0.05\n25,40,1,0.06\n25,40,90,9\n55,10,180,0.07\n")
        picture = self.picture(VINYL, "--data", data)
        series = picture.data["panels"][0]["series"]
        dots = {s["label"]: sorted(zip(s["x"], s["y"])) for s in series if s["marks"] == "dots"}
        self.assertEqual(dots, {"25°": [(-30, 0.05), (40, 0.06)], "55°": [(-10, 0.07)]})
        self.assertEqual([s["label"] for s in series if s["marks"] == "line"], ["25°", "55°"])
        picture = self.picture(VINYL, "--data", data, "--scale", "2", "--theta-i", "25")
        dots = [s for s in picture.data["panels"][0]["series"] if s["marks"] == "dots"]
        self.assertEqual([sorted(s["y"]) for s in dots], [[0.1, 0.12]])
        self.assertIn("at 1 of 2 θi", picture.texts())

    def test_shadowing(self):
        picture = self.picture(VINYL, "--kind", "shadowing")
        self.assert_drawn_as_said(picture)
        reflectance, width = picture.data["panels"]
        parameters = tomllib.loads(VINYL.read_text())["parameters"]
        w_a, w_b, w, n = (parameters[key] for key in ("w_a", "w_b", "w", "n"))
        self.assertEqual(len(reflectance["series"]), 2)
        for curve in reflectance["series"]:
            for x, y in zip(curve["x"], curve["y"]):
                if -89 < x < 0:  # S of Eq. (13)
                    a = math.sin(math.radians(x))
                    self.assertAlmostEqual(y, math.exp(-w_a * abs(a) / math.sqrt(1 - a * a) * math.exp(-w_b / (a * a))), delta=1e-7)
        for x, y in zip(width["series"][0]["x"], width["series"][0]["y"]):
            self.assertAlmostEqual(y, gammaincc(1 + n, (1 + n) * x * x / w**2), delta=1e-7)

    def test_dhr(self):
        picture = self.picture(YELLOW, "--kind", "dhr")
        self.assert_drawn_as_said(picture)
        for panel, polarization in zip(picture.data["panels"], ("unpolarized", "s", "p")):
            series = {s["label"]: dict(zip(s["x"], s["y"])) for s in panel["series"]}
            result = run("integrate", YELLOW, "--theta-i", "0,40,80", "--polarization", polarization)
            rows = list(csv.DictReader(line for line in io.StringIO(result.stdout) if not line.startswith("#")))
            for row in rows:
                for label, column in (("all", "dhr"), ("surface", "dhr_surface"), ("bulk", "dhr_bulk"), ("retro", "dhr_retro")):
                    self.assertAlmostEqual(series[label][float(row["theta_i_deg"])] / float(row[column]), 1, delta=1e-7)


if __name__ == "__main__":
    unittest.main()
