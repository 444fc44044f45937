#!/usr/bin/python3
"""The tables of docs/water.md, from docs/water.

Usage:
    water.py                    writes the tables
    water.py --check            writes nothing; fails if a table differs from the data
    water.py --collect FOLDER   first takes the members of the campaigns water_channel.h5 and boundaries.h5 in FOLDER, as far
                                as they are there
"""
import pathlib
import textwrap

import pandas as pd

from contact import beside, collected
from page_blocks import make
from validation_data import change
from validation_tables import difference, table, with_interval

DOCS = pathlib.Path(__file__).resolve().parent.parent
DATA = DOCS / "water"
CASES = {"outline": "**waves and added mass of the outline (the default)**", "waves": "waves of the outline, no added mass",
         "neither": "neither",
         "paper": "the paper's preset: 15 % of critical damping, under water too, no added mass, no shelter"}
CAMPAIGNS = ["water_channel", "boundaries"]
QUANTITIES = {"mean_N": "mean, N", "maximum_1s_N": "maxima, 1 s, N", "broken_percent": "broken floes, %"}
WORK = {"ice_friction": "friction, ice on ice", "ice_crushing": "crushing and stopping, ice on ice",
        "hull_friction": "friction on the structure", "hull_crushing": "crushing and stopping on the structure",
        "vertical_drag": "drag along the normals", "plane_drag": "form and skin drag", "waves": "waves",
        "joints": "bending and breaking", "lifting": "lifting and pushing under", "motion": "motion",
        "rest": "lost by finite steps"}


def members(name):
    return pd.read_csv(DATA / f"{name}.csv")


BOUNDARIES = {"fixed": "**fixed sheets, half width 1.25 m, 24 floes (the channel of smoke.toml)**",
              "width_2": "2 times as wide", "width_3": "3 times as wide", "length_3": "3 times as long",
              "far_end_open": "far end open", "sides_open": "sides open", "pressure_5": "sheets press with 5 N/m",
              "pressure_20": "sheets press with 20 N/m", "pressure_80": "sheets press with 80 N/m"}


def boundaries():
    """Beside the fixed sheets: in pairs where the floes are the same ones, else by Welch's t."""
    rows = members("boundaries")
    lines = []
    for case, words in BOUNDARIES.items():
        own = rows[rows.case == case]
        cells = [words, with_interval(own.mean_N.to_numpy())]
        for quantity in ["mean_N", "maximum_1s_N"]:
            if case != "fixed":
                cells.append(difference(*change(rows, quantity, case, "fixed", not case.startswith(("width", "length")))))
            else:
                cells.append("" if quantity == "mean_N" else with_interval(own[quantity].to_numpy()))
        lines.append(cells)
    return table(["channel", "mean, N", "beside fixed", "maxima, 1 s, N, beside fixed"], lines)


def work(name):
    rows = members(name)
    own = rows[rows.case == "outline"]
    means = {words: own[f"work_{key}"].mean() for key, words in WORK.items()}
    total = sum(means.values())
    shares = "; ".join(f"{words} {100 * mean / total:.1f} %" for words, mean in sorted(means.items(), key=lambda one: -one[1]))
    return textwrap.fill(f"Of {total:.1f} N, where the mean load is {own.mean_N.mean():.1f} N: {shares}.", 125)


def collect(folder):
    for name in CAMPAIGNS:
        path = pathlib.Path(folder) / f"{name}.h5"
        if path.exists():
            collected(path, {"case": "joint.name"}, [f"work_{key}" for key in WORK]).round(6).to_csv(
                DATA / f"{name}.csv", index=False)


if __name__ == "__main__":
    make({DOCS / "water.md": {"channel": lambda: beside(members("water_channel"), CASES, "water", QUANTITIES),
                              "work": lambda: work("water_channel"), "boundaries": boundaries}}, __doc__, collect=collect)
