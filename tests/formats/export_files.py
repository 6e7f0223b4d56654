"""Rewrites the values of simulators' files, for tests that falsify them.

`rewrite(file, change)` puts change(theta_i, theta_s, channel, f) in the place of every f of a file, found by its name's suffix.
Angles are numpy arrays in degrees, theta_i nan where the format tells of theta_s alone; channels are counted from 0.
"""

import json
import re

import h5py
import numpy

import rgl_file

KLEMS_THETA = numpy.repeat([0, 10, 20, 30, 40, 50, 60, 70, 82.5], [1, 8, 16, 20, 24, 24, 24, 16, 12])


def rewrite(file, change):
    {"csv": csv, "astm": astm, "ssdd": ssdd, "bsdf": zemax, "json": bird, "xompt": openmaterial, "nc": eradiate, "binary": merl,
     "klems": klems, "tree": tree, "rgl": rgl}[file.suffix[1:]](file, change)


def text(values):
    return [f"{value:.9g}" for value in values]


def csv(file, change):
    lines = file.read_text().splitlines()
    start = next(k for k, line in enumerate(lines) if not line.startswith("#"))
    names = lines[start].split(",")
    rows = numpy.array([line.split(",") for line in lines[start + 1:]], float)
    theta_i, theta_s = (rows[:, names.index(name)] for name in ("theta_i_deg", "theta_s_deg"))
    first = names.index("brdf_s")
    bands = numpy.unique(rows[:, 0], return_inverse=True)[1] if names[0] == "wavelength_nm" else numpy.zeros(len(rows), int)
    for column in range(first, first + 3):
        for band in set(bands):
            at = bands == band
            rows[at, column] = change(theta_i[at], theta_s[at], band, rows[at, column])
    rows = [",".join([*map(repr, map(float, row[:first])), *text(row[first:])]) for row in rows]
    file.write_text("\n".join(lines[:start + 1] + rows) + "\n")


def astm(file, change):
    head, mark, rest = file.read_text().partition("\nVARS ")
    names, *lines = rest.strip().split("\n")
    cells = [line.split(",") for line in lines]
    rows = numpy.array(cells, float)
    for c in range(4, rows.shape[1]):
        rows[:, c] = change(numpy.degrees(rows[:, 0]), numpy.degrees(rows[:, 2]), c - 4, rows[:, c])
    file.write_text(head + mark + "\n".join([names] + [",".join(a[:4] + text(row[4:])) for a, row in zip(cells, rows)]) + "\n")


def ssdd(file, change):
    head, mark, data = file.read_text().partition("DATA ascii\n")
    axes = [numpy.array(re.search(rf"^PARAM{k}_LIST (.*)$", head, re.MULTILINE).group(1).split(), float) for k in (0, 2, 3)]
    values = numpy.array([line.split() for line in data.strip().split("\n")], float).reshape(*map(len, reversed(axes)), -1)
    for c in range(values.shape[3]):
        values[..., c] = change(axes[0][None, None, :], axes[1][None, :, None], c, values[..., c])
    file.write_text(head + mark + "\n".join(" ".join(text(row)) for row in values.reshape(-1, values.shape[3])) + "\n")


def zemax(file, change):
    lines = file.read_text().splitlines()
    axes = {name: numpy.array(lines[k + 1].split(), float) for k, line in enumerate(lines)
            for name in ("AngleOfIncidence", "ScatterAzimuth", "ScatterRadial") if line.startswith(name)}
    radial = numpy.radians(axes["ScatterRadial"])
    channel, incidence, row = -1, 0, 0
    for k, line in enumerate(lines):
        if line == "DataBegin":
            channel, incidence = channel + 1, -1
        elif line.startswith("TIS"):
            incidence, row = incidence + 1, 0
        elif channel >= 0 and line[:1].isdigit():
            theta_i, azimuth = numpy.radians(axes["AngleOfIncidence"][incidence]), numpy.radians(axes["ScatterAzimuth"][row])
            cosine = numpy.cos(theta_i) * numpy.cos(radial) + numpy.sin(theta_i) * numpy.sin(radial) * numpy.cos(azimuth)
            theta_s = numpy.degrees(numpy.arccos(numpy.clip(cosine, -1, 1)))
            lines[k] = "\t".join(text(change(numpy.degrees(theta_i), theta_s, channel, numpy.array(line.split(), float))))
            row += 1
    file.write_text("\n".join(lines) + "\n")


def bird(file, change):
    content = json.loads(file.read_text())
    data = {name: entry["values"] for name, entry in content["data"].items()}
    bands = numpy.unique(data["wavelength_i"], return_inverse=True)[1] if "wavelength_i" in data else [0] * len(data["BRDF"])
    content["data"]["BRDF"]["values"] = [float(change(numpy.float64(i), numpy.float64(r), c, f)) for i, r, c, f in
                                         zip(data["theta_i"], data["theta_r"], bands, data["BRDF"])]
    file.write_text(json.dumps(content))


def openmaterial(file, change):
    content = json.loads(file.read_text())
    table = content["brdf"]["lookupTable"]
    bands = {wavelength: k for k, wavelength in enumerate(sorted({row[0] for row in table}, key=lambda w: w or 0))}
    for row in table:
        row[4] = float(change(numpy.degrees(row[1]), numpy.degrees(row[2]), bands[row[0]], row[4]))
    file.write_text(json.dumps(content))


def eradiate(file, change):
    with h5py.File(file, "r+") as content:
        theta_o, theta_i = (numpy.degrees(numpy.arccos(content[name][...])) for name in ("cos_theta_o", "cos_theta_i"))
        content["brdf"][...] = change(theta_i[None, None, :], theta_o[:, None, None], 0, content["brdf"][...])


def merl(file, change):
    data = bytearray(file.read_bytes())
    values = numpy.frombuffer(data, float, offset=12).reshape(3, 90, 90, 180)
    h, d, phi = numpy.meshgrid((numpy.arange(90) + 0.5)**2 / 90, numpy.arange(90) + 0.5, numpy.arange(180) + 0.5, indexing="ij")
    h, d, phi = (numpy.radians(angle) for angle in (h, d, phi))
    level, swing = numpy.cos(h) * numpy.cos(d), numpy.sin(h) * numpy.sin(d) * numpy.cos(phi)
    theta_i, theta_s = (numpy.degrees(numpy.arccos(numpy.clip(level + sign * swing, -1, 1))) for sign in (-1, 1))
    for c in range(3):
        values[c] = numpy.where(values[c] >= 0, change(theta_i, theta_s, c, values[c]), values[c])
    file.write_bytes(data)


def klems(file, change):
    channel = -1

    def changed(match):
        nonlocal channel
        channel += 1
        matrix = numpy.array(match.group(1).split(), float).reshape(145, 145)
        matrix = change(KLEMS_THETA[None, :], KLEMS_THETA[:, None], channel, matrix)
        return "<ScatteringData>\n" + "\n".join(" ".join(text(row)) for row in matrix) + "\n</ScatteringData>"

    file.write_text(re.sub(r"<ScatteringData>(.*?)</ScatteringData>", changed, file.read_text(), flags=re.DOTALL))


def tree(file, change):
    whole = file.read_text()
    start, end = whole.index("<ScatteringData>") + 16, whole.index("</ScatteringData>")
    tokens = whole[start:end].replace("{", " { ").replace("}", " } ").split()
    places, at = {}, 0  # of each number's token: the cell's corner and size

    def node(corner, size):
        nonlocal at
        at += 1
        corners = [[corner[d] + (k >> d & 1) * size / 2 for d in range(3)] for k in range(8)]
        if tokens[at] == "{":
            for k in range(8):
                node(corners[k], size / 2)
        elif tokens[at + 1] == "}":
            places[at], at = (corner, size), at + 1
        else:
            for k in (0, 4, 2, 6, 1, 5, 3, 7):
                places[at], at = (corners[k], size / 2), at + 1
        at += 1

    node([0, 0, 0], 1)
    centres = numpy.array([[x + size / 2 for x in corner] for corner, size in places.values()])
    theta_i = numpy.degrees(numpy.arcsin(numpy.clip(1 - 2 * centres[:, 0], 0, 1)))
    theta_s = numpy.degrees(numpy.arcsin(numpy.abs(2 * centres[:, 1:] - 1).max(axis=1)))
    values = change(theta_i, theta_s, 0, numpy.array([tokens[k] for k in places], float))
    for k, value in zip(places, text(values)):
        tokens[k] = value
    file.write_text(whole[:start] + " ".join(tokens) + whole[end:])


def rgl(file, change):
    fields, offsets = rgl_file.read(file)
    name = "rgb" if "rgb" in fields else "spectra"
    values = fields[name].copy()  # f cos(theta_i) and factors that a change of f leaves
    theta_s = numpy.degrees(fields["theta_i"])
    for c in range(values.shape[2]):
        values[0, :, c] = change(numpy.nan, theta_s[:, None, None], c, values[0, :, c])
    data = bytearray(file.read_bytes())
    data[offsets[name]:offsets[name] + values.nbytes] = values.astype("float32").tobytes()
    file.write_bytes(data)
