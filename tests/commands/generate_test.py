"""`generate` writes a table and says so, or refuses in one line; `info` shows what a table holds."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import h5py
import numpy

from program import BAD_INPUT, DEVICE, DONE, FILE, GOLDEN, MATERIALS, SMALL_GRID, VINYL, InFolder, run


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
        self.assert_refused(run("info", text), BAD_INPUT, "is no table: it is neither hdf5 nor exr")
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
        good = (GOLDEN / "brown-vinyl.toml").read_text()
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
    unittest.main()
