#!/usr/bin/python3
"""Every block of the section "Without the package" of docs/reading_the_file.md runs as it stands, and its last number is the one that floes gives.

Usage: reading_the_file.py FLOES CONFIG.toml PAGE.md
"""
import json
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

COMMANDS = {"python": ["/usr/bin/python3", "-c"], "octave": ["octave-cli", "--eval"], "sh": ["sh", "-e", "-c"]}


def numbers(text):
    return [float(word) for word in re.findall(r"-?\d+\.\d+", text)]


def main(floes, config, page):
    blocks = re.findall(r"^```(\w+)\n(.*?)^```", page.read_text().partition("\n## Without the package\n")[2], re.DOTALL | re.MULTILINE)
    kinds = [kind for kind, _ in blocks]
    if sorted(set(kinds)) != sorted(COMMANDS) or kinds.count("python") < 2:
        sys.exit(f"the page has blocks of {kinds}")
    with tempfile.TemporaryDirectory() as folder:
        environment = dict(os.environ, PATH=f"{Path(floes).resolve().parent}:{os.environ['PATH']}")
        subprocess.run([floes, "run", config, "-o", "smoke.h5", "--set", "campaign.arrangements=2"], cwd=folder,
                       check=True, stdout=subprocess.DEVNULL)
        summary = json.loads(subprocess.run([floes, "summarize", "smoke.h5", "--format", "json"], cwd=folder, check=True,
                                            capture_output=True, text=True).stdout)
        means = [case["mean_load"] for case in summary["cases"]]
        by_name = dict(sorted((case["name"], case["mean_load"]) for case in summary["cases"]))
        said = []
        for kind, block in blocks:
            run = subprocess.run(COMMANDS[kind] + [block], cwd=folder, env=environment, capture_output=True, text=True)
            if run.returncode != 0:
                sys.exit(f"this {kind} block failed:\n{block}\n{run.stdout}{run.stderr}")
            if not said and [line.split()[0] for line in run.stdout.splitlines() if line[:1] == "E"] != list(by_name):
                sys.exit(f"xarray names other cases than {list(by_name)}:\n{run.stdout}")
            said.append(numbers(run.stdout))
    xarray_means, h5py_numbers, octave_numbers, shell_numbers = said
    for expected, found, who in [(list(by_name.values()), xarray_means[-3:], "xarray"), ([means[2] - means[1]], h5py_numbers[-1:], "h5py"),
                                 ([sum(means) / 3], octave_numbers[-1:], "Octave"),
                                 (means, shell_numbers[-3:], "the shell")]:
        if len(expected) != len(found) or any(abs(e - f) > 6e-3 for e, f in zip(expected, found)):
            sys.exit(f"{who} says {found} where floes says {expected}")
    print(f"{len(blocks)} blocks ran and agree")


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(str(Path(sys.argv[1]).resolve()), Path(sys.argv[2]).resolve(), Path(sys.argv[3]))
