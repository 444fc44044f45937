"""The blocks of docs/field.md that its summaries give, each a function that gives Markdown."""
import pandas as pd

from order_data import LOADS, SUMMARIES, members, walls
from validation_data import half_width
from validation_tables import table, with_interval

STUDIED = ["mean_load", "sd_load", "mean_maximum_1s", "failure_ratio"]
SCENES = {"closed": "ice sheet, scattered", "rows": "ice sheet, 10000 sweeps", "open": "open water, scattered"}


def percent(values, base):
    """Change of the mean over the same arrangements, in percent of that of `base`, with its 95 % interval (delta method)."""
    both = pd.DataFrame({"value": values, "base": base}).dropna()
    ratio = both.value.mean() / both.base.mean()
    half = half_width(both.value - ratio * both.base) / both.base.mean()
    return f"{100 * (ratio - 1):+.0f} ± {100 * half:.0f} %"


def changes():
    """In words: the change of the loads from the lowest to the highest level, as a share of the lowest."""
    rows, parts = members(), []
    first, last = rows.sweeps.min(), rows.sweeps.max()
    for name in STUDIED:
        wide = rows.pivot(index="arrangement", columns="sweeps", values=name)
        parts.append(f"{LOADS[name].split(', ')[0]} {percent(wide[last], wide[first])}")
    return f"From {first} to {last} sweeps: {', '.join(parts)}."


def ran():
    computed, lines = pd.read_csv(SUMMARIES.parent / "campaigns.csv").set_index("campaign"), []
    for name, row in computed.loc[["order", "wall_far_end"]].iterrows():
        command = f"floes run configs/validation/{name}.toml"
        lines.append(f"    {command:50}# {row.members} members, {row.core_minutes:.0f} minutes of one core")
    return "\n".join([*lines, "    docs/figures/order.py --collect . --program floes"])


def wall_table():
    """Mean loads by wall, and their change from scattered floes before an ice sheet."""
    rows, lines = walls(), []
    rows = rows.assign(angle=rows.case.str.partition("deg")[0], scene=rows.case.str.partition("_")[2])
    for angle, of_wall in rows.groupby("angle"):
        loads = {scene: of_wall[of_wall.scene == scene].set_index("arrangement").mean_load for scene in SCENES}
        changes = {scene: f" ({percent(load, loads['closed'])})" for scene, load in loads.items() if scene != "closed"}
        lines.append([f"{angle}°", *[with_interval(load) + changes.get(scene, "") for scene, load in loads.items()]])
    return table(["wall", *SCENES.values()], lines)


BLOCKS = {"changes": changes, "walls": wall_table, "ran": ran}
