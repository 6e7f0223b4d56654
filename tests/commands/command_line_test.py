"""What users type, and what they get: commands, exit statuses, one clear line for each fault, and no file left."""

import csv
import io
import unittest

from program import BAD_INPUT, DONE, FILE, GOLDEN, PROGRAM, VINYL, InFolder, run

SAMPLES = "theta_i_deg,theta_s_deg,phi_deg\n30,30,0\n60,-20,0\n0,0,77\n"


def rows(text):
    return list(csv.DictReader(line for line in io.StringIO(text) if not line.startswith("#")))


class Habits(unittest.TestCase):
    def test_every_command_has_help_and_version(self):
        for command in ([], ["generate"], ["evaluate"], ["integrate"], ["fit"], ["info"], ["devices"], ["parameters"]):
            self.assertIn("Usage", run(*command, "--help").stdout)
            self.assertRegex(run(*command, "--version").stdout, r"^brdftab \d+\.\d+\.\d+\n$")

    def test_usage_errors_are_bad_input(self):
        for arguments in ([], ["nonsense"], ["generate"], ["generate", VINYL], ["generate", VINYL, "-o", "x.h5", "--nonsense"],
                          ["evaluate", VINYL, "--engine", "magic"], ["generate", VINYL, "-o", "x.h5", "--polarization", "q"]):
            result = run(*arguments)
            self.assertEqual(result.returncode, BAD_INPUT, arguments)
            self.assertTrue(result.stderr.startswith("brdftab: "), result.stderr)
            self.assertEqual(result.stderr.count("\n"), 1, result.stderr)

    def test_parameters_lists_all_fourteen(self):
        text = run("parameters").stdout
        for name in ("n_eff", "k_eff", "sigma_surface", "rho_surface", "sigma_bulk", "rho_bulk", "sigma_retro", "rho_retro",
                     "w_a", "w_b", "gamma", "delta", "  w ", "  n "):
            self.assertIn(name, text)

    def test_devices_says_how_to_select_each(self):
        result = run("devices")
        self.assertEqual(result.returncode, DONE)
        self.assertIn("(default)", result.stdout)
        self.assertIn("BRDFTAB_DEVICE", result.stdout)


class Evaluate(InFolder):
    def test_engines_agree_on_directions_in_any_form(self):
        device = rows(run("evaluate", VINYL, stdin=SAMPLES).stdout)
        reference = rows(run("evaluate", VINYL, "--engine", "reference", stdin=SAMPLES).stdout)
        self.assertEqual(list(device[0]), ["theta_i_deg", "theta_s_deg", "phi_deg", "brdf_s", "brdf_p", "brdf"])
        self.assertEqual(len(device), 3)
        for ours, theirs in zip(device, reference):
            for column in ("brdf_s", "brdf_p", "brdf"):
                self.assertAlmostEqual(float(ours[column]) / float(theirs[column]), 1, delta=1e-12)
            self.assertAlmostEqual(float(ours["brdf"]), (float(ours["brdf_s"]) + float(ours["brdf_p"])) / 2, delta=1e-15)

    def test_other_columns_and_orders(self):
        shuffled = "# measured\nphi_s_deg,note,theta_s_deg,theta_i_deg\n0,a,30,30\n180,b,20,60\n77,c,0,0\n"
        plain = rows(run("evaluate", VINYL, stdin=SAMPLES).stdout)
        other = rows(run("evaluate", VINYL, stdin=shuffled).stdout)
        self.assertEqual([r["brdf"] for r in plain], [r["brdf"] for r in other])

    def test_float32_prints_nine_digits(self):
        text = run("evaluate", VINYL, "--precision", "float32", stdin=SAMPLES).stdout
        for row in rows(text):
            self.assertLessEqual(len(row["brdf"].lstrip("0.").replace(".", "")), 9)

    def test_bands_come_first(self):
        material = self.folder / "bands.toml"
        material.write_text(VINYL.read_text() + "[[band]]\nwavelength_nm = 450\n[[band]]\nwavelength_nm = 650\nsigma_bulk = 0.21\n")
        table = rows(run("evaluate", material, stdin=SAMPLES).stdout)
        self.assertEqual([r["wavelength_nm"] for r in table], ["450"] * 3 + ["650"] * 3)
        self.assertGreater(float(table[3]["brdf"]), float(table[0]["brdf"]))

    def test_bad_directions_name_line_and_value(self):
        header = "theta_i_deg,theta_s_deg,phi_deg\n"
        for text, *parts in ((header + "90,0,0\n", ":2:", "theta_i_deg = 90"), (header + "0,0,0\n0,95,0\n", ":3:", "theta_s_deg = 95"),
                             (header + "0,nan,0\n", "theta_s_deg = nan"), (header + "x,0,0\n", "theta_i_deg = x"),
                             (header + "0,0\n", "2 cells"), ("theta_i_deg,phi_deg\n0,0\n", "theta_s_deg is missing"), ("", "is empty"),
                             (header + "-5,0,0\n", "theta_i_deg = -5"), (header + "0,0,361\n", "phi_deg = 361")):
            result = run("evaluate", VINYL, stdin=text)
            self.assert_refused(result, BAD_INPUT, "standard input:", *parts)

    def test_output_file(self):
        output = self.folder / "out.csv"
        self.assertEqual(run("evaluate", VINYL, "-o", output, stdin=SAMPLES).returncode, DONE)
        before = output.read_text()
        self.assertEqual(len(rows(before)), 3)
        self.assert_refused(run("evaluate", VINYL, "-o", output, stdin=SAMPLES), FILE, "exists; --force overwrites it")
        self.assertEqual(output.read_text(), before)
        self.assertEqual(run("evaluate", VINYL, "-o", output, "--force", stdin=SAMPLES).returncode, DONE)


class Integrate(unittest.TestCase):
    def test_integrals_equal_those_of_an_independent_implementation(self):
        arguments = ["integrate", "-", "--theta-i", "0,35,75"]
        material = (GOLDEN / "brown-vinyl.toml").read_text()
        golden = {row["theta_i_deg"]: row for row in rows((GOLDEN / "integrals.csv").read_text()) if row["material"] == "brown-vinyl"}
        device = rows(run(*arguments, stdin=material).stdout)
        self.assertEqual(list(device[0]), ["theta_i_deg", "N_surface", "N_bulk", "N_retro", "dhr", "dhr_surface", "dhr_bulk", "dhr_retro"])
        for row in device:
            expected = golden[row["theta_i_deg"]]
            for lobe in ("surface", "bulk", "retro"):
                self.assertAlmostEqual(float(row[f"N_{lobe}"]) / float(expected[f"N_{lobe}"]), 1, delta=1e-10)
                # The golden reflectances hold to 1e-7 where k_eff is 0.
                self.assertAlmostEqual(float(row[f"dhr_{lobe}"]) / float(expected[f"dhr_{lobe}"]), 1, delta=1e-7)
            parts = sum(float(row[f"dhr_{lobe}"]) for lobe in ("surface", "bulk", "retro"))
            self.assertAlmostEqual(float(row["dhr"]) / parts, 1, delta=1e-14)
        text = run(*arguments, stdin=material).stdout
        self.assertRegex(text, r"\n# bhr = 0\.1909332\d+\n")
        self.assertRegex(text, r"\n# reciprocity of 1768 pairs: median 0\.\d+, 90 % 0\.\d+, maximum \d\.\d+ at theta_i = \d+, theta_s = \d+, phi = \d+ degrees; .*\n$")

    def test_unpolarized_is_the_mean(self):
        value = {}
        for polarization in ("unpolarized", "s", "p"):
            value[polarization] = float(rows(run("integrate", VINYL, "--theta-i", "60", "--polarization", polarization).stdout)[0]["dhr"])
        self.assertAlmostEqual(value["unpolarized"], (value["s"] + value["p"]) / 2, delta=1e-15)
        self.assertGreater(value["s"], value["p"])


if __name__ == "__main__":
    assert PROGRAM
    unittest.main()
