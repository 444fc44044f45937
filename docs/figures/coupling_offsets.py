#!/usr/bin/python3
"""Draws docs/coupling/offsets.svg: the offset of one hull, moved inside an FMU and outside, from docs/coupling/offsets.csv,
which docs/coupling/mass_on_a_spring.py writes.

    coupling_offsets.py            writes the picture
    coupling_offsets.py --check    writes nothing; fails if the picture is not that of the numbers
"""

import csv
import pathlib
import sys

FOLDER = pathlib.Path(__file__).resolve().parents[1] / "coupling"
WIDTH, HEIGHT, LEFT, BOTTOM, TOP = 760, 300, 60, 40, 16
STYLE = """
text { font: 13px sans-serif; fill: #1b2733; }
.grid { stroke: #dde3e9; }
.inside { fill: none; stroke: #2b6cb0; stroke-width: 2; }
.outside { fill: none; stroke: #c05621; stroke-width: 1.3; }
.ground { fill: #ffffff; }
"""


def draw():
    with open(FOLDER / "offsets.csv", encoding="utf-8") as file:
        rows = [[float(value) for value in row] for row in list(csv.reader(file))[1:]]
    offsets = [-value for row in rows for value in row[1:]]
    most, least = 1.05 * max(offsets), 1.05 * min(offsets)
    end = rows[-1][0]

    def place(time, offset):
        return (LEFT + (WIDTH - LEFT - 10) * time / end, HEIGHT - BOTTOM - (HEIGHT - BOTTOM - TOP) * (offset - least) / (most - least))

    step = next(width for width in (0.01, 0.02, 0.05, 0.1, 0.2, 0.5) if (most - least) / width < 8)
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}" '
             'role="img" aria-label="The offset of a hull, moved inside and outside an FMU">', f"<style>{STYLE}</style>",
             f'<rect class="ground" width="{WIDTH}" height="{HEIGHT}"/>']
    for k in range(int(least / step), int(most / step) + 1):
        x, y = place(0, k * step)
        lines += [f'<line class="grid" x1="{x:.1f}" y1="{y:.1f}" x2="{WIDTH - 10}" y2="{y:.1f}"/>',
                  f'<text x="{x - 6:.1f}" y="{y + 4:.1f}" text-anchor="end">{1e3 * k * step:.0f}</text>']
    for time in range(0, int(end) + 1, 10):
        x, y = place(time, least)
        lines.append(f'<text x="{x:.1f}" y="{y + 18:.1f}" text-anchor="middle">{time}</text>')
    for column, kind in ((1, "inside"), (2, "outside")):
        points = " ".join("{:.1f},{:.1f}".format(*place(row[0], -row[column])) for row in rows)
        lines.append(f'<polyline class="{kind}" points="{points}"/>')
        y = TOP + 16 * column
        lines += [f'<line class="{kind}" x1="{LEFT + 14}" y1="{y - 4}" x2="{LEFT + 44}" y2="{y - 4}"/>',
                  f'<text x="{LEFT + 50}" y="{y}">moved {kind}</text>']
    lines += [f'<text x="{WIDTH - 10}" y="{HEIGHT - 6}" text-anchor="end">time, s</text>',
              f'<text x="6" y="{TOP + 4}">mm</text>', "</svg>"]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    picture = FOLDER / "offsets.svg"
    if "--check" in sys.argv[1:]:
        if picture.read_text(encoding="utf-8") != draw():
            sys.exit(f"{picture} is not drawn from offsets.csv; run {sys.argv[0]}")
    else:
        picture.write_text(draw(), encoding="utf-8")
