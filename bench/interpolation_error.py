"""Tables chosen by --interpolation-error, measured at 10,000 random directions between their nodes, by numpy.

usage: python3 bench/interpolation_error.py BRDFTAB ERROR MATERIAL...

One line a material: nodes of the table; the largest error of linear interpolation relative to max(f, 0.01 x the slice's peak),
where f is `brdftab evaluate`'s and the peak the largest sample of the slice at the node of theta_i below; and where.
"""

import pathlib
import subprocess
import sys
import tempfile

import h5py
import numpy

FLOOR = 0.01
AXES = ("theta_i", "phi_i", "theta_s", "phi_s")


def interpolated(samples, axes, points):
    """Linear between the nodes of all axes that have more than one; samples[theta_i][phi_i][theta_s][phi_s]."""
    result = numpy.zeros(len(points[0]))
    cells = []
    for axis, x in zip(axes, points):
        low = numpy.clip(numpy.searchsorted(axis, x, side="right") - 1, 0, max(len(axis) - 2, 0))
        high = numpy.minimum(low + 1, len(axis) - 1)
        weight = (x - axis[low]) / numpy.where(high > low, axis[high] - axis[low], 1)
        cells.append(((low, 1 - weight), (high, weight)))
    for corner in numpy.ndindex(2, 2, 2, 2):
        index, weights = zip(*(cell[k] for cell, k in zip(cells, corner)))
        result += numpy.prod(weights, axis=0) * samples[index]
    return result


def measure(program, error, material, count=10_000, seed=7):
    """nodes, the errors at random directions, their angles, and the attributes of the table."""
    with tempfile.TemporaryDirectory() as folder:
        table = pathlib.Path(folder) / "table.h5"
        subprocess.run([program, "generate", "-q", material, "-o", table, "--interpolation-error", error], check=True)
        with h5py.File(table) as file:
            axes = [file[name][:] for name in AXES]
            samples = file["brdf"][...]
            attributes = dict(file.attrs)
    random = numpy.random.default_rng(seed)
    points = [random.uniform(axis[0], axis[-1], count) for axis in axes]
    pairs = "theta_i_deg,theta_s_deg,phi_deg\n" + "".join(
        f"{i!r},{s!r},{q - p!r}\n" for i, p, s, q in zip(*(x.tolist() for x in points)))
    text = subprocess.run([program, "evaluate", material], input=pairs, capture_output=True, text=True, check=True).stdout
    f = numpy.array([float(line.split(",")[5]) for line in text.splitlines() if line[0].isdigit()])
    peak = samples.max(axis=(1, 2, 3))[numpy.searchsorted(axes[0], points[0], side="right") - 1]
    errors = abs(interpolated(samples, axes, points) - f) / numpy.maximum(f, FLOOR * peak)
    return samples.size, errors, points, attributes


def main():
    program, error, *materials = sys.argv[1:]
    for material in materials:
        nodes, errors, points, attributes = measure(program, error, material)
        worst = errors.argmax()
        where = ", ".join(f"{name} = {x[worst]:.3f}" for name, x in zip(AXES, points))
        print(f"{pathlib.Path(material).stem}: asked {error}: {nodes} nodes; largest error at {len(errors)} random directions "
              f"{errors[worst]:.4f} at {where}; 95 % {numpy.quantile(errors, 0.95):.4f}; the table says "
              f"{attributes['interpolation_error_reached']:.4f}", flush=True)


if __name__ == "__main__":
    main()
