"""Tables opened by tools that others wrote, and compared with the scalar reference."""

import csv
import io
import json
import pathlib
import random
import shutil
import subprocess
import tempfile
import tomllib
import unittest

import h5py
import netCDF4
import xarray

from program import DONE, MATERIALS, SMALL_GRID, VINYL, InFolder, run

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
            self.assertEqual(brdf.attrs["units"], "sr-1")
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
        self.assertIn('string :Conventions = "CF-1.10" ;', text)
        self.assertIn('string brdf:units = "sr-1" ;', text)
        self.assertIn('string theta_s:standard_name = "angle_of_emergence" ;', text)

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

    @unittest.skipUnless(shutil.which("octave-cli"), "Octave is not installed")
    def test_octave_loads_it_with_dimensions_reversed(self):
        table = self.folder / "t.h5"
        run("generate", VINYL, "-o", table, *SMALL_GRID)
        script = f"d = load('{table}'); disp(size(d.brdf)); disp(d.theta_s(2));"
        text = subprocess.run(["octave-cli", "--eval", script], capture_output=True, text=True, check=True).stdout
        self.assertEqual(text.split(), ["13", "12", "1", "5", "8"])


class Texts(InFolder):
    """Attributes that are text."""

    def made(self, material, name, *options):
        table = self.folder / name
        result = run("generate", material, "-o", table, *options)
        self.assertEqual(result.returncode, DONE, result.stderr)
        return table

    def long_material(self):
        """Text beyond ASCII, and beyond the 64 KiB that an attribute of an HDF5 object's header can have."""
        material = self.folder / "long.toml"
        description = "Mattlack „grün“, θ_i 0 to 60° – 测量 " + "x" * 100_000
        notes = "".join(f"# note {k}\n" for k in range(20000))
        text = VINYL.read_text()
        self.assertEqual(text.count("\ndescription ="), 1)
        lines = [f'description = "{description}"' if line.startswith("description =") else line for line in text.splitlines()]
        material.write_text("\n".join(lines) + "\n" + notes)
        return material, description

    def assert_strings(self, table):
        """Every text is one variable-length UTF-8 string: str in h5py. Returns how many there are."""
        texts = 0
        with h5py.File(table) as file:
            for holder in (file, *file.values()):
                for name, value in holder.attrs.items():
                    if name in ("CLASS", "NAME", "DIMENSION_LIST", "REFERENCE_LIST"):  # HDF5's own, for its dimension scales
                        continue
                    kind = holder.attrs.get_id(name).dtype
                    if kind.kind == "f":
                        continue
                    with self.subTest(f"{holder.name}: {name}"):
                        self.assertIs(type(value), str)
                        self.assertEqual(h5py.check_string_dtype(kind), ("utf-8", None))
                        texts += 1
                if isinstance(holder, h5py.Dataset):
                    self.assertTrue(holder.attrs["units"] and holder.attrs["long_name"])
        return texts

    def test_h5py_gives_str(self):
        plain = self.made(VINYL, "plain.h5", *SMALL_GRID)
        self.assertGreater(self.assert_strings(plain), 40)
        for k, (material, *options) in enumerate(((MATERIALS / "garnet-red-spectrum.toml", *SMALL_GRID),
                                                  (VINYL, *SMALL_GRID, "--layout", "virtual", "--polarization", "all"),
                                                  (VINYL, *SMALL_GRID, "--keep-bits", "12", "--compress", "deflate"),
                                                  (VINYL, "--interpolation-error", "20%"), (self.long_material()[0], *SMALL_GRID))):
            with self.subTest(options):
                self.assertGreater(self.assert_strings(self.made(material, f"{k}.h5", *options)), 40)
        with self.subTest("eradiate"):
            simulator = self.made(VINYL, "eradiate.nc", "--format", "eradiate", "--eradiate-cosines", "11", "--eradiate-azimuths", "12")
            self.assertGreater(self.assert_strings(simulator), 15)

    def test_long_texts_beyond_ascii_are_carried_whole(self):
        material, description = self.long_material()
        table = self.made(material, "long.h5", *SMALL_GRID)
        expected = {"description": description, "material": material.read_text()}
        found = {"info": json.loads(run("info", "--json", table).stdout)["attributes"]}
        with h5py.File(table) as file:
            found["h5py"] = dict(file.attrs)
        with netCDF4.Dataset(table) as file:
            found["netCDF4"] = {name: file.getncattr(name) for name in file.ncattrs()}
        for engine in ("netcdf4", "h5netcdf"):
            with xarray.open_dataset(table, engine=engine) as data:
                found[engine] = data.attrs
        for reader, attributes in found.items():
            with self.subTest(reader):
                for name, text in expected.items():
                    self.assertTrue(attributes[name] == text, f"{name}: {len(attributes[name])} of {len(text)} characters")
        header = subprocess.run(["ncdump", "-h", table], capture_output=True, text=True, check=True).stdout
        self.assertTrue(description in header)

    def test_tables_with_fixed_length_strings_are_read_as_well(self):
        for name, material in (("short", VINYL), ("long", self.long_material()[0])):
            with self.subTest(name):
                table = self.made(material, f"{name}.h5", *SMALL_GRID)
                new = self.all_that_is_read(table)
                with h5py.File(table, "r+") as file:
                    for holder in (file, *file.values()):
                        for key, value in list(holder.attrs.items()):
                            if isinstance(value, str):
                                size = len(value.encode()) + 1
                                del holder.attrs[key]
                                holder.attrs.create(key, value.encode(), dtype=h5py.string_dtype("utf-8", size))
                    self.assertNotIsInstance(file.attrs["material"], str)
                old = self.all_that_is_read(table)
                # Only names are compared: a difference of such long texts takes minutes to print.
                self.assertEqual([key for key in new if old[key] != new[key]], [])

    def all_that_is_read(self, table):
        picture, again = table.with_suffix(".svg"), table.with_name("again.h5")
        found = {command: json.loads(self.said(command, "--json", table)) for command in ("info", "validate")}
        self.said("plot", table, "-o", picture, "--force")
        self.said("generate", table, "-o", again, *SMALL_GRID, "--force")
        with h5py.File(again) as file:
            found |= {"picture": picture.read_text(), "samples": file["brdf"][()].tobytes(), "material": file.attrs["material"]}
        return found

    def said(self, *arguments):
        result = run(*arguments)
        self.assertEqual(result.returncode, DONE, result.stderr)
        return result.stdout


if __name__ == "__main__":
    unittest.main()
