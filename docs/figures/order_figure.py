"""The picture of docs/field.md."""
import numpy as np
import pandas as pd

from validation_figures import finish  # before pyplot: it chooses the writer of SVG
import matplotlib.pyplot as plt
from matplotlib.patches import Rectangle

from order_data import LOADS, ORDER, SUMMARIES, curves, floe_time, members, settings
from order_tables import STUDIED
from validation_data import half_width


def colours(levels):
    """Glass light, crystal dark; levels by their place, as the sweeps span decades."""
    return dict(zip(levels, plt.cm.viridis_r(np.linspace(0.22, 1, len(levels)))))


def draw_loads(axes, rows, name, shades):
    for level, own in rows.groupby("sweeps"):
        axes.plot(own.local_order, own[name], "o", color=shades[level], markersize=3.5, alpha=0.6, markeredgewidth=0)
        axes.errorbar(own.local_order.mean(), own[name].mean(), half_width(own[name]), half_width(own.local_order),
                      fmt="s", color=shades[level], markeredgecolor="black", ecolor="black", elinewidth=1, capsize=2,
                      markersize=6, zorder=3, label=f"{level} sweeps")
    axes.set_ylim(bottom=0)
    axes.set_xlabel(ORDER["local_order"])
    axes.set_ylabel(LOADS[name])


def draw_histories(panels, shades, window):
    loads = curves("histories")
    top = 1.05 * loads.to_numpy().max()
    for axes, level in zip(panels, loads.columns):
        axes.plot(loads.index, loads[level], color=shades[int(level)], linewidth=0.7)
        axes.axvspan(0, window[0], color="0.93", zorder=0)
        axes.set_xlim(0, loads.index.max())
        axes.set_ylim(0, top)
        axes.set_ylabel("load, N")
        axes.text(0.01, 0.95, f"{level} sweeps", transform=axes.transAxes, va="top")
    panels[0].tick_params(labelbottom=False)
    panels[-1].set_xlabel("time, s")


def draw_correlation(axes, shades, period):
    correlations = curves("autocorrelation")
    for level in correlations.columns:
        axes.plot(correlations.index, correlations[level], color=shades[int(level)], linewidth=1.3)
    axes.axhline(0, color="black", linewidth=0.6)
    for times in range(1, int(correlations.index.max() / period + 0.05) + 1):
        axes.axvline(times * period, color="black", linewidth=0.8, linestyle=":")
    axes.set_xlim(0, correlations.index.max())
    axes.set_ylim(min(-0.3, correlations.to_numpy().min() - 0.02), 1)
    axes.set_xlabel("lag, s (dotted: floe lengths)")
    axes.set_ylabel("autocorrelation")


def draw_fields(path):
    """The floes of one arrangement from above, at the lowest and the highest level."""
    floes, kept = pd.read_csv(SUMMARIES / "fields.csv"), settings()
    length, breadth = kept["floe"]["length_m"], kept["floe"]["breadth_m"]
    half_width = kept["field"]["half_width_m"]
    shades = colours(sorted(members().sweeps.unique()))
    levels = sorted(floes.sweeps.unique())
    figure, panels = plt.subplots(len(levels), 1, figsize=(7.5, 5.2), sharex=True)
    for axes, level in zip(panels, levels):
        for floe in floes[floes.sweeps == level].itertuples():
            centre = (floe.x_m, floe.z_m)  # a positive yaw turns x away from z
            axes.add_patch(Rectangle((floe.x_m - length / 2, floe.z_m - breadth / 2), length, breadth,
                                     angle=-np.degrees(floe.yaw_rad), rotation_point=centre, facecolor=shades[level],
                                     edgecolor="white", linewidth=0.5))
        axes.set_ylim(-half_width, half_width)
        axes.set_xlim(floes.x_m.min() - length, floes.x_m.max() + length)
        axes.set_aspect("equal")
        axes.set_ylabel("z, m")
        axes.set_title(f"{level} sweeps", fontsize=10, loc="left")
    panels[-1].set_xlabel("x, m; the structure comes from the left")
    finish(figure, path)


def draw(path):
    rows, kept = members(), settings()
    shades = colours(sorted(rows.sweeps.unique()))
    figure = plt.figure(figsize=(11, 6.6))
    grid = figure.add_gridspec(3, 4, height_ratios=[2.2, 1, 1])
    loads = [figure.add_subplot(grid[0, place]) for place in range(4)]
    for axes, name in zip(loads, STUDIED):
        draw_loads(axes, rows, name, shades)
    draw_histories([figure.add_subplot(grid[place, :3]) for place in (1, 2)], shades,
                   (kept["analysis"]["steady_start_s"],))
    draw_correlation(figure.add_subplot(grid[1:, 3]), shades, floe_time(kept))
    finish(figure, path, legend_of=loads[0])
