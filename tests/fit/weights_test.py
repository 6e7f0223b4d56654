"""What counts as one angle of incidence, and as one reading: lists, weights, standard errors, legends."""

import csv
import io
import math
import random
import re
import unittest

from picture import Picture
from program import BAD_INPUT, DONE, MATERIALS, ROOT, VINYL, InFolder, run

DATA = ROOT / "tests" / "data" / "weights"
HEADER = "theta_i_deg,theta_s_deg,phi_deg,brdf_per_sr\n"
LINE = re.compile(r"^  theta_i = (\S+?)(?: to (\S+))? .*\((\d+) samples\)", re.MULTILINE)


def values(result):
    """Of each parameter in the table on standard output: value and standard error, as printed."""
    rows = re.findall(r"^([a-z_]+) +(\S+) +(\S+)   .* to ", result.stdout, re.MULTILINE)
    return {name: (value, error) for name, value, error in rows}


def scan(material, angles, theta_s, noise, seed):
    """f of a material over theta_s at every angle of a list, with noise of ln f, as rows of numbers."""
    pairs = "theta_i_deg,theta_s_deg,phi_deg\n" + "".join(f"{i!r},{s},0\n" for i in angles for s in theta_s)
    result = run("evaluate", material, stdin=pairs)
    assert result.returncode == DONE, result.stderr
    random.seed(seed)
    return [[float(row["theta_i_deg"]), float(row["theta_s_deg"]), float(row["brdf"]) * math.exp(random.gauss(0, noise))]
            for row in csv.DictReader(io.StringIO(result.stdout))]


def text(rows):
    return HEADER + "".join(f"{i!r},{s!r},0,{f!r}\n" for i, s, f in rows)


class Weights(InFolder):
    def fit(self, data, *options, stdin=""):
        result = run("fit", data, "-o", self.folder / "fit.toml", "--force", *options, stdin=stdin)
        self.assertEqual(result.returncode, DONE, result.stderr)
        return result

    def test_an_angle_read_back_is_one_incidence(self):
        options = ["--starts", "24", "--intervals", "linear"]
        rounded = self.fit(DATA / "one_rounded.csv", *options)
        truth = float(values(rounded)["n_eff"][0])
        self.assertAlmostEqual(truth, 0.8085, delta=0.02)
        settings = [("0", "41"), ("10", "41"), ("20", "41"), ("30", "41"), ("40", "41"), ("50", "41"), ("60", "41"), ("70", "41")]
        for name in ("one_jittered", "float_noise"):
            with self.subTest(name):
                result = self.fit(DATA / f"{name}.csv", *options)
                self.assertEqual([(angle, count) for angle, to, count in LINE.findall(result.stdout)],
                                 [(angle, count) for angle, to, count in LINE.findall(rounded.stdout)])
                self.assertAlmostEqual(float(values(result)["n_eff"][0]) / truth, 1, delta=0.02)
        listed = LINE.findall(rounded.stdout)
        self.assertEqual([angle for angle, to, count in listed], [angle for angle, count in settings])
        # If its settings are told apart, each sample of the jittered scan weighs as much as another whole scan.
        apart = self.fit(DATA / "one_jittered.csv", "--incidence-width", "0", *options)
        self.assertGreater(abs(float(values(apart)["n_eff"][0]) / truth - 1), 0.05)

    def test_the_setting_at_the_limit_is_used_whole(self):
        rows = scan(VINYL, [20.0, 50.0, 80.0], range(-75, 76, 5), 0.01, 4)
        for row in rows:
            row[0] += random.uniform(-0.02, 0.02)
        result = self.fit("-", "--floor", "0", "--starts", "4", "--intervals", "linear", stdin=text(rows))
        self.assertIn("left out: 0 samples beyond 80 degrees", result.stdout)
        self.assertEqual([count for angle, to, count in LINE.findall(result.stdout)], ["31"] * 3)

    def test_equal_readings_are_readings(self):
        options = ["--starts", "16", "--intervals", "linear"]
        one = self.fit(DATA / "u6_repeats.csv", *options)
        self.assertRegex(one.stderr, r"1312 samples have the directions of an earlier one, \d+ of them its value too")
        other = self.fit(DATA / "u6_no_identical.csv", *options)
        self.assertEqual(one.stdout.split("\n")[0].split(",")[0], "1640 samples")
        self.assertEqual(other.stdout.split("\n")[0].split(",")[0], "1640 samples")
        first, second = values(one), values(other)
        self.assertEqual(set(first), set(second))
        for name, (value, error) in first.items():
            self.assertEqual(second[name][1], error, name)

    def test_readings_twice_halve_the_variance(self):
        """The same readings, each twice, in one file: every standard error falls by the square root of two."""
        rows = scan(MATERIALS / "garnet-red-paint.toml", range(0, 71, 10), range(-75, 76, 5), 0.05, 6)
        held = [word for name in ("w", "n", "delta", "gamma", "w_a", "w_b", "k_eff") for word in ("--fix", f"{name}=1")]
        options = ["--floor", "0", "--starts", "8", "--intervals", "linear", *held]
        once = self.fit("-", *options, stdin=text(rows))
        twice = self.fit("-", *options, stdin=text(rows + rows))
        self.assertIn(f"{len(rows)} samples have the directions of an earlier one, {len(rows)} of them", twice.stderr)
        for name, (value, error) in values(once).items():
            if error == "-":
                continue
            freedom = math.sqrt((len(rows) - 7) / (2 * len(rows) - 7))
            self.assertAlmostEqual(float(values(twice)[name][1]) / float(error), freedom, delta=0.06, msg=name)

    def test_what_a_format_repeats_counts_once(self):
        data = self.folder / "vinyl.bsdf"
        made = run("generate", VINYL, "-o", data, "--format", "zemax", "--zemax-incidence", "0:60:20", "--zemax-azimuth",
                   "0:180:20", "--zemax-radial", "0,5,10,20,40")
        self.assertEqual(made.returncode, DONE, made.stderr)
        result = self.fit(data, "--floor", "0", "--max-theta", "89", "--starts", "2", "--intervals", "linear")
        # There are ten azimuths at four incidences, and nine of ten values at radial 0 say nothing new.
        self.assertIn("36 values repeat that of another azimuth", result.stderr)
        counts = {angle: int(count) for angle, to, count in LINE.findall(result.stdout)}
        self.assertEqual(counts["0"], 1 + 4 * 10)

    def test_a_fine_scan_is_listed_and_drawn_in_few_steps(self):
        fine = [round(0.1 * k, 1) for k in range(320)]
        rows = scan(VINYL, fine, [-60, -30, 0, 30, 60], 0.02, 5)
        data = self.folder / "fine.csv"
        data.write_text(text(rows))
        result = self.fit(data, "--floor", "0", "--starts", "1", "--intervals", "linear", "--report", self.folder / "report")
        listed = LINE.findall(result.stdout)
        self.assertLessEqual(len(listed), 20)
        self.assertEqual(sum(int(count) for angle, to, count in listed), 1600)
        self.assertTrue(all(to for angle, to, count in listed), listed)
        self.assertIn("107 angles of incidence, neighbouring ones in one line", result.stdout)
        for name, notes in (("fit.svg", ["at 17 of 107 θi"]), ("residuals.svg", [])):
            picture = Picture(self.folder / "report" / name)
            labels = {series["label"] for series in picture.data["panels"][0]["series"]}
            self.assertLessEqual(len(labels), 17, name)
            for note in notes:
                self.assertIn(note, picture.texts())
        residuals = Picture(self.folder / "report" / "residuals.svg").data["panels"][0]["series"]
        self.assertEqual(sum(len(series["x"]) for series in residuals), 1600)

    def test_plot_draws_a_setting_as_one(self):
        for name, angles in (("one_jittered", 8), ("float_noise", 8)):
            picture = self.folder / f"{name}.svg"
            result = run("plot", VINYL, "--data", DATA / f"{name}.csv", "-o", picture)
            self.assertEqual(result.returncode, DONE, result.stderr)
            series = Picture(picture).data["panels"][0]["series"]
            dots = {s["label"]: len(s["x"]) for s in series if s["marks"] == "dots"}
            self.assertEqual(dots, {f"{angle}°": 41 for angle in range(0, 71, 10)}, name)
        result = run("plot", VINYL, "--data", DATA / "one_jittered.csv", "--theta-i", "60", "-o", self.folder / "at60.svg")
        self.assertEqual(result.returncode, DONE, result.stderr)
        series = Picture(self.folder / "at60.svg").data["panels"][0]["series"]
        self.assertEqual([len(s["x"]) for s in series if s["marks"] == "dots"], [41])
        self.assert_refused(run("plot", VINYL, "--incidence-width", "1", "-o", self.folder / "x.svg"), BAD_INPUT,
                            "--incidence-width")


if __name__ == "__main__":
    unittest.main()
