"""The blocks of docs/order.md that its summaries give, each a function that gives Markdown."""
import numpy as np
from scipy import stats

from order_bursts import WINDOWS
from order_data import LOADS, ORDER, floe_time, members, settings
from order_regression import explained, fit, holm, predicted, within_level_sd
from validation_data import PAPER, half_width
from validation_tables import number, table

STUDIED = ["mean_load", "sd_load", "mean_maximum_0.1s", "failure_ratio"]
BURSTS = {"before": "highest from {} to {} s", "burst": "burst strength: {} to {} s", "after": "highest from {} to {} s"}
MODELS = {"local order": ["local_order", "coverage"], "ψ4": ["psi4", "coverage"]}


def with_interval(values):
    if len(values) < 2:
        return number(np.mean(values))
    mean, half = np.mean(values), half_width(values)
    return f"{number(mean)} [{number(mean - half)}, {number(mean + half)}]"


def signed(value):
    return ("-" if value < 0 else "+") + number(abs(value))


def share(r2):
    return f"{r2 + 0.0:.2f}".replace("-0.00", "0.00")


def percent(r2):
    return f"{100 * max(0, r2):.0f} %"


def keys(values):
    """Keys of the configuration with their values, as they stand there."""
    written = {True: "true", False: "false"}
    return ", ".join(f"`{key}` {written[value] if isinstance(value, bool) else value}" for key, value in values.items()
                     if not isinstance(value, dict))


def levels(rows, columns):
    return {level: own for level, own in rows.groupby("sweeps")}, [dict(ORDER, **LOADS)[name] for name in columns]


def campaign():
    """What was run, from the configuration in the campaign file."""
    kept = settings()
    general, field, structure = (kept[name] for name in ["general", "field", "structure"])
    (low, narrow), (high, wide) = structure["profile_m"][:2]
    angle = np.degrees(np.arctan2(high - low, wide - narrow))
    analysis, rows = kept["analysis"], members()
    return table(["", ""], [
        ["members", f"{kept['done']}: {rows.arrangement.nunique()} arrangements (seed {kept['campaign']['seed']}) at "
                    f"{rows.sweeps.nunique()} levels of order"],
        ["ice", f"{field['floes']} floes of {kept['floe']['length_m']} m at {field['concentration_percent']:g} %, "
                f"E {kept['elastic_modulus_MPa']:g} MPa (Σ {kept['joint']['cfm']:g})"],
        ["wall", f"{angle:.1f}° below the waterline (radius {narrow} m at the bottom)"],
        ["tow", f"{structure['speed_m_s']} m/s: one floe length in {floe_time(kept):.2f} s"],
        ["far end", field["far_end"].replace("_", " ")],
        ["`[contact]`", keys(kept["contact"])],
        ["`[paper]`", keys(kept["paper"])],
        ["`[water]`", keys(kept["water"])],
        ["solver", f"Δt {general['time_step_s']} s, {general['iterations']} iterations"],
        ["window", f"{analysis['steady_start_s']:g} to {analysis['steady_start_s'] + analysis['window_s']:g} s in "
                   f"{analysis['segments']} segments"],
        ["processor time", f"{kept['processor_minutes']:.0f} min"]])


def order():
    own, names = levels(members(), ORDER)
    return table(["sweeps", "members", *names, "steady"],
                 [[str(level), str(len(rows)), *[with_interval(rows[name]) for name in ORDER],
                   f"{np.sum(rows.trend_p > 0.05)} of {len(rows)}"] for level, rows in own.items()])


def loads():
    own, names = levels(members(), LOADS)
    lines = [[str(level), *[with_interval(rows[name]) for name in LOADS]] for level, rows in own.items()]
    paper = dict(PAPER.loc["E60"], failure_ratio=100 * PAPER.loc["E60", "failure_ratio"])
    lines.append(["the paper, one run", *[number(paper[name]) if name in paper else "" for name in LOADS]])
    return table(["sweeps", *names], lines)


def paired(rows, name, level):
    """Differences to the lowest level within arrangements."""
    wide = rows.pivot(index="arrangement", columns="sweeps", values=name)
    return (wide[level] - wide[wide.columns.min()]).dropna().to_numpy()


def differences():
    rows = members()
    first, *others = sorted(rows.sweeps.unique())
    columns = []
    for name in LOADS:
        changes = [paired(rows, name, level) for level in others]
        adjusted = holm([stats.ttest_1samp(change, 0).pvalue for change in changes])
        columns.append([("**{}**" if p < 0.05 else "{}").format(f"{signed(change.mean())} ± {number(half_width(change))}")
                        for change, p in zip(changes, adjusted)])
    names = levels(rows, LOADS)[1]
    return table([f"sweeps, less {first}", *names], [[str(level), *line] for level, line in zip(others, zip(*columns))])


def bursts():
    own, period = levels(members(), [])[0], floe_time(settings())
    heads = [text.format(*(f"{part * period:.1f}" for part in WINDOWS[name])) for name, text in BURSTS.items()]
    lines = []
    for level, rows in own.items():
        excess = rows.burst - (rows.before + rows.after) / 2
        lines.append([str(level), *[with_interval(rows[name]) for name in BURSTS], with_interval(excess),
                      with_interval(rows.burst_s)])
    return table(["sweeps", *heads, "strength less the mean of its neighbours", "time of the highest, s"], lines)


def slope(value, error, half, unit):
    mark = "**" if abs(value) > half else ""
    return f"{mark}{signed(unit * value)} ({number(unit * error)}){mark}"


def regression():
    rows, lines = members(), []
    for name in STUDIED:
        line = [LOADS[name]]
        for predictors in MODELS.values():
            order_, coverage = zip(*fit(rows, name, predictors))
            line += [slope(*order_, 0.1), slope(*coverage, 1), share(explained(rows, name, predictors))]
        lines.append(line)
    heads = [[f"per 0.1 of {model}", f"per 1 % of coverage, with {model}", f"R² with {model}"] for model in MODELS]
    return table(["", *sum(heads, [])], lines)


def three_ways():
    rows, lines = members(), []
    for name in STUDIED:
        line = [LOADS[name]]
        for groups in [None, "arrangement", "sweeps"]:
            line.append(slope(*next(zip(*fit(rows, name, MODELS["local order"], groups))), 0.1))
        lines.append(line)
    return table(["per 0.1 of local order", "over all members", "within an arrangement", "within a level"], lines)


def control():
    """Left out: R2 of prediction, and by how much it multiplies the number of arrangements."""
    rows, lines = members(), []
    both = MODELS["local order"]
    for name in [*STUDIED, "burst"]:
        inside = [explained(rows, name, predictors, "sweeps") for predictors in [both[:1], both[1:], *MODELS.values()]]
        unseen = [predicted(rows, name, predictors) for predictors in [both[1:], both]]
        lines.append([LOADS[name], number(within_level_sd(rows, name)), *map(share, inside),
                      *[f"{share(r2)} ({1 / (1 - r2):.2f})" for r2 in unseen]])
    return table(["", "SD within a level", "R²: local order", "R²: coverage", "R²: both", "R²: ψ4 and coverage",
                  "left out: coverage", "left out: local order and coverage"], lines)


def caution():
    """What is wrong with the summaries, a paragraph, if anything is."""
    kept = settings()
    if kept["campaign"]["name"] != "order":
        return [f"**These are not the figures of the study: they are from a stand-in, `{kept['campaign']['name']}`, that "
                "only tries the script.**\n"]
    missing = kept["members"] - kept["done"]
    return [f"**{missing} of {kept['members']} members are missing.**\n"] if missing else []


def answer():
    """The main figures in sentences that hold whatever they are."""
    rows = members()
    own, (first, last) = levels(rows, [])[0], (rows.sweeps.min(), rows.sweeps.max())
    start, end = ({name: number(own[level][name].mean()) for name in [*ORDER, *LOADS]} for level in (first, last))
    parts = []
    for name in LOADS:
        change = paired(rows, name, last)
        half = half_width(change)
        parts.append(f"  * {LOADS[name]}: {start[name]} and {end[name]}; the difference of {signed(change.mean())} ± "
                     f"{number(half)} is {'beyond' if abs(change.mean()) > half else 'within'} chance")
    names = [LOADS[name].split(", ")[0] for name in STUDIED]
    over_all = [percent(explained(rows, name, MODELS["local order"])) for name in STUDIED]
    inside = [percent(predicted(rows, name, MODELS["local order"])) for name in STUDIED]
    return "\n".join([
        *caution(),
        f"* From {first} to {last} sweeps over the same fields (local order {start['local_order']} to "
        f"{end['local_order']}, ψ4 {start['psi4']} to {end['psi4']}), with 95 % intervals of the differences:", *parts,
        f"* Over all members, local order and coverage ahead together explain these shares of the variance: "
        f"{', '.join(f'{name} {value}' for name, value in zip(names, over_all))}.",
        f"* Between arrangements within one level they predict, for arrangements that the fit has not seen: "
        f"{', '.join(f'{name} {value}' for name, value in zip(names, inside))}."])


BLOCKS = {"answer": answer, "campaign": campaign, "order": order, "loads": loads, "differences": differences,
          "bursts": bursts, "regression": regression, "three ways": three_ways, "control": control}
