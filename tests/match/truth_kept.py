#!/usr/bin/python3
"""truth_kept.py FLOES CONFIG [FOLDER]: how often matching rules out the inputs behind a tank test made by floes itself. Ten
hidden combinations, ten tanks each (arrangements of their own), from waves of other floes. At most 2 % may be ruled out.

FOLDER keeps the campaigns, so that matching can be tried again on the same.
"""

import json
import pathlib
import subprocess
import sys
import tempfile

import h5py

from synthetic_tank import AXES, QUANTITIES, axes_text, targets_text

HIDDEN = [(0.26, 0.10), (0.30, 0.15), (0.33, 0.50), (0.35, 0.25), (0.38, 0.30), (0.41, 0.55), (0.42, 0.20), (0.44, 0.10),
          (0.46, 0.45), (0.49, 0.35)]
TANKS, POINTS, ARRANGEMENTS, WAVES = 10, 24, 4, (1, 2, 3, 4)
MOST_RULED_OUT = 0.02


def main(floes, config, folder):
    base = pathlib.Path(config).read_text()
    base = base[:base.index("[[case]]")]

    def run(name, text, seed, arrangements):
        path = folder / f"{name}.toml"
        path.write_text(base + text)
        subprocess.run([floes, "run", path, "-o", path.with_suffix(".h5"), "--resume", "--set", f"campaign.seed={seed}",
                        "--set", f"campaign.arrangements={arrangements}"], check=True, capture_output=True)
        return path.with_suffix(".h5")

    tank = run("tanks", '[design]\nmethod = "list"\n' +
               axes_text(lambda k, low, high: f"values = {[point[k] for point in HIDDEN]}"), 77, TANKS)
    with h5py.File(tank) as file:
        members = file["members"]
        measured = [(HIDDEN[members["case"][k]], {name: factor * float(members[name][k])
                                                  for name, factor in QUANTITIES.items()})
                    for k in range(len(members["case"]))]
    shares = []
    for seed in WAVES:
        wave = run(f"wave{seed}", '[design]\nmethod = "sobol"\npoints = %d\n' % POINTS +
                   axes_text(lambda k, low, high: f"from = {low}\nto = {high}"), seed, ARRANGEMENTS)
        ruled_out, left = [], []
        for point, values in measured:
            targets = folder / "targets.toml"
            targets.write_text(targets_text(values))
            at = [word for key, value in zip(AXES, point) for word in ("--at", f"{key}={value}")]
            out = subprocess.run([floes, "match", wave, "--targets", targets, "--format", "json", "--samples", "256", *at],
                                 check=True, capture_output=True, text=True).stdout
            found = json.loads(out)["match"]
            worst = max(target["implausibility"] for target in found["point"])
            ruled_out.append(worst > 3)
            left.append(found["left"])
        shares.append(sum(ruled_out) / len(ruled_out))
        print(f"wave {seed}: {100 * shares[-1]:.0f} % of {len(ruled_out)} tanks rule out their truth; "
              f"{100 * sum(left) / len(left):.0f} % of the ranges are left", flush=True)
    mean = sum(shares) / len(shares)
    if mean > MOST_RULED_OUT:
        sys.exit(f"{100 * mean:.1f} % of the truths are ruled out")
    if sum(left) / len(left) > 0.8:
        sys.exit("little is ruled out")


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    if len(sys.argv) == 4:
        pathlib.Path(sys.argv[3]).mkdir(exist_ok=True)
        main(sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3]))
    else:
        with tempfile.TemporaryDirectory() as made:
            main(sys.argv[1], sys.argv[2], pathlib.Path(made))
