"""Maps and files of `plot`: maps show samples, texts keep clear of each other, bad requests are refused."""

import csv
import io
import math
import unittest

import h5py
import numpy
from PIL import Image

import browser
from drawing import BANDS, Drawing
from picture import TEXTS_IN_THE_WAY
from program import BAD_INPUT, DONE, FILE, MATERIALS, VINYL, run

YELLOW = MATERIALS / "yellow-retro-sheeting.toml"
GARNET = MATERIALS / "garnet-red-paint.toml"
KINDS = ["inplane", "polar", "hemisphere", "shadowing", "dhr", "lobes"]


class Maps(Drawing):
    def read(self, pixels, scale, axis):
        """Values of a map's pixels by the nearest colour of the scale beside it, and the step of that scale in ln f."""
        colours = scale[::-1, 0, :3].astype(int)
        distance = numpy.abs(pixels[:, None, :3].astype(int) - colours[None]).sum(axis=2)
        share = (distance.argmin(axis=1) + 0.5) / len(colours)
        width = math.log(axis["high"] / axis["low"])
        return numpy.exp(math.log(axis["low"]) + share * width), width / len(colours)

    def sample(self, picture, k):
        """Directions of some pixels inside a map, and their values."""
        maps, scale = picture.images()
        side = maps[k].shape[0]
        directions, pixels = [], []
        for row in range(7, side, 23):
            for column in range(5, side, 19):
                x, y = (column + 0.5) / side * 2 - 1, 1 - (row + 0.5) / side * 2
                if math.hypot(x, y) < 0.985:
                    directions.append((picture.data["maps"][k]["theta_i"], math.degrees(math.asin(math.hypot(x, y))), math.degrees(math.atan2(y, x))))
                    pixels.append(maps[k][row, column])
        self.assertGreater(len(directions), 200)
        return directions, *self.read(numpy.array(pixels), scale, picture.data["scale"])

    def assert_map_shows(self, picture, k, expected, directions, shown, step):
        axis = picture.data["scale"]
        clamped = numpy.clip(expected, axis["low"], axis["high"])
        numpy.testing.assert_allclose(numpy.log(shown), numpy.log(clamped), atol=2 * step)

    def test_model(self):
        for material in (GARNET, VINYL):
            picture = self.picture(material, "--kind", "hemisphere", "--theta-i", "20,60")
            for k in range(2):
                with self.subTest(material=material.name, map=k):
                    directions, shown, step = self.sample(picture, k)
                    self.assert_map_shows(picture, k, self.evaluated(material, directions), directions, shown, step)

    def test_table_draws_its_own_nodes(self):
        table = self.table(GARNET, "--theta-i", "20,60")
        with h5py.File(table, "r+") as file:
            file["brdf"][1] *= 3
        picture = self.picture(table, "--kind", "hemisphere")
        for k, factor in enumerate((1, 3)):
            directions, shown, step = self.sample(picture, k)
            # The map is interpolated between nodes.
            expected = factor * self.evaluated(GARNET, directions)
            self.assertLess(numpy.median(numpy.abs(numpy.log(shown / expected))), step)

    def test_half_a_circle_is_mirrored_and_gaps_are_refused(self):
        whole = self.picture(self.table(GARNET, "--theta-i", "60", "--phi-s", "0:358:2"), "--kind", "hemisphere")
        half = self.picture(self.table(GARNET, "--theta-i", "60", "--phi-s", "0:180:2"), "--kind", "hemisphere")
        numpy.testing.assert_array_equal(whole.images()[0][0], half.images()[0][0])
        table = self.table(GARNET, "--phi-s", "0,180")
        self.assert_refused(run("plot", table, "--kind", "hemisphere", "-o", self.folder / "x.svg"), BAD_INPUT, table, "gaps above 90")

    def test_comparison_finds_the_changed_sample(self):
        table, changed = self.table(GARNET), self.table(GARNET, name="changed.h5")
        with h5py.File(changed, "r+") as file:
            file["brdf"][7, 0, 41, 33] *= 1.5
        same = self.picture(table, table, "--kind", "compare")
        self.assertTrue(any("no difference anywhere" in text for text in same.texts()))
        picture = self.picture(changed, table, "--kind", "compare")
        found = [text for text in picture.texts() if text.startswith("largest difference: ")]
        self.assertEqual(len(found), 1, picture.texts())
        for part in ("ratio 1.5 ", "35°", "41°", "66°"):
            self.assertIn(part, found[0])
        self.assertIn(35, [m["theta_i"] for m in picture.data["maps"]])

    def test_comparison_of_materials(self):
        picture = self.picture(GARNET, VINYL, "--kind", "compare", "--theta-i", "40")
        directions, shown, step = self.sample(picture, 0)
        expected = self.evaluated(GARNET, directions) / self.evaluated(VINYL, directions)
        self.assert_map_shows(picture, 0, expected, directions, shown, step)


class Files(Drawing):
    def test_png(self):
        path = self.plot(VINYL, "--width", "900", name="picture.png")
        with Image.open(path) as image:
            self.assertEqual(image.width, 900)
            self.assertGreater(len(image.convert("RGB").getcolors(1 << 20)), 50)
            self.assertEqual(image.convert("RGB").getpixel((2, 2)), (255, 255, 255))

    def test_name_in_the_metadata(self):
        material = self.folder / "quoted.toml"
        name = 'a "b" \\ <c> & é'
        material.write_text(VINYL.read_text().replace('name = "brown vinyl"', f"name = '{name}'"))
        for kind in KINDS:
            with self.subTest(kind):
                self.assertTrue(self.picture(material, "--kind", kind).data["title"].startswith(f"{name}: "))

    def test_needs_no_display_and_no_network(self):
        result = run("plot", VINYL, "-o", self.folder / "a.png", DISPLAY=None, WAYLAND_DISPLAY=None)
        self.assertEqual(result.returncode, DONE, result.stderr)
        for kind in KINDS:
            text = self.plot(VINYL, "--kind", kind).read_text()
            for scheme in ("http:", "https:", "file:"):
                self.assertNotIn(scheme, text.replace('xmlns="http://www.w3.org/2000/svg"', ""))

    def test_refused(self):
        out = self.folder / "a.svg"
        banded = self.folder / "bands.toml"
        banded.write_text(VINYL.read_text() + BANDS)
        table = self.table(VINYL, "--polarization", "s")
        data = self.folder / "data.csv"
        data.write_text("theta_i_deg,theta_s_deg,phi_deg,brdf_per_sr\n25,-30,0,0.05\n")
        for arguments, parts in (
                ([VINYL, "-o", self.folder / "a.pdf"], ["a.pdf", ".svg or .png"]),
                ([VINYL, "-o", out, "--kind", "pie"], ["--kind"]),
                ([VINYL, "-o", out, "--theta-i", "0:85:5"], ["--theta-i", "at most 9"]),
                ([VINYL, "-o", out, "--theta-i", "95"], ["--theta-i", "95"]),
                ([VINYL, "-o", out, "--kind", "compare"], ["takes two"]),
                ([VINYL, "-o", out, "--kind", "dhr", "--theta-i", "5"], ["--theta-i"]),
                ([VINYL, "-o", out, "--kind", "shadowing", "--polarization", "s"], ["--polarization"]),
                ([VINYL, "-o", out, "--kind", "lobes", "--data", data], ["--data"]),
                ([VINYL, "-o", out, "--wavelength", "450"], ["no bands"]),
                ([banded, "-o", out, "--wavelength", "500"], ["450, 650"]),
                ([table, "-o", out, "--polarization", "p"], ["--polarization p", table]),
                ([table, "-o", out, "--theta-i", "33"], ["--theta-i 33", "nearest is 35"]),
                ([VINYL, "-o", out, "--width", "900"], ["--width"]),
                ([VINYL, "-o", out, "--channel", "550"], ["--channel"]),
                ([VINYL, "-o", out, "--scale", "2"], ["--scale"])):
            with self.subTest(arguments):
                self.assert_refused(run("plot", *arguments), BAD_INPUT, *parts)
        self.assert_refused(run("plot", self.folder / "none.h5", "-o", out), FILE, "none.h5")
        self.assertFalse(out.exists())

    def test_existing_output_is_kept(self):
        out = self.folder / "a.svg"
        out.write_text("mine")
        self.assert_refused(run("plot", VINYL, "-o", out), FILE, out)
        self.assertEqual(out.read_text(), "mine")
        self.assertEqual(run("plot", VINYL, "-o", out, "--force").returncode, DONE)
        self.assertIn("<svg", out.read_text())

    def test_bands(self):
        banded = self.folder / "bands.toml"
        banded.write_text(VINYL.read_text() + BANDS)
        first = self.picture(banded, "--theta-i", "70", "--wavelength", "650")
        self.assertTrue(any("650 nm" in text for text in first.texts()))
        series = first.curves()[0][1]
        result = run("evaluate", banded, stdin="theta_i_deg,theta_s_deg,phi_deg\n70,70,0\n")
        expected = float(list(csv.DictReader(io.StringIO(result.stdout)))[1]["brdf"])
        self.assertAlmostEqual(dict(zip(series["x"], series["y"]))[70] / expected, 1, delta=1e-8)


@unittest.skipUnless(browser.PROGRAM, "needs Chromium")
class Layout(Drawing):
    def test_texts_keep_clear(self):
        with browser.Browser() as page:
            cases = [(material, kind, []) for material in sorted(MATERIALS.glob("*.toml")) for kind in KINDS]
            cases += [(GARNET, kind, ["--theta-i", ",".join(map(str, range(5, 5 + 9 * n, 9)))])
                      for n in range(1, 10) for kind in KINDS if kind != "dhr"]
            for material, kind, options in cases:
                with self.subTest(material=material.name, kind=kind, options=options):
                    page.open(self.plot(material, "--kind", kind, *options))
                    self.assertEqual(page.evaluate(TEXTS_IN_THE_WAY), [])
            for arguments in ([GARNET, VINYL, "--kind", "compare"], [GARNET, VINYL], [GARNET, VINYL, YELLOW, "--kind", "dhr"],
                              [GARNET, VINYL, YELLOW, "--kind", "hemisphere"]):
                with self.subTest(arguments):
                    page.open(self.plot(*arguments))
                    self.assertEqual(page.evaluate(TEXTS_IN_THE_WAY), [])

    def test_dark_page(self):
        path = self.plot(VINYL)
        for dark, background in ((False, "rgb(255, 255, 255)"), (True, "rgb(20, 23, 28)")):
            with browser.Browser(dark=dark) as page:
                page.open(path)
                self.assertEqual(page.evaluate("getComputedStyle(document.querySelector('rect')).fill"), background)
                self.assertEqual(page.complaints(), [])


if __name__ == "__main__":
    unittest.main()
