"""CSV, ASTM and SSDD files, each read by a parser of its own here, written from the format's description, not from the program."""

import csv
import math
import struct
import unittest

import scalar_reference
from program import BAD_INPUT, DONE, VINYL, run
from written import AXES, PHI, THETA_I, THETA_S, Written, golden


class Csv(Written):
    def rows(self, file):
        return list(csv.DictReader(line for line in file.read_text().splitlines() if not line.startswith("#")))

    def test_golden_direction(self):
        rows = self.rows(self.generate("a.csv", *AXES, "--csv-digits", 15, material=scalar_reference.VINYL))
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
        names, rows = self.parse(self.generate("a.astm", *AXES, material=scalar_reference.VINYL))
        self.assertEqual(names, ["theta_i", "phi_i", "theta_s", "phi_s", "brdf"])
        # Angles are radians, and both vectors point away from the surface, so that specular is at phi_i + pi.
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
        (f,) = self.value(self.generate("a.ssdd", *AXES, material=scalar_reference.VINYL), THETA_I, THETA_S, 180 + PHI)
        self.assert_close(f, golden(), 8)

    def test_binary(self):
        file = self.generate("a.ssdd", *AXES, "--ssdd-data", "binary", material=scalar_reference.VINYL)
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


if __name__ == "__main__":
    unittest.main()
