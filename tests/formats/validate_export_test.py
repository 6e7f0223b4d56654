"""`validate` of simulators' files: right ones are good at any resolution, and falsified ones are not, whatever their format
loses by itself. The line says in which region of directions and by which statistic, or which value it is."""

import json
import shutil
import unittest

import export_files
from program import BAD_INPUT, CHECK_FAILED, DONE, MATERIALS, VINYL, InFolder, run

PAINT, SHEETING = MATERIALS / "garnet-red-paint.toml", MATERIALS / "yellow-retro-sheeting.toml"
BANDS = "".join(f"[[band]]\nwavelength_nm = {nm}\nsigma_bulk = {sigma}\n"
                for nm, sigma in ((450.0, 0.03), (550.0, 0.1), (650.0, 0.21)))

AXES = ["--theta-i", "0:75:15", "--theta-s", "0:80:8", "--phi-s", "0:360:20"]
RGL = ["--rgl-theta-i", "16", "--rgl-samples", "16", "--rgl-warp-theta", "32", "--rgl-warp-phi", "17"]
# For each suffix that export_files knows: the format, and options of a small file.
FORMATS = {
    "csv": ("csv", AXES), "astm": ("astm", AXES), "ssdd": ("ssdd", AXES), "json": ("bird", AXES), "xompt": ("openmaterial", AXES),
    "bsdf": ("zemax", ["--zemax-incidence", "0:75:15", "--zemax-azimuth", "0:180:20", "--zemax-radial", "0:150:10"]),
    "nc": ("eradiate", ["--eradiate-cosines", "12", "--eradiate-azimuths", "24"]),
    "binary": ("merl", []), "rgl": ("rgl", RGL), "klems": ("radiance", ["--radiance-basis", "klems"]),
    "tree": ("radiance", ["--radiance-basis", "tree", "--radiance-depth", "4"])}


class Exported(InFolder):
    def generate(self, suffix, *options, material=VINYL, name="file", small=True):
        file = self.folder / f"{name}.{suffix}"
        format_name, of_small = FORMATS[suffix]
        if small:
            options = (*of_small, *options)
        result = run("generate", material, "--format", format_name, "-o", file, "--force", "-q", *options)
        self.assertEqual(result.returncode, DONE, result.stderr)
        return file

    def validate(self, file, *options, material=VINYL):
        if file.suffix == ".binary":
            options = ("--material", material, *options)
        return run("validate", file, *options)

    def assert_good(self, file, *options, material=VINYL):
        result = self.validate(file, "--json", *options, material=material)
        self.assertEqual(result.returncode, DONE, result.stderr)
        found = json.loads(result.stdout)
        self.assertTrue(found["good"])
        self.assertGreater(found["values"]["compared"], 0)
        # Both sides compute the same numbers in one arithmetic: what is allowed beyond is room for others.
        self.assertLess(found["values"]["max"], 1e-6)
        for region in found["regions"]:
            for statistic in ("median", "95_percent", "mean"):
                reached = region[statistic]["reached"]
                self.assertAlmostEqual(region[statistic]["file"], reached, delta=1e-5 * (1 + abs(reached)))
        return found

    def assert_wrong(self, file, *parts, options=(), material=VINYL):
        """Exit status 1, and one line with the file's name and every part."""
        result = self.validate(file, *options, material=material)
        self.assertEqual(result.returncode, CHECK_FAILED, result.stderr or f"{file} is good")
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        for part in (file, *parts):
            self.assertIn(str(part), result.stderr)
        self.assertIn("NOT good", result.stdout)
        return result.stderr

    def assert_names_a_region(self, said):
        self.assertRegex(said, r"(all directions|theta_[is] \d+ to \d+ degrees|near the \w+ direction)( in [^:]+)?: "
                               r"f read is off by \S+ % of f in the (median|95th percentile|mean); "
                               r"the format reaches \S+ %, allowed is \S+ %")


class Right(Exported):
    def test_at_the_formats_own_resolution(self):
        for suffix in FORMATS:
            with self.subTest(suffix):
                self.assert_good(self.generate(suffix, small=suffix in ("json", "xompt")))

    def test_at_a_reduced_one(self):
        for material in (PAINT, SHEETING):
            for suffix in FORMATS:
                with self.subTest(suffix, material=material.stem):
                    self.assert_good(self.generate(suffix, material=material), material=material)

    def test_with_bands(self):
        material = self.folder / "bands.toml"
        material.write_text(VINYL.read_text() + BANDS)
        for suffix in FORMATS.keys() - {"nc", "tree"}:
            options = ["--rgl-channels", "spectral"] if suffix == "rgl" else []
            with self.subTest(suffix):
                found = self.assert_good(self.generate(suffix, *options, material=material), material=material)
                channels = {region["channel"] for region in found["regions"]}
                self.assertEqual(len(channels), 3, channels)
        for suffix in ("nc", "tree", "csv"):
            with self.subTest(suffix, wavelength=650):
                self.assert_good(self.generate(suffix, "--wavelength", "650", material=material))

    def test_other_conventions_of_a_format(self):
        node = ["--merl-registration", "node"]
        for suffix, options in (("ssdd", ["--ssdd-data", "binary"]), ("binary", node), ("json", ["--bird-polarization", "all"]),
                                ("klems", ["--radiance-values", "centre"]), ("tree", ["--radiance-values", "centre"])):
            with self.subTest(suffix):
                self.assert_good(self.generate(suffix, *options), *(node if options == node else []))

    def test_of_few_digits(self):
        for digits in (2, 4):
            result = self.validate(self.generate("csv", "--csv-digits", digits), "--json")
            self.assertEqual(result.returncode, DONE, result.stderr)
            self.assertAlmostEqual(json.loads(result.stdout)["values"]["rounding"], 5 * 10.0**-digits)


class Resolution(Exported):
    """What is off is then the resolution: it is reported, not judged, and measured where the file has samples."""

    def axes(self, theta_i="0:75:15", theta_s="0:80:8", phi_s="0:360:20"):
        found = self.assert_good(self.generate("csv", "--theta-i", theta_i, "--theta-s", theta_s, "--phi-s", phi_s, small=False))
        worst = found["uniform"]["worst"]
        for angle in ("theta_i", "theta_s", "phi"):
            low, high = found["drawn"][angle]
            self.assertTrue(low <= worst[angle] <= high, (angle, worst))
        return found

    def test_one_azimuth(self):
        found = self.axes(phi_s="30")
        self.assertEqual(found["drawn"]["phi"], [30, 30])
        self.assertLess(found["uniform"]["median"], 0.05)

    def test_in_the_plane_of_incidence(self):
        found = self.axes(phi_s="0")
        self.assertIn("near the mirror direction", {region["region"] for region in found["regions"]})

    def test_one_polar_angle(self):
        found = self.axes(theta_i="60", theta_s="20:80:4")
        self.assertEqual(found["drawn"]["theta_i"], [60, 60])
        self.assertEqual(found["drawn"]["theta_s"], [20, 80])
        self.assertLess(found["uniform"]["median"], 0.05)

    def test_a_gap_in_azimuth(self):
        found = self.axes(phi_s="-40:200:20")
        self.assertEqual(found["drawn"]["phi"], [-40, 200])
        for whole in ("0:340:20", "0:180:20", "-180:0:20"):
            self.assertEqual(self.axes(phi_s=whole)["drawn"]["phi"], [-180, 180], whole)

    def test_few_angles(self):
        self.assertGreater(self.axes(theta_i="0,60", theta_s="0,70", phi_s="0,180")["uniform"]["95_percent"], 0.5)

    def test_the_share_of_directions(self):
        # Polar angles to 60 degrees are half a hemisphere, azimuths from 90 to 180 degrees a quarter of a turn.
        self.assertAlmostEqual(self.axes("0:60:10", "0:60:10", "90:180:10")["drawn"]["share"], 0.5 * 0.5 * 0.25, delta=1e-12)
        small = ["--zemax-incidence", "0:60:10", "--zemax-radial", "0:30:2"]
        found = self.assert_good(self.generate("bsdf", *small, small=False))
        self.assertLess(found["drawn"]["share"], 0.5 * 0.25)
        self.assertLess(found["uniform"]["95_percent"], 0.3)


class Wrong(Exported):
    def falsified(self, change, suffixes=FORMATS, material=VINYL, options=()):
        for suffix in suffixes:
            with self.subTest(suffix):
                file = self.generate(suffix, *options, material=material)
                export_files.rewrite(file, change)
                yield file

    def test_every_value(self):
        originals = {suffix: self.generate(suffix, name="right") for suffix in FORMATS}
        for factor in (1.2, 1.02, 0.9):
            for suffix, original in originals.items():
                with self.subTest(suffix, factor=factor):
                    file = self.folder / f"file.{suffix}"
                    shutil.copy(original, file)
                    export_files.rewrite(file, lambda theta_i, theta_s, channel, f: factor * f)
                    self.assert_names_a_region(self.assert_wrong(file))

    def test_beyond_60_degrees(self):
        for file in self.falsified(lambda theta_i, theta_s, channel, f: f * (1 + 9 * (theta_s > 60))):
            said = self.assert_wrong(file, "values are off by more than 0.1 % of f, most of all")
            self.assert_names_a_region(said)
            self.assertNotIn("theta_s 0 to 30", said)

    def test_one_theta_i(self):
        band = {"nc": (56, 58), "binary": (42, 43), "klems": (39, 41), "tree": (38, 44)}
        for suffix in FORMATS.keys() - {"rgl"}:
            low, high = band.get(suffix, (44, 46))

            def change(theta_i, theta_s, channel, f):
                return f * (1 + 0.2 * ((theta_i > low) & (theta_i < high)))

            for file in self.falsified(change, [suffix]):
                self.assert_wrong(file, "values are off")

    def test_one_channel(self):
        material = self.folder / "bands.toml"
        material.write_text(VINYL.read_text() + BANDS)
        names = {"bsdf": "Y", "binary": "G", "klems": "CIE-X", "rgl": "G"}
        suffixes = FORMATS.keys() - {"nc", "tree"}
        for file in self.falsified(lambda theta_i, theta_s, channel, f: f * (1.1 if channel == 1 else 1), suffixes, material):
            said = self.assert_wrong(file, names.get(file.suffix[1:], "550 nm"), material=material)
            self.assert_names_a_region(said)

    def test_one_value(self):
        def change(theta_i, theta_s, channel, f):
            nonlocal changed
            if changed or not (abs(theta_i - 30) < 1e-3 and abs(theta_s - 48) < 1e-3):
                return f
            changed = True
            return 1.003 * f

        for suffix in ("json", "xompt"):
            changed = False
            for file in self.falsified(change, [suffix]):
                said = self.assert_wrong(file, ": 1 of ", "theta_i = 30, theta_s = 48")
                self.assertNotIn("f read is off", said)

    def test_the_tolerance_is_a_share_of_f(self):
        for file in self.falsified(lambda theta_i, theta_s, channel, f: 1.02 * f, ["csv", "klems", "tree", "rgl"]):
            self.assertEqual(self.validate(file, "--tolerance", "0.021").returncode, DONE)
            self.assert_wrong(file, "more than 1.9 % of f", options=["--tolerance", "0.019"])

    def test_light_and_viewer_exchanged(self):
        file = self.generate("csv", "--theta-i", "0:80:10", "--theta-s", "0:80:10", "--phi-s", "0:180:30", small=False)
        for names in (("theta_i_deg", "theta_s_deg"), ("brdf_s", "brdf_p")):
            text = file.read_text()
            lines = text.split("\n")
            header = next(k for k, line in enumerate(lines) if not line.startswith("#"))
            exchanged = {names[0]: names[1], names[1]: names[0]}
            lines[header] = ",".join(exchanged.get(name, name) for name in lines[header].split(","))
            file.write_text("\n".join(lines))
            self.assert_wrong(file, "values are off")
            file.write_text(text)

    def test_azimuths_reversed(self):
        for suffix in ("csv", "ssdd"):
            file = self.generate(suffix, *AXES[:4], "--phi-s", "0:180:20", small=False)
            lines = file.read_text().splitlines()
            if suffix == "ssdd":
                at = next(k for k, line in enumerate(lines) if line.startswith("DATA "))
                nodes = 6 * 11
                blocks = [lines[k:k + nodes] for k in range(at + 1, len(lines), nodes)]
                lines[at + 1:] = [line for block in reversed(blocks) for line in block]
            else:
                at = next(k for k, line in enumerate(lines) if not line.startswith("#"))
                rows = [line.split(",") for line in lines[at + 1:]]
                lines[at + 1:] = [",".join([*row[:3], str(180 - float(row[3])), *row[4:]]) for row in rows]
            file.write_text("\n".join(lines) + "\n")
            self.assert_names_a_region(self.assert_wrong(file))

    def test_polarisations_exchanged(self):
        file = self.generate("json", "--bird-polarization", "all")
        file.write_text(file.read_text().replace('"s"', '"x"').replace('"p"', '"s"').replace('"x"', '"p"'))
        self.assert_wrong(file, "brdf_")

    def test_the_reflectance_of_zemax(self):
        file = self.generate("bsdf")
        lines = file.read_text().splitlines()
        at = [k for k, line in enumerate(lines) if line.startswith("TIS")][2]
        lines[at] = f"TIS\t{1.1 * float(lines[at].split()[1])}"
        file.write_text("\n".join(lines) + "\n")
        self.assert_wrong(file, "1 of ", "TIS", "AngleOfIncidence 30")

    def test_a_band_of_another_wavelength(self):
        material = self.folder / "bands.toml"
        material.write_text(VINYL.read_text() + BANDS)
        file = self.generate("csv", material=material)
        lines = file.read_text().splitlines()
        file.write_text("\n".join("500" + line[3:] if line.startswith("450,") else line for line in lines) + "\n")
        result = self.validate(file)
        self.assertEqual(result.returncode, BAD_INPUT)
        self.assertIn("bands are 500, 550, 650 nm", result.stderr)


if __name__ == "__main__":
    unittest.main()
