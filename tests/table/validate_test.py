"""`validate` accepts every table that `generate` writes, and says how far it is off."""

import json
import unittest

import h5py
import numpy

from program import CHECK_FAILED, DONE, MATERIALS, VINYL, InFolder, run

# theta_i and theta_s share nodes and a length; phi_i and phi_s a length only, as f does not change where they are exchanged.
GRID = ["--theta-i", "0:80:10", "--phi-i", "0:120:30", "--theta-s", "0:80:10", "--phi-s", "0,30,60,100,180"]
BANDS = "[[band]]\nwavelength_nm = 450\n[[band]]\nwavelength_nm = 650\nn_eff = 1.5\n"
VARIANT = '[model]\nnormalization = "reciprocal"\nautocovariance = "gaussian"\nreflectance_shadowing = "surface"\n'


class Good(InFolder):
    def validated(self, table, *options):
        result = run("validate", table, "--json", *options)
        self.assertEqual(result.returncode, DONE, result.stderr)
        found = json.loads(result.stdout)
        self.assertTrue(found["good"])
        self.assertEqual(found["faults"], [])
        return found

    def test_every_layout_and_option(self):
        spectral = self.folder / "spectral.toml"
        spectral.write_text(VINYL.read_text() + BANDS)
        variant = self.folder / "variant.toml"
        variant.write_text(VINYL.read_text() + VARIANT)
        cases = [("a.h5", VINYL), ("b.nc", VINYL, "--polarization", "all"), ("c.h5", VINYL, "--precision", "float64"),
                 ("d.h5", spectral, "--polarization", "p"), ("e.h5", variant), ("f.exr", VINYL, "--polarization", "all"),
                 ("g.exr", spectral, "--exr-layout", "tiles", "--exr-compression", "zip"),
                 ("h", spectral, "--exr-layout", "files", "--polarization", "s"), ("i.exr", VINYL, "--exr-compression", "zip")]
        for name, material, *options in cases:
            with self.subTest(name):
                table = self.folder / name
                made = run("generate", material, "-o", table, *GRID, *options)
                self.assertEqual(made.returncode, DONE, made.stderr)
                found = self.validated(table)
                promised = 1e-12 if "float64" in options else 1e-6
                self.assertEqual(found["tolerance"], promised)
                self.assertLess(found["nodes"]["max_relative_error"], promised)
                nodes = 9 * 5 * 9 * 5 * (3 if "all" in options else 1) * (2 if material == spectral else 1)
                self.assertEqual(found["nodes"]["in_table"], nodes)
                self.assertEqual(found["nodes"]["compared_with_kernels"], nodes)
                self.assertGreater(found["nodes"]["compared_with_reference"], 0)

    def test_compressed_rounded_and_virtual_tables(self):
        grid = ["--theta-i", "0:80:10", "--phi-i", "0:330:30", "--theta-s", "0:80:10", "--phi-s", "0:360:15"]
        cases = [["--compress", "deflate:6"], ["--layout", "virtual"], ["--keep-bits", "12"],
                 ["--layout", "virtual", "--compress", "deflate", "--keep-bits", "10", "--polarization", "all"],
                 ["--precision", "float64", "--compress", "deflate", "--keep-bits", "30"]]
        for k, options in enumerate(cases):
            with self.subTest(options):
                table = self.folder / f"{k}.h5"
                made = run("generate", VINYL, "-o", table, *grid, *options)
                self.assertEqual(made.returncode, DONE, made.stderr)
                found = self.validated(table)
                promised = 1e-12 if "float64" in options else 1e-6
                rounding = 2.0 ** -(int(options[options.index("--keep-bits") + 1]) + 1) if "--keep-bits" in options else 0
                self.assertAlmostEqual(found["tolerance"], promised + rounding, delta=1e-6 * (promised + rounding) + promised * rounding)
                self.assertGreater(found["nodes"]["max_relative_error"], 0.5 * rounding)

    def test_shipped_materials(self):
        for material in sorted(MATERIALS.glob("*.toml")):
            with self.subTest(material.stem):
                table = self.folder / (material.stem + ".h5")
                self.assertEqual(run("generate", material, "-o", table).returncode, DONE)
                found = self.validated(table)
                self.assertEqual(found["nodes"]["in_table"], 293220 * (5 if "spectrum" in material.stem else 1))
                self.assertLess(found["normalization"]["max_relative_error"], 1e-10)
                self.assertLess(found["dhr"]["max_relative_error"], 1e-8)
                self.assertEqual(bool(found["energy"]["warnings"]), material.stem == "white-ptfe")

    def test_all_is_all(self):
        table = self.folder / "table.h5"
        self.assertEqual(run("generate", VINYL, "-o", table, *GRID).returncode, DONE)
        found = self.validated(table, "--all")
        self.assertEqual(found["nodes"]["compared_with_reference"], 2025)
        self.assertEqual(found["normalization"]["compared_with_reference"], 27)
        self.assertEqual(found["dhr"]["compared_with_reference"], 36)
        self.assertGreater(found["nodes"]["rms_relative_error"], 1e-9)  # float32 rounds

    def test_reciprocity_of_the_samples(self):
        table = self.folder / "table.h5"
        self.assertEqual(run("generate", VINYL, "-o", table, *GRID).returncode, DONE)
        with h5py.File(table) as file:
            f = file["brdf"][:, 0].astype(float)
        defect = abs(numpy.log(f / f.transpose(1, 0, 2)))
        found = self.validated(table)["reciprocity"]
        self.assertEqual(found["pairs"], 9 * 8 // 2 * 5)
        self.assertAlmostEqual(found["max"], defect.max(), 12)
        worst = tuple(int(found[name] / step) for name, step in (("theta_i", 10), ("theta_s", 10), ("phi", 30)))
        self.assertAlmostEqual(defect[worst], found["max"], 12)


class Interpolation(InFolder):
    """The errors at cell centres against the table's own samples and `evaluate`."""

    AXES = ("theta_i", "phi_i", "theta_s", "phi_s")

    def setUp(self):
        super().setUp()
        self.table = self.folder / "table.h5"
        # The grid has no node where f vanishes, and its steps are uneven.
        grid = ["--theta-i", "10,30,45", "--phi-i", "0,20,30", "--theta-s", "5,15,50,60", "--phi-s", "0,40,60,130,180"]
        self.assertEqual(run("generate", VINYL, "-o", self.table, "--precision", "float64", *grid).returncode, DONE)
        result = run("validate", self.table, "--json")
        self.assertEqual(result.returncode, DONE, result.stderr)
        self.found = json.loads(result.stdout)["interpolation"]
        with h5py.File(self.table) as file:
            self.axes = [file[name][:] for name in self.AXES]
            self.f = file["brdf"][...]

    def model(self, nodes):
        pairs = "theta_i_deg,theta_s_deg,phi_deg\n"
        points = numpy.array(numpy.meshgrid(*nodes, indexing="ij")).reshape(4, -1)
        pairs += "".join(f"{i!r},{s!r},{q - p!r}\n" for i, p, s, q in points.T.tolist())
        text = run("evaluate", VINYL, "--engine", "reference", stdin=pairs).stdout.splitlines()
        values = [float(line.split(",")[5]) for line in text if line[0].isdigit()]
        return numpy.array(values).reshape([len(a) for a in nodes])

    def check(self, found, axes):
        nodes = [0.5 * (a[1:] + a[:-1]) if k in axes else a[:-1] for k, a in enumerate(self.axes)]
        mean, logarithm = self.f, numpy.log(self.f)
        for k in range(4):
            lower = [slice(None)] * 4
            upper = [slice(None)] * 4
            lower[k], upper[k] = slice(None, -1), slice(1, None)
            if k in axes:
                mean = 0.5 * (mean[tuple(lower)] + mean[tuple(upper)])
                logarithm = 0.5 * (logarithm[tuple(lower)] + logarithm[tuple(upper)])
            else:
                mean, logarithm = mean[tuple(lower)], logarithm[tuple(lower)]
        model = self.model(nodes)
        for kind, value in (("linear", mean), ("ln", numpy.exp(logarithm))):
            error = abs(value / model - 1)
            self.assertEqual(found[kind]["points"], error.size)
            self.assertAlmostEqual(found[kind]["max"] / error.max(), 1, 9)
            self.assertAlmostEqual(found[kind]["median"] / numpy.sort(error.ravel())[error.size // 2], 1, 9)
            self.assertAlmostEqual(found[kind]["95_percent"] / numpy.sort(error.ravel())[error.size * 95 // 100], 1, 9)
            where = numpy.unravel_index(error.argmax(), error.shape)
            for axis, k in zip(self.AXES, range(4)):
                self.assertAlmostEqual(found[kind]["worst"][axis], nodes[k][where[k]], 9)
            self.assertAlmostEqual(found[kind]["worst"]["interpolated"], value[where], 9)

    def test_cell_centres(self):
        self.assertEqual(self.found["cells"], 2 * 2 * 3 * 4)
        self.check(self.found["cell_centres"], {0, 1, 2, 3})

    def test_each_axis(self):
        for k, axis in enumerate(self.AXES):
            with self.subTest(axis):
                self.check(self.found[f"along_{axis}"], {k})


class KeepBits(InFolder):
    """Rounded samples are good as far as their attributes say."""

    def rounded(self, said):
        table = self.folder / "table.h5"
        self.assertEqual(run("generate", VINYL, "-o", table, "--force", *GRID).returncode, DONE)
        with h5py.File(table, "r+") as file:
            bits = file["brdf"][...].view("uint32")
            bits = (bits + numpy.uint32(1 << 10)) & numpy.uint32(0xFFFFF800)  # 12 of 23 mantissa bits
            file["brdf"][...] = bits.view("float32")
            for name, value in said.items():
                file.attrs[name] = value
        return table

    def test_as_said(self):
        table = self.rounded({"keep_bits": 12.0, "keep_bits_relative_error": 2.0**-13})
        self.assertEqual(run("validate", table).returncode, DONE)
        found = json.loads(run("validate", table, "--json").stdout)
        self.assertEqual(found["tolerance"], 1e-6 + 2.0**-13)
        self.assertGreater(found["nodes"]["max_relative_error"], 2.0**-14)

    def test_not_said(self):
        result = run("validate", self.rounded({}))
        self.assertEqual(result.returncode, CHECK_FAILED)
        self.assertIn("differ from the reference", result.stderr)

    def test_said_falsely(self):
        result = run("validate", self.rounded({"keep_bits": 20.0, "keep_bits_relative_error": 2.0**-13}))
        self.assertEqual(result.returncode, CHECK_FAILED)
        self.assertIn("keep_bits", result.stderr)


if __name__ == "__main__":
    unittest.main()
