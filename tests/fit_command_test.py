"""fit from outside: a synthetic measurement to a material file, and what bad data get."""

import collections
import csv
import io
import math
import re
import statistics
import unittest

from picture import Picture
from program import BAD_INPUT, CHECK_FAILED, DONE, FILE, MATERIALS, InFolder, run

HEADER = "theta_i_deg,theta_s_deg,phi_s_deg,brdf_per_sr,channel\n"
PAIRS = "theta_i_deg,theta_s_deg,phi_deg\n" + "".join(
    f"{i},{s},0\n" for i in range(0, 81, 20) for s in range(-80, 81, 8))


class Fit(InFolder):
    def synthetic(self, *arguments):
        data = self.folder / "data.csv"
        result = run("evaluate", MATERIALS / "garnet-red-paint.toml", "-o", data, *arguments, stdin=PAIRS)
        self.assertEqual(result.returncode, DONE, result.stderr)
        return data

    def test_a_synthetic_measurement_gives_its_material_back(self):
        data = self.synthetic("--noise", "0.03", "--seed", "3")
        self.assertTrue(data.read_text().startswith("# ln f with noise of standard deviation 0.03, seed 3\n"))
        material = self.folder / "fit.toml"
        result = run("fit", data, "-o", material, "--floor", "0", "--starts", "24", "--name", "a paint", "--source", "made up",
                     "--report", self.folder / "report")
        self.assertEqual(result.returncode, DONE, result.stderr)
        rms = float(re.search(r"each incidence alike: (\S+)", result.stdout).group(1))
        self.assertLess(rms, 0.035)
        for words in ("95 % interval (profile)", "std. error", "condition number", "strongest correlations", "poorly known",
                      "24 starts", "theta_i = 80"):
            self.assertIn(words, result.stdout)
        self.assertRegex(result.stderr, r"% of it in kernels")
        pictures = {path.name: path for path in (self.folder / "report").iterdir()}
        self.assertEqual(sorted(pictures), ["correlations.svg", "fit.svg", "residuals.svg", "shadowing.svg"])
        # A dot for each sample and a curve for each incidence.
        for name, curves in (("fit.svg", 5), ("residuals.svg", 0)):
            series = Picture(pictures[name]).data["panels"][0]["series"]
            self.assertEqual(sum(len(s["x"]) for s in series if s["marks"] == "dots"), 105)
            self.assertEqual(sum(s["marks"] == "line" for s in series), curves)
        self.assertIn("σsurface", Picture(pictures["correlations.svg"], data=False).texts())
        text = material.read_text()
        for words in ('name = "a paint"', "rms of ln(model/data)", "bounds 0.0001 to 100", "made up; data.csv", "brdftab fit ",
                      "theta_i 0 to 80 degrees"):
            self.assertIn(words, text)
        fitted = run("evaluate", material, stdin=PAIRS)
        self.assertEqual(fitted.returncode, DONE, fitted.stderr)
        truth = run("evaluate", MATERIALS / "garnet-red-paint.toml", stdin=PAIRS)
        model = list(csv.DictReader(io.StringIO(fitted.stdout)))
        for ours, theirs in zip(model, csv.DictReader(io.StringIO(truth.stdout))):
            self.assertAlmostEqual(float(ours["brdf"]) / float(theirs["brdf"]), 1, delta=0.12, msg=str(ours))
        measured = csv.DictReader(line for line in data.read_text().splitlines() if not line.startswith("#"))
        squares = collections.defaultdict(list)
        for ours, theirs in zip(model, measured):
            squares[float(ours["theta_i_deg"])].append(math.log(float(ours["brdf"]) / float(theirs["brdf"])) ** 2)
        samples = math.sqrt(statistics.fmean(value for at in squares.values() for value in at))
        incidences = math.sqrt(statistics.fmean(statistics.fmean(at) for at in squares.values()))
        self.assertIn(f"all samples alike: {samples:.4g}, each incidence alike: {incidences:.4g}\n", result.stdout)
        integrals = run("integrate", material, "--theta-i", ",".join(f"{angle:g}" for angle in squares))
        for row in csv.DictReader(line for line in integrals.stdout.splitlines() if not line.startswith("#")):
            self.assertRegex(result.stdout, rf"theta_i = {float(row['theta_i_deg']):g} .*DHR {float(row['dhr']):.4g}\n")

    def test_polarised_light_is_fitted_as_such(self):
        data = self.synthetic()
        text = data.read_text().replace("brdf_s", "brdf_per_sr", 1)
        data.write_text(text)
        for polarization, limit in (("s", 1), ("p", None)):
            result = run("fit", data, "-o", self.folder / "x.toml", "--force", "--floor", "0", "--starts", "16", "--intervals",
                         "linear", "--polarization", polarization)
            rms = float(re.search(r"each incidence alike: (\S+)", result.stdout).group(1))
            if limit:
                self.assertLess(rms, 1e-3)
            else:
                self.assertGreater(rms, 1e-3)

    def test_a_variant_is_fitted_as_such(self):
        variant = self.folder / "variant.toml"
        variant.write_text((MATERIALS / "garnet-red-paint.toml").read_text() + '\n[model]\nnormalization = "reciprocal"\n')
        data = self.folder / "data.csv"
        self.assertEqual(run("evaluate", variant, "-o", data, stdin=PAIRS).returncode, DONE)
        output = self.folder / "x.toml"
        for options, fits in ((["--model", "normalization=reciprocal"], True), ([], False)):
            result = run("fit", data, "-o", output, "--force", "--floor", "0", "--starts", "16", "--intervals", "linear", *options)
            self.assertEqual(result.returncode, DONE, result.stderr)
            rms = float(re.search(r"each incidence alike: (\S+)", result.stdout).group(1))
            self.assertEqual(rms < 1e-3, fits, result.stdout)
            self.assertEqual('normalization = "reciprocal"' in output.read_text(), fits)

    def test_bad_data_and_options_are_one_line(self):
        good = HEADER + "".join(f"{i},{s},0,0.1,a\n" for i in (10, 50) for s in range(-60, 61, 5))
        output = self.folder / "out.toml"
        cases = [("", [], "is empty"),
                 (HEADER, [], "has no samples"),
                 (good + "10,70,0,O.1,a\n", [], "brdf_per_sr = O.1"),
                 (good + "90,70,0,0.1,a\n", [], "theta_i_deg = 90"),
                 (good + "10,70,0,0.1,b\n", [], "--channel takes one of a, b"),
                 (good, ["--channel", "z"], "--channel z"),
                 (good, ["--wavelengths", "all"], "is no wavelength"),
                 (good, ["--fix", "k_ef=0"], "--fix k_ef=0"),
                 (good, ["--bounds", "w=3:1"], "LOW must be below HIGH"),
                 (good, ["--weights", "sigma"], "takes a column sigma"),
                 (good, ["--model", "normalization=closed-form"], "no derivatives"),
                 (good, ["--model", "shading=none"], "--model shading=none"),
                 (good, ["--floor", "1"], "no sample"),
                 ("\n".join(good.split("\n")[:10]) + "\n", [], "samples are left for 14 free parameters")]
        for text, options, part in cases:
            with self.subTest(part):
                self.assert_refused(run("fit", "-", "-o", output, *options, stdin=text), BAD_INPUT, part)
                self.assertFalse(output.exists())
        self.assert_refused(run("fit", self.folder / "none.csv", "-o", output), FILE, "cannot be opened")
        output.write_text("mine")
        self.assert_refused(run("fit", "-", "-o", output, stdin=good), FILE, "--force")
        self.assertEqual(output.read_text(), "mine")

    def test_no_start_converges_where_there_is_no_light(self):
        data = self.synthetic()
        dark = [word for lobe in ("surface", "bulk", "retro") for word in ("--fix", f"sigma_{lobe}=0")]
        result = run("fit", data, "-o", self.folder / "x.toml", "--starts", "3", *dark)
        self.assert_refused(result, CHECK_FAILED, "none of 3 starts converged")
        self.assertFalse((self.folder / "x.toml").exists())

    def test_what_is_set_aside_is_counted(self):
        text = HEADER + "".join(f"{i},{s},0,{0.1 + 0.001 * s},a\n" for i in (10,) for s in range(-60, 61, 4))
        text += "10,70,0,nan,a\n10,71,0,0,a\n10,72,0,-1,a\n" + text[len(HEADER):].split("\n")[0] + "\n"
        result = run("fit", "-", "-o", self.folder / "x.toml", "--starts", "4", "--intervals", "linear", stdin=text)
        self.assertEqual(result.returncode, DONE, result.stderr)
        for part in ("1 of 35 samples are nan", "are zero", "are negative", "1 of them its value too", "one incidence only"):
            self.assertIn(part, result.stderr)


if __name__ == "__main__":
    unittest.main()
