"""The pictures of docs/validation.md."""
import matplotlib

matplotlib.use("svg")
matplotlib.rcParams["svg.hashsalt"] = "floes"
matplotlib.rcParams["font.size"] = 10
import matplotlib.pyplot as plt
import numpy as np

from validation_data import (EXPERIMENT, LABELS, MODULI, WALLS, WAYS, hybrid, interval, is_maximum, members, of_tank,
                             paper, pooled)

COLOURS = {"E30": "#0072B2", "E60": "#D55E00", "E200": "#009E73"}  # Okabe and Ito
PANELS = ["mean_load", "mean_maximum", "failure_ratio"]


def finish(figure, path, legend_of=None, legend_rows=1):
    for axes in figure.axes:
        axes.spines[["top", "right"]].set_visible(False)
    if legend_of is not None:
        handles, names = legend_of.get_legend_handles_labels()
        figure.legend(handles, names, loc="upper center", ncol=-(-len(names) // legend_rows), frameon=False)
    figure.tight_layout(rect=(0, 0, 1, 1 if legend_of is None else 1 - 0.07 * legend_rows - 0.01))
    figure.savefig(path, metadata={"Date": None})
    plt.close(figure)


def draw_estimate(axes, place, values, positive, colour, labels):
    """The mean with its interval, on a bar that holds 95 % of single runs, `positive` as for interval(). `labels`: of bar
    and mean, None for none."""
    _, low, high = interval(values, one_run=True, positive=positive)
    axes.vlines(place, low, high, color="0.72", linewidth=5, label=labels[0])
    mean, low, high = interval(values)
    axes.errorbar(place, mean, [[mean - low], [high - mean]], fmt="o", color=colour, capsize=5, linewidth=2,
                  label=labels[1])


def answer(path):
    """Table 3 computed in two ways, and the tank test on three walls: every member as a dot, the mean with its interval, what
    single runs give, and the paper's single runs or the experiment."""
    figure, panels = plt.subplots(1, 3, figsize=(11, 4.6))
    for axes, quantity in zip(panels, PANELS):
        for group, campaign in enumerate(WAYS):
            table = members(campaign)
            for place, (case, modulus) in enumerate(MODULI.items()):
                at = 3.6 * group + place
                values = table[table.case == case][quantity].to_numpy()
                order = np.argsort(np.argsort(values))  # dots side by side, in no other order than their size
                first = group == 0
                axes.plot(at - 0.24 + 0.08 * (order % 3 - 1), values, ".", color=COLOURS[case], alpha=0.45, markersize=3,
                          markeredgewidth=0, label=None)
                draw_estimate(axes, at + 0.06, values, is_maximum(quantity), COLOURS[case],
                              ("95 % of single runs" if first and place == 0 else None,
                               f"mean, {modulus} MPa" if first else None))
                axes.plot(at + 0.34, paper(case, quantity), "D", color="black", markersize=5,
                          label="the paper's run" if first and place == 0 else None)
        # Of the tank the largest load over 1 s, and floes cracked through.
        shown = {"mean_maximum": "maximum_load_1s", "failure_ratio": "split_ratio"}.get(quantity, quantity)
        walls = of_tank(shown)
        means, runs = pooled(walls), pooled(walls, one_run=True, positive=is_maximum(quantity))
        for place, (case, values) in enumerate(walls.items()):
            at = 7.2 + place
            axes.plot(np.full(len(values), at - 0.24), values, ".", color=COLOURS["E60"], alpha=0.45, markersize=3,
                      markeredgewidth=0)
            axes.vlines(at + 0.06, *runs[case][1:], color="0.72", linewidth=5)
            mean, low, high = means[case]
            axes.errorbar(at + 0.06, mean, [[mean - low], [high - mean]], fmt="o", color=COLOURS["E60"], capsize=5, linewidth=2)
        name = "maximum_load" if quantity == "mean_maximum" else quantity
        level = EXPERIMENT[name] * (100 if quantity == "failure_ratio" else 1)
        axes.hlines(level, 6.8, 9.6, color="black", linestyle=":", linewidth=1,
                    label="tank test" if axes is panels[0] else None)
        names = [name.replace(" contacts", "").replace(", ", ",\n") for name in WAYS.values()]
        angles = ", ".join(f"{float(wall[:-1]):.0f}°" for wall in WALLS.values())
        axes.set_xticks([1, 4.6, 8.2], names + [f"physics, wall\n{angles}"], fontsize=9)
        axes.tick_params(axis="x", length=0)
        axes.set_ylim(bottom=0)
        axes.set_ylabel(LABELS[quantity])
    finish(figure, path, legend_of=panels[0], legend_rows=2)


def hybrid_points(path):
    curve = hybrid()
    figure, axes = plt.subplots(figsize=(7.5, 4.6))
    axes.plot(curve.elastic_modulus_MPa, curve.limit_stress, color="#0072B2", label="limit stress (Lindqvist), Eq. (6)")
    axes.plot(curve.elastic_modulus_MPa, curve.limit_momentum, color="#D55E00",
              label="limit momentum (KPR, coefficient calibrated), Eq. (7)")
    axes.plot(curve.elastic_modulus_MPa, curve.hybrid, color="black", linewidth=3, alpha=0.35, label="hybrid: the lower")
    table = members("table3")
    for case, modulus in MODULI.items():
        draw_estimate(axes, modulus, table[table.case == case].mean_load, False, "#009E73",
                      (None, f"{WAYS['table3']}: mean, 95 %" if case == "E30" else None))
    for case, modulus in MODULI.items():
        axes.plot(1.2 * modulus, paper(case, "mean_load"), "D", color="black",
                  label="the paper's simulation" if case == "E30" else None)
    axes.plot(60 / 1.13, EXPERIMENT["mean_load"], "*", color="black", markersize=12, label="experiment")
    axes.set_xscale("log")
    axes.set_xlim(2, 500)
    axes.set_ylim(0, 120)
    axes.set_xlabel("elastic modulus E, MPa")
    axes.set_ylabel("mean load, N")
    axes.legend(frameon=False, fontsize=8)
    finish(figure, path)


def draw_all(folder):
    answer(folder / "answer.svg")
    hybrid_points(folder / "hybrid.svg")
