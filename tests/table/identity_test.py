"""The bytes of a table do not depend on the driver, the number of devices, or how its rows are shared."""

import hashlib

import h5py
import numpy

from program import DONE, GOLDEN, InFolder, MATERIALS, run

DATASETS = ["brdf", "brdf_s", "brdf_p", "dhr", "dhr_surface", "normalization_surface", "normalization_retro"]
# SHA-256 of DATASETS over the default grid, from PoCL 3.1 of Debian 12. Only a change that is meant to alter samples alters them.
DIGESTS = {
    "brown-vinyl": "7ad5c7bf68edecdf99cb5c50cab23034a0838879d65cf707347556abc8aee4b9",
    "yellow-retro-sheeting": "01054466858f760f91d0c92f90f4c3b8a5a71cf0160690a00f6a483964bed5f7",
}
COMMON = ["--theta-i", "20,70", "--theta-s", "0:88:4"]


class Identity(InFolder):
    def table(self, *options, material=MATERIALS / "garnet-red-paint.toml", **environment):
        file = self.folder / "table.h5"
        made = run("generate", material, "-o", file, "--force", "--polarization", "all", *options,
                   **environment)
        self.assertEqual(made.returncode, DONE, made.stderr)
        with h5py.File(file) as table:
            return {name: table[name][...] for name in DATASETS}

    def test_releases(self):
        """One digest for every release of the driver, the compiler and the libraries."""
        for name, expected in DIGESTS.items():
            with self.subTest(name):
                datasets = self.table(material=GOLDEN / f"{name}.toml")
                self.assertEqual(hashlib.sha256(b"".join(datasets[d].tobytes() for d in DATASETS)).hexdigest(), expected)

    def test_drivers_and_device_counts(self):
        if "pthread" not in run("devices").stdout:
            self.skipTest("takes PoCL's CPU drivers")
        grid = ["--theta-i", "0:80:10", "--phi-i", "0:350:10", "--theta-s", "0:88:2", "--phi-s", "0:360:1"]
        expected = self.table(*grid, POCL_DEVICES="pthread")
        for devices in ["basic", "pthread pthread", "basic pthread pthread"]:
            found = self.table(*grid, "--device", "all", POCL_DEVICES=devices)
            for name in DATASETS:
                self.assertEqual(found[name].tobytes(), expected[name].tobytes(), f"{name} on {devices}")

    def test_rows_that_repeat_equal_rows_evaluated(self):
        phi_s = ["--phi-s", "0:360:2.5"]
        together = self.table(*COMMON, "--phi-i=-90:270:45", *phi_s)
        for k, phi_i in enumerate(range(-90, 271, 45)):
            alone = self.table(*COMMON, f"--phi-i={phi_i}", *phi_s)
            for name in ["brdf", "brdf_s"]:
                numpy.testing.assert_array_equal(together[name][:, k], alone[name][:, 0])

    def test_decimal_steps_repeat_within_rounding(self):
        phi_s = ["--phi-s", "0:36:0.1"]
        together = self.table(*COMMON, "--phi-i", "0:9:0.3", *phi_s)["brdf"]
        alone = self.table(*COMMON, "--phi-i", "5.7", *phi_s)["brdf"]
        numpy.testing.assert_allclose(together[:, 19], alone[:, 0], rtol=1.2e-7)
