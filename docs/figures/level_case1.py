#!/usr/bin/python3
"""Level ice pushed on an inclined plate in docs/validation.md: its tables and its picture, from docs/validation.

Usage:
    level_case1.py                        writes tables and picture
    level_case1.py --check                writes nothing; fails if the page differs from the data
    level_case1.py --collect FOLDER       first takes the members that FOLDER has, as NAME.h5, of the campaigns level_case1,
                                          level_case1_factors and level_case1_wide of configs/validation; others stay

level_case1.measured.csv: means over 0.5 s of the measured load; Lemström, Polojärvi, Puolakka and Tuhkuri, Data in Brief
45 (2022) 108580, doi 10.5281/zenodo.6524282, CC BY 4.0. level_case1.windows.csv: its means in five windows, and those of
four runs of another program (GitHub vasopatejdl/lemstrom-case1-viewer, 9ff4783).
"""
import pathlib
import tomllib

import numpy as np
import pandas as pd
from scipy import stats

from page_blocks import make
from validation_tables import table

DATA = pathlib.Path(__file__).resolve().parent.parent / "validation"
PAGE = DATA.parent / "validation.md"
CONFIGS = DATA.parent.parent / "configs" / "validation"
WINDOWS = [(0, 30), (30, 130), (130, 230), (230, 330), (330, 430)]  # s
NAMES = [f"{begin}-{end}" for begin, end in WINDOWS]
CAMPAIGNS = {"level_case1": 0.98, "level_case1_factors": 0.98, "level_case1_wide": 2.94}  # breadth of the ice, m
WIDTH = 10.0  # m, in the test
EVERY = 2.0  # s, of the traces
STEADY = (130, 430)  # s, in which the peaks are compared: the measured load no longer grows
FALL = 500  # N, of the smallest fall that counts


def turning_points(load, least):
    """Of the trace, those between which it rises or falls by `least` or more."""
    points = [load[0]]
    rising = None
    for value in load:
        if rising is None and abs(value - points[0]) >= least:
            rising = value > points[0]
            points.append(value)
        elif rising is not None and (value > points[-1]) == rising:
            points[-1] = value
        elif rising is not None and abs(value - points[-1]) >= least:
            rising = not rising
            points.append(value)
    return np.array(points)


def averaged(load, step):
    """Means over EVERY of means over `step`, s."""
    size = round(EVERY / step)
    return load[: len(load) // size * size].reshape(-1, size).mean(axis=1)


def peaks_of(load, step):
    """Of means over `step`, s, in STEADY: standard deviation, largest over 1 and 10 s, time between falls, mean fall, N and
    s, and the share of the variance below 0.05 Hz."""
    load = load[round(STEADY[0] / step): round(STEADY[1] / step)]
    largest = [np.convolve(load, np.ones(n) / n, "valid").max() for n in (round(1 / step), round(10 / step))]
    falls = -np.diff(turning_points(load, FALL))
    falls = falls[falls > 0]
    power = np.abs(np.fft.rfft(load - load.mean())) ** 2
    slow = power[np.fft.rfftfreq(len(load), step) < 0.05].sum() / power.sum()
    return [load.std(), *largest, (STEADY[1] - STEADY[0]) / max(len(falls), 1), falls.mean() if len(falls) else 0, slow]


PEAKS = ["sd_N", "largest_1s_N", "largest_10s_N", "between_falls_s", "fall_N", "below_0.05_Hz"]


def add_members(path, breadth, rows, peaks, traces):
    import h5py  # which --check does not need

    with h5py.File(path) as file:
        cases = file["cases/name"].asstr()[:]
        members = file["members"]
        for member in np.flatnonzero(members["status"][:] == 0):
            case = members["case"][member]
            step = file["cases/time_step"][case] * file["cases/history_stride"][case]
            load = file["history/surge_load"][member] * WIDTH / breadth
            bed = file["history/bed_surge"][member] * WIDTH / breadth
            grounded = file["history/grounded"][member]
            end = (np.arange(len(load)) + 1) * step
            inside = [(end > begin) & (end <= stop) & np.isfinite(load) for begin, stop in WINDOWS if end[-1] >= stop]
            means = [[round(trace[one].mean(), digits) for one in inside] + [np.nan] * (len(WINDOWS) - len(inside))
                     for trace, digits in ((load, 0), (bed, 0), (grounded, 2))]
            rows.append([cases[case], members["arrangement"][member], *sum(means, [])])
            traces[f"{cases[case]}: {members['arrangement'][member]}"] = np.round(averaged(load, step)).astype(int)
            if end[-1] >= STEADY[1]:
                peaks.append([cases[case], members["arrangement"][member]] + [float(f"{x:.4g}") for x in peaks_of(load, step)])


def renewed(name, rows, order):
    """The table `name` of docs/validation with these rows in place of those of the same members, by case."""
    known = pd.read_csv(DATA / name)
    fresh = pd.DataFrame(rows, columns=known.columns)
    both = pd.concat([fresh, known]).drop_duplicates(["case", "arrangement"])
    both = both[both.case.isin(order)]
    both["order"] = both.case.map(order.index)
    both.sort_values(["order", "arrangement"]).drop(columns="order").to_csv(DATA / name, index=False)


def collect(folder):
    rows, peaks, traces = [], [], {}
    for name, breadth in CAMPAIGNS.items():
        if (path := pathlib.Path(folder) / f"{name}.h5").exists():
            add_members(path, breadth, rows, peaks, traces)
    order = [case["name"] for name in CAMPAIGNS
             for case in tomllib.loads((CONFIGS / f"{name}.toml").read_text())["case"]]
    renewed("level_case1.members.csv", rows, order)
    renewed("level_case1.peaks.csv", peaks, order)
    known = pd.read_csv(DATA / "level_case1.traces.csv").set_index("end_s")
    for name, trace in traces.items():
        known[name] = pd.Series(trace, index=known.index[: len(trace)])
    columns = sorted(known, key=lambda name: (order.index(name.split(": ")[0]), int(name.split(": ")[1])))
    known[columns].astype("Int64").to_csv(DATA / "level_case1.traces.csv")


CHANGES = {"high": "a plate that reaches 1.2 m above the water", "ice_friction_40": "friction of ice on ice 0.4 for 0.15",
           "wide": "a slice of 3 m"}


def words(case):
    """Of a50_d46: its angle and depth; of a50_d46_high also what else differs."""
    angle, depth, *rest = case.split("_", 2)
    return f"{angle[1:]}° in 0.{depth[1:]} m" + "".join(f", {CHANGES[one]}" for one in rest)


def one_run(values):
    """Mean, and half the 95 % prediction interval of one further run."""
    values = np.asarray(values, float)
    count = len(values)
    if count < 2:
        return values.mean(), np.nan
    return values.mean(), stats.t.ppf(0.975, count - 1) * values.std(ddof=1) * np.sqrt(1 + 1 / count)


def load_table():
    reference = pd.read_csv(DATA / "level_case1.windows.csv")
    members = pd.read_csv(DATA / "level_case1.members.csv")
    runs = reference[[f"run{k}_N" for k in range(1, 5)]].to_numpy() / 1e3
    lines = [["measured", *(f"{value / 1e3:.2f}" for value in reference.measured_N)],
             ["four runs of another program", *(f"{r.min():.2f} to {r.max():.2f}" for r in runs)]]
    for case, rows in members.groupby("case", sort=False):
        cells = []
        for name, measured in zip(NAMES, reference.measured_N):
            mean, half = one_run(rows[f"load_{name}"])
            if not np.isfinite(mean):
                cells.append("")
                continue
            spread = f" ± {half / 1e3:.2f}" if np.isfinite(half) else ""
            cells.append(f"{mean / 1e3:.2f}{spread} ({mean / measured:.2f})")
        many = len(rows) > 1
        lines.append([f"{'floes, ' if many else ''}{words(case)}, {len(rows)} {'runs' if many else 'run'}", *cells])
        if case == members.case[0]:
            lines.append(["of these, borne by the bed",
                          *(f"{round(rows[f'bed_{name}'].mean() / 1e3, 2) + 0.0:.2f}" for name in NAMES)])
    return table(["load, kN for 10 m", *(f"{name} s" for name in NAMES)], lines)


def peak_table():
    measured = pd.read_csv(DATA / "level_case1.measured.csv").force_N.to_numpy()
    peaks = pd.read_csv(DATA / "level_case1.peaks.csv")
    first = peaks[peaks.case == peaks.case[0]]
    lines = []
    what = ["standard deviation, kN", "largest over 1 s, kN", "largest over 10 s, kN", "time between falls of more than 0.5 kN, s",
            "mean fall, kN", "share of the variance below 0.05 Hz, %"]
    for name, key, value in zip(what, PEAKS, peaks_of(measured, 0.5)):
        scale = 1e-3 if key.endswith("_N") else 100 if key.endswith("Hz") else 1
        mean, half = one_run(first[key])
        digits = 0 if key.endswith("Hz") else 1 if key.endswith("_s") and "largest" not in key else 2
        lines.append([name, f"{value * scale:.{digits}f}", f"{mean * scale:.{digits}f} ± {half * scale:.{digits}f}"])
    return table(["from 130 to 430 s", "measured", "floes, one run"], lines)


def widths():
    """How the load of ice of one width differs from its straight line from 30 to 130 s, by means over 2 s."""
    traces = pd.read_csv(DATA / "level_case1.traces.csv").set_index("end_s")
    measured = pd.read_csv(DATA / "level_case1.measured.csv").force_N.to_numpy()
    begin, end = WINDOWS[1]

    def figures(load):
        part = load[round(begin / EVERY): round(end / EVERY)] / 1e3
        about = part - np.polyval(np.polyfit(np.arange(len(part)), part, 1), np.arange(len(part)))
        return part.mean(), about.std(), part.min()

    lines = [["measured, 10 m", *(f"{x:.2f}" for x in figures(averaged(measured, 0.5)))]]
    for name, case in (("slices of 1 m", "a50_d46"), ("slices of 3 m", "a50_d46_wide")):
        runs = [figures(traces[one].to_numpy()) for one in traces if one.split(": ")[0] == case]
        cells = []
        for values in zip(*runs):
            mean, half = one_run(values)
            cells.append(f"{mean:.2f} ± {half:.2f}" if np.isfinite(half) else f"{mean:.2f}")
        lines.append([f"{name}, {len(runs)} runs", *cells])
    return table(["from 30 to 130 s, kN for 10 m", "mean", "standard deviation about its line", "least of 2 s"], lines)


def draw(path):
    import matplotlib

    matplotlib.use("Agg")
    matplotlib.rcParams["svg.hashsalt"] = "floes"  # the same file at each drawing
    import matplotlib.pyplot as plt

    measured = pd.read_csv(DATA / "level_case1.measured.csv")
    windows = pd.read_csv(DATA / "level_case1.windows.csv")
    traces = pd.read_csv(DATA / "level_case1.traces.csv")
    figure, axes = plt.subplots(figsize=(9, 3.6), layout="constrained")
    means = averaged(measured.force_N.to_numpy(), 0.5) / 1e3
    axes.plot((np.arange(len(means)) + 1) * EVERY, means, color="black", linewidth=0.8, label="measured")
    cases = [name.split(": ")[0] for name in traces.columns[1:]]
    for k, name in enumerate(traces.columns[1:]):
        likeliest = cases[k] == cases[0]
        axes.plot(traces.end_s, traces[name] / 1e3, color="tab:blue" if likeliest else "0.8", linewidth=0.6,
                  zorder=2 if likeliest else 1,
                  label="floes, " + words(cases[0]) if k == 0 else "floes, one change each" if cases[k - 1] == cases[0] != cases[k] else None)
    for k in range(1, 5):
        for (begin, end), value in zip(WINDOWS, windows[f"run{k}_N"]):
            axes.plot([begin, end], [value / 1e3] * 2, color="tab:orange", linewidth=1.2,
                      label="four runs of another program, means" if (k, begin) == (1, 0) else None)
    axes.set(xlabel="time, s", ylabel="load, kN for 10 m", xlim=(0, 464), ylim=(0, None))
    axes.legend(fontsize="small", loc="upper left")
    figure.savefig(path, metadata={"Date": None})


if __name__ == "__main__":
    if make({PAGE: {"level": load_table, "level_widths": widths, "level_peaks": peak_table}}, __doc__, collect=collect):
        draw(DATA / "level_case1.svg")
