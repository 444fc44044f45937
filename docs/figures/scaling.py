#!/usr/bin/python3
"""What `floes plan` foretells on 2 to 100,000 cores, ten members a core: a figure, and the same as a table. With
--no-file, and how long one core writes the campaign file then.

Usage: scaling.py FLOES CONFIGS OUTPUT.svg      (FLOES: the program, CONFIGS: the folder configs/)
"""
import csv
import io
import os
import subprocess
import sys

import matplotlib

matplotlib.use("agg")
import matplotlib.pyplot as plt

CORES = [2, 8, 64, 512, 1000, 2000, 4000, 8000, 16000, 32000, 64000, 100000]
IN_THE_TABLE = [2, 64, 1000, 8000, 32000, 100000]
# title, configuration, bytes of a record (None: as it is), colour, line
CURVES = [
    ("31 s members with histories, 188 kB (Table 3)", "validation/crystalline.toml", None, "#0072B2", "-"),
    ("31 s members without histories, 5 kB", "validation/crystalline.toml", 5000, "#0072B2", "--"),
    ("0.4 s members with histories, 22 kB (smoke.toml)", "smoke.toml", None, "#D55E00", "-"),
    ("0.4 s members without histories, 2 kB", "smoke.toml", 2000, "#D55E00", "--"),
]


def plan(program, config, cores, record_bytes):
    arrangements = -(-10 * cores // 3)
    command = [program, "plan", config, "--cores", str(cores), "--format", "csv", "--no-file",
               "--set", f"campaign.arrangements={arrangements}"]
    if record_bytes:
        command += ["--record-bytes", str(record_bytes)]
    text = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    row = {key: float(value) for key, value in next(csv.DictReader(io.StringIO(text))).items()}
    row["busiest"] = max(row["master_busy"], row["writer_busy"])
    row["efficiency_with_file"] = row["efficiency"] * row["wall_time_s"] / (row["wall_time_s"] + row["file_s"])
    return row


def figures(number):
    return f"{number:.3g}" if number < 1000 else f"{number:.0f}"


def size(number):
    for unit in ("B", "kB", "MB"):
        if number < 1000:
            return f"{number:.0f} {unit}"
        number /= 1000
    return f"{number:.1f} GB"


def main(program, configs, output):
    figure, (efficiency, busy) = plt.subplots(1, 2, figsize=(10, 4), sharex=True)
    print("| members | cores | ranks | writers | wall time, s | efficiency | master busy | busiest other writer "
          "| campaign file | written in, s | efficiency with it |")
    print("|---|---|---|---|---|---|---|---|---|---|---|")
    for title, config, record_bytes, colour, line in CURVES:
        rows = [plan(program, os.path.join(configs, config), cores, record_bytes) for cores in CORES]
        for row in rows:
            if row["cores"] not in IN_THE_TABLE:
                continue
            print(f"| {title} | {row['cores']:.0f} | {row['ranks']:.0f} | {row['writers']:.0f} | {row['wall_time_s']:.4g} "
                  f"| {100 * row['efficiency']:.1f} % | {100 * row['master_busy']:.1f} % "
                  f"| {100 * row['writer_busy']:.1f} % | {size(row['file_bytes'])} | {figures(row['file_s'])} "
                  f"| {100 * row['efficiency_with_file']:.1f} % |")
        efficiency.plot(CORES, [100 * row["efficiency"] for row in rows], line, color=colour, marker=".", label=title)
        busy.plot(CORES, [100 * row["busiest"] for row in rows], line, color=colour, marker=".", label=title)
    efficiency.set_ylabel("efficiency until all results are on the disk (%)")
    busy.set_ylabel("busiest of master and writers (%)")
    for axis in (efficiency, busy):
        axis.set_xscale("log")
        axis.set_xlabel("cores")
        axis.set_ylim(0, 104)
        axis.grid(color="0.9")
        axis.spines[["top", "right"]].set_visible(False)
    figure.legend(*efficiency.get_legend_handles_labels(), frameon=False, fontsize=8, ncol=2, loc="upper center")
    figure.tight_layout(rect=(0, 0, 1, 0.9))
    figure.savefig(output, metadata={"Date": None})


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
