#!/usr/bin/python3
"""Do two solvers give the same statistics? Paired tests over common arrangements.

Usage: equivalence.py A.h5 B.h5 [A2.h5 B2.h5 …]
       equivalence.py --reference CASE A.h5      every other case of one file (A) against this one (B)

A and B are campaign files of the same configuration with different `general.solver`; further pairs, of other seeds, are
pooled with the first; what only one of them has does not count. For every statistic of Table 3 and every case: the mean
of A, of B, of the difference with its 95 % interval, p of the paired t test, and p after Holm's correction over all rows.
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


def pairs(path_a, path_b):
    """{(column, case): [(a, b), …]} of the members that are done in both."""
    with h5py.File(path_a) as a, h5py.File(path_b) as b:
        common = min(len(a["arrangements/pose"]), len(b["arrangements/pose"]))
        poses = [file["arrangements/pose"][:common] for file in (a, b)]
        if not np.all((poses[0] == poses[1]) | np.isnan(poses[0]) | np.isnan(poses[1])):  # nan: not computed yet
            sys.exit(f"{path_a} and {path_b} do not have the same arrangements, so their members are no pairs.")
        names = [name.decode() if isinstance(name, bytes) else name for name in a["cases/name"][:]]

        def values(file, column, index):
            return file[f"members/{column}"][:][file["members/case"][:] == index][:common]

        return {(column, name): [pair for pair in zip(values(a, column, index), values(b, column, index))
                                 if np.all(np.isfinite(pair))]
                for column in COLUMNS for index, name in enumerate(names)}


def pairs_within(path, reference):
    """The same of one file: each other case with the reference, arrangement by arrangement."""
    with h5py.File(path) as file:
        names = [name.decode() if isinstance(name, bytes) else name for name in file["cases/name"][:]]
        if reference not in names:
            sys.exit(f"{path} has no case {reference}; it has {', '.join(names)}.")
        case = file["members/case"][:]
        arrangement = file["members/arrangement"][:]

        def of_case(column, index):
            mine = case == index
            return file[f"members/{column}"][:][mine][np.argsort(arrangement[mine])]

        return {(column, name): [pair for pair in zip(of_case(column, index), of_case(column, names.index(reference)))
                                 if np.all(np.isfinite(pair))]
                for column in COLUMNS for index, name in enumerate(names) if name != reference}


def main(paths):
    if paths[0] == "--reference":
        return show(pairs_within(paths[2], paths[1]))
    pooled = {}
    for path_a, path_b in zip(paths[::2], paths[1::2]):
        for key, values in pairs(path_a, path_b).items():
            pooled.setdefault(key, []).extend(values)
    return show(pooled)


def show(pooled):
    rows = []
    for (column, name), values in pooled.items():
        if len(values) < 2:
            continue
        value_a, value_b = np.transpose(values)
        difference = value_a - value_b
        half = stats.sem(difference) * stats.t.ppf(0.975, len(difference) - 1)
        p = stats.ttest_1samp(difference, 0).pvalue
        rows.append((column, name, len(difference), value_a.mean(), value_b.mean(), difference.mean(), half, p))
    corrected = holm([row[-1] for row in rows])
    print("| statistic | case | n | A | B | A - B | p | p (Holm) |\n|---|---|---|---|---|---|---|---|")
    for (column, name, n, mean_a, mean_b, difference, half, p), adjusted in zip(rows, corrected):
        print(f"| {column} | {name} | {n} | {mean_a:.4g} | {mean_b:.4g} | {difference:+.3g} ± {half:.2g} | {p:.3f} | {adjusted:.2f} |")


if __name__ == "__main__":
    if len(sys.argv) < 3 or (len(sys.argv) % 2 == 0) != (sys.argv[1] == "--reference"):
        sys.exit(__doc__)
    main(sys.argv[1:])
