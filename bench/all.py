#!/usr/bin/python3
"""The benchmarks, end to end: what `./floes bench` runs. Some 10 minutes on a quiet machine.

    bench/all.py build/release/bench [--rounds 7] [--docs docs/performance.md]

First the scenes of the default, each stepped on again and again from one moment, with the share of each part of the
program by `perf`; then steps, members and peers of the paper's preset, A B A B ...; two threads against two processes.
Prints the tables; all single times go to results.json in the folder of the programs. --docs puts that of the default
into docs/performance.md, between its marks.
"""

import argparse
import json
import os
import statistics
import sys
import tempfile

import pair
import profile
import side_by_side

# Times are compared with that of the first of each group.
LATE = [f"TowStep/{solver}/late" for solver in ("stock", "lanes", "direct")] + ["Peer/bullet/late", "Peer/ode/late"]
EARLY = [f"TowStep/{solver}/early" for solver in ("stock", "lanes", "direct")]
MEMBERS = [f"Member/{solver}" for solver in ("stock", "lanes", "direct")]
STEPS = 100  # of a scene in a round
MARKS = "<!-- default: ./floes bench -->", "<!-- end -->"


def turns(program, names, rounds, steps):
    times = {name: [] for name in names}
    for round_ in range(rounds):
        for name in names:
            times[name].append(pair.run(program, name, steps)["cpu_time"])
        print(f"round {round_ + 1} of {rounds}: " + "  ".join(f"{name} {times[name][-1]:.3f}" for name in names),
              file=sys.stderr, flush=True)
    return times


def parser(about):
    made = argparse.ArgumentParser(description=about, formatter_class=argparse.RawDescriptionHelpFormatter)
    made.add_argument("folder")
    made.add_argument("--rounds", type=int, default=7, help="of steps; members take a third of them")
    return made


def default_scenes(program, rounds):
    """Of each scene the answers of all rounds, and the shares of its parts in them."""
    answers, shares = {}, {}
    with tempfile.TemporaryDirectory() as folder:
        data = {name: os.path.join(folder, name) for name in pair.scene_names(program)}
        scenes = {name: pair.Scene(program, name, before=profile.recording(file)) for name, file in data.items()}
        for name, scene in scenes.items():
            print(f"{name}: {scene.ready()}", file=sys.stderr, flush=True)
            answers[name] = []
        for round_ in range(rounds):
            for name, scene in scenes.items():
                answers[name].append(scene.step(STEPS))
            print(f"round {round_ + 1} of {rounds}: " + "  ".join(
                f"{name} {of[-1]['ms']:.3f}" for name, of in answers.items()), file=sys.stderr, flush=True)
        for name, scene in scenes.items():
            scene.end()
            shares[name] = profile.shares(data[name], "timed")
    return answers, shares


def default_table(answers):
    """Times of the fastest round: all do the same work, and what else the machine does only adds."""
    lines = ["| scene | elements | contacts | sweeps a step | ms a step | µs an element and step (slowest round) |",
             "|---|---|---|---|---|---|"]
    for name, of in answers.items():
        micros = [1e3 * one["ms"] / one["elements"] for one in of]
        lines.append(f"| {name} | {of[0]['elements']} | {of[0]['contacts']} | {of[0]['sweeps']:.0f} | "
                     f"{min(one['ms'] for one in of):.3g} | {min(micros):.2f} ({max(micros):.2f}) |")
    return "\n".join(lines) + "\n"


def shares_table(shares):
    lines = ["| share of the time, % | " + " | ".join(shares) + " |", "|---" * (len(shares) + 1) + "|"]
    lines += [f"| {part} | " + " | ".join(f"{of[part]:.0f}" for of in shares.values()) + " |"
              for part in next(iter(shares.values()))]
    return "\n".join(lines) + "\n"


def paper_table(times):
    lines = ["| benchmark | CPU ms | time of stock over it (range of rounds) |", "|---|---|---|"]
    for group in (LATE, EARLY, MEMBERS):
        for name in group:
            ratios = [a / b for a, b in zip(times[group[0]], times[name])]
            lines.append(f"| {name} | {statistics.median(times[name]):.4g} | "
                         f"{1 if name == group[0] else pair.ratio_text(ratios)} |")
    return "\n".join(lines) + "\n"


def machine(load):
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        of = dict(line.split(":", 1) for line in file.read().replace("\t", "").splitlines() if ":" in line)
    name, family, model = (of.get(key, "unknown").strip() for key in ("model name", "cpu family", "model"))
    return f"{name}, family {family} model {model}, {os.cpu_count()} CPUs, load average {load:.1f} before"


def put_between_marks(path, text, marks):
    with open(path, encoding="utf-8") as file:
        before, mark, rest = file.read().partition(marks[0])
    _, end, after = rest.partition(marks[1])
    if not mark or not end:
        sys.exit(f"{path} lacks the marks {marks[0]} and {marks[1]} that the table goes between.")
    with open(path, "w", encoding="utf-8") as file:
        file.write(f"{before}{mark}\n{text}{end}{after}")


def main():
    options = parser(__doc__)
    options.add_argument("--docs")
    options = options.parse_args()
    tables = {}

    load = os.getloadavg()[0]
    answers, shares = default_scenes(os.path.join(options.folder, "floes_default"), options.rounds)
    tables["default"] = f"{default_table(answers)}\n{options.rounds} rounds of {STEPS} steps; {machine(load)}.\n"
    print(shares_table(shares))

    load = os.getloadavg()[0]
    program = os.path.join(options.folder, "floes_bench")
    times = turns(program, LATE + EARLY, options.rounds, 50)
    times |= turns(program, MEMBERS, max(1, options.rounds // 3), 1)
    together = side_by_side.measure(os.path.join(options.folder, "floes_throughput"), max(1, options.rounds - 2), 200)
    tables["paper"] = (
        f"{paper_table(times)}\n{options.rounds} rounds of 50 steps, {len(times[MEMBERS[0]])} of members; "
        f"{machine(load)}.\n"
        "Two threads over two processes, throughput: "
        + ", ".join(f"{what} {pair.ratio_text(values)}" for what, values in together.items()) + ".\n")

    for name, text in tables.items():
        print(text)
        if options.docs and name == "default":
            put_between_marks(options.docs, text, MARKS)
    with open(os.path.join(options.folder, "results.json"), "w", encoding="utf-8") as file:
        json.dump({"default": answers, "shares": shares, "cpu_ms": times, "threads_over_processes": together}, file,
                  indent=1)


if __name__ == "__main__":
    main()
