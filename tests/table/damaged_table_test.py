"""`validate` names what was done to tables that are damaged."""

import json
import math
import re
import shutil
import subprocess
import tomllib
import unittest

import h5py
import numpy

from program import BAD_INPUT, CHECK_FAILED, DONE, FILE, MATERIALS, VINYL, InFolder, run

# theta_i and theta_s share nodes and a length; phi_i and phi_s a length only, as f does not change where they are exchanged.
GRID = ["--theta-i", "0:80:10", "--phi-i", "0:120:30", "--theta-s", "0:80:10", "--phi-s", "0,30,60,100,180"]
VINYL_PARAMETERS = tomllib.loads(VINYL.read_text())["parameters"]


class Damaged(InFolder):
    """Each change in place, and the words that must name it."""

    def make(self, *options, name="table.h5", material=VINYL, grid=GRID):
        table = self.folder / name
        result = run("generate", material, "-o", table, *grid, *options)
        self.assertEqual(result.returncode, DONE, result.stderr)
        return table

    def assert_fault(self, table, *words, status=CHECK_FAILED):
        result = run("validate", table)
        self.assertEqual(result.returncode, status, result.stdout + result.stderr)
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        for word in (table.name, *words):
            self.assertIn(word, result.stderr)
        return result

    def edit(self, table, change):
        with h5py.File(table, "r+") as file:
            change(file)

    def test_one_node_changed_by_1e_4(self):
        table = self.make(grid=[])
        self.assertEqual(run("validate", table).returncode, DONE)

        def change(file):
            file["brdf"][7, 0, 41, 83] *= 1 + 1e-4

        self.edit(table, change)
        self.assert_fault(table, "1 of 293220 nodes", "theta_i = 35, phi_i = 0, theta_s = 41, phi_s = 166 degrees")
        found = json.loads(run("validate", table, "--json").stdout)
        self.assertFalse(found["good"])
        self.assertEqual(found["nodes"]["over_tolerance"], 1)
        worst = found["nodes"]["worst"]
        self.assertAlmostEqual(worst["stored"] / worst["reference"] - 1, 1e-4, 6)
        self.assertEqual(run("validate", table, "--tolerance", "1e-3").returncode, DONE)

    def test_samples_of_two_axes_swapped(self):
        for a, b, names in ((0, 2, "theta_i and theta_s"), (1, 3, "phi_i and phi_s")):
            with self.subTest(names):
                table = self.make("--force")
                self.edit(table, lambda file: file["brdf"].write_direct(numpy.ascontiguousarray(file["brdf"][...].swapaxes(a, b))))
                self.assert_fault(table, f"the axes {names} are swapped")

    def test_samples_of_two_axes_of_other_lengths_swapped(self):
        table = self.make(grid=["--theta-i", "0:80:20", "--theta-s", "0:80:10", "--phi-s", "0:350:50"])

        def change(file):
            f = file["brdf"][...]
            file["brdf"][...] = f.swapaxes(2, 3).reshape(f.shape)

        self.edit(table, change)
        self.assert_fault(table, "the axes theta_s and phi_s are swapped")

    def test_dimensions_swapped(self):
        table = self.make(grid=["--theta-i", "0:80:20", "--theta-s", "0:80:10", "--phi-s", "0:350:50"])

        def change(file):
            f = file["brdf"][...]
            del file["brdf"]
            file["brdf"] = f.swapaxes(2, 3)
            file["brdf"].attrs["units"] = numpy.bytes_("sr-1")
            for k, name in enumerate(("theta_i", "phi_i", "phi_s", "theta_s")):
                file["brdf"].dims[k].attach_scale(file[name])

        self.edit(table, change)
        self.assert_fault(table, "[theta_i, phi_i, phi_s, theta_s]", "axes are swapped")

    def test_degrees_written_as_radians(self):
        for names in (["theta_i"], ["theta_s"], ["phi_s"], ["theta_i", "phi_i", "theta_s", "phi_s"]):
            with self.subTest(names):
                table = self.make("--force")

                def change(file):
                    for name in names:
                        file[name][...] = numpy.radians(file[name][...])

                self.edit(table, change)
                self.assert_fault(table, f"{', '.join(names)} {'are' if len(names) > 1 else 'is'} in radians")

    def test_units_other_than_degrees(self):
        table = self.make()

        def change(file):
            file["theta_s"].attrs["units"] = numpy.bytes_("radian")

        self.edit(table, change)
        self.assert_fault(table, "theta_s", "'radian'", "'degree'")

    def test_reversed_axis_and_backward_azimuth(self):
        table = self.make("--force")
        self.edit(table, lambda file: file["brdf"].write_direct(numpy.ascontiguousarray(file["brdf"][...][:, :, ::-1])))
        self.assert_fault(table, "theta_s is reversed")
        table = self.make("--force", grid=["--theta-i", "0:80:20", "--theta-s", "0:80:10", "--phi-s", "0:350:10"])
        self.edit(table, lambda file: file["brdf"].write_direct(numpy.roll(file["brdf"][...], 18, axis=3)))
        self.assert_fault(table, "backward side")

    def test_samples_of_another_material(self):
        table = self.make()
        other = self.make(name="other.h5", material=MATERIALS / "white-ptfe.toml")
        with h5py.File(other) as file:
            f = file["brdf"][...]
        self.edit(table, lambda file: file["brdf"].write_direct(f))
        self.assert_fault(table, "not those of the material's text")

    def test_not_finite_and_negative(self):
        for value, count in ((math.nan, "1 nodes are not finite and 0"), (-0.25, "0 nodes are not finite and 1")):
            with self.subTest(value=value):
                table = self.make("--force")

                def change(file):
                    file["brdf"][3, 1, 4, 2] = value

                self.edit(table, change)
                self.assert_fault(table, count, "theta_i = 30, phi_i = 30, theta_s = 40, phi_s = 60")

    def test_attributes_edited(self):
        changes = {"rho_surface": (0.46, "rho_surface is 0.46", str(VINYL_PARAMETERS["rho_surface"])),
                   "normalization": (numpy.bytes_("reciprocal"), "normalization is 'reciprocal'", "'hemispherical'"),
                   "azimuth_convention": (numpy.bytes_("phi = 0 is backward"), "azimuth_convention"),
                   "material": (numpy.bytes_("name = 1"), "material's text")}
        for name, (value, *words) in changes.items():
            with self.subTest(name):
                table = self.make("--force")

                def change(file):
                    del file.attrs[name]
                    file.attrs[name] = value

                self.edit(table, change)
                self.assert_fault(table, *words)

    def test_attribute_of_openexr_edited(self):
        table = self.make("--exr-layout", "tiles", name="table.exr")
        edited = self.folder / "edited.exr"
        subprocess.run(["oiiotool", table, "--attrib:type=string", "brdf:normalization", "reciprocal", "-o", edited], check=True)
        self.assert_fault(edited, "normalization is 'reciprocal'", "'hemispherical'")

    def test_pixel_of_openexr_changed(self):
        table = self.make(name="table.exr")
        # The table is not compressed: the last float of the file is the last node.
        whole = bytearray(table.read_bytes())
        whole[-4:] = numpy.float32(numpy.frombuffer(whole[-4:], "float32")[0] * 1.0001).tobytes()
        table.write_bytes(whole)
        self.assert_fault(table, "1 of 2025 nodes", "theta_i = 80, phi_i = 120, theta_s = 80, phi_s = 180")

    def test_material_text_edited(self):
        table = self.make()

        def change(file):
            text = re.sub(r"(?m)^rho_bulk = .*$", "rho_bulk = 0.89", file.attrs["material"])
            del file.attrs["material"]
            file.attrs["material"] = numpy.bytes_(text)

        self.edit(table, change)
        self.assert_fault(table, f"rho_bulk is {VINYL_PARAMETERS['rho_bulk']}", "0.89")

    def test_stored_integrals_edited(self):
        for name in ("normalization_bulk", "dhr_retro"):
            with self.subTest(name):
                table = self.make("--force")

                def change(file):
                    file[name][4] *= 1 + 1e-6

                self.edit(table, change)
                self.assert_fault(table, name, "theta_i = 40", "1.00e-06")

    def test_missing_parts(self):
        for name in ("brdf", "theta_s", "dhr"):
            with self.subTest(name):
                table = self.make("--force")
                self.edit(table, lambda file: file.pop(name))
                self.assert_fault(table, name)

    def test_truncated_tail(self):
        made = {"table.h5": [], "parts.exr": [], "tiles.exr": ["--exr-layout", "tiles", "--exr-compression", "zip"]}
        for name, options in made.items():
            with self.subTest(name):
                table = self.make(*options, name=name)
                whole = table.read_bytes()
                for kept in (len(whole) - 100, len(whole) // 2, 2000, 10):
                    table.write_bytes(whole[:kept])
                    self.assert_fault(table, "truncated" if kept > 2000 else "", status=FILE)

    def test_damaged_zip(self):
        table = self.make("--exr-compression", "zip", name="table.exr")
        whole = bytearray(table.read_bytes())
        whole[-2000:-1000] = bytes(1000)
        table.write_bytes(whole)
        self.assert_fault(table, "damaged", status=FILE)

    def test_slice_missing_from_a_folder(self):
        table = self.make("--exr-layout", "files", name="slices")
        (table / "ti30_pi060.exr").unlink()
        self.assert_fault(table, "theta_i = 30, phi_i = 60 is missing", status=FILE)

    def test_slice_exchanged_in_a_folder(self):
        table = self.make("--exr-layout", "files", name="slices")
        shutil.copy(table / "ti30_pi060.exr", table / "ti40_pi060.exr")
        self.assert_fault(table, "two slices", status=FILE)

    def test_foreign_files(self):
        hdf5 = self.folder / "foreign.h5"
        with h5py.File(hdf5, "w") as file:
            file["brdf"] = numpy.ones((2, 2, 2, 2))
        text = self.folder / "foreign.txt"
        text.write_text("theta_i,f\n0,1\n")
        exr = self.folder / "foreign.exr"
        subprocess.run(["oiiotool", "--create", "4x4", "3", "-o", exr], check=True)
        self.assert_fault(hdf5, "is an HDF5 file, but not a table of brdftab", status=BAD_INPUT)
        self.assert_fault(text, "is no table: it is neither hdf5 nor exr", status=BAD_INPUT)
        self.assert_fault(exr, "is an OpenEXR file, but not a table of brdftab", status=BAD_INPUT)
        empty = self.folder / "empty.h5"
        empty.touch()
        self.assert_fault(empty, "is empty", status=FILE)
        self.assert_fault(self.folder / "none.h5", "does not exist", status=FILE)


if __name__ == "__main__":
    unittest.main()
