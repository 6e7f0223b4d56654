"""Draws what `brdftab bench --json` measured: bytes stored a second, and directions a second on a logarithmic scale.

usage: speed_picture.py BENCH.json OUTPUT.svg
"""

import json
import math
import sys

STORED = ["memset", "store", "dense", "store rows", "dense rows"]
COMPUTED = ["dense", "direct", "reference, all threads", "reference"]
WIDTH, LEFT, RIGHT, BAR, GAP = 760, 190, 90, 20, 8


def panel(top, title, rows, scale):
    """Bars of (name, length in 0..1, label, own), under a title; returns the parts and the height that they take."""
    parts = [f'<text x="{LEFT}" y="{top + 16}" font-size="15">{title}</text>']
    for k, (name, value, label, own) in enumerate(rows):
        y = top + 30 + k * (BAR + GAP)
        length = scale(value) * (WIDTH - LEFT - RIGHT)
        parts.append(f'<text x="{LEFT - 8}" y="{y + 15}" text-anchor="end">{name}</text>'
                     f'<rect x="{LEFT}" y="{y}" width="{length:.1f}" height="{BAR}" fill="{"#2a788e" if own else "#bbbbbb"}"/>'
                     f'<text x="{LEFT + length + 6:.1f}" y="{y + 15}">{label}</text>')
    return parts, 30 + len(rows) * (BAR + GAP) + 20


def draw(device):
    by_name = {work["name"]: work for work in device["workloads"]}
    stored = [(name, by_name[name]["bytes_per_second"] / 1e9) for name in STORED]
    computed = [(name, by_name[name]["per_second"]) for name in COMPUTED]
    most = max(rate for _, rate in stored)
    low, high = 4, math.ceil(math.log10(max(rate for _, rate in computed)))
    first, height = panel(12, "stored, GB/s", [(n, r, f"{r:.1f}", n.startswith("dense")) for n, r in stored], lambda r: r / most)
    second, more = panel(12 + height, "f at a direction, per second (logarithmic)",
                         [(n, r, f"{r:.2g}", not n.startswith("reference")) for n, r in computed],
                         lambda r: (math.log10(r) - low) / (high - low))
    total = 12 + height + more
    return "\n".join([f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {total}" font-family="sans-serif" font-size="13">',
                      f'<rect width="{WIDTH}" height="{total}" fill="white"/>', *first, *second, "</svg>", ""])


def main():
    source, output = sys.argv[1:]
    with open(source, encoding="utf-8") as file:
        measured = json.load(file)
    measured = measured.get("figures", measured)  # as bench/figures saves it, or as `brdftab bench` does
    with open(output, "w", encoding="utf-8") as file:
        file.write(draw(measured["devices"][0]))


if __name__ == "__main__":
    main()
