#!/usr/bin/python3
"""moorings.py > docs/moored/signs.svg: a moored structure from above, with the signs of what docs/moorings.md speaks of."""

import math

INK, ICE, HULL, LINE, LOAD, GREY = "#1a2733", "#2b7bba", "#e0a800", "#444c55", "#c62828", "#8a949e"


def at(x, z):
    return 300 + 2.6 * x, 170 + 2.6 * z  # +x to the right, +z down, as in the plan view


def line(a, b, colour, width=1.6, extra=""):
    (x1, y1), (x2, y2) = at(*a), at(*b)
    return f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" stroke="{colour}" stroke-width="{width}" {extra}/>'


def arrow(a, b, colour, width=2):
    angle = math.atan2(b[1] - a[1], b[0] - a[0])
    head = [(b[0] - 5 * math.cos(angle + turn), b[1] - 5 * math.sin(angle + turn)) for turn in (0.45, -0.45)]
    points = " ".join("{:.1f},{:.1f}".format(*at(*p)) for p in [b, *head])
    return line(a, b, colour, width) + f'<polygon points="{points}" fill="{colour}"/>'


def word(place, text, colour=INK, anchor="start"):
    x, y = at(*place)
    return f'<text x="{x:.1f}" y="{y:.1f}" fill="{colour}" text-anchor="{anchor}">{text}</text>'


def circle(place, radius, fill, stroke, extra=""):
    x, y = at(*place)
    return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{2.6 * radius:.1f}" fill="{fill}" stroke="{stroke}" {extra}/>'


offset, yaw, radius = (-14, 7), math.radians(20), 18
parts = ['<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 640 360" font-family="sans-serif" font-size="13">',
         '<rect width="640" height="360" fill="white"/>',
         circle((0, 0), radius, "none", GREY, 'stroke-dasharray="4 4"')]
for azimuth in (0, 60, 120, 180, 240, 300):
    a = math.radians(azimuth)
    anchor = (62 * math.cos(a), 62 * math.sin(a))
    fairlead = (radius * math.cos(a), radius * math.sin(a))
    turned = (offset[0] + math.cos(yaw) * fairlead[0] + math.sin(yaw) * fairlead[1],
              offset[1] + math.cos(yaw) * fairlead[1] - math.sin(yaw) * fairlead[0])
    parts += [line(fairlead, anchor, GREY, 0.8, 'stroke-dasharray="3 4"'), line(turned, anchor, LINE),
              circle(anchor, 1.4, LINE, LINE), circle(turned, 1, LINE, LINE)]
parts.append(circle(offset, radius, HULL, INK, 'fill-opacity="0.55"'))
bow = (offset[0] + radius * math.cos(yaw), offset[1] - radius * math.sin(yaw))
parts += [line(offset, bow, INK), line(offset, (offset[0] + radius, offset[1]), INK, 0.8, 'stroke-dasharray="3 3"'),
          word((offset[0] + 8, offset[1] - 1), "ψ", INK), arrow((0, 0), offset, INK, 1.4), word((2, -3), "offset"),
          arrow((bow[0] + 18, bow[1] - 8), (bow[0] + 2, bow[1] - 3), LOAD), word((bow[0] + 15, bow[1] - 10), "ice load", LOAD),
          arrow((96, -48), (72, -48), ICE, 3), word((72, -51), "ice drifts", ICE),
          arrow((-110, -58), (-90, -58), INK), word((-88, -57), "x, the tow of the anchors"),
          arrow((-110, -58), (-110, -38), INK), word((-107, -38), "z"),
          word((-110, 61), "dashed: without an offset; azimuth 0 along +x, 90 towards +z;", GREY),
          word((-110, 67), "yaw ψ is positive where +z turns to +x", GREY),
          "</svg>"]
print("\n".join(parts))
