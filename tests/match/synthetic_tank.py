#!/usr/bin/python3
"""synthetic_tank.py FLOES CONFIG: tank tests made by floes itself from hidden inputs. Matching must not rule the hidden
inputs out, must rule others out, and must see a contradiction.

The measurement is one arrangement that the design does not have, as a tank test is.
"""

import json
import pathlib
import subprocess
import sys
import tempfile

import h5py

AXES = {"structure.keel_radius_m": (0.25, 0.50), "contact.ice_ice_friction": (0.05, 0.6)}
HIDDEN = [(0.30, 0.15), (0.33, 0.50), (0.38, 0.30), (0.44, 0.10), (0.46, 0.45), (0.41, 0.55)]
QUANTITIES = {"mean_load": 1, "sd_load": 1, "mean_maximum": 1, "failure_ratio": 100}


def axes_text(of):
    return "".join(f'\n[[design.axis]]\nkey = "{key}"\n{of(k, *ends)}\n' for k, (key, ends) in enumerate(AXES.items()))


def targets_text(values, runs=1):
    return "".join(f'[[target]]\nquantity = "{name}"\nvalue = {value}\nruns = {runs}\ndiscrepancy_percent = 2.0\n'
                   for name, value in values.items())


def main(floes, config):
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        base = pathlib.Path(config).read_text()
        base = base[:base.index("[[case]]")]

        def run(name, text, seed, arrangements):
            path = folder / f"{name}.toml"
            path.write_text(base + text)
            subprocess.run([floes, "run", path, "-o", path.with_suffix(".h5"), "--set", f"campaign.seed={seed}", "--set",
                            f"campaign.arrangements={arrangements}"], check=True, capture_output=True)
            return path.with_suffix(".h5")

        wave = run("wave", '[design]\nmethod = "sobol"\npoints = 24\n' +
                   axes_text(lambda k, low, high: f"from = {low}\nto = {high}"), 1, 4)
        tank = run("tank", '[design]\nmethod = "list"\n' +
                   axes_text(lambda k, low, high: f"values = {[point[k] for point in HIDDEN]}"), 77, 1)
        with h5py.File(tank) as file:
            measured = [{name: factor * float(file["members"][name][k]) for name, factor in QUANTITIES.items()}
                        for k in range(len(HIDDEN))]

        def match(text, *options):
            path = folder / "targets.toml"
            path.write_text(text)
            out = subprocess.run([floes, "match", wave, "--targets", path, "--format", "json", "--samples", "1024",
                                  *options], check=True, capture_output=True, text=True).stdout
            return json.loads(out)["match"]

        kept, shares = 0, []
        for point, values in zip(HIDDEN, measured):
            at = [word for key, value in zip(AXES, point) for word in ("--at", f"{key}={value}")]
            found = match(targets_text(values), *at)
            worst = max(target["implausibility"] for target in found["point"])
            kept += worst <= 3
            shares.append(found["left"])
            print(f"{point}: {found['left']:.2f} left, implausibility of the truth {worst:.2f}")
        if kept < len(HIDDEN) - 1:
            sys.exit(f"{len(HIDDEN) - kept} of {len(HIDDEN)} hidden inputs are ruled out")
        if sum(shares) / len(shares) > 0.8:
            sys.exit(f"little is ruled out: {shares} are left")
        both = [max(values["mean_load"] for values in measured), min(values["sd_load"] for values in measured) / 2]
        contradiction = match(targets_text(dict(zip(("mean_load", "sd_load"), both)), runs=100))
        print(f"mean {both[0]:.1f} N with SD {both[1]:.1f} N: {contradiction['left']:.2f} left")
        if contradiction["left"] != 0:
            sys.exit("a contradiction leaves something")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
