#!/usr/bin/python3
"""The tables of docs/validation.md and its pictures, from the summaries in docs/validation.

Usage:
    validation.py                       writes tables and pictures
    validation.py --check               writes nothing; fails if a table of the page differs from the summaries
    validation.py --collect FOLDER [FLOES]
                                        first takes the summaries of the finished campaigns in FOLDER (NAME.h5) with
                                        the program FLOES (default ./floes)
"""
import pathlib
import subprocess
import sys

import numpy as np
import pandas as pd

import validation_tables as tables
from page_blocks import fill_or_check
from validation_data import CAMPAIGNS, SUMMARIES

PAGE = SUMMARIES.parent / "validation.md"


def averaged(path):
    """Median, SD and mean of the segment maxima of the load averaged over increasing windows; means over arrangements."""
    import h5py  # which --check does not need

    rows = []
    with h5py.File(path) as file:
        names = file["cases/name"].asstr()[:]
        members_ = file["members"]
        for member in np.flatnonzero(members_["status"][:] == 0):
            case = members_["case"][member]
            step, start = (file[f"cases/{key}"][case] for key in ["time_step", "steady_start"])
            load = file["history/surge_load"][member][round(start / step):]
            for steps in [1, 5, 10, 25, 50, 100, 250]:
                mean = np.convolve(load, np.ones(steps) / steps, mode="valid")
                maxima = [part.max() for part in np.array_split(mean, file["cases/segments"][case])]
                rows.append([names[case], round(steps * step, 6), np.median(mean), mean.std(), np.mean(maxima)])
    table = pd.DataFrame(rows, columns=["case", "averaged_over_s", "median_N", "sd_N", "mean_maximum_N"])
    return table.groupby(["case", "averaged_over_s"], sort=False).mean().reset_index()


def collect(folder, program):
    def summary(name, part, *options, as_name=None):
        command = [program, "summarize", str(folder / f"{name}.h5"), "--parts", part, "--format", "csv", *options]
        text = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout
        (SUMMARIES / f"{name}.{as_name or part}.csv").write_text(text)

    for name in CAMPAIGNS:
        if (folder / f"{name}.h5").exists():
            summary(name, "cases")
            summary(name, "members")
    if (folder / "table3.h5").exists():
        summary("table3", "pairs")
        summary("table3", "cases", "--window", "auto", as_name="steady")
        averaged(folder / "table3.h5").to_csv(SUMMARIES / "table3.averaged.csv", index=False)
    command = [program, "hybrid", "--modulus-MPa", "2,3,5,7,10,15,20,30,45,60,100,150,200,300,500", "--format", "json"]
    curve = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout
    (SUMMARIES / "hybrid.json").write_text(curve)


def main(arguments):
    if arguments[:1] == ["--collect"]:
        collect(pathlib.Path(arguments[1]), arguments[2] if len(arguments) > 2 else "./floes")
    check = arguments == ["--check"]
    fill_or_check({PAGE: tables.BLOCKS}, check, "validation.py")
    if check:
        return
    import validation_figures  # needs matplotlib, which --check does not

    validation_figures.draw_all(SUMMARIES)


if __name__ == "__main__":
    main(sys.argv[1:])
