#!/usr/bin/python3
"""Level ice pushed on an inclined plate in docs/validation.md: its table and its picture, from docs/validation.

Usage:
    level_case1.py                        writes table and picture
    level_case1.py --check                writes nothing; fails if the page differs from the data
    level_case1.py --collect FOLDER       first takes the finished campaigns of configs/validation/level_case1.toml and
                                          level_case1_geometry.toml, FOLDER/NAME.h5

level_case1.measured.csv: means over 0.5 s of the measured load; Lemström, Polojärvi, Puolakka and Tuhkuri, Data in Brief
45 (2022) 108580, doi 10.5281/zenodo.6524282, CC BY 4.0. level_case1.windows.csv: its means in five windows, and those of
four runs of another program (GitHub vasopatejdl/lemstrom-case1-viewer, 9ff4783).
"""
import argparse
import pathlib

import numpy as np
import pandas as pd
from scipy import stats

from page_blocks import fill_or_check

DATA = pathlib.Path(__file__).resolve().parent.parent / "validation"
PAGE = DATA.parent / "validation.md"
WINDOWS = [(0, 30), (30, 130), (130, 230), (230, 330), (330, 430)]  # s
NAMES = [f"{begin}-{end}" for begin, end in WINDOWS]
SLICE, WIDTH = 0.98, 10.0  # m, of the ice
EVERY = 2.0  # s, of the traces


def add_members(path, rows, traces):
    import h5py  # which --check does not need

    with h5py.File(path) as file:
        cases = file["cases/name"].asstr()[:]
        members = file["members"]
        for member in np.flatnonzero(members["status"][:] == 0):
            case = members["case"][member]
            step = file["cases/time_step"][case] * file["cases/history_stride"][case]
            load = file["history/surge_load"][member] * WIDTH / SLICE
            bed = file["history/bed_surge"][member] * WIDTH / SLICE
            grounded = file["history/grounded"][member]
            end = (np.arange(len(load)) + 1) * step
            inside = [(end > begin) & (end <= stop) & np.isfinite(load) for begin, stop in WINDOWS]
            rows.append([cases[case], members["arrangement"][member]] + [round(load[one].mean()) for one in inside] +
                        [round(bed[one].mean()) for one in inside] + [round(grounded[one].mean(), 2) for one in inside])
            size = round(EVERY / step)
            means = load[: len(load) // size * size].reshape(-1, size).mean(axis=1)
            traces[f"{cases[case]}: {members['arrangement'][member]}"] = np.round(means).astype(int)


def collect(folder):
    rows, traces = [], {}
    for name in ("level_case1", "level_case1_geometry"):
        add_members(folder / f"{name}.h5", rows, traces)
    columns = ["case", "arrangement"] + [f"{what}_{name}" for what in ("load", "bed", "grounded") for name in NAMES]
    pd.DataFrame(rows, columns=columns).to_csv(DATA / "level_case1.members.csv", index=False)
    traces = pd.DataFrame(traces)
    traces.insert(0, "end_s", (np.arange(len(traces)) + 1) * EVERY)
    traces.to_csv(DATA / "level_case1.traces.csv", index=False)


def words(case):
    """Of a50_d46: its angle and depth."""
    angle, depth = case.split("_")
    return f"floes, {angle[1:]}° in 0.{depth[1:]} m"


def one_run(values):
    """Mean, and half the 95 % prediction interval of one further run."""
    values = np.asarray(values, float)
    count = len(values)
    if count < 2:
        return values.mean(), np.nan
    return values.mean(), stats.t.ppf(0.975, count - 1) * values.std(ddof=1) * np.sqrt(1 + 1 / count)


def table():
    reference = pd.read_csv(DATA / "level_case1.windows.csv")
    members = pd.read_csv(DATA / "level_case1.members.csv")
    head = [f"{name} s" for name in NAMES]
    lines = ["| load, kN for 10 m | " + " | ".join(head) + " |", "|---" * 6 + "|"]
    lines.append("| measured | " + " | ".join(f"{value / 1e3:.2f}" for value in reference.measured_N) + " |")
    runs = reference[[f"run{k}_N" for k in range(1, 5)]].to_numpy() / 1e3
    lines.append("| four runs of another program | " + " | ".join(f"{r.min():.2f} to {r.max():.2f}" for r in runs) + " |")
    for case, rows in members.groupby("case", sort=False):
        cells = []
        for name, measured in zip(NAMES, reference.measured_N):
            mean, half = one_run(rows[f"load_{name}"])
            spread = f" ± {half / 1e3:.2f}" if np.isfinite(half) else ""
            cells.append(f"{mean / 1e3:.2f}{spread} ({mean / measured:.2f})")
        lines.append(f"| {words(case)}, {len(rows)} {'runs' if len(rows) > 1 else 'run'} | " + " | ".join(cells) + " |")
    first = members[members.case == members.case[0]]
    lines.append("| of these first, borne by the bed | " +
                 " | ".join(f"{first[f'bed_{name}'].mean() / 1e3:.2f}" for name in NAMES) + " |")
    return "\n".join(lines)


def draw(path):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    measured = pd.read_csv(DATA / "level_case1.measured.csv")
    windows = pd.read_csv(DATA / "level_case1.windows.csv")
    traces = pd.read_csv(DATA / "level_case1.traces.csv")
    figure, axes = plt.subplots(figsize=(9, 3.6), layout="constrained")
    size = round(EVERY / 0.5)
    count = len(measured) // size * size
    means = measured.force_N.to_numpy()[:count].reshape(-1, size).mean(axis=1) / 1e3
    axes.plot((np.arange(len(means)) + 1) * EVERY, means, color="black", linewidth=0.8, label="measured")
    cases = [name.split(": ")[0] for name in traces.columns[1:]]
    for k, name in enumerate(traces.columns[1:]):
        likeliest = cases[k] == cases[0]
        axes.plot(traces.end_s, traces[name] / 1e3, color="tab:blue" if likeliest else "0.8", linewidth=0.6,
                  zorder=2 if likeliest else 1,
                  label=words(cases[0]) if k == 0 else "other angles and depths" if cases[k - 1] == cases[0] != cases[k] else None)
    for k in range(1, 5):
        for (begin, end), value in zip(WINDOWS, windows[f"run{k}_N"]):
            axes.plot([begin, end], [value / 1e3] * 2, color="tab:orange", linewidth=1.2,
                      label="four runs of another program, means" if (k, begin) == (1, 0) else None)
    axes.set(xlabel="time, s", ylabel="load, kN for 10 m", xlim=(0, 464), ylim=(0, None))
    axes.legend(fontsize="small", loc="upper left")
    figure.savefig(path, metadata={"Date": None})


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--collect", type=pathlib.Path, metavar="FOLDER")
    options = parser.parse_args()
    if options.collect is not None:
        collect(options.collect)
    fill_or_check({PAGE: {"level": table}}, options.check, "level_case1.py")
    if not options.check:
        draw(DATA / "level_case1.svg")


if __name__ == "__main__":
    main()
