"""The tables of docs/crystalline_fields.md, each a function that gives Markdown."""
import numpy as np

from validation_data import FITTED_TO, LABELS, MODULI, across, change, crystalline_averages, crystalline_steady, members, paper
from validation_tables import (SHOWN, bottom_radius, bracketed, difference, fit_row, fitted, number, steady, table, table3,
                               wall_angle, with_interval)


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


def fit():
    table_ = members("fit_crystalline")
    rows = [[f"{bottom_radius(case):.4g}", f"{wall_angle(bottom_radius(case)):.1f}°"]
            + [with_interval(table_[table_.case == case][quantity]) for quantity in SHOWN]
            + [steady(table_[table_.case == case])] for case in dict.fromkeys(table_.case)]
    rows.append(fit_row(fitted(across(table_, "mean_load"), FITTED_TO["fit_crystalline"]), FITTED_TO["fit_crystalline"]) + [""] * 4)
    return table(["radius at the bottom, m", "wall below the waterline"] + [LABELS[q] for q in SHOWN] + ["steady"], rows)


def steady_window():
    table_ = crystalline_steady()
    rows = []
    for case, modulus in MODULI.items():
        own = table_.loc[case]
        cells = [bracketed(own[q], own[f"{q}_low"], own[f"{q}_high"]) for q in SHOWN[:3]]
        rows.append([f"{modulus}", f"{own.steady_start:g} to {own.steady_start + own.window:g}"] + cells
                    + [f"{own.members - own.not_steady:g} of {own.members:g}"])
    return table(["E, MPa", "window, s"] + [LABELS[q] for q in SHOWN[:3]] + ["steady"], rows)


def averaging():
    rows = []
    for window, own in crystalline_averages().groupby("averaged_over_s"):
        own = own.set_index("case")
        rows.append([f"{window:g}"] + [number(own.loc[case, "sd_load"]) for case in MODULI]
                    + [number(own.loc[case, "mean_maximum"]) for case in MODULI])
    rows.append(["paper"] + [number(paper(case, "sd_load")) for case in MODULI]
                + [number(paper(case, "mean_maximum")) for case in MODULI])
    return table(["load averaged over, s"] + [f"SD, N, {modulus} MPa" for modulus in MODULI.values()]
                 + [f"mean of the maxima, N, {modulus} MPa" for modulus in MODULI.values()], rows)


BLOCKS = {"table3": lambda: table3("crystalline"), "steady": steady_window, "averaging": averaging,
          "sensitivity": sensitivity, "fit": fit, "one at a time": lambda: changes("one_at_a_time"),
          "convergence": lambda: changes("convergence")}
