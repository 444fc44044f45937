#!/usr/bin/python3
"""The paired benchmarks, end to end: what `./floes bench` runs. Some 5 minutes on a quiet machine.

    bench/all.py build/release/bench [--rounds 7] [--docs docs/performance.md]

Steps, peers and members in turns, A B A B ..., instructions by callgrind, two threads against two processes. Prints the
table of docs/performance.md; all single times go to results.json in the folder of the programs. --docs puts the table
into that file, between its two marks.
"""

import argparse
import json
import os
import re
import statistics
import subprocess
import sys
import tempfile

import pair
import side_by_side

# Times are compared with that of the first of each group.
LAWS = ["", "_cone", "_crushing", "_cone_crushing"]  # of contact, in the lane solver
LATE = ["TowStep/stock/late"] + [f"TowStep/lanes/late{law}" for law in LAWS] + ["Peer/bullet/late", "Peer/ode/late"]
STEEP = ["TowStep/stock/late_steep"] + [f"TowStep/lanes/late_steep{law}" for law in LAWS]
EARLY = ["TowStep/stock/early", "TowStep/lanes/early"]
MEMBERS = ["Member/stock", "Member/lanes"] + [f"Member/lanes/wake:{radius}" for radius in (6, 4, 3, 2)]
# The physical preset: over lanes with 50 sweeps; Bullet's own solver has neither its cone nor its crushing.
PHYSICAL = [[f"TowStep/lanes/{scene}_cone_crushing", f"TowStep/direct/{scene}_cone_crushing_20",
             f"TowStep/direct/{scene}_physical"] for scene in ("late", "late_steep")]
PHYSICAL += [["TowStep/lanes/early_physical", "TowStep/direct/early_physical"]]
PHYSICAL_MEMBERS = ["Member/lanes_physical", "Member/direct_physical"]
FIELD = ["Size/floes:2000", "Size/direct/floes:2000"]
COUNTED = LATE[:-2] + STEEP + EARLY + [name for group in PHYSICAL for name in group if "direct" in name]
WARM_UP = 5  # steps that callgrind counts too
MARKS = ("<!-- paired: ./floes bench -->", "<!-- end -->")


def turns(program, names, rounds, steps):
    times = {name: [] for name in names}
    for round_ in range(rounds):
        for name in names:
            times[name].append(pair.run(program, name, steps)["cpu_time"])
        print(f"round {round_ + 1} of {rounds}: " + "  ".join(f"{name} {times[name][-1]:.3f}" for name in names),
              file=sys.stderr, flush=True)
    return times


def instructions(program, name):
    """Of one step."""
    steps = 5
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "out")
        subprocess.run(["valgrind", "--tool=callgrind", "--toggle-collect=floes::Simulation::step()",
                        f"--callgrind-out-file={out}", program, "--steps", str(steps), f"--benchmark_filter=^{name}/"],
                       check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        with open(out, encoding="utf-8") as file:
            total = re.search(r"^(?:summary|totals): (\d+)", file.read(), re.MULTILINE)
    return int(total.group(1)) / (WARM_UP + steps)


def ratio_text(ratios):
    return f"{statistics.median(ratios):.2f} ({min(ratios):.2f} to {max(ratios):.2f})"


def parser(about):
    made = argparse.ArgumentParser(description=about, formatter_class=argparse.RawDescriptionHelpFormatter)
    made.add_argument("folder")
    made.add_argument("--rounds", type=int, default=7, help="of steps; members take a third of them")
    made.add_argument("--docs")
    return made


def table(times, counts, first, groups):
    lines = [f"| benchmark | CPU ms | instructions/step | time of {first} over it (range of rounds) |", "|---|---|---|---|"]
    for group in groups:
        for name in group:
            ratios = [a / b for a, b in zip(times[group[0]], times[name])]
            ratio = ratio_text(ratios)
            count = f"{counts[name] / 1e6:.1f} M" if name in counts else ""
            lines.append(f"| {name} | {statistics.median(times[name]):.4g} | {count} | "
                         f"{1 if name == group[0] else ratio} |")
    return "\n".join(lines) + "\n"


def put_between_marks(path, text, marks=MARKS):
    with open(path, encoding="utf-8") as file:
        before, mark, rest = file.read().partition(marks[0])
    _, end, after = rest.partition(marks[1])
    if not mark or not end:
        sys.exit(f"{path} lacks the marks {marks[0]} and {marks[1]} that the table goes between.")
    with open(path, "w", encoding="utf-8") as file:
        file.write(f"{before}{mark}\n{text}{end}{after}")


def main():
    options = parser(__doc__).parse_args()
    program = os.path.join(options.folder, "floes_bench")

    load = os.getloadavg()[0]
    times = turns(program, LATE + STEEP + EARLY, options.rounds, 50)
    times |= turns(program, sorted({name for group in PHYSICAL for name in group} - set(times)), options.rounds, 50)
    times |= turns(program, MEMBERS + PHYSICAL_MEMBERS + FIELD, max(1, options.rounds // 3), 1)
    counts = {name: instructions(program, name) for name in COUNTED}
    together = side_by_side.measure(os.path.join(options.folder, "floes_throughput"), max(1, options.rounds - 2), 200)

    text = table(times, counts, "stock", (LATE, STEEP, EARLY, MEMBERS))
    text += "\n" + table(times, counts, "lanes", (*PHYSICAL, PHYSICAL_MEMBERS, FIELD))
    text += f"\nLoad average before: {load:.1f}; {os.cpu_count()} CPUs; {options.rounds} rounds of 50 steps, " \
            f"{len(times[MEMBERS[0]])} of members.\nTwo threads over two processes, throughput: "
    text += ", ".join(f"{what} {statistics.median(values):.3f} ({min(values):.3f} to {max(values):.3f})"
                      for what, values in together.items()) + ".\n"
    print(text, end="")
    with open(os.path.join(options.folder, "results.json"), "w", encoding="utf-8") as file:
        json.dump({"load": load, "cpu_ms": times, "instructions_a_step": counts, "threads_over_processes": together},
                  file, indent=1)
    if options.docs:
        put_between_marks(options.docs, text)


if __name__ == "__main__":
    main()
