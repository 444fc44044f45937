"""The picture of docs/field.md."""
import numpy as np
import pandas as pd

from validation_figures import finish  # before pyplot: it chooses the writer of SVG
import matplotlib.pyplot as plt
from matplotlib.patches import Rectangle

from order_data import SUMMARIES, members, settings


def colours(levels):
    """Glass light, crystal dark; levels by their place, as the sweeps span decades."""
    return dict(zip(levels, plt.cm.viridis_r(np.linspace(0.22, 1, len(levels)))))


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
