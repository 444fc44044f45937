#!/usr/bin/python3
"""Runs benchmarks in turns, A B A B ..., and prints the ratios pair by pair and their median.

    bench/pair.py build/release/bench/floes_bench TowStep/stock/late TowStep/lanes/late [more ...]
                  [--rounds 7] [--steps 50] [--json FILE]

Ratios are of CPU time, first benchmark over each of the others, within a round: what else the machine does in a round
touches both. Each benchmark runs in a process of its own.
"""

import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile


def run(program, name, steps):
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "out.json")
        command = [program, "--steps", str(steps), f"--benchmark_filter=^{name}(/iterations:[0-9]+)?$",
                   f"--benchmark_out={out}", "--benchmark_out_format=json"]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        with open(out, encoding="utf-8") as file:
            found = json.load(file)["benchmarks"]
    if not found:
        sys.exit(f"{program} has no benchmark {name}.")
    return found[0]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("names", nargs="+")
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument("--steps", type=int, default=50)
    parser.add_argument("--json", help="write all times to this file")
    options = parser.parse_args()

    times = {name: [] for name in options.names}
    loads = []
    for round_ in range(options.rounds):
        loads.append(os.getloadavg()[0])
        for name in options.names:
            times[name].append(run(options.program, name, options.steps)["cpu_time"])
        first = times[options.names[0]][-1]
        print(f"round {round_ + 1}: " + "  ".join(
            f"{name} {times[name][-1]:.3f} ms (x{first / times[name][-1]:.2f})" for name in options.names), flush=True)

    print(f"\nload average {min(loads):.1f} to {max(loads):.1f}, {os.cpu_count()} CPUs, {options.rounds} rounds")
    for name in options.names:
        ratios = [a / b for a, b in zip(times[options.names[0]], times[name])]
        print(f"{name:24} median {statistics.median(times[name]):9.3f} ms   ratio median {statistics.median(ratios):6.2f}"
              f"   from {min(ratios):.2f} to {max(ratios):.2f}")
    if options.json:
        with open(options.json, "w", encoding="utf-8") as file:
            json.dump({"cpu_ms": times, "load": loads}, file, indent=1)


if __name__ == "__main__":
    main()
