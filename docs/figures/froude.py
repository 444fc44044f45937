#!/usr/bin/python3
"""The tables of docs/froude.md, from the members in docs/froude.

Usage:
    froude.py                        writes the tables
    froude.py --check                writes nothing; fails if a table differs from the data
    froude.py --run FLOES FOLDER     first runs the campaigns with the program FLOES on one core, into FOLDER
    froude.py --collect FOLDER       first takes the members of the finished campaigns in FOLDER
    froude.py --poses FOLDER         only writes configs/validation/froude_30/*.csv anew, from tank.h5 in FOLDER
"""
import json
import math
import pathlib
import subprocess
import sys
import tomllib

import numpy as np
import pandas as pd

from page_blocks import fill_or_check
from validation_data import half_width
from validation_tables import table, with_interval

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
DOCS = ROOT / "docs"
DATA = DOCS / "froude"
TANK = ROOT / "configs" / "table3_physical.toml"
LARGE = ROOT / "configs" / "validation" / "froude_30.toml"
SCALES = [0.25, 1, 4, 16, 64, 30]  # of smoke.toml; the last is no power of 4
ARRANGEMENTS = {"smoke": 20, "tank": 4}
POWERS = {"m": 1, "s": 0.5, "m_s": 0.5, "m_s2": 0, "kPa": 1, "MPa": 1, "N": 3}  # of the scale, by the unit in a key
OF_THE_RUN = ["run", "stop"]  # tables that are not of the scene
QUANTITIES = {"mean_N": "mean load, N", "maximum_N": "maxima, every step, N", "maximum_1s_N": "maxima, 1 s, N",
              "broken_percent": "broken floes, %"}


def scaled(key, value, scale):
    if isinstance(value, dict):
        return {name: scaled(name, inner, scale) for name, inner in value.items()}
    if isinstance(value, list):
        return [scaled(key, inner, scale) for inner in value]
    units = [unit for unit in POWERS if key.endswith(f"_{unit}")]
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


def write_poses(folder):
    target = LARGE.with_suffix("")
    target.mkdir(exist_ok=True)
    for i, rows in enumerate(poses(folder / "tank.h5", 30)):
        text = "x_m,z_m,yaw_deg\n" + "".join(",".join(map(repr, row)) + "\n" for row in rows)
        (target / f"arrangement_{i}.csv").write_text(text)


def floes(program, folder, config, name):
    subprocess.run([program, "run", config, "--output", folder / f"{name}.h5", "--threads", "1", "--overwrite"], check=True)


def run_smoke(program, folder):
    """Draws the arrangements once, then gives them, scaled, to the members of every scale."""
    config = resolved(program, ROOT / "configs" / "smoke.toml")
    config["campaign"]["arrangements"] = ARRANGEMENTS["smoke"]
    drawn = folder / "smoke_drawn.toml"
    drawn.write_text(toml(config))
    floes(program, folder, drawn, "smoke_drawn")
    config["campaign"]["arrangements"] = 1
    config["arrangement"]["method"] = "file"
    for scale in SCALES:
        large = {name: inner if name in OF_THE_RUN else scaled(name, inner, scale) for name, inner in config.items()}
        large["case"] = [{**case, "name": f"{case['name']}-{i}", "arrangement.poses": rows}
                         for case in large["case"] for i, rows in enumerate(poses(folder / "smoke_drawn.h5", scale))]
        path = folder / f"smoke_{scale:g}.toml"
        path.write_text(toml(large))
        floes(program, folder, path, f"smoke_{scale:g}")


def run_tank(program, folder):
    config = resolved(program, TANK)
    config["campaign"]["arrangements"] = ARRANGEMENTS["tank"]
    config["case"] = [case for case in config["case"] if case["name"] == "E60"]
    path = folder / "tank.toml"
    path.write_text(toml(config))
    floes(program, folder, path, "tank")
    check_large(resolved(program, LARGE), scaled("", config, 30))
    floes(program, folder, LARGE, "tank_30")


def check_large(found, expected):
    """Every number of the committed configuration must be that of the tank, scaled."""
    for name in set(expected) - {"campaign", "case", *OF_THE_RUN}:
        for key in set(expected[name]) - {"method", "poses"}:
            value = expected[name][key]
            same = found[name][key] == value or np.allclose(found[name][key], value, rtol=1e-12, atol=0)
            if not same:
                sys.exit(f"{LARGE}: {name}.{key} is {found[name][key]}, but scaled it is {value}")


def collected(path, scene, scale):
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
                "scene": scene, "scale": scale, "case": case,
                "arrangement": int(arrangement or file["arrangements/number"][file["members/arrangement"][i]]),
                "set_aside": int(status != 0), "mean_N": file["members/mean_load"][i],
                "maximum_N": file["members/mean_maximum"][i],
                "maximum_1s_N": file["averaged/mean_maximum"][i][second],
                "broken_percent": 100 * file["members/failure_ratio"][i]})
    return rows


def collect(folder):
    rows = [row for scale in SCALES for row in collected(folder / f"smoke_{scale:g}.h5", "smoke", scale)]
    rows += collected(folder / "tank.h5", "tank", 1) + collected(folder / "tank_30.h5", "tank", 30)
    pd.DataFrame(rows).to_csv(DATA / "members.csv", index=False)


def members(scene, scale):
    """Of one scale, loads scaled back."""
    data = pd.read_csv(DATA / "members.csv", float_precision="round_trip")
    own = data[(data.scene == scene) & (data.scale == scale)].set_index(["case", "arrangement"]).sort_index()
    return own.assign(**{name: own[name] / scale**3 for name in QUANTITIES if name.endswith("_N")})


def scales(scene, shown):
    rows = []
    for scale in shown:
        own = members(scene, scale)
        rows.append([f"{scale:g}", f"{own.set_aside.sum()} of {len(own)}"]
                    + [with_interval(own[name].dropna()) for name in QUANTITIES])
    return table(["scale", "set aside", *QUANTITIES.values()], rows)


def differences(scene, scale):
    """Mean over the same arrangements of scale and 1, as a ratio with its 95 % interval (delta method)."""
    large, one = members(scene, scale), members(scene, 1)
    row = []
    for name in QUANTITIES:
        r = large[name].mean() / one[name].mean()
        row.append(f"{r:.3f} ± {half_width(large[name] - r * one[name]) / one[name].mean():.3f}")
    return row


def ratios():
    rows = [["`smoke.toml`", "30", f"{len(members('smoke', 30))}", *differences("smoke", 30)],
            ["`table3_physical.toml`, 60 MPa", "30", f"{len(members('tank', 30))}", *differences("tank", 30)]]
    return table(["scene", "scale", "members", *[words.replace(", N", "").replace(", %", "")
                                                for words in QUANTITIES.values()]], rows)


def equal():
    """In words: how far members of the scales that are powers of 4 are from their twins."""
    one = members("smoke", 1)
    names = list(QUANTITIES)
    worst = max(float((members("smoke", scale)[names] / one[names] - 1).abs().max().max())
                for scale in SCALES if math.log(scale, 4).is_integer() and scale != 1)
    return (f"Largest relative difference of a member's mean load, maxima or broken floes from its twin's at scale 1, at\n"
            f"scales that are powers of 4: {worst:.1g}.")


BLOCKS = {"smoke": lambda: scales("smoke", SCALES), "equal": equal, "tank": lambda: scales("tank", [1, 30]),
          "ratios": ratios}


def main():
    options = sys.argv[1:]
    if options[:1] == ["--poses"]:
        return write_poses(pathlib.Path(options[1]))
    if options[:1] == ["--run"]:
        program, folder = pathlib.Path(options[1]).resolve(), pathlib.Path(options[2])
        run_smoke(program, folder)
        run_tank(program, folder)
        collect(folder)
    if options[:1] == ["--collect"]:
        collect(pathlib.Path(options[1]))
    fill_or_check({DOCS / "froude.md": BLOCKS}, "--check" in options, "froude.py")


if __name__ == "__main__":
    main()
