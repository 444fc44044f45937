#!/usr/bin/python3
"""Fig. 2 redrawn, and the ceiling that the number of iterations sets, from `floes laboratory plate`.

Usage: calibration.py OUTPUT_FOLDER [FLOES]      FLOES: the program, default ./floes
Writes calibration.json (what was measured), calibration.svg and ceiling.svg into the folder, and prints the ceiling
table. Takes some minutes.
"""
import json
import pathlib
import sys

from told import told
from validation_figures import finish, plt
from validation_tables import table

COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7"]
MARKERS = ["o", "s", "^", "D"]
PAPER = {1e-10: 200, 0.016: 60, 0.03: 30}
SMALL = "1e-10"


def calibrate(program, *arguments):
    return told(program, "laboratory", "plate", *arguments)["curve"]


def measure(program):
    return {
        "fig2": calibrate(program, "--cfm", "1e-10,1e-4,1e-3,0.003,0.008,0.016,0.03,0.06,0.1"),
        "ceiling": calibrate(program, "--sheet-m", "2.4", "--cfm", SMALL, "--element-m", "0.2,0.15,0.1",
                             "--iterations", "10,20,50,100,200"),
        "time_step": calibrate(program, "--sheet-m", "2.6", "--cfm", "1e-10,0.016", "--time-step-s", "0.005,0.01,0.02,0.03"),
        "thickness": calibrate(program, "--sheet-m", "2.6", "--cfm", "0.016", "--thickness-m", "0.02,0.03,0.033,0.05"),
        "erp": calibrate(program, "--sheet-m", "2.6", "--cfm", "1e-10,0.016", "--erp", "0.2,0.4,0.8"),
    }


def draw(curve, x, line, labels, path, marks=None):
    """E over the column x, one line for each value of the column `line`; marks: {x: E} to circle."""
    figure, axes = plt.subplots(figsize=(7.5, 4.4))
    for value, colour, marker in zip(sorted({p[line] for p in curve}, reverse=True), COLOURS, MARKERS):
        points = [p for p in curve if p[line] == value]
        axes.plot([p[x] for p in points], [p["elastic_modulus_MPa"] for p in points], color=colour, marker=marker,
                  markersize=5, label=labels["line"].format(value))
    if marks:
        axes.scatter(marks.keys(), marks.values(), s=130, facecolors="none", edgecolors="black", linewidths=1.5, zorder=5,
                     label=labels["marks"])
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel(labels["x"])
    axes.set_ylabel(labels["y"])
    axes.legend(frameon=False)
    axes.grid(True, which="major", alpha=0.3)
    finish(figure, path)


def print_table(curve, row, column, value="elastic_modulus_MPa"):
    columns, rows = sorted({p[column] for p in curve}), []
    for r in sorted({p[row] for p in curve}, reverse=True):
        cells = {p[column]: p[value] for p in curve if p[row] == r}
        rows.append([f"{r:g}", *(f"{cells[c]:.1f}" for c in columns)])
    print(table([f"{row} \\ {column}", *(f"{c:g}" for c in columns)], rows) + "\n")


def main(folder, program="./floes"):
    folder = pathlib.Path(folder)
    measured = measure(program)
    (folder / "calibration.json").write_text(json.dumps(measured, indent=1) + "\n")
    draw(measured["fig2"], "cfm", "sheet_m",
         {"x": "constraint force mixing Σ", "y": "elastic modulus E (MPa)", "line": "sheet of {} m",
          "marks": "the paper: about 200, 60, 30 MPa"}, folder / "calibration.svg", PAPER)
    draw(measured["ceiling"], "iterations", "element_m",
         {"x": "Gauss-Seidel iterations a step", "y": "E at Σ = 1e-10 (MPa)", "line": "elements of {} m"},
         folder / "ceiling.svg")
    print_table(measured["fig2"], "sheet_m", "cfm")
    print_table(measured["ceiling"], "element_m", "iterations")
    print_table(measured["time_step"], "cfm", "time_step_s")
    print_table(measured["thickness"], "cfm", "thickness_m")
    print_table(measured["erp"], "cfm", "erp")


if __name__ == "__main__":
    if not 2 <= len(sys.argv) <= 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
