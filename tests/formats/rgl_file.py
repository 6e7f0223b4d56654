"""A reader of RGL .bsdf files, written from the format's description and not from the program: header, tables, and f as
Mitsuba 3, pbrt-v4 and powitacq make it from them. Isotropic files only."""

import math
import struct

import numpy

TYPES = {1: numpy.uint8, 10: numpy.float32}


def read(path):
    """The fields of a tensor file, by name, and where each begins."""
    data = path.read_bytes()
    if data[:12] != b"tensor_file\0" or data[12:14] != b"\1\0":
        raise ValueError("no tensor file of version 1.0")
    (count,) = struct.unpack_from("<I", data, 14)
    at, fields, offsets = 18, {}, {}
    for _ in range(count):
        (length,) = struct.unpack_from("<H", data, at)
        name = data[at + 2:at + 2 + length].decode()
        dimensions, kind, offset = struct.unpack_from("<HBQ", data, at + 2 + length)
        at += 2 + length + 11
        shape = struct.unpack_from(f"<{dimensions}Q", data, at)
        at += 8 * dimensions
        fields[name] = numpy.frombuffer(data, TYPES[kind], math.prod(shape), offset).reshape(shape)
        offsets[name] = offset
    return fields, offsets


def vector(theta, phi):
    """A unit vector away from the surface, from degrees; [3, ...]."""
    theta, phi = numpy.broadcast_arrays(numpy.radians(theta), numpy.radians(phi))
    return numpy.array([numpy.sin(theta) * numpy.cos(phi), numpy.sin(theta) * numpy.sin(phi), numpy.cos(theta)])


def angles(v):
    """Polar angle and azimuth, degrees."""
    return numpy.degrees(numpy.arctan2(numpy.hypot(v[0], v[1]), v[2])), numpy.degrees(numpy.arctan2(v[1], v[0]))


def model_angles(viewer, light):
    """theta_i, theta_s and phi of the model, degrees: phi is 0 where the viewer is opposite to the light."""
    (theta_i, phi_light), (theta_s, phi_viewer) = angles(light), angles(viewer)
    return theta_i, theta_s, (phi_viewer - phi_light - 180) % 360


class Rgl:
    def __init__(self, path):
        self.fields, self.offsets = read(path)
        self.theta_i = self.fields["theta_i"].astype(float)
        self.vndf = self.fields["vndf"][0].astype(float)
        rows, columns = self.vndf.shape[1:]
        # These are cumulative integrals of the density: along each row, and of whole rows.
        along = numpy.cumsum((self.vndf[:, :, 1:] + self.vndf[:, :, :-1]) / (2 * (columns - 1)), axis=2)
        self.along = numpy.concatenate([numpy.zeros_like(along[:, :, :1]), along], axis=2)
        whole = self.along[:, :, -1]
        down = numpy.cumsum((whole[:, 1:] + whole[:, :-1]) / (2 * (rows - 1)), axis=1)
        self.down = numpy.concatenate([numpy.zeros_like(down[:, :1]), down], axis=1)
        total = self.down[:, -1].copy()
        self.vndf /= total[:, None, None]
        self.along /= total[:, None, None]
        self.down /= total[:, None]
        self.s = self.fields["rgb" if "rgb" in self.fields else "spectra"][0].astype(float)

    @staticmethod
    def bilinear(table, at, x, y):
        """table[at] at a point of the unit square."""
        rows, columns = table.shape[-2:]
        r = numpy.clip((y * (rows - 1)).astype(int), 0, rows - 2)
        c = numpy.clip((x * (columns - 1)).astype(int), 0, columns - 2)
        u, v = x * (columns - 1) - c, y * (rows - 1) - r
        return ((1 - v) * ((1 - u) * table[*at, r, c] + u * table[*at, r, c + 1])
                + v * ((1 - u) * table[*at, r + 1, c] + u * table[*at, r + 1, c + 1]))

    def evaluate(self, viewer, light, channel=0):
        """f, 1/sr, from unit vectors [3, n]."""
        half = viewer + light
        half /= numpy.linalg.norm(half, axis=0)
        (theta_v, phi_v), (theta_m, phi_m) = angles(viewer), angles(half)
        x, y = numpy.sqrt(theta_m / 90), ((phi_m - phi_v + 180) / 360) % 1
        k = numpy.clip(numpy.searchsorted(self.theta_i, numpy.radians(theta_v), side="right") - 1, 0, len(self.theta_i) - 2)
        w = numpy.clip((numpy.radians(theta_v) - self.theta_i[k]) / (self.theta_i[k + 1] - self.theta_i[k]), 0, 1)

        def mixed(table, *index):
            return (1 - w) * table[(k, *index)] + w * table[(k + 1, *index)]

        rows, columns = self.vndf.shape[1:]
        r = numpy.minimum((y * (rows - 1)).astype(int), rows - 2)
        c = numpy.minimum((x * (columns - 1)).astype(int), columns - 2)
        u, v = x * (columns - 1) - c, y * (rows - 1) - r
        left, right = [(1 - v) * mixed(self.vndf, r, c + d) + v * mixed(self.vndf, r + 1, c + d) for d in (0, 1)]
        before = (1 - v) * mixed(self.along, r, c) + v * mixed(self.along, r + 1, c)
        row, next_row = mixed(self.along, r, -1), mixed(self.along, r + 1, -1)
        s_x = (before + (u * left + u * u * (right - left) / 2) / (columns - 1)) / ((1 - v) * row + v * next_row)
        s_y = mixed(self.down, r) + (v * row + v * v * (next_row - row) / 2) / (rows - 1)
        s = (1 - w) * self.bilinear(self.s, (k, channel), s_x, s_y) + w * self.bilinear(self.s, (k + 1, channel), s_x, s_y)
        return s * self.scale(x, y, theta_v) / light[2]

    def scale(self, x, y, theta_v):
        d = self.bilinear(self.fields["ndf"].astype(float), (), x, y)
        return d / (4 * self.bilinear(self.fields["sigma"].astype(float), (), numpy.sqrt(theta_v / 90), 0.5 + 0 * x))

    def nodes(self, k):
        """The light directions of the nodes of s at the k-th theta_i, as the forward warp has them, and f cos(theta_o) there
        by channel; the viewer is at azimuth 0. [3, node], [channel, node]."""
        n = self.s.shape[-1]
        rows, columns = self.vndf.shape[1:]
        grid = numpy.arange(n) / (n - 1)
        places = []
        for s_y in grid:
            r = min(max(numpy.searchsorted(self.down[k], s_y, side="right") - 1, 0), rows - 2)
            row, next_row = self.along[k, r, -1], self.along[k, r + 1, -1]
            v = self.root((s_y - self.down[k, r]) * (rows - 1), row, next_row)
            along = (1 - v) * self.along[k, r] + v * self.along[k, r + 1]
            density = (1 - v) * self.vndf[k, r] + v * self.vndf[k, r + 1]
            for s_x in grid:
                c = min(max(numpy.searchsorted(along, s_x * along[-1], side="right") - 1, 0), columns - 2)
                u = self.root((s_x * along[-1] - along[c]) * (columns - 1), density[c], density[c + 1])
                places.append(((c + u) / (columns - 1), (r + v) / (rows - 1)))
        x, y = numpy.array(places).T
        theta_v = math.degrees(self.theta_i[k])
        half, viewer = vector(90 * x * x, 360 * y - 180), vector(theta_v, 0)
        cosine = half.T @ viewer
        values = self.s[k].reshape(self.s.shape[1], -1) * self.scale(x, y, theta_v)
        return 2 * cosine * half - viewer[:, None], values

    @staticmethod
    def root(area, v0, v1):
        """Where the integral of a density that goes from v0 to v1 reaches an area."""
        below = v0 + math.sqrt(max(v0 * v0 + 2 * area * (v1 - v0), 0))
        return min(max(2 * area / below, 0), 1) if below > 0 else 0
