"""The data of docs/field.md: its summaries, and how they are taken from the campaigns."""
import io
import json
import pathlib

import pandas as pd

from told import said

SUMMARIES = pathlib.Path(__file__).resolve().parent.parent / "order"
ORDER = ["psi4", "local_order", "coverage"]
LOADS = {"mean_load": "mean load, N", "sd_load": "SD, N", "mean_maximum": "mean maximum, N",
         "mean_maximum_1s": "mean maximum over 1 s, N", "failure_ratio": "broken floes, %"}
COLUMNS = ["sweeps", "arrangement", *ORDER, *LOADS, "trend_p"]
WALL_COLUMNS = ["case", "arrangement", "mean_load", "sd_load", "mean_maximum_1s", "failure_ratio", "trend_p"]


def members():
    """One row for each finished member, sorted by level and arrangement; coverage and broken floes are in percent."""
    return pd.read_csv(SUMMARIES / "members.csv")


def walls():
    """One row for each finished member of the walls and far ends."""
    return pd.read_csv(SUMMARIES / "wall_far_end.csv")


def settings():
    return json.loads((SUMMARIES / "settings.json").read_text())


def finished(campaign, program):
    """Figures of the finished members as `program` gives them, and the row of /arrangements as `field`: `arrangement` is
    the number, equal for the same throw."""
    import h5py  # which --check does not need

    table = pd.read_csv(io.StringIO(said(program, "summarize", campaign, "--parts", "members", "--format", "csv")))
    with h5py.File(campaign) as file:
        row = table.arrangement.to_numpy()
        table = table.assign(field=row, arrangement=file["arrangements/number"][:][row])
    return table[table.status == "done"].assign(failure_ratio=lambda rows: 100 * rows.failure_ratio)


def collect_walls(campaign, program):
    table = finished(campaign, program)[WALL_COLUMNS]
    table.to_csv(SUMMARIES / "wall_far_end.csv", index=False, float_format="%.6g")


def collect(campaign, program):
    """Writes the summaries of the campaign of levels."""
    import tomllib

    import h5py

    table = finished(campaign, program)
    with h5py.File(campaign) as file:
        configuration = tomllib.loads(file["provenance/configuration"].asstr()[()])
        sweeps = {case["name"]: case["arrangement"]["ordering_sweeps"] for case in configuration["case"]}
        table = table.assign(sweeps=table.case.map(sweeps), psi4=file["arrangements/psi4"][:][table.field],
                             coverage=100 * table.coverage_ahead)
        fields(table, file["arrangements/pose"]).to_csv(SUMMARIES / "fields.csv", index=False, float_format="%.5g")
    table = table.sort_values(["sweeps", "arrangement"])[COLUMNS]
    table.to_csv(SUMMARIES / "members.csv", index=False, float_format="%.6g")
    kept = {name: configuration[name] for name in ["floe", "field", "structure", "analysis"]}
    (SUMMARIES / "settings.json").write_text(json.dumps(kept, indent=1) + "\n")


def shown_arrangement(table):
    """The first arrangement that has both the lowest and the highest level."""
    of_ends = table[table.sweeps.isin([table.sweeps.min(), table.sweeps.max()])].groupby("arrangement").size()
    return of_ends[of_ends == 2].index.min()


def fields(table, poses):
    """Where the floes of the shown arrangement lie, at the lowest and the highest level."""
    shown = table[table.arrangement == shown_arrangement(table)]
    parts = []
    for row in shown[shown.sweeps.isin([shown.sweeps.min(), shown.sweeps.max()])].itertuples():
        parts.append(pd.DataFrame(poses[row.field], columns=["x_m", "z_m", "yaw_rad"]).assign(sweeps=row.sweeps))
    return pd.concat(parts)
