#!/usr/bin/python3
"""The tables of docs/matching.md and its picture, from the summaries in docs/matching.

Usage:
    matching.py                     writes the tables
    matching.py --check             writes nothing; fails if the page differs from the data
    matching.py --collect FOLDER [FLOES]
                                    first matches channel.h5, wave2.h5 and physical.h5 of FOLDER with the program FLOES,
                                    and takes the pictures (needs chromium)
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import tomllib

from page_blocks import fill_or_check
from validation_tables import table

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
DATA = ROOT / "docs/matching"
PAGE = ROOT / "docs/matching.md"
# Name of a matching: what the page calls it, campaigns, targets.
MATCHINGS = {
    "one_run": ("one run, first wave", ["channel"], "channel"),
    "one_run_two_waves": ("one run, two waves", ["channel", "wave2"], "channel"),
    "ten_runs": ("mean of ten runs, two waves", ["channel", "wave2"], "channel_ten"),
    "tank": ("the tank test", ["physical"], "tank"),
}
PICTURES = {"ten_runs": "pairs.png", "tank": "tank_pairs.png"}
# Of the tank test: what is not known of the largest load, and what a further measurement would say, each beside a record
# that was averaged over 1 s. Name of a reading: what the page calls it, averaging time, change of each target, and what
# else would be measured, as it is expected.
READINGS = {
    "single": ("single steps of 0.02 s", "", {}, None),
    "0.1": ("0.1 s", "_0.1s", {}, None),
    "0.5": ("0.5 s", "_0.5s", {}, None),
    "1": ("1 s", "_1s", {}, None),
    "2": ("2 s", "_2s", {}, None),
    "open_water": ("whether open water is in the 38.8 N", "_1s", {"uncertainty": 0.03}, None),
    "heave": ("the mean heave load", "_1s", {}, "mean_heave"),
    "spectrum": ("the SD over 1 s", "_1s", {}, "sd_load_1s"),
    "ten": ("all of it in ten runs", "_1s", {"runs": 10}, None),
}
TRUTH = {"structure.keel_radius_m": 0.43, "contact.ice_structure_friction": 0.2}  # behind the targets of the channel


def told(name):
    return json.loads((DATA / f"{name}.json").read_text())["match"]


def collect(folder, floes):
    DATA.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as temporary:
        page = pathlib.Path(temporary) / "match.html"
        for name, (_, campaigns, targets) in MATCHINGS.items():
            command = [floes, "match", *[folder / f"{one}.h5" for one in campaigns], "--targets",
                       ROOT / f"configs/targets_{targets}.toml", "--format", "json", "--exposure-h", "3", "-o", page]
            if targets != "tank":
                command += [word for key, value in TRUTH.items() for word in ("--at", f"{key}={value}")]
            done = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True)
            (DATA / f"{name}.json").write_text(done.stdout)
            if name in PICTURES:
                picture(page, DATA / PICTURES[name])
    collect_readings(folder, floes)


def matched(floes, campaign, targets, *more):
    with tempfile.NamedTemporaryFile("w", suffix=".toml") as file:
        for target in targets:
            file.write("[[target]]\n" + "".join(f"{key} = {json.dumps(value)}\n" for key, value in target.items()))
        file.flush()
        command = [floes, "match", campaign, "--targets", file.name, "--format", "json", *more]
        return json.loads(subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout)["match"]


def collect_readings(folder, floes):
    """Each target may be off by 10 % of what is measured, the share of cracked floes by its own discrepancy."""
    mean, largest, cracked = tomllib.loads((ROOT / "configs/targets_tank.toml").read_text())["target"]
    campaign = folder / "physical.h5"
    found = {}
    for name, (_, averaging, changes, measured) in READINGS.items():
        own = {"quantity": f"maximum_load{averaging}", "discrepancy_percent": mean["discrepancy_percent"]}
        targets = [mean | changes, largest | own | changes, cracked | changes]
        if measured:
            [expected] = matched(floes, campaign, targets, "--predict", f"E60:{measured}")["predicted"]
            targets.append(mean | {"quantity": measured, "value": expected["weighted"], "uncertainty": 0.0})
        found[name] = matched(floes, campaign, targets)
    (DATA / "tank_readings.json").write_text(json.dumps(found, indent=1) + "\n")


def percent(share):
    return f"{100 * share:.0f}" if share >= 0.1 else f"{100 * share:.1f}"


def left():
    rows = []
    for name, (words, _, _) in MATCHINGS.items():
        found = told(name)
        truth = max((target["implausibility"] for target in found.get("point", [])), default=None)
        rows.append([words, f"{percent(found['left'])} %", "–" if truth is None else f"{truth:.1f}"])
    return table(["measured", "not ruled out", "implausibility of the truth"], rows)


def readings():
    found = json.loads((DATA / "tank_readings.json").read_text())
    rows = []
    for name, one in found.items():
        mean, largest, _ = one["targets"][:3]
        rows.append([READINGS[name][0], *(f"{percent(share)} %" for share in
                                          (one["left"], mean["rules_out"], largest["rules_out"]))])
    return table(["record averaged over; 1 s, and if one knew", "not ruled out", "mean rules out", "largest load"], rows)


def design():
    rows = []
    for name, (words, _, targets) in MATCHINGS.items():
        for one in told(name)["design_load"] if targets != "tank" else []:
            rows.append([words, *(f"{one[key]:.0f} [{one[f'{key}_low']:.0f}, {one[f'{key}_high']:.0f}]"
                                  for key in ("expected", "quantile_load"))])
    return table(["measured", "expected, N", "with 10 % exceedance probability, N"], rows)


def picture(page, png):
    """The pairs of inputs, cut out of the page."""
    text = page.read_text()
    begin = text.index("<h2>What is left, for each pair")
    figure = text[text.index("<svg", begin):text.index("</svg>", begin) + len("</svg>")]
    style = text[text.index("<style>"):text.index("</style>") + len("</style>")]
    page.write_text(f"<!doctype html><meta charset=utf-8>{style}<body style='margin:8px;max-width:none'>{figure}")
    width, height = (16 + round(float(size)) for size in figure.split('viewBox="0 0 ')[1].split('"')[0].split())
    subprocess.run(["chromium", "--headless", "--no-sandbox", "--hide-scrollbars", f"--window-size={width},{height}",
                    f"--screenshot={png}", page.as_uri()], check=True, capture_output=True)


BLOCKS = {"left": left, "design": design, "readings": readings}


def main(arguments):
    if arguments[:1] == ["--collect"] and len(arguments) in (2, 3):
        collect(pathlib.Path(arguments[1]), arguments[2] if len(arguments) == 3 else ROOT / "floes")
    elif arguments not in ([], ["--check"]):
        sys.exit(__doc__)
    fill_or_check({PAGE: BLOCKS}, arguments == ["--check"], "matching.py")


if __name__ == "__main__":
    main(sys.argv[1:])
