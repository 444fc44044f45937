#!/usr/bin/python3
"""A vessel's own program, as small as it can be: a mass on a spring in surge, under ice from an FMU of floes.

    mass_on_a_spring.py inside.fmu outside.fmu [OFFSETS.csv]

Both FMUs are of one hull. The first moves it, and takes the spring's force from here; the second is told the motion that
is computed here from its ice load. Prints the mean and the largest offset that each gives in the second half of the run,
and writes both offsets over time. docs/coupling.md has the commands that make the FMUs.
"""

import csv
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from fmu_host import Fmu  # noqa: E402

MASS, STIFFNESS, DAMPING_RATIO = 800.0, 2800.0, 0.1  # kg with the water that moves along, N/m, of the critical
DAMPING = 2 * DAMPING_RATIO * math.sqrt(MASS * STIFFNESS)


def pull(x, v):
    """Of the spring and the damper on the hull, N."""
    return -STIFFNESS * x - DAMPING * v


def moved_inside(path):
    """The FMU has the mass; what holds it is given as a force at the beginning of each step."""
    with Fmu(path) as ice:
        ice.begin()
        for _ in range(round(ice.stop_time / ice.time_step)):
            ice["force_x"] = pull(ice["x"], ice["x_velocity"])
            ice.step(ice.time_step)
            yield ice.time, ice["x"]


def moved_outside(path):
    """The mass is here; the FMU is told how it moves, and its load moves it over the same step."""
    with Fmu(path) as ice:
        ice.begin()
        x, v, step = 0.0, 0.0, ice.time_step
        for _ in range(round(ice.stop_time / step)):
            ice["x"], ice["x_velocity"] = x, v
            ice.step(step)
            v += step * (ice["ice_force_x"] + pull(x, v)) / MASS
            x += step * v
            yield ice.time, x


def main(inside, outside, table=None):
    rows = [(time, here, there) for (time, here), (_, there) in zip(moved_inside(inside), moved_outside(outside))]
    late = rows[len(rows) // 2:]
    for name, column in (("moved inside", 1), ("moved outside", 2)):
        offsets = [-row[column] for row in late]  # ice pushes to -X
        print(f"{name}: mean offset {1e3 * sum(offsets) / len(offsets):.1f} mm, largest {1e3 * max(offsets):.1f} mm")
    if table:
        with open(table, "w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file)
            writer.writerow(["time_s", "moved_inside_m", "moved_outside_m"])
            writer.writerows([f"{time:.2f}", f"{here:.5f}", f"{there:.5f}"] for time, here, there in rows[4::5])


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    main(*sys.argv[1:])
