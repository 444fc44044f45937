"""The tables of docs/validation.md, each a function that gives Markdown."""
import functools
import itertools
import re
import textwrap

import numpy as np
from scipy import stats

from validation_data import (EXPERIMENT, FITTED_TO, LABELS, MODULI, PAPER, SUMMARIES, WALLS, WAYS, WINDOW_START,
                             across, as_far_off, common_scatter, half_width, interval, is_maximum, members, of_tank,
                             pairs, paper, pooled, variations, windows)

STARTS_SHOWN = [80, WINDOW_START]  # s
SHOWN = ["mean_load", "sd_load", "mean_maximum", "failure_ratio"]  # of the paper's Table 3
COMPARED = ["mean_load", "mean_maximum", "failure_ratio", "mean_maximum_1s"]


def table(heading, rows):
    lines = ["| " + " | ".join(heading) + " |", "|---" * len(heading) + "|"]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def digits(value):
    """Decimals that give three significant digits, as many as any figure here deserves."""
    return 0 if abs(value) >= 99.95 else 1 if abs(value) >= 9.995 else 2


def number(value):
    return f"{value:.{digits(value)}f}"


def bracketed(mean, low, high):
    return f"{number(mean)} [{number(low)}, {number(high)}]"


def with_interval(values):
    return bracketed(*interval(values))


def plus_minus(mean, half):
    return f"{number(mean)} ± {half:.{digits(mean)}f}"


def beside_runs(mean, half, low, high, reference):
    """A mean with half of its 95 % interval, and what 95 % of single runs give, in brackets: bold without the reference."""
    mark = "" if low <= reference <= high else "**"
    return f"{plus_minus(mean, half)} {mark}({number(low)} to {number(high)}){mark}"


def difference(mean, side, beyond=None):
    """With the longer side of its interval, bold where that excludes zero; both sides are alike unless `beyond` says so."""
    mark = "**" if (abs(mean) > side if beyond is None else beyond) else ""
    return f"{mark}{mean:+.1f} ± {side:.1f}{mark}"


def listed(values, form=str):
    return ", ".join(form(value) for value in values)


def off(computed, reference):
    return listed([100 * (one / other - 1) for one, other in zip(computed, reference)], "{:+.0f}".format) + " %"


# -- the one unknown that is fitted

def bottom_radius(case):
    return float(case.removeprefix("bottom_").removesuffix("mm")) / 1000


def wall_angle(radius):
    return np.degrees(np.arctan2(0.443, 0.614 - radius))


def fit_radius(means, radii, target):
    """The radius at which a parabola through the logarithms of the means meets the target; a parabola that does not is
    replaced by its straight line."""
    for degree in (2, 1):
        roots = np.roots(np.polyfit(radii, np.log(means / target), degree))
        real = [root.real for root in roots if abs(root.imag) < 1e-12]
        if real:
            return min(real, key=lambda root: abs(root - np.mean(radii)))
    return np.nan


def fitted(means, target, scatter=0.0):
    """Bottom radius in m: estimate, and the 95 % interval over arrangements (percentile bootstrap, 10,000 draws).
    `means`: a row for each arrangement, a column for each case. `scatter`: SD of the target, which is of one run."""
    radii = np.array([bottom_radius(case) for case in means.columns])
    generator = np.random.default_rng(1)
    draws = generator.integers(len(means), size=(10000, len(means)))
    targets = target + scatter * generator.standard_normal(len(draws))
    fits = [fit_radius(means.values[rows].mean(axis=0), radii, one) for rows, one in zip(draws, targets)]
    low, high = np.nanquantile(fits, [0.025, 0.975])
    return fit_radius(means.values.mean(axis=0), radii, target), low, high


def loads_of_fit():
    own = windows("fit_paper")
    return own[own.start_s == WINDOW_START]


def scatter_of_a_run():
    """SD over arrangements of the mean load to which the wall is fitted, N."""
    return members("table3").query("case == 'E60'").mean_load.std()


@functools.cache
def fitted_to_paper(one_run=False):
    """As fitted(); `one_run`: with the scatter of the paper's run."""
    return fitted(across(loads_of_fit(), "mean_load"), FITTED_TO["fit_paper"], scatter_of_a_run() if one_run else 0.0)


def wall_radius(case):
    """Radius at the bottom, m, of a case of tank_walls."""
    return float(case.removeprefix("r_"))


def fit():
    def bounds(values, digits):
        return "{:.{digits}f} [{:.{digits}f}, {:.{digits}f}]".format(*values, digits=digits)

    best, of_a_run = fitted_to_paper(), fitted_to_paper(one_run=True)
    return (f"The radius is {bounds(best, 3)} m, a wall of {bounds(wall_angle(np.array(best)), 1)}°; with the scatter of the paper's\n"
            f"one run, ± {scatter_of_a_run():.1f} N (SD), {bounds(of_a_run, 3)} m and {bounds(wall_angle(np.array(of_a_run)), 1)}°.\n")


def window():
    """Trend of the load in windows that begin later and later, mean over the walls of each arrangement."""
    own = windows("fit_paper")
    trends = {start: own[own.start_s == start].groupby("arrangement").trend_N_per_100s.mean() for start in STARTS_SHOWN}
    shown = "; ".join(f"from {start} s on {difference(values.mean(), half_width(values))}" for start, values in trends.items())
    return textwrap.fill(f"Trend of the load in windows of 150 s, mean over the walls, N in 100 s: {shown}.", 125) + "\n"


# -- Table 3

def within(campaign, case, quantity):
    """The prediction interval of one run, and whether the paper's run lies in it."""
    own = members(campaign)
    _, low, high = interval(own[own.case == case][quantity], one_run=True, positive=is_maximum(quantity))
    return low, high, bool(low <= paper(case, quantity) <= high)


def count_within(campaign, cases=MODULI):
    return sum(within(campaign, case, quantity)[2] for quantity, case in itertools.product(PAPER.columns, cases))


def table3():
    own, rows = members("table3"), []
    for quantity in SHOWN:
        cells = [LABELS[quantity]]
        for case in MODULI:
            values, (low, high, _) = own[own.case == case][quantity], within("table3", case, quantity)
            cells.append(f"{number(paper(case, quantity))}; "
                         + beside_runs(values.mean(), half_width(values), low, high, paper(case, quantity)))
        rows.append(cells)
    return table(["the paper's run; mean ± (one run)", *[f"{modulus} MPa" for modulus in MODULI.values()]], rows)


# -- the paper's question

def signed_difference(row):
    scale = 100 if row.quantity == "failure_ratio" else 1
    mark = "**" if row.t_p_holm < 0.05 else ""
    return f"{mark}{scale * row.difference:+.1f}{mark} [{scale * row.difference_low:+.1f}, {scale * row.difference_high:+.1f}]"


def differences():
    found = {(row.quantity, row.first, row.second): row for row in pairs("table3").itertuples()}
    compared = list(itertools.combinations(MODULI, 2))
    rows = [[LABELS[quantity]] + [signed_difference(found[quantity, *pair]) for pair in compared] for quantity in COMPARED]
    return table([""] + [f"{second} - {first}" for first, second in compared], rows)


def findings(mean, peak, broken):
    """The trends of the paper's three runs, for arrays (..., case in the order of MODULI): name -> where it holds."""
    lowest_mean = mean.argmin(axis=-1) == 0
    highest_mean = mean.argmax(axis=-1) == 1
    lowest_peak = peak.argmin(axis=-1) == 0
    most_broken = broken[..., 2] > broken[..., :2].max(axis=-1)
    return {"mean load lowest at 30 MPa": lowest_mean, "most broken floes at 200 MPa": most_broken,
            "these and the mean highest at 60, the maxima lowest at 30 MPa":
            lowest_mean & highest_mean & lowest_peak & most_broken}


def trend():
    shown = ["mean_load", "mean_maximum", "failure_ratio"]
    found = findings(*[across(members("table3"), quantity, list(MODULI)).values for quantity in shown])
    told = []
    for name, holds in found.items():
        share = stats.binomtest(int(holds.sum()), len(holds)).proportion_ci(method="exact")
        told.append(f"{name} in {holds.sum()} of {len(holds)} [{100 * share.low:.0f}, {100 * share.high:.0f} %]")
    return textwrap.fill(f"Three runs on one arrangement show {'; '.join(told)}.", 125) + "\n"


# -- the tank test

# Quantity -> what the table calls it, the measured figure.
TANK = {"mean_load": ("mean load, N", EXPERIMENT["mean_load"]),
        "maximum_load_1s": ("largest load over 1 s, N", EXPERIMENT["maximum_load"]),
        "split_ratio": ("floes cracked through, %", 100 * EXPERIMENT["failure_ratio"])}
TIMES = ["1 s", "2 s"]  # over which the load cell may have averaged; the first is the test


def tank_runs(quantity):
    """Wall -> the interval of the mean, that of one run, and whether the measured figure lies in the latter."""
    walls, measured = of_tank(quantity), TANK[quantity][1]
    means, runs = pooled(walls), pooled(walls, one_run=True, positive=quantity.startswith("maximum"))
    return {case: (means[case], runs[case], bool(runs[case][1] <= measured <= runs[case][2])) for case in WALLS}


def experiment():
    rows = []
    for quantity, (label, measured) in TANK.items():
        rows.append([label, number(measured)] + [beside_runs(mean[0], mean[2] - mean[0], *run[1:], measured)
                                                 for mean, run, _ in tank_runs(quantity).values()])
    for time in TIMES:
        rows.append([f"the three together, largest over {time}", "", *map(of_runs, tank_together(time))])
    return table(["", "measured", *WALLS.values()], rows)


def tank_samples(time):
    """The test's three figures, and of each wall an array (run, quantity): largest loads, averaged over `time`, by their
    logarithm."""
    def scaled(quantity, values):
        return np.log(values) if quantity.startswith("maximum") else values

    of_time = [f"maximum_load_{time.replace(' ', '')}" if q.startswith("maximum") else q for q in TANK]
    samples = {case: np.column_stack([scaled(q, of_tank(q)[case]) for q in of_time]) for case in WALLS}
    return np.array([scaled(q, TANK[q][1]) for q in TANK]), samples


def tank_together(time=TIMES[0]):
    """How often a run on each wall is as far off as the test's three figures together, with the scatter of all runs."""
    figures, samples = tank_samples(time)
    common = common_scatter(samples.values())
    return [as_far_off(figures, values.mean(axis=0), 1 / len(values), *common) for values in samples.values()]


def best_wall():
    """The angle of the wall on which a run is most often as far off as the test's three figures, and how often: by a straight
    line over the radius through the walls, between the bounds that the scatter of the paper's run leaves."""
    figures, samples = tank_samples(TIMES[0])
    common = common_scatter(samples.values())
    at = np.concatenate([np.full(len(values), wall_radius(case)) for case, values in samples.items()])
    slope, level = np.polyfit(at, np.concatenate(list(samples.values())), 1)
    line = {}
    for radius in np.linspace(*fitted_to_paper(one_run=True)[1:], 100):
        of_mean = 1 / len(at) + (radius - at.mean()) ** 2 / ((at - at.mean()) ** 2).sum()
        line[radius] = as_far_off(figures, slope * radius + level, of_mean, *common)
    best = max(line, key=line.get)
    return wall_angle(best), line[best]


def of_runs(chance):
    return "below 1 %" if chance < 0.005 else f"{100 * chance:.0f} %"


def tank_says():
    low, high = (wall_angle(radius) for radius in fitted_to_paper(one_run=True)[1:])
    angle, most = best_wall()
    return f"A straight line through the walls, from {low:.1f} to {high:.1f}°, has at most {of_runs(most)}, at {angle:.1f}°.\n"


# -- the first screen

def at_full_scale():
    """Simulated mean load and Lindqvist's formula, MN, as docs/validation.md has them below "Full scale"."""
    page = (SUMMARIES.parent / "validation.md").read_text().partition("\n## Full scale\n")[2]
    simulated = re.search(r"bears ([\d.]+) \[", page)
    formula = re.search(r"concentration gives ([\d.]+) MN", page)
    if not simulated or not formula:
        raise SystemExit("docs/validation.md has no mean load below its heading Full scale, or not what the formula gives")
    return float(simulated[1]), float(formula[1])


def score():
    """What was fitted, computed and measured, and by how much the computed mean is off."""
    rows = []
    own = members("table3")
    fitted_to = {"mean_load": "the wall, to the one at 60 MPa", "failure_ratio": "two readings, chosen knowing it"}
    for quantity in ["mean_load", "mean_maximum", "failure_ratio"]:
        means = [own[own.case == case][quantity].mean() for case in MODULI]
        papers = [paper(case, quantity) for case in MODULI]
        inside = sum(within("table3", case, quantity)[2] for case in MODULI)
        rows.append([f"paper's Table 3: {LABELS[quantity]}", fitted_to.get(quantity, "nothing"), listed(means, number),
                     listed(papers, number), off(means, papers), f"{inside} of {len(means)}"])
    fields = [name.partition(", ")[2] for name in WAYS.values()]
    rows.append([f"all its figures; on {fields[1]} fields", "", "", "", "",
                 f"{count_within('table3')} of 24; {count_within('crystalline')}"])
    for quantity, (label, measured) in TANK.items():
        found = tank_runs(quantity)
        means = [mean[0] for mean, _, _ in found.values()]
        agrees = [WALLS[case] for case, (_, _, inside) in found.items() if inside]
        rows.append([f"tank test: {label}", "nothing", listed(means, number), number(measured),
                     off(means, [measured] * len(means)),
                     "on all three walls" if len(agrees) == len(WALLS) else f"at {', '.join(agrees)}" if agrees else "no"])
    rows.append(["tank test: the three together", "nothing", "", "", "",
                 f"as far off: {listed(tank_together(), of_runs)} of runs"])
    simulated, formula = at_full_scale()
    rows.append(["full scale: mean load, MN", "nothing", f"{simulated:.2f}", f"{formula:.2f}, a formula",
                 off([simulated], [formula]), "–"])
    return table(["", "fitted", "computed", "reference", "computed off by", "reference within one run"], rows)


# -- what the model leaves open

VARIED = {"mean_load": 1, "mean_maximum_1s": 1, "failure_ratio": 100}


def vary():
    """Cases that change a load; vary_says() has the others."""
    own = variations("vary_channel")
    rows = [["*as it is*"] + [f"{scale * row.base:.1f} ± {scale * row.sampling:.1f}" for row, scale in varied(own, own.case[0])]]
    for case in own.case.unique():
        row = [f"`{case}`" + ("" if own[own.case == case].paired.iloc[0] else " (other floes)")]
        row += [difference(scale * one.change, scale * max(one.change_high - one.change, one.change - one.change_low), beyond)
                for (one, scale), beyond in zip(varied(own, case), changed(own, case))]
        if any(changed(own, case)[:2]):
            rows.append(row)
    rows.append(["all inputs together"]
                + [f"{scale * one.all_down:+.1f} to {scale * one.all_up:+.1f}" for one, scale in varied(own, own.case[0])])
    return table(["case, then changes from it", "mean load, N", "largest over 1 s, N", "broken floes, %"], rows)


def changed(own, case):
    """Of each quantity shown, whether its interval excludes zero."""
    return [one.change_low > 0 or one.change_high < 0 for one, _ in varied(own, case)]


def varied(own, case):
    """One row for each quantity shown, with what turns it into the unit shown."""
    of_case = own[own.case == case].set_index("quantity")
    return [(of_case.loc[quantity], scale) for quantity, scale in VARIED.items()]


def vary_says():
    own = variations("vary_channel")
    mean, _ = varied(own, own.case[0])[0]
    down, up = mean.all_down / mean.base, mean.all_up / mean.base
    found = [changed(own, case) for case in own.case.unique()]
    broken, none = sum(not any(one[:2]) and one[2] for one in found), sum(not any(one) for one in found)
    return (f"Of the other cases {broken} change the broken floes alone, and {none} nothing beyond chance. Sampling leaves the\n"
            f"channel's {mean.base:.1f} N open by ± {mean.sampling:.1f} N, the {own.input.nunique()} inputs together by "
            f"{mean.all_down:+.1f} to {mean.all_up:+.1f} N, which is {100 * down:+.0f} to {100 * up:+.0f} %.\n")


BLOCKS = {"score": score, "experiment": experiment, "tank_says": tank_says, "vary": vary, "vary_says": vary_says,
          "table3": table3, "differences": differences, "trend": trend, "window": window, "fit": fit}
