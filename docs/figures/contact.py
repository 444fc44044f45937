#!/usr/bin/python3
"""The tables of docs/convergence.md, from the members in docs/contact.

Usage:
    contact.py                    writes the tables
    contact.py --check            writes nothing; fails if a table differs from the data
    contact.py --collect FOLDER   first takes the members of the finished campaigns contact_choices.h5, resolution.h5,
                                  friction_cone.h5 and jam.h5 in FOLDER, made from configs/validation, or of their parts
                                  (jam.part1.h5, …)
"""
import pathlib
import tomllib

import numpy as np
import pandas as pd

from page_blocks import make
from validation_data import half_width
from validation_tables import difference, number, table

DOCS = pathlib.Path(__file__).resolve().parent.parent
DATA = DOCS / "contact"
COLUMNS = ["split_ratio", "mean_heave", "mean_sweeps"]
CAMPAIGNS = {"contact_choices": "choices", "resolution": "resolution",
             "friction_cone": "friction_cone", "jam": "jam"}
QUANTITIES = {"mean_N": "mean, N", "maximum_0.1s_N": "largest over 0.1 s, N", "maximum_1s_N": "over 1 s, N",
              "broken_percent": "broken floes, %"}
NUMERIC_QUANTITIES = QUANTITIES | {"heave_N": "heave, N"}
LONG_QUANTITIES = {"mean_N": "mean, N", "maximum_1s_N": "largest over 1 s, N", "broken_percent": "broken floes, %"}
CHOICES = {"default": "**default: friction cone, crushing at 145.6 kPa**", "pressure_halved": "crushing at 72.8 kPa",
           "pressure_x16": "crushing at 2330 kPa", "edges_act": "crushing, internal edges act", "rigid": "rigid, Γ 0.2",
           "rigid_erp_0.8": "rigid, Γ 0.8"}
NUMERICS = {"default": "**default: 0.02 s, 1 mm/s**", "step_0.01": "step 0.01 s",
            "step_0.0025": "step 0.0025 s", "tolerance_10": "tolerance 10 mm/s",
            "tolerance_0.1": "tolerance 0.1 mm/s, at most 5000 sweeps",
            "elements_0.3": "elements 0.3 m", "elements_0.15": "elements 0.15 m", "elements_0.1": "elements 0.1 m"}
JAM = {"tolerance_1": "**1 mm/s**", "tolerance_0.2": "0.2 mm/s"}
FRICTION = {"constant": "**constant**", "ice_rate_and_state": "ice on ice by rate and state",
            "ice_power": "ice on ice by the power 0.35", "hull_power": "hull by the power 0.28"}


def collected(path, keys, columns=()):
    """One row for each finished member of a campaign file. `keys`: name of a column -> a key of the configuration; any
    table with "name" is the name of the case. `columns`: further ones of members."""
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
    rows = pd.read_csv(DATA / f"{name}.csv")
    return rows.assign(heave_N=rows.mean_heave)


def beside(data, words, first, quantities=QUANTITIES, more=(), step_by_step=False):
    """Cases `words`, the first with its means, the others as paired differences from it, or `step_by_step` from the case
    above. `more`: further columns, as name and heading, of which each case has its mean."""
    rows, other = [], None
    for case in words:
        one = data[data.case == case].set_index("arrangement")
        cells = [words[case]]
        for quantity in quantities:
            if other is None:
                mean = number(one[quantity].mean())
                cells.append(f"{mean} ± {half_width(one[quantity]):.{len(mean.partition('.')[2])}f}")
            else:
                apart = (one[quantity] - other[quantity]).dropna()
                cells.append(difference(apart.mean(), half_width(apart)))
        rows.append(cells + [number(one[name].mean()) for name in dict(more)])
        if other is None or step_by_step:
            other = one
    return table([first, *quantities.values(), *dict(more).values()], rows)


def friction(data):
    """Mean load by laws of friction at each speed: of the first the mean, of the others paired differences from it."""
    cases = data.case.str.rsplit("_", n=1, expand=True)
    speeds = sorted(cases[1].unique(), key=float)
    rows = []
    for law, words in FRICTION.items():
        cells = [words]
        for speed in speeds:
            one, constant = (data[data.case == f"{name}_{speed}"].set_index("arrangement").mean_N
                             for name in [law, "constant"])
            if law == "constant":
                cells.append(f"{number(one.mean())} ± {half_width(one):.1f}")
            else:
                apart = (one - constant).dropna()
                cells.append(difference(apart.mean(), half_width(apart)))
        rows.append(cells)
    return table(["friction", *(f"mean, N, {speed} m/s" for speed in speeds)], rows)


def numerics():
    return beside(members("resolution"), NUMERICS, "computed with", NUMERIC_QUANTITIES, {"mean_sweeps": "sweeps a step"})


def jam():
    rows = members("jam")
    counts = rows.case.value_counts()
    return beside(rows, {case: f"{text} ({counts[case]})" for case, text in JAM.items()}, "contacts solved to (arrangements)",
                  LONG_QUANTITIES, {"mean_sweeps": "sweeps a step"})


def collect(folder):
    for campaign, name in CAMPAIGNS.items():
        files = [*pathlib.Path(folder).glob(f"{campaign}.h5"), *sorted(pathlib.Path(folder).glob(f"{campaign}.part*.h5"))]
        if files:
            rows = pd.concat([collected(file, {"case": "joint.name"}, COLUMNS) for file in files])
            rows.sort_values("arrangement", kind="stable").round(6).to_csv(DATA / f"{name}.csv", index=False)


BLOCKS = {"numerics": numerics, "jam": jam, "choices": lambda: beside(members("choices"), CHOICES, "contacts"),
          "friction_cone": lambda: friction(members("friction_cone"))}

if __name__ == "__main__":
    make({DOCS / "convergence.md": BLOCKS}, __doc__, collect=collect)
