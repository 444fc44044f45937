#!/usr/bin/python3
"""Of docs/year.md: which quantile of the largest load of a state, on the contour of a probability, is the load that years
exceed with that probability. Loads and their variability are given by formula, so both are known. Prints a table.

Usage: contour_percentile.py ICE [FLOES]

ICE is what floes contour reads.
"""
import sys

import numpy as np
from scipy.optimize import brentq
from scipy.stats import norm

from told import told
from validation_tables import table

GROWTH = {"thickness": (1, 0), "thickness^2": (2, 0), "thickness^1.5 · speed^0.5": (1.5, 0.5)}
VARIABILITY = {"6 %": 0.06, "14 %": 0.14, "30 %": 0.30}  # scale of Gumbel's distribution over its location


def value(law, score, given):
    first, second = (law[f"{name}_a"] + (law[f"{name}_b"] * given ** law[f"{name}_c"] if law[f"{name}_b"] else 0)
                     for name in ("first", "second"))
    if law["distribution"] == "weibull":
        return first * (-norm.logsf(score)) ** (1 / second)
    if law["distribution"] == "lognormal":
        return first * np.exp(second * score)
    if law["distribution"] == "exponential":
        return first * -norm.logsf(score)
    return first + second * score


def main(arguments):
    if len(arguments) not in (1, 2):
        sys.exit(__doc__)
    ice, *program = arguments
    found = told(*(program or ["./floes"]), "contour", ice, "--points", "360")
    one, other = found["inputs"]
    scores = np.linspace(-8, 8, 801)
    weights = norm.pdf(scores)
    weights /= weights.sum()
    x = value(one, scores, 0.0)[:, None]
    y = value(other, scores[None, :], x)
    both = weights[:, None] * weights[None, :]
    rows = []
    for name, (power, speed) in GROWTH.items():
        for words, spread in VARIABILITY.items():
            cells = []
            for level in sorted({point["per_year"] for point in found["contours"]}, reverse=True):
                own = [point for point in found["contours"] if point["per_year"] == level]
                beyond = norm.sf(own[0]["radius"])  # of one state, of the year's load as of the contour
                location = x ** power * y ** speed
                below = lambda load: np.sum(both * np.exp(-np.exp(-(load / location - 1) / spread)))
                top = 20 * location[scores < 7][-1].max()
                load = brentq(lambda load: 1 - below(load) - beyond, 1e-6 * top, top, xtol=1e-12 * top)
                keys = [law["key"] for law in found["inputs"]]
                largest = max(point[keys[0]] ** power * point[keys[1]] ** speed for point in own)
                cells.append(f"{100 * np.exp(-np.exp(-(load / largest - 1) / spread)):.0f} %")
            rows.append([name, words, *cells])
    print(table(["load grows with", "variability", "quantile for 10^-2", "quantile for 10^-4"], rows))


if __name__ == "__main__":
    main(sys.argv[1:])
