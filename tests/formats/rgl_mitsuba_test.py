"""RGL files in Mitsuba 3, the renderer that they are for."""

import csv
import io
import math
import pathlib
import tempfile
import unittest

import numpy

import wheels
from program import DONE, VINYL, InFolder, run
from rgl_file import vector
from rgl_test import SHIPPED, SMALL, generate, random_directions, reference

RGB = "llvm_ad_rgb"


def setUpModule():
    global drjit, mitsuba
    wheels.use("simulators")  # skips this module's tests where there are none
    import drjit
    import mitsuba


def load(path, variant=RGB):
    mitsuba.set_variant(variant)
    return mitsuba.load_dict({"type": "measured", "filename": str(path)})


def interaction(viewer):
    surface = drjit.zeros(mitsuba.SurfaceInteraction3f, viewer.shape[1])
    surface.wi = mitsuba.Vector3f(*viewer.astype(numpy.float32))
    return surface


def evaluate(bsdf, viewer, light):
    """f cos and the density of sampling, from unit vectors [3, n]."""
    surface, to_light = interaction(viewer), mitsuba.Vector3f(*light.astype(numpy.float32))
    context = mitsuba.BSDFContext()
    return numpy.array(bsdf.eval(context, surface, to_light)), numpy.array(bsdf.pdf(context, surface, to_light))


def sample_weights(bsdf, theta, count=200_000):
    """f cos / density of samples. Their mean is the share of uniform light that reaches a viewer."""
    surface = interaction(numpy.repeat(vector(theta, 25)[:, None], count, axis=1))
    random = mitsuba.load_dict({"type": "independent"})
    random.seed(7, count)
    _, weight = bsdf.sample(mitsuba.BSDFContext(), surface, random.next_1d(), random.next_2d())
    return numpy.array(weight)[0]


def hemisphere(count):
    """A midpoint rule over the hemisphere, even in cos(theta) and phi: directions, and the solid angle of each."""
    z, phi = numpy.meshgrid((numpy.arange(count) + 0.5) / count, (numpy.arange(2 * count) + 0.5) * 180 / count)
    return vector(numpy.degrees(numpy.arccos(z.ravel())), phi.ravel()), 2 * math.pi / z.size


class Shipped(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        folder = pathlib.Path(cls.temporary.name)
        cls.files = {m: folder / f"{m.stem}.bsdf" for m in SHIPPED}
        cls.own = {m: generate(m, file) for m, file in cls.files.items()}

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def test_eval_is_the_model(self):
        viewer, light = random_directions(3000, 11), random_directions(3000, 12)
        for material, file in self.files.items():
            with self.subTest(material.stem):
                f = reference(material, viewer, light)
                values, _ = evaluate(load(file), viewer, light)
                error = numpy.abs(values / light[2] - f) / f
                self.assertLess(numpy.median(error[0]), 0.01)
                self.assertLess(numpy.quantile(error[0], 0.95), 0.05)
                self.assertGreaterEqual(values.min(), 0)
                # The tests' own reader is Mitsuba's, but for float32.
                own = numpy.abs(self.own[material].evaluate(viewer, light) * light[2] - values[0])
                self.assertLess(numpy.quantile(own / values[0], 0.99), 1e-3)

    def test_isotropic(self):
        viewer, light = random_directions(1000, 13), random_directions(1000, 14)
        turn = numpy.array([[math.cos(1.1), -math.sin(1.1), 0], [math.sin(1.1), math.cos(1.1), 0], [0, 0, 1]])
        for material, file in self.files.items():
            with self.subTest(material.stem):
                bsdf = load(file)
                still, turned = evaluate(bsdf, viewer, light)[0][0], evaluate(bsdf, turn @ viewer, turn @ light)[0][0]
                self.assertLess(numpy.quantile(numpy.abs(turned / still - 1), 0.99), 1e-3)

    def test_samples_follow_their_density(self):
        """Mitsuba's own chi-square test."""
        from mitsuba.chi2 import BSDFAdapter, ChiSquareTest, SphericalDomain
        mitsuba.set_variant(RGB)
        cases = [(file, theta) for file in self.files.values() for theta in (0, 30, 60, 80)]
        for file, theta in cases:
            with self.subTest(file.stem, theta=theta):
                draw, density = BSDFAdapter("measured", f"<string name='filename' value='{file}'/>",
                                            wi=[float(x) for x in vector(theta, 25)])
                test = ChiSquareTest(SphericalDomain(), draw, density, sample_dim=3, res=201, ires=16)
                self.assertTrue(test.run(test_count=len(cases), quiet=True), test.messages)

    def test_density_and_albedo(self):
        light, solid_angle = hemisphere(400)
        for material, file in self.files.items():
            bsdf = load(file)
            for theta in (10, 45, 75):
                with self.subTest(material.stem, theta=theta):
                    values, density = evaluate(bsdf, numpy.repeat(vector(theta, 25)[:, None], light.shape[1], axis=1), light)
                    self.assertAlmostEqual(density.sum() * solid_angle, 1, delta=0.01)
                    weights = sample_weights(bsdf, theta)
                    self.assertAlmostEqual(weights.mean() / (values[0].sum() * solid_angle), 1, delta=0.01)
                    # Samples follow f cos: uniform ones would deviate by 0.6 to 8.5 of their mean.
                    self.assertLess(weights.std() / weights.mean(), 0.25)


class Loaded(InFolder):
    def test_albedo_of_a_reciprocal_material_is_its_dhr(self):
        """Mitsuba fixes the viewer, integrate the light: for a reciprocal material both are one."""
        material = self.folder / "reciprocal.toml"
        material.write_text(VINYL.read_text() + '\n[model]\nnormalization = "reciprocal"\nreflectance_shadowing = "none"\n')
        file = self.folder / "reciprocal.bsdf"
        generate(material, file)
        bsdf = load(file)
        result = run("integrate", material, "--theta-i", "0:75:25")
        self.assertEqual(result.returncode, DONE, result.stderr)
        for row in csv.DictReader(line for line in io.StringIO(result.stdout) if not line.startswith("#")):
            with self.subTest(theta=row["theta_i_deg"]):
                self.assertAlmostEqual(sample_weights(bsdf, float(row["theta_i_deg"])).mean() / float(row["dhr"]), 1, delta=0.01)

    def test_variants(self):
        """rgb files in rgb variants, spectral files in spectral ones; at a band's wavelength its f."""
        material = self.folder / "bands.toml"
        material.write_text(VINYL.read_text() + "".join(f"\n[[band]]\nwavelength_nm = {nm}\nrho_surface = {rho}\n"
                                                        for nm, rho in ((450, 0.3), (550, 0.45), (650, 0.6))))
        for name, source in (("grey", VINYL), ("bands", material)):
            for channels in ("rgb", "spectral"):
                generate(source, self.folder / f"{name}_{channels}.bsdf", "--rgl-channels", channels)
        viewer, light = vector([40.0], [10.0]), vector([38.0], [190.0])
        grey, bands = reference(VINYL, viewer, light)[0], reference(material, viewer, light)[:, 0]
        for variant in ("scalar_rgb", RGB, "scalar_spectral", "llvm_ad_spectral"):
            channels = variant.split("_")[-1]
            with self.subTest(variant):
                for name in ("grey", "bands"):
                    bsdf = load(self.folder / f"{name}_{channels}.bsdf", variant)
                    surface = mitsuba.SurfaceInteraction3f()
                    surface.wi = mitsuba.Vector3f(*viewer[:, 0].tolist())
                    surface.wavelengths = [] if channels == "rgb" else [450, 550, 650, 600]
                    to_light = mitsuba.Vector3f(*light[:, 0].tolist())
                    value = numpy.array(bsdf.eval(mitsuba.BSDFContext(), surface, to_light)).ravel() / light[2]
                    if name == "grey":
                        numpy.testing.assert_allclose(value, grey, rtol=0.01)
                    elif channels == "spectral":
                        numpy.testing.assert_allclose(value, [*bands, bands[1:].mean()], rtol=0.01)
                    else:
                        self.assertGreater(value[2] / value[0], 1.05)  # the narrower lobe is the brighter

    def test_renders(self):
        """A sphere in even light of 1 is nowhere brighter than its albedo, and nowhere black."""
        file = self.folder / "vinyl.bsdf"
        generate(VINYL, file, *SMALL)
        mitsuba.set_variant("scalar_rgb")
        scene = mitsuba.load_dict({
            "type": "scene", "integrator": {"type": "path"}, "light": {"type": "constant"},
            "ball": {"type": "sphere", "bsdf": {"type": "measured", "filename": str(file)}},
            "sensor": {"type": "orthographic", "to_world": mitsuba.ScalarTransform4f().look_at([0, 0, 4], [0, 0, 0], [0, 1, 0]),
                       "film": {"type": "hdrfilm", "width": 32, "height": 32},
                       "sampler": {"type": "independent", "sample_count": 64}}})
        image = numpy.array(mitsuba.render(scene))[:, :, :3]
        self.assertTrue(numpy.isfinite(image).all())
        self.assertGreater(image[16, 16].min(), 0.05)
        self.assertLess(image[16, 16].max(), 0.3)


if __name__ == "__main__":
    unittest.main()
