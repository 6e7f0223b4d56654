"""Files for simulators, each read by a parser of its own here, written from the format's description, not from the program.

A golden direction, off the specular one and off the plane of incidence, lies on a node of every file whose axes are free: its
value says where specular sits, degrees or radians, f or f cos or pi f, centre or node.
"""

import csv
import json
import math
import pathlib
import struct
import unittest

from program import BAD_INPUT, CHECK_FAILED, DONE, FILE, MATERIALS, ROOT, VINYL, InFolder, run

SHARED = ROOT.parent / "shared"
GOLDEN = SHARED / "golden" / "brdf.csv"
# The material of the golden values; those shipped have been fitted anew.
GOLDEN_VINYL = SHARED / "materials" / "brown-vinyl.toml"
THETA_I, THETA_S, PHI = 60, 31.71, -7.17  # a row of the golden values
AXES = ["--theta-i", f"0,{THETA_I}", "--theta-s", f"0,{THETA_S},80", "--phi-s", f"-180,{PHI},0,100,180"]

BANDS = """
[[band]]
wavelength_nm = 450.0
sigma_bulk = 0.03

[[band]]
wavelength_nm = 550.5

[[band]]
wavelength_nm = 650.0
sigma_bulk = 0.21
"""


def golden():
    with GOLDEN.open() as file:
        for row in csv.DictReader(file):
            if row["material"] == "brown-vinyl" and (float(row["theta_i_deg"]), float(row["theta_s_deg"]), float(row["phi_deg"])) == (THETA_I, THETA_S, PHI):
                return float(row["brdf"])
    raise AssertionError("the golden values have no such row")


def golden_material():
    if not GOLDEN.exists():
        raise unittest.SkipTest(f"{GOLDEN} is not there: the golden values lie beside the checkout")
    return GOLDEN_VINYL


def unit(theta, phi):
    theta, phi = math.radians(theta), math.radians(phi)
    return [math.sin(theta) * math.cos(phi), math.sin(theta) * math.sin(phi), math.cos(theta)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def model_angles(to_light, to_viewer):
    """theta_i, theta_s and phi (0 forward) of vectors away from the surface: the mirrored light is forward."""
    forward = [-to_light[0], -to_light[1]]
    phi = math.atan2(to_viewer[1], to_viewer[0]) - math.atan2(forward[1], forward[0])
    return math.degrees(math.acos(to_light[2])), math.degrees(math.acos(to_viewer[2])), math.degrees(phi)


def reference(material, *pairs, column="brdf"):
    """f by the scalar reference at pairs of theta_i, theta_s, phi."""
    text = "theta_i_deg,theta_s_deg,phi_deg\n" + "".join(f"{i},{s},{p}\n" for i, s, p in pairs)
    result = run("evaluate", material, "--engine", "reference", stdin=text)
    assert result.returncode == DONE, result.stderr
    return [float(row[column]) for row in csv.DictReader(line for line in result.stdout.splitlines() if not line.startswith("#"))]


class Written(InFolder):
    """generate, validate and refusals, with one material of one band and one of three."""

    def setUp(self):
        super().setUp()
        self.bands = self.folder / "bands.toml"
        self.bands.write_text(VINYL.read_text() + BANDS)

    def generate(self, name, *options, material=VINYL):
        file = self.folder / name
        result = run("generate", material, "-o", file, "--force", *options)
        self.assertEqual(result.returncode, DONE, result.stderr)
        self.said = result.stderr
        return file

    def assert_close(self, value, expected, digits):
        self.assertLess(abs(value / expected - 1), 10.0**-digits, f"{value!r} against {expected!r}")

    def validate(self, file, *options):
        result = run("validate", file, "--json", "--samples", 2000, *options)
        self.assertEqual(result.returncode, DONE, result.stderr)
        return json.loads(result.stdout)


class Csv(Written):
    def rows(self, file):
        return list(csv.DictReader(line for line in file.read_text().splitlines() if not line.startswith("#")))

    def test_golden_direction(self):
        rows = self.rows(self.generate("a.csv", *AXES, "--csv-digits", 15, material=golden_material()))
        self.assertEqual(len(rows), 2 * 3 * 5)
        (row,) = [r for r in rows if (float(r["theta_i_deg"]), float(r["theta_s_deg"]), float(r["phi_s_deg"])) == (THETA_I, THETA_S, PHI)]
        self.assert_close(float(row["brdf"]), golden(), 10)
        self.assert_close(0.5 * (float(row["brdf_s"]) + float(row["brdf_p"])), golden(), 10)

    def test_fit_reads_it(self):
        file = self.generate("a.csv", "--theta-i", "0:80:20", "--theta-s", "0:80:5", "--phi-s", "0,180")
        result = run("fit", file, "-o", self.folder / "fit.toml", "--starts", "1", "-q")
        self.assertEqual(result.returncode, DONE, result.stderr)

    def test_bands(self):
        rows = self.rows(self.generate("a.csv", *AXES, material=self.bands))
        self.assertEqual(sorted({r["wavelength_nm"] for r in rows}), ["450", "550.5", "650"])
        self.assertEqual({r["wavelength_nm"] for r in self.rows(self.generate("a.csv", *AXES, "--wavelength", "550.5", material=self.bands))}, {"550.5"})


class Astm(Written):
    def parse(self, file):
        header, _, rest = file.read_text().partition("\nVARS ")
        names, *rows = rest.strip().split("\n")
        names = names.split(",")
        self.assertIn(f"NUM_POINTS {len(rows)}", header.split("\n"))
        return names, [dict(zip(names, map(float, row.split(",")))) for row in rows]

    def test_golden_direction(self):
        names, rows = self.parse(self.generate("a.astm", *AXES, material=golden_material()))
        self.assertEqual(names, ["theta_i", "phi_i", "theta_s", "phi_s", "brdf"])
        # Radians; both vectors away from the surface, so that specular is at phi_i + pi.
        wanted = math.radians(THETA_I), math.radians(THETA_S), math.radians(PHI + 180)
        (row,) = [r for r in rows if max(abs(r["theta_i"] - wanted[0]), abs(r["theta_s"] - wanted[1]), abs(r["phi_s"] - r["phi_i"] - wanted[2])) < 1e-9]
        self.assert_close(row["brdf"], golden(), 8)
        azimuths = sorted({r["phi_s"] for r in rows})
        self.assertEqual(azimuths[0], 0)
        self.assertEqual(azimuths[-1], 2 * math.pi)

    def test_bands_are_channels(self):
        names, rows = self.parse(self.generate("a.astm", *AXES, material=self.bands))
        self.assertEqual(names[4:], ["450nm", "550.5nm", "650nm"])
        self.assertLess(rows[0]["450nm"], rows[0]["650nm"])

    def test_several_phi_i_are_refused(self):
        result = run("generate", VINYL, "-o", self.folder / "a.astm", "--phi-i", "0,90")
        self.assertEqual(result.returncode, BAD_INPUT)
        self.assertIn("phi_i", result.stderr)
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["bands.toml"])


class Ssdd(Written):
    def parse(self, file):
        head, mark, data = file.read_bytes().partition(b"\nDATA ")
        entries = [line.split(" ", 1) for line in head.decode().split("\n") if line and not line.startswith("#")]
        self.order = [name for name, _ in entries]
        header = dict(entries)
        kind, _, data = data.partition(b"\n")
        axes = [[float(x) for x in header[f"PARAM{k}_LIST"].split()] for k in (0, 2, 3)]
        channels = len(header["WAVELENGTH_LIST"].split()) if "WAVELENGTH_LIST" in header else 1
        count = len(axes[0]) * len(axes[1]) * len(axes[2]) * channels
        values = struct.unpack(f"<{count}f", data) if kind == b"binary" else [float(x) for x in data.split()]
        self.assertEqual(len(values), count)
        return header, axes, channels, values

    def value(self, file, theta_i, theta_s, phi):
        _, axes, channels, values = self.parse(file)
        index = [axis.index(angle) for axis, angle in zip(axes, (theta_i, theta_s, phi))]
        at = index[0] + len(axes[0]) * (index[1] + len(axes[1]) * index[2])  # theta_i fastest
        return values[at * channels : (at + 1) * channels]

    def test_golden_direction(self):
        # Half a turn stands for all of it; specular is at 180 degrees.
        (f,) = self.value(self.generate("a.ssdd", *AXES, material=golden_material()), THETA_I, THETA_S, 180 + PHI)
        self.assert_close(f, golden(), 8)

    def test_binary(self):
        file = self.generate("a.ssdd", *AXES, "--ssdd-data", "binary", material=golden_material())
        self.assert_close(self.value(file, THETA_I, THETA_S, 180 + PHI)[0], golden(), 6)
        ascii, binary = (self.validate(self.generate("a.ssdd", "--ssdd-data", data))["uniform"] for data in ("ascii", "binary"))
        self.assert_close(binary["median"], ascii["median"], 3)

    def test_entries_in_order(self):
        header, axes, *_ = self.parse(self.generate("a.ssdd", *AXES, material=self.bands))
        self.assertEqual(header["VERSION"], "0.3")
        self.assertEqual(header["REDUCTION_TYPE"], "bilateral_symmetry")
        self.assertEqual((axes[2][0], axes[2][-1]), (0, 180))
        wanted = ["DATA_TYPE", "COLOR_MODEL", "WAVELENGTH_LIST", "PARAM_TYPE", "REDUCTION_TYPE", "PARAM0_LIST", "PARAM2_LIST", "PARAM3_LIST"]
        self.assertEqual([name for name in self.order if name in wanted], wanted)


class Zemax(Written):
    def parse(self, file):
        """Axes and blocks: {content: [(TIS, rows of azimuth)] by incidence}."""
        lines = [line for line in file.read_text().split("\n") if not line.startswith("#")]
        self.assertTrue(all(line == line.strip() and "  " not in line for line in lines), "one tab between numbers, none at the end")
        keywords = dict(line.split("\t") for line in lines[:4])
        axes, k = {}, 4
        while lines[k]:
            name, count = lines[k].split("\t")
            axes[name] = [float(x) for x in lines[k + 1].split("\t")]
            self.assertEqual(len(axes[name]), int(count))
            k += 2
        blocks, content = {}, None
        for line in lines[k + 1 :]:
            if line.startswith(("Monochrome", "Tristimulus")):
                content = blocks.setdefault(line, [])
            elif line.startswith("TIS"):
                content.append((float(line.split("\t")[1]), []))
            elif line and line not in ("DataBegin", "DataEnd"):
                content[-1][1].append([float(x) for x in line.split("\t")])
        return keywords, axes, blocks

    def specular_angles(self, theta_i, theta_s, phi):
        """Radial angle from the specular direction, and azimuth about it, 0 toward the normal, of model.md's angles."""
        specular, viewer = unit(theta_i, 0), unit(theta_s, phi)
        toward_normal = unit(theta_i - 90, 0)  # at right angles to the specular direction, in plane
        return math.degrees(math.acos(dot(specular, viewer))), math.degrees(math.atan2(abs(viewer[1]), dot(toward_normal, viewer)))

    def test_golden_direction(self):
        radial, azimuth = self.specular_angles(THETA_I, THETA_S, PHI)
        self.assertTrue(20 < radial < 40 and 1 < azimuth < 30)
        file = self.generate("a.bsdf", "--format", "zemax", "--zemax-incidence", f"0,{THETA_I}", "--zemax-radial", f"0,{radial!r},50", "--zemax-azimuth", f"0,{azimuth!r},180", material=golden_material())
        keywords, axes, blocks = self.parse(file)
        self.assertEqual(keywords, {"Source": "Measured", "Symmetry": "PlaneSymmetrical", "SpectralContent": "Monochrome", "ScatterType": "BRDF"})
        self.assertEqual(axes["AngleOfIncidence"], [0, THETA_I])
        tis, rows = blocks["Monochrome"][1]
        self.assert_close(rows[1][1], golden(), 6)

    def test_tis_is_the_reflectance(self):
        _, axes, blocks = self.parse(self.generate("a.bsdf", "--format", "zemax"))
        result = run("integrate", VINYL, "--engine", "reference", "--theta-i", "0,30,60,85")
        rows = list(csv.DictReader(line for line in result.stdout.splitlines() if not line.startswith("#")))
        for row in rows:
            tis, _ = blocks["Monochrome"][axes["AngleOfIncidence"].index(float(row["theta_i_deg"]))]
            self.assert_close(tis, float(row["dhr"]), 7)

    def test_below_the_horizon_is_nothing(self):
        _, axes, blocks = self.parse(self.generate("a.bsdf", "--format", "zemax"))
        i, r = axes["AngleOfIncidence"].index(60), axes["ScatterRadial"].index(40)
        rows = blocks["Monochrome"][i][1]
        self.assertGreater(rows[0][r], 0)  # theta_s = 20
        self.assertEqual(rows[-1][r], 0)  # theta_s = 100

    def test_several_bands_are_xyz(self):
        file = self.generate("a.bsdf", "--format", "zemax", material=self.bands)
        keywords, _, blocks = self.parse(file)
        self.assertEqual(keywords["SpectralContent"], "XYZ")
        self.assertEqual(list(blocks), ["TristimulusX", "TristimulusY", "TristimulusZ"])
        self.assertGreater(blocks["TristimulusX"][0][1][0][0], blocks["TristimulusZ"][0][1][0][0])
        self.assertLess(self.validate(file)["uniform"]["median"], 0.01)

    def test_reflectance_above_one_is_said(self):
        self.generate("a.bsdf", "--format", "zemax", material=MATERIALS / "white-ptfe.toml")
        self.assertRegex(self.said, r"TIS, the model's DHR, is above 1 at \d+ of 35 incidences")

    def test_axes_that_miss_the_plane_of_symmetry(self):
        result = run("generate", VINYL, "-o", self.folder / "a.bsdf", "--format", "zemax", "--zemax-azimuth", "0:90:5")
        self.assertEqual(result.returncode, BAD_INPUT)
        self.assertIn("--zemax-azimuth 0:90:5", result.stderr)


class Merl(Written):
    SCALE = (1 / 1500, 1.15 / 1500, 1.66 / 1500)

    def planes(self, file):
        data = file.read_bytes()
        self.assertEqual(len(data), 34_992_012)
        self.assertEqual(struct.unpack("<3i", data[:12]), (90, 90, 180))
        return data

    def f(self, data, channel, h, d, phi):
        (value,) = struct.unpack_from("<d", data, 12 + 8 * (phi + 180 * (d + 90 * (h + 90 * channel))))
        return value * self.SCALE[channel] if value >= 0 else None

    def pair(self, theta_h, theta_d, phi_d):
        """Vectors to the light and to the viewer: the difference vector turned by theta_h about y."""
        x, y, z = unit(theta_d, phi_d)
        c, s = math.cos(math.radians(theta_h)), math.sin(math.radians(theta_h))
        turn = lambda x, y, z: (c * x + s * z, y, c * z - s * x)
        return turn(x, y, z), turn(-x, -y, z)

    def mean(self, material, light, viewer):
        """Of both directions of light, which the format takes for one."""
        return sum(reference(material, model_angles(light, viewer), model_angles(viewer, light))) / 2

    def test_centres_of_cells(self):
        data = self.planes(self.generate("a.binary"))
        for h, d, phi in ((20, 35, 40), (50, 3, 170), (0, 60, 90), (5, 44, 0), (40, 50, 91)):
            with self.subTest(cell=(h, d, phi)):
                light, viewer = self.pair((h + 0.5) ** 2 / 90, d + 0.5, phi + 0.5)
                for channel in range(3):  # one band is grey
                    self.assert_close(self.f(data, channel, h, d, phi), self.mean(VINYL, light, viewer), 9)

    def test_nodes(self):
        data = self.planes(self.generate("a.binary", "--merl-registration", "node"))
        for h, d, phi in ((20, 35, 40), (0, 0, 0), (30, 20, 0), (45, 30, 179)):
            with self.subTest(node=(h, d, phi)):
                self.assert_close(self.f(data, 1, h, d, phi), self.mean(VINYL, *self.pair(h * h / 90, d, phi)), 9)

    def test_below_the_horizon_is_invalid(self):
        data = self.planes(self.generate("a.binary"))
        self.assertIsNone(self.f(data, 0, 89, 80, 0))
        self.assertIsNone(self.f(data, 2, 60, 89, 0))

    def test_the_cell_of_the_golden_direction(self):
        """The cell that the reference reader looks up holds f and its exchange, off by no more than the cell is wide."""
        light, viewer = unit(THETA_I, 180), unit(THETA_S, PHI)
        half = [a + b for a, b in zip(light, viewer)]
        half = [x / math.sqrt(dot(half, half)) for x in half]
        phi_h, theta_h = math.atan2(half[1], half[0]), math.acos(half[2])
        x, y = light[0] * math.cos(phi_h) + light[1] * math.sin(phi_h), light[1] * math.cos(phi_h) - light[0] * math.sin(phi_h)
        dx, dz = x * math.cos(theta_h) - light[2] * math.sin(theta_h), x * math.sin(theta_h) + light[2] * math.cos(theta_h)
        phi_d = math.degrees(math.atan2(y, dx)) % 180
        data = self.planes(self.generate("a.binary", material=golden_material()))
        cell = self.f(data, 0, int(math.sqrt(math.degrees(theta_h) * 90)), int(math.degrees(math.acos(dz))), int(phi_d))
        expected = (golden() + reference(golden_material(), (THETA_S, THETA_I, PHI))[0]) / 2
        self.assert_close(cell, expected, 1.3)

    def test_bands_are_linear_srgb(self):
        """Weights of the three bands under D65, from colour-science and its own tables, for f linear between bands."""
        data = self.planes(self.generate("a.binary", material=self.bands))
        h, d, phi = 20, 35, 40
        light, viewer = self.pair((h + 0.5) ** 2 / 90, d + 0.5, phi + 0.5)
        there, back = model_angles(light, viewer), model_angles(viewer, light)
        pairs = reference(self.bands, there, back)
        f = [(pairs[2 * band] + pairs[2 * band + 1]) / 2 for band in range(3)]
        weights = SRGB_WEIGHTS_D65
        for channel in range(3):
            self.assertAlmostEqual(sum(weights[channel]), 1, 12)
            self.assert_close(self.f(data, channel, h, d, phi), dot(weights[channel], f), 9)

    def test_one_band_alone_is_grey(self):
        data = self.planes(self.generate("a.binary", "--wavelength", "650", material=self.bands))
        values = [self.f(data, channel, 20, 35, 40) for channel in range(3)]
        self.assert_close(values[1], values[0], 12)
        self.assert_close(values[2], values[0], 12)


class Validation(Written):
    def test_of_each_format(self):
        for name, format_name, most in (("a.csv", "csv", 0.002), ("a.astm", "astm", 0.002), ("a.ssdd", "ssdd", 0.002), ("a.bsdf", "zemax", 0.003)):
            with self.subTest(format_name):
                found = self.validate(self.generate(name, "--format", format_name))
                self.assertEqual(found["format"], format_name)
                self.assertLess(found["uniform"]["median"], most)
                self.assertLess(found["uniform"]["95_percent"], 0.05)
                self.assertIn("f is off by", self.said)
                self.assertEqual("not held: polarisation" in self.said, format_name != "csv")

    def test_merl_needs_the_material(self):
        file = self.generate("a.binary")
        self.assert_refused_validate(file, BAD_INPUT, "--material")
        found = self.validate(file, "--material", VINYL)
        self.assertLess(found["uniform"]["median"], 0.2)
        self.assertTrue(found["not_held"]["reciprocity_defect"])
        self.assertIn("not held: |ln f(i,s)/f(s,i)|", self.said)

    def assert_refused_validate(self, file, status, *parts):
        result = run("validate", file)
        self.assertEqual(result.returncode, status, result.stderr)
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        for part in parts:
            self.assertIn(str(part), result.stderr)

    def test_one_band_of_several(self):
        for name in ("a.csv", "a.astm", "a.ssdd", "a_zemax.bsdf"):
            with self.subTest(name):
                options = ["--format", "zemax"] if name.endswith("bsdf") else ["--theta-i", "0:80:10"]
                found = self.validate(self.generate(name, *options, "--wavelength", "650", material=self.bands))
                self.assertLess(found["uniform"]["median"], 0.01)

    def test_the_worst_direction_is_the_model_s(self):
        found = self.validate(self.generate("a.ssdd"))["uniform"]["worst"]
        (expected,) = reference(VINYL, (found["theta_i"], found["theta_s"], found["phi"]))
        self.assert_close(found["model"], expected, 9)

    def test_another_material_s_file(self):
        file = self.generate("a.ssdd")
        result = run("validate", file, "--material", MATERIALS / "yellow-retro-sheeting.toml", "--samples", 2000)
        self.assertEqual(result.returncode, CHECK_FAILED)
        self.assertIn("NOT good", result.stdout)

    def test_wrong_azimuths_show(self):
        """A file whose specular lies on the other side is off at most directions."""
        file = self.generate("a.ssdd")
        head, _, data = file.read_text().partition("DATA ascii\n")
        rows, block = data.split("\n")[:-1], 18 * 90
        turned = [rows[k : k + block] for k in range(0, len(rows), block)][::-1]
        file.write_text(head + "DATA ascii\n" + "\n".join(row for part in turned for row in part) + "\n")
        result = run("validate", file, "--samples", 2000, "--json")
        self.assertGreater(json.loads(result.stdout)["uniform"]["median"], 0.05)

    def test_damaged_files(self):
        for name, format_name in (("a.csv", "csv"), ("a.astm", "astm"), ("a.ssdd", "ssdd"), ("a.bsdf", "zemax")):
            with self.subTest(format_name):
                file = self.generate(name, "--format", format_name)
                file.write_bytes(file.read_bytes()[: -file.stat().st_size // 3])
                self.assert_refused_validate(file, BAD_INPUT, file)
        file = self.generate("a.binary")
        file.write_bytes(file.read_bytes()[:-8])
        self.assert_refused_validate(file, BAD_INPUT, "fewer")

    def test_axes_that_do_not_increase(self):
        file = self.generate("a.ssdd", *AXES)
        lines = file.read_text().split("\n")
        at, = [k for k, line in enumerate(lines) if line.startswith("PARAM2_LIST")]
        lines[at] = "PARAM2_LIST " + " ".join(reversed(lines[at].split()[1:]))
        file.write_text("\n".join(lines))
        self.assert_refused_validate(file, BAD_INPUT, file, "theta_s", "increase strictly")

    def test_a_grid_at_the_normal_and_a_name_of_two_lines(self):
        material = self.folder / "two\nlines.toml"
        material.write_text(VINYL.read_text())
        file = self.generate("a.csv", "--theta-i", "30", "--theta-s", "0", "--phi-s", "0:360:90", material=material)
        self.assertEqual(run("validate", file).returncode, DONE)


class Options(Written):
    def refused(self, *options, material=VINYL, status=BAD_INPUT, parts=()):
        result = run("generate", material, *options)
        self.assertEqual(result.returncode, status, result.stderr)
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        for part in parts:
            self.assertIn(part, result.stderr)
        self.assertEqual([p.name for p in self.folder.iterdir()], ["bands.toml"])

    def test_options_of_another_format(self):
        self.refused("-o", self.folder / "a.binary", "--csv-digits", 3, parts=("--csv-digits", "merl"))
        self.refused("-o", self.folder / "a.h5", "--merl-registration", "node", parts=("--merl-registration", "dense"))
        self.refused("-o", self.folder / "a.csv", "--precision", "float64", parts=("--precision", "csv"))
        self.refused("-o", self.folder / "a.binary", "--theta-i", "0", parts=("--theta-i", "merl"))
        self.refused("-o", self.folder / "a.h5", "--wavelength", "550", parts=("--wavelength", "dense"))

    def test_a_wavelength_that_is_none_of_the_bands(self):
        self.refused("-o", self.folder / "a.csv", "--wavelength", "500", material=self.bands, parts=("500", "450, 550.5, 650"))

    def test_an_ambiguous_extension(self):
        self.refused("-o", self.folder / "a.bsdf", parts=("names no format", "zemax"))

    def test_an_existing_file_stays(self):
        file = self.folder / "a.ssdd"
        file.write_text("mine")
        result = run("generate", VINYL, "-o", file)
        self.assertEqual(result.returncode, FILE)
        self.assertEqual(file.read_text(), "mine")

    def test_from_a_table_by_the_material_inside(self):
        table = self.generate("t.h5", "--theta-i", "0", "--theta-s", "0,10", "--phi-s", "0")
        strip = lambda file: [line for line in file.read_text().split("\n") if not line.startswith("# 20")]
        first = self.generate("a.ssdd", *AXES)
        self.assertEqual(strip(first), strip(self.generate("b.ssdd", *AXES, material=table)))

    def test_all_materials_are_checked_before_the_first_is_written(self):
        self.refused(self.bands, "--format", "eradiate", "-o", f"{self.folder}/", parts=("bands.toml", "--wavelength"))

    def test_a_simulators_file_is_no_material(self):
        file = self.generate("a.csv", *AXES)
        for command in (["generate", file, "-o", self.folder / "b.h5"], ["plot", file, "-o", self.folder / "b.svg"]):
            result = run(*command)
            self.assertEqual(result.returncode, BAD_INPUT, result.stderr)
            self.assertIn("a.csv: is a simulator's file (csv)", result.stderr)

    def test_more_samples_than_memory_takes(self):
        self.refused("-o", self.folder / "a.csv", "--phi-s", "0:360:0.01", parts=("samples", "at most"))

    def test_several_materials_into_a_folder(self):
        materials = sorted(MATERIALS.glob("*.toml"))[:2]
        result = run("generate", *materials, "-o", f"{self.folder}/", "--format", "zemax")
        self.assertEqual(result.returncode, DONE, result.stderr)
        self.assertEqual(sorted(p.name for p in self.folder.glob("*.bsdf")), [f"{m.stem}_zemax.bsdf" for m in materials])


# From colour-science 0.4.7: XYZ of each band's share of the spectrum, 380:780:5 nm, under D65, Bradford-adapted to
# (0.3127, 0.3290), by the matrix of the Rec. 709 primaries; channels by bands 450, 550.5 and 650 nm.
SRGB_WEIGHTS_D65 = (
    (-0.10947099743995328, 0.2995304933621423, 0.809940504077812),
    (0.11792948850363294, 0.8465474051265709, 0.035523106369794194),
    (0.9969926893365887, 0.023695076053977696, -0.020687765390565972),
)


if __name__ == "__main__":
    unittest.main()
