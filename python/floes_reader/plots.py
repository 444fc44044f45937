"""Two figures of `floes report`, drawn with matplotlib. Each returns its figure:
`plots.loads(campaign).savefig("loads.png")`."""

from collections.abc import Sequence

import numpy
from matplotlib import pyplot
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from .campaign import Campaign
from .stored import CampaignError

COLOURS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#b58900", "#56b4e9"]  # of cases, as in the report
INK, SOFT, GRID, SHADE = "#1b1f24", "#57606a", "#e4e7ea", "#ededed"
DASHES = (4, 2.5)
MOST_PANELS = 12


def loads(campaign: Campaign, quantity: str = "mean_load", cases: Sequence[str] | None = None) -> Figure:
    """A quantity of every arrangement as a dot, a strip for each case, and below the dots the mean over arrangements
    with its 95 % confidence interval (thick) and the 95 % prediction interval of one further run (dashed)."""
    known, members, summary = campaign.quantities, campaign.members, campaign.summary()
    shown = summary.index.unique("quantity")
    if quantity not in shown:
        raise CampaignError(f"summary() has no quantity '{quantity}'; it has {', '.join(shown)}.")
    names = _chosen(campaign, cases)
    figure, axes = pyplot.subplots(figsize=(8, 1.45 + 0.62 * len(names)), layout="constrained")
    lowest = largest = 0.0  # without prediction intervals: those of a few runs may run out of the picture
    for row, name in enumerate(names):
        values = members[quantity][members.case == name].dropna().to_numpy()
        lift = 0.06 * (2 * numpy.arange(len(values)) % 5)  # spreads the dots, always in the same way
        colour = _colour(campaign, name)
        axes.plot(values, row - 0.06 - lift, "o", color=colour, alpha=0.5, markersize=6, markeredgewidth=0)
        found = summary.loc[(name, quantity)]
        level = [row + 0.22] * 2
        axes.plot([found.prediction_low, found.prediction_high], level, color=INK, linewidth=1.3, dashes=DASHES)
        axes.plot([found.low, found.high], level, color=INK, linewidth=3.2, solid_capstyle="butt")
        axes.plot(found.estimate, level[0], "o", color=INK, markersize=6.5)
        lowest = numpy.nanmin([lowest, found.low, found.prediction_low, *values])  # left of 0 they count
        largest = numpy.nanmax([largest, *numpy.abs([found.low, found.high, *values])])
    axes.set_yticks(range(len(names)), names)
    axes.set_ylim(len(names) - 0.45, -0.5)
    left, right = axes.get_xlim()
    if largest > 0:
        axes.set_xlim(max(left, -2 * largest) if lowest < 0 else 0, min(right, 2 * largest))
    axes.set_xlabel(_label(known.long_name[quantity], known.units[quantity]))
    axes.tick_params(axis="y", length=0)
    axes.grid(axis="x", color=GRID)
    _legend(axes, {"one arrangement": Line2D([], [], color=SOFT, marker="o", linestyle="", alpha=0.6),
                   "mean, its 95 % interval": Line2D([], [], color=INK, marker="o", linewidth=3.2),
                   "95 % interval of one further run": Line2D([], [], color=INK, linewidth=1.3, dashes=DASHES)})
    return _finished(figure)


def histories(campaign: Campaign, arrangement: int = 0, over: float = 5.0,
              cases: Sequence[str] | None = None) -> Figure:
    """The surge load of one arrangement over time, a panel for each case. Thin: every value that the file keeps.
    Black: its mean over `over` seconds. Grey: before the window in which the load is measured."""
    members = campaign.members
    chosen = members[(members.arrangement_number == arrangement) & (members.status == "done")]
    chosen = chosen[chosen.case.isin(_chosen(campaign, cases))]
    if not 0 < len(chosen) <= MOST_PANELS:
        raise CampaignError(f"{len(chosen)} cases have arrangement {arrangement} done; 1 to {MOST_PANELS} can be "
                            "drawn: choose another one by arrangement=, or some cases by cases=[…].")
    figure, panels = pyplot.subplots(len(chosen), 1, sharex=True, sharey=True, squeeze=False, layout="constrained",
                                     figsize=(8, 1.0 + 1.75 * len(chosen)))
    ends = []
    for axes, (number, member) in zip(panels[:, 0], chosen.iterrows()):
        history = campaign.history(number)
        time, load = history.time.values, history.surge_load.values
        ends.append(time[-1])
        width = max(1, round(over * len(time) / time[-1]))
        axes.plot(time, load, color=_colour(campaign, member.case), linewidth=0.6, alpha=0.8)
        axes.plot(time, moving_mean(load, width), color=INK, linewidth=1.6)
        axes.axvspan(0, history.steady_start, color=SHADE, linewidth=0, zorder=0)
        axes.set_title(f"{member.case}: mean {member.mean_load:.1f} N, mean of the maxima {member.mean_maximum:.0f} N, "
                       f"broken floes {100 * member.failure_ratio:.0f} %", loc="left", fontsize=10)
        axes.set_ylabel("surge load, N")
        axes.grid(axis="y", color=GRID)
    panels[-1, 0].set_xlim(0, max(ends))
    panels[-1, 0].set_xlabel("time since the tow began, s")
    _legend(panels[0, 0], {"as kept in the file": Line2D([], [], color=SOFT, linewidth=0.8),
                           f"mean over {over:g} s": Line2D([], [], color=INK, linewidth=1.6),
                           "before the window": Patch(color=SHADE)}, above=1.14)
    return _finished(figure)


def moving_mean(values: numpy.ndarray, width: int) -> numpy.ndarray:
    """Round each value, over what there is of `width` values, so that the ends do not droop."""
    sums = numpy.concatenate([[0], numpy.cumsum(values)])
    middle = numpy.arange(len(values))
    first, last = numpy.maximum(0, middle - width // 2), numpy.minimum(len(values), middle - width // 2 + width)
    return (sums[last] - sums[first]) / (last - first)


def _chosen(campaign: Campaign, cases: Sequence[str] | None) -> list[str]:
    known = campaign.cases.index.tolist()
    for name in cases or []:
        campaign.keys(name)  # a sentence for a name that is not known
    return known if cases is None else [name for name in known if name in cases]


def _colour(campaign: Campaign, case: str) -> str:
    return COLOURS[campaign.cases.index.get_loc(case) % len(COLOURS)]


def _legend(axes: Axes, handles: dict[str, Artist], above: float = 1) -> None:
    """Over the axes, from the left."""
    axes.legend(list(handles.values()), list(handles), ncol=len(handles), frameon=False, fontsize=9.5, loc="lower left",
                bbox_to_anchor=(-0.01, above), borderaxespad=0.2, columnspacing=1.6, handletextpad=0.6)


def _label(long_name: str, units: str) -> str:
    return long_name if units == "1" else f"{long_name}, {units}"


def _finished(figure: Figure) -> Figure:
    for axes in figure.axes:
        axes.spines[["top", "right"]].set_visible(False)
        axes.spines[["left", "bottom"]].set_color(SOFT)
        axes.tick_params(colors=SOFT, labelcolor=INK)
        axes.set_axisbelow(True)
    return figure
