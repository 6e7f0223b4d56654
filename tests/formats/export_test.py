"""Files for simulators: what `validate` finds in them, and which options they take and refuse."""

import json
import unittest

import scalar_reference
from program import BAD_INPUT, CHECK_FAILED, DONE, FILE, MATERIALS, VINYL, run
from written import AXES, Written


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
        (expected,) = scalar_reference.brdf(VINYL, [(found["theta_i"], found["theta_s"], found["phi"])])
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

    def test_a_simulators_file_gives_its_material(self):
        file = self.generate("a.csv", *AXES)
        first, second = self.generate("b.ssdd", *AXES), self.generate("c.ssdd", *AXES, material=file)
        strip = lambda file: [line for line in file.read_text().split("\n") if not line.startswith("# 20")]
        self.assertEqual(strip(first), strip(second))
        result = run("plot", file, "-o", self.folder / "b.svg")
        self.assertEqual(result.returncode, DONE, result.stderr)

    def test_more_samples_than_memory_takes(self):
        self.refused("-o", self.folder / "a.csv", "--phi-s", "0:360:0.01", parts=("samples", "at most"))

    def test_several_materials_into_a_folder(self):
        materials = sorted(MATERIALS.glob("*.toml"))[:2]
        result = run("generate", *materials, "-o", f"{self.folder}/", "--format", "zemax")
        self.assertEqual(result.returncode, DONE, result.stderr)
        self.assertEqual(sorted(p.name for p in self.folder.glob("*.bsdf")), [f"{m.stem}_zemax.bsdf" for m in materials])


if __name__ == "__main__":
    unittest.main()
