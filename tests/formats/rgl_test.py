"""RGL files, read by a reader of the tests' own and compared with the scalar reference."""

import csv
import io
import json
import math
import pathlib
import tempfile
import unittest

import numpy

from program import BAD_INPUT, DONE, FILE, MATERIALS, VINYL, InFolder, run
from rgl_file import Rgl, model_angles, vector

SHIPPED = sorted(m for m in MATERIALS.glob("*.toml") if "[[band]]" not in m.read_text())
SMALL = ["--rgl-theta-i", "20", "--rgl-samples", "24", "--rgl-warp-theta", "64", "--rgl-warp-phi", "33"]


def reference(material, viewer, light, engine="reference"):
    """f of the model, [direction] or [band][direction]."""
    pairs = "theta_i_deg,theta_s_deg,phi_deg\n"
    pairs += "".join(f"{i:.17g},{s:.17g},{phi:.17g}\n" for i, s, phi in zip(*model_angles(viewer, light)))
    result = run("evaluate", material, "--engine", engine, stdin=pairs)
    assert result.returncode == DONE, result.stderr
    rows = list(csv.DictReader(line for line in io.StringIO(result.stdout) if not line.startswith("#")))
    f = numpy.array([float(row["brdf"]) for row in rows])
    return f.reshape(-1, viewer.shape[1]) if "wavelength_nm" in rows[0] else f


def random_directions(count, seed):
    """Uniform over the hemisphere; [3, count]."""
    chosen = numpy.random.default_rng(seed)
    return vector(numpy.degrees(numpy.arccos(chosen.random(count))), 360 * chosen.random(count))


def generate(material, path, *options):
    result = run("generate", material, "--format", "rgl", "-o", path, *options)
    assert result.returncode == DONE, result.stderr
    return Rgl(path)


class DefaultFiles(unittest.TestCase):
    """Every shipped material of one band at the default resolution."""

    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        folder = pathlib.Path(cls.temporary.name)
        cls.files = {m: generate(m, folder / f"{m.stem}.bsdf") for m in SHIPPED}

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def test_random_directions(self):
        viewer, light = random_directions(3000, 1), random_directions(3000, 2)
        for material, file in self.files.items():
            with self.subTest(material.stem):
                f = reference(material, viewer, light)
                error = numpy.abs(file.evaluate(viewer, light) - f) / f
                self.assertLess(numpy.median(error), 0.01)
                self.assertLess(numpy.quantile(error, 0.95), 0.05)

    def test_nodes_are_exact(self):
        for material, file in self.files.items():
            with self.subTest(material.stem):
                k = 40
                light, values = file.nodes(k)
                above = numpy.flatnonzero((light[2] > 0.02) & (numpy.arange(len(values[0])) % 7 == 0))
                self.assertGreater(len(above), 1000)
                viewer = numpy.repeat(vector(math.degrees(file.theta_i[k]), 0)[:, None], len(above), axis=1)
                # The tables are float32, and N comes from a spline.
                f = reference(material, viewer, light[:, above])
                numpy.testing.assert_allclose(values[0][above] / light[2][above], f, rtol=1e-5)
                self.assertEqual(values[:, light[2] < 0].max(initial=0), 0)

    def test_roles_and_azimuth(self):
        """Off the specular direction and out of plane: the file's first direction is the viewer, its cosine the light's, and
        azimuths turn as the model's. Each misreading is off by far more than the file is."""
        viewer, light = vector([35.0], [20.0]), vector([64.0], [250.0])
        for material, file in self.files.items():
            with self.subTest(material.stem):
                f = reference(material, viewer, light)[0]
                self.assertAlmostEqual(file.evaluate(viewer, light)[0] / f, 1, delta=0.01)
                for wrong in ((light, viewer), (viewer * numpy.array([[-1], [-1], [1]]), light)):
                    self.assertGreater(abs(reference(material, *wrong)[0] / f - 1), 0.02)
                turned = [vector(*angles) for angles in (([35.0], [107.0]), ([64.0], [337.0]))]
                self.assertAlmostEqual(file.evaluate(*turned)[0] / file.evaluate(viewer, light)[0], 1, delta=1e-9)

    def test_finite_and_not_negative(self):
        for material, file in self.files.items():
            with self.subTest(material.stem):
                for name, field in file.fields.items():
                    if field.dtype == numpy.float32:
                        self.assertTrue(numpy.isfinite(field).all(), name)
                        self.assertGreaterEqual(field.min(), 0, name)
                # f cos stays finite up to the horizon, and the tables of the last theta_i serve beyond it.
                viewer, light = vector([89.99, 89.95, 10.0], [0.0] * 3), vector([10.0, 89.99, 89.999], [100.0] * 3)
                self.assertTrue((file.evaluate(viewer, light) * light[2] >= 0).all())


class Layout(InFolder):
    def test_size_and_fields(self):
        path = self.folder / "vinyl.bsdf"
        file = generate(VINYL, path, *SMALL)
        self.assertEqual(set(file.fields), {"description", "comments", "jacobian", "phi_i", "theta_i", "ndf", "sigma", "vndf",
                                            "luminance", "rgb"})
        self.assertEqual(file.fields["vndf"].shape, (1, 20, 33, 64))
        self.assertEqual(file.fields["luminance"].shape, (1, 20, 24, 24))
        self.assertEqual(file.fields["rgb"].shape, (1, 20, 3, 24, 24))
        self.assertEqual(file.fields["jacobian"].tolist(), [1])
        self.assertEqual(file.fields["phi_i"].tolist(), [0])
        self.assertEqual(file.theta_i[0], 0)
        self.assertAlmostEqual(math.degrees(file.theta_i[-1]), 89.9, places=4)
        # Every array is in its place: after the header, on a boundary of 8 bytes, and with nothing after the last.
        header = 18 + sum(2 + len(name) + 11 + 8 * field.ndim for name, field in file.fields.items())
        end = header
        for name in sorted(file.offsets, key=file.offsets.get):
            self.assertEqual(file.offsets[name], -(-end // 8) * 8, name)
            end = file.offsets[name] + file.fields[name].nbytes
        self.assertEqual(path.stat().st_size, end)
        self.assertAlmostEqual(end, 4 * 20 * ((3 + 1) * 24**2 + 64 * 33) + 11_500 + VINYL.stat().st_size, delta=2000)
        self.assertIn("brown vinyl", bytes(file.fields["description"]).decode())
        comments = bytes(file.fields["comments"]).decode().split("\n")
        for line in VINYL.read_text().splitlines():
            self.assertIn(f"| {line}", comments)
        self.assertEqual(file.fields["rgb"][0, :, 0].tolist(), file.fields["rgb"][0, :, 2].tolist())

    def test_same_bytes_again(self):
        files = [self.folder / name for name in ("a.bsdf", "b.bsdf")]
        for file in files:
            result = run("generate", VINYL, "--format", "rgl", "-o", file, *SMALL, SOURCE_DATE_EPOCH="0")
            self.assertEqual(result.returncode, DONE, result.stderr)
        self.assertEqual(*(file.read_bytes().replace(b"b.bsdf", b"a.bsdf") for file in files))

    def test_refused(self):
        file = self.folder / "x.bsdf"
        for options, parts in ((["--rgl-warp-phi", "128"], ["--rgl-warp-phi 128", "odd"]), (["--rgl-samples", "1"], ["samples"]),
                               (["--rgl-channels", "xyz"], ["xyz"]),
                               (["--rgl-theta-i", "4096", "--rgl-samples", "4096"], ["--rgl-theta-i", "GB", "at most 4"]),
                               (["--theta-i", "0:80:5"], ["--theta-i", "rgl"])):
            with self.subTest(options):
                self.assert_refused(run("generate", VINYL, "--format", "rgl", "-o", file, *options), BAD_INPUT, *parts)
                self.assertFalse(file.exists())

    def test_damaged_files(self):
        path = self.folder / "vinyl.bsdf"
        generate(VINYL, path, *SMALL)
        whole = path.read_bytes()
        for damaged, status, part in ((whole[:-100], FILE, "field vndf"), (whole[:60], FILE, "header"),
                                      (whole.replace(b"luminance", b"luminanse"), BAD_INPUT, "luminance")):
            path.write_bytes(damaged)
            self.assert_refused(run("validate", path), status, path, part)


class Bands(InFolder):
    """A spectrum whose surface lobe widens towards the red."""

    def setUp(self):
        super().setUp()
        self.material = self.folder / "bands.toml"
        self.wavelengths = [450.0, 550.0, 650.0]
        bands = "".join(f"\n[[band]]\nwavelength_nm = {nm}\nrho_surface = {0.3 + k / 10}\nsigma_bulk = {0.1 + k / 5}\n"
                        for k, nm in enumerate(self.wavelengths))
        self.material.write_text(VINYL.read_text() + bands)
        self.directions = random_directions(1000, 3), random_directions(1000, 4)

    def test_spectral(self):
        file = generate(self.material, self.folder / "s.bsdf", "--rgl-channels", "spectral")
        self.assertEqual(file.fields["wavelengths"].tolist(), self.wavelengths)
        self.assertNotIn("rgb", file.fields)
        for k, f in enumerate(reference(self.material, *self.directions)):
            error = numpy.abs(file.evaluate(*self.directions, channel=k) - f) / f
            self.assertLess(numpy.median(error), 0.01)
            self.assertLess(numpy.quantile(error, 0.95), 0.05)

    def test_rgb(self):
        file = generate(self.material, self.folder / "rgb.bsdf", *SMALL)
        self.assertNotIn("wavelengths", file.fields)
        blue, _, red = (file.evaluate(*self.directions, channel=k) for k in (2, 1, 0))
        self.assertGreater(numpy.mean(red > blue), 0.99)
        result = run("validate", self.folder / "rgb.bsdf", "--json")
        self.assertEqual(result.returncode, DONE, result.stderr)
        self.assertLess(json.loads(result.stdout)["uniform"]["median"], 0.05)

    def test_grey_spectrum(self):
        file = generate(VINYL, self.folder / "g.bsdf", "--rgl-channels", "spectral", *SMALL)
        self.assertEqual(file.fields["spectra"].shape, (1, 20, 1, 24, 24))
        rgb = generate(VINYL, self.folder / "rgb.bsdf", *SMALL)
        self.assertEqual(file.fields["spectra"][:, :, 0].tolist(), rgb.fields["rgb"][:, :, 1].tolist())


class ReadBack(InFolder):
    def test_validate_evaluates_as_consumers_do(self):
        """The worst direction that validate names, evaluated from the file here."""
        path = self.folder / "vinyl.bsdf"
        file = generate(VINYL, path, *SMALL)
        found = json.loads(run("validate", path, "--json").stdout)
        for worst in (found["uniform"]["worst"], found["near_peaks"]["worst"]):
            light = vector([worst["theta_i"]], [180.0])
            viewer = vector([worst["theta_s"]], [worst["phi"]])
            self.assertAlmostEqual(file.evaluate(viewer, light)[0] / worst["consumer"], 1, delta=1e-6)


if __name__ == "__main__":
    unittest.main()
