"""The function `brdf` of host/FORMATS.md, run as it stands there, on tables of every kind that `generate` makes."""

import json
import re
import unittest

import numpy
import xarray
from scipy.interpolate import RegularGridInterpolator

import scalar_reference
from program import DONE, MATERIALS, ROOT, VINYL, InFolder, run
from scalar_reference import SHEETING

THETA = ["--theta-i", "0:80:10", "--theta-s", "0:85:5"]
TURN = [*THETA, "--phi-s", "0:360:5"]
# These are all ways to lay nodes round a circle, of which each can serve any azimuth.
AZIMUTHS = {"closed": ["--phi-s", "0:360:5"], "open": ["--phi-s", "0:355:5"], "signed": ["--phi-s=-180:180:5"],
            "half": ["--phi-s", "0:180:5"], "other half": ["--phi-s", "180:360:5"], "centred": ["--phi-s", "2.5:357.5:5"],
            "no node at 180": ["--phi-s", "0:352:8"], "turned": ["--phi-i", "35", "--phi-s=-145:215:5"],
            "all": ["--phi-i", "0:355:5", "--phi-s", "0:355:5"], "uneven": ["--phi-s", "0,5,15,30,60,100,150,170,180"],
            "phi_i instead": ["--phi-i", "0:350:10", "--phi-s", "0,180"], "only phi_i": ["--phi-i", "0:180:5", "--phi-s", "0"]}
ROUNDED = 1e-6  # float32, and what a table promises


def function():
    """As a reader of the document copies it."""
    (text,) = re.findall(r"^```python\n(import itertools.*?)^```", (ROOT / "host" / "FORMATS.md").read_text(), re.M | re.S)
    namespace = {}
    exec(text, namespace)
    return namespace["brdf"]


brdf = function()


class OfATable(InFolder):
    def table(self, *options, material=VINYL, engine="netcdf4"):
        path = self.folder / "table.h5"
        made = run("generate", material, "-o", path, "--force", *options)
        self.assertEqual(made.returncode, DONE, made.stderr)
        table = xarray.open_dataset(path, engine=engine)
        self.addCleanup(table.close)
        return table

    def directions(self, count, theta_i=80, theta_s=85):
        """theta_i, phi_i, theta_s, phi_s, the azimuths far beyond one turn."""
        draw = numpy.random.default_rng(7)
        return [draw.uniform(0, theta_i, count), draw.uniform(-500, 800, count), draw.uniform(0, theta_s, count),
                draw.uniform(-500, 800, count)]

    def refused(self, table, *said, **asked):
        asked = {"theta_i": 10, "phi_i": 0, "theta_s": 20, "phi_s": 30, **asked}
        with self.assertRaises(ValueError) as caught:
            brdf(table, **asked)
        for part in said:
            self.assertIn(part, str(caught.exception))

    def assert_nodes(self, table, material=VINYL):
        """Every node of `brdf` as it is stored; some of them as `evaluate` has them, wherever the function finds them."""
        nodes = numpy.meshgrid(*(table[axis].values for axis in ("theta_i", "phi_i", "theta_s", "phi_s")), indexing="ij")
        numpy.testing.assert_allclose(brdf(table, *nodes), table.brdf.values, rtol=ROUNDED)
        some = numpy.random.default_rng(3).choice(nodes[0].size, 50)
        theta_i, phi_i, theta_s, phi_s = (axis.ravel()[some] for axis in nodes)
        expected = scalar_reference.brdf(material, zip(theta_i.tolist(), theta_s.tolist(), (phi_s - phi_i).tolist()))
        for turn, sign in ((0, 1), (-360, 1), (720, 1), (0, -1)):
            found = brdf(table, theta_i, 70 + phi_i, theta_s, 70 + phi_i + sign * (phi_s - phi_i) + turn)
            numpy.testing.assert_allclose(found, expected, rtol=ROUNDED)


class Nodes(OfATable):
    def test_the_default_table(self):
        for engine in ("netcdf4", "h5netcdf"):
            with self.subTest(engine):
                self.assert_nodes(self.table(engine=engine))

    def test_every_way_to_lay_azimuths(self):
        for name, options in AZIMUTHS.items():
            with self.subTest(name):
                self.assert_nodes(self.table(*THETA, *options))

    def test_another_material(self):
        self.assert_nodes(self.table(*THETA, *AZIMUTHS["open"], material=SHEETING), SHEETING)

    def test_tables_of_one_node(self):
        table = self.table("--theta-i", "30", "--theta-s", "40", "--phi-i", "10", "--phi-s", "100")
        self.assert_nodes(table)
        self.refused(table, "theta_i = 31", "30.0 to 30.0", theta_i=31, theta_s=40, phi_s=90)
        self.refused(table, "phi = 89", "90.0 to 90.0", theta_i=30, theta_s=40, phi_s=89)

    def test_polarisations(self):
        table = self.table(*TURN, "--polarization", "all")
        pair = "theta_i_deg,theta_s_deg,phi_deg\n30,60,-110\n"
        row, = scalar_reference.rows(run("evaluate", VINYL, "--engine", "reference", stdin=pair).stdout)
        for name in ("brdf", "brdf_s", "brdf_p"):
            self.assertAlmostEqual(float(brdf(table, 30, 150, 60, 40, name=name)) / float(row[name]), 1, delta=ROUNDED)
        self.assertGreater(abs(float(row["brdf_s"]) / float(row["brdf_p"]) - 1), 0.01)
        with self.assertRaises(KeyError):
            brdf(self.table(*TURN), 30, 150, 60, 40, name="brdf_s")

    def test_results_have_the_shape_of_what_is_asked(self):
        table = self.table(*TURN)
        self.assertEqual(brdf(table, 10, 0, 20, 30).shape, ())
        found = brdf(table, [[10], [20]], 0, 20, [30, 60, 90])
        self.assertEqual(found.shape, (2, 3))
        self.assertEqual(found[1, 2], table.brdf.sel(theta_i=20, phi_i=0, theta_s=20, phi_s=90))


class BetweenNodes(OfATable):
    def padded(self, table):
        """An interpolation of SciPy's over a whole turn, in place of the table's own azimuths."""
        phi = table.phi_s.values
        f = table.brdf.values[:, 0]
        if phi[-1] == 180:
            phi, f = numpy.r_[phi, 360 - phi[-2::-1]], numpy.concatenate([f, f[:, :, -2::-1]], axis=2)
        elif phi[-1] != 360:
            phi, f = numpy.r_[phi, 360 + phi[0]], numpy.concatenate([f, f[:, :, :1]], axis=2)
        interpolate = RegularGridInterpolator((table.theta_i.values, table.theta_s.values, phi), f.astype(float))
        return lambda theta_i, phi_i, theta_s, phi_s: interpolate((theta_i, theta_s, phi[0] + (phi_s - phi_i - phi[0]) % 360))

    def test_equals_an_independent_interpolation(self):
        for name in ("closed", "open", "half", "centred", "no node at 180"):
            with self.subTest(name):
                table = self.table(*THETA, *AZIMUTHS[name])
                asked = self.directions(2000)
                numpy.testing.assert_allclose(brdf(table, *asked), self.padded(table)(*asked), rtol=2e-6)

    def test_the_default_table(self):
        table = self.table()
        asked = self.directions(2000, theta_i=table.theta_i.values[-1], theta_s=table.theta_s.values[-1])
        numpy.testing.assert_allclose(brdf(table, *asked), self.padded(table)(*asked), rtol=2e-6)

    def test_is_as_near_to_the_model_as_validate_says(self):
        for options in ([*THETA, "--phi-s", "0:355:5"], [*THETA, "--phi-s", "0:360:5", "--phi-i", "0:300:60"],
                        ["--interpolation-error", "10%"]):
            with self.subTest(options):
                table = self.table(*options)
                said = json.loads(run("validate", self.folder / "table.h5", "--json").stdout)["interpolation"]
                centres = [(axis[1:] + axis[:-1]) / 2 for axis in (table[name].values for name in ("theta_i", "theta_s", "phi_s"))]
                theta_i, theta_s, phi = (each.ravel()[::37] for each in numpy.meshgrid(*centres, indexing="ij"))
                model = numpy.array(scalar_reference.brdf(VINYL, zip(theta_i.tolist(), theta_s.tolist(), phi.tolist()), "opencl"))
                peak = table.brdf.max(("phi_i", "theta_s", "phi_s")).values
                peak = numpy.minimum(peak[1:], peak[:-1])[numpy.searchsorted(table.theta_i.values, theta_i) - 1]
                error = abs(brdf(table, theta_i, 17, theta_s, 17 + phi) - model) / numpy.maximum(model, said["floor"] * peak)
                self.assertLessEqual(error.max(), said["cell_centres"]["linear"]["max"] * (1 + 1e-5))
                self.assertGreater(error.max(), 0.001)


class Bands(OfATable):
    def test_at_bands_and_between(self):
        material = MATERIALS / "garnet-red-spectrum.toml"
        table = self.table(*TURN, material=material)
        bands = table.wavelength.values
        expected = scalar_reference.brdf(material, [(30, 40, 100)])
        self.assertEqual(len(expected), len(bands))
        numpy.testing.assert_allclose(brdf(table, 30, 0, 40, -100, wavelength=bands), expected, rtol=ROUNDED)
        between = brdf(table, 30, 0, 40, -100, wavelength=0.75 * bands[0] + 0.25 * bands[1])
        self.assertAlmostEqual(float(between) / (0.75 * expected[0] + 0.25 * expected[1]), 1, delta=ROUNDED)
        self.refused(table, f"wavelength = {bands[-1] + 1}", f"{bands[0]} to {bands[-1]}", wavelength=bands[-1] + 1)
        self.refused(table, "wavelength", "450", "650")
        self.refused(self.table(*TURN), "wavelength = 450", "none", wavelength=450)

    def test_one_band(self):
        material = self.folder / "one.toml"
        material.write_text(VINYL.read_text() + "[[band]]\nwavelength_nm = 532\n")
        table = self.table(*TURN, material=material)
        self.assertEqual(brdf(table, 10, 0, 20, 30, wavelength=532), table.brdf.sel(theta_i=10, theta_s=20, phi_s=30).item())
        self.refused(table, "wavelength = 533", "532.0 to 532.0", wavelength=533)


class Storage(OfATable):
    def test_views_and_compression(self):
        grid = [*THETA, "--phi-i", "0:350:10", "--phi-s", "0:355:5", "--polarization", "all"]
        asked = self.directions(500)
        plain = brdf(self.table(*grid), *asked)
        polarized = brdf(self.table(*grid), *asked, name="brdf_p")
        for options in (["--layout", "virtual"], ["--compress", "deflate"], ["--layout", "virtual", "--compress", "deflate"]):
            for engine in ("netcdf4", "h5netcdf"):
                with self.subTest(options=options, engine=engine):
                    table = self.table(*grid, *options, engine=engine)
                    numpy.testing.assert_array_equal(brdf(table, *asked), plain)
                    if "virtual" in options:
                        numpy.testing.assert_allclose(brdf(table, *asked, name="brdf_relative"), plain, rtol=2e-6)
                        numpy.testing.assert_allclose(brdf(table, *asked, name="brdf_p_relative"), polarized, rtol=2e-6)


class Refusals(OfATable):
    def test_theta_beyond_the_nodes(self):
        table = self.table(*THETA, *AZIMUTHS["open"])
        self.refused(table, "theta_s = 85.5", "0.0 to 85.0", theta_s=[10, 85.5])
        self.refused(table, "theta_i = 80.1", "0.0 to 80.0", theta_i=80.1)
        self.refused(table, "theta_i = -1", theta_i=-1)
        for angle in ("theta_i", "phi_i", "theta_s", "phi_s"):
            self.refused(table, "= nan", **{angle: numpy.nan})
        default = self.table()
        last = default.theta_s.values[-1]
        self.refused(default, f"theta_s = {last + 0.25}", f"to {last}", theta_s=last + 0.25)

    def test_azimuths_that_no_node_serves(self):
        quarter = self.table(*THETA, "--phi-s", "0:90:5")
        self.assertEqual(brdf(quarter, 10, 0, 20, -90), brdf(quarter, 10, 0, 20, 90))
        for phi_s in (91, -91, 180, 269):
            self.refused(quarter, "phi = ", "0.0 to 90.0", phi_s=phi_s)
        # The table has two sectors and nothing between them.
        sectors = self.table(*THETA, "--phi-i", "0,100", "--phi-s", "0:30:5")
        self.assertEqual(brdf(sectors, 10, 0, 20, 70), sectors.brdf.sel(theta_i=10, phi_i=100, theta_s=20, phi_s=30).item())
        self.refused(sectors, "phi = 50", "steps of at most 5", phi_s=50)


if __name__ == "__main__":
    unittest.main()
