#!/usr/bin/python3
"""Draws docs/rooms.svg: the rooms on their floors, and which room includes which, as the sources have it.

    rooms.py            writes the picture
    rooms.py --check    writes nothing; fails if the picture is not that of the sources

Floors come from the tables of ARCHITECTURE.md. An arrow is left out where a longer way of arrows leads to the same room.
"""

import pathlib
import re
import sys

PROJECT = pathlib.Path(__file__).resolve().parents[2]
PICTURE = PROJECT / "docs" / "rooms.svg"
WIDTH, ROW, BOX_HEIGHT, MARGIN = 920, 62, 26, 12
STYLE = """
text { font: 13px sans-serif; text-anchor: middle; fill: #1b2733; }
.floor { font-size: 11px; fill: #6b7885; text-anchor: start; }
rect { fill: #eef3f8; stroke: #6b8299; }
.ensemble rect { fill: #fdf3e4; stroke: #b08a4e; }
path { fill: none; stroke: #8a97a3; stroke-width: 1; }
.ground { fill: #ffffff; stroke: none; }
"""


def floors():
    """Room to floor, rooms in the order of the tables."""
    page = (PROJECT / "ARCHITECTURE.md").read_text(encoding="utf-8")
    return {room: int(floor) for floor, room in re.findall(r"^\| (\d+) \| `(\w+)` \|", page, re.M)}


def includes(rooms):
    """Room to the other rooms that its files include."""
    found = {room: set() for room in rooms}
    for top in ("src", "ensemble"):
        for file in sorted((PROJECT / top).rglob("*.[chi]*")):
            room = file.parent.name
            if room not in found:
                continue  # no source of a room
            others = re.findall(r'^#include "(\w+)/', file.read_text(encoding="utf-8"), re.M)
            found[room] |= {other for other in others if other in rooms and other != room}
    return found


def reachable(room, edges):
    seen, left = set(), [room]
    while left:
        for other in edges[left.pop()] - seen:
            seen.add(other)
            left.append(other)
    return seen


def direct(edges):
    """Edges without those that a longer way implies."""
    return {room: {other for other in others
                   if not any(other in reachable(between, edges) for between in others - {other})}
            for room, others in edges.items()}


def places(levels):
    """Room to the middle of its box."""
    rows = {}
    for room, floor in levels.items():
        rows.setdefault(floor, []).append(room)
    top = max(rows)
    middle = {}
    for floor, rooms in rows.items():
        for k, room in enumerate(rooms):
            x = 70 + (WIDTH - 70 - MARGIN) * (k + 0.5) / len(rooms)
            # Neighbouring floors are shifted against each other, so that lines do not run through boxes.
            middle[room] = (x + (28 if floor % 2 and len(rooms) < 6 else 0), MARGIN + 16 + (top - floor) * ROW)
    return middle


def draw():
    levels = floors()
    edges = direct(includes(levels))
    at = places(levels)
    height = MARGIN * 2 + 32 + max(levels.values()) * ROW
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" width="{WIDTH}" height="{height}" '
             'role="img" aria-label="The rooms on their floors and what each includes">', f"<style>{STYLE}</style>",
             f'<rect class="ground" width="{WIDTH}" height="{height}"/>']
    for room in levels:
        for other in sorted(edges[room]):
            (x, y), (x_below, y_below) = at[room], at[other]
            y, y_below = y + BOX_HEIGHT / 2, y_below - BOX_HEIGHT / 2
            bend = (y_below - y) / 2
            lines.append(f'<path d="M{x:.0f} {y:.0f}C{x:.0f} {y + bend:.0f} {x_below:.0f} {y_below - bend:.0f} '
                         f'{x_below:.0f} {y_below:.0f}"/>')
    for floor in sorted(set(levels.values())):
        y = MARGIN + 20 + (max(levels.values()) - floor) * ROW
        lines.append(f'<text class="floor" x="{MARGIN}" y="{y}">floor {floor}</text>')
    for room in levels:
        x, y = at[room]
        width = 9 * len(room) + 18
        kind = "src" if (PROJECT / "src" / room).is_dir() else "ensemble"
        lines.append(f'<g class="{kind}"><rect x="{x - width / 2:.0f}" y="{y - BOX_HEIGHT / 2:.0f}" width="{width}" '
                     f'height="{BOX_HEIGHT}" rx="5"/><text x="{x:.0f}" y="{y + 5:.0f}">{room}</text></g>')
    return "\n".join(lines) + "\n</svg>\n"


def main(arguments):
    if arguments == ["--check"]:
        if PICTURE.read_text(encoding="utf-8") != draw():
            sys.exit("docs/rooms.svg is not that of the sources; run docs/figures/rooms.py")
        return
    PICTURE.write_text(draw(), encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])
