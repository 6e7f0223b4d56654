"""`report`: the page in a browser; its numbers, its map, and what it carries."""

import base64
import json
import re
import unittest

import h5py
import numpy

import browser
from program import BAD_INPUT, DONE, FILE, MATERIALS, SMALL_GRID, VINYL, InFolder, run

GARNET = MATERIALS / "garnet-red-paint.toml"
BANDS = "[[band]]\nwavelength_nm = 450\n[[band]]\nwavelength_nm = 650\nn_eff = 1.5\n"
NUMBERS = "[...document.querySelectorAll('data')].map((e) => [e.dataset.path, e.value, e.textContent])"


class Pages(InFolder):
    def report(self, subject, *options, name="page.html"):
        path = self.folder / name
        result = run("report", subject, "-o", path, "--force", *options)
        self.assertEqual(result.returncode, DONE, result.stderr)
        return path

    def table(self, material, *options, name="table.h5"):
        path = self.folder / name
        result = run("generate", material, "-o", path, "--force", *options)
        self.assertEqual(result.returncode, DONE, result.stderr)
        return path

    def embedded(self, page):
        text = page.read_text()
        axes = json.loads(re.search(r'id="axes">(.*?)</script>', text, re.S)[1])
        samples = base64.b64decode(re.search(r'id="samples">(.*?)</script>', text, re.S)[1])
        shape = (len(axes["sets"]), len(axes["theta_i"]), len(axes["theta_s"]), len(axes["phi"]))
        return axes, numpy.frombuffer(samples, "<f4").reshape(shape)


class Content(Pages):
    def test_needs_no_network(self):
        text = self.report(VINYL).read_text()
        for attribute in re.findall(r'(?:src|href)="([^"]{0,40})', text):
            self.assertTrue(attribute.startswith("data:"), attribute)
        self.assertNotIn("@import", text)
        self.assertNotIn("url(", text)
        self.assertNotIn("://", text.split("<script>", 1)[1])

    def test_carries_the_samples_of_the_table(self):
        table = self.table(GARNET, "--theta-i", "0:80:20", "--phi-i", "10,20", "--phi-s", "0:360:10", "--polarization", "all")
        axes, samples = self.embedded(self.report(table))
        with h5py.File(table) as file:
            for k, name in enumerate(("brdf", "brdf_s", "brdf_p")):
                numpy.testing.assert_array_equal(samples[k], file[name][:, 0])
            numpy.testing.assert_array_equal(axes["phi"], file["phi_s"][:] - 10)
            numpy.testing.assert_array_equal(axes["theta_i"], file["theta_i"][:])

    def test_thins_a_large_table_and_says_so(self):
        table = self.table(VINYL, "--theta-i", "0:80:2", "--phi-s", "0:360:0.5")
        page = self.report(table)
        axes, samples = self.embedded(page)
        self.assertLessEqual(samples.size, 1 << 20)
        self.assertGreater(samples.size, 1 << 19)
        self.assertEqual((axes["phi"][0], axes["phi"][-1], axes["theta_i"][-1]), (0, 360, 80))
        self.assertIn(f"these are {len(axes['theta_i'])} of its 41", page.read_text())
        with h5py.File(table) as file:
            rows = numpy.searchsorted(file["theta_i"][:], axes["theta_i"])
            columns = numpy.searchsorted(file["phi_s"][:], axes["phi"])
            lines = numpy.searchsorted(file["theta_s"][:], axes["theta_s"])
            numpy.testing.assert_array_equal(samples[0], file["brdf"][:, 0][numpy.ix_(rows, lines, columns)])

    def test_material_with_a_large_grid(self):
        material = self.folder / "fine.toml"
        material.write_text(VINYL.read_text() + '\n[grid]\ntheta_i = "0:80:2"\nphi_s = "0:360:0.25"\n')
        page = self.report(material)
        _, samples = self.embedded(page)
        self.assertLessEqual(samples.size, 1 << 20)
        self.assertIn(f"at {samples.size} of the {41 * 90 * 1441} directions", page.read_text())

    def test_exr_and_gaps(self):
        self.assertIn('id="samples"', self.report(self.table(VINYL, *SMALL_GRID, name="table.exr")).read_text())
        text = self.report(self.table(VINYL, "--phi-s", "0,180")).read_text()
        self.assertNotIn('id="samples"', text)
        self.assertIn("no hemisphere to map", text)

    def test_text_of_a_material_is_no_markup(self):
        material = self.folder / "evil.toml"
        material.write_text(VINYL.read_text().replace('name = "brown vinyl"', 'name = "a<script>alert(1)</script>_b & \\"c\\""'))
        text = self.report(material).read_text()
        self.assertNotIn("<script>alert", text)
        self.assertIn("a&lt;script&gt;alert(1)&lt;/script&gt;_b &amp; &quot;c&quot;", text)

    def test_refused(self):
        out = self.folder / "page.html"
        self.assert_refused(run("report", VINYL, "-o", self.folder / "page.pdf"), BAD_INPUT, "page.pdf", ".html")
        self.assert_refused(run("report", self.folder / "none.h5", "-o", out), FILE, "none.h5")
        out.write_text("mine")
        self.assert_refused(run("report", VINYL, "-o", out), FILE, out)
        self.assertEqual(out.read_text(), "mine")
        self.assertEqual([path.name for path in self.folder.iterdir()], ["page.html"])


@unittest.skipUnless(browser.PROGRAM, "needs Chromium")
class InTheBrowser(Pages):
    def number(self, info, path):
        """What `info --json` prints at a path of the page."""
        at = info
        for step in path.split("/"):
            at = at[int(step)] if isinstance(at, list) else at[step]
        return at

    def test_numbers_are_those_of_info(self):
        banded = self.folder / "bands.toml"
        banded.write_text(VINYL.read_text() + BANDS)
        for material in (GARNET, banded):
            with self.subTest(material.name), browser.Browser() as page:
                table = self.table(material)
                info = json.loads(run("info", table, "--json").stdout)
                page.open(self.report(table))
                numbers = page.evaluate(NUMBERS)
                for path, value, shown in numbers:
                    self.assertEqual(float(value), self.number(info, path), path)
                    self.assertAlmostEqual(float(shown), float(value), delta=1e-3 * abs(float(value)))
                paths = {path for path, _, _ in numbers}
                for name in ("accuracy_max_relative_error", "accuracy_nodes", "dhr_relative_error"):
                    self.assertIn(f"attributes/{name}", paths)
                self.assertIn("attributes/reciprocity_max" + ("/1" if material is banded else ""), paths)
                self.assertEqual(sum(path.startswith("variables/dhr/") for path in paths), 18 * (2 if material is banded else 1))
                text = page.evaluate("document.body.innerText")
                for part in ("brdftab generate", str(table), info["attributes"]["energy"].rstrip(".")):
                    self.assertIn(part, text)
                self.assertEqual(page.complaints(), [])

    def test_slider_and_light_change_the_map(self):
        table = self.table(GARNET, "--polarization", "all")
        with browser.Browser() as page:
            page.open(self.report(table))
            self.assertEqual(page.evaluate("[slider.min, slider.max].join()"), "0,17")
            seen = set()
            for node in (0, 9, 17):
                page.evaluate(f"slider.value = {node}; slider.dispatchEvent(new Event('input'))")
                self.assertEqual(page.evaluate("theta_i.value"), f"{5 * node}°")
                seen.add(page.evaluate("map.toDataURL() + cut.toDataURL()"))
            page.evaluate("sets.value = 2; sets.dispatchEvent(new Event('change'))")
            seen.add(page.evaluate("map.toDataURL() + cut.toDataURL()"))
            self.assertEqual(len(seen), 4)
            self.assertEqual(page.complaints(), [])

    def test_reading_under_the_pointer(self):
        table = self.table(GARNET)
        with browser.Browser() as page:
            page.open(self.report(table))
            page.evaluate("slider.value = 12; slider.dispatchEvent(new Event('input'))")
            # The middle of the map is the normal, a node, and shows its f.
            page.evaluate("""(() => { const b = map.getBoundingClientRect(), unit = b.width / 568;
                map.dispatchEvent(new PointerEvent('pointermove', {clientX: b.left + 262 * unit, clientY: b.top + 224 * unit})); })()""")
            reading = page.evaluate("reading.textContent")
        with h5py.File(table) as file:
            f = file["brdf"][12, 0, 0, 0]
        self.assertRegex(reading, r"θₛ = 0\.[0-2]°")
        self.assertAlmostEqual(float(re.search(r"f = (\S+)", reading)[1]) / f, 1, delta=0.02)

    def test_map_shows_the_samples(self):
        table = self.table(GARNET)
        with h5py.File(table, "r+") as file:
            file["brdf"][9] = 5.0
        with browser.Browser() as page:
            page.open(self.report(table))
            # This looks between the circles at 30 and 60 degrees.
            colours = """new Set(Array.from({length: 1600}, (_, k) =>
                [...map.getContext('2d').getImageData(2 * 232 + k % 40, 2 * 66 + Math.floor(k / 40), 1, 1).data].join())).size"""
            self.assertEqual(page.evaluate("theta_i.value"), "45°")
            self.assertEqual(page.evaluate(colours), 1)
            page.evaluate("slider.value = 10; slider.dispatchEvent(new Event('input'))")
            self.assertGreater(page.evaluate(colours), 1)

    def test_every_shipped_material_and_the_dark_page(self):
        for material in sorted(MATERIALS.glob("*.toml")):
            for dark in (False, True):
                with self.subTest(material=material.name, dark=dark), browser.Browser(dark=dark) as page:
                    page.open(self.report(material))
                    self.assertEqual(page.complaints(), [])
                    self.assertTrue(page.evaluate("[...document.images].every((image) => image.complete && image.naturalWidth > 100)"))
                    self.assertEqual(page.evaluate("document.images.length"), 7)
                    # Nothing is wider than the page.
                    self.assertLessEqual(page.evaluate("document.documentElement.scrollWidth"), 1100)


if __name__ == "__main__":
    unittest.main()
