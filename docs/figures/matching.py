#!/usr/bin/python3
"""The tables of docs/matching.md and its picture, from the summaries in docs/matching.

Usage:
    matching.py                     writes the tables
    matching.py --check             writes nothing; fails if the page differs from the data
    matching.py --collect FOLDER [FLOES]
                                    first matches the finished campaigns of FOLDER with the program FLOES: physical.h5,
                                    physical_2.h5 and paper.h5; and takes the picture (needs chromium)
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
# Name of a matching: contacts, files, targets, and of how many runs these are taken for the mean.
MATCHINGS = {
    "physical_tank": ("physical", ["physical", "physical_2"], "tank", 1),
    "physical_tank_of_ten": ("physical", ["physical", "physical_2"], "tank", 10),
    "physical_table3": ("physical", ["physical", "physical_2"], "table3", 1),
    "paper_table3": ("paper's", ["paper"], "table3", 1),
}
TARGETS = {"tank": "the tank test", "table3": "Table 3 at 60 MPa"}
HELD_OUT = ["mean_load", "sd_load", "mean_maximum", "sd_maximum", "maximum_load", "failure_ratio"]
LABELS = {"mean_load": "mean load, N", "sd_load": "SD, N", "mean_maximum": "mean of the maxima, N",
          "sd_maximum": "SD of the maxima, N", "maximum_load": "largest load, N", "failure_ratio": "broken floes, %"}


def told(name):
    return json.loads((DATA / f"{name}.json").read_text())["match"]


def there():
    return [name for name in MATCHINGS if (DATA / f"{name}.json").exists()]


def collect(folder, floes):
    DATA.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as temporary:
        temporary = pathlib.Path(temporary)
        for name, (_, files, targets, runs) in MATCHINGS.items():
            campaigns = [folder / f"{file}.h5" for file in files if (folder / f"{file}.h5").exists()]
            if not campaigns:
                continue
            text = (ROOT / f"configs/targets_{targets}.toml").read_text()
            (temporary / "targets.toml").write_text(text.replace("uncertainty =", f"runs = {runs}\nuncertainty ="))
            command = [floes, "match", *campaigns, "--targets", temporary / "targets.toml", "--format", "json"]
            if targets == "tank":
                command += ["--exposure-h", "3", "-o", temporary / "match.html"]
            if name == "physical_table3" and len(campaigns) > 1:
                command += [word for case in ("E30", "E200") for one in HELD_OUT
                            for word in ("--predict", f"{case}:{one}")]
            done = subprocess.run(command, stdout=subprocess.PIPE, text=True)
            if done.returncode != 0:
                sys.exit(f"{name} cannot be matched")
            (DATA / f"{name}.json").write_text(done.stdout)
            if name == "physical_tank":
                picture(temporary / "match.html")
    for name in {file for _, files, _, _ in MATCHINGS.values() for file in files}:
        if (folder / f"{name}.h5").exists():
            rows = subprocess.run([floes, "summarize", folder / f"{name}.h5", "--parts", "members", "--format", "csv"],
                                  check=True, stdout=subprocess.PIPE, text=True).stdout
            (DATA / f"{name}.members.csv").write_text(rows)


def words(name):
    contacts, _, targets, runs = MATCHINGS[name]
    return [contacts, TARGETS[targets] + (f", if it were the mean of {runs} runs" if runs > 1 else "")]


def percent(share):
    return f"{100 * share:.0f}" if share >= 0.1 else f"{100 * share:.1f}"


def left():
    rows = []
    for name in there():
        found = told(name)
        used = [target for target in found["targets"] if not target["unused"]]
        most = sorted(used, key=lambda target: -target["rules_out"])
        rows.append([*words(name), f"{percent(found['left'])} %", f"{found['best_implausibility']:.1f}",
                     "; ".join(f"{LABELS[target['quantity']].split(',')[0]} {percent(target['rules_out'])} %"
                               f" ({percent(target['alone'])})" for target in most[:3] if target["rules_out"] > 0)])
    return table(["contacts", "targets", "not ruled out", "best point's implausibility",
                  "rule out most (alone)"], rows)


def measured(case, quantity):
    return next(one for one in told("physical_table3")["targets"]
                if (one["case"], one["quantity"]) == (case, quantity))["value"]


def held_out():
    rows = []
    for one in told("physical_table3").get("predicted", []):
        factor = 100 if one["quantity"] == "failure_ratio" else 1
        value = factor * measured(one["case"], one["quantity"])
        low, high = factor * one["run_low"], factor * one["run_high"]
        rows.append([LABELS[one["quantity"]], one["case"][1:], f"{value:.3g}", f"{factor * one['weighted']:.3g}",
                     f"{low:.3g} to {high:.3g}", "yes" if low <= value <= high else "**no**"])
    return table(["", "E, MPa", "paper, one run", "mean over what is left", "95 % of one run", "paper within"], rows)


def design():
    rows = []
    for name in there():
        for one in told(name).get("design_load", []):
            if one["case"] != "E60":
                continue
            cells = [f"{one[key]:.0f} [{one[f'{key}_low']:.0f}, {one[f'{key}_high']:.0f}]"
                     for key in ("expected", "expected_weighted", "quantile_load", "quantile_load_weighted")]
            growth = (f"{one['growth_quantile']:.2f} [{one['growth_quantile_low']:.2f}, "
                      f"{one['growth_quantile_high']:.2f}]")
            rows.append([words(name)[1], *cells, growth])
    return table(["targets", "expected in 3 h, N [95 %]", "weighed", "exceeded with 10 %, N", "weighed",
                  "growth of the latter"], rows)


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


BLOCKS = {"left": left, "held out": held_out, "design": design}


def main(arguments):
    if arguments[:1] == ["--collect"] and len(arguments) in (2, 3):
        collect(pathlib.Path(arguments[1]), arguments[2] if len(arguments) == 3 else ROOT / "floes")
    elif arguments not in ([], ["--check"]):
        sys.exit(__doc__)
    fill_or_check({PAGE: BLOCKS}, arguments == ["--check"], "matching.py")


if __name__ == "__main__":
    main(sys.argv[1:])
