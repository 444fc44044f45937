#!/usr/bin/python3
"""Does a load foretell a larger one, from histories of campaign files (docs/decisions.md)?

Of each member, every 5 s of its window: the mean load of the last 1, 5 and 10 s, and the largest 1 s average of the 15 s
that begin 0, 2, 5 and 10 s later. Their rank correlation (Spearman) is over all members of a case together, as a score
that decides which run is to be continued would be; its 95 % interval is by bootstrap over members (1000, percentiles).

Usage:
    foretell.py --collect NAME FILE      takes the correlations of a campaign file's cases into docs/year/foretell.csv
    foretell.py --show FILE ...          only prints those of the campaign files
"""
import pathlib
import sys

import h5py
import numpy as np
import pandas as pd

DATA = pathlib.Path(__file__).resolve().parent.parent / "year" / "foretell.csv"
PAST = [1, 5, 10]      # s
LATER = [0, 2, 5, 10]  # s
AHEAD = 15             # s
PEAK = 1               # s, that the largest load is averaged over
EVERY = 5              # s
RESAMPLES = 1000


def running_means(values, count):
    """Of each `count` successive values: number k is that of values[k] to values[k + count - 1]."""
    sums = np.concatenate([[0.0], np.cumsum(values)])
    return (sums[count:] - sums[:-count]) / count


def pairs_of(load, step, past, later):
    """Rows of (mean load of the last `past` s, largest load of the 15 s that begin `later` s after them)."""
    count, peak = round(past / step), round(PEAK / step)
    before, peaks = running_means(load, count), running_means(load, peak)
    first, ahead = round(later / step), round(AHEAD / step)
    longest = round(max(PAST) / step)
    rows = []
    for now in range(longest, len(load) - first - ahead + 1, round(EVERY / step)):
        rows.append((before[now - count], peaks[now + first:now + first + ahead - peak + 1].max()))
    return np.array(rows).reshape(-1, 2)


def rank_correlation(rows):
    ranks = pd.DataFrame(rows).rank()
    return ranks[0].corr(ranks[1])


def with_interval(members):
    random = np.random.default_rng(36)
    drawn = [rank_correlation(np.concatenate([members[k] for k in random.integers(0, len(members), len(members))]))
             for _ in range(RESAMPLES)]
    return rank_correlation(np.concatenate(members)), *np.percentile(drawn, [2.5, 97.5])


def correlations(path, name):
    rows = []
    with h5py.File(path) as file:
        if "history/surge_load" not in file:
            sys.exit(f"{path} keeps no histories; run its campaign with analysis.history_steps = 1")
        cases = [case.decode() if isinstance(case, bytes) else case for case in file["cases/name"][:]]
        for index, case in enumerate(cases):
            step = float(file["cases/time_step"][index]) * int(file["cases/history_stride"][index])
            first, count = (round(float(file[f"cases/{key}"][index]) / step) for key in ("steady_start", "window"))
            done = np.flatnonzero((file["members/case"][:] == index) & (file["members/status"][:] == 0))
            loads = [file["history/surge_load"][member][first:first + count] for member in done]
            if count * step < max(PAST) + max(LATER) + AHEAD:
                print(f"{path}, {case}: a window of {count * step:g} s has no room for {max(PAST)} s before and "
                      f"{max(LATER) + AHEAD} s after; left out", file=sys.stderr)
                continue
            for past in PAST:
                for later in LATER:
                    members = [pairs_of(load, step, past, later) for load in loads]
                    rows.append([name, case, len(members), sum(map(len, members)), past, later,
                                 *with_interval(members)])
    columns = ["campaign", "case", "members", "moments", "past_s", "later_s", "correlation", "low", "high"]
    return pd.DataFrame(rows, columns=columns)


def main(words):
    if words[:1] == ["--show"]:
        for path in words[1:]:
            print(correlations(path, pathlib.Path(path).stem).to_string(index=False, float_format="{:.3f}".format))
        return
    if words[:1] != ["--collect"] or len(words) != 3:
        sys.exit(__doc__)
    new = correlations(words[2], words[1])
    if DATA.exists():
        old = pd.read_csv(DATA)
        new = pd.concat([old[old.campaign != words[1]], new])
    new.to_csv(DATA, index=False, float_format="%.4f")


if __name__ == "__main__":
    main(sys.argv[1:])
