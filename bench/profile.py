#!/usr/bin/python3
"""What a run spends its processor time on: samples by the source of the function, as a table.

    bench/profile.py -- build/release/floes run my.toml -o my.h5 --threads 1
    bench/profile.py --scene cone [--steps 400] build/release/bench/floes_default

Needs `perf`. Samples are of the processor's clock, so other load on the machine does not count. Functions are found in
src/ by their names; what is inlined counts with its caller.
"""

import argparse
import pathlib
import re
import subprocess
import sys
import tempfile

import pair

SOURCES = pathlib.Path(__file__).resolve().parents[1] / "src"
# The first part that the function or its source, "solver/contact_order" for one, fits.
PARTS = [
    ("sweeps: rows", r"solve_all_|for_each_direct_row|::sweep"),
    ("sweeps: passed to pieces", r"add_velocity_changes|pass_to_piece|piece_motion"),
    ("sweeps: momentum", r"Acceleration::|move_contacts_ahead|begin_sweeps"),
    ("hull against ice", r"^collision/solid_gap|^world/(hull_contacts|bullet)|^shapes/|libBullet|libLinearMath|\bbt[A-Z]|gjkepa"),
    ("ice against ice", r"^collision/"),
    ("contacts set up", r"LaneEngine::(read|write_contacts)\b|^solver/(contact_|direct_contacts|slip|kernels)"),
    ("joints, pieces", r"^solver/(direct_|piece_|joint_|carried)|Eigen::"),
    ("bodies to and fro", r"^(world|solver|core)/"),
    ("stress, cracks", r"^ice/"),
    ("water", r"^water/|^simulation/(field_water|lee)"),
    ("records", r"^(simulation|statistics)/"),
]
REST = "the rest"


def where_defined():
    """The source of each class, and of each function outside one."""
    classes, functions = {}, {}
    for path in sorted(SOURCES.rglob("*.[hci]*")):
        source = path.relative_to(SOURCES).with_suffix("").as_posix()
        text = path.read_text(encoding="utf-8")
        for name in re.findall(r"^ *(?:class|struct) (\w+)[^;(]*\{", text, re.MULTILINE):
            classes.setdefault(name, source)
        for name in re.findall(r"^\w[^;{}=#/]*?\b(\w+)\([^;{}]*\{", text, re.MULTILINE):
            functions.setdefault(name, source)
    return classes, functions


def source_of(symbol, classes, functions):
    if "floes::" not in symbol:
        return ""
    words = re.findall(r"\w+", symbol.replace("(anonymous namespace)", ""))
    return next((of[word] for word in words for of in (classes, functions) if word in of), "")


def part_of(library, symbol, where):
    source = source_of(symbol, *where)
    return next((name for name, fits in PARTS
                 if re.search(fits, f"{library} {symbol}") or re.search(fits, source)), REST)


def recording(data):
    """What stands before a command so that perf samples it."""
    return ["perf", "record", "--quiet", "-e", "cpu-clock", "-F", "1999", "-o", data]


def samples(data, of_thread=None):
    """(library, function, share in %) of what was recorded, of one thread's name only if it is given."""
    of = ["--comms", of_thread] if of_thread else []
    report = subprocess.run(["perf", "report", "-i", data, "--stdio", "--no-children", "--percentage", "relative", *of,
                             "-F", "overhead,dso,symbol,comm", "-t", "|"], check=True, capture_output=True, text=True)
    for line in report.stdout.splitlines():
        found = re.match(r"\s*([0-9.]+)%?\s*\|([^|]*)\|([^|]*)", line)
        if found:
            yield found.group(2).strip(), found.group(3).strip(), float(found.group(1))


def shares(data, of_thread=None):
    where = where_defined()
    found = dict.fromkeys([name for name, _ in PARTS] + [REST], 0.0)
    for library, symbol, share in samples(data, of_thread):
        found[part_of(library, symbol, where)] += share
    if not any(found.values()):
        sys.exit("perf recorded nothing.")
    return found


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--scene", help="of floes_default: these steps alone, without the run up to it")
    options.add_argument("--steps", type=int, default=400)
    options.add_argument("--unknown", action="store_true", help="print what is in the rest")
    options.add_argument("command", nargs="+")
    options = options.parse_args()
    with tempfile.NamedTemporaryFile() as data:
        before = recording(data.name)
        if options.scene:
            scene = pair.Scene(options.command[0], options.scene, before=before)
            scene.step(options.steps)
            scene.end()
        else:
            subprocess.run([*before, *options.command], check=True, stdout=subprocess.DEVNULL)
        thread = "timed" if options.scene else None
        found = shares(data.name, thread)
        if options.unknown:
            where = where_defined()
            for library, symbol, share in samples(data.name, thread):
                if part_of(library, symbol, where) == REST:
                    print(f"{share:6.2f} {library} {symbol}")
    print("\n| share of samples | % |\n|---|---|")
    for name, share in found.items():
        print(f"| {name} | {share:.1f} |")


if __name__ == "__main__":
    main()
