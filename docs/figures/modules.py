#!/usr/bin/python3
"""Draws docs/modules.svg: the modules in their layers, and which uses which, as CMakeLists.txt declares it.

    modules.py            writes the picture
    modules.py --check    writes nothing; fails if the picture is not that of CMakeLists.txt

An arrow is left out where a longer way of arrows leads to the same module.
"""

import pathlib
import sys

PROJECT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(PROJECT / "tests" / "layers"))
sys.dont_write_bytecode = True
import layers  # noqa: E402

PICTURE = PROJECT / "docs" / "modules.svg"
WIDTH, ROW, BOX_HEIGHT, MARGIN = 760, 58, 26, 12
STYLE = """
text { font: 13px sans-serif; text-anchor: middle; fill: #1b2733; }
.layer { font-size: 11px; fill: #6b7885; text-anchor: start; }
rect { fill: #eef3f8; stroke: #6b8299; }
.ensemble rect { fill: #fdf3e4; stroke: #b08a4e; }
path { fill: none; stroke: #8a97a3; stroke-width: 1; }
.ground { fill: #ffffff; stroke: none; }
"""


def reachable(name, edges):
    seen, left = set(), [name]
    while left:
        for other in edges[left.pop()] - seen:
            seen.add(other)
            left.append(other)
    return seen


def direct(edges):
    """Edges without those that a longer way implies."""
    return {name: {other for other in others
                   if not any(other in reachable(between, edges) for between in others - {other})}
            for name, others in edges.items()}


def places(levels):
    """Name to the middle of its box."""
    rows = {}
    for name, level in levels.items():
        rows.setdefault(level, []).append(name)
    top, middle = max(rows), {}
    for level, names in rows.items():
        for k, name in enumerate(names):
            x = 70 + (WIDTH - 70 - MARGIN) * (k + 0.5) / len(names)
            # Layers of one or two are shifted in turn, so that lines do not run through boxes.
            shift = (60 if level % 2 else -60) if len(names) < 3 else 0
            middle[name] = (x + shift, MARGIN + 16 + (top - level) * ROW)
    return middle


def draw():
    modules = layers.declared((PROJECT / "CMakeLists.txt").read_text(encoding="utf-8"))
    levels = layers.layers(modules)
    edges = direct({name: module.uses for name, module in modules.items()})
    at, top = places(levels), max(levels.values())
    height = MARGIN * 2 + 32 + top * ROW
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" width="{WIDTH}" height="{height}" '
             'role="img" aria-label="The modules in their layers and what each uses">', f"<style>{STYLE}</style>",
             f'<rect class="ground" width="{WIDTH}" height="{height}"/>']
    for name in levels:
        for other in sorted(edges[name]):
            (x, y), (x_below, y_below) = at[name], at[other]
            y, y_below = y + BOX_HEIGHT / 2, y_below - BOX_HEIGHT / 2
            bend = (y_below - y) / 2
            lines.append(f'<path d="M{x:.0f} {y:.0f}C{x:.0f} {y + bend:.0f} {x_below:.0f} {y_below - bend:.0f} '
                         f'{x_below:.0f} {y_below:.0f}"/>')
    for level in range(top + 1):
        lines.append(f'<text class="layer" x="{MARGIN}" y="{MARGIN + 20 + (top - level) * ROW}">layer {level}</text>')
    for name in levels:
        x, y = at[name]
        width = 9 * len(name) + 18
        lines.append(f'<g class="{modules[name].folder.split("/")[0]}"><rect x="{x - width / 2:.0f}" '
                     f'y="{y - BOX_HEIGHT / 2:.0f}" width="{width}" height="{BOX_HEIGHT}" rx="5"/>'
                     f'<text x="{x:.0f}" y="{y + 5:.0f}">{name}</text></g>')
    return "\n".join(lines) + "\n</svg>\n"


def main(arguments):
    if arguments == ["--check"]:
        if PICTURE.read_text(encoding="utf-8") != draw():
            sys.exit("docs/modules.svg is not that of CMakeLists.txt; run docs/figures/modules.py")
        return
    PICTURE.write_text(draw(), encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])
