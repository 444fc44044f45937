#!/usr/bin/python3
"""Draws docs/sea_ice/fields.png: one arrangement of each case, its floes coloured by their thickness.

    floes run configs/validation/sea_ice.toml -o sea_ice.h5
    docs/figures/sea_ice.py sea_ice.h5 [PICTURE]
"""
import math
import pathlib
import sys
import tomllib

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

CASES = ["squares", "mixed", "rectangles", "both"]
PAGE = pathlib.Path(__file__).resolve().parent.parent / "sea_ice"


def floes_of(file, case, configuration):
    """x, z, yaw, length, breadth and thickness of the floes of the case's first member, a row each."""
    names = [name.decode() for name in file["cases/name"][()]]
    member = int(np.flatnonzero(file["members/case"][()] == names.index(case))[0])
    poses = file["arrangements/pose"][file["members/arrangement"][member]]
    own = file["members/floe_properties"][member][:, :3]  # length, breadth, thickness; NaN where all are alike
    alike = [configuration["floe"]["length_m"], configuration["floe"]["breadth_m"], configuration["ice"]["thickness_m"]]
    rows = np.hstack([poses, np.where(np.isnan(own), alike, own)])
    return rows[~np.isnan(rows[:, 0])]


def draw(axes, floes, title, half_width):
    for x, z, yaw, length, breadth, thickness in floes:
        corners = 0.5 * np.array([[length, breadth], [-length, breadth], [-length, -breadth], [length, -breadth]])
        turn = np.array([[math.cos(yaw), math.sin(yaw)], [-math.sin(yaw), math.cos(yaw)]])
        colour = plt.cm.Blues(np.clip((thickness - 0.015) / 0.04, 0.1, 0.95))
        axes.fill(*(corners @ turn.T + [x, z]).T, facecolor=colour, edgecolor="black", linewidth=0.5)
    for edge in (-half_width, half_width):
        axes.axhline(edge, color="black", linewidth=1)
    axes.set(aspect="equal", title=title, xlim=(1.9, 6.75), xlabel="x, m", ylabel="z, m")


def main():
    picture = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else PAGE / "fields.png"
    figure, axes = plt.subplots(2, 2, figsize=(11, 6.2), layout="constrained")
    with h5py.File(sys.argv[1]) as file:
        configuration = tomllib.loads(file["provenance/configuration"].asstr()[()])
        for place, case in zip(axes.flat, CASES):
            draw(place, floes_of(file, case, configuration), case, configuration["field"]["half_width_m"])
    figure.savefig(picture, dpi=110)


if __name__ == "__main__":
    main()
