#!/usr/bin/python3
"""What docs/fracture.md has of the grid of beams.

Usage:
    fracture.py                   writes it from docs/fracture/*.csv
    fracture.py --check           writes nothing; fails if the page differs from the data
    fracture.py --grid            first solves the grid of beams at rest on water, a minute; its own lines, not those of floes
    fracture.py --wide RECORDING  draws the cracks of the wide floe instead, docs/fracture/wide_floe.svg
"""
import math
import pathlib
import sys

import numpy as np
import pandas as pd

from page_blocks import make

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
DOCS = ROOT / "docs"
DATA = DOCS / "fracture"
E, NU, T, K, STRENGTH, CRUSHING = 60e6, 0.3, 0.033, 9810.0, 36.4e3, 145.6e3  # the tank's ice, SI
D = E * T**3 / 12 / (1 - NU**2)
LENGTH = (D / K) ** 0.25
ELEMENTS = [0.3, 0.2, 0.15, 0.1, 0.05]
PATCH = {"edge": (0.6, 0.66), "interior": (1.0, 0.92)}  # as src/ice/stress_field.cpp has it
PER_DECADE = {"edge": 4 * 0.529 * (1 + 0.54 * NU), "interior": 4 * 0.275 * (1 + NU)}


def felt(load):
    """b₀, m: of the circle that a load crushes."""
    return math.sqrt(1.6 * load / (math.pi * CRUSHING) + T * T) - 0.675 * T


def westergaard(where, b):
    """Pa for 1 N."""
    decades = math.log10(E * T**3 / (K * b**4))
    return PER_DECADE[where] / 4 / T**2 * (decades - (0.71 if where == "edge" else 0))


class Grid:
    """Square elements of side L on water, joined by the beams of docs/fracture.md; the loaded one is in the middle of the rim
    of a half plate or of a wide sheet. Motion of an element: down, and its slopes along x and z."""

    def __init__(self, side, where):
        self.side, self.where = side, where
        half = math.ceil(4 * LENGTH / side)
        self.long, self.broad = 2 * half + 1, half + 1 if where == "edge" else 2 * half + 1
        self.loaded = (half, 0 if where == "edge" else half)

    def dof(self, i, k):
        return 3 * (i + k * self.long)

    def solve(self, x, z, without=None):
        """Motion under 1 N at (x, z) from the middle of the loaded element; `without` that joint."""
        from scipy.sparse import coo_matrix
        from scipy.sparse.linalg import spsolve

        side = self.side
        shear = 12 * D / (side**2 * (1 + 12 * D / (5 / 6 * E / (2 * (1 + NU)) * T * side**2)))
        rows, columns, values = [], [], []

        def add(parts, stiffness):
            for one, share in parts:
                for other, more in parts:
                    rows.append(one), columns.append(other), values.append(stiffness * share * more)

        for k in range(self.broad):
            for i in range(self.long):
                a = self.dof(i, k)
                add([(a, 1)], K * side**2)
                add([(a + 1, 1)], K * side**4 / 12)
                add([(a + 2, 1)], K * side**4 / 12)
                for along, (b_i, b_k) in enumerate([(i + 1, k), (i, k + 1)], 1):
                    if b_i == self.long or b_k == self.broad or (i, k, along) == without:
                        continue
                    b = self.dof(b_i, b_k)
                    add([(b, 1), (b + along, -side / 2), (a, -1), (a + along, -side / 2)], shear)
                    add([(b + 1, 1), (a + 1, -1)], D)
                    add([(b + 2, 1), (a + 2, -1)], D)
        size = 3 * self.long * self.broad
        load = np.zeros(size)
        a = self.dof(*self.loaded)
        load[a], load[a + 1], load[a + 2] = 1, x, z
        return spsolve(coo_matrix((values, (rows, columns)), (size, size)).tocsc(), load)

    def moments(self, motion, i, k, along):
        """Bending and torsion of the joint behind element (i, k), N m; 0 where there is none."""
        b_i, b_k = (i + 1, k) if along == 1 else (i, k + 1)
        if i < 0 or k < 0 or b_i >= self.long or b_k >= self.broad:
            return 0.0, 0.0
        turned = motion[self.dof(b_i, b_k):][:3] - motion[self.dof(i, k):][:3]
        return -D * turned[along], -D * turned[3 - along]

    def at_joint(self, x, z):
        """Stresses at the loaded element's joint towards +x, Pa: along its normal, across it, twist; and its rotation."""
        motion = self.solve(x, z)
        i, k = self.loaded
        bending, torsion = self.moments(motion, i, k, 1)
        across = sum(self.moments(motion, column, row, 2)[0] for column in (i, i + 1) for row in (k, k - 1)) / 4
        by_moment = 6 / (self.side * T**2)
        return (by_moment * (bending + NU * across), by_moment * (across + NU * bending), by_moment * (1 - NU) * torsion,
                math.hypot(bending, torsion) / D)


def principal(along, across, twist):
    return (along + across) / 2 + math.hypot((along - across) / 2, twist)


def patches():
    """Radius b_L, over the side, with which the formula fills what the grid's joint lacks; and with the constants used,
    the stress over the formula's."""
    rows = []
    for where in PATCH:
        for side in ELEMENTS:
            grid = Grid(side, where)
            for share in [0.0, 0.25, 0.49]:
                along, across, twist, _ = grid.at_joint(share * side, -side / 2 if where == "edge" else 0.0)
                load = 10.0
                wanted = westergaard(where, felt(load))
                per_decade = PER_DECADE[where] / T**2

                def stress(patch):
                    added = per_decade * math.log10(patch * side / felt(load))
                    return principal(along + added, across + (added if where == "interior" else 0), twist)

                low, high = 1e-3, 10.0
                for _ in range(50):
                    middle = math.sqrt(low * high)
                    low, high = (middle, high) if stress(middle) < wanted else (low, middle)
                used = PATCH[where][0] * 10 ** (-PATCH[where][1] * share)
                rows.append({"where": where, "element_m": side, "towards_joint": share, "patch": low, "patch_used": used,
                             "stress_over_formula": stress(used) / wanted})
    return pd.DataFrame(rows).round(4)


def first_cracks():
    """Load of the first crack at the rim of a half plate, N, by the grid alone and with what contacts add; and how much
    further a joint turns when it is gone."""
    rows = []
    for side in ELEMENTS:
        grid = Grid(side, "edge")
        along, across, twist, turned = grid.at_joint(0.0, -side / 2)
        i, k = grid.loaded
        motion = grid.solve(0.0, -side / 2, without=(i, k, 1))
        without = math.hypot(*grid.moments(motion, i, k, 1)) / D

        def cracked(load, contact):
            added = PER_DECADE["edge"] / T**2 * math.log10(PATCH["edge"][0] * side / felt(load))
            return load * (principal(along + max(0, added), across, twist) if contact else along) / STRENGTH

        row = {"element_m": side, "turns_further": without / turned}
        for contact, name in [(False, "moment"), (True, "stress")]:
            low, high = 0.1, 200.0
            for _ in range(50):
                middle = (low + high) / 2
                low, high = (low, middle) if cracked(middle, contact) > 1 else (middle, high)
            row[name] = high
        rows.append(row)
    return pd.DataFrame(rows).round(3)


def data(name):
    return pd.read_csv(DATA / f"{name}.csv")


def patch_says():
    spans = data("patches").groupby("where").stress_over_formula.agg(["min", "max"])
    rim, inside = ("{:.2f} to {:.2f}".format(*spans.loc[where]) for where in ["edge", "interior"])
    return f"The stress is {rim} times the formula's at a rim, {inside} times inside."


def crack_says():
    rows = data("first_cracks")
    loads = {name: " to ".join(f"{rows[name].iloc[i]:.1f}" for i in (0, -1)) for name in ["moment", "stress"]}
    return (f"The first crack forms at {loads['moment']} N by moment, Eq. (3), and at {loads['stress']} N by stress, with elements of\n"
            f"{rows.element_m.max():g} to {rows.element_m.min():g} m.")


def cracks(recording):
    """Ends (x, z) of the edge of each joint that failed, as it lay at first, and when it failed, s."""
    import h5py

    with h5py.File(recording) as file:
        position, turn = file["frames/position"][0], file["frames/orientation"][0]
        corners = np.stack([file["ice/corner_x"][()], np.zeros(file["ice/corner_x"].shape), file["ice/corner_z"][()]], axis=-1)
        a, b, time = file["joints/a"][()], file["joints/b"][()], file["joints/failure_time"][()]
        failed = file["joints/failure_mode"][()] >= 0
    real, axis = turn[:, None, :1], turn[:, None, 1:]
    placed = corners + 2 * np.cross(axis, np.cross(axis, corners) + real * corners) + position[:, None, :]
    for one, other, when in zip(a[failed], b[failed], time[failed]):
        own, next_to = (corner[~np.isnan(corner[:, 0])][:, [0, 2]] for corner in (placed[one], placed[other]))
        apart = np.linalg.norm(own[:, None] - next_to[None], axis=2).min(axis=1)
        shared = own[np.argsort(apart)[:2]]
        yield shared, when


def draw_wide_floe(recording, path, until=9.0):
    """The failed joints of the wide floe as cracks, in the colours of their time."""
    import matplotlib

    matplotlib.use("svg")
    matplotlib.rcParams["svg.hashsalt"] = "floes"
    from matplotlib import pyplot

    found = [(edge, when) for edge, when in cracks(recording) if when <= until]
    first = min(when for _, when in found)
    figure, axes = pyplot.subplots(figsize=(6, 2.8), layout="constrained")
    colours = matplotlib.colormaps["viridis"]
    for edge, when in found:
        axes.plot(edge[:, 1], edge[:, 0] - 2.1, linewidth=2, color=colours((when - first) / (until - first)))
    axes.axhline(0, color="0.4", linewidth=1)
    axes.set(aspect="equal", xlim=(-1.1, 1.1), ylim=(-0.1, 0.9), xlabel="across the tow, m", ylabel="from the rim, m")
    scale = matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(first, until), colours)
    figure.colorbar(scale, ax=axes, label="failed at, s", shrink=0.8)
    figure.savefig(path, metadata={"Date": None})


def solve_grid():
    patches().to_csv(DATA / "patches.csv", index=False)
    first_cracks().to_csv(DATA / "first_cracks.csv", index=False)


if __name__ == "__main__":
    DATA.mkdir(exist_ok=True)
    if sys.argv[1:2] == ["--wide"] and len(sys.argv) == 3:
        draw_wide_floe(sys.argv[2], DATA / "wide_floe.svg")
    else:
        make({DOCS / "fracture.md": {"patches": patch_says, "first_cracks": crack_says}}, __doc__, grid=solve_grid)
