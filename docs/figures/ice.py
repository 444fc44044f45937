#!/usr/bin/python3
"""The tables of docs/fracture.md, from docs/ice.

Usage:
    ice.py                    writes the tables
    ice.py --check            writes nothing; fails if a table differs from the data
    ice.py --measure FLOES    first bends strips and sheets with the program FLOES, half a minute
    ice.py --collect FOLDER   first takes the members of the campaign joints_channel.h5 in FOLDER
"""
import io
import math
import pathlib
import subprocess
import sys

import pandas as pd

from contact import beside, collected
from page_blocks import fill_or_check
from validation_tables import table

DOCS = pathlib.Path(__file__).resolve().parent.parent
DATA = DOCS / "ice"
SHEETS = {0.3: 5.1, 0.2: 5.4, 0.1: 5.3, 0.05: 5.25}  # side of the elements -> of the sheet, an odd number of them, m
JOINTS = {"beams": "**beams between cells that crack by stress (the default)**", "squares": "between squares",
          "moment": "that crack by moment, Eq. (3)", "moment_share": "in the paper's water",
          "cfm": "the paper's joints, solved exactly", "sweeps": "solved in 50 sweeps (the paper's)"}


def csv_of(program, *arguments):
    text = subprocess.run([program, *arguments, "--format", "csv"], capture_output=True, text=True, check=True).stdout
    return pd.read_csv(io.StringIO(text), comment="#")


def measure(program):
    DATA.mkdir(exist_ok=True)
    csv_of(program, "laboratory", "cantilever", "--stiffness", "--elements", "3,6,12", "--modulus-MPa",
           "60,5000").to_csv(DATA / "strip.csv", index=False)
    sheets = [csv_of(program, "laboratory", "plate", "--thickness-m", "0.03", "--sheet-m", str(sheet), "--element-m",
                     str(element), "--beam-MPa", "60,200") for element, sheet in SHEETS.items()]
    pd.concat(sheets).to_csv(DATA / "sheet.csv", index=False)


def members(name):
    return pd.read_csv(DATA / f"{name}.csv")


def strip():
    """Each row stands for every modulus, as long as none differs in what is shown."""
    rows = [[f"{row.elements}", f"{row.deflection_m / row.elastic_deflection_m:.4f}",
             f"{row.frequency_1_per_s / row.elastic_frequency_1_per_s:.4f}"]
            for row in members("strip").sort_values("elements").itertuples()]
    return table(["elements", "deflection / elastic", "frequency / elastic"], [list(row) for row in dict.fromkeys(map(tuple, rows))])


def point_load_slope(modulus, thickness):
    rigidity = modulus * thickness**3 / (12 * (1 - 0.3**2))
    return 8 * math.sqrt(1000 * 9.81 * rigidity)


def sheet():
    rows = []
    for element, of in members("sheet").groupby("element_m", sort=False):
        rows.append([f"{element:g}"] + [f"{row.slope_N_per_m / point_load_slope(1e6 * row.set_modulus_MPa, row.thickness_m):.4f}"
                                        for row in of.sort_values("set_modulus_MPa").itertuples()])
    return table(["element, m", "slope / plate, E 60 MPa", "E 200 MPa"], rows)


def main():
    arguments = sys.argv[1:]
    if arguments[:1] == ["--measure"]:
        measure(arguments[1])
    elif arguments[:1] == ["--collect"]:
        DATA.mkdir(exist_ok=True)
        collected(pathlib.Path(arguments[1]) / "joints_channel.h5", {"case": "joint.name"}).to_csv(
            DATA / "joints_channel.csv", index=False)
    elif arguments not in ([], ["--check"]):
        sys.exit(__doc__)
    fill_or_check({DOCS / "fracture.md": {"strip": strip, "sheet": sheet,
                                      "channel": lambda: beside(members("joints_channel"), JOINTS, "joints",
                                                                step_by_step=True)}},
                  arguments == ["--check"], "ice.py")


if __name__ == "__main__":
    main()
