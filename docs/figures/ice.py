#!/usr/bin/python3
"""The tables of docs/ice.md, of docs/full_scale.md and of the resolution in docs/convergence.md, from docs/ice.

Usage:
    ice.py                    writes the tables and the picture docs/ice/resolution.svg
    ice.py --check            writes nothing; fails if a table differs from the data
    ice.py --measure FLOES    first bends strips and sheets with the program FLOES, half a minute
    ice.py --collect FOLDER   first takes the members of the campaigns resolution.h5, full_scale.h5, joints_channel.h5 and
                              joints_tank.h5 in FOLDER

The costs in docs/ice.md are measured by bench/direct.py.
"""
import io
import math
import pathlib
import subprocess
import sys

import numpy as np
import pandas as pd

from contact import collected
from page_blocks import fill_or_check
from validation_data import half_width, interval
from validation_tables import bracketed, difference, number, table, with_interval

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
DOCS = ROOT / "docs"
DATA = DOCS / "ice"
SHEETS = {0.3: 5.1, 0.2: 5.4, 0.1: 5.3, 0.05: 5.25}  # side of the elements -> of the sheet, an odd number of them, m
KEYS = {"element_m": "floe.element_m", "iterations": "general.iterations", "time_step_s": "general.time_step_s"}
FAILURES = [f"failures_{mode}" for mode in ("bending", "shear", "compression")]
BASE = {"element_m": 0.2, "iterations": 20, "time_step_s": 0.02}
FULL_SCALE_BREADTH = 70  # m, of the structure of configs/full_scale.toml at the waterline
QUANTITIES = {"mean_N": "mean", "maximum_0.1s_N": "maxima, 0.1 s", "maximum_1s_N": "maxima, 1 s",
              "broken_percent": "broken floes, %"}


def csv_of(program, *arguments):
    text = subprocess.run([program, *arguments, "--format", "csv"], capture_output=True, text=True, check=True).stdout
    return pd.read_csv(io.StringIO(text), comment="#")


def measure(program):
    DATA.mkdir(exist_ok=True)
    csv_of(program, "laboratory", "cantilever", "--stiffness", "--elements", "3,6,12", "--modulus-MPa",
           "60,1000,5000").to_csv(DATA / "strip.csv", index=False)
    sheets = [csv_of(program, "laboratory", "plate", "--thickness-m", "0.03", "--sheet-m", str(sheet), "--element-m",
                     str(element), "--beam-MPa", "60,200") for element, sheet in SHEETS.items()]
    pd.concat(sheets).to_csv(DATA / "sheet.csv", index=False)
    csv_of(program, "hybrid", str(ROOT / "configs" / "full_scale.toml"), "--modulus-MPa", "1000,5000").to_csv(
        DATA / "lindqvist.csv", index=False)


def members(name):
    return pd.read_csv(DATA / f"{name}.csv")


# -- docs/ice.md

def strip():
    rows = [[f"{row.elastic_modulus_MPa:g}", f"{row.elements}", f"{row.deflection_m / row.elastic_deflection_m:.4f}",
             f"{row.frequency_1_per_s:.4g}", f"{row.frequency_1_per_s / row.elastic_frequency_1_per_s:.4f}"]
            for row in members("strip").itertuples()]
    return table(["E, MPa", "elements", "deflection / elastic", "frequency, 1/s", "frequency / elastic"], rows)


def point_load_slope(modulus, thickness):
    rigidity = modulus * thickness**3 / (12 * (1 - 0.3**2))
    return 8 * math.sqrt(1000 * 9.81 * rigidity)


def sheet():
    rows = []
    for row in members("sheet").itertuples():
        elastic = point_load_slope(1e6 * row.set_modulus_MPa, row.thickness_m)
        rows.append([f"{row.set_modulus_MPa:g}", f"{row.element_m:g}", f"{row.sheet_m:g}", f"{row.slope_N_per_m:.0f}",
                     f"{elastic:.0f}", f"{row.slope_N_per_m / elastic:.4f}", f"{row.elastic_modulus_point_MPa:.1f}"])
    return table(["E, MPa", "element, m", "sheet, m", "slope, N/m", "plate, N/m", "shown / plate", "E shown, MPa"], rows)


# -- docs/convergence.md

def cases():
    """Of the campaign: one thing at a time away from the base."""
    data = members("resolution")
    found = []
    for key in KEYS:
        rest = [other for other in KEYS if other != key]
        alone = data[np.logical_and.reduce([data[other] == BASE[other] for other in rest])]
        found += [(key, value, alone[alone[key] == value].set_index("arrangement"))
                  for value in sorted(alone[key].unique(), reverse=key != "iterations")]
    return found


def resolution():
    base = next(rows for key, value, rows in cases() if value == BASE[key])
    what = {"element_m": "elements, m", "iterations": "iterations", "time_step_s": "Δt, s"}
    lines = []
    for key, value, rows in cases():
        cells = [what[key], f"{value:g}", f"{len(rows)}"]
        for quantity in QUANTITIES:
            cells.append(with_interval(rows[quantity].to_numpy()))
            if quantity == "broken_percent":
                continue
            both = rows[quantity].to_frame("one").join(base[quantity].to_frame("other"), how="inner")
            ratio = both["one"] / both["other"]
            cells.append("1" if value == BASE[key] else f"{ratio.mean():.2f} ± {half_width(ratio.to_numpy()):.2f}")
        lines.append(cells)
    heading = ["varied", "value", "members"]
    for quantity, name in QUANTITIES.items():
        heading += [name if quantity == "broken_percent" else f"{name}, N"] + ([] if quantity == "broken_percent" else ["over base"])
    return table(heading, lines)


WAYS = {"sweeps": "sweeps over joints that follow Σ", "exact": "the same joints, solved exactly",
        "beams": "beams, solved exactly (the default)"}


def joints(name):
    """Ways of computing joints, in pairs over arrangements beside the first."""
    rows = members(name)
    quantities = {"mean_N": "mean, N", "maximum_1s_N": "maxima, 1 s, N", "broken_percent": "broken floes, %"}
    own = {way: rows[rows.way == way].set_index("arrangement") for way in WAYS}
    common = sorted(set.intersection(*(set(one.index) for one in own.values())))
    lines = []
    for way, words in WAYS.items():
        cells = [words, f"{len(common)}"]
        for quantity in quantities:
            values = own[way].loc[common, quantity].to_numpy()
            apart = values - own["sweeps"].loc[common, quantity].to_numpy()
            cells += [with_interval(values), "" if way == "sweeps" else difference(apart.mean(), half_width(apart))]
        lines.append(cells)
    return table(["joints", "arrangements"] + [cell for one in quantities.values() for cell in (one, "beside sweeps")],
                 lines)


def draw(path):
    """Loads and broken floes over element size, iterations and time step."""
    import matplotlib

    matplotlib.use("svg")
    matplotlib.rcParams["svg.hashsalt"] = "floes"
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(2, 3, figsize=(9.5, 4.6), sharey="row", sharex="col")
    shown = [("mean_N", "mean load", "C0"), ("maximum_1s_N", "maxima over 1 s", "C1")]
    for column, (key, title) in enumerate([("element_m", "side of the elements, m"), ("iterations", "iterations"),
                                           ("time_step_s", "time step, s")]):
        points = [(value, rows) for name, value, rows in cases() if name == key]
        places = range(len(points))
        for axis, quantities in [(axes[0][column], shown), (axes[1][column], [("broken_percent", None, "C2")])]:
            for quantity, label, colour in quantities:
                found = [interval(rows[quantity].to_numpy()) for _, rows in points]
                axis.errorbar(places, [mean for mean, *_ in found],
                              [[mean - low for mean, low, _ in found], [high - mean for mean, _, high in found]],
                              color=colour, marker="o", markersize=4, capsize=3, linewidth=1, label=label)
            axis.set_ylim(bottom=0)
            axis.grid(axis="y", linewidth=0.4)
        axes[1][column].set_xticks(list(places), [f"{value:g}" for value, _ in points])
        axes[1][column].set_xlabel(title)
    axes[0][0].set_ylabel("load, N")
    axes[1][0].set_ylabel("broken floes, %")
    axes[0][0].legend(frameon=False, fontsize=8)
    figure.tight_layout()
    figure.savefig(path, metadata={"Date": None})


# -- docs/full_scale.md

def full_scale():
    rows = members("full_scale")
    what = {"mean_N": "mean", "sd_N": "standard deviation"}
    for column in [name for name in rows if name.startswith("maximum_") and name != "maximum_N"]:
        what[column] = f"largest over {column.removeprefix('maximum_').removesuffix('s_N')} s, mean of three segments"
    lines = [[name, with_interval(1e-6 * rows[column].to_numpy()), number(1e-3 * rows[column].mean() / FULL_SCALE_BREADTH)]
             for column, name in what.items()]
    return table([f"load ({len(rows)} members)", "MN, mean over arrangements [95 %]", "kN per m of breadth"], lines)


def full_scale_breaks():
    rows = members("full_scale")
    failed = {column.removeprefix("failures_"): rows[column].to_numpy() for column in FAILURES}
    total = sum(values.sum() for values in failed.values())
    shares = ", ".join(f"{100 * values.sum() / total:.0f} % in {mode}" for mode, values in failed.items())
    return (f"Broken floes: {bracketed(*interval(rows['broken_percent'].to_numpy()))} %. Joints that failed: "
            f"{number(total / len(rows))} a member, {shares}.")


def lindqvist():
    rows = [[f"{row.elastic_modulus_MPa / 1000:g}", *(number(1e-6 * value) for value in
             (row.crushing, row.bending, row.submergence, row.limit_stress)),
             number(1e-3 * row.limit_stress / FULL_SCALE_BREADTH)]
            for row in members("lindqvist").itertuples()]
    return table(["E, GPa", "crushing, MN", "bending, MN", "submergence, MN", "together, MN", "kN per m"], rows)


def main():
    arguments = sys.argv[1:]
    if arguments[:1] == ["--measure"]:
        measure(arguments[1])
    elif arguments[:1] == ["--collect"]:
        DATA.mkdir(exist_ok=True)
        for name in ["resolution", "full_scale"]:
            path = pathlib.Path(arguments[1]) / f"{name}.h5"
            if path.exists():
                collected(path, KEYS, FAILURES).to_csv(DATA / f"{name}.csv", index=False)
        for name in ["joints_channel", "joints_tank"]:
            path = pathlib.Path(arguments[1]) / f"{name}.h5"
            if path.exists():
                collected(path, {"way": "joint.name"}).to_csv(DATA / f"{name}.csv", index=False)
    elif arguments not in ([], ["--check"]):
        sys.exit(__doc__)
    fill_or_check({DOCS / "ice.md": {"strip": strip, "sheet": sheet, "channel": lambda: joints("joints_channel"),
                                      "tank": lambda: joints("joints_tank")},
                   DOCS / "convergence.md": {"resolution": resolution},
                   DOCS / "full_scale.md": {"loads": full_scale, "breaks": full_scale_breaks, "lindqvist": lindqvist}},
                  arguments == ["--check"], "ice.py")
    if arguments != ["--check"]:
        draw(DATA / "resolution.svg")


if __name__ == "__main__":
    main()
