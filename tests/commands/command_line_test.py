"""What users type, and what they get: commands, exit statuses, one clear line for each fault, and no file left."""

import csv
import io
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import h5py
import numpy

from program import (BAD_INPUT, DEVICE, DONE, FILE, MATERIALS, PROGRAM, SMALL_GRID, VINYL, InFolder, run)

SAMPLES = "theta_i_deg,theta_s_deg,phi_deg\n30,30,0\n60,-20,0\n0,0,77\n"

# A material, line by line as the messages count.
GOOD = """name = "brown vinyl"
description = "Brown vinyl-like sheet, visible light, imaging-sphere measurement"

[parameters]
n_eff = 1.24
k_eff = 0.0
sigma_surface = 1.9
rho_surface = 0.45
sigma_bulk = 0.073
rho_bulk = 0.88
sigma_retro = 0.061
rho_retro = 1.9
w_a = 0.21
w_b = 0.12
gamma = 0.9
delta = 0.0
w = 2.0
n = 0.0
"""


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
        arguments = ["integrate", "-", "--theta-i", "0,30,75"]
        device = rows(run(*arguments, stdin=GOOD).stdout)
        # Values of N by an independent implementation.
        golden = {0: 0.164490678175, 30: None, 75: 0.1276008474614}
        self.assertEqual(list(device[0]), ["theta_i_deg", "N_surface", "N_bulk", "N_retro", "dhr", "dhr_surface", "dhr_bulk", "dhr_retro"])
        for row in device:
            expected = golden[int(row["theta_i_deg"])]
            if expected:
                self.assertAlmostEqual(float(row["N_surface"]) / expected, 1, delta=1e-10)
            parts = sum(float(row[f"dhr_{lobe}"]) for lobe in ("surface", "bulk", "retro"))
            self.assertAlmostEqual(float(row["dhr"]) / parts, 1, delta=1e-14)
        text = run(*arguments, stdin=GOOD).stdout
        self.assertRegex(text, r"\n# bhr = 0\.1909332\d+\n")
        self.assertRegex(text, r"\n# reciprocity of 1768 pairs: median 0\.\d+, 90 % 0\.\d+, maximum \d\.\d+ at theta_i = \d+, theta_s = \d+, phi = \d+ degrees; .*\n$")

    def test_unpolarized_is_the_mean(self):
        value = {}
        for polarization in ("unpolarized", "s", "p"):
            value[polarization] = float(rows(run("integrate", VINYL, "--theta-i", "60", "--polarization", polarization).stdout)[0]["dhr"])
        self.assertAlmostEqual(value["unpolarized"], (value["s"] + value["p"]) / 2, delta=1e-15)
        self.assertGreater(value["s"], value["p"])


class Generate(InFolder):
    def generate(self, *arguments, **changes):
        return run("generate", *arguments, *SMALL_GRID, **changes)

    def assert_nothing_written(self):
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_writes_and_says_so(self):
        result = self.generate(VINYL, "-o", self.folder / "t.h5")
        self.assertEqual(result.returncode, DONE, result.stderr)
        self.assertIn("t.h5", result.stderr)
        self.assertEqual(self.generate(VINYL, "-q", "-o", self.folder / "quiet.h5").stderr, "")
        self.assertEqual(run("-q", "generate", VINYL, "-o", self.folder / "silent.h5").stderr, "")

    def test_several_materials_into_a_folder(self):
        materials = sorted(MATERIALS.glob("*.toml"))
        self.assertEqual(self.generate(*materials, "-o", f"{self.folder}/").returncode, DONE)
        self.assertEqual(sorted(f.stem for f in self.folder.iterdir()), [m.stem for m in materials])
        self.assert_refused(self.generate(VINYL, VINYL, "-o", f"{self.folder}/", "--force"), BAD_INPUT, "two materials")
        self.assert_refused(self.generate(VINYL, materials[0], "-o", self.folder / "one.h5"), FILE, "-o FOLDER/")
        existing = self.folder / "brown-vinyl.h5"
        self.assert_refused(self.generate(VINYL, materials[0], "-o", existing), BAD_INPUT, "is a file; several materials need -o FOLDER/")

    def test_info_shows_what_a_table_holds(self):
        table = self.folder / "t.h5"
        self.generate(VINYL, "-o", table)
        text = run("info", table).stdout
        for part in ("theta_i", "brdf", "sr-1", "azimuth_convention", "rho_surface", "accuracy_max_relative_error", "dhr", 'name = "brown vinyl"'):
            self.assertIn(part, text)
        described = json.loads(run("info", table, "--json").stdout)
        self.assertEqual(described["variables"]["theta_i"]["values"], [0, 20, 40, 60, 80])
        self.assertEqual(described["variables"]["brdf"]["shape"], [5, 1, 12, 13])
        self.assertLess(described["attributes"]["accuracy_max_relative_error"], 1e-6)

    def test_info_refuses_other_files(self):
        text = self.folder / "text.h5"
        text.write_text("no table")
        self.assert_refused(run("info", text), BAD_INPUT, "neither an HDF5 nor an OpenEXR file")
        self.assert_refused(run("info", self.folder / "none.h5"), FILE, "does not exist")
        foreign = self.folder / "foreign.h5"
        with h5py.File(foreign, "w") as file:
            file.attrs["material"] = numpy.array([b"x" * 50] * 1000)
            file.attrs["azimuth_convention"] = numpy.bytes_("none")
        self.assert_refused(run("info", foreign), BAD_INPUT, "not a table of brdftab")
        with h5py.File(foreign, "w") as file:
            file.attrs["material"] = numpy.bytes_("text")
            file.attrs["azimuth_convention"] = numpy.bytes_("none")
            file.attrs["matrix"] = numpy.zeros((2, 3000))
        self.assertEqual(run("info", foreign).returncode, DONE)

    def test_bad_materials(self):
        good = GOOD
        big = "# " + "x" * 10_000_000

        def line(key):
            return good[:good.index(key)].count("\n") + 1

        for text, *parts in ((good.replace("rho_bulk", "rho_bluk"), f":{line('rho_bulk')}:1: parameters.rho_bluk", "did you mean rho_bulk?"),
                             (good.replace("w = 2.0\n", ""), "parameters.w is missing"),
                             (good.replace("1.24", '"1.24"'), "must be a number"),
                             (good.replace("1.24", "24"), "n_eff = 24: must lie in 0.05 to 20"),
                             (good.replace("1.24", "nan"), "n_eff = nan: must be finite"),
                             (good.replace("1.24", "+inf"), "n_eff = +inf: must be finite"), ("", ":1:1: the file is empty"),
                             (good + "name = 3\n", f":{good.count(chr(10)) + 1}:"), (good.replace("k_eff", "n_eff"), f":{line('k_eff')}:"), (good + big, "larger than"),
                             (good + "[grid]\ntheta_s = \"0:90:1\"\n", "grid.theta_s", "90 does not")):
            material = self.folder / "material.toml"
            material.write_text(text)
            result = run("generate", material, "-o", self.folder / "t.h5")
            self.assert_refused(result, BAD_INPUT, f"{material}:", *parts)
            material.unlink()
            self.assert_nothing_written()
        material = self.folder / "binary.toml"
        material.write_bytes(bytes(range(256)))
        self.assert_refused(run("generate", material, "-o", self.folder / "t.h5"), BAD_INPUT, "byte 0x00: a material is a text file")
        self.assert_refused(run("generate", self.folder / "none.toml", "-o", self.folder / "t.h5"), FILE, "No such file")

    def test_bad_axes(self):
        for option, text, *parts in (("--theta-i", "80:0:5", "increase"), ("--theta-i", "0,10,10", "10 follows 10"),
                                     ("--theta-s", "0:90:5", "90 does not"), ("--theta-s", "", "no node"),
                                     ("--phi-s", "0:360:0.0001", "at most 100000"), ("--phi-i", "0:400:5", "must lie in"),
                                     ("--phi-s", "0:360:7", "whole number of steps"), ("--theta-i", "zero", "'zero' is not a number")):
            result = run("generate", VINYL, "-o", self.folder / "t.h5", option, text)
            self.assert_refused(result, BAD_INPUT, option, *parts)
            self.assert_nothing_written()

    def test_more_samples_than_any_disk_holds(self):
        axes = [text for option in ("--theta-i", "--phi-i", "--theta-s", "--phi-s") for text in (option, "0:65.535:0.001")]
        self.assert_refused(run("generate", VINYL, "-o", self.folder / "t.h5", *axes), BAD_INPUT, "1.84e+19 samples")
        self.assert_nothing_written()

    def test_only_regular_files_are_replaced(self):
        fifo = self.folder / "t.h5"
        os.mkfifo(fifo)
        self.assert_refused(self.generate(VINYL, "-o", fifo, "--force"), FILE, "is not a regular file")
        fifo.unlink()
        table, link = self.folder / "table.h5", self.folder / "link.h5"
        table.write_text("old")
        link.symlink_to(table)
        self.assertEqual(self.generate(VINYL, "-o", link, "--force").returncode, DONE)
        self.assertTrue(link.is_symlink())
        self.assertGreater(table.stat().st_size, 1000)

    def test_negative_angles_may_be_given(self):
        result = run("generate", VINYL, "-o", self.folder / "t.h5", "--theta-i", "30", "--theta-s", "0:80:10", "--phi-s", "-180:180:30")
        self.assertEqual(result.returncode, DONE, result.stderr)

    def test_output_that_cannot_be_written(self):
        self.assert_refused(self.generate(VINYL, "-o", self.folder / "none" / "t.h5"), FILE, "does not exist")
        self.assert_refused(self.generate(VINYL, "-o", self.folder / "t.xyz"), BAD_INPUT, "names no format", ".h5")
        self.assert_nothing_written()
        existing = self.folder / "t.h5"
        existing.write_text("precious")
        self.assert_refused(self.generate(VINYL, "-o", existing), FILE, "exists; --force overwrites it")
        self.assertEqual(existing.read_text(), "precious")
        self.assertEqual(self.generate(VINYL, "-o", existing, "--force").returncode, DONE)
        self.assertEqual([f.name for f in self.folder.iterdir()], ["t.h5"])

    def test_read_only_folder(self):
        # Root writes anywhere, except where the file system itself is read-only.
        target = "/proc/t.h5" if os.geteuid() == 0 else self.folder / "t.h5"
        if os.geteuid() != 0:
            self.folder.chmod(0o500)
            self.addCleanup(self.folder.chmod, 0o700)
        self.assert_refused(self.generate(VINYL, "-o", target), FILE, "cannot be written")

    def test_full_disk(self):
        mount = ["mount", "-t", "tmpfs", "-o", "size=2m", "tmpfs", str(self.folder)]
        if os.geteuid() != 0 or subprocess.run(mount, capture_output=True).returncode != 0:
            self.skipTest("mounting a small tmpfs takes root")
        self.addCleanup(subprocess.run, ["umount", str(self.folder)])
        outside = tempfile.TemporaryDirectory()
        self.addCleanup(outside.cleanup)
        self.outside = pathlib.Path(outside.name)
        result = run("generate", VINYL, "-o", self.folder / "t.h5", "--phi-i", "0:350:10")
        self.assert_refused(result, FILE, "free space")
        self.assert_nothing_written()
        # Room for the samples, but not for the text that goes with them: the disk fills while the file is written.
        filler = self.folder / "filler"
        filler.write_bytes(bytes(2 * 1024 * 1024 - 300 * 1024))
        material = self.outside / "long.toml"
        material.write_text(VINYL.read_text() + "# note\n" * 100_000)
        result = self.generate(material, "-o", self.folder / "t.h5")
        self.assert_refused(result, FILE, self.folder / "t.h5", "No space left on device")
        self.assertEqual([f.name for f in self.folder.iterdir()], ["filler"])

    def test_no_device(self):
        empty = self.folder / "no-vendors"
        empty.mkdir()
        result = self.generate(VINYL, "-o", self.folder / "t.h5", OCL_ICD_VENDORS=str(empty))
        self.assert_refused(result, DEVICE, "no OpenCL device", "pocl-opencl-icd")
        self.assertEqual([f.name for f in self.folder.iterdir()], ["no-vendors"])

    def test_unknown_device(self):
        result = self.generate(VINYL, "-o", self.folder / "t.h5", "--device", "abacus")
        self.assert_refused(result, DEVICE, "no OpenCL device is called 'abacus'", "there is 0 (0:0")
        self.assert_refused(self.generate(VINYL, "-o", self.folder / "t.h5", BRDFTAB_DEVICE="99"), DEVICE, "'99'")
        self.assert_nothing_written()
        for selector in ("0", "0:0", "portable"):
            self.assertEqual(self.generate(VINYL, "-o", self.folder / "t.h5", "--force", "--device", selector).returncode, DONE)

    def test_unusable_cache_folder(self):
        result = self.generate(VINYL, "-o", self.folder / "t.h5", POCL_CACHE_DIR="/proc/none")
        self.assert_refused(result, DEVICE, "POCL_CACHE_DIR=/proc/none", "set it to a writable folder")
        result = self.generate(VINYL, "-o", self.folder / "t.h5", POCL_CACHE_DIR=None, HOME="/proc/none", XDG_CACHE_HOME=None)
        self.assertEqual(result.returncode, DONE, result.stderr)


if __name__ == "__main__":
    assert PROGRAM
    unittest.main()
