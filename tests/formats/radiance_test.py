"""Radiance's files, judged by Radiance's own library."""

import itertools
import json
import math
import random
import re
import subprocess
import unittest

import numpy

import scalar_reference
import wheels
from program import BAD_INPUT, DONE, ROOT, InFolder, environment, run
from scalar_reference import SHEETING, VINYL

# The library's own perturbation of each cell, which depends on its place, is up to 3e-4.
PERTURBED = 1e-3

# Directions of vectors away from the surface. The library is asked in a process for each file: it does not bear several.
QUERY = """
import json, sys
from pyradiance import bsdf
data = bsdf.load_file(sys.argv[1])
asked = json.load(sys.stdin)
values = [list(bsdf.query(data, *map(float, pair))) for pair in asked["pairs"]]
hemispherical = [bsdf.direct_hemi(data, float(theta), 0.0, bsdf.SAMPLE_ALL) for theta in asked["theta_i"]]
json.dump([values, hemispherical], sys.stdout)
"""

# Each row is theta of the centre, from, to, and the number of patches: "LBNL/Klems Full" as WINDOW's documentation lists it.
KLEMS = [(0, 0, 5, 1), (10, 5, 15, 8), (20, 15, 25, 16), (30, 25, 35, 20), (40, 35, 45, 24), (50, 45, 55, 24),
         (60, 55, 65, 24), (70, 65, 75, 16), (82.5, 75, 90, 12)]


def radiance(file, pairs=(), theta_i=()):
    """X, Y, Z in 1/sr at (theta_i, phi_i, theta_s, phi_s) of the model, and DHR at theta_i, as Radiance gets them."""
    vectors = [(i, phi_i + 180, s, phi_s) for i, phi_i, s, phi_s in pairs]
    result = subprocess.run([wheels.interpreter("simulators"), "-c", QUERY, file], capture_output=True, text=True, timeout=120,
                            input=json.dumps({"pairs": vectors, "theta_i": list(theta_i)}))
    assert result.returncode == 0, result.stderr
    return json.loads(result.stdout)


def directions(pairs):
    return [(i, s, phi_s - phi_i) for i, phi_i, s, phi_s in pairs]


def dhr(material, theta_i):
    result = run("integrate", material, "--theta-i", ",".join(map(str, theta_i)))
    assert result.returncode == DONE, result.stderr
    return [float(row["dhr"]) for row in scalar_reference.rows(result.stdout)]


def disk(a, b):
    """Shirley and Chiu: the unit square to direction cosines, as (radius, azimuth in degrees)."""
    a, b = 2 * a - 1, 2 * b - 1
    if a == b == 0:
        return 0.0, 0.0
    if abs(a) > abs(b):
        radius, eighths = a, b / a
    else:
        radius, eighths = b, 2 - a / b
    return abs(radius), 45 * eighths + (180 if radius < 0 else 0)


class Written(InFolder):
    def written(self, material, *options):
        file = self.folder / "file.xml"
        result = run("generate", material, "-o", file, "--force", *options)
        self.assertEqual(result.returncode, DONE, result.stderr)
        return file

    def assert_luminances(self, file, pairs, expected, tolerance):
        for pair, (_, found, _), value in zip(pairs, radiance(file, pairs)[0], expected, strict=True):
            self.assertAlmostEqual(found / value, 1, delta=tolerance,
                                   msg=f"theta_i, phi_i, theta_s, phi_s = {pair}: {found}, and {value} expected")


class Klems(Written):
    def patches(self, count):
        """Pairs of patches: incidence and scatter as (first, last, azimuth, width), and the pair of their centres."""
        draw = random.Random(7)
        for _ in range(count):
            ends, centre = [], []
            for theta, first, last, patches in (draw.choice(KLEMS), draw.choice(KLEMS)):
                phi = 360 * draw.randrange(patches) / patches
                ends.append((first, last, phi, 360 / patches))
                centre += [theta, phi]
            yield *ends, tuple(centre)

    def test_centres(self):
        for material in (VINYL, SHEETING):
            file = self.written(material, "--radiance-basis", "klems", "--radiance-values", "centre")
            pairs = [centre for _, _, centre in self.patches(300)]
            self.assert_luminances(file, pairs, scalar_reference.brdf(material, directions(pairs)), PERTURBED)

    def test_averages_are_weighted_by_projected_solid_angles(self):
        file = self.written(VINYL, "--radiance-basis", "klems")
        nodes, weights = numpy.polynomial.legendre.leggauss(6)
        pairs, expected = [], []
        for incidence, scatter, centre in self.patches(12):
            if min(incidence[1], scatter[1]) < 6 or min(incidence[1], scatter[1]) > 75:
                continue  # too wide, or too narrow a lobe, for so few nodes
            axes = []
            for first, last, phi, width in (incidence, scatter):
                low, high = (math.sin(math.radians(theta))**2 for theta in (first, last))
                axes.append([math.degrees(math.asin(math.sqrt((low + high + node * (high - low)) / 2))) for node in nodes])
                axes.append([phi + node * width / 2 for node in nodes])
            f = scalar_reference.brdf(VINYL, directions(itertools.product(*axes)))
            over = numpy.prod(list(itertools.product(weights / 2, repeat=4)), axis=1)
            pairs.append(centre)
            expected.append(float(over @ f))
        self.assert_luminances(file, pairs, expected, PERTURBED)

    def test_reflectance(self):
        file = self.written(VINYL, "--radiance-basis", "klems")
        _, found = radiance(file, theta_i=[0, 30, 50])
        for value, expected in zip(found, dhr(VINYL, [0, 30, 50]), strict=True):
            self.assertAlmostEqual(value / expected, 1, delta=0.02)


class Tree(Written):
    def test_centres(self):
        # Cells that vary less than tenfold are not refined, and are eighths of the cube's edge.
        file = self.written(VINYL, "--radiance-values", "centre", "--radiance-tolerance", "10", "--radiance-depth", "3")
        pairs = []
        for k, a, b in itertools.product(range(4), range(8), range(8)):
            radius, phi = disk((a + 0.5) / 8, (b + 0.5) / 8)
            theta_i = math.degrees(math.asin(1 - 2 * (k + 0.5) / 8))
            pairs.append((theta_i, 33, math.degrees(math.asin(radius)), 33 + phi))
        self.assert_luminances(file, pairs, scalar_reference.brdf(VINYL, directions(pairs)), PERTURBED)

    def test_averages(self):
        file = self.written(VINYL, "--radiance-tolerance", "10", "--radiance-depth", "3")
        k, a, b = 2, 5, 1
        centres, corners = [], []
        for i, j, l in itertools.product((k, k + 0.5), (a, a + 0.5), (b, b + 0.5)):
            radius, phi = disk((j + 0.25) / 8, (l + 0.25) / 8)
            corners.append((math.degrees(math.asin(1 - 2 * (i + 0.25) / 8)), 0, math.degrees(math.asin(radius)), phi))
        radius, phi = disk((a + 0.5) / 8, (b + 0.5) / 8)
        centres.append((math.degrees(math.asin(1 - 2 * (k + 0.5) / 8)), 0, math.degrees(math.asin(radius)), phi))
        f = scalar_reference.brdf(VINYL, directions(corners))
        self.assert_luminances(file, centres, [sum(f) / 8], PERTURBED)

    def test_golden_direction(self):
        (theta_i, theta_s, phi), expected = scalar_reference.off_plane()
        file = self.written(VINYL, "--radiance-tolerance", "0.03")
        self.assert_luminances(file, [(theta_i, 100, theta_s, 100 + phi)], [expected], 0.03)

    def test_specular_and_retro_peaks(self):
        file = self.written(SHEETING)
        scan = [(40, 33, theta, 33 + phi) for phi in (0, 180) for theta in range(0, 81, 2)]
        values = [y for _, y, _ in radiance(file, scan)[0]]
        # The forward direction is a reflection at 40 degrees, the backward one the retro-reflection.
        forward, backward = values[:41], values[41:]
        self.assertEqual(2 * max(range(41), key=forward.__getitem__), 40)
        self.assertEqual(2 * max(range(41), key=backward.__getitem__), 40)

    def test_reflectance(self):
        for material in (VINYL, SHEETING):
            _, found = radiance(self.written(material), theta_i=[1, 30, 60])
            for value, expected in zip(found, dhr(material, [1, 30, 60]), strict=True):
                self.assertAlmostEqual(value / expected, 1, delta=0.02)

    def test_colour(self):
        bands = "".join(f"[[band]]\nwavelength_nm = {w:.1f}\nsigma_surface = {s}\nsigma_bulk = {s}\n"
                        for w, s in ((450, 0.6), (550, 0.3), (650, 0.1)))
        spectrum, flat = self.folder / "spectrum.toml", self.folder / "flat.toml"
        spectrum.write_text(VINYL.read_text() + bands)
        flat.write_text(VINYL.read_text() + "".join(f"[[band]]\nwavelength_nm = {w}.0\n" for w in (450, 550, 650)))
        pair = (30, 0, 20, 90)  # centres of patches
        (x, y, z), = radiance(self.written(flat, "--radiance-values", "centre"), [pair])[0]
        expected, = scalar_reference.brdf(VINYL, directions([pair]))
        for value in (x, y, z):
            self.assertAlmostEqual(value / expected, 1, delta=0.015)  # the library stores colours in 16 bits
        (x, y, z), = radiance(self.written(spectrum, "--radiance-values", "centre"), [pair])[0]
        # Z sees the first band, Y the middle one, X the last and a little of the first.
        blue, green, red = scalar_reference.brdf(spectrum, directions([pair]))
        self.assertAlmostEqual(z / blue, 1, delta=0.1)
        self.assertAlmostEqual(y / green, 1, delta=0.2)
        self.assertTrue(red < x < green, (red, x, green))
        refused = run("generate", spectrum, "-o", self.folder / "tree.xml", "--radiance-basis", "tree")
        self.assert_refused(refused, BAD_INPUT, "klems", "--wavelength")

    def test_validate_reads_what_radiance_reads(self):
        draw = random.Random(3)
        for basis, median in (("tree", 0.04), ("klems", 0.1)):
            file = self.written(VINYL, "--radiance-basis", basis)
            result = run("validate", "--json", file)
            self.assertEqual(result.returncode, DONE, result.stderr)
            said = json.loads(result.stdout)["uniform"]["median"]
            pairs = [(math.degrees(math.acos(draw.random())), 0, math.degrees(math.acos(draw.random())), draw.uniform(0, 360))
                     for _ in range(400)]
            f = scalar_reference.brdf(VINYL, directions(pairs))
            errors = sorted(abs(y / value - 1) for (_, y, _), value in zip(radiance(file, pairs)[0], f, strict=True))
            self.assertLess(errors[200], median)
            self.assertAlmostEqual(errors[200] / said, 1, delta=0.25)

    def test_a_damaged_file_is_told(self):
        text = self.written(VINYL, "--radiance-depth", 3).read_text()
        for damaged, part in ((text.replace("TensorTree3", "TensorTree5"), "IncidentDataStructure"),
                              (text.replace("{ ", "{ x", 1), "not a number"),
                              (text[:text.index("</ScatteringData>")], "is not XML")):
            file = self.folder / "damaged.xml"
            file.write_text(damaged)
            self.assert_refused(run("validate", file), BAD_INPUT, file, part)

    def test_a_refusal_names_the_line(self):
        text = self.written(VINYL, "--radiance-depth", 3).read_text()
        file = self.folder / "line.xml"
        file.write_text(text.replace("TensorTree3", "TensorTree5"))
        line = 1 + text[:text.index("<IncidentDataStructure>")].count("\n")
        self.assert_refused(run("validate", file), BAD_INPUT, f"{file}:{line}: <IncidentDataStructure>: TensorTree5")

    def test_xml_is_read_as_xml(self):
        """Comments, CDATA, attributes, prefixes and encodings of others' files change nothing of what is read."""
        file = self.written(VINYL, "--radiance-basis", "klems")
        right = run("validate", "--json", file).stdout
        text = file.read_text()
        head, data = text.split("<ScatteringData>")
        data, tail = data.split("</ScatteringData>")
        numbers = data.split("\n")
        half = len(numbers) // 2
        cases = {
            "a comment": f"{head}<!-- was <ScatteringData>0</ScatteringData> --><ScatteringData>{data}</ScatteringData>{tail}",
            "a comment inside": "\n".join([f"{head}<ScatteringData>", *numbers[:half], "<!-- half -->", *numbers[half:]]) + f"</ScatteringData>{tail}",
            "CDATA": f"{head}<ScatteringData><![CDATA[{data}]]></ScatteringData>{tail}",
            "an attribute": f"{head}<ScatteringData note='a &gt; b > c'>{data}</ScatteringData>{tail}",
            "an entity": text.replace("Reflection Back", "Reflection&#32;Back").replace("LBNL/Klems Full", "LBNL/Klems&#x20;Full"),
            "a prefix": re.sub(r"<(/?)(\w+)(?=[ >])", r"<\1w:\2", text).replace("xmlns=", "xmlns:w="),
        }
        for name, changed in cases.items():
            with self.subTest(name):
                self.assertNotEqual(changed, text)
                file.write_text(changed)
                self.assertEqual(run("validate", "--json", file).stdout, right)
        file.write_bytes(text.replace('encoding="UTF-8"', 'encoding="UTF-16"').encode("utf-16"))
        self.assertEqual(run("validate", "--json", file).stdout, right)

    def test_interpolation_is_within_the_tolerance_asked(self):
        draw = random.Random(3)
        pairs = [(draw.uniform(0, 60), 0, draw.uniform(0, 60), draw.uniform(0, 360)) for _ in range(500)]
        f = scalar_reference.brdf(VINYL, directions(pairs))
        for tolerance in (0.3, 0.1):
            found = radiance(self.written(VINYL, "--radiance-tolerance", tolerance), pairs)[0]
            errors = sorted(abs(y / value - 1) for (_, y, _), value in zip(found, f, strict=True))
            self.assertLess(errors[475], tolerance)
            self.assertGreater(errors[475], tolerance / 10)


class Readme(Written):
    def test_a_scene_under_the_sun(self):
        """The README's material on a floor, by Radiance's own renderer."""
        (self.folder / ".build").mkdir()
        result = run("generate", VINYL, "-o", self.folder / ".build" / "vinyl.xml", "--radiance-tolerance", "0.02")
        self.assertEqual(result.returncode, DONE, result.stderr)
        material = re.search(r"```\n(void BSDF vinyl.*?)```", (ROOT / "README.md").read_text(), re.DOTALL).group(1)
        (self.folder / "scene.rad").write_text(material + """
vinyl polygon floor 0 0 12  -1 -1 0  1 -1 0  1 1 0  -1 1 0
void light sun 0 0 3  1000 1000 1000
sun source disk 0 0 4  0.5 0 0.8660254 0.5
""")
        python = wheels.interpreter("simulators")
        package, = (python.parent.parent / "lib").glob("python*/site-packages/pyradiance")
        variables = environment(RAYPATH=f"{package / 'lib'}:.")
        octree = subprocess.run([package / "bin" / "oconv", "scene.rad"], capture_output=True, cwd=self.folder, env=variables)
        self.assertEqual(octree.returncode, 0, octree.stderr)
        (self.folder / "scene.oct").write_bytes(octree.stdout)
        # The views are from the mirror direction, from the sun's and from the normal.
        rays = "-0.5 0 0.8660254 0.5 0 -0.8660254\n0.5 0 0.8660254 -0.5 0 -0.8660254\n0 0 1 0 0 -1\n"
        traced = subprocess.run([package / "bin" / "rtrace", "-h", "-ab", "0", "-dj", "0", "scene.oct"], input=rays,
                                capture_output=True, text=True, cwd=self.folder, env=variables)
        self.assertEqual(traced.returncode, 0, traced.stderr)
        irradiance = 1000 * 2 * math.pi * (1 - math.cos(math.radians(0.25))) * 0.8660254
        # The renderer has the viewer in the place of the light.
        f = scalar_reference.brdf(VINYL, [(30, 30, 0), (30, 30, 180), (0, 30, 0)])
        for line, expected in zip(traced.stdout.splitlines(), f, strict=True):
            # Cells differ by 2 %, and the renderer draws directions within one.
            self.assertAlmostEqual(float(line.split()[0]) / irradiance / expected, 1, delta=0.1)


if __name__ == "__main__":
    unittest.main()
