#!/usr/bin/python3
"""The tables of docs/matching.md and its picture, from the summaries in docs/matching.

Usage:
    matching.py                     writes the tables
    matching.py --check             writes nothing; fails if the page differs from the data
    matching.py --collect CAMPAIGN [FLOES]
                                    first matches the campaign of configs/matching/physical.toml with the program FLOES,
                                    and takes the picture (needs chromium)
"""
import json
import pathlib
import subprocess
import sys
import tempfile

from page_blocks import fill_or_check
from validation_tables import table

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
DATA = ROOT / "docs/matching"
PAGE = ROOT / "docs/matching.md"
# Name of a matching: of how many runs the targets are taken for the mean.
MATCHINGS = {"tank": 1, "tank_of_ten": 10}
LABELS = {"mean_load": "mean load", "maximum_load": "largest load", "failure_ratio": "broken floes"}


def told(name):
    return json.loads((DATA / f"{name}.json").read_text())["match"]


def collect(campaign, floes):
    DATA.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as temporary:
        temporary = pathlib.Path(temporary)
        text = (ROOT / "configs/targets_tank.toml").read_text()
        for name, runs in MATCHINGS.items():
            (temporary / "targets.toml").write_text(text.replace("uncertainty =", f"runs = {runs}\nuncertainty ="))
            done = subprocess.run([floes, "match", campaign, "--targets", temporary / "targets.toml", "--format", "json",
                                   "--exposure-h", "3", "-o", temporary / f"{name}.html"],
                                  check=True, stdout=subprocess.PIPE, text=True)
            (DATA / f"{name}.json").write_text(done.stdout)
        picture(temporary / "tank.html")


def words(name):
    runs = MATCHINGS[name]
    return "the tank test" + (f", if it were the mean of {runs} runs" if runs > 1 else "")


def percent(share):
    return f"{100 * share:.0f}" if share >= 0.1 else f"{100 * share:.1f}"


def left():
    rows = []
    for name in MATCHINGS:
        found = told(name)
        used = [target for target in found["targets"] if not target["unused"]]
        most = sorted(used, key=lambda target: -target["rules_out"])
        rows.append([words(name), f"{percent(found['left'])} %", f"{found['best_implausibility']:.1f}",
                     "; ".join(f"{LABELS[target['quantity']]} {percent(target['rules_out'])} %"
                               f" ({percent(target['alone'])})" for target in most if target["rules_out"] > 0)])
    return table(["targets", "not ruled out", "best point's implausibility", "what each rules out (alone)"], rows)


def design():
    rows = []
    for name in MATCHINGS:
        for one in told(name)["design_load"]:
            cells = [f"{one[key]:.0f} [{one[f'{key}_low']:.0f}, {one[f'{key}_high']:.0f}]"
                     for key in ("expected", "quantile_load", "quantile_load_weighted")]
            growth = (f"{one['growth_quantile']:.2f} [{one['growth_quantile_low']:.2f}, "
                      f"{one['growth_quantile_high']:.2f}]")
            rows.append([words(name), *cells, growth])
    return table(["targets", "expected, N", "with 10 % exceedance probability, N", "the same, weighed", "its growth"], rows)


def picture(page):
    """The pairs of inputs, cut out of the page."""
    text = page.read_text()
    begin = text.index("<h2>What is left, for each pair")
    figure = text[text.index("<svg", begin):text.index("</svg>", begin) + len("</svg>")]
    style = text[text.index("<style>"):text.index("</style>") + len("</style>")]
    page.write_text(f"<!doctype html><meta charset=utf-8>{style}<body style='margin:8px;max-width:none'>{figure}")
    width, height = (16 + round(float(size)) for size in figure.split('viewBox="0 0 ')[1].split('"')[0].split())
    subprocess.run(["chromium", "--headless", "--no-sandbox", "--hide-scrollbars", f"--window-size={width},{height}",
                    f"--screenshot={DATA / 'pairs.png'}", page.as_uri()], check=True, capture_output=True)


BLOCKS = {"left": left, "design": design}


def main(arguments):
    if arguments[:1] == ["--collect"] and len(arguments) in (2, 3):
        collect(pathlib.Path(arguments[1]), arguments[2] if len(arguments) == 3 else ROOT / "floes")
    elif arguments not in ([], ["--check"]):
        sys.exit(__doc__)
    fill_or_check({PAGE: BLOCKS}, arguments == ["--check"], "matching.py")


if __name__ == "__main__":
    main(sys.argv[1:])
