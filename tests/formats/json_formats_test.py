"""The formats in JSON, by the rules of their schemas as written down here, and by values at directions."""

import json
import math
import re
import unittest

import jsonschema

import scalar_reference
from program import BAD_INPUT, DONE, MATERIALS, InFolder, run
from scalar_reference import VINYL

SMALL = ["--theta-i", "0,10,35,60", "--theta-s", "0,35,54.38,75.9", "--phi-s", "0,46.38,180,226.38,360"]

# Nine digits of f are written.
ROUNDED = 2e-8

TEXT = {"type": "string", "minLength": 1}
DIRECTION = {"type": "object", "required": ["unit", "values"], "additionalProperties": False}


def angles(below):
    return {**DIRECTION, "properties": {"unit": {"const": "deg"}, "values": {
        "type": "array", "items": {"type": "number", "minimum": 0, "exclusiveMaximum": below}}}}


# ASAM OpenMATERIAL 3D 1.0.0 requires this of a look-up table of a BRDF.
OPENMATERIAL = {
    "type": "object", "required": ["metadata", "brdf"],
    "properties": {
        "metadata": {
            "required": ["name", "uuid", "materialVersion", "openMaterial3dVersion", "copyrights", "license", "authors", "sources"],
            "properties": {
                "name": TEXT, "license": TEXT, "sources": TEXT, "description": TEXT,
                "uuid": {"type": "string", "pattern": "^[0-9a-f]{8}-[0-9a-f]{4}-[0-9a-f]{4}-[0-9a-f]{4}-[0-9a-f]{12}$"},
                "materialVersion": {"pattern": r"^\d+\.\d+\.\d+$"}, "openMaterial3dVersion": {"const": "1.0.0"},
                "creationDate": {"pattern": r"^\d{8}T\d{6}Z$"},
                "copyrights": {"type": "array", "items": TEXT, "minItems": 1},
                "authors": {"type": "array", "items": TEXT, "minItems": 1}}},
        "brdf": {
            "required": ["wavelengths", "lookupTable"],
            "properties": {
                "wavelengths": {"type": "array", "items": {"type": "number", "minimum": 1e-9, "maximum": 17.16e-3}},
                "lookupTable": {"type": "array", "items": {
                    "type": "array", "minItems": 5, "maxItems": 5, "items": [
                        {"type": ["number", "null"], "minimum": 1e-9, "maximum": 17.16e-3},
                        {"type": "number", "minimum": 0, "maximum": 1.570796},
                        {"type": "number", "minimum": 0, "maximum": 1.570796},
                        {"type": "number", "minimum": 0, "maximum": 6.283185},
                        {"type": "number", "minimum": 0}]}}}}}}

# EURAMET BiRD 1.0 requires this of metadata and data, and allows no more than it knows.
BIRD = {
    "type": "object", "required": ["metadata", "data"], "additionalProperties": False,
    "properties": {
        "metadata": {
            "additionalProperties": False,
            "required": ["schema", "id", "type", "timestamp", "provenance", "description", "method", "instrumentation", "software",
                         "sample", "environment"],
            "properties": {
                "schema": {"type": "string", "pattern": "^https://.*/brdf_json_schema_v1.0.json$"}, "license": {
                    "required": ["type", "rights_holder"]},
                "id": {"type": "string", "pattern": "^urn:uuid:[0-9a-f-]{36}$"}, "type": {"const": "BRDF"},
                "timestamp": {"type": "string", "pattern": r"^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ$"},
                "provenance": {
                    "required": ["organization", "location", "email", "contact_person"], "additionalProperties": False,
                    "properties": {
                        "organization": TEXT, "contact_person": TEXT, "email": {"type": "string", "pattern": "@"},
                        "location": {"required": ["country", "city", "street", "building_nr", "postal_code"],
                                     "additionalProperties": TEXT}}},
                "description": TEXT, "method": {"const": "simulation"}, "instrumentation": {"const": "NA"},
                "software": {
                    "required": ["name"], "additionalProperties": False,
                    "properties": {
                        "name": TEXT, "version": TEXT,
                        "simulation_model": {
                            "required": ["name", "description"], "additionalProperties": False,
                            "properties": {
                                "name": TEXT, "description": TEXT, "equation": TEXT, "comments": TEXT,
                                "parameters": {"type": "array", "uniqueItems": True, "items": {
                                    "required": ["name", "description", "value", "unit"], "additionalProperties": False,
                                    "properties": {
                                        "name": TEXT, "symbol": TEXT, "description": TEXT, "unit": TEXT, "comments": TEXT,
                                        "uncertainty_unit": TEXT, "value": {"type": "number"}, "uncertainty": {"type": "number"}}}}}}}},
                "sample": {
                    "required": ["name", "type", "dimensions", "shape", "zero_azimuth_location"], "additionalProperties": False,
                    "properties": {"name": TEXT, "type": TEXT, "shape": TEXT, "zero_azimuth_location": TEXT, "dimensions": {
                        "type": "object", "additionalProperties": False}}},
                "environment": {"const": "NA"}, "comments": TEXT, "adhoc_section": {"type": "object"}}},
        "data": {
            "required": ["theta_i", "phi_i", "theta_r", "phi_r", "BRDF"], "additionalProperties": False,
            "properties": {
                "theta_i": angles(90), "phi_i": angles(360), "theta_r": angles(90), "phi_r": angles(360),
                "wavelength_i": {**DIRECTION, "properties": {"unit": {"const": "nm"}, "values": {
                    "type": "array", "items": {"type": "number", "minimum": 0}}}},
                "polarization_i": {
                    "required": ["notation", "values"], "additionalProperties": False, "properties": {
                        "notation": {"const": "sp"}, "values": {"type": "array", "items": {"enum": ["s", "p", "u"]}}}},
                "BRDF": {**DIRECTION, "properties": {"unit": {"const": "sr^-1"}, "values": {
                    "type": "array", "items": {"type": "number", "minimum": 0}}}}}}}}


class Written(InFolder):
    def written(self, format, schema, material, *options):
        file = self.folder / "file.json"
        result = run("generate", material, "--format", format, "-o", file, "--force", *options)
        self.assertEqual(result.returncode, DONE, result.stderr)
        content = json.loads(file.read_text())
        jsonschema.Draft7Validator(schema).validate(content)
        return content

    def spectrum(self):
        file = self.folder / "spectrum.toml"
        file.write_text(VINYL.read_text() + "[[band]]\nwavelength_nm = 450.0\nsigma_bulk = 0.2\n[[band]]\nwavelength_nm = 650.5\n")
        return file

    def assert_samples(self, samples, material, tolerance=ROUNDED):
        """(theta_i, theta_s, difference of the azimuths away from the surface, f), in degrees: 180 is specular."""
        f = scalar_reference.brdf(material, [(i, s, azimuth - 180) for i, s, azimuth, _ in samples])
        for sample, expected in zip(samples, f, strict=True):
            self.assertAlmostEqual(sample[3] / expected, 1, delta=tolerance, msg=f"{sample}")


class OpenMaterial(Written):
    def rows(self, *options, material=VINYL):
        return self.written("openmaterial", OPENMATERIAL, material, *options)["brdf"]

    def test_samples_in_radians_and_their_order(self):
        content = self.rows(*SMALL, "--openmaterial-wavelength", 532)
        table = content["lookupTable"]
        self.assertEqual(content["wavelengths"], [5.32e-7])
        self.assertEqual({row[0] for row in table}, {5.32e-7})
        self.assertEqual(table, sorted(table))
        # A turn is closed, and starts at the light's azimuth.
        self.assertEqual(sorted({round(math.degrees(row[3]), 4) for row in table}), [0, 46.38, 180, 226.38, 360])
        self.assert_samples([(*map(math.degrees, row[1:4]), row[4]) for row in table], VINYL)

    def test_golden_direction(self):
        (theta_i, theta_s, phi), expected = scalar_reference.off_plane()
        wanted = [math.radians(angle) for angle in (theta_i, theta_s, (phi + 180) % 360)]
        found, = [row[4] for row in self.rows(*SMALL)["lookupTable"]
                  if all(abs(a - b) < 1e-6 for a, b in zip(row[1:4], wanted, strict=True))]
        self.assertAlmostEqual(found / expected, 1, delta=1e-5)  # angles are written to a millionth

    def test_bands(self):
        spectrum = self.spectrum()
        content = self.rows("--theta-i", 30, "--theta-s", "10,50", "--phi-s", "0:360:90", material=spectrum)
        self.assertEqual(content["wavelengths"], [4.5e-7, 6.505e-7])
        table = content["lookupTable"]
        self.assertEqual([row[0] for row in table], [4.5e-7] * 10 + [6.505e-7] * 10)
        self.assert_samples([(*map(math.degrees, row[1:4]), row[4]) for row in table[10:]], VINYL)

    def test_the_same_material_has_the_same_identity(self):
        one = self.written("openmaterial", OPENMATERIAL, VINYL, *SMALL)["metadata"]["uuid"]
        self.assertEqual(self.written("openmaterial", OPENMATERIAL, VINYL, "--theta-i", "0,5")["metadata"]["uuid"], one)
        self.assertNotEqual(self.written("openmaterial", OPENMATERIAL, self.spectrum(), *SMALL)["metadata"]["uuid"], one)

    def test_what_it_cannot_hold_is_refused(self):
        for options, part in ((["--phi-i", "0,90"], "phi_i"), (["--theta-s", "0:89:0.1", "--theta-i", "0:85:1"], "1000000")):
            refused = run("generate", VINYL, "--format", "openmaterial", "-o", self.folder / "file.json", *options)
            self.assert_refused(refused, BAD_INPUT, part)
            self.assertEqual(list(self.folder.iterdir()), [])


class Bird(Written):
    def samples(self, content):
        """By row: theta_i, theta_r, phi_r - phi_i, BRDF."""
        data = {name: entry["values"] for name, entry in content["data"].items()}
        self.assertEqual({len(values) for values in data.values()}, {len(data["BRDF"])})
        return [(i, r, phi_r - phi_i, f) for i, r, phi_i, phi_r, f in
                zip(data["theta_i"], data["theta_r"], data["phi_i"], data["phi_r"], data["BRDF"])]

    def test_samples_in_degrees(self):
        content = self.written("bird", BIRD, VINYL, *SMALL, "--phi-i", "0,30")
        self.assertEqual(sorted(set(content["data"]["phi_i"]["values"])), [180, 210])
        samples = self.samples(content)
        self.assertEqual(len(samples), 4 * 2 * 4 * 4)  # 360 degrees of azimuth are 0
        self.assert_samples(samples, VINYL)

    def test_golden_direction(self):
        (theta_i, theta_s, phi), expected = scalar_reference.off_plane()
        content = self.written("bird", BIRD, VINYL, *SMALL)
        found, = [f for i, r, azimuth, f in self.samples(content)
                  if (i, r) == (theta_i, theta_s) and abs(math.remainder(azimuth - 180 - phi, 360)) < 1e-9]
        self.assertAlmostEqual(found / expected, 1, delta=ROUNDED)

    def test_bands_and_polarisations(self):
        content = self.written("bird", BIRD, self.spectrum(), "--theta-i", 30, "--theta-s", "50", "--phi-s", "0,90",
                               "--bird-polarization", "all")
        data = content["data"]
        self.assertEqual(data["wavelength_i"]["values"], [450, 450, 650.5, 650.5] * 3)
        self.assertEqual("".join(data["polarization_i"]["values"]), "uuuusssspppp")
        u, s, p = (data["BRDF"]["values"][k:k + 4] for k in (0, 4, 8))
        for k in range(4):
            self.assertAlmostEqual(u[k], (s[k] + p[k]) / 2, delta=1e-9)
        self.assertGreater(s[2], 1.1 * p[2])
        names = [entry["name"] for entry in content["metadata"]["software"]["simulation_model"]["parameters"]]
        self.assertIn("sigma_bulk[450]", names)
        self.assertIn("sigma_bulk[650.5]", names)
        self.assertIn("rho_bulk", names)

    def test_uncertainty_from_a_fit(self):
        data, material = self.folder / "data.csv", self.folder / "fit.toml"
        pairs = "theta_i_deg,theta_s_deg,phi_deg\n" + "".join(f"{i},{s},0\n" for i in range(0, 81, 20) for s in range(-80, 81, 8))
        for result in (run("evaluate", MATERIALS / "garnet-red-paint.toml", "-o", data, "--noise", "0.03", stdin=pairs),
                       run("fit", data, "-o", material, "--floor", "0", "--starts", "24", "--fix", "delta=0")):
            self.assertEqual(result.returncode, DONE, result.stderr)
        printed = {line.split()[0]: line for line in result.stdout.splitlines() if re.match(r"\w+ +[\d.]+ ", line)}
        model = self.written("bird", BIRD, material, *SMALL)["metadata"]["software"]["simulation_model"]
        self.assertIn("profile likelihood", model["comments"])
        entries = {entry["name"]: entry for entry in model["parameters"]}
        self.assertEqual(len(entries), 14)
        low, high = map(float, re.search(r"(\S+) to (\S+)", printed["n_eff"]).groups())
        self.assertAlmostEqual(entries["n_eff"]["uncertainty"], (high - low) / 2, delta=1e-12)
        self.assertAlmostEqual(entries["n_eff"]["value"], float(printed["n_eff"].split()[1]), delta=1e-4)
        self.assertNotIn("uncertainty", entries["delta"])

    def test_an_interval_that_only_bounds_limit_is_no_uncertainty(self):
        material = self.folder / "fit.toml"
        material.write_text(VINYL.read_text() + """
[[band]]
wavelength_nm = 450.0
n_eff = 1.5
[band.fit.n_eff]
low = 1.3
high = 1.9

[[band]]
wavelength_nm = 650.0

[fit]
n_eff = { low = 1.2, high = 1.3, bounds = [0.05, 20] }
w_a = { low = 0, high = 100, open = "both" }
rho_bulk = { low = 0.5, high = 100, open = "above" }
gamma = { at_bound = true }
""")
        model = self.written("bird", BIRD, material, *SMALL)["metadata"]["software"]["simulation_model"]
        entries = {entry["name"]: entry for entry in model["parameters"]}
        for name, flag in (("w_a", "unidentifiable"), ("rho_bulk", "no upper limit")):
            self.assertNotIn("uncertainty", entries[name])
            self.assertIn(flag, entries[name]["comments"])
        self.assertNotIn("uncertainty", entries["gamma"])
        self.assertAlmostEqual(entries["n_eff[450]"]["uncertainty"], 0.3, delta=1e-12)
        self.assertAlmostEqual(entries["n_eff[650]"]["uncertainty"], 0.05, delta=1e-12)

    def test_a_material_that_was_not_fitted_has_none(self):
        model = self.written("bird", BIRD, VINYL, *SMALL)["metadata"]["software"]["simulation_model"]
        self.assertTrue(all("uncertainty" not in entry for entry in model["parameters"]))


if __name__ == "__main__":
    unittest.main()
