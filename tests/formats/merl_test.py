"""MERL binary files, read by a parser of its own here, written from the format's description, not from the program."""

import math
import struct
import unittest

import scalar_reference
from program import VINYL
from written import PHI, THETA_I, THETA_S, Written, dot, golden, model_angles, unit

# From colour-science 0.4.7: XYZ of each band's share of the spectrum, 380:780:5 nm, under D65, Bradford-adapted to
# (0.3127, 0.3290), by the matrix of the Rec. 709 primaries; channels by bands 450, 550.5 and 650 nm.
SRGB_WEIGHTS_D65 = (
    (-0.10947099743995328, 0.2995304933621423, 0.809940504077812),
    (0.11792948850363294, 0.8465474051265709, 0.035523106369794194),
    (0.9969926893365887, 0.023695076053977696, -0.020687765390565972),
)


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
        return sum(scalar_reference.brdf(material, [model_angles(light, viewer), model_angles(viewer, light)])) / 2

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
        data = self.planes(self.generate("a.binary", material=scalar_reference.VINYL))
        cell = self.f(data, 0, int(math.sqrt(math.degrees(theta_h) * 90)), int(math.degrees(math.acos(dz))), int(phi_d))
        expected = (golden() + scalar_reference.brdf(scalar_reference.VINYL, [(THETA_S, THETA_I, PHI)])[0]) / 2
        self.assert_close(cell, expected, 1.3)

    def test_bands_are_linear_srgb(self):
        """Weights of the three bands under D65, from colour-science and its own tables, for f linear between bands."""
        data = self.planes(self.generate("a.binary", material=self.bands))
        h, d, phi = 20, 35, 40
        light, viewer = self.pair((h + 0.5) ** 2 / 90, d + 0.5, phi + 0.5)
        there, back = model_angles(light, viewer), model_angles(viewer, light)
        pairs = scalar_reference.brdf(self.bands, [there, back])
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


if __name__ == "__main__":
    unittest.main()
