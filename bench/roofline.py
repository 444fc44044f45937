#!/usr/bin/python3
"""Which bound the sweeps meet, and the cost of an element over the number of floes. Two minutes on a quiet machine.

    bench/roofline.py build/release/bench [--rounds 3]

Medians over the rounds.
"""

import json
import os
import statistics
import subprocess
import tempfile

import all as paired

FLOES = (50, 189, 500, 1000, 5000, 20000)
READS = ("24 KiB", "512 KiB", "4096 KiB", "262144 KiB")


def roofline(program, rounds):
    """The rows of floes_roofline, each number the median over the rounds."""
    runs = [subprocess.run([program], check=True, capture_output=True, text=True).stdout.splitlines()
            for _ in range(rounds)]
    rows = []
    for lines in zip(*runs):
        cells = [line.split(",") for line in lines]
        rows.append(cells[0][:2] + [statistics.median(map(float, column)) for column in zip(*(c[2:] for c in cells))])
    return rows


def bounds_table(rows):
    ceilings = {row[1]: row[2] for row in rows if row[0] == "ceiling"}
    lines = ["| this core | |", "|---|---|"]
    lines += [f"| reads {size} again and again at | {ceilings['read ' + size]:.0f} GB/s |" for size in READS]
    lines += [f"| multiplies and adds at | {ceilings['multiply and add']:.0f} Gflop/s |", ""]
    lines += ["| a sweep | µs | joints | loaded contacts | MB | GB/s | a plain read of as much | share, % | Gflop/s | share, % |",
              "|---|---|---|---|---|---|---|---|---|---|"]
    for kind, *of in rows:
        if kind != "sweep":
            continue
        solver, micros, joints, contacts, size, flops, read = of
        rate, speed = 1e-3 * size / micros, 1e-3 * flops / micros
        lines.append(f"| {solver} | {micros:.1f} | {joints:.0f} | {contacts:.0f} | {1e-6 * size:.2f} | {rate:.0f} | {read:.0f} | "
                     f"{100 * rate / read:.0f} | {speed:.1f} | "
                     f"{100 * speed / ceilings['multiply and add']:.0f} |")
    return "\n".join(lines) + "\n"


def sizes_table(program, rounds):
    times = {}
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "sizes.json")
        for _ in range(rounds):
            subprocess.run([program, "--benchmark_filter=^Size/", f"--benchmark_out={out}",
                            "--benchmark_out_format=json"], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            with open(out, encoding="utf-8") as file:
                for run in json.load(file)["benchmarks"]:
                    name = run["name"].split("/iterations")[0]
                    times.setdefault(name, []).append((run["cpu_time"], run["elements"]))
    lines = ["| floes | default, ms a step | µs an element | paper's preset, ms a step | µs an element |", "|---|---|---|---|---|"]
    for floes in FLOES:
        cells = []
        for name in (f"Size/default/floes:{floes}", f"Size/paper/floes:{floes}"):
            took = statistics.median(time for time, _ in times[name])
            cells += [f"{took:.3g}", f"{1e3 * took / times[name][0][1]:.2f}"]
        lines.append(f"| {floes} | " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def main():
    options = paired.parser(__doc__)
    options.set_defaults(rounds=3)
    options = options.parse_args()
    tables = {"bounds": bounds_table(roofline(os.path.join(options.folder, "floes_roofline"), options.rounds)),
              "sizes": sizes_table(os.path.join(options.folder, "floes_bench"), options.rounds)}
    for text in tables.values():
        print(text)


if __name__ == "__main__":
    main()
