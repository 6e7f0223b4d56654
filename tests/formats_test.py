"""The readers that host/FORMATS.md gives, run as they stand there."""

import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import pathlib

import h5py
import numpy

from program import DONE, ROOT, VINYL, run

GRID = ["--phi-i", "0,90"]


def blocks(language):
    text = (ROOT / "host" / "FORMATS.md").read_text()
    return re.findall(rf"^```{language}\n(.*?)^```", text, re.MULTILINE | re.DOTALL)


class Readers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        for name in ("table.h5", "table.exr"):
            result = run("generate", VINYL, "-o", cls.folder / name, *GRID)
            assert result.returncode == DONE, result.stderr
        with h5py.File(cls.folder / "table.h5") as file:
            cls.axes = [file[name][:] for name in ("theta_i", "phi_i", "theta_s", "phi_s")]
            cls.brdf = file["brdf"][...]

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def printed(self, command, text):
        script = self.folder / "reader"
        script.write_text(text)
        result = subprocess.run([*command, script], capture_output=True, text=True, cwd=self.folder, timeout=120)
        self.assertEqual(result.returncode, 0, result.stderr)
        return float(result.stdout.split()[-1])

    def python(self, which):
        return self.printed([sys.executable], next(b for b in blocks("python") if which in b))

    def sample(self):
        return float(self.brdf[6, 0, 40, 45])

    def test_the_expected_node(self):
        self.assertEqual([a[k] for a, k in zip(self.axes, (6, 0, 40, 45))], [30, 0, 40, 90])

    def test_h5py(self):
        self.assertEqual(self.python("h5py"), self.sample())

    def test_xarray(self):
        corners = self.brdf[6:8, 0, 40:42, 45:47].astype(float)
        self.assertAlmostEqual(self.python("xarray") / corners.mean(), 1, 6)

    def test_openimageio(self):
        self.assertEqual(self.python("OpenImageIO"), self.sample())

    @unittest.skipUnless(shutil.which("octave"), "octave is not installed")
    def test_octave(self):
        (reader,) = blocks("matlab")
        self.assertEqual(numpy.float32(self.printed(["octave", "--no-gui", "--norc"], reader)), numpy.float32(self.sample()))

    def test_readers_are_about_ten_lines(self):
        for reader in blocks("python") + blocks("matlab"):
            self.assertLessEqual(len(reader.strip().splitlines()), 11)

    def test_every_attribute_is_described(self):
        text = (ROOT / "host" / "FORMATS.md").read_text()
        with h5py.File(self.folder / "table.h5") as file:
            for name in file:
                self.assertRegex(text, rf"`(brdf|{name}|{name[name.rfind('_'):]})`", name)
            parameters = {"n_eff", "k_eff", "w", "n", "w_a", "w_b", "gamma", "delta"}
            for name in file.attrs:
                if name in parameters or name.startswith(("sigma_", "rho_")):
                    continue
                short = name if f"`{name}`" in text else name[len("reciprocity"):]
                self.assertIn(f"`{short}`", text)


if __name__ == "__main__":
    unittest.main()
