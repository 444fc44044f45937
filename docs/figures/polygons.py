#!/usr/bin/python3
"""Prints a table of docs/sea_ice.md, a row for each case of a campaign, and draws docs/sea_ice/polygons.png.

    floes run configs/validation/sea_ice.toml -o sea_ice.h5
    docs/figures/polygons.py FLOES sea_ice.h5 [--table]

FLOES: the program. The pictures are its own, of arrangement 1 of each case at the end of the run, from above. --table
only prints, from `floes summarize --format csv` and the processor times in the file.
"""
import csv
import io
import pathlib
import subprocess
import sys
import tempfile

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from validation_tables import table

CASES = ["squares", "voronoi", "hexagons"]
ARRANGEMENT = 1
PAGE = pathlib.Path(__file__).resolve().parent.parent / "sea_ice"
COLUMNS = [("mean load, N", "mean_load", 1),
           ("mean maximum over 1 s, N", "mean_maximum_1s", 1), ("broken floes, %", "failure_ratio", 100)]


def rows_of(program, campaign):
    text = subprocess.run([program, "summarize", campaign, "--format", "csv"], check=True, capture_output=True,
                          text=True).stdout
    return {row["name"]: row for row in csv.DictReader(io.StringIO(text))}


def cost(campaign, case):
    """Seconds of a processor for a member, mean of a case."""
    with h5py.File(campaign) as file:
        names = [name.decode() for name in file["cases/name"][()]]
        mine = file["members/case"][()] == names.index(case)
        return np.mean(file["provenance/cpu_time"][()][mine])


def print_table(program, campaign):
    rows, lines = rows_of(program, campaign), []
    for case in rows:
        cells = []
        for _, key, scale in COLUMNS:
            value, low, high = (scale * float(rows[case][key + end]) for end in ("", "_low", "_high"))
            cells.append(f"{value:.1f} [{low:.1f}, {high:.1f}]")
        lines.append([case, *cells, f"{cost(campaign, case):.1f}"])
    print(table(["case", *(title for title, _, _ in COLUMNS), "a member, s"], lines))


def pictures(program, campaign):
    figure, axes = plt.subplots(1, len(CASES), figsize=(13, 3.9), layout="constrained")
    with tempfile.TemporaryDirectory() as folder:
        for place, case in zip(axes, CASES):
            picture = pathlib.Path(folder) / f"{case}.png"
            subprocess.run([program, "replay", campaign, "--case", case, "--arrangement", str(ARRANGEMENT), "--at", "26",
                            "--view", "above", "--size", "1000x800", "-o", picture], check=True, capture_output=True)
            place.imshow(plt.imread(picture))
            place.set_title(case)
            place.axis("off")
    figure.savefig(PAGE / "polygons.png", dpi=90)


if __name__ == "__main__":
    print_table(sys.argv[1], sys.argv[2])
    if "--table" not in sys.argv:
        pictures(sys.argv[1], sys.argv[2])
