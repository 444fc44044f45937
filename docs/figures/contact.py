#!/usr/bin/python3
"""The tables of docs/convergence.md and docs/contact.md and their picture, from the members in docs/contact.

Usage:
    contact.py                    writes tables and picture
    contact.py --check            writes nothing; fails if a table differs from the data
    contact.py --collect FOLDER   first takes the members of the finished campaigns in FOLDER: contact_convergence.h5,
                                  contact_choices.h5 and contact_laws.h5, made from configs/validation
"""
import pathlib
import sys
import tomllib

import numpy as np
import pandas as pd

from page_blocks import fill_or_check
from validation_data import half_width, interval
from validation_data import members as validation_members
from validation_tables import number, table, with_interval

DOCS = pathlib.Path(__file__).resolve().parent.parent
DATA = DOCS / "contact"
KEYS = {"friction": "contact.friction", "law": "contact.law", "iterations": "general.iterations",
        "time_step_s": "general.time_step_s",
        "internal_edges": "paper.internal_edges", "erp": "contact.erp", "pressure_kPa": "contact.crushing_pressure_kPa",
        "strength_kPa": "ice.compressive_strength_kPa", "cfm": "joint.cfm", "modulus_MPa": "ice.elastic_modulus_MPa"}
LAWS = [(friction, law) for law in ["rigid", "crushing"] for friction in ["one_direction", "cone"]]
MAXIMA = {"maximum_N": "every step", "maximum_0.1s_N": "0.1 s", "maximum_0.5s_N": "0.5 s", "maximum_1s_N": "1 s",
          "maximum_2s_N": "2 s"}


def collected(path, keys=KEYS, columns=()):
    """One row for each finished member of a campaign file; `columns`: further ones of members."""
    import h5py  # which --check does not need

    with h5py.File(path) as file:
        config = tomllib.loads(file["provenance/configuration"].asstr()[()])
        times = file["averaging_time"][:]
        rows = []
        for i in np.flatnonzero(file["members/status"][:] == 0):
            number_of_case = file["members/case"][i]
            own = config["case"][number_of_case]

            def value(key):  # of the case, or of all
                head, name = key.split(".")
                return own.get(head, {}).get(name, own.get(name, config.get(head, {}).get(name)))

            row = {name: value(key) for name, key in keys.items()}
            row["arrangement"] = file["arrangements/number"][file["members/arrangement"][i]]
            for name, field in [("mean_N", "mean_load"), ("sd_N", "sd_load"), ("maximum_N", "mean_maximum")]:
                row[name] = file[f"members/{field}"][i]
            for k, time in enumerate(times):
                row[f"maximum_{time:g}s_N"] = file["averaged/mean_maximum"][i][k]
            row["broken_percent"] = 100 * file["members/failure_ratio"][i]
            row |= {column: file[f"members/{column}"][i] for column in columns}
            rows.append(row)
    return pd.DataFrame(rows).round({name: 6 for name in rows[0] if name.endswith(("_N", "_percent"))})


def members(name):
    return pd.read_csv(DATA / f"{name}.csv")


def law_words(friction, law):
    return f"{'cone' if friction == 'cone' else 'one direction'}, {law}"


def cases(data):
    """(iterations, friction, law, time step) and the members, in the order of the page."""
    for iterations in sorted(data.iterations.unique()):
        for friction, law in LAWS:
            for step in sorted(data.time_step_s.unique(), reverse=True):
                own = data[(data.iterations == iterations) & (data.friction == friction) & (data.law == law)
                           & (data.time_step_s == step)]
                if len(own):
                    yield iterations, friction, law, step, own


def loads():
    rows = [[law_words(friction, law), f"{iterations}", f"{step:g}", f"{own.cfm.iloc[0]:.3g}",
             with_interval(own.mean_N), number(own.sd_N.mean())]
            + [with_interval(own[column]) if column in ("maximum_N", "maximum_0.1s_N") else number(own[column].mean())
               for column in MAXIMA] + [with_interval(own.broken_percent)]
            for iterations, friction, law, step, own in cases(members("convergence"))]
    return table(["contact", "sweeps", "Δt, s", "Σ", "mean, N", "SD, N"]
                 + [f"maxima, {words}, N" for words in MAXIMA.values()] + ["broken floes, %"], rows)


def ratio(own, shortest, column):
    """Of the means over the arrangements that both have, and the half width of its 95 % interval (delta method)."""
    both = own.merge(shortest, on="arrangement", suffixes=("", "_there"))
    here, there = both[column], both[f"{column}_there"]
    r = here.mean() / there.mean()
    return r, half_width(here - r * there) / there.mean()


def ratios():
    """Loads over those of the shortest step, same law and sweeps, same arrangements."""
    data = members("convergence")
    shortest = data.time_step_s.min()
    rows = []
    for iterations, friction, law, step, own in cases(data):
        if step == shortest:
            continue
        there = data[(data.iterations == iterations) & (data.friction == friction) & (data.law == law)
                     & (data.time_step_s == shortest)]
        values = [ratio(own, there, column) for column in ["mean_N", *MAXIMA]]
        rows.append([law_words(friction, law), f"{iterations}", f"{step:g}"]
                    + [f"{r:.2f} ± {half:.2f}" for r, half in values])
    return table(["contact", "sweeps", "Δt, s", "mean"] + [f"maxima, {words}" for words in MAXIMA.values()], rows)


def summary():
    """In words: how far the maxima of each law are from those of the shortest step."""
    data = members("convergence")
    shortest = data.time_step_s.min()
    lines = [f"{len(data.arrangement.unique())} arrangements. Maxima over those at {shortest:g} s, 50 sweeps:", ""]
    for friction, law in LAWS:
        own = data[(data.friction == friction) & (data.law == law) & (data.iterations == 50)]
        there = own[own.time_step_s == shortest]
        parts = []
        for step, column in [(0.02, "maximum_N"), (0.01, "maximum_N"), (0.02, "maximum_0.1s_N"),
                             (0.01, "maximum_0.1s_N"), (0.02, "maximum_1s_N")]:
            r, half = ratio(own[own.time_step_s == step], there, column)
            parts.append(f"{r:.2f} ± {half:.2f} ({MAXIMA[column]}, Δt {step:g} s)")
        lines.append(f"* {law_words(friction, law)}: " + ", ".join(parts) + ".")
    return "\n".join(lines)


def choices():
    """Each choice in the short channel, as a change from the physical preset and by itself."""
    data = members("choices")
    rows = []
    for key, own in data.groupby(["friction", "law", "internal_edges", "erp", "pressure_kPa"], sort=False):
        friction, law, edges, erp, pressure = key
        detail = f"Γ {erp:g}" if law == "rigid" else f"{pressure or own.strength_kPa.iloc[0]:g} kPa"
        rows.append([law_words(friction, law), detail, "act" if edges else "do not act"]
                    + [with_interval(own[column])
                       for column in ["mean_N", "maximum_N", "maximum_0.1s_N", "maximum_1s_N", "broken_percent"]])
    return table(["contact", "", "internal edges", "mean, N", "maxima, every step, N", "0.1 s, N", "1 s, N",
                  "broken floes, %"], rows)


def laws():
    """Table 3's case under each law, over the same arrangements."""
    data = members("laws")
    paper = validation_members("crystalline")
    paper = paper[paper.arrangement < len(data.arrangement.unique())]
    rows = []
    shown = ["mean_N", "sd_N", "maximum_N", "maximum_0.1s_N", "maximum_1s_N", "broken_percent"]
    for modulus in sorted(data.modulus_MPa.unique()):
        own = paper[paper.case == f"E{modulus:g}"].rename(
            columns={"mean_load": "mean_N", "sd_load": "sd_N", "mean_maximum": "maximum_N", "failure_ratio": "broken_percent"})
        rows.append(["one direction, rigid", f"{modulus:g}"]
                    + [with_interval(own[column]) if column in own else "–" for column in shown])
        for friction, law in LAWS[1:]:
            own = data[(data.friction == friction) & (data.law == law) & (data.modulus_MPa == modulus)]
            rows.append([law_words(friction, law), f"{modulus:g}"] + [with_interval(own[column]) for column in shown])
    return table(["contact", "E, MPa", "mean, N", "SD, N", "maxima, every step, N", "0.1 s, N", "1 s, N",
                  "broken floes, %"], rows)


def draw(path):
    import matplotlib

    matplotlib.use("svg")
    matplotlib.rcParams["svg.hashsalt"] = "floes"
    from matplotlib import pyplot

    data = members("convergence")
    figure, axes = pyplot.subplots(1, 3, figsize=(11, 3.6))
    for (friction, law), colour in zip(LAWS, ["C0", "C1", "C2", "C3"]):
        for iterations, line in [(50, "-"), (200, "--")]:
            own = data[(data.friction == friction) & (data.law == law) & (data.iterations == iterations)]
            for axis, column in zip(axes, ["mean_N", "maximum_N", "maximum_0.1s_N"]):
                found = own.groupby("time_step_s")[column].apply(lambda values: pd.Series(interval(values)))
                found = found.unstack()
                label = f"{law_words(friction, law)}, {iterations} sweeps"
                axis.errorbar(found.index * (1.02 if iterations == 200 else 1), found[0],
                              [found[0] - found[1], found[2] - found[0]], color=colour, linestyle=line, marker="o",
                              markersize=3, capsize=2, linewidth=1, label=label)
    for axis, title in zip(axes, ["mean load", "maxima, every step", "maxima of the load averaged over 0.1 s"]):
        axis.set_xscale("log")
        axis.set_xticks([0.0025, 0.005, 0.01, 0.02], ["0.0025", "0.005", "0.01", "0.02"])
        axis.minorticks_off()
        axis.set_xlabel("time step, s")
        axis.set_title(title, fontsize=10)
        axis.set_ylim(bottom=0)
    axes[0].set_ylabel("N")
    figure.legend(*axes[0].get_legend_handles_labels(), loc="lower center", ncols=4, fontsize=8, frameon=False)
    figure.tight_layout(rect=(0, 0.13, 1, 1))
    figure.savefig(path, metadata={"Date": None})


def main(arguments):
    if arguments[:1] == ["--collect"]:
        folder = pathlib.Path(arguments[1])
        for name in ["convergence", "choices", "laws"]:
            file = folder / f"contact_{name}.h5"
            if file.exists():
                collected(file).to_csv(DATA / f"{name}.csv", index=False)
    check = arguments == ["--check"]
    fill_or_check({DOCS / "convergence.md": {"summary": summary, "loads": loads, "ratios": ratios},
                   DOCS / "contact.md": {"choices": choices, "laws": laws}},
                  check, "contact.py")
    if not check:
        draw(DATA / "convergence.svg")


if __name__ == "__main__":
    main(sys.argv[1:])
