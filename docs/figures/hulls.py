#!/usr/bin/python3
"""The pictures of docs/structures.md, and docs/hulls/platform.stl.

Usage: hulls.py FLOES             (some minutes)
       hulls.py FLOES --pieces    (writes configs/validation/hull_pieces.toml)
"""
import math
import pathlib
import subprocess
import sys
import tempfile

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "hulls"
PIECES = FOLDER.parent.parent / "configs" / "validation" / "hull_pieces.toml"

SCENE = """
[campaign]
seed = 3
arrangements = 1
[field]
floes = 40
concentration_percent = 70.0
begin_m = 2.0
half_width_m = 1.6
sheet_width_m = 1.0
far_end = "ice_sheet"
[structure]
start_m = {start}
speed_m_s = 0.1
[analysis]
steady_start_s = 8.0
window_s = 14.0
segments = 2
[hull]
{hull}
"""

SHIP = "length_m = 2.0\nbeam_m = 0.8\ndraught_m = 0.25\nfreeboard_m = 0.15\n"
HULLS = {
    "cylinder": ("diameter_m = 1.0\ndraught_m = 0.4\nfreeboard_m = 0.2", 0.5),
    "cone_up": ("diameter_m = 1.0\nwall_deg = 60.0\ndraught_m = 0.4\nfreeboard_m = 0.2", 0.5),
    "cone_down": ("diameter_m = 1.0\nwall_deg = 60.0\ndraught_m = 0.4\nfreeboard_m = 0.2", 0.5),
    "four_legs": ("diameter_m = 0.35\nspacing_m = 1.1\ndraught_m = 0.4\nfreeboard_m = 0.2", 0.725),
    "wedge_bow": (SHIP + "stem_deg = 45.0\nentrance_deg = 35.0\nflare_deg = 75.0", 1.0),
    "drillship": (SHIP + "stem_deg = 60.0\nentrance_deg = 35.0", 1.0),
    "barge": (SHIP + "stem_deg = 45.0", 1.0),
}


def run(floes, folder, name, text, *options):
    config = folder / f"{name}.toml"
    config.write_text(text)
    output = folder / f"{name}.h5"
    subprocess.run([floes, "run", config, "-o", output, *options], check=True, capture_output=True)
    return output


def pictures(floes):
    FOLDER.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        for name, (sizes, ahead) in HULLS.items():
            campaign = run(floes, folder, name, SCENE.format(start=1.98 - ahead, hull=f'shape = "{name}"\n{sizes}'))
            subprocess.run([floes, "replay", campaign, "--worst", "-o", FOLDER / f"{name}.png", "--size", "640x400"],
                           check=True, capture_output=True)


def prism(name, outline, low, high):
    """An STL solid over a convex outline in (x, y), from z = low to high."""
    def facet(a, b, c):
        corners = "".join(f"  vertex {x:.6g} {y:.6g} {z:.6g}\n" for x, y, z in (a, b, c))
        return f" facet normal 0 0 0\n  outer loop\n{corners}  endloop\n endfacet\n"

    text = f"solid {name}\n"
    for k in range(1, len(outline) - 1):
        a, b, c = outline[0], outline[k], outline[k + 1]
        text += facet((*a, low), (*c, low), (*b, low)) + facet((*a, high), (*b, high), (*c, high))
    for a, b in zip(outline, outline[1:] + outline[:1]):
        text += facet((*a, low), (*b, low), (*b, high)) + facet((*a, low), (*b, high), (*a, high))
    return text + f"endsolid {name}\n"


def platform():
    """A platform of two pontoons and four columns in m, z up from the keel, 15 m of draught wanted."""
    def ring(x, y, radius):
        return [(x + radius * math.cos(math.pi * k / 12), y + radius * math.sin(math.pi * k / 12)) for k in range(24)]

    text = ""
    for y, side in ((-25, "starboard"), (25, "port")):
        text += prism(f"{side} pontoon", [(-40, y - 7), (40, y - 7), (40, y + 7), (-40, y + 7)], 0, 6)
        for x, end in ((-25, "aft"), (25, "fore")):
            text += prism(f"{end} {side} column", ring(x, y, 6), 6, 25)
    (FOLDER / "platform.stl").write_text(text)


CUTS = """# The same flare and the same straight cone as a body of revolution and in pieces, cut at the waterline into rings of 25
# sides or each ring into 25 wedges: docs/structures.md. Made by docs/figures/hulls.py. 12 arrangements each.

[campaign]
seed = 1
arrangements = 12

[ice]
elastic_modulus_MPa = 60.0

[field]
floes = 24
concentration_percent = 75.0
begin_m = 2.0
half_width_m = 1.25
far_end = "ice_sheet"

[structure]
start_m = 1.38
speed_m_s = 0.1

[analysis]
steady_start_s = 8.0
window_s = 18.0
segments = 3
"""

FLARE = [(-0.443, 0.43), (0.0, 0.614), (0.122, 0.736)]
STRAIGHT = [(-0.443, 0.171), (0.0, 0.614), (0.122, 0.736)]


def cut(profile, sides, wedges):
    """Rows of hull.pieces of a profile, a piece for each step of it, or for each side of that."""
    def corner(piece, height, radius, side):
        angle = 2 * math.pi * side / sides
        return [piece, 0, round(radius * math.cos(angle), 9), height, round(radius * math.sin(angle), 9)]

    rows = []
    for step, ends in enumerate(zip(profile, profile[1:])):
        for side in range(sides):
            piece = step * sides + side if wedges else step
            for height, radius in ends:
                if wedges:
                    rows += [[piece, 0, 0.0, height, 0.0], corner(piece, height, radius, side)]
                rows.append(corner(piece, height, radius, side + 1))
    return rows


def pieces():
    text = CUTS
    for name, profile in (("flare", FLARE), ("straight", STRAIGHT)):
        text += f'\n[[case]]\nname = "{name}_cone"\nstructure.profile_m = {[list(one) for one in profile]}\n'
        whole = [profile[0], profile[-1]]
        kinds = {"flare": {"rings": (profile, False), "wedges": (profile, True)},
                 "straight": {"one_piece": (whole, False), "rings": (profile, False)}}[name]
        for kind, (outline, wedges) in kinds.items():
            rows = ",\n    ".join(map(str, cut(outline, 25, wedges)))
            text += (f'\n[[case]]\nname = "{name}_{kind}"\nhull.shape = "file"\nhull.parts = "hull"\n'
                     f"hull.pieces = [\n    {rows}]\n")
    PIECES.write_text(text)


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3) or sys.argv[2:] not in ([], ["--pieces"]):
        sys.exit(__doc__)
    if len(sys.argv) == 3:
        pieces()
    else:
        platform()
        pictures(sys.argv[1])
