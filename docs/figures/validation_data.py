"""The data of the validation: the paper's figures, and the summaries of the campaigns as tables."""
import json
import pathlib

import numpy as np
import pandas as pd
from scipy import stats

SUMMARIES = pathlib.Path(__file__).resolve().parent.parent / "validation"
# Table 3 computed in two ways, 30, 60 and 200 MPa each: campaign -> what the tables call it.
WAYS = {"table3": "paper's contacts, scattered", "crystalline": "paper's contacts, crystalline"}
# The tank test with the default physics on three walls: case of tank_walls -> wall below the waterline.
WALLS = {"r_0.432": "67.7°", "r_0.445": "69.1°", "r_0.464": "71.3°"}
CAMPAIGNS = [*WAYS, "tank_walls"]
MODULI = {"E30": 30, "E60": 60, "E200": 200}

# Table 3 of the paper: one run for each E. The experiment: its text.
PAPER = pd.DataFrame(
    {"mean_load": [26.50, 30.28, 28.32], "sd_load": [15.52, 18.43, 18.67],
     "segment_1_maximum": [106.58, 162.22, 86.48], "segment_2_maximum": [46.75, 93.10, 127.36],
     "segment_3_maximum": [126.84, 98.50, 150.30], "mean_maximum": [93.39, 117.94, 121.38],
     "sd_maximum": [34.00, 31.39, 26.39], "failure_ratio": [0.106, 0.101, 0.175]}, index=MODULI)
EXPERIMENT = {"mean_load": 38.8, "maximum_load": 102.7, "failure_ratio": 0.22}
FITTED_TO = {"fit_paper": PAPER.loc["E60", "mean_load"]}
WINDOW_START = 120  # s; where the steady window of the scattered fields begins

LABELS = {"mean_load": "mean load, N", "sd_load": "SD, N", "mean_maximum": "mean of the maxima, N",
          "mean_maximum_1s": "mean of the maxima over 1 s, N", "failure_ratio": "broken floes, %"}


def members(name):
    """One row for each finished member; the failure ratio is in percent, as in the paper."""
    table = pd.read_csv(SUMMARIES / f"{name}.members.csv")
    return table[table.status == "done"].assign(failure_ratio=lambda rows: 100 * rows.failure_ratio)


def pairs(name):
    return pd.read_csv(SUMMARIES / f"{name}.pairs.csv")


def variations(name):
    """What each case of a study by floes vary changes, sorted by the mean load, by quantity."""
    return pd.read_csv(SUMMARIES / f"{name}.model.csv")


def windows(name):
    """One row for each finished member and start of a window of the table's length: the load in that window."""
    return pd.read_csv(SUMMARIES / f"{name}.windows.csv")


def largest(name):
    """The largest load in the window of each finished member, averaged over several times."""
    return pd.read_csv(SUMMARIES / f"{name}.largest.csv")


def of_tank(quantity):
    """Wall -> one figure of each run, in the unit of the page; "maximum_load_1s": the largest load averaged over 1 s."""
    name, _, time = quantity.partition("_load_")
    if time:
        table_ = largest("tank_walls")
        table_ = table_[np.isclose(table_.averaged_over_s, float(time.removesuffix("s")))]
        table_ = table_.assign(**{quantity: table_.maximum_load})
    else:
        table_ = members("tank_walls")
    scale = 100 if quantity == "split_ratio" else 1  # members() has percent for failure_ratio
    return {case: scale * table_[table_.case == case].sort_values("arrangement")[quantity].to_numpy() for case in WALLS}


def hybrid():
    return pd.DataFrame(json.loads((SUMMARIES / "hybrid.json").read_text())["rows"])


def paper(case, quantity):
    return PAPER.loc[case, quantity] * (100 if quantity == "failure_ratio" else 1)


def is_maximum(quantity):
    """A maximum or a mean of maxima: single runs are predicted on a logarithmic scale."""
    return quantity.endswith(("maximum", "maximum_load")) and not quantity.startswith("sd_")


def half_width(values, one_run=False):
    """Half width of the 95 % t interval: of the mean, or the prediction interval of one further run."""
    n = len(values)
    spread = np.std(values, ddof=1) * np.sqrt((1 if one_run else 0) + 1 / n)
    return stats.t.ppf(0.975, n - 1) * spread


def interval(values, one_run=False, positive=False):
    """Mean, lower and upper bound; the lower bound is cut at zero, as loads and ratios are not negative. `positive`: the
    bounds are those of the logarithms, as floes summarize has them for one further run of a maximum."""
    if positive:
        logs = np.log(values)
        half = half_width(logs, one_run)
        return np.mean(values), np.exp(np.mean(logs) - half), np.exp(np.mean(logs) + half)
    mean, half = np.mean(values), half_width(values, one_run)
    return mean, max(mean - half, 0.0), mean + half


def pooled(samples, one_run=False, positive=False):
    """Mean, lower and upper bound of each of some samples, name -> values, with the scatter that they have in common: as
    interval(), with the standard deviation over all and the degrees of freedom of all."""
    logs = {name: np.log(values) if positive else np.asarray(values, float) for name, values in samples.items()}
    freedom = sum(len(values) - 1 for values in logs.values())
    spread = np.sqrt(sum(((values - values.mean()) ** 2).sum() for values in logs.values()) / freedom)
    found = {}
    for name, values in logs.items():
        half = stats.t.ppf(0.975, freedom) * spread * np.sqrt((1 if one_run else 0) + 1 / len(values))
        bounds = np.array([values.mean() - half, values.mean() + half])
        found[name] = (np.mean(samples[name]), *(np.exp(bounds) if positive else np.maximum(bounds, 0.0)))
    return found


def common_scatter(samples):
    """Covariance that some samples, each an array (run, quantity), have in common, and its degrees of freedom."""
    freedom = sum(len(values) - 1 for values in samples)
    return sum((values - values.mean(axis=0)).T @ (values - values.mean(axis=0)) for values in samples) / freedom, freedom


def as_far_off(figures, mean, share, scatter, freedom):
    """How often one further run lies as far from `mean` as `figures` do, or farther, in all quantities at once, by Hotelling's
    T². `share`: variance of the mean over that of a run; `scatter`: covariance of runs, of `freedom`."""
    off, count = figures - mean, len(figures)
    squared = off @ np.linalg.solve(scatter, off) / (1 + share)
    return stats.f.sf(squared * (freedom - count + 1) / (freedom * count), count, freedom - count + 1)


def change(table, quantity, case, base, same_floes=True):
    """Change of `case` from `base` and the half width of its 95 % interval: paired, or by Welch's t if the two began from
    other floes, of which arrangements have the numbers alone in common."""
    if same_floes:
        wide = across(table, quantity, [case, base])
        differences = wide[case] - wide[base]
        return differences.mean(), half_width(differences)
    one, other = (table[table.case == name][quantity].dropna() for name in (case, base))
    errors = one.var() / len(one), other.var() / len(other)
    freedom = sum(errors) ** 2 / (errors[0] ** 2 / (len(one) - 1) + errors[1] ** 2 / (len(other) - 1))
    return one.mean() - other.mean(), stats.t.ppf(0.975, freedom) * np.sqrt(sum(errors))


def across(table, quantity, cases=None):
    """Rows: arrangements that all the cases have; columns: cases."""
    wide = table.pivot(index="arrangement", columns="case", values=quantity)
    return wide[cases if cases is not None else list(dict.fromkeys(table.case))].dropna()
