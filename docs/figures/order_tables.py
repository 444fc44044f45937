"""The blocks of docs/field.md that its summaries give, each a function that gives Markdown."""
import numpy as np
import pandas as pd

from order_data import LOADS, ORDER, members, walls
from order_regression import predicted
from validation_data import half_width
from validation_tables import number, table, with_interval as not_negative

STUDIED = ["mean_load", "sd_load", "mean_maximum_1s", "failure_ratio"]
SHOWN = {name: LOADS[name] for name in ("mean_load", "mean_maximum_1s", "failure_ratio")}  # in tables
ROWS = {**ORDER, **SHOWN, "burst": "burst strength"}
SCENES = {"closed": "ice sheet, scattered", "rows": "ice sheet, 10000 sweeps", "open": "open water, scattered"}


def with_interval(values):
    mean, half = np.mean(values), half_width(values)
    return f"{number(mean)} [{number(mean - half)}, {number(mean + half)}]"


def signed(value):
    return ("-" if value < 0 else "+") + number(abs(value))


def difference(values):
    """Mean of paired differences with its 95 % interval, bold where that excludes zero."""
    mean, half = np.mean(values), half_width(values)
    text = f"{signed(mean)} ± {number(half)}"
    return f"**{text}**" if abs(mean) > half else text


def by_level():
    """The members, with the strength of their bursts: what the highest autocorrelation has above its neighbours."""
    rows = members()
    return rows.assign(burst=rows.burst - (rows.before + rows.after) / 2)


def levels():
    """Order and loads by level, and the change from the lowest level over the same arrangements."""
    rows = by_level()
    first, *others = sorted(rows.sweeps.unique())
    lines = []
    for name, words in ROWS.items():
        wide = rows.pivot(index="arrangement", columns="sweeps", values=name)
        lines.append([words, *[with_interval(wide[level].dropna()) for level in [first, *others]],
                      difference((wide[others[-1]] - wide[first]).dropna())])
    return table(["ordering sweeps", *[str(level) for level in [first, *others]], f"{others[-1]} less {first}"], lines)


def percent(values, base):
    """Change of the mean over the same arrangements, in percent of that of `base`, with its 95 % interval (delta method)."""
    both = pd.DataFrame({"value": values, "base": base}).dropna()
    ratio = both.value.mean() / both.base.mean()
    half = half_width(both.value - ratio * both.base) / both.base.mean()
    return f"{100 * (ratio - 1):+.0f} ± {100 * half:.0f} %"


def changes():
    """In words: the change of the loads from the lowest to the highest level, as a share of the lowest."""
    rows, parts = by_level(), []
    first, last = rows.sweeps.min(), rows.sweeps.max()
    for name in STUDIED:
        wide = rows.pivot(index="arrangement", columns="sweeps", values=name)
        parts.append(f"{LOADS[name].split(', ')[0]} {percent(wide[last], wide[first])}")
    return f"From {first} to {last} sweeps: {', '.join(parts)}."


def within():
    """In words: what order and coverage predict of single arrangements."""
    rows = members()
    parts = [f"{LOADS[name].split(', ')[0]} {predicted(rows, name, ['local_order', 'coverage']):.2f}" for name in STUDIED]
    return f"R² of arrangements left out: {', '.join(parts)}."


def ran():
    lines = []
    for name, rows in {"order": members(), "wall_far_end": walls()}.items():
        command = f"floes run configs/validation/{name}.toml"
        lines.append(f"    {command:50}# {len(rows)} members, {rows.cpu_s.sum() / 60:.0f} minutes of one core")
    return "\n".join([*lines, "    docs/figures/order.py --collect order.h5 wall_far_end.h5 --program floes"])


def wall_table():
    rows, lines = walls(), []
    rows = rows.assign(angle=rows.case.str.partition("deg")[0], scene=rows.case.str.partition("_")[2])
    for angle, of_wall in rows.groupby("angle"):
        base = of_wall[of_wall.scene == "closed"].set_index("arrangement")
        for scene, words in SCENES.items():
            own = of_wall[of_wall.scene == scene].set_index("arrangement")
            change = "" if scene == "closed" else percent(own.mean_load, base.mean_load)
            mean, *others = [not_negative(own[name]) for name in SHOWN]
            lines.append([f"{angle}°", words, mean, change, *others])
    mean, *others = SHOWN.values()
    return table(["wall", "far end, floes", mean, "change of the mean", *others], lines)


BLOCKS = {"changes": changes, "levels": levels, "within": within, "walls": wall_table, "ran": ran}
