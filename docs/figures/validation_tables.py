"""The tables of docs/validation.md, each a function that gives Markdown."""
import itertools
import tomllib

import numpy as np
from scipy import stats

from validation_data import (CONFIGS, EXPERIMENT, FITTED_TO, LABELS, MODULI, PAPER, WALLS, WAYS, WINDOW_START, across,
                             half_width, hybrid, interval, is_maximum, largest, members, pairs, paper, pooled, variations,
                             windows)

SHOWN = ["mean_load", "sd_load", "mean_maximum", "failure_ratio"]
COMPARED = SHOWN + ["mean_maximum_1s"]


def table(heading, rows):
    lines = ["| " + " | ".join(heading) + " |", "|---" * len(heading) + "|"]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def number(value):
    """Three significant digits, as many as any figure here deserves."""
    digits = 0 if abs(value) >= 99.95 else 1 if abs(value) >= 9.995 else 2
    return f"{value:.{digits}f}"


def bracketed(mean, low, high):
    return f"{number(mean)} [{number(low)}, {number(high)}]"


def with_interval(values):
    return bracketed(*interval(values))


def difference(mean, half):
    mark = "**" if abs(mean) > half else ""
    return f"{mark}{mean:+.1f} ± {half:.1f}{mark}"


def steady(rows):
    return f"{np.sum(rows.trend_p > 0.05)} of {len(rows)}"


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


def fitted(means, target):
    """Bottom radius in m: estimate, and the 95 % interval over arrangements (percentile bootstrap, 10,000 draws).
    `means`: a row for each arrangement, a column for each case."""
    radii = np.array([bottom_radius(case) for case in means.columns])
    draws = np.random.default_rng(1).integers(len(means), size=(10000, len(means)))
    fits = [fit_radius(means.values[rows].mean(axis=0), radii, target) for rows in draws]
    low, high = np.nanquantile(fits, [0.025, 0.975])
    return fit_radius(means.values.mean(axis=0), radii, target), low, high


def fit_row(radius, target):
    best, low, high = radius
    return [f"**{best:.3f} [{low:.3f}, {high:.3f}]**",
            f"**{wall_angle(best):.1f}° [{wall_angle(low):.1f}°, {wall_angle(high):.1f}°]**", f"**{target} N, fitted to**"]


def fit():
    rows = []
    own = windows("fit_paper")
    own = own[own.start_s == WINDOW_START]
    for case in dict.fromkeys(own.case):
        values = own[own.case == case]
        rows.append([f"{bottom_radius(case):.4g}", f"{wall_angle(bottom_radius(case)):.1f}°"]
                    + [with_interval(values[quantity]) for quantity in SHOWN[:3]])
    rows.append(fit_row(fitted(across(own, "mean_load"), FITTED_TO["fit_paper"]), FITTED_TO["fit_paper"]) + [""] * 2)
    return table(["radius at the bottom, m", "wall below the waterline"] + [LABELS[q] for q in SHOWN[:3]], rows)


def window():
    """Trend of the load in windows that begin later and later, mean over the walls of each arrangement."""
    rows = []
    own = windows("fit_paper")
    for start in sorted(own.start_s.unique()):
        trends = own[own.start_s == start].groupby("arrangement").trend_N_per_100s.mean()
        rows.append([f"{start} to {start + 150}", difference(trends.mean(), half_width(trends))])
    return table(["window, s", "trend of the load, N in 100 s"], rows)


# -- Table 3

def within(campaign, case, quantity):
    """The prediction interval of one run, and whether the paper's run lies in it."""
    own = members(campaign)
    _, low, high = interval(own[own.case == case][quantity], one_run=True, positive=is_maximum(quantity))
    return low, high, bool(low <= paper(case, quantity) <= high)


def count_within(campaign, cases=MODULI):
    return sum(within(campaign, case, quantity)[2] for quantity, case in itertools.product(PAPER.columns, cases))


def table3(campaign):
    table_ = members(campaign)
    rows = []
    for quantity, case in itertools.product(PAPER.columns, MODULI):
        low, high, inside = within(campaign, case, quantity)
        rows.append([LABELS[quantity], f"{MODULI[case]}", number(paper(case, quantity)),
                     with_interval(table_[table_.case == case][quantity]), f"{number(low)} to {number(high)}",
                     "yes" if inside else "**no**"])
    return table(["", "E, MPa", "paper, one run", "mean over arrangements [95 %]", "95 % prediction interval of one run",
                  "paper within"],
                 rows)


# -- the paper's question

def signed_difference(row):
    scale = 100 if row.quantity == "failure_ratio" else 1
    mark = "**" if row.t_p_holm < 0.05 else ""
    return f"{mark}{scale * row.difference:+.1f}{mark} [{scale * row.difference_low:+.1f}, {scale * row.difference_high:+.1f}]"


def differences():
    found = {campaign: {(row.quantity, row.first, row.second): row for row in pairs(campaign).itertuples()}
             for campaign in WAYS}
    rows = []
    for quantity in COMPARED:
        for first, second in itertools.combinations(MODULI, 2):
            cells = [found[campaign].get((quantity, first, second)) for campaign in WAYS]
            rows.append([LABELS[quantity], f"{second} - {first}"] + ["" if row is None else signed_difference(row) for row in cells])
    return table(["", "pair", *WAYS.values()], rows)


def findings(mean, peak, broken):
    """The trends of the paper's three runs, for arrays (..., case in the order of MODULI): name -> where it holds."""
    lowest_mean = mean.argmin(axis=-1) == 0
    highest_mean = mean.argmax(axis=-1) == 1
    lowest_peak = peak.argmin(axis=-1) == 0
    most_broken = broken[..., 2] > broken[..., :2].max(axis=-1)
    return {"mean load lowest at 30 MPa": lowest_mean, "mean load highest at 60 MPa": highest_mean,
            "mean of the maxima lowest at 30 MPa": lowest_peak, "most broken floes at 200 MPa": most_broken,
            "lowest mean and maxima at 30, most broken at 200 MPa": lowest_mean & lowest_peak & most_broken,
            "all of these": lowest_mean & highest_mean & lowest_peak & most_broken}


def found_in(campaign):
    return findings(*[across(members(campaign), q, list(MODULI)).values
                      for q in ["mean_load", "mean_maximum", "failure_ratio"]])


def trend():
    found = {campaign: found_in(campaign) for campaign in WAYS}
    rows = []
    for name in found["table3"]:
        cells = []
        for own in found.values():
            share = stats.binomtest(int(own[name].sum()), len(own[name])).proportion_ci(method="exact")
            cells.append(f"{own[name].sum()} of {len(own[name])} [{100 * share.low:.0f}, {100 * share.high:.0f} %]")
        rows.append([name] + cells)
    return table(["three runs on one arrangement show", *WAYS.values()], rows)


def averaging():
    """Maxima over increasing averaging times, with the paper's contacts."""
    rows = []
    for time in ["", "_0.1s", "_0.5s", "_1s", "_2s"]:
        row = [time.strip("_").replace("s", " s") or "one step, 0.02 s"]
        own = members("table3")
        row += [with_interval(own[own.case == case][f"mean_maximum{time}"]) for case in MODULI]
        rows.append(row)
    return table(["mean of the maxima, N, averaged over"] + [f"{modulus} MPa" for modulus in MODULI.values()], rows)


def modes():
    rows = []
    table_ = members("table3")
    for case, modulus in MODULI.items():
        own = table_[table_.case == case]
        rows.append([f"{modulus}"] + [with_interval(own[f"failures_{mode}"]) for mode in ["bending", "shear", "compression"]])
    return table(["E, MPa", "joints failed in bending per run", "in shear", "in compression"], rows)


def answer():
    """What the campaigns say, in figures."""
    lines = []
    for campaign, name in WAYS.items():
        own = members(campaign)
        means = ", ".join(number(own[own.case == case].mean_load.mean()) for case in MODULI)
        maxima = ", ".join(number(own[own.case == case].mean_maximum.mean()) for case in MODULI)
        broken = ", ".join(number(own[own.case == case].failure_ratio.mean()) for case in MODULI)
        lines.append([name, f"{own.arrangement.nunique()}", means, maxima, broken, f"{count_within(campaign)} of 24"])
    lines.append(["*the paper, one run each*", "1"] + [", ".join(number(paper(case, q)) for case in MODULI)
                                                   for q in ["mean_load", "mean_maximum", "failure_ratio"]] + [""])
    return table(["at 30, 60, 200 MPa", "arrangements", "mean load, N", "mean of the maxima, N", "broken floes, %",
                  "the paper's figures inside"], lines)


def hybrid_points():
    curve = hybrid().set_index("elastic_modulus_MPa")
    rows = []
    for case, modulus in MODULI.items():
        own = members("table3")
        rows.append([f"{modulus}", number(curve.loc[modulus, "limit_stress"]), number(curve.loc[modulus, "limit_momentum"]),
                     number(curve.loc[modulus, "hybrid"]), with_interval(own[own.case == case].mean_load),
                     number(paper(case, "mean_load"))])
    return table(["E, MPa", "limit stress, N", "limit momentum, N", "hybrid, N", "paper's contacts, N [95 %]",
                  "paper's simulation, N"], rows)


def readings():
    """What the paper leaves open besides the wall, on scattered fields; the paper's run for comparison."""
    axes = {axis["key"]: axis["values"]
            for axis in tomllib.loads((CONFIGS / "readings.toml").read_text())["design"]["axis"]}
    words = {"pivot": "joint", "element_centre": "element's centre", "outline": "outline",
             "every_element": "every element"}
    table_ = members("readings")
    rows = []
    for modulus in ["E60", "E200"]:
        for point in range(len(axes["contact.erp"])):
            own = table_[table_.case == f"{modulus}+p{point:03d}"]
            rows.append([f"{MODULI[modulus]}", words[axes["paper.moment_about"][point]],
                         words[axes["paper.form_drag_on"][point]], f"{axes['contact.erp'][point]:g}", f"{len(own)}"]
                        + [with_interval(own[quantity]) for quantity in SHOWN])
        rows.append([f"{MODULI[modulus]}", "*paper*", "", "", "1"] + [number(paper(modulus, q)) for q in SHOWN])
    return table(["E, MPa", "moment about", "form drag on", "contact Γ", "n"] + [LABELS[q] for q in SHOWN], rows)


# -- what the model leaves open

VARIED = {"mean_load": 1, "mean_maximum_1s": 1, "failure_ratio": 100}


def vary():
    own = variations("vary_channel")
    rows = [["*as it is*"] + [f"{scale * row.base:.1f} ± {scale * row.sampling:.1f}" for row, scale in varied(own, own.case[0])]]
    for case in own.case.unique():
        row = [f"`{case}`" + ("" if own[own.case == case].paired.iloc[0] else " (other floes)")]
        row += [difference(scale * one.change, scale * (one.change_high - one.change_low) / 2) for one, scale in varied(own, case)]
        rows.append(row)
    rows.append(["all inputs together"]
                + [f"{scale * one.all_down:+.1f} to {scale * one.all_up:+.1f}" for one, scale in varied(own, own.case[0])])
    return table(["case, then changes from it", "mean load, N", "largest over 1 s, N", "broken floes, %"], rows)


def varied(own, case):
    """One row for each quantity shown, with what turns it into the unit shown."""
    of_case = own[own.case == case].set_index("quantity")
    return [(of_case.loc[quantity], scale) for quantity, scale in VARIED.items()]


def vary_says():
    own = variations("vary_channel")
    mean, _ = varied(own, own.case[0])[0]
    down, up = mean.all_down / mean.base, mean.all_up / mean.base
    return (f"Sampling leaves the channel's {mean.base:.1f} N open by ± {mean.sampling:.1f} N, the {own.input.nunique()} inputs "
            f"together by {mean.all_down:+.1f} to {mean.all_up:+.1f} N, which is\n{100 * down:+.0f} to {100 * up:+.0f} %.\n")


BLOCKS = {"answer": answer, "vary": vary, "vary_says": vary_says, "table3": lambda: table3("table3"),
          "averaging": averaging, "modes": modes, "differences": differences,
          "trend": trend, "readings": readings, "window": window, "fit": fit, "hybrid": hybrid_points}
