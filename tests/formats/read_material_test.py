"""A material is read from whatever file holds one: TOML, a table, a simulator's file."""

import csv
import unittest

from program import BAD_INPUT, DONE, MATERIALS, SMALL_GRID, VINYL, InFolder, run

BANDED = MATERIALS / "garnet-red-spectrum.toml"
PAIRS = "theta_i_deg,theta_s_deg,phi_deg\n10,20,0\n45,45,0\n60,30,170\n"
# Formats that carry the material's text, each with coarse nodes.
CARRIERS = {
    "t.h5": SMALL_GRID, "t.exr": SMALL_GRID, "slices/": ["--exr-layout", "files", *SMALL_GRID],
    "t.astm": SMALL_GRID, "t.csv": SMALL_GRID, "t.ssdd": SMALL_GRID,
    "t_bird.json": ["--format", "bird", *SMALL_GRID], "t.xompt": SMALL_GRID,
    "t_eradiate.nc": ["--format", "eradiate", "--eradiate-cosines", "4", "--eradiate-azimuths", "8"],
    "t_rgl.bsdf": ["--format", "rgl", "--rgl-theta-i", "4", "--rgl-samples", "8", "--rgl-warp-theta", "16", "--rgl-warp-phi", "9"],
    "t_zemax.bsdf": ["--format", "zemax", "--zemax-incidence", "0,40", "--zemax-radial", "0,5,90", "--zemax-azimuth", "0,180"],
    "t.xml": ["--radiance-depth", "3"],
}


class ReadMaterial(InFolder):
    def written(self, material, name, *options):
        result = run("generate", material, "-q", "-o", self.folder / name.rstrip("/"), *options)
        self.assertEqual(result.returncode, DONE, result.stderr)
        return self.folder / name.rstrip("/")

    def evaluated(self, file, stdin=PAIRS):
        result = run("evaluate", file, stdin=stdin)
        self.assertEqual(result.returncode, DONE, result.stderr)
        return [row for row in csv.reader(result.stdout.splitlines()) if not row[0].startswith("#")]

    def test_every_format_that_carries_its_text(self):
        expected = self.evaluated(VINYL)
        integrals = run("integrate", VINYL, "--theta-i", "0,60").stdout
        for name, options in CARRIERS.items():
            with self.subTest(name):
                file = self.written(VINYL, name, *options)
                self.assertEqual(self.evaluated(file), expected)
                lines = lambda text: [line for line in text.splitlines() if not line.startswith("#")]
                self.assertEqual(lines(run("integrate", file, "--theta-i", "0,60").stdout), lines(integrals))

    def test_bench_takes_a_table(self):
        table = self.written(VINYL, "t.h5", *SMALL_GRID)
        result = run("bench", table, "--table", "0.01", "--file", "0.02", "--rounds", "1", "--folder", self.folder)
        self.assertEqual(result.returncode, DONE, result.stderr)

    def test_the_one_band_of_a_file_is_what_it_holds(self):
        whole = self.evaluated(BANDED)
        at = whole[0].index("wavelength_nm")
        file = self.written(BANDED, "t.ssdd", "--wavelength", "550", *SMALL_GRID)
        one = self.evaluated(file)
        self.assertEqual(one[1:], [row for row in whole[1:] if float(row[at]) == 550])
        self.assertEqual(len(one), 4)

    def test_a_pipe_is_read_once(self):
        pairs = self.folder / "pairs.csv"
        pairs.write_text(PAIRS)
        result = run("evaluate", "/dev/stdin", pairs, stdin=VINYL.read_text())
        self.assertEqual(result.returncode, DONE, result.stderr)
        self.assertEqual([row for row in csv.reader(result.stdout.splitlines()) if not row[0].startswith("#")], self.evaluated(VINYL))

    def test_a_file_that_cannot_hold_a_material(self):
        merl = self.written(VINYL, "t.binary")
        for command in (["evaluate", merl], ["integrate", merl], ["generate", merl, "-o", self.folder / "t.h5"]):
            self.assertEqual((result := run(*command)).returncode, BAD_INPUT)
            self.assertIn("t.binary: its format cannot hold the material", result.stderr)


if __name__ == "__main__":
    unittest.main()
