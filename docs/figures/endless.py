#!/usr/bin/python3
"""The figures of docs/field.md: whether the load of a field without end is stationary, and how much ice has to be
computed round the structure. Writes docs/endless/loads.csv and docs/endless/load.svg, and prints the page's tables.

    floes run configs/endless.toml --set campaign.arrangements=20 -o endless.h5
    floes run configs/validation/endless_window.toml -o window.h5
    docs/figures/endless.py endless.h5 window.h5
"""
import csv
import math
import pathlib
import sys

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from scipy import stats

PAGE = pathlib.Path(__file__).resolve().parent.parent / "endless"
PARTS = 6


def done(file):
    return file["members/status"][()] == 0


def interval(values):
    """Mean with its 95 % interval by Student's t."""
    values = np.asarray(values, float)
    half = stats.t.ppf(0.975, len(values) - 1) * values.std(ddof=1) / math.sqrt(len(values))
    return values.mean(), values.mean() - half, values.mean() + half


def text(values, digits=1):
    return "{:.{d}f} [{:.{d}f}, {:.{d}f}]".format(*interval(values), d=digits)


def histories(file):
    """Surge load of each done member over time, N, and the time between its values, s."""
    stride = int(file["cases/history_stride"][0])
    return file["history/surge_load"][()][done(file)], stride * float(file["cases/time_step"][0])


def stationarity(path):
    with h5py.File(path) as file:
        loads, step = histories(file)
        start, window = float(file["cases/steady_start"][0]), float(file["cases/window"][0])
        counts = {name: file["members/" + name][()][done(file)]
                  for name in ("failure_ratio", "met_failure_ratio", "floes_entered", "floes_met")}
    first = round(start / step)
    parts = np.stack([part.mean(axis=1) for part in np.array_split(loads[:, first:], PARTS, axis=1)], axis=1)
    print(f"{len(loads)} members, {PARTS} parts of {window / PARTS:g} s from {start:g} s on: mean load, N")
    for k in range(PARTS):
        print(f"| {k + 1} | {text(parts[:, k])} |")
    slopes = np.polyfit(np.arange(PARTS), parts.T, 1)[0] * PARTS
    print("change over the window, N, over members:", text(slopes, 2), "p =", f"{stats.ttest_1samp(slopes, 0).pvalue:.2g}")
    print("the last part less the first, N:", text(parts[:, -1] - parts[:, 0], 2),
          "p =", f"{stats.ttest_rel(parts[:, -1], parts[:, 0]).pvalue:.2g}")
    for name, values in counts.items():
        print(name, text(values, 3 if "ratio" in name else 0))
    PAGE.mkdir(exist_ok=True)
    with open(PAGE / "loads.csv", "w", newline="") as out:
        table = csv.writer(out, lineterminator="\n")
        table.writerow(["member"] + [f"mean_{k + 1}_N" for k in range(PARTS)])
        for k, row in enumerate(parts):
            table.writerow([k] + [f"{value:.3f}" for value in row])
    draw(loads, step, start)


def draw(loads, step, start):
    size = round(10 / step)  # means of 10 s
    count = loads.shape[1] // size
    means = loads[:, : count * size].reshape(len(loads), count, size).mean(axis=2)
    time = (np.arange(count) + 0.5) * size * step
    half = stats.t.ppf(0.975, len(loads) - 1) * means.std(axis=0, ddof=1) / math.sqrt(len(loads))
    figure, axes = plt.subplots(figsize=(8, 3), layout="constrained")
    axes.plot(time, means.T, color="0.8", linewidth=0.7)
    axes.fill_between(time, means.mean(axis=0) - half, means.mean(axis=0) + half, color="tab:blue", alpha=0.3)
    axes.plot(time, means.mean(axis=0), color="tab:blue")
    axes.axvline(start, color="black", linewidth=0.8, linestyle=":")
    axes.set(xlabel="time, s", ylabel="load, N", xlim=(0, time[-1]), ylim=(0, None))
    figure.savefig(PAGE / "load.svg", metadata={"Date": None})


def windows(path):
    with h5py.File(path) as file:
        names = [name.decode() if isinstance(name, bytes) else name for name in file["cases/name"][()]]
        case, number = file["members/case"][()], file["members/arrangement"][()]
        loads = {q: file["members/" + q][()] for q in ("mean_load", "failure_ratio")}
        peaks = file["averaged/mean_maximum"][()]
        times = np.round(file["averaging_time"][()], 3)
    peaks = peaks[:, int(np.flatnonzero(times == 1)[0])]
    order = {k: np.flatnonzero(case == k)[np.argsort(number[case == k])] for k in range(len(names))}
    base = order[0]
    for k, name in enumerate(names):
        rows = order[k]
        change = loads["mean_load"][rows] - loads["mean_load"][base]
        print("| {} | {} | {} | {} | {:.1f} |".format(
            name.replace("+", " ahead, "), text(loads["mean_load"][rows]), "–" if k == 0 else text(change),
            text(peaks[rows]), 100 * loads["failure_ratio"][rows].mean()))


if __name__ == "__main__":
    stationarity(sys.argv[1])
    windows(sys.argv[2])
