#!/usr/bin/python3
"""configs/gallery/traced.geojson: outlines as somebody would trace them from a photograph. It is none: each is a circle
with waves of two, three and five to the round, some of which bend inwards.

Usage: traced.py      writes the file anew
"""
import json
import math
import pathlib

FILE = pathlib.Path(__file__).resolve().parents[2] / "configs" / "gallery" / "traced.geojson"
ALONG, ACROSS, SPACING = 4, 3, 42  # m
CORNERS = 40


def outline(number):
    radius = 10 + 8 * (number * 0.618034 % 1)  # m, spread evenly by multiples of the golden ratio
    phase = 2 * math.pi * (number * 0.414214 % 1)
    middle = SPACING * (number % ALONG + 0.5), SPACING * (number // ALONG + 0.5)
    ring = []
    for k in range(CORNERS):
        angle = 2 * math.pi * k / CORNERS
        waves = (0.12 * math.cos(2 * angle - phase) + 0.06 * math.cos(3 * angle + 2 * phase) +
                 0.03 * math.cos(5 * angle - 3 * phase))
        ring.append([round(middle[0] + radius * (1 + waves) * math.cos(angle), 2),
                     round(middle[1] + radius * (1 + waves) * math.sin(angle), 2)])
    return ring + ring[:1]


def feature(number):
    return {"type": "Feature", "id": f"F{number + 1}", "properties": {},
            "geometry": {"type": "Polygon", "coordinates": [outline(number)]}}


lines = ",\n".join(json.dumps(feature(number)) for number in range(ALONG * ACROSS))
FILE.write_text('{"type": "FeatureCollection", "features": [\n' + lines + "\n]}\n")
