#!/usr/bin/python3
"""The table of docs/trends.md, from docs/trends.

Usage:
    trends.py                          writes the table
    trends.py --check                  writes nothing; fails if it differs from the data
    trends.py --collect FOLDER FLOES   first takes the members of arch_gap.h5 and compressed_field.h5 in FOLDER, made from
                                       configs/validation, as far as they are there, and draws docs/trends/*.png
"""
import pathlib
import subprocess

import numpy as np
import pandas as pd
from scipy import stats

from contact import collected
from page_blocks import make
from validation_data import change
from validation_tables import bracketed, table

DOCS = pathlib.Path(__file__).resolve().parent.parent
DATA = DOCS / "trends"
KEYS = {"case": "joint.name", "percent": "field.concentration_percent", "half_width_m": "field.half_width_m",
        "speed_m_s": "structure.speed_m_s", "thickness_m": "ice.thickness_m", "side_m": "floe.length_m"}
WORK = ["ice_crushing", "ice_friction", "hull_crushing", "hull_friction", "lifting", "vertical_drag"]
COLUMNS = {"arch_gap": ["floes_astern", "ice_flux"], "compressed_field": ["mean_concentration"] + [f"work_{one}" for one in WORK]}
SIDES = ["side_0.08", "side_0.10", "side_0.125", "side_0.15", "side_0.20", "side_0.25", "side_0.33"]
BASE = "side_0.25"


def members(name):
    rows = pd.read_csv(DATA / f"{name}.csv")
    if name == "arch_gap":  # what falls through, of what comes at the barrier
        rows["passes"] = 100 * rows.ice_flux / (rows.percent / 100 * 2 * rows.half_width_m * rows.speed_m_s)
        rows["arched"] = rows.floes_astern == 0
    else:
        rows["log_N"] = np.log(rows.mean_N)
    return rows


def base_of(case):
    return "late" if case.startswith("late") else "base"


def ratio(rows, case):
    """Geometric mean over that of the base, with its 95 % interval."""
    mean, half = change(rows, "log_N", case, base_of(case), not case.startswith("length"))
    return tuple(np.exp([mean, mean - half, mean + half]))


def exponent(quantity, cases):
    """Of the load as a power of a quantity, with its 95 % interval, by a straight line through the logarithms."""
    rows = members("compressed_field")
    rows = rows[rows.case.isin([base_of(cases[0]), *cases])]
    line = stats.linregress(np.log(rows[quantity]), rows.log_N)
    half = stats.t.ppf(0.975, len(rows) - 2) * line.stderr
    return line.slope, line.slope - half, line.slope + half


def power(bounds):
    return "power {:.2f} [{:.2f}, {:.2f}]".format(*bounds)


def within(value, bounds):
    return "yes" if bounds[1] <= value <= bounds[2] else "no"


def verdicts():
    rows = members("arch_gap")

    def counts(*cases):
        return ", ".join(f"{some(case)[0]} of {sum(some(case))}" for case in cases)

    def some(case):
        own = rows[rows.case == case].arched
        return int(own.sum()), int((~own).sum())

    def apart(*cases):
        """How the share that falls through differs from that of the base, and whether any difference is beyond chance."""
        found = [change(rows, "passes", case, BASE, case != "twice_as_wide") for case in cases]
        return (", ".join(f"{mean:+.0f} ± {half:.0f}" for mean, half in found) + " points",
                any(abs(mean) > half for mean, half in found))

    more = stats.fisher_exact([some(BASE), some("closeness_20")], alternative="greater").pvalue
    wide, differs_wide = apart("twice_as_wide")
    fast, differs_fast = apart("speed_0.05", "speed_0.2")
    rub, differs_rub = apart("friction_0.1", "friction_0.6")
    pure = tuple(sum(counted) for counted in zip(some("side_0.125"), some(BASE)))
    mixed = stats.fisher_exact([some("two_sizes_50"), pure], alternative="greater").pvalue
    mixes = ["side_0.125", "two_sizes_25", "two_sizes_50", "two_sizes_75", BASE]
    thick = exponent("thickness_m", ["thickness_0.015", "thickness_0.06"])
    late = exponent("thickness_m", ["late_thickness_0.015", "late_thickness_0.06"])
    side = exponent("side_m", ["side_0.2", "side_0.45"])
    speed = exponent("speed_m_s", ["speed_0.05", "speed_0.2"])
    length = ratio(members("compressed_field"), "length_6")
    seen = {True: "yes", False: "not seen"}
    lines = [
        ["blocks up to 0.10 of the gap do not arch, even where more comes than can pass", "Calkins and Ashton",
         f"at 0.08 and 0.10 {counts('side_0.08', 'side_0.10')} arched",
         ", ".join("no" if some(case)[0] else "yes" for case in SIDES[:2])],
        ["larger ones do", "the same", f"at 0.15, 0.20, 0.25 and 0.33 {counts('side_0.15', 'side_0.20', 'side_0.25', 'side_0.33')}",
         seen[bool(rows[rows.case.isin(SIDES[3:])].arched.any())]],
        ["a higher concentration upstream arches", "both", f"{counts('closeness_20', 'closeness_30', 'closeness_45', BASE)} "
         f"where 20, 30, 45 and 60 % come (first and last: one-sided p = {more:.2g})", seen[bool(more < 0.05)]],
        ["the concentration in the gap decides, whatever the width of the flume", "Tatinclaux and Lee",
         f"twice as wide at half the concentration: {counts('twice_as_wide')}, {wide} fall through", "no" if differs_wide else "yes"],
        ["no effect of the Froude number before blocks dive", "the same", f"half and twice the speed: "
         f"{counts('speed_0.05', 'speed_0.2')}, {fast}", "no" if differs_fast else "yes"],
        ["friction matters", "the same", f"friction 0.1 and 0.6: {counts('friction_0.1', 'friction_0.6')}, {rub}", seen[differs_rub]],
        ["of two sizes, equal areas arch most easily", "Calkins and Ashton 1976", f"0, 25, 50, 75 and 100 % of the area in the "
         f"larger: {counts(*mixes)} (half and half beside one size: one-sided p = {mixed:.2g})", seen[bool(mixed < 0.05)]],
        ["a compressed field: load linear in the thickness after a first phase", "Lensu", f"{power(thick)}, compressed on "
         f"{power(late)}", f"{within(1, thick)}, {within(1, late)}"],
        ["load independent of the diameter of the floes", "Lensu", power(side), within(0, side)],
        ["load independent of the length of the field", "IIHR", f"twice as long: {bracketed(*length)} times the load",
         within(1, length)],
        ["load falls with the speed: inversely, or until it is constant", "IIHR; Tatinclaux and Cheng", power(speed),
         "yes" if speed[2] < 0 else "no" if speed[1] > 0 else "not seen"]]
    return table(["published", "by", "here", "agrees"], lines)


def collect(folder, floes):
    folder = pathlib.Path(folder)
    for name, columns in COLUMNS.items():
        path = folder / f"{name}.h5"
        if path.exists():
            collected(path, KEYS, columns).round(6).to_csv(DATA / f"{name}.csv", index=False)
    for case, arrangement in [("side_0.08", 0), ("side_0.33", 4)]:
        subprocess.run([floes, "replay", folder / "arch_gap.h5", "--case", case, "--arrangement", f"{arrangement}", "--from",
                        "23.9", "--to", "24", "--at", "24", "--view", "above", "--size", "700x380", "-o",
                        DATA / f"{case}.png"], check=True)


if __name__ == "__main__":
    make({DOCS / "trends.md": {"verdicts": verdicts}}, __doc__, collect=collect)
