"""Draws the in-plane BRDF of a material, as Fig. 3 of Renhorn and Boreman (2008), from `brdftab evaluate`.

usage: in_plane_picture.py BRDFTAB MATERIAL.toml OUTPUT.svg
"""

import csv
import io
import math
import subprocess
import sys

INCIDENCES = [0, 20, 40, 60, 70, 80]
COLOURS = ["#440154", "#414487", "#2a788e", "#22a884", "#7ad151", "#d9a400"]
WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 760, 420, 70, 110, 40, 55


def evaluate(program, material):
    angles = [k / 4 for k in range(-352, 353)]
    text = "theta_i_deg,theta_s_deg,phi_deg\n" + "".join(f"{i},{s},0\n" for i in INCIDENCES for s in angles)
    result = subprocess.run([program, "evaluate", material], input=text, capture_output=True, text=True, check=True)
    curves = {i: [] for i in INCIDENCES}
    for row in csv.DictReader(io.StringIO(result.stdout)):
        curves[int(row["theta_i_deg"])].append((float(row["theta_s_deg"]), float(row["brdf"])))
    return curves


def draw(curves, title):
    values = [f for curve in curves.values() for _, f in curve]
    low, high = math.floor(math.log10(min(values))), math.ceil(math.log10(max(values)))

    def x(angle):
        return LEFT + (angle + 90) / 180 * (WIDTH - LEFT - RIGHT)

    def y(f):
        return TOP + (high - math.log10(f)) / (high - low) * (HEIGHT - TOP - BOTTOM)

    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif" font-size="13">',
             f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>',
             f'<text x="{LEFT}" y="24" font-size="15">{title}</text>']
    for angle in range(-90, 91, 30):
        parts.append(f'<line x1="{x(angle)}" x2="{x(angle)}" y1="{TOP}" y2="{HEIGHT - BOTTOM}" stroke="#ddd"/>'
                     f'<text x="{x(angle)}" y="{HEIGHT - BOTTOM + 18}" text-anchor="middle">{angle}</text>')
    for decade in range(low, high + 1):
        parts.append(f'<line x1="{LEFT}" x2="{WIDTH - RIGHT}" y1="{y(10.0 ** decade):.1f}" y2="{y(10.0 ** decade):.1f}" stroke="#ddd"/>'
                     f'<text x="{LEFT - 8}" y="{y(10.0 ** decade) + 4:.1f}" text-anchor="end">10<tspan dy="-5" font-size="10">{decade}</tspan></text>')
    for k, (incidence, curve) in enumerate(curves.items()):
        points = " ".join(f"{x(s):.2f},{y(f):.2f}" for s, f in curve)
        parts.append(f'<polyline points="{points}" fill="none" stroke="{COLOURS[k]}" stroke-width="1.8"/>')
        parts.append(f'<line x1="{WIDTH - RIGHT + 12}" x2="{WIDTH - RIGHT + 36}" y1="{TOP + 36 + 20 * k}" y2="{TOP + 36 + 20 * k}" '
                     f'stroke="{COLOURS[k]}" stroke-width="2"/><text x="{WIDTH - RIGHT + 42}" y="{TOP + 40 + 20 * k}">{incidence}°</text>')
    middle = (LEFT + WIDTH - RIGHT) / 2
    parts.append(f'<text x="{WIDTH - RIGHT + 12}" y="{TOP + 14}">incidence θ<tspan dy="3" font-size="10">i</tspan></text>')
    parts.append(f'<text x="{middle}" y="{HEIGHT - 12}" text-anchor="middle">scatter angle θ<tspan dy="3" font-size="10">s</tspan>'
                 '<tspan dy="-3" dx="4">in the plane of incidence, degrees (forward side positive)</tspan></text>')
    parts.append(f'<text transform="translate(20,{(TOP + HEIGHT - BOTTOM) / 2}) rotate(-90)" text-anchor="middle">BRDF, 1/sr</text>')
    return "\n".join(parts + ["</svg>", ""])


def main():
    program, material, output = sys.argv[1:]
    name = material.rsplit("/", 1)[-1].removesuffix(".toml").replace("-", " ")
    with open(output, "w", encoding="utf-8") as file:
        file.write(draw(evaluate(program, material), f"{name}, unpolarised"))


if __name__ == "__main__":
    main()
