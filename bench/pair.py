#!/usr/bin/python3
"""Runs benchmarks in turns, A B A B ..., and prints the ratios pair by pair and their median.

    bench/pair.py build/release/bench/floes_bench TowStep/stock/late TowStep/lanes/late [more ...]
                  [--rounds 7] [--steps N] [--json FILE]
    bench/pair.py old/floes_default new/floes_default --scenes [cone wall ...] [--arrangements 0 1 2]

Ratios are of CPU time, first over each of the others, within a round: what else the machine does in a round touches
both. Each benchmark runs in a process of its own.

With --scenes the others are builds, not benchmarks, and step the scenes of the default, all of them if none is named, in
more rounds where these are short. The time is that of the fastest round, since all do the same work.
Builds that round differently come to other moments of the same run; then compare several arrangements, and see in how
far contacts and sweeps explain a ratio.
"""

import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile


LEAST_MS = 3000  # of a scene and a build: short ones take more rounds


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


class Scene:
    """A scene of the default that waits for steps to be asked for; `before` is what runs the program, as perf does."""

    def __init__(self, program, name, arrangement=0, before=()):
        self.process = subprocess.Popen([*before, program, name, str(arrangement)], stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE, text=True)
        self.about = None

    def _answer(self):
        line = self.process.stdout.readline()
        if not line:
            sys.exit(f"{' '.join(self.process.args)} has ended.")
        return json.loads(line)

    def ready(self):
        """Waits for the run up to the scene; what there is then."""
        self.about = self.about or self._answer()
        return self.about

    def step(self, steps):
        self.ready()
        print(steps, file=self.process.stdin, flush=True)
        return self._answer()

    def end(self):
        self.process.stdin.close()
        self.process.wait()


def scene_names(program):
    return subprocess.run([program], check=True, capture_output=True, text=True).stdout.split()


def added(answers):
    """Of several arrangements of a scene, as if they were one; sweeps are of the mean arrangement."""
    sums = {what: sum(answer[what] for answer in answers) for what in answers[0]}
    return sums | {"sweeps": sums["sweeps"] / len(answers)}


def ratio_text(ratios):
    return f"{statistics.median(ratios):.3g} ({min(ratios):.3g} to {max(ratios):.3g})"


def compare_builds(programs, options):
    found = {}
    for name in options.scenes or scene_names(programs[0]):
        scenes = [[Scene(program, name, number) for number in options.arrangements] for program in programs]
        for scene in sum(scenes, []):
            scene.ready()
        rounds = []
        while len(rounds) < options.rounds or sum(one[0]["ms"] for one in rounds) * options.steps < LEAST_MS:
            rounds.append([added([scene.step(options.steps) for scene in of]) for of in scenes])
        for scene in sum(scenes, []):
            scene.end()
        found[name] = rounds
        for at, program in enumerate(programs):
            of = rounds[-1][at]
            least = min(one[at]["ms"] for one in rounds)
            ratio = "1" if at == 0 else ratio_text([one[0]["ms"] / one[at]["ms"] for one in rounds])
            same = "" if at == 0 or of["surge_N"] != rounds[-1][0]["surge_N"] else ", same load"
            print(f"{name:12} {program}: {least:.4g} ms, {of['elements']} elements, {of['contacts']} contacts, "
                  f"{of['sweeps']:.1f} sweeps; {len(rounds)} rounds, ratio {ratio}{same}", flush=True)
    return found


def compare_benchmarks(program, names, options):
    times = {name: [] for name in names}
    for round_ in range(options.rounds):
        for name in names:
            times[name].append(run(program, name, options.steps)["cpu_time"])
        first = times[names[0]][-1]
        print(f"round {round_ + 1}: " + "  ".join(
            f"{name} {times[name][-1]:.3f} ms (x{first / times[name][-1]:.2f})" for name in names), flush=True)
    for name in names:
        ratios = [a / b for a, b in zip(times[names[0]], times[name])]
        print(f"{name:24} median {statistics.median(times[name]):9.3f} ms   ratio {ratio_text(ratios)}")
    return times


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("others", nargs="+", metavar="NAME_OR_PROGRAM")
    parser.add_argument("--scenes", nargs="*")
    parser.add_argument("--arrangements", nargs="+", type=int, default=[0])
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument("--steps", type=int, help="a round; 50, of scenes 100")
    parser.add_argument("--json", help="write all times to this file")
    options = parser.parse_args()
    options.steps = options.steps or (50 if options.scenes is None else 100)

    load = os.getloadavg()[0]
    if options.scenes is None:
        found = compare_benchmarks(options.program, options.others, options)
    else:
        found = compare_builds([options.program, *options.others], options)
    load = [load, os.getloadavg()[0]]
    print(f"\nload average {load[0]:.1f} before, {load[1]:.1f} after; {os.cpu_count()} CPUs, {options.rounds} rounds")
    if options.json:
        with open(options.json, "w", encoding="utf-8") as file:
            json.dump({"found": found, "load": load}, file, indent=1)


if __name__ == "__main__":
    main()
