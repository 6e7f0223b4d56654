"""The figures in the texts are those that bench/figures saved, and those are what the program gives."""

import csv
import io
import itertools
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tomllib
import unittest

from picture import Picture
from program import DONE, MATERIALS, PROGRAM, ROOT, InFolder, run

sys.path.insert(0, str(ROOT / "bench"))
from sections import simulators, storage  # noqa: E402
from sections.section import Program, Results  # noqa: E402
from sections.text import SPAN, TABLE  # noqa: E402

BUILD = pathlib.Path(shutil.which(PROGRAM)).resolve().parent
TEXTS = ["README.md", "kernels/README.md", "host/FORMATS.md"]
BY_HAND = ["off by 3.1 %", "after 2.5 s", "in 40 ms", "64 MB", "10.8 GB/s", "2.5e-7", "1.2e7 directions", "45 times as long",
           "12 of 20", "14 000 times", "2 ulp beyond", "a ratio of 1.92", "DHR 1.23"]
SETTINGS = ["`--interpolation-error 3%`", "18 × 36 nodes", "at 30.5° and 45°", "PoCL 3.1", "Eq. (12)", "```\nsleep 3 s\n```",
            "[a link](page-3%20s)"]
# Another compiler, C library or release of libdeflate may move a figure a little: less than the two digits that texts show.
TOLERANCE = 0.01


class Texts(InFolder):
    """`bench/figures --check` on this checkout's texts, and on copies with one thing changed."""

    def setUp(self):
        super().setUp()
        for name in [*TEXTS, "bench/definitional.tsv"]:
            (self.folder / name).parent.mkdir(exist_ok=True)
            shutil.copy(ROOT / name, self.folder / name)
        shutil.copytree(ROOT / "bench/results", self.folder / "bench/results")

    def figures(self, *options):
        command = [sys.executable, ROOT / "bench/figures", "--root", self.folder, *options]
        return subprocess.run(command, capture_output=True, text=True)

    def change(self, name, old, new):
        text = (self.folder / name).read_text()
        self.assertIn(old, text)
        (self.folder / name).write_text(text.replace(old, new, 1))

    def test_texts_are_what_was_measured(self):
        found = self.figures("--check")
        self.assertEqual((found.returncode, found.stdout, found.stderr), (0, "", ""))

    def test_each_changed_piece_is_found(self):
        for name in TEXTS:
            text = (ROOT / name).read_text()
            for piece in [*TABLE.finditer(text), *SPAN.finditer(text)]:
                with self.subTest(f"{name}: {piece[2]}"):
                    digit = text.index(re.search(r"\d(?=\D*$)", piece[3])[0], piece.start(3))
                    other = str((int(text[digit]) + 1) % 10)
                    (self.folder / name).write_text(text[:digit] + other + text[digit + 1:])
                    found = self.figures("--check")
                    self.assertEqual(found.returncode, 1)
                    line = text.count("\n", 0, digit) + 1
                    self.assertIn(f"{name}:{line}: {piece[2]} is not what the saved results give", found.stdout)
            (self.folder / name).write_text(text)

    def test_figures_by_hand_are_found(self):
        for name, figure in zip(itertools.cycle(TEXTS), BY_HAND):
            with self.subTest(figure):
                text = (ROOT / name).read_text()
                (self.folder / name).write_text(text + f"\nThat was {figure} here.\n")
                found = self.figures("--check")
                self.assertEqual(found.returncode, 1)
                self.assertRegex(found.stdout, rf"^{re.escape(name)}:{text.count(chr(10)) + 2}: '.*' is typed by hand")
                (self.folder / name).write_text(text)

    def test_settings_are_no_figures(self):
        (self.folder / "README.md").write_text((ROOT / "README.md").read_text() + "\n" + "\n".join(SETTINGS) + "\n")
        self.assertEqual(self.figures("--check").stdout, "")

    def test_what_went_stale_is_found(self):
        with (self.folder / "bench/definitional.tsv").open("a") as phrases:
            phrases.write("a phrase of 7 %\tno text has it\n")
        self.change("kernels/README.md", "<!--/-->", "")
        found = self.figures("--check")
        self.assertEqual(found.returncode, 1)
        self.assertIn("'a phrase of 7 %': no text has it", found.stdout)
        self.assertRegex(found.stdout, r"kernels/README.md:\d+: <!--f:float32-table-error--> is not")
        self.assertIn("the block float32-table-error: no text has it", found.stdout)

    def test_a_changed_result_is_written(self):
        path = self.folder / "bench/results/table-accuracy.json"
        saved = json.loads(path.read_text())
        saved["figures"]["float32"] = 4.4e-7
        path.write_text(json.dumps(saved))
        self.assertEqual(self.figures("--check").returncode, 1)
        written = self.figures("--write")
        self.assertEqual((written.returncode, written.stdout), (0, "written: README.md\nwritten: kernels/README.md\n"))
        for name in ("README.md", "kernels/README.md"):
            self.assertIn("4.4e-7", (self.folder / name).read_text())
        self.assertEqual(self.figures("--check").returncode, 0)


class Measured(InFolder):
    """The cheapest of the figures, measured anew."""

    def setUp(self):
        super().setUp()
        self.saved = Results(ROOT)
        self.program = Program(ROOT, BUILD, self.folder)

    def assert_same(self, measured, saved):
        self.assertAlmostEqual(measured / saved, 1, delta=TOLERANCE)

    def test_simulators(self):
        cases = [("rgl", "brown-vinyl"), ("rgl", "yellow-retro-sheeting"), ("zemax", "white-ptfe"), ("ssdd", "garnet-red-paint"),
                 ("merl", "brown-vinyl")]
        for name, material in cases:
            with self.subTest(name, material=material):
                measured, saved = simulators.measured(self.program, material, name), self.saved["simulators"][name][material]
                for kind in ("uniform", "near_peaks"):
                    for key in ("median", "95_percent"):
                        self.assert_same(measured[kind][key], saved[kind][key])
                self.assert_same(measured["bytes"], saved["bytes"])
                self.assert_same(measured["reciprocity_median"], saved["reciprocity_median"])

    def test_sizes_of_tables(self):
        for options in storage.OPTIONS[-2:]:
            with self.subTest(options):
                self.assert_same(storage.size_of_table(self.program, options), self.saved["table-sizes"][options])

    def test_cell_centres(self):
        measured = storage.error_at_cell_centres(self.program, "yellow-retro-sheeting")
        for key in ("median", "95_percent", "max"):
            self.assert_same(measured[key], self.saved["cell-centres"]["yellow-retro-sheeting"][key])

    def test_fits_are_the_shipped_materials(self):
        """Measured data are not here, but the material files say what their fits reached."""
        shipped = {"brown vinyl in plane": "brown-vinyl", "garnet red paint 550 nm, hemisphere": "garnet-red-paint",
                   "yellow retro-reflective sheeting in plane": "yellow-retro-sheeting", "PTFE 532 nm in plane": "white-ptfe"}
        for fit, material in shipped.items():
            with self.subTest(material):
                record = tomllib.loads((MATERIALS / f"{material}.toml").read_text())["fit"]
                self.assert_same(record["rms"], self.saved["fits"][fit]["rms_of_samples"])
                self.assert_same(record["rms_by_incidence"], self.saved["fits"][fit]["rms_of_incidences"])

    def test_dhr_of_ptfe(self):
        found = run("integrate", MATERIALS / "white-ptfe.toml", "--theta-i", "0:75:15")
        self.assertEqual(found.returncode, DONE, found.stderr)
        rows = csv.DictReader(line for line in io.StringIO(found.stdout) if not line.startswith("#"))
        for row, saved in zip(rows, self.saved["fits"]["PTFE 532 nm in plane"]["dhr"], strict=True):
            self.assert_same(float(row["dhr"]), saved)


class Pictures(InFolder):
    """The pictures are what the commands beneath them draw: the same numbers and pixels on every device."""

    def parts(self, picture):
        """The SVG without its images, and their pixels, since another libdeflate packs them otherwise."""
        maps, scale = Picture(picture, data=False).images()
        pixels = [image.tolist() for image in (*maps, scale) if image is not None]
        return re.sub(r'"data:image[^"]*', "", picture.read_text()), pixels

    def test_commands_draw_the_saved_pictures(self):
        beneath = r"^\*`(\S+) (.*?) (?:-o )?(bench/results/\S+\.svg)(?: --force)?`\*$"
        commands = re.findall(beneath, (ROOT / "README.md").read_text(), re.MULTILINE)
        self.assertEqual(len(commands), 3)
        for program, arguments, picture in commands:
            with self.subTest(picture):
                drawn = self.folder / "drawn.svg"
                interpreter = [BUILD / "brdftab"] if program.endswith("brdftab") else [sys.executable]
                output = ["-o", drawn] if program.endswith("brdftab") else [drawn]
                subprocess.run([*interpreter, *arguments.split(), *output], cwd=ROOT, check=True, capture_output=True)
                self.assertEqual(self.parts(drawn), self.parts(ROOT / picture))
                drawn.unlink()


if __name__ == "__main__":
    unittest.main()
