#!/usr/bin/python3
"""The table of docs/matching.md and its picture, from the summaries in docs/matching.

Usage:
    matching.py                     writes the table
    matching.py --check             writes nothing; fails if the page differs from the data
    matching.py --collect FOLDER [FLOES]
                                    first matches channel.h5, wave2.h5 (which it runs if it is not there) and physical.h5 of
                                    FOLDER with the program FLOES, and takes the picture (needs chromium)
"""
import json
import pathlib
import subprocess
import tempfile

from page_blocks import make
from told import said
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
TRUTH = {"structure.keel_radius_m": 0.43, "contact.ice_structure_friction": 0.2}  # behind the targets of the channel


def told(name):
    return json.loads((DATA / f"{name}.json").read_text())["match"]


def collect(folder, floes=ROOT / "floes"):
    folder = pathlib.Path(folder)
    DATA.mkdir(exist_ok=True)
    if not (folder / "wave2.h5").exists():
        wave = folder / "wave2.toml"
        subprocess.run([floes, "match", folder / "channel.h5", "--targets", ROOT / "configs/targets_channel.toml", "--next",
                        wave, "--points", "12"], check=True, stdout=subprocess.DEVNULL)
        subprocess.run([floes, "run", wave, "-o", folder / "wave2.h5"], check=True)
    with tempfile.TemporaryDirectory() as temporary:
        page = pathlib.Path(temporary) / "match.html"
        for name, (_, campaigns, targets) in MATCHINGS.items():
            command = [floes, "match", *[folder / f"{one}.h5" for one in campaigns], "--targets",
                       ROOT / f"configs/targets_{targets}.toml", "--format", "json", "--exposure-h", "3", "-o", page]
            if targets != "tank":
                command += [word for key, value in TRUTH.items() for word in ("--at", f"{key}={value}")]
            (DATA / f"{name}.json").write_text(said(*command))
            if name == "ten_runs":
                picture(page, DATA / "pairs.png")


def left():
    shares = {name: f"{100 * told(name)['left']:.0f} %" for name in MATCHINGS}
    return (f"Not ruled out are {shares['one_run']} of the ranges by one run, {shares['one_run_two_waves']} after two waves, and "
            f"{shares['ten_runs']} by the mean of ten\nruns; by the tank test of the next section {shares['tank']}.")


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


if __name__ == "__main__":
    make({PAGE: {"left": left, "design": design}}, __doc__, collect=collect)
