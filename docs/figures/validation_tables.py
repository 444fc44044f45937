"""The tables of docs/validation.md, each a function that gives Markdown."""
import itertools
import tomllib

import numpy as np
from scipy import stats

from validation_data import (CONFIGS, EXPERIMENT, FITTED_TO, LABELS, MODULI, PAPER, WAYS, WINDOW_START, across, half_width,
                             hybrid, interval, is_maximum, largest, members, pairs, paper, variations, windows)

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
    for campaign, contacts in {"fit_paper": "paper", "fit_physical": "physical"}.items():
        own = windows(campaign)
        own = own[own.start_s == WINDOW_START]
        for case in dict.fromkeys(own.case):
            values = own[own.case == case]
            rows.append([contacts, f"{bottom_radius(case):.4g}", f"{wall_angle(bottom_radius(case)):.1f}°"]
                        + [with_interval(values[quantity]) for quantity in SHOWN[:3]])
        radius = fitted(across(own, "mean_load"), FITTED_TO[campaign])
        rows.append([contacts] + fit_row(radius, FITTED_TO[campaign]) + [""] * 2)
    return table(["contacts", "radius at the bottom, m", "wall below the waterline"] + [LABELS[q] for q in SHOWN[:3]], rows)


def window():
    """Trend of the load in windows that begin later and later, mean over the walls of each arrangement."""
    rows = []
    for start in sorted(windows("fit_paper").start_s.unique()):
        row = [f"{start} to {start + 150}"]
        for campaign in ["fit_paper", "fit_physical"]:
            own = windows(campaign)
            trends = own[own.start_s == start].groupby("arrangement").trend_N_per_100s.mean()
            row.append(difference(trends.mean(), half_width(trends)))
        rows.append(row)
    return table(["window, s", "trend with the paper's contacts, N in 100 s", "with physical contacts, sweeps and the water of before"], rows)


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


def experiment():
    """The tank test beside both ways at its modulus. A load cell and its recorder average over some time: which is not
    known, so the largest load is given for three."""
    ways = ["table3_physical", "table3"]
    peaks = {campaign: largest(campaign) for campaign in ways}
    own = {campaign: members(campaign).query("case == 'E60'") for campaign in ways}

    def row(label, measured, values, positive=False):
        cells = [label, number(measured)]
        for campaign in ways:
            _, low, high = interval(values[campaign], one_run=True, positive=positive)
            inside = "" if low <= measured <= high else ", **outside**"
            cells += [with_interval(values[campaign]), f"{number(low)} to {number(high)}{inside}"]
        return cells

    rows = [row("mean load, N", EXPERIMENT["mean_load"], {campaign: own[campaign].mean_load for campaign in ways})]
    for time in sorted(peaks["table3"].averaged_over_s.unique()):
        over = {campaign: peak[(peak.case == "E60") & (peak.averaged_over_s == time)].maximum_load
                for campaign, peak in peaks.items()}
        rows.append(row(f"largest load over {time:g} s, N", EXPERIMENT["maximum_load"], over, positive=True))
    rows.append(row("floes with a failed joint, %", 100 * EXPERIMENT["failure_ratio"], {c: own[c].failure_ratio for c in ways}))
    through = 100 * own["table3_physical"].split_ratio  # which files of the paper's preset do not have
    _, low, high = interval(through, one_run=True)
    inside = "" if low <= 100 * EXPERIMENT["failure_ratio"] <= high else ", **outside**"
    rows.append(["floes cracked through, %", number(100 * EXPERIMENT["failure_ratio"]), with_interval(through),
                 f"{number(low)} to {number(high)}{inside}", "–", "–"])
    return table(["60 MPa", "experiment", "physics [95 %]", "one run", "paper's contacts [95 %]", "one run"], rows)


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
    """SD and maxima over increasing averaging times, at 60 MPa and, for the maxima, the ratio of 200 to 30 MPa."""
    rows = []
    for time in ["", "_0.1s", "_0.5s", "_1s", "_2s"]:
        row = [time.strip("_").replace("s", " s") or "one step, 0.02 s"]
        for campaign in ["table3", "table3_physical"]:
            own = members(campaign)
            row += [with_interval(own[own.case == case][f"mean_maximum{time}"]) for case in MODULI]
        rows.append(row)
    return table(["mean of the maxima, N, averaged over"] + [f"{contacts}, {modulus} MPa" for contacts in ["paper's", "physics"]
                                                for modulus in MODULI.values()], rows)


def modes():
    rows = []
    for campaign, contacts in {"table3": "paper's", "table3_physical": "physics"}.items():
        table_ = members(campaign)
        for case, modulus in MODULI.items():
            own = table_[table_.case == case]
            rows.append([contacts, f"{modulus}"] + [with_interval(own[f"failures_{mode}"])
                                                    for mode in ["bending", "shear", "compression"]])
    return table(["contacts", "E, MPa", "joints failed in bending per run", "in shear", "in compression"], rows)


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
        own = [members(campaign) for campaign in ["table3", "table3_physical"]]
        rows.append([f"{modulus}", number(curve.loc[modulus, "limit_stress"]), number(curve.loc[modulus, "limit_momentum"]),
                     number(curve.loc[modulus, "hybrid"])] + [with_interval(rows_[rows_.case == case].mean_load) for rows_ in own]
                    + [number(paper(case, "mean_load"))])
    return table(["E, MPa", "limit stress, N", "limit momentum, N", "hybrid, N", "paper's contacts, N [95 %]",
                  "physics, N [95 %]", "paper's simulation, N"], rows)


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
        row += [difference(scale * one.change, scale * (one.high - one.low) / 2) for one, scale in varied(own, case)]
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
    tank = members("table3_physical").query("case == 'E60'").mean_load.mean()
    low, high = tank * (1 + down), tank * (1 + up)
    inside = "inside" if low <= EXPERIMENT["mean_load"] <= high else "outside"
    return (f"Sampling leaves the channel's {mean.base:.1f} N open by ± {mean.sampling:.1f} N, the {own.input.nunique()} inputs "
            f"together by {mean.all_down:+.1f} to {mean.all_up:+.1f} N, which is\n{100 * down:+.0f} to {100 * up:+.0f} %. "
            f"If the tank is as sensitive, its {tank:.1f} N are {low:.0f} to {high:.0f} N, and the {EXPERIMENT['mean_load']} N of the "
            f"test lie {inside}. The wall\nis not among these inputs: [above](#the-tank-test-and-the-wall).\n")


BLOCKS = {"answer": answer, "vary": vary, "vary_says": vary_says, "table3": lambda: table3("table3"), "experiment": experiment,
          "physical": lambda: table3("table3_physical"), "averaging": averaging, "modes": modes, "differences": differences,
          "trend": trend, "readings": readings, "window": window, "fit": fit, "hybrid": hybrid_points}
