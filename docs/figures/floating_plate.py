#!/usr/bin/python3
"""Radiation of a thin rectangular plate afloat on deep water: added mass and damping of heave, roll and pitch, each at
the plate's own natural frequency. Writes src/water/floating_plate_table.inl and docs/water/floating_plate.csv.

    docs/figures/floating_plate.py --update        # some minutes of one core
    docs/figures/floating_plate.py --edgewise      # added mass of a wide sheet towed edge on, at high frequency
    docs/figures/floating_plate.py --check         # both files agree, and one entry with fewer panels; a second

A plate without draught in z = 0, x along the short side b, y along the long side l, moves with the normal velocity
v(x, y) exp(-i w t). The potential below it obeys phi_z = v on the plate and phi_z = K phi beside it, K = w^2/g. With
f = phi_z - K phi, which is zero beside the plate, phi is the sum of the sources f,

    phi(P) = int f(Q) g(P, Q) dQ,   2 pi g = 1/r - (pi K/2) (H0(K r) + Y0(K r)) + i pi K J0(K r)

(g: a pressure point on the surface of deep water, Wehausen and Laitone 1960, section 21; H0 of Struve, Y0, J0 of
Bessel), so f + K int f g = v: an equation of the second kind, solved on n panels across the short side. Then
added mass = rho Re int v phi and damping = rho w Im int v phi.
"""
import argparse
import csv
import pathlib
import sys

import numpy as np
from scipy.special import j0, struve, y0

ROOT = pathlib.Path(__file__).resolve().parents[2]
CSV = ROOT / "docs/water/floating_plate.csv"
TABLE = ROOT / "src/water/floating_plate_table.inl"
COLUMNS = ["aspect", "draught_over_b", "added_mass", "gyration_across", "gyration_along", "damping"]
ASPECTS = (1.0, 1.5, 2.0, 3.0, 5.0, 8.0)
DRAUGHTS = (0.0, 0.03, 0.06, 0.12, 0.25, 0.5)  # over the short side
PANELS = {1.0: 28, 1.5: 24, 2.0: 20, 3.0: 16, 5.0: 12, 8.0: 10}  # across the short side


class Plate:
    """Side 1 by `aspect`, `n` panels across."""

    def __init__(self, aspect, n):
        self.h = h = 1.0 / n
        self.panels = m = round(n * aspect)
        x = (np.arange(n) + 0.5) * h - 0.5
        y = (np.arange(m) + 0.5) * h - 0.5 * m * h
        x, y = (c.ravel() for c in np.meshgrid(x, y, indexing="ij"))
        self.modes = {"heave": np.ones_like(x), "across": x, "along": y}
        # What panels do to each other depends on how far apart they are in x and in y.
        row, column = np.divmod(np.arange(n * m), m)
        self.pair = np.abs(row[:, None] - row) * m + np.abs(column[:, None] - column)
        dx, dy = (c.ravel() * h for c in np.meshgrid(np.arange(n), np.arange(m), indexing="ij"))
        self.r = np.hypot(dx, dy)
        s = (np.arange(8) + 0.5) / 8 * h - h / 2
        sx, sy = (c.ravel() for c in np.meshgrid(s, s))
        self.inverse = (h * h / 64 / np.hypot(dx[:, None] + sx, dy[:, None] + sy)).sum(1)
        self.inverse[0] = 4 * h * np.arcsinh(1.0)

    def radiation(self, wave_number):
        """int v phi of each mode, for K b."""
        k, h = wave_number, self.h
        smooth = np.empty_like(self.r)
        smooth[1:] = struve(0, k * self.r[1:]) + y0(k * self.r[1:])
        mean_log = np.log(h) - 0.5 * np.log(2) + np.pi / 4 - 1.5  # of r over a square panel about its middle
        smooth[0] = 2 / np.pi * (np.log(k / 2) + np.euler_gamma + mean_log)
        g = (self.inverse + (-np.pi * k / 2 * smooth + 1j * np.pi * k * j0(k * self.r)) * h * h) / (2 * np.pi)
        modes = np.array(list(self.modes.values())).T
        phi = (modes - np.linalg.solve(np.eye(len(modes)) + k * g[self.pair], modes)) / k
        return dict(zip(self.modes, (modes * phi).sum(0) * h * h))


def natural(plate, aspect, draught, mode):
    """K b at which the plate oscillates freely, and int v phi there: stiffness rho g int v^2, mass rho d int v^2."""
    area = (plate.modes[mode] ** 2).sum() * plate.h**2
    k = 3.0
    for _ in range(60):
        phi = plate.radiation(k)[mode]
        new = area / (draught * area + phi.real)
        if abs(new - k) < 1e-4 * k:
            break
        k = 0.5 * (k + new) if abs(new - k) > 0.2 else new
    return k, phi


def row(plate, aspect, draught):
    """Heave added mass / (rho b^2 l); squared radii of gyration of the added mass in b^2 and l^2; damping of heave over
    added mass and root of g/b."""
    k, heave = natural(plate, aspect, draught, "heave")
    _, across = natural(plate, aspect, draught, "across")
    _, along = natural(plate, aspect, draught, "along")
    return (heave.real / aspect, across.real / heave.real, along.real / heave.real / aspect**2,
            np.sqrt(k) * heave.imag / heave.real)


def edgewise(half_breadth, n):
    """Sway added mass a metre over rho d^2 of a rectangle afloat, draught d = 1, at high frequency (phi = 0 on z = 0):
    sources of panels on its wetted sides and bottom, and opposite ones above the surface."""
    down = (1 - np.cos(np.linspace(0, np.pi, n + 1))) / 2
    along = -np.cos(np.linspace(0, np.pi, max(4 * n, int(4 * n * np.log(half_breadth + 2))) + 1)) * half_breadth
    corners = np.array([(-half_breadth, -y) for y in down] + [(x, -1.0) for x in along[1:]] +
                       [(half_breadth, y - 1) for y in down[1:]])
    middle, step = (corners[:-1] + corners[1:]) / 2, np.diff(corners, axis=0)
    length = np.hypot(*step.T)
    tangent = step / length[:, None]
    outward = np.stack([tangent[:, 1], -tangent[:, 0]], 1)

    def influence(start, tangent):
        normal = np.stack([-tangent[:, 1], tangent[:, 0]], 1)
        apart = middle[:, None] - start[None]
        x, y = (apart * tangent).sum(2), (apart * normal).sum(2)
        near, far = x**2 + y**2, (x - length) ** 2 + y**2
        angle = np.arctan2(y, x - length) - np.arctan2(y, x)
        u, v = np.log(near / far) / (4 * np.pi), angle / (2 * np.pi)
        potential = (x * np.log(near) - (x - length) * np.log(far) - 2 * length + 2 * y * angle) / (4 * np.pi)
        return potential, u[:, :, None] * tangent + v[:, :, None] * normal

    below, moved_below = influence(corners[:-1], tangent)
    above, moved_above = influence(corners[:-1] * [1, -1], tangent * [1, -1])
    through = ((moved_below - moved_above) * outward[:, None]).sum(2)
    np.fill_diagonal(through, 0.5 - (moved_above * outward[:, None]).sum(2).diagonal())
    sources = np.linalg.solve(through, outward[:, 0])
    return -(((below - above) @ sources) * outward[:, 0] * length).sum()


def kernel_table(rows):
    lines = ["// Made by docs/figures/floating_plate.py. A row: heave added mass / (ρ b² l), squared radii of",
             "// gyration of it along b and l over b² and l², damping of heave over added mass and √(g/b).", "",
             f"constexpr std::array<double, {len(ASPECTS)}> aspects{{{', '.join(f'{a:g}' for a in ASPECTS)}}};",
             f"constexpr std::array<double, {len(DRAUGHTS)}> draughts{{{', '.join(f'{d:g}' for d in DRAUGHTS)}}};",
             f"constexpr std::array<PlateWater, {len(rows)}> table{{{{",
             *(f"    {{{', '.join(values)}}}," for _, _, *values in rows), "}};"]
    return "\n".join(lines) + "\n"


def update():
    rows = []
    for aspect in ASPECTS:
        plate = Plate(aspect, PANELS[aspect])
        for draught in DRAUGHTS:
            rows.append([f"{aspect:g}", f"{draught:g}", *(f"{v:.4f}" for v in row(plate, aspect, draught))])
            print(*rows[-1], flush=True)
    CSV.parent.mkdir(exist_ok=True)
    with open(CSV, "w", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([COLUMNS, *rows])
    TABLE.write_text(kernel_table(rows))


def check():
    with open(CSV, newline="") as file:
        columns, *rows = csv.reader(file)
    if columns != COLUMNS or TABLE.read_text() != kernel_table(rows):
        sys.exit(f"{TABLE.name} differs from {CSV.name}; run docs/figures/floating_plate.py --update")
    stored = next(np.array(values, float) for aspect, draught, *values in rows if (aspect, draught) == ("1", "0.06"))
    coarse = np.array(row(Plate(1.0, 12), 1.0, 0.06))
    if not np.allclose(coarse, stored, rtol=0.02):
        sys.exit(f"12 panels give {coarse}, {CSV.name} has {stored}")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--update", action="store_true")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--edgewise", action="store_true")
    asked = parser.parse_args()
    if asked.edgewise:
        for half_breadth in (1, 2, 5, 10):
            print(f"breadth {2 * half_breadth:2d} d: {edgewise(half_breadth, 40):.3f} rho d^2")
    if asked.update:
        update()
    if asked.check:
        check()
