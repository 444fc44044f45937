#!/usr/bin/python3
"""The tables of docs/validation.md, from the members in docs/froude.

Usage:
    froude.py                        writes the tables
    froude.py --check                writes nothing; fails if a table differs from the data
    froude.py --run FLOES FOLDER     first runs the campaigns with the program FLOES on one core, into FOLDER
    froude.py --collect FOLDER       first takes the members of the finished campaigns in FOLDER
"""
import json
import math
import pathlib
import subprocess
import tomllib

import numpy as np
import pandas as pd

from page_blocks import make
from validation_data import half_width

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
DOCS = ROOT / "docs"
DATA = DOCS / "froude"
SCENE = ROOT / "configs" / "smoke.toml"
SCALES = [1, 16, 30]  # the last is no power of 4
ARRANGEMENTS = 20
POWERS = {"m": 1, "s": 0.5, "m_s": 0.5, "m_s2": 0, "kPa": 1, "MPa": 1, "N": 3}  # of the scale, by the unit in a key
OF_THE_RUN = ["run", "stop"]  # tables that are not of the scene
BY_ITSELF = ["tolerance_mm_s"]  # goes with the ice's thickness without being told
QUANTITIES = {"mean_N": "mean load", "maximum_1s_N": "maxima over 1 s", "broken_percent": "broken floes"}


def scaled(key, value, scale):
    if isinstance(value, dict):
        return {name: scaled(name, inner, scale) for name, inner in value.items()}
    if isinstance(value, list):
        return [scaled(key, inner, scale) for inner in value]
    units = [unit for unit in POWERS if key.endswith(f"_{unit}") and key not in BY_ITSELF]
    return value * math.sqrt(scale) ** (2 * POWERS[max(units, key=len)]) if units else value


def toml(config):
    """Tables, and cases with dotted keys."""
    lines = []
    for name, inner in config.items():
        for one in inner if isinstance(inner, list) else [inner]:
            lines.append(f"\n[[{name}]]" if isinstance(inner, list) else f"\n[{name}]")
            for key, value in one.items():
                parts = {f"{key}.{k}": v for k, v in value.items()} if isinstance(value, dict) else {key: value}
                lines += [f"{k} = {json.dumps(v)}" for k, v in parts.items()]
    return "\n".join(lines) + "\n"


def resolved(program, path):
    run = subprocess.run([program, "config", "--resolved", path], capture_output=True, text=True, check=True)
    return tomllib.loads(run.stdout)


def poses(path, scale):
    """Of each arrangement of a campaign file: rows of x_m, z_m, yaw_deg."""
    import h5py  # which --check does not need

    with h5py.File(path) as file:
        return [[[x * scale, z * scale, math.degrees(yaw)] for x, z, yaw in rows.tolist()]
                for rows in file["arrangements/pose"][:]]


def floes(program, folder, config, name):
    subprocess.run([program, "run", config, "--output", folder / f"{name}.h5", "--threads", "1", "--overwrite"], check=True)


def run(program, folder):
    """Draws the arrangements once, then gives them, scaled, to the members of every scale."""
    program, folder = pathlib.Path(program).resolve(), pathlib.Path(folder)
    config = resolved(program, SCENE)
    config["campaign"]["arrangements"] = ARRANGEMENTS
    drawn = folder / "drawn.toml"
    drawn.write_text(toml(config | {"case": config["case"][:1]}))
    floes(program, folder, drawn, "drawn")
    config["campaign"]["arrangements"] = 1
    config["arrangement"]["method"] = "file"
    for scale in SCALES:
        large = {name: inner if name in OF_THE_RUN else scaled(name, inner, scale) for name, inner in config.items()}
        large["case"] = [{**case, "name": f"{case['name']}-{i}", "arrangement.poses": rows}
                         for case in large["case"] for i, rows in enumerate(poses(folder / "drawn.h5", scale))]
        path = folder / f"scale_{scale:g}.toml"
        path.write_text(toml(large))
        floes(program, folder, path, f"scale_{scale:g}")
    collect(folder)


def collected(path, scale):
    """One row for each member of a campaign file; loads of the scale, those set aside without numbers."""
    import h5py

    with h5py.File(path) as file:
        rows = []
        of_case = file["members/case"][:]
        names = file["cases/name"].asstr()[:]
        second = int(np.argmin(abs(file["averaging_time"][:] / math.sqrt(scale) - 1)))
        for i, status in enumerate(file["members/status"][:]):
            case, _, arrangement = names[of_case[i]].partition("-")
            rows.append({
                "scale": scale, "case": case, "arrangement": int(arrangement),
                "set_aside": int(status != 0), "mean_N": file["members/mean_load"][i],
                "maximum_N": file["members/mean_maximum"][i],
                "maximum_1s_N": file["averaged/mean_maximum"][i][second],
                "broken_percent": 100 * file["members/failure_ratio"][i],
                "cpu_s": file["provenance/cpu_time"][i]})
    return rows


def collect(folder):
    rows = [row for scale in SCALES for row in collected(pathlib.Path(folder) / f"scale_{scale:g}.h5", scale)]
    pd.DataFrame(rows).to_csv(DATA / "members.csv", index=False)


def members(scale):
    """Of one scale, loads scaled back."""
    data = pd.read_csv(DATA / "members.csv", float_precision="round_trip")
    own = data[data.scale == scale].set_index(["case", "arrangement"]).sort_index()
    return own.assign(**{name: own[name] / scale**3 for name in QUANTITIES if name.endswith("_N")})


def ratio(scale, name):
    """Mean over the same arrangements of scale and 1, as a ratio with its 95 % interval (delta method), of arrangements: the
    moduli of one are not independent."""
    large, one = members(scale)[name], members(1)[name]
    r = large.mean() / one.mean()
    return f"{r:.3f} ± {half_width((large - r * one).groupby('arrangement').mean()) / one.mean():.3f}"


def scales():
    """Of the scale that is no power of 4, in words."""
    last = SCALES[-1]
    return f"At scale {last:g}: " + ", ".join(f"{words} {ratio(last, name)}" for name, words in QUANTITIES.items()) + "."


def equal():
    """In words: how far members of the scales that are powers of 4 are from their twins."""
    one, names = members(1), list(QUANTITIES)
    others = [members(scale) for scale in SCALES if math.log(scale, 4).is_integer() and scale != 1]
    worst = max(float((other[names] - one[names]).abs().max().max()) for other in others)
    aside, count = (sum(how(members(scale)) for scale in SCALES) for how in (lambda own: own.set_aside.sum(), len))
    minutes = sum(members(scale).cpu_s.sum() for scale in SCALES) / 60
    return (f"{count} members, {minutes:.0f} minutes of one core, {aside} set aside. Largest difference of any figure of a "
            f"member at scale 16 from\nits twin's at scale 1: {worst:.1g}.")


if __name__ == "__main__":
    make({DOCS / "validation.md": {"scales": scales, "equal": equal}}, __doc__, run=run, collect=collect)
