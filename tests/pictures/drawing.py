"""Pictures that `plot` drew, beside what `evaluate` and tables say."""

import csv
import io

import numpy

from picture import Picture
from program import DONE, InFolder, run

BANDS = "[[band]]\nwavelength_nm = 450\n[[band]]\nwavelength_nm = 650\nn_eff = 1.5\n"


class Drawing(InFolder):
    def plot(self, *arguments, name="picture.svg"):
        path = self.folder / name
        result = run("plot", *arguments, "-o", path, "--force")
        self.assertEqual(result.returncode, DONE, result.stderr)
        return path

    def picture(self, *arguments):
        return Picture(self.plot(*arguments))

    def evaluated(self, material, pairs, column="brdf"):
        text = "theta_i_deg,theta_s_deg,phi_deg\n" + "".join(f"{i},{s},{phi}\n" for i, s, phi in pairs)
        result = run("evaluate", material, stdin=text)
        self.assertEqual(result.returncode, DONE, result.stderr)
        rows = list(csv.DictReader(io.StringIO(result.stdout)))
        # A picture of a spectrum shows its first band.
        return numpy.array([float(row[column]) for row in rows if row.get("wavelength_nm") == rows[0].get("wavelength_nm")])

    def table(self, material, *options, name="table.h5"):
        path = self.folder / name
        result = run("generate", material, "-o", path, "--force", *options)
        self.assertEqual(result.returncode, DONE, result.stderr)
        return path
