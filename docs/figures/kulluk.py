#!/usr/bin/python3
"""The figure of docs/validation.md of loads and mooring forces over the thickness of the ice. Writes docs/kulluk/load.svg, and
says to which power of the thickness the mean load grows.

    floes run configs/kulluk.toml -o kulluk.h5
    docs/figures/kulluk.py kulluk.h5
"""
import pathlib
import sys

import h5py
import numpy as np

from endless import interval, plt

DOCS = pathlib.Path(__file__).resolve().parent.parent
MN = 1e6


def read(path):
    """thickness, m -> quantity -> its values over the members that are done."""
    found = {}
    with h5py.File(path) as file:
        case, done = file["members/case"][()], file["members/status"][()] == 0
        one_second = int(np.flatnonzero(np.isclose(file["averaging_time"][()], 1))[0])
        for number, name in enumerate(file["cases/name"].asstr()[()]):
            rows = done & (case == number)
            member = lambda key: file["members/" + key][()][rows]
            found[float(name.removesuffix("_m"))] = {
                "mean": member("mean_load") / MN, "peak": file["averaged/mean_maximum"][()][rows, one_second] / MN,
                "force": member("mean_maximum_surge_mooring") / MN}
    return found


def draw(found):
    figure, axes = plt.subplots(figsize=(6.5, 3.6), layout="constrained")
    for key, label, colour in (("mean", "mean load", "tab:blue"), ("peak", "mean maximum over 1 s", "tab:orange"),
                               ("force", "mean maximum of the mooring force", "tab:green")):
        values = np.array([interval(of[key]) for of in found.values()])
        axes.errorbar(list(found), values[:, 0], (values[:, 0] - values[:, 1], values[:, 2] - values[:, 0]), label=label,
                      color=colour, marker="o", capsize=3)
    axes.set(xlabel="thickness of the ice, m", ylabel="MN", xlim=(0, None), ylim=(0, None))
    axes.legend(frameon=False)
    (DOCS / "kulluk").mkdir(exist_ok=True)
    figure.savefig(DOCS / "kulluk" / "load.svg", metadata={"Date": None})


def exponent(found):
    """Slope of the mean load over the thickness on logarithmic axes, of each arrangement: its interval()."""
    return interval(np.polyfit(np.log(list(found)), np.log([of["mean"] for of in found.values()]), 1)[0])


if __name__ == "__main__":
    taken = read(sys.argv[1])
    draw(taken)
    print("mean load: thickness to the power of {:.1f} [{:.1f}, {:.1f}]".format(*exponent(taken)))
