"""Compressed, rounded and virtual tables: what others' tools read from them is what the plain table holds."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import h5py
import numpy
import xarray

from program import BAD_INPUT, DONE, FILE, SMALL_GRID, VINYL, InFolder, run

GRID = ["--theta-i", "0:80:20", "--phi-i", "0:355:5", "--theta-s", "0:85:5", "--phi-s", "0:360:5"]
STORAGES = {"plain": [], "deflate": ["--compress", "deflate"], "strongest": ["--compress", "deflate:12"], "view": ["--layout", "virtual"],
            "deflated-view": ["--layout", "virtual", "--compress", "deflate:6"]}


class SameSamples(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        cls.talk = {}
        for name, options in STORAGES.items():
            result = run("generate", VINYL, "-o", cls.folder / "new.h5", *GRID, *options)
            assert result.returncode == DONE, result.stderr
            cls.talk[name] = result.stderr
            (cls.folder / "new.h5").rename(cls.folder / f"{name}.h5")
        with h5py.File(cls.folder / "plain.h5") as file:
            cls.expected = file["brdf"][()]

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def assert_same_bits(self, samples):
        self.assertEqual(samples.dtype, self.expected.dtype)
        self.assertEqual(samples.tobytes(), self.expected.tobytes())

    def each_other(self, check):
        for name in STORAGES:
            if name != "plain":
                with self.subTest(name):
                    check(self.folder / f"{name}.h5")

    def test_h5py(self):
        def check(table):
            with h5py.File(table) as file:
                self.assert_same_bits(file["brdf"][()])
                self.assertEqual([d[0].name for d in file["brdf"].dims], ["/theta_i", "/phi_i", "/theta_s", "/phi_s"])

        self.each_other(check)

    def test_h5dump(self):
        def check(table):
            raw = self.folder / "raw"
            subprocess.run(["h5dump", "-d", "/brdf", "-b", "LE", "-o", raw, table], capture_output=True, check=True)
            self.assertEqual(raw.read_bytes(), self.expected.tobytes())

        self.each_other(check)

    def test_xarray(self):
        def check(table):
            for engine in ("netcdf4", "h5netcdf"):
                with self.subTest(engine), xarray.open_dataset(table, engine=engine) as data:
                    self.assertEqual(data.brdf.dims, ("theta_i", "phi_i", "theta_s", "phi_s"))
                    self.assert_same_bits(data.brdf.values)

        self.each_other(check)

    def test_ncdump(self):
        def values(table):
            text = subprocess.run(["ncdump", "-p", "9,17", "-v", "brdf", table], capture_output=True, text=True, check=True).stdout
            return text[text.index("data:"):]

        expected = values(self.folder / "plain.h5")
        self.each_other(lambda table: self.assertEqual(values(table), expected))

    def test_a_view_and_what_it_shows(self):
        for name in ("view", "deflated-view"):
            with self.subTest(name), xarray.open_dataset(self.folder / f"{name}.h5") as data:
                self.assertEqual(data.brdf_relative.dims, ("theta_i", "theta_s", "phi"))
                self.assertEqual((data.phi.values[0], data.phi.values[-1], data.phi.size), (-175, 180, 72))
                self.assertEqual(data.phi.attrs["units"], "degree")
                for phi_i, phi_s, phi in ((0, 0, 0), (350, 10, 20), (20, 355, -25), (180, 360, 180)):
                    shown = data.brdf.sel(phi_i=phi_i, phi_s=phi_s).values
                    self.assertEqual(shown.tolist(), data.brdf_relative.sel(phi=phi).values.tolist())

    def test_filters_are_hdf5s_own(self):
        for name, variable, chunks in (("deflate", "brdf", (1, 36, 18, 73)), ("deflated-view", "brdf_relative", (5, 18, 72))):
            with self.subTest(name), h5py.File(self.folder / f"{name}.h5") as file:
                self.assertEqual(file[variable].compression, "gzip")
                self.assertTrue(file[variable].shuffle)
                self.assertEqual(file[variable].chunks, chunks)

    def test_sizes_are_told(self):
        size = {name: (self.folder / f"{name}.h5").stat().st_size for name in STORAGES}
        self.assertLess(size["strongest"], size["deflate"])
        self.assertLess(size["deflate"], size["plain"] / 2)
        self.assertLess(size["view"], size["plain"] / 10)
        # Only samples are counted: they are so few that what HDF5 leaves free between its own structures weighs more.
        stored = {}
        for name in ("view", "deflated-view"):
            with h5py.File(self.folder / f"{name}.h5") as file:
                stored[name] = file["brdf_relative"].id.get_storage_size()
        self.assertEqual(stored["view"], 5 * 18 * 72 * 4)
        self.assertLess(stored["deflated-view"], stored["view"])
        for name in STORAGES:
            if name == "plain":
                self.assertNotIn("ratio", self.talk[name])
            else:
                self.assertIn(f"(ratio {self.expected.nbytes / size[name]:.2f}: ", self.talk[name])
        self.assertIn("deflate 12 in chunks of 1 theta_i x 36 phi_i x 18 theta_s x 73 phi_s)", self.talk["strongest"])
        self.assertIn("a view over phi_s - phi_i; deflate 6 in chunks of 5 theta_i x 18 theta_s x 72 phi)", self.talk["deflated-view"])

    def test_info(self):
        text = {name: run("info", self.folder / f"{name}.h5").stdout for name in STORAGES}
        self.assertIn("contiguous: 1.892 MB\n", text["plain"])
        self.assertRegex(text["deflate"], r"chunked, 1 x 36 x 18 x 73 nodes each, shuffle, deflate 1: 0\.\d+ MB, ratio \d")
        self.assertIn("a view of brdf_relative\n", text["view"])
        self.assertIn("chunked, 5 x 18 x 72 nodes each, shuffle, deflate 6: ", text["deflated-view"])
        described = json.loads(run("info", "--json", self.folder / "deflated-view.h5").stdout)["variables"]
        self.assertEqual(described["brdf"]["storage"], {"layout": "virtual", "view_of": "brdf_relative", "bytes": 0})
        stored = described["brdf_relative"]["storage"]
        self.assertEqual(stored["filters"], ["shuffle", "deflate 6"])
        self.assertAlmostEqual(stored["ratio"], 5 * 18 * 72 * 4 / stored["bytes"])


class KeptBits(InFolder):
    def table(self, name, *options):
        result = run("generate", VINYL, "-o", self.folder / name, *GRID, *options)
        self.assertEqual(result.returncode, DONE, result.stderr)
        with h5py.File(self.folder / name) as file:
            return file["brdf"][()].astype("float64"), dict(file["brdf"].attrs), dict(file.attrs)

    def test_every_layout_holds_the_same_rounded_samples(self):
        for precision, most in (("float32", 23), ("float64", 52)):
            exact, attributes, _ = self.table(f"{precision}.h5", "--precision", precision)
            self.assertNotIn("keep_bits", attributes)
            for keep_bits in (4, 12, most):
                bound = 2.0 ** -(keep_bits + 1)
                tables = [self.table(f"{precision}-{keep_bits}-{name}.h5", "--precision", precision, "--keep-bits", keep_bits, *options)
                          for name, options in STORAGES.items()]
                for samples, attributes, root in tables:
                    numpy.testing.assert_array_equal(samples, tables[0][0])
                    for each in (attributes, root):
                        self.assertEqual((each["keep_bits"], each["keep_bits_relative_error"]), (keep_bits, bound))
                error = numpy.abs(tables[0][0] / exact - 1).max()
                self.assertLessEqual(error, bound)
                self.assertGreaterEqual(error, 0.9 * bound if keep_bits < most else 0)
                accuracy = tables[0][2]["accuracy_max_relative_error"]
                self.assertLessEqual(accuracy, bound + 1e-6)
                if keep_bits < most:
                    self.assertGreater(accuracy, 0.1 * bound)
                else:
                    numpy.testing.assert_array_equal(tables[0][0], exact)

    def test_info(self):
        talk = run("generate", VINYL, "-o", self.folder / "t.h5", *SMALL_GRID, "--keep-bits", "12").stderr
        self.assertIn(": 12 mantissa bits)", talk)
        self.assertRegex(run("info", self.folder / "t.h5").stdout, r"keep_bits +12\n +keep_bits_relative_error +0.0001220703125\n")


class Refusals(InFolder):
    def test_bad_options(self):
        for arguments, *parts in ((["--compress", "gzip"], "--compress gzip", "deflate:LEVEL", "1 (fastest) to 12"),
                                  (["--compress", "deflate:0"], "--compress deflate:0"), (["--compress", "deflate:13"], "deflate:13"),
                                  (["--compress", "deflate:1.5"], "deflate:1.5"), (["--compress", "deflate:"], "--compress deflate:"),
                                  (["--compress", "deflated"], "--compress deflated"), (["--keep-bits", "0"], "--keep-bits 0", "1 to 23"),
                                  (["--keep-bits", "24"], "--keep-bits 24", "float32"),
                                  (["--keep-bits", "53", "--precision", "float64"], "--keep-bits 53", "1 to 52"),
                                  (["--keep-bits", "x"], "--keep-bits"), (["--layout", "dense"], "--layout")):
            result = run("generate", VINYL, "-o", self.folder / "t.h5", *SMALL_GRID, *arguments)
            self.assert_refused(result, BAD_INPUT, *parts)
            self.assertEqual(list(self.folder.iterdir()), [])

    def test_a_disk_that_fills(self):
        mount = ["mount", "-t", "tmpfs", "-o", "size=200k", "tmpfs", str(self.folder)]
        if os.geteuid() != 0 or subprocess.run(mount, capture_output=True).returncode != 0:
            self.skipTest("mounting a small tmpfs takes root")
        self.addCleanup(subprocess.run, ["umount", str(self.folder)])
        result = run("generate", VINYL, "-o", self.folder / "t.h5", *GRID, "--compress", "deflate", "--precision", "float64")
        self.assert_refused(result, FILE, self.folder / "t.h5", "cannot be written: brdf: No space left on device")
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_grids_that_are_no_view(self):
        for phi_i, phi_s, *parts in (("0:20:10", "0:360:0.1", "phi_i = ", "not 0.1"), ("0:359:1", "0:360:0.01", "whole degrees"),
                                     ("0,7,19,60", "0,1,3,10,30,90,91,97,115,118,203", "41 different values for 4 by 11 nodes")):
            result = run("generate", VINYL, "-o", self.folder / "t.h5", "--layout", "virtual", "--phi-i", phi_i, "--phi-s", phi_s)
            self.assert_refused(result, BAD_INPUT, VINYL, "--layout virtual: phi_s - phi_i takes", *parts)
            self.assertEqual(list(self.folder.iterdir()), [])


if __name__ == "__main__":
    unittest.main()
