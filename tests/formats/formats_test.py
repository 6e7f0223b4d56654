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

TABLES = {"default": [], "dense": ["--phi-i", "0,90"]}


def blocks(language):
    text = (ROOT / "host" / "FORMATS.md").read_text()
    return re.findall(rf"^```{language}\n(.*?)^```", text, re.MULTILINE | re.DOTALL)


class Readers(unittest.TestCase):
    """On the default table, and on one with several phi_i."""

    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        for table, options in TABLES.items():
            (cls.folder / table).mkdir()
            for name in ("table.h5", "table.exr"):
                result = run("generate", VINYL, "-o", cls.folder / table / name, *options)
                assert result.returncode == DONE, result.stderr

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def each_table(self):
        for table in TABLES:
            with self.subTest(table):
                with h5py.File(self.folder / table / "table.h5") as file:
                    axes = [file[name][:] for name in ("theta_i", "phi_i", "theta_s", "phi_s")]
                    self.assertEqual([axis[k] for axis, k in zip(axes, (6, 0, 40, 45))], [30, 0, 40, 90])
                    yield self.folder / table, file["brdf"][...].astype(float)

    def run_script(self, command, text, folder):
        script = folder / "reader"
        script.write_text(text)
        return subprocess.run([*command, script], capture_output=True, text=True, cwd=folder, timeout=120)

    def printed(self, command, text, folder):
        result = self.run_script(command, text, folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        return [float(number) for number in result.stdout.split()]

    def python(self, which):
        return next(block for block in blocks("python") if which in block)

    def test_h5py(self):
        reader = self.python("h5py")
        for folder, brdf in self.each_table():
            self.assertEqual(self.printed([sys.executable], reader, folder), [brdf[6, 0, 40, 45]])
            result = self.run_script([sys.executable], reader.replace("(30, 0, 40, 90)", "(30, 0, 40.5, 90)"), folder)
            self.assertIn("ValueError", result.stderr)

    def test_xarray(self):
        reader = "".join(block for block in blocks("python") if "xarray" in block)
        for folder, brdf in self.each_table():
            (f,) = self.printed([sys.executable], reader, folder)
            self.assertAlmostEqual(f / brdf[6:8, 0, 40:42, 45:47].mean(), 1, 12)

    def test_openimageio(self):
        for folder, brdf in self.each_table():
            self.assertEqual(self.printed([sys.executable], self.python("OpenImageIO"), folder), [brdf[6, 0, 40, 45]])

    @unittest.skipUnless(shutil.which("octave"), "octave is not installed")
    def test_octave(self):
        (reader,) = blocks("matlab")
        octave = ["octave", "--no-gui", "--norc"]
        for folder, brdf in self.each_table():
            node, between = self.printed(octave, reader, folder)
            self.assertEqual(numpy.float32(node), brdf[6, 0, 40, 45])
            self.assertAlmostEqual(between / brdf[6:8, 0, 40:42, 45:47].mean(), 1, 7)
            for angle, change, said in (("no node", "at(t.theta_s, 40.5)", "an angle is no node"),
                                        ("beyond", "slice, 32.5, 89.5", "an angle lies beyond the nodes")):
                old = "at(t.theta_s, 40)" if angle == "no node" else "slice, 32.5, 40.5"
                self.assertIn(old, reader)
                result = self.run_script(octave, reader.replace(old, change), folder)
                self.assertNotEqual(result.returncode, 0)
                self.assertIn(said, result.stderr)

    def test_every_attribute_is_described(self):
        text = (ROOT / "host" / "FORMATS.md").read_text()
        with h5py.File(self.folder / "default" / "table.h5") as file:
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
