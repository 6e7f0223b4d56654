"""Measurements in other units than their layout's: told by every command that reads one, and mended by the option named."""

import csv
import math
import pathlib
import re
import unittest

from picture import Picture
from program import BAD_INPUT, DONE, MATERIALS, VINYL, InFolder, run

DATA = pathlib.Path(__file__).resolve().parent.parent / "data"
HEADER = "theta_i_deg,theta_s_deg,phi_deg"


def pairs(name):
    """Directions of a measurement that someone could make."""
    if name == "in plane":
        rows = [(i, s, 0) for i in range(0, 81, 10) for s in range(-85, 86, 5)]
    elif name == "hemisphere":
        rows = [(i, s, p) for i in (0, 15, 30, 45, 60, 75) for s in range(0, 90, 10) for p in range(0, 360, 30)]
    elif name == "off the plane":
        rows = [(i, s, p) for i in range(5, 81, 15) for s in (0, *range(5, 86, 10)) for p in (range(15, 360, 30) if s else [0])]
    elif name == "near the mirror direction":
        rows = [(i, i + d, 0) for i in (10, 30, 50, 70) for d in range(-10, 11)]
    else:
        rows = [(i, s, 90) for i in range(0, 81, 10) for s in range(0, 86, 5)]
    return f"{HEADER}\n" + "".join("{},{},{}\n".format(*row) for row in rows)


class Units(InFolder):
    def plot(self, data, *options, material="brown-vinyl"):
        """What is said of a measurement, and its points as the picture has them."""
        picture = self.folder / "plot.svg"
        result = run("plot", MATERIALS / f"{material}.toml", "-o", picture, "--force", "--data", data, *options)
        self.assertEqual(result.returncode, DONE, result.stderr)
        series = Picture(picture).data["panels"][0]["series"]
        said = "".join(line for line in result.stderr.splitlines(True) if "warning: " in line)
        return said, [(s["x"], s["y"]) for s in series if s["marks"] == "dots"]

    def assert_same_points(self, first, second, digits):
        self.assertEqual(len(first), len(second))
        for (x, y), (other_x, other_y) in zip(first, second):
            for a, b in zip(x, other_x, strict=True):
                self.assertAlmostEqual(a, b, delta=1e-5)
            for a, b in zip(y, other_y, strict=True):
                self.assertAlmostEqual(a / b, 1, delta=digits)

    def test_radians_in_columns_of_degrees(self):
        wrong = DATA / "units" / "a22_radians_in_deg.csv"
        right = self.folder / "degrees.csv"
        rows = list(csv.DictReader(wrong.open()))
        right.write_text(f"{HEADER},brdf_per_sr\n" + "".join(
            "{:.6f},{:.6f},{:.6f},{}\n".format(*(math.degrees(float(row[name])) for name in HEADER.split(",")), row["brdf_per_sr"])
            for row in rows))
        angles = ["--theta-i", "10,40,60"]
        said, points = self.plot(right, *angles)
        self.assertNotIn(" --", said)
        self.assertGreater(len(points), 2)
        said, mended = self.plot(wrong, "--angles", "radians", *angles)
        self.assertNotIn(" --", said)
        self.assert_same_points(mended, points, 1e-12)
        result = run("fit", wrong, "-o", self.folder / "x.toml", "--starts", "1", "--intervals", "linear")
        self.assertIn("--angles radians takes them so", result.stderr)

    def test_percent_with_one_view_of_each_incidence(self):
        said, _ = self.plot(DATA / "units" / "one_view_percent.csv", "--theta-i", "40")
        self.assertIn("--values percent", said)
        self.assertIn("--scale 0.01", said)
        self.assertIn("80 of 80 incidences have one direction of view only", said)
        said, points = self.plot(DATA / "units" / "one_view_percent.csv", "--theta-i", "40", "--values", "percent")
        self.assertNotIn("--values", said)
        self.assertAlmostEqual(points[0][1][0], 103.8302 / 100 / math.pi, delta=1e-6)

    def test_micrometres_are_no_nanometres(self):
        output = self.folder / "x.toml"
        micrometres, nanometres = (DATA / "spectra" / name for name in ("s01_um.csv", "s02_nm.csv"))
        self.assert_refused(run("fit", micrometres, "-q", "-o", output, "--wavelengths", "all"), BAD_INPUT,
                            "would be 0.45 nm", "--wavelength-unit")
        self.assertFalse(output.exists())
        said, _ = self.plot(micrometres, "--channel", "0.45")
        self.assertIn("as um they are 450 to 550 nm; --wavelength-unit um", said)
        by_name = self.folder / "named.csv"
        by_name.write_text(micrometres.read_text().replace("wavelength_nm", "wavelength_um"))
        said, right = self.plot(nanometres, "--channel", "550")
        self.assertNotIn(" --", said)
        for data, options in ((micrometres, ["--wavelength-unit", "um"]), (by_name, [])):
            said, points = self.plot(data, "--channel", "550", *options)
            self.assertNotIn(" --", said)
            self.assert_same_points(points, right, 1e-15)
        result = run("fit", by_name, "-o", output, "--wavelengths", "all", "--starts", "1", "--intervals", "linear")
        self.assertEqual(result.returncode, DONE, result.stderr)
        for nm in ("450", "550"):
            self.assertIn(f"wavelength_nm = {nm}.0\n", output.read_text())

    def test_the_text_of_a_wavelength_does_not_matter(self):
        _, right = self.plot(DATA / "spectra" / "s02_nm.csv", "--channel", "450")
        said, points = self.plot(DATA / "spectra" / "s03_mixed_text.csv", "--channel", "450.00")
        self.assertNotIn(" --", said)
        self.assert_same_points(points, right, 1e-15)

    def test_a_truncated_file_is_told(self):
        said, _ = self.plot(DATA / "text" / "b05_truncated.astm")
        self.assertIn("has 200 rows where NUM_POINTS says 328", said)

    def test_the_shipped_materials_are_not_doubted(self):
        for material in sorted(path.stem for path in MATERIALS.glob("*.toml")):
            for name in ("in plane", "hemisphere", "off the plane", "near the mirror direction", "across the plane"):
                with self.subTest(f"{material}, {name}"):
                    result = run("evaluate", MATERIALS / f"{material}.toml", "-q", stdin=pairs(name))
                    self.assertEqual(result.returncode, DONE, result.stderr)
                    head, body = result.stdout.split("\n", 1)
                    channel = ["--channel", body.split(",")[0]] if head.startswith("wavelength_nm") else []
                    for column in ("brdf", "brdf_s", "brdf_p"):
                        names = ["brdf_per_sr" if name == column else name for name in head.split(",")]
                        data = self.folder / "data.csv"
                        data.write_text(",".join(names) + "\n" + body)
                        said, _ = self.plot(data, *channel, material=material)
                        self.assertNotIn(" --", said, column)

    def test_exported_files_are_not_doubted(self):
        for material in sorted(path.stem for path in MATERIALS.glob("*.toml")):
            for name, options in (("x.astm", ["--format", "astm"]), ("x.bsdf", ["--format", "zemax"])):
                with self.subTest(f"{material}, {name}"):
                    table = self.folder / name
                    grid = ["--theta-i", "0:80:20", "--theta-s", "0:85:5", "--phi-s", "0:360:30"] if name == "x.astm" else []
                    result = run("generate", MATERIALS / f"{material}.toml", "-q", "-o", table, "--force", *options, *grid)
                    self.assertEqual(result.returncode, DONE, result.stderr)
                    first = run("plot", VINYL, "-o", self.folder / "x.svg", "--force", "--data", table)
                    channel = re.search(r"has the channels ([^,:]+)", first.stderr)
                    said, _ = self.plot(table, *(["--channel", channel.group(1)] if channel else []))
                    self.assertNotIn(" --", said)


if __name__ == "__main__":
    unittest.main()
