#!/usr/bin/python3
"""Draws docs/figures/arrangement.png: is the start of the Monte Carlo chain forgotten, and when?

    cmake --preset release && cmake --build --preset release --target arrangement_chains
    docs/figures/arrangement.py build/release/docs/figures/arrangement_chains

Takes about two minutes. A second argument is where the picture goes instead.
"""

import collections
import math
import pathlib
import subprocess
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

CHAINS = 24
DEFAULT_SWEEPS = 20000
SWEEPS = 2 * DEFAULT_SWEEPS  # followed beyond the default; floes are drawn and counted at the default
BEGIN, END, HALF_WIDTH, SIDE = 6.0, 24.9, 2.4, 0.6
COLOURS = {"lattice": "#0072B2", "stripes": "#D55E00"}


def read(program):
    """chains[start][sweeps] -> rows of (psi4, near_far, sway, columns); poses[start, chain, sweeps] -> rows of (x, z, yaw)"""
    chains = {start: collections.defaultdict(list) for start in COLOURS}
    poses = collections.defaultdict(list)
    output = subprocess.run([program, str(CHAINS), str(SWEEPS)], check=True, capture_output=True, text=True).stdout
    for line in output.splitlines():
        kind, start, number, sweeps, *values = line.split(",")
        if kind == "chain":
            chains[start][int(sweeps)].append([float(value) for value in values])
        else:
            poses[start, int(number), int(sweeps)].append([float(value) for value in values])
    return chains, poses


def draw_floes(axes, poses, title):
    corners = 0.5 * SIDE * np.array([[1, 1], [-1, 1], [-1, -1], [1, -1]])
    for x, z, yaw in poses:
        turn = np.array([[math.cos(yaw), math.sin(yaw)], [-math.sin(yaw), math.cos(yaw)]])
        # Fourfold angle: squares that differ by a quarter turn are the same.
        colour = plt.cm.twilight(yaw / (math.pi / 2) % 1)
        axes.fill(*(corners @ turn.T + [x, z]).T, facecolor=colour, edgecolor="black", linewidth=0.4)
    axes.add_patch(plt.Rectangle((BEGIN, -HALF_WIDTH), END - BEGIN, 2 * HALF_WIDTH, fill=False, linewidth=1.0))
    axes.set(xlim=(BEGIN - 0.1, END + 0.1), ylim=(-HALF_WIDTH - 0.1, HALF_WIDTH + 0.1), aspect="equal", title=title,
             xlabel="x, m", ylabel="z, m")


def draw_history(axes, chains, column, label):
    for start, states in chains.items():
        sweeps = np.array(sorted(states))
        values = np.array([[row[column] for row in states[n]] for n in sweeps])
        mean, error = values.mean(axis=1), values.std(axis=1, ddof=1) / math.sqrt(values.shape[1])
        at = np.maximum(sweeps, 80)  # the start itself, on a logarithmic axis
        axes.fill_between(at, mean - 2 * error, mean + 2 * error, color=COLOURS[start], alpha=0.25, linewidth=0)
        axes.plot(at, mean, color=COLOURS[start], label=f"from {start}")
    axes.axvline(DEFAULT_SWEEPS, color="grey", linewidth=0.8, linestyle="--")
    axes.set(xscale="log", xlabel="sweeps", ylabel=label)


def draw_profile(axes, poses, coordinate, low, high, bins, label):
    width = (high - low) / bins
    middles = low + width * (np.arange(bins) + 0.5)
    for start in COLOURS:
        counts = np.array([np.histogram(np.array(rows)[:, coordinate], bins, (low, high))[0]
                           for (name, _, sweeps), rows in poses.items() if name == start and sweeps == DEFAULT_SWEEPS])
        share = counts / counts.sum(axis=1, keepdims=True) * bins
        mean, error = share.mean(axis=0), share.std(axis=0, ddof=1) / math.sqrt(len(share))
        axes.fill_between(middles, mean - 2 * error, mean + 2 * error, color=COLOURS[start], alpha=0.25, linewidth=0)
        axes.plot(middles, mean, color=COLOURS[start], linewidth=1)
    axes.axhline(1, color="grey", linewidth=0.8)
    axes.set(xlabel=label, ylabel="density of floe centres\nover its mean")


def main():
    chains, poses = read(sys.argv[1])
    target = sys.argv[2] if len(sys.argv) > 2 else pathlib.Path(__file__).with_name("arrangement.png")
    figure, axes = plt.subplots(4, 2, figsize=(12, 12.5), constrained_layout=True,
                                gridspec_kw={"height_ratios": [1, 1, 1.3, 1.3]})
    for row, start in enumerate(COLOURS):
        for column, sweeps in enumerate((0, DEFAULT_SWEEPS)):
            draw_floes(axes[row, column], poses[start, 0, sweeps], f"{start}, {sweeps} sweeps")
    draw_history(axes[2, 0], chains, 0, "ψ4")
    draw_history(axes[2, 1], chains, 1, "near-far imbalance, mean cos π(x - 6)/18.9")
    axes[2, 0].legend()
    draw_profile(axes[3, 0], poses, 0, BEGIN, END, 9, f"x, m (after {DEFAULT_SWEEPS} sweeps)")
    draw_profile(axes[3, 1], poses, 1, -HALF_WIDTH, HALF_WIDTH, 48, f"z, m (after {DEFAULT_SWEEPS} sweeps)")
    figure.suptitle(f"189 floes at 75 %, {CHAINS} chains from each start; bands: ± 2 standard errors")
    figure.savefig(target, dpi=80)

    print("sweeps  start    psi4            near_far         sway, m          columns")
    for wanted in (0, 1000, 2000, 5000, 10000, DEFAULT_SWEEPS, SWEEPS):
        for start, states in chains.items():
            nearest = min(states, key=lambda n: abs(n - wanted))
            values = np.array(states[nearest])
            errors = values.std(axis=0, ddof=1) / math.sqrt(len(values))
            print(f"{nearest:6} {start:8}", "  ".join(f"{m:7.4f}({e:.4f})" for m, e in zip(values.mean(axis=0), errors)))


if __name__ == "__main__":
    main()
