#!/usr/bin/python3
"""Load histories of one arrangement, one panel a case, as in the paper's Fig. 6.

Thin: every time step. Black: mean over 5 s. Grey: before the window in which the load is measured.

Usage: load_history.py CAMPAIGN.h5 OUTPUT.png [ARRANGEMENT]
"""
import sys

import h5py
import matplotlib

matplotlib.use("agg")
import matplotlib.pyplot as plt
import numpy as np

COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00"]  # Okabe and Ito


def moving_mean(values, width):
    """Over what there is of the window of `width` samples: no droop at the ends."""
    ones = np.ones(width)
    return np.convolve(values, ones, mode="same") / np.convolve(np.ones(len(values)), ones, mode="same")


def main(campaign, output, arrangement=0):
    with h5py.File(campaign) as file:
        time = file["time"][:]
        members = file["members"]
        chosen = np.flatnonzero((members["arrangement"][:] == arrangement) & (members["status"][:] == 0))
        names = [n.decode() if isinstance(n, bytes) else n for n in file["cases/name"][:]]
        figure, axes = plt.subplots(len(chosen), 1, sharex=True, figsize=(9, 1.9 * len(chosen) + 0.6), squeeze=False)
        for axis, member, colour in zip(axes[:, 0], chosen, COLOURS):
            load = file["history/surge_load"][member]
            case = int(members["case"][member])
            axis.plot(time, load, color=colour, linewidth=0.4, alpha=0.6)
            step = float(file["cases/time_step"][case])
            axis.plot(time, moving_mean(load, round(5 / step)), color="black", linewidth=1.2)
            axis.axvspan(0, float(file["cases/steady_start"][case]), color="0.93", zorder=0)
            axis.set_xlim(0, time[-1])
            axis.set_ylabel("load (N)")
            axis.set_title(
                f"{names[case]}: mean {members['mean_load'][member]:.1f} N, "
                f"mean maximum {members['mean_maximum'][member]:.0f} N, "
                f"broken floes {100 * members['failure_ratio'][member]:.1f} %",
                loc="left", fontsize=10)
            axis.set_ylim(bottom=min(0, float(np.nanmin(load))))
            axis.spines[["top", "right"]].set_visible(False)
        axes[-1, 0].set_xlabel("time since the tow began (s)")
        figure.tight_layout()
        figure.savefig(output, dpi=110)


if __name__ == "__main__":
    if not 3 <= len(sys.argv) <= 4:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2], int(sys.argv[3]) if len(sys.argv) == 4 else 0)
