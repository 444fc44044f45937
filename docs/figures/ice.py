#!/usr/bin/python3
"""The table of joints in docs/fracture.md, from docs/ice.

Usage:
    ice.py                    writes the table
    ice.py --check            writes nothing; fails if the table differs from the data
    ice.py --collect FOLDER   first takes the members of the campaign joints_channel.h5 in FOLDER
"""
import pathlib

import pandas as pd

from contact import LONG_QUANTITIES, beside, collected
from page_blocks import make

DOCS = pathlib.Path(__file__).resolve().parent.parent
DATA = DOCS / "ice/joints_channel.csv"
JOINTS = {"beams": "**beams between cells that crack by stress (the default)**", "squares": "between squares",
          "moment": "that crack by moment, Eq. (3)", "moment_share": "in the paper's water",
          "cfm": "the paper's joints, solved exactly", "sweeps": "solved in 50 sweeps (the paper's)"}


def channel():
    return beside(pd.read_csv(DATA), JOINTS, "joints", LONG_QUANTITIES, step_by_step=True)


def collect(folder):
    collected(pathlib.Path(folder) / "joints_channel.h5", {"case": "joint.name"}).to_csv(DATA, index=False)


if __name__ == "__main__":
    make({DOCS / "fracture.md": {"channel": channel}}, __doc__, collect=collect)
