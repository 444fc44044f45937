#!/usr/bin/python3
"""The table and the picture of docs/design_load.md, from the data in docs/design.

Usage:
    design_load.py                      writes table and picture
    design_load.py --check              writes nothing; fails if the page differs from the data
    design_load.py --collect CAMPAIGN [FLOES]
                                        first takes the tails of the campaign file with the program FLOES
"""
import json
import pathlib

import numpy as np
import pandas as pd

from page_blocks import make
from told import told
from validation_tables import table

DATA = pathlib.Path(__file__).resolve().parent.parent / "design"
PAGE = DATA.parent / "design_load.md"
SHOWN = ["both tails", "Pareto tail", "Weibull tail", "Gumbel", "GEV"]


def take_tails(campaign, program="./floes"):
    """Of the first case of the campaign."""
    found = told(program, "design", campaign)["design"]
    basis = found["basis"][0]
    kept = {"basis": basis} | {name: [one for one in found[name] if one["case"] == basis["case"]]
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


def draw(path):
    from validation_figures import finish, plt  # needs matplotlib, which --check does not

    found = tails()
    basis = found["basis"]
    figure, (left, middle, right) = plt.subplots(1, 3, figsize=(13, 4.2))
    rates = pd.DataFrame(found["rates"])
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
    loads = pd.DataFrame(found["loads"])
    own = loads[(loads.method == "both tails") & (loads.figure == "quantile")].iloc[0]
    points = pd.DataFrame(found["over_thresholds"])
    right.plot(100 * points.share, points.load, "o-", color="black", label="by share")
    right.errorbar(25, own.load, [[own.load - own.load_low], [own.load_high - own.load]], color="#D55E00", fmt="s",
                   capsize=4, label="both tails, 95 %")
    right.set_ylim(bottom=0)
    right.set_xlabel("share of the peaks that the tails are fitted to, %")
    right.set_ylabel("3 h load with 10 %\nexceedance probability, N")
    right.legend(frameon=False, fontsize=8)
    finish(figure, path)


if __name__ == "__main__":
    if make({PAGE: {"example": example}}, __doc__, collect=take_tails):
        draw(DATA / "tails.svg")
