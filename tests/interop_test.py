"""Tables opened by tools that others wrote, and compared with the scalar reference."""

import csv
import io
import pathlib
import random
import shutil
import subprocess
import tempfile
import tomllib
import unittest

import h5py
import xarray

from program import DONE, SMALL_GRID, VINYL, run

GRID = ["--theta-i", "0:85:5", "--phi-i", "0:355:5", "--theta-s", "0:89:1", "--phi-s", "0:360:5"]


class DenseTable(unittest.TestCase):
    """The 4-D table of the project's own acceptance: 18 x 72 x 90 x 73 nodes."""

    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.table = pathlib.Path(cls.temporary.name) / "vinyl.h5"
        result = run("generate", VINYL, "-o", cls.table, *GRID)
        assert result.returncode == DONE, result.stderr

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def test_h5py_sees_named_axes(self):
        with h5py.File(self.table) as file:
            brdf = file["brdf"]
            self.assertEqual(brdf.shape, (18, 72, 90, 73))
            self.assertEqual(brdf.dtype, "float32")
            self.assertEqual([d[0].name for d in brdf.dims], ["/theta_i", "/phi_i", "/theta_s", "/phi_s"])
            self.assertEqual(brdf.attrs["units"].decode() if isinstance(brdf.attrs["units"], bytes) else brdf.attrs["units"], "sr-1")
            self.assertEqual(file.attrs["rho_surface"], tomllib.loads(VINYL.read_text())["parameters"]["rho_surface"])
            for name in ("normalization_surface", "normalization_bulk", "normalization_retro", "dhr", "dhr_surface", "dhr_bulk", "dhr_retro"):
                self.assertEqual(file[name].shape, (18,))
                self.assertEqual(file[name].dtype, "float64")

    def test_xarray_engines_select_by_angle(self):
        for engine in ("netcdf4", "h5netcdf"):
            with self.subTest(engine), xarray.open_dataset(self.table, engine=engine) as data:
                self.assertEqual(data.brdf.dims, ("theta_i", "phi_i", "theta_s", "phi_s"))
                self.assertEqual(data.attrs["Conventions"], "CF-1.10")
                self.assertEqual(data.theta_s.attrs["units"], "degree")
                self.assertEqual(data.brdf.attrs["units"], "sr-1")
                forward = float(data.brdf.sel(theta_i=60, phi_i=0, theta_s=60, phi_s=0))
                backward = float(data.brdf.sel(theta_i=60, phi_i=0, theta_s=60, phi_s=180))
                self.assertGreater(forward, backward)

    def test_ncdump_prints_the_header(self):
        text = subprocess.run(["ncdump", "-h", self.table], capture_output=True, text=True, check=True).stdout
        self.assertIn("float brdf(theta_i, phi_i, theta_s, phi_s)", text)
        self.assertIn('Conventions = "CF-1.10"', text)
        self.assertIn('brdf:units = "sr-1"', text)

    @unittest.skipUnless(shutil.which("h5dump"), "h5dump is not installed")
    def test_h5dump_finds_the_scales(self):
        text = subprocess.run(["h5dump", "-H", "-A", self.table], capture_output=True, text=True, check=True).stdout
        self.assertIn("DIMENSION_LIST", text)

    def test_material_can_be_made_again(self):
        with xarray.open_dataset(self.table) as data:
            self.assertEqual(data.attrs["material"], VINYL.read_text())

    def test_random_nodes_equal_the_reference(self):
        chosen = random.Random(5)
        with xarray.open_dataset(self.table) as data:
            nodes = [{axis: chosen.choice(data[axis].values) for axis in data.brdf.dims} for _ in range(300)]
            stored = [float(data.brdf.sel(node)) for node in nodes]
        pairs = "theta_i_deg,phi_i_deg,theta_s_deg,phi_s_deg\n"
        pairs += "".join(f"{n['theta_i']},{n['phi_i']},{n['theta_s']},{n['phi_s']}\n" for n in nodes)
        reference = run("evaluate", VINYL, "--engine", "reference", stdin=pairs)
        self.assertEqual(reference.returncode, DONE, reference.stderr)
        for node, value, row in zip(nodes, stored, csv.DictReader(io.StringIO(reference.stdout))):
            self.assertAlmostEqual(value / float(row["brdf"]), 1, delta=1e-6, msg=str(node))


class OtherTables(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def test_bands_and_polarizations_in_float64(self):
        material = self.folder / "bands.toml"
        material.write_text(VINYL.read_text() + "[[band]]\nwavelength_nm = 450\n[[band]]\nwavelength_nm = 650\nsigma_bulk = 0.21\n")
        table = self.folder / "bands.nc"
        result = run("generate", material, "-o", table, "--polarization", "all", "--precision", "float64", *SMALL_GRID)
        self.assertEqual(result.returncode, DONE, result.stderr)
        with xarray.open_dataset(table) as data:
            self.assertEqual(data.brdf.dims, ("wavelength", "theta_i", "phi_i", "theta_s", "phi_s"))
            self.assertEqual(list(data.wavelength.values), [450, 650])
            self.assertEqual(data.wavelength.attrs["units"], "nm")
            self.assertEqual(data.brdf.dtype, "float64")
            self.assertEqual(data.dhr.dims, ("wavelength", "theta_i"))
            self.assertNotIn("rho_surface", data.attrs)
            mean = (data.brdf_s + data.brdf_p) / 2
            self.assertLess(float(abs(data.brdf / mean - 1).max()), 1e-14)
            self.assertTrue(bool((data.brdf.sel(wavelength=650) > data.brdf.sel(wavelength=450)).all()))

    def test_a_long_material_text_is_carried_whole(self):
        material = self.folder / "long.toml"
        material.write_text(VINYL.read_text() + "".join(f"# note {k}\n" for k in range(20000)))
        table = self.folder / "long.h5"
        self.assertEqual(run("generate", material, "-o", table, *SMALL_GRID).returncode, DONE)
        for engine in ("netcdf4", "h5netcdf"):
            with self.subTest(engine), xarray.open_dataset(table, engine=engine) as data:
                self.assertEqual(data.attrs["material"], material.read_text())

    @unittest.skipUnless(shutil.which("octave-cli"), "Octave is not installed")
    def test_octave_loads_it_with_dimensions_reversed(self):
        table = self.folder / "t.h5"
        run("generate", VINYL, "-o", table, *SMALL_GRID)
        script = f"d = load('{table}'); disp(size(d.brdf)); disp(d.theta_s(2));"
        text = subprocess.run(["octave-cli", "--eval", script], capture_output=True, text=True, check=True).stdout
        self.assertEqual(text.split(), ["13", "12", "1", "5", "8"])


if __name__ == "__main__":
    unittest.main()
