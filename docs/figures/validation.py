#!/usr/bin/python3
"""The tables of docs/validation.md and its pictures, from docs/validation.

Usage:
    validation.py                       writes tables and pictures
    validation.py --check               writes nothing; fails if a table of the page differs from the summaries
    validation.py --collect FOLDER [FLOES]
                                        first takes the summaries of the finished campaigns in FOLDER (NAME.h5) with
                                        the program FLOES (default ./floes)
"""
import pathlib

import numpy as np
import pandas as pd

import validation_tables
from page_blocks import make
from told import said
from validation_data import CAMPAIGNS, SUMMARIES, WINDOW_START

WINDOW_S, SEGMENTS = 150, 3
STARTS = range(80, 131, 10)  # s


def histories(path):
    """Name of the case, arrangement, time step and load at every step, for each finished member."""
    import h5py  # which --check does not need

    with h5py.File(path) as file:
        names = file["cases/name"].asstr()[:]
        members = file["members"]
        for member in np.flatnonzero(members["status"][:] == 0):
            case = members["case"][member]
            load = file["history/surge_load"][member]
            yield names[case], members["arrangement"][member], file["cases/time_step"][case], load[np.isfinite(load)]


def windows(path):
    """Mean, SD, mean of the segment maxima, and trend of the load, in windows that begin later and later."""
    rows = []
    for name, arrangement, step, load in histories(path):
        for start in STARTS:
            inside = load[round(start / step):round((start + WINDOW_S) / step)]
            time = np.arange(len(inside)) * step
            maxima = [part.max() for part in np.array_split(inside, SEGMENTS)]
            rows.append([name, arrangement, start, inside.mean(), inside.std(), np.mean(maxima),
                         100 * np.polyfit(time, inside, 1)[0]])
    return pd.DataFrame(rows, columns=["case", "arrangement", "start_s", "mean_load", "sd_load", "mean_maximum",
                                       "trend_N_per_100s"])


def largest(path, start):
    """The largest load in the window of each member, averaged over increasing times."""
    rows = []
    for name, arrangement, step, load in histories(path):
        inside = load[round(start / step):]
        for steps in [1, 5, 50, 100]:
            mean = np.convolve(inside, np.ones(steps) / steps, mode="valid")
            rows.append([name, arrangement, round(steps * step, 6), mean.max()])
    return pd.DataFrame(rows, columns=["case", "arrangement", "averaged_over_s", "maximum_load"])


def collect(folder, program="./floes"):
    folder = pathlib.Path(folder)

    def summary(name, part):
        words = said(program, "summarize", folder / f"{name}.h5", "--parts", part, "--format", "csv")
        (SUMMARIES / f"{name}.{part}.csv").write_text(words)

    def is_here(name):
        return (folder / f"{name}.h5").exists()

    for name in filter(is_here, CAMPAIGNS):
        summary(name, "members")
    if is_here("table3"):
        summary("table3", "pairs")
    if is_here("vary_channel"):
        summary("vary_channel", "model")
    if is_here("fit_paper"):
        windows(folder / "fit_paper.h5").to_csv(SUMMARIES / "fit_paper.windows.csv", index=False, float_format="%.6g")
    if is_here("tank_walls"):
        largest(folder / "tank_walls.h5", WINDOW_START).to_csv(SUMMARIES / "tank_walls.largest.csv", index=False,
                                                               float_format="%.6g")
    curve = said(program, "hybrid", "--modulus-MPa", "2,3,5,7,10,15,20,30,45,60,100,150,200,300,500", "--format", "json")
    (SUMMARIES / "hybrid.json").write_text(curve)


if __name__ == "__main__":
    if make({SUMMARIES.parent / "validation.md": validation_tables.BLOCKS}, __doc__, collect=collect):
        import validation_figures  # needs matplotlib, which --check does not

        validation_figures.draw_all(SUMMARIES)
