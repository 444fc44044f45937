#!/usr/bin/python3
"""The tables and the picture of docs/design_load.md, and the tables of coverage of docs/statistics.md, from the data in
docs/design.

Usage:
    design_load.py                      writes tables and picture
    design_load.py --check              writes nothing; fails if a page differs from the data
    design_load.py --coverage           first takes the trials of build/release/tests/test_coverage from standard input
    design_load.py --collect CAMPAIGN [FLOES]
                                        first takes the tails of the campaign file with the program FLOES
"""
import json
import pathlib
import subprocess
import sys

import numpy as np
import pandas as pd

from page_blocks import fill_or_check
from validation_tables import table

DATA = pathlib.Path(__file__).resolve().parent.parent / "design"
PAGE = DATA.parent / "design_load.md"
STATISTICS = DATA.parent / "statistics.md"
COLUMNS = ["process", "exposure", "method", "quantile", "error_percent"]
INTERVAL_COLUMNS = ["method", "set", "n", "within_percent", "below_percent", "width"]
PAIR_COLUMNS = ["pairs", "n", "none_met_percent", "within_percent", "student_within_percent", "width", "student_width"]
STOP_COLUMNS = ["members", "target_percent", "minimum", "median_n", "by_30_percent", "none_met_percent", "within_percent",
                "near_percent"]
LOAD_STOP_COLUMNS = ["members", "target_percent", "campaigns", "median_n", "within_percent", "below_percent",
                     "error_percent"]
SHOWN = ["both tails", "Pareto tail", "Weibull tail", "Gumbel", "GEV"]
SHOWN_EXPOSURE = 10       # times the time run; all trials are in coverage.csv


def take_coverage(lines):
    """Rows as the test prints them: what is measured, then the columns."""
    rows = [[cell.strip() for cell in line.strip().strip("|").split("|")] for line in lines if line.startswith("| ")]
    for kind, columns, name in [("design", COLUMNS, "coverage"), ("interval", INTERVAL_COLUMNS, "coverage_intervals"),
                                ("pair", PAIR_COLUMNS, "coverage_pairs"),
                                ("stop", STOP_COLUMNS, "coverage_stops"),
                                ("loadstop", LOAD_STOP_COLUMNS, "coverage_load_stops")]:
        own = [row[1:2] + [cell.removesuffix(" %") for cell in row[2:]] for row in rows if row[0] == kind]
        if own:
            put_rows(DATA / f"{name}.csv", pd.DataFrame(own, columns=columns))


def put_rows(path, rows):
    """Into the file, in the place of those of the same kind and number, so that the test can be run in slices."""
    keys = list(rows.columns[:2])
    if path.exists():
        old = pd.read_csv(path, dtype=str, keep_default_na=False)
        rows = pd.concat([old, rows]).drop_duplicates(keys + [name for name in ("method", "quantile", "exposure", "minimum", "n")
                                                              if name in rows.columns], keep="last")
        order = {key: place for place, key in enumerate(dict.fromkeys(map(tuple, old[keys].values)))}
        rows = rows.sort_values(keys[0], kind="stable",
                                key=lambda _: [order.get(tuple(key), len(order)) for key in rows[keys].values])
    rows.to_csv(path, index=False)


def whole(value):
    return "–" if pd.isna(value) else f"{value:.0f} %"


def interval_coverage():
    data = pd.read_csv(DATA / "coverage_intervals.csv")
    data = data[data.method == "design load, both tails"]  # the page says in words how often the others hold
    members = sorted(data.n.unique())
    rows = []
    for name, own in data.groupby("set", sort=False):
        own = own.set_index("n")
        rows.append([name] + [f"{own.loc[n, 'within_percent']:.0f} % ({own.loc[n, 'below_percent']:.0f}, "
                              f"{own.loc[n, 'width']:.2f})" for n in members])
    return table(["design load, both tails", *[f"{n} members" for n in members]], rows)


def pair_coverage():
    return table(["pairs", "n", "samples without a jam", "of the others, hold", "Student's t holds",
                  "width / load of a case", "Student's"],
                 [[one.pairs, str(one.n), whole(one.none_met_percent), whole(one.within_percent),
                   whole(one.student_within_percent), f"{one.width:.2f}", f"{one.student_width:.2f}"]
                  for one in pd.read_csv(DATA / "coverage_pairs.csv").query("n == 20 or n == 50").itertuples()])


def stop_coverage():
    return table(["members", "target", "`stop.minimum`", "median n", "ended by n = 30", "ended without the other kind",
                  "interval holds", "mean within the target"],
                 [[one.members, f"{one.target_percent:g} %", str(one.minimum), f"{one.median_n:.0f}",
                   whole(one.by_30_percent), whole(one.none_met_percent), whole(one.within_percent),
                   whole(one.near_percent)]
                  for one in pd.read_csv(DATA / "coverage_stops.csv").itertuples()])


def load_stop_coverage():
    return table(["members", "target", "campaigns", "median n", "interval holds", "interval ends below", "error"],
                 [[one.members, f"{one.target_percent:g} %", str(one.campaigns), f"{one.median_n:.0f}",
                   whole(one.within_percent), whole(one.below_percent), f"{one.error_percent:+.0f} %"]
                  for one in pd.read_csv(DATA / "coverage_load_stops.csv").itertuples()])


def take_tails(campaign, program):
    """Of the first case of the campaign."""
    command = [program, "design", campaign, "--format", "json"]
    told = json.loads(subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout)["design"]
    basis = told["basis"][0]
    kept = {"basis": basis} | {name: [one for one in told[name] if one["case"] == basis["case"]]
                               for name in ("over_thresholds", "loads", "rates")}
    kept["rates"] = [point for point in kept["rates"] if point["load"] > 0.6 * basis["threshold"]]
    (DATA / "tails.json").write_text(json.dumps(kept, indent=1) + "\n")


def tails():
    return json.loads((DATA / "tails.json").read_text())


def example():
    loads = pd.DataFrame(tails()["loads"])

    def cell(method, figure):
        own = loads[(loads.method == method) & (loads.figure == figure)].iloc[0]
        if pd.isna(own.load):
            return "–"
        return f"{own.load:.0f}" + ("" if pd.isna(own.load_low) else f" [{own.load_low:.0f}, {own.load_high:.0f}]")

    return table(["method", "expected largest load in 3 h, N", "3 h load with 10 % exceedance probability, N"],
                 [[method, cell(method, "expected"), cell(method, "quantile")] for method in SHOWN])


def coverage():
    data = pd.read_csv(DATA / "coverage.csv")
    data = data[(data["quantile"] == 0.9) & (data.exposure == SHOWN_EXPOSURE)]
    rows = []
    for process, own in data.groupby("process", sort=False):
        own = own.set_index("method")
        rows.append([process] + [f"{own.loc[m, 'error_percent']:+.0f} %" for m in SHOWN])
    return table(["load", *SHOWN], rows)


def draw(path):
    import matplotlib

    matplotlib.use("svg")
    matplotlib.rcParams["svg.hashsalt"] = "floes"
    import matplotlib.pyplot as plt

    told = tails()
    basis = told["basis"]
    figure, (left, middle, right) = plt.subplots(1, 3, figsize=(13, 4.2))
    rates = pd.DataFrame(told["rates"])
    left.step(rates.load, 3600 * rates.seen_per_s, color="black", linewidth=1, label="declustered peaks seen")
    for name, colour in [("pareto", "#0072B2"), ("weibull", "#D55E00")]:
        left.plot(rates.load, 3600 * rates[f"{name}_per_s"].astype(float), color=colour, label=f"{name.title()} tail")
    exposure = basis["exposure"]
    left.axhline(3600 / exposure, color="0.6", linestyle=":", label=f"once in {exposure / 3600:g} h")
    left.set_yscale("log")
    left.set_xlabel("load averaged over 1 s, N")
    left.set_ylabel("peaks above it in an hour")
    left.legend(frameon=False, fontsize=8)
    peaks = rates.load.to_numpy()[::-1]
    middle.plot(peaks[:-5], [(peaks[peaks > u] - u).mean() for u in peaks[:-5]], color="black", linewidth=1,
                label="peaks seen")
    scale, shape, threshold = basis["pareto_scale"], basis["pareto_shape"], basis["threshold"]
    above = np.array([threshold, peaks[-5]])
    middle.plot(above, (scale + shape * (above - threshold)) / (1 - shape), color="#0072B2", label="Pareto tail")
    middle.set_ylim(bottom=0)
    middle.set_xlabel("threshold, N")
    middle.set_ylabel("mean excess over it, N")
    middle.legend(frameon=False, fontsize=8)
    loads = pd.DataFrame(told["loads"])
    own = loads[(loads.method == "both tails") & (loads.figure == "quantile")].iloc[0]
    points = pd.DataFrame(told["over_thresholds"])
    right.plot(100 * points.share, points.load, "o-", color="black", label="by share")
    right.errorbar(25, own.load, [[own.load - own.load_low], [own.load_high - own.load]], color="#D55E00", fmt="s",
                   capsize=4, label="both tails, 95 %")
    right.set_ylim(bottom=0)
    right.set_xlabel("share of the peaks that the tails are fitted to, %")
    right.set_ylabel("3 h load with 10 %\nexceedance probability, N")
    right.legend(frameon=False, fontsize=8)
    for axes in (left, middle, right):
        axes.spines[["top", "right"]].set_visible(False)
    figure.tight_layout()
    figure.savefig(path, metadata={"Date": None})


def main(arguments):
    if arguments[:1] == ["--coverage"]:
        take_coverage(sys.stdin)
    if arguments[:1] == ["--collect"]:
        take_tails(arguments[1], arguments[2] if len(arguments) > 2 else "./floes")
    check = arguments == ["--check"]
    fill_or_check({PAGE: {"example": example, "coverage": coverage},
                   STATISTICS: {"intervals": interval_coverage, "pairs": pair_coverage, "stops": stop_coverage,
                                "loadstops": load_stop_coverage}},
                  check, "design_load.py")
    if not check:
        draw(DATA / "tails.svg")


if __name__ == "__main__":
    main(sys.argv[1:])
