#!/usr/bin/python3
"""Do two solvers give the same statistics? Paired tests over common arrangements.

Usage: equivalence.py A.h5 B.h5

A and B are campaign files of the same configuration with different `general.solver`. For every statistic of Table 3 and
every case: the mean of A, of B, of the difference with its 95 % interval, p of the paired t test, and p after Holm's
correction over all rows.
"""
import sys

import h5py
import numpy as np
from scipy import stats

COLUMNS = ["mean_load", "sd_load", "maximum_load", "mean_maximum", "sd_maximum", "failure_ratio"]


def holm(p):
    order = np.argsort(p)
    scaled = np.array(p)[order] * np.arange(len(p), 0, -1)
    corrected = np.empty(len(p))
    corrected[order] = np.minimum(np.maximum.accumulate(scaled), 1)
    return corrected


def main(path_a, path_b):
    with h5py.File(path_a) as a, h5py.File(path_b) as b:
        names = [name.decode() if isinstance(name, bytes) else name for name in a["cases/name"][:]]
        case = a["members/case"][:]
        if not np.array_equal(a["arrangements/pose"][:], b["arrangements/pose"][:]):
            sys.exit("The two campaigns do not have the same arrangements, so their members are no pairs.")
        rows = []
        for column in COLUMNS:
            for index, name in enumerate(names):
                value_a, value_b = (file[f"members/{column}"][:][case == index] for file in (a, b))
                difference = (value_a - value_b)[np.isfinite(value_a - value_b)]
                half = stats.sem(difference) * stats.t.ppf(0.975, len(difference) - 1)
                p = stats.ttest_1samp(difference, 0).pvalue
                rows.append((column, name, len(difference), np.nanmean(value_a), np.nanmean(value_b), difference.mean(), half, p))
    corrected = holm([row[-1] for row in rows])
    print("| statistic | case | n | A | B | A - B | p | p (Holm) |\n|---|---|---|---|---|---|---|---|")
    for (column, name, n, mean_a, mean_b, difference, half, p), adjusted in zip(rows, corrected):
        print(f"| {column} | {name} | {n} | {mean_a:.4g} | {mean_b:.4g} | {difference:+.3g} ± {half:.2g} | {p:.3f} | {adjusted:.2f} |")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
