#!/usr/bin/python3
"""What `floes plan` foretells on 2 to 100,000 cores, twenty members a core, campaign file included: a figure, and the
same as a table.

Usage: scaling.py FLOES CONFIGS OUTPUT.svg      (FLOES: the program, CONFIGS: the folder configs/; five minutes)
"""
import json
import os
import subprocess
import sys

import matplotlib

matplotlib.use("agg")
import matplotlib.pyplot as plt

from validation_tables import table

CORES = [2, 8, 64, 512, 1000, 2000, 4000, 8000, 16000, 32000, 64000, 100000]
IN_THE_TABLE = [1000, 4000, 8000, 100000]
MEMBERS_A_CORE = 20
# what is added to the title, configuration, cores, bytes of a record (None: as it is), options, colour, line
CURVES = [
    ("with histories", "validation/crystalline.toml", CORES, None, [], "#0072B2", "-"),
    ("thinned", "validation/crystalline.toml", CORES, 10000, [], "#0072B2", "--"),
    ("with histories", "smoke.toml", CORES, None, ["--set", "analysis.window_s=9"], "#D55E00", "-"),
    ("without histories", "smoke.toml", CORES, 2000, ["--set", "analysis.window_s=9"], "#D55E00", "--"),
]


def plan(program, config, cores, record_bytes, options):
    """A row of the plan, and the mean member's run time (s) and bytes."""
    arrangements = -(-MEMBERS_A_CORE * cores // 3)
    if 3 * arrangements > 20_000_000:
        arrangements -= 1
    command = [program, "plan", config, "--cores", str(cores), "--format", "json", *options,
               "--set", f"campaign.arrangements={arrangements}"]
    if record_bytes:
        command += ["--record-bytes", str(record_bytes)]
    answer = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
    row = answer["plans"][0]
    row["member_s"] = answer["mean_run_time_s"]
    row["member_bytes"] = answer["message_bytes"]
    row["busiest"] = max(row["master_busy"], row["writer_busy"])
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
    lines = []
    for what, config, counts, record_bytes, options, colour, line in CURVES:
        rows = [plan(program, os.path.join(configs, config), cores, record_bytes, options) for cores in counts]
        title = f"{rows[-1]['member_s']:.2g} s members {what}, {rows[-1]['member_bytes'] / 1000:.0f} kB"
        for row in rows:
            if row["cores"] not in IN_THE_TABLE:
                continue
            lines.append([title, f"{row['cores']:.0f}", f"{row['wall_time_s']:.4g}", f"{100 * row['efficiency']:.1f} %",
                          size(row["file_bytes"]), figures(row["file_s"])])
        efficiency.plot(counts, [100 * row["efficiency"] for row in rows], line, color=colour, marker=".", label=title)
        busy.plot(counts, [100 * row["busiest"] for row in rows], line, color=colour, marker=".", label=title)
    print(table(["members", "cores", "wall time, s", "efficiency", "campaign file", "written in, s"], lines))
    efficiency.set_ylabel("efficiency, campaign file included (%)")
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
