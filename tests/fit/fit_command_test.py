"""fit from outside: a synthetic measurement to a material file, and what bad data get."""

import collections
import csv
import io
import math
import random
import re
import statistics
import tomllib
import unittest

from picture import Picture
from program import BAD_INPUT, CHECK_FAILED, DONE, FILE, MATERIALS, ROOT, InFolder, run

DATA = ROOT / "tests" / "data"
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
        # The picture has a dot for each sample and a curve for each incidence.
        for name, curves in (("fit.svg", 5), ("residuals.svg", 0)):
            series = Picture(pictures[name]).data["panels"][0]["series"]
            self.assertEqual(sum(len(s["x"]) for s in series if s["marks"] == "dots"), 105)
            self.assertEqual(sum(s["marks"] == "line" for s in series), curves)
        self.assertIn("σsurface", Picture(pictures["correlations.svg"], data=False).texts())
        self.assert_told(tomllib.loads(material.read_text()), result.stdout)
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

    def assert_told(self, written, printed):
        """What the program prints of a fit, the material file has as data."""
        self.assertEqual((written["name"], written["source"]), ("a paint", "made up; data.csv"))
        fit = written["fit"]
        self.assertTrue(fit["command"].startswith("brdftab fit "))
        self.assertEqual([fit[key] for key in ("data", "light", "residuals", "weights", "loss", "intervals", "level", "starts")],
                         ["data.csv", "unpolarized", "ln(model/data)", "aoi", "linear", "profile", 0.95, 24])
        self.assertEqual([fit["samples"], fit["theta_i"], fit["max_theta"], fit["floor"]], [105, [0, 80], 80, 0])
        self.assertIn(f"all samples alike: {fit['rms']:g}, each incidence alike: {fit['rms_by_incidence']:g}\n", printed)
        self.assertIn(f"{fit['starts']} starts, {fit['converged']} converged, {fit['reached']} of them", printed)
        self.assertIn(f"columns of unit length: {fit['condition']:.2g}\n", printed)
        rows = {line.split()[0]: line for line in printed.splitlines() if re.match(r"\w+ +[\d.e-]+ +(-|[\d.e-]+)   ", line)}
        self.assertEqual(sorted(rows), sorted(written["parameters"]))
        for name, line in rows.items():
            self.assertEqual(f"{written['parameters'][name]:.5g}", line.split()[1], name)
            told = fit[name]
            if "low" in told:
                self.assertIn(f"   {told['low']:.4g} to {told['high']:.4g} ", line)
            else:
                self.assertIn("at bound", line)
            self.assertEqual(told.get("at_bound", False), "at bound" in line)
            flag = {None: "", "below": "no lower limit", "above": "no upper limit", "both": "unidentifiable"}[told.get("open")]
            self.assertTrue(line.endswith(flag), line)
        self.assertEqual(fit["rho_surface"]["bounds"], [1e-4, 100])
        for at in fit["incidences"]:
            line = re.search(rf"theta_i = {at['theta_i']:g} +(\S+) +\({at['samples']} samples\) +DHR (\S+)", printed)
            for key, value in zip(("rms", "dhr"), line.groups()):
                self.assertAlmostEqual(at[key] / float(value), 1, delta=6e-3, msg=str(at))

    def test_polarised_light_is_fitted_as_such(self):
        data = self.synthetic()
        swapped = self.folder / "swapped.csv"
        swapped.write_text(data.read_text().replace("brdf_s,brdf_p,", "brdf_p,brdf_s,", 1))
        for file, polarization, fits in ((data, "s", True), (data, "all", True), (swapped, "s", False)):
            result = run("fit", file, "-o", self.folder / "x.toml", "--force", "--floor", "0", "--starts", "16", "--intervals",
                         "linear", "--polarization", polarization)
            self.assertEqual(result.returncode, DONE, result.stderr)
            rms = float(re.search(r"each incidence alike: (\S+)", result.stdout).group(1))
            self.assertEqual(rms < 1e-3, fits, result.stdout)
            self.assertEqual(tomllib.loads((self.folder / "x.toml").read_text())["fit"]["light"], polarization)

    def test_what_low_readings_left_out_do_is_told_and_mended(self):
        black = DATA / "noise" / "floor1e-3.csv"
        output = self.folder / "x.toml"
        common = ["fit", black, "-o", output, "--force", "--starts", "8", "--intervals", "linear"]
        result = run(*common)
        self.assertEqual(result.returncode, DONE, result.stderr)
        told = re.search(r"warning: \S+: (\d+) of 648 samples \(\d+ %\) are left out .*DHR upward.* is (\S+) times all readings.*"
                         r"--weights sigma.*--noise", result.stderr)
        self.assertIsNotNone(told, result.stderr)
        self.assertGreater(int(told.group(1)), 200)
        self.assertGreater(float(told.group(2)), 1.5)
        written = tomllib.loads(output.read_text())["fit"]
        self.assertEqual(written["below_floor"], int(told.group(1)))
        self.assertIn(f"{told.group(1)} of 648 samples", written["warnings"][-1])
        for options, words, noise in ((["--weights", "sigma"], "sigma given with the data", (None, None, None)),
                                      (["--noise", "2%,1e-3"], "a = 0.02 given, b = 0.001 1/sr given", (0.02, 0.001, None)),
                                      (["--noise", "2%,estimated"], "a = 0.02 given, b = 0.00", (0.02, ..., ["floor"]))):
            result = run(*common, *options, "--report", self.folder / "report")
            self.assertEqual(result.returncode, DONE, result.stderr)
            self.assertNotIn("left out", result.stderr)
            self.assertNotIn("bad fit", result.stdout)
            self.assertIn(words, result.stdout)
            chi_square = re.search(r"reduced chi-square ((0\.9|1)\S*) of 648 samples", result.stdout).group(1)
            above = re.search(r"rms of ln\(model/data\) over the (\d+) of 648 samples above 0.002 1/sr", result.stdout).group(1)
            written = tomllib.loads(output.read_text())["fit"]
            self.assertEqual(written["weights"], "sigma" if "--weights" in options else "noise")
            for key, value in zip(("noise_relative", "noise_floor", "noise_estimated"), noise):
                self.assertEqual(written.get(key), written[key] if value is ... else value, key)
            self.assertEqual([f"{written['reduced_chi_square']:g}", written["rms_samples"]], [chi_square, int(above)])
            dhr = float(re.search(r"theta_i = 0 .*DHR (\S+)", result.stdout).group(1))
            self.assertAlmostEqual(dhr, 0.00525, delta=0.05 * 0.00525)
            fit = Picture(self.folder / "report" / "fit.svg").data["panels"][0]
            self.assertGreater(min(y for s in fit["series"] for y in s["y"]), 0)
            residuals = Picture(self.folder / "report" / "residuals.svg").data["panels"][0]
            self.assertEqual(sum(len(s["y"]) for s in residuals["series"]), 648)

    def test_statistics_that_contradict_each_other_are_refused(self):
        black = DATA / "noise" / "floor1e-3.csv"
        for options, part in ((["--weights", "sigma", "--floor", "0.001"], "--floor 0.001: --weights sigma and --noise take every"),
                              (["--noise", "2%,1e-3", "--floor", "0"], "--floor 0: "),
                              (["--noise", "2%,1e-3", "--weights", "uniform"], "--weights uniform: --noise gives"),
                              (["--noise", "2%"], "--noise 2%: must be RELATIVE,FLOOR"),
                              (["--noise", "2%,0"], "--noise 2%,0: must be"),
                              (["--noise", "estimated", "--loss", "cauchy"], "--loss cauchy takes a noise that is given")):
            with self.subTest(part):
                self.assert_refused(run("fit", black, "-o", self.folder / "x.toml", *options), BAD_INPUT, part)
                self.assertFalse((self.folder / "x.toml").exists())

    def test_a_bad_fit_says_so_in_its_first_line(self):
        # This is no surface: what scatters at one angle says nothing of the next.
        draw = random.Random(4)
        text = HEADER + "".join(f"{i},{s},0,{math.exp(draw.gauss(-2, 1.5))},a\n" for i in (0, 30, 60) for s in range(-75, 76, 5))
        output = self.folder / "x.toml"
        result = run("fit", "-", "-o", output, "--floor", "0", "--starts", "4", "--intervals", "linear", stdin=text)
        self.assertEqual(result.returncode, DONE, result.stderr)
        first = result.stdout.splitlines()[0]
        self.assertRegex(first, r"^bad fit, not to be used as it is: model and data differ by a factor of \S+ \(rms of ln\(model/data\)")
        self.assertEqual(output.read_text().splitlines()[0], "# " + first)
        self.assertTrue(tomllib.loads(output.read_text())["fit"]["warnings"][0].startswith("bad fit, not to be used as it is: "))
        self.assertEqual(run("evaluate", output, stdin=PAIRS).returncode, DONE)

    def test_help_tells_every_default(self):
        text = " ".join(run("fit", "--help").stdout.split())
        for words in ("default 48", "default 1", "default 80", "default 0.002", "(default)",
                      "values to f in 1/sr; default 1", "unpolarized (default)", "linear (default)", "the default, or none"):
            self.assertIn(words, text)

    def test_help_and_formats_name_every_key_of_the_material_file(self):
        text = run("fit", "--help").stdout
        keys = re.findall(r"^    (\w+) {2,}\S", text[text.index("  [fit] "):], re.M)
        self.assertGreater(len(keys), 30)
        documented = re.findall(r"^\| `(\w+)` \| ", (ROOT / "host" / "FORMATS.md").read_text(), re.M)
        self.assertEqual([key for key in keys if key not in documented], [])

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
