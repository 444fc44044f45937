#!/usr/bin/python3
"""The direct solver beside the sweeps: time, and what a number of iterations leaves unsolved. Under a minute.

    bench/direct.py build/release/bench [--rounds 7] [--docs docs/fracture.md]

Steps and members in turns, A B A B .... --docs puts the tables into that file, between <!-- cost --> and <!-- end -->.
"""

import csv
import os
import statistics
import subprocess

import all as paired

# Times over that of the first of each group; lanes with 50 sweeps, direct with 20 and 50.
SCENES = [f"{scene}_cone_crushing" for scene in ("late", "late_steep")]
GROUPS = [([f"TowStep/lanes/{scene}", f"TowStep/direct/{scene}_20", f"TowStep/direct/{scene}_50"], 50)
          for scene in SCENES]
GROUPS += [(["Member/lanes_physical", "Member/direct_physical"], 1),
           ([f"Size/direct/elements:{count}" for count in (9, 16, 36)], 20),
           ([f"Size/direct/floes:{count}" for count in (189, 1000, 2000)], 5)]
MARKS = ("<!-- cost -->", "<!-- end -->")


def times_table(times):
    lines = ["| benchmark | CPU ms | over the first (range of rounds) |", "|---|---|---|"]
    for names, _ in GROUPS:
        for name in names:
            ratios = [b / a for a, b in zip(times[names[0]], times[name])]
            ratio = 1 if name == names[0] else paired.ratio_text(ratios)
            lines.append(f"| {name} | {statistics.median(times[name]):.4g} | {ratio} |")
    return "\n".join(lines) + "\n"


def error_table(program):
    rows = list(csv.DictReader(subprocess.run([program], check=True, capture_output=True, text=True).stdout.splitlines()))
    counts = sorted({int(row["iterations"]) for row in rows})
    lines = ["| error, % | " + " | ".join(f"{count}" for count in counts) + " |", "|---" * (len(counts) + 1) + "|"]
    for solver in ("lanes", "direct"):
        for field, what in (("velocity_error", "velocities"), ("load_error", "load")):
            of = {int(row["iterations"]): float(row[field]) for row in rows if row["solver"] == solver}
            lines.append(f"| {solver}, {what} | " + " | ".join(f"{100 * of[count]:.2g}" for count in counts) + " |")
    return "\n".join(lines) + "\n"


def main():
    options = paired.parser(__doc__).parse_args()
    times = {}
    for names, steps in GROUPS:
        rounds = options.rounds if steps > 1 else max(1, options.rounds // 3)
        times |= paired.turns(os.path.join(options.folder, "floes_bench"), names, rounds, steps)
    text = "\n" + times_table(times) + "\n" + error_table(os.path.join(options.folder, "floes_contact_error")) + "\n"
    print(text, end="")
    if options.docs:
        paired.put_between_marks(options.docs, text, MARKS)


if __name__ == "__main__":
    main()
