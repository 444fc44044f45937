#!/usr/bin/python3
"""Throughput of two threads in one process over that of two processes, in turns.

    bench/side_by_side.py build/release/bench/floes_throughput [--rounds 7] [--steps 400]

By wall clock, which needs two idle cores, and by CPU time, which shows what two threads cost each other in work but not
waiting.
"""

import argparse
import statistics
import subprocess
import sys


def finish(processes):
    rates = [[float(word) for word in process.communicate()[0].split()] for process in processes]
    wall = sum(rate[0] for rate in rates)
    cpu = len(rates) / sum(1 / rate[1] for rate in rates)
    return wall, cpu


def measure(program, rounds, steps):
    """Ratios of throughput round by round, by wall clock and by CPU time."""
    def start(threads):
        return subprocess.Popen([program, str(threads), str(steps)], stdout=subprocess.PIPE, text=True)

    ratios = {"wall": [], "CPU": []}
    for round_ in range(rounds):
        together = finish([start(2)])
        apart = finish([start(1), start(1)])
        for i, what in enumerate(ratios):
            ratios[what].append(together[i] / apart[i])
        print(f"round {round_ + 1}: wall {together[0]:.1f} / {apart[0]:.1f} steps/s = {ratios['wall'][-1]:.3f}   "
              f"CPU {together[1]:.1f} / {apart[1]:.1f} steps/s = {ratios['CPU'][-1]:.3f}", file=sys.stderr, flush=True)
    return ratios


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument("--steps", type=int, default=400)
    options = parser.parse_args()

    for what, values in measure(options.program, options.rounds, options.steps).items():
        print(f"{what}: median {statistics.median(values):.3f}, from {min(values):.3f} to {max(values):.3f}")


if __name__ == "__main__":
    main()
