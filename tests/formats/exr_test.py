"""OpenEXR tables opened by tools that others wrote, and compared bit for bit with the same table in HDF5."""

import shutil
import subprocess
import unittest

import h5py
import numpy
import OpenImageIO as oiio

from program import BAD_INPUT, DONE, FILE, MATERIALS, VINYL, InFolder, run

GRID = ["--theta-i", "0:80:20", "--phi-i=-90:90:90", "--theta-s", "0.5:88.5:8", "--phi-s", "0:360:30"]
BANDS = """
[[band]]
wavelength_nm = 450.25
[[band]]
wavelength_nm = 1064
n_eff = 1.5
"""


def image(path, part=0):
    """The pixels [y][x][channel], the channel names and the attributes of a part."""
    file = oiio.ImageInput.open(str(path))
    assert file, oiio.geterror()
    try:
        assert file.seek_subimage(part, 0), "no such part"
        spec = file.spec()
        names = list(spec.channelnames)
        attributes = {a.name: a.value for a in spec.extra_attribs}
        return numpy.asarray(file.read_image(part, 0, 0, len(names), "float")), names, attributes
    finally:
        file.close()


def exrinfo(file):
    """What exrinfo prints. Its exit status says nothing: OpenEXR 3.1.5's returns a number that it has not set."""
    result = subprocess.run(["exrinfo", file], capture_output=True, text=True)
    assert result.stderr == "", result.stderr
    return result.stdout


class SameBits(InFolder):
    """Every layout and compression against HDF5."""

    def make(self, material, *options):
        table = self.folder / "table.h5"
        exr = self.folder / ("slices" if "files" in options else "table.exr")
        extra = ["--polarization", "all"]
        for target, more in ((table, []), (exr, options)):
            result = run("generate", material, "-o", target, *GRID, *extra, *more)
            self.assertEqual(result.returncode, DONE, result.stderr)
        with h5py.File(table) as file:
            axes = {name: file[name][:] for name in ("theta_i", "phi_i", "theta_s", "phi_s")}
            samples = {name: file[name][...] for name in ("brdf", "brdf_s", "brdf_p")}
        return exr, axes, samples

    def assert_slice(self, pixels, names, samples, i, p):
        for layer, brdf in (("", "brdf"), ("s.", "brdf_s"), ("p.", "brdf_p")):
            expected = samples[brdf]
            if expected.ndim == 4:
                channels = {layer + "Y": expected[i, p]}
            else:
                channels = {layer + "T.450,250000nm": expected[0, i, p], layer + "T.1064,000000nm": expected[1, i, p]}
            for channel, values in channels.items():
                self.assertEqual(pixels[..., names.index(channel)].tobytes(), values.tobytes(), (channel, i, p))

    def materials(self):
        spectral = self.folder / "spectral.toml"
        spectral.write_text(VINYL.read_text() + BANDS)
        return VINYL, spectral

    def check(self, layout, compression, read):
        for material in self.materials():
            with self.subTest(material=material.name):
                exr, axes, samples = self.make(material, "--exr-layout", layout, "--exr-compression", compression)
                for i, theta_i in enumerate(axes["theta_i"]):
                    for p, phi_i in enumerate(axes["phi_i"]):
                        pixels, names, attributes = read(exr, axes, i, p)
                        self.assertEqual(len(names), 3 if material == VINYL else 6)
                        self.assert_slice(pixels, names, samples, i, p)
                        if layout != "tiles":
                            self.assertEqual(attributes["brdf:slice_theta_i"], theta_i)
                            self.assertEqual(attributes["brdf:slice_phi_i"], phi_i)
                        self.assertEqual([float(a) for a in attributes["brdf:theta_s"].split(",")], list(axes["theta_s"]))
                        self.assertEqual([float(a) for a in attributes["brdf:phi_s"].split(",")], list(axes["phi_s"]))
                        self.assertEqual(attributes["brdf:units"], "sr-1")
                        self.assertEqual(attributes["compression"], compression)
                        if material != VINYL:
                            self.assertEqual(attributes["spectralLayoutVersion"], "1.0")
                            self.assertEqual(attributes["brdf:wavelength"], "450.25,1064")
                shutil.rmtree(exr) if exr.is_dir() else exr.unlink()
                (self.folder / "table.h5").unlink()

    def test_parts(self):
        def read(exr, axes, i, p):
            return image(exr, i * len(axes["phi_i"]) + p)

        for compression in ("none", "zip"):
            self.check("parts", compression, read)

    def test_tiles(self):
        def read(exr, axes, i, p):
            pixels, names, attributes = image(exr)
            rows, columns = len(axes["theta_s"]), len(axes["phi_s"])
            return pixels[i * rows:(i + 1) * rows, p * columns:(p + 1) * columns], names, attributes

        for compression in ("none", "zip"):
            self.check("tiles", compression, read)

    def test_files(self):
        def read(exr, axes, i, p):
            sign = "m" if axes["phi_i"][p] < 0 else ""
            return image(exr / f"ti{axes['theta_i'][i]:02.0f}_pi{sign}{abs(axes['phi_i'][p]):03.0f}.exr")

        for compression in ("none", "zip"):
            self.check("files", compression, read)

    def test_many_rows_come_in_several_slabs(self):
        grid = ["--theta-i", "10", "--theta-s", "0:89:0.5", "--phi-s", "0:360:0.0075"]  # 34 MB a slice
        for name in ("table.h5", "table.exr"):
            self.assertEqual(run("generate", VINYL, "-o", self.folder / name, *grid).returncode, DONE)
        pixels, _, _ = image(self.folder / "table.exr")
        with h5py.File(self.folder / "table.h5") as file:
            self.assertEqual(pixels[..., 0].tobytes(), file["brdf"][0, 0].tobytes())


class Header(InFolder):
    def setUp(self):
        super().setUp()
        self.table = self.folder / "table.exr"
        self.assertEqual(run("generate", VINYL, "-o", self.table, *GRID).returncode, DONE)

    def test_part_zero_says_what_hdf5_says(self):
        hdf5 = self.folder / "table.h5"
        self.assertEqual(run("generate", VINYL, "-o", hdf5, *GRID).returncode, DONE)
        _, _, attributes = image(self.table)
        with h5py.File(hdf5) as file:
            for name, value in file.attrs.items():
                if name in ("Conventions", "history"):
                    continue
                with self.subTest(name):
                    self.assertEqual(attributes["brdf:" + name], value)
            for name in ("theta_i", "phi_i", "theta_s", "phi_s", "normalization_surface", "dhr", "dhr_bulk"):
                self.assertEqual([float(v) for v in str(attributes["brdf:" + name]).split(",")], list(file[name]))
        self.assertEqual(attributes["brdf:material"], VINYL.read_text())

    def test_exrheader_and_exrinfo_list_the_parts(self):
        text = subprocess.run(["exrheader", self.table], capture_output=True, text=True, check=True).stdout
        self.assertIn('brdf:slice_theta_i (type double): 80', text)
        self.assertIn("brdf:azimuth_convention", text)
        names = [f"ti{t:02}_pi{p}" for t in range(0, 81, 20) for p in ("m090", "000", "090")]
        info = exrinfo(self.table)
        for name in names:
            self.assertIn(f'"{name}"', text)
            self.assertIn(name, info)
        self.assertEqual(info.count("compression: 'none'"), 15)

    def test_oiiotool_finds_no_nan(self):
        text = subprocess.run(["oiiotool", "--stats", "-a", self.table], capture_output=True, text=True, check=True).stdout
        self.assertEqual(text.count("NanCount: 0"), 15, text)
        self.assertEqual(text.count("InfCount: 0"), 15)

    def test_decimals_tell_slices_apart(self):
        table = self.folder / "fine.exr"
        self.assertEqual(run("generate", VINYL, "-o", table, *GRID[2:], "--theta-i", "5,5.25,30").returncode, DONE)
        text = exrinfo(table)
        for name in ("ti05p00_pi000", "ti05p25_pi000", "ti30p00_pim090"):
            self.assertIn(name, text)


class Refusals(InFolder):
    def test_too_many_parts(self):
        result = run("generate", VINYL, "-o", self.folder / "t.exr", "--theta-i", "0:85:5", "--phi-i", "0:355:5")
        self.assert_refused(result, BAD_INPUT, "1296", "1024", "--exr-layout tiles", "--exr-layout files")
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_most_parts(self):
        result = run("generate", VINYL, "-o", self.folder / "t.exr", "--theta-i", "0:62:2", "--phi-i", "0:31:1", "--theta-s",
                     "0,45", "--phi-s", "0,90")
        self.assertEqual(result.returncode, DONE, result.stderr)

    def test_float64(self):
        result = run("generate", VINYL, "-o", self.folder / "t.exr", "--precision", "float64")
        self.assert_refused(result, BAD_INPUT, "float32", "HDF5")
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_options_of_another_format(self):
        result = run("generate", VINYL, "-o", self.folder / "t.h5", "--exr-layout", "files")
        self.assert_refused(result, BAD_INPUT, "--exr-layout", "hdf5")
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_bands_too_near_for_channel_names(self):
        material = self.folder / "near.toml"
        material.write_text(VINYL.read_text() + "[[band]]\nwavelength_nm = 500\n[[band]]\nwavelength_nm = 500.0000001\n")
        self.assert_refused(run("generate", material, "-o", self.folder / "t.exr", *GRID), BAD_INPUT, "1e-6 nm")
        self.assertEqual([f.name for f in self.folder.iterdir()], ["near.toml"])

    def test_a_folder_is_never_overwritten(self):
        keep = self.folder / "slices" / "keep"
        keep.parent.mkdir()
        keep.write_text("mine")
        result = run("generate", VINYL, MATERIALS / "white-ptfe.toml", "-o", self.folder, "--exr-layout", "files", *GRID)
        self.assertEqual(result.returncode, DONE, result.stderr)
        self.assertEqual(len(list((self.folder / "brown-vinyl").glob("*.exr"))), 15)
        again = run("generate", VINYL, "-o", self.folder, "--exr-layout", "files", "--force", *GRID)
        self.assert_refused(again, FILE, "is a folder")
        self.assertEqual(keep.read_text(), "mine")
        self.assertEqual(sorted(f.name for f in self.folder.iterdir()), ["brown-vinyl", "slices", "white-ptfe"])


if __name__ == "__main__":
    unittest.main()
