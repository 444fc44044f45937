"""The tables of docs/validation.md, each a function that gives Markdown."""
import itertools
import tomllib

import numpy as np
from scipy import stats

from validation_data import (CONFIGS, FITTED_TO, LABELS, MODULI, PAPER, across, averages, change, hybrid, interval,
                             is_maximum, members, pairs, paper, steady_cases)

SHOWN = ["mean_N", "sd_N", "mean_maximum_N", "failure_ratio"]


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


def sensitivity():
    table_ = members("wall_far_end_erp")
    rows = []
    for case in dict.fromkeys(table_.case):
        own = table_[table_.case == case]
        wall, far_end, erp = case.split("_")
        rows.append([wall.replace("deg", "°"), far_end, erp.removeprefix("erp")]
                    + [with_interval(own[quantity]) for quantity in SHOWN] + [steady(own)])
    return table(["wall below the waterline", "far end", "contact Γ"] + [LABELS[q] for q in SHOWN] + ["steady"], rows)


def changes(campaign):
    """The first case, and the change of each other case from it, over the same arrangements."""
    table_ = members(campaign)
    base, *changed = dict.fromkeys(table_.case)
    rows = [[base] + [with_interval(table_[table_.case == base][q]) for q in SHOWN] + [steady(table_[table_.case == base])]]
    for case in changed:
        rows.append([case.replace("_", " ")] + [difference(*change(table_, q, case, base)) for q in SHOWN]
                    + [steady(table_[table_.case == case])])
    return table(["case"] + [LABELS[q] for q in SHOWN] + ["steady"], rows)


def bottom_radius(case):
    return float(case.removeprefix("bottom_").removesuffix("mm")) / 1000


def fit_radius(means, radii):
    """The radius at which a parabola through the logarithms of the means meets the paper's mean."""
    curve = np.polyfit(radii, np.log(means) - np.log(FITTED_TO), 2)
    real = [root.real for root in np.roots(curve) if abs(root.imag) < 1e-12]
    return min(real, key=lambda root: abs(root - np.mean(radii)), default=np.nan)


def fitted():
    """Bottom radius in m: estimate, and the 95 % interval over arrangements (percentile bootstrap, 10,000 draws)."""
    wide = across(members("fit_wall"), "mean_N")
    radii = np.array([bottom_radius(case) for case in wide.columns])
    draws = np.random.default_rng(1).integers(len(wide), size=(10000, len(wide)))
    fits = [fit_radius(wide.values[rows].mean(axis=0), radii) for rows in draws]
    low, high = np.nanquantile(fits, [0.025, 0.975])
    return fit_radius(wide.values.mean(axis=0), radii), low, high


def wall_angle(radius):
    return np.degrees(np.arctan2(0.443, 0.614 - radius))


def fit():
    table_ = members("fit_wall")
    rows = [[f"{bottom_radius(case):.4g}", f"{wall_angle(bottom_radius(case)):.1f}°"]
            + [with_interval(table_[table_.case == case][quantity]) for quantity in SHOWN]
            + [steady(table_[table_.case == case])] for case in dict.fromkeys(table_.case)]
    radius, low, high = fitted()
    rows.append([f"**{radius:.3f} [{low:.3f}, {high:.3f}]**",
                 f"**{wall_angle(radius):.1f}° [{wall_angle(low):.1f}°, {wall_angle(high):.1f}°]**",
                 f"**{FITTED_TO} N, the paper's**"] + [""] * 4)
    return table(["radius at the bottom, m", "wall below the waterline"] + [LABELS[q] for q in SHOWN] + ["steady"], rows)


def table3():
    table_ = members("table3")
    rows = []
    for quantity, case in itertools.product(PAPER.columns, MODULI):
        own = table_[table_.case == case][quantity]
        _, low, high = interval(own, one_run=True, positive=is_maximum(quantity))
        there = paper(case, quantity)
        inside = "yes" if low <= there <= high else "**no**"
        rows.append([LABELS[quantity], f"{MODULI[case]}", number(there), with_interval(own),
                     f"{number(low)} to {number(high)}", inside])
    return table(["", "E, MPa", "paper, one run", "mean over arrangements [95 %]", "95 % prediction interval of one run",
                  "paper within"],
                 rows)


def p_value(p):
    return "< 0.0001" if p < 0.0001 else f"{p:.2g}"


def differences():
    rows = []
    for row in pairs().itertuples():
        if row.quantity not in SHOWN:
            continue
        scale = 100 if row.quantity == "failure_ratio" else 1
        rows.append([LABELS[row.quantity], f"{row.second} - {row.first}",
                     f"{scale * row.difference:+.2f} [{scale * row.low:+.2f}, {scale * row.high:+.2f}]", p_value(row.t_p),
                     p_value(row.t_p_holm), p_value(row.wilcoxon_p_holm), f"{row.to_resolve_observed:.0f}"])
    return table(["", "pair", "difference [95 %]", "p (t)", "p (t, Holm)", "p (Wilcoxon, Holm)",
                  "arrangements needed"], rows)


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


def every_triple(values):
    """A different arrangement for each E: all n^3 combinations."""
    n = len(values)
    index = np.stack(np.meshgrid(*[np.arange(n)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    return values[index, np.arange(3)]


def trend():
    values = [across(members("table3"), q, list(MODULI)).values for q in ["mean_N", "mean_maximum_N", "failure_ratio"]]
    apart = findings(*[every_triple(v) for v in values])
    rows = []
    for name, holds in findings(*values).items():
        share = stats.binomtest(int(holds.sum()), len(holds)).proportion_ci(method="exact")
        rows.append([name, f"{holds.sum()} of {len(holds)}", f"{100 * share.low:.0f} to {100 * share.high:.0f} %",
                     f"{100 * apart[name].mean():.0f} %"])
    return table(["three single runs show", "on the same arrangement", "95 % interval of that share",
                  "on three different arrangements"], rows)


def steady_window():
    table_ = steady_cases()
    rows = []
    for case, modulus in MODULI.items():
        own = table_.loc[case]
        cells = [bracketed(own[q], own[f"{q}_low"], own[f"{q}_high"]) for q in SHOWN[:3]]
        rows.append([f"{modulus}", f"{own.steady_start_s:g} to {own.steady_start_s + own.window_s:g}"] + cells
                    + [f"{own.members - own.not_steady:g} of {own.members:g}"])
    return table(["E, MPa", "window, s"] + [LABELS[q] for q in SHOWN[:3]] + ["steady"], rows)


def averaging():
    rows = []
    for window, own in averages().groupby("averaged_over_s"):
        own = own.set_index("case")
        rows.append([f"{window:g}"] + [number(own.loc[case, "sd_N"]) for case in MODULI]
                    + [number(own.loc[case, "mean_maximum_N"]) for case in MODULI])
    rows.append(["paper"] + [number(paper(case, "sd_N")) for case in MODULI]
                + [number(paper(case, "mean_maximum_N")) for case in MODULI])
    return table(["load averaged over, s"] + [f"SD, N, {modulus} MPa" for modulus in MODULI.values()]
                 + [f"mean of the maxima, N, {modulus} MPa" for modulus in MODULI.values()], rows)


def modes():
    table_ = members("table3")
    rows = []
    for case, modulus in MODULI.items():
        own = table_[table_.case == case]
        rows.append([f"{modulus}"] + [with_interval(own[f"failures_{mode}_per_run"])
                                      for mode in ["bending", "shear", "compression"]])
    return table(["E, MPa", "joints failed in bending per run", "in shear", "in compression"], rows)


def hybrid_points():
    table_ = members("table3")
    curve = hybrid().set_index("elastic_modulus_MPa")
    rows = [[f"{modulus}", number(curve.loc[modulus, "limit_stress_N"]), number(curve.loc[modulus, "limit_momentum_N"]),
             number(curve.loc[modulus, "hybrid_N"]), with_interval(table_[table_.case == case].mean_N),
             number(paper(case, "mean_N"))] for case, modulus in MODULI.items()]
    return table(["E, MPa", "limit stress, N", "limit momentum, N", "hybrid, N", "ensemble, N [95 %]",
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
            rows.append([f"{MODULI[modulus]}", words[axes["joint.moment_about"][point]],
                         words[axes["water.form_drag_on"][point]], f"{axes['contact.erp'][point]:g}", f"{len(own)}"]
                        + [with_interval(own[quantity]) for quantity in SHOWN])
        rows.append([f"{MODULI[modulus]}", "*paper*", "", "", "1"] + [number(paper(modulus, q)) for q in SHOWN])
    return table(["E, MPa", "moment about", "form drag on", "contact Γ", "n"] + [LABELS[q] for q in SHOWN], rows)


BLOCKS = {"readings": readings, "sensitivity": sensitivity, "fit": fit, "table3": table3, "steady": steady_window, "averaging": averaging, "modes": modes, "differences": differences,
          "trend": trend, "one at a time": lambda: changes("one_at_a_time"), "convergence": lambda: changes("convergence"), "hybrid": hybrid_points}
