#!/usr/bin/python3
"""How much of the cores goes into members: (sum of their processor time) / (cores x wall time), start-up and tail included.

    bench/efficiency.py build/release/floes -o efficiency.json

runs the same members by floes alone, by floes on two ranks, and beside them by GNU parallel and by mpi4py.futures, each
member there a process of its own (floes run --part K/N). What is not installed is left out and said. On a quiet machine:
"others" tells how many cores other processes had meanwhile.
"""

import argparse
import json
import os
import platform
import resource
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import h5py
import numpy

CONFIG = Path(__file__).resolve().parent / "efficiency.toml"
TOW = 2.6  # m: short enough to stay in the ice, whatever the length of a member
STEADY_START = 8.0  # s, as in the configuration


def settings_of(members, window):
    """A member takes as long as its window says; the structure goes the same way in all of them."""
    speed = TOW / (STEADY_START + window)
    return [f"--set=campaign.arrangements={members}", f"--set=analysis.window_s={window:g}",
            f"--set=structure.speed_m_s={speed:.6f}"]


def cpu_times(files):
    times = []
    for file in files:
        with h5py.File(file) as campaign:
            times.append(campaign["provenance/cpu_time"][:])
    times = numpy.concatenate(times)
    return times[~numpy.isnan(times)]


def own_environment():
    """Without the traces of an MPI that this process may be part of."""
    return {name: value for name, value in os.environ.items() if not name.startswith(("OMPI_", "PMIX_", "PRTE_"))}


def busy_seconds():
    """Of all cores together, since the machine started."""
    fields = [int(field) for field in Path("/proc/stat").read_text().split("\n", 1)[0].split()[1:]]
    return (sum(fields[:8]) - fields[3] - fields[4]) / os.sysconf("SC_CLK_TCK")


def own_cpu_seconds():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def measure(name, command, folder, options):
    """One way of computing all members, in a folder of its own."""
    folder.mkdir()
    own, busy, begin = own_cpu_seconds(), busy_seconds(), time.perf_counter()
    done = subprocess.run(command, cwd=folder, env={**own_environment(), **ROOT}, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True)
    wall = time.perf_counter() - begin
    own, busy = own_cpu_seconds() - own, busy_seconds() - busy
    if done.returncode != 0:
        sys.exit(f"{name} ended with {done.returncode}:\n{done.stdout[-2000:]}")
    cpu = cpu_times(sorted(folder.glob("*.h5")))
    if len(cpu) != options.members:
        sys.exit(f"{name} computed {len(cpu)} members instead of {options.members}")
    result = {"way": name, "efficiency": round(cpu.sum() / (options.cores * wall), 4), "wall_s": round(wall, 3),
              "members_cpu_s": round(cpu.sum(), 3), "shortest_member_s": round(cpu.min(), 3),
              "longest_member_s": round(cpu.max(), 3), "all_cpu_s": round(own, 3),
              "others_cores": round(max(0.0, busy - own) / wall, 3)}
    print(f"{name:32} {result['efficiency']:.4f}   {wall:7.1f} s, others {result['others_cores']:.2f} cores", file=sys.stderr)
    return result


# Open MPI refuses root, which is all there is in a container.
ROOT = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
MPIRUN = ["mpirun", "--oversubscribe", "--bind-to", "none"]

FUTURES = """
import os, subprocess, sys
from mpi4py.futures import MPIPoolExecutor
def run(command):
    environment = {n: v for n, v in os.environ.items() if not n.startswith(("OMPI_", "PMIX_", "PRTE_"))}
    subprocess.run(command, env=environment, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
if __name__ == "__main__":
    members, command = int(sys.argv[1]), sys.argv[2:]
    with MPIPoolExecutor() as executor:
        list(executor.map(run, [[*command, f"--part={k}/{members}", "-o", f"m{k}.h5"] for k in range(1, members + 1)]))
"""


def has_futures():
    return subprocess.run(["/usr/bin/python3", "-c", "import mpi4py.futures"], stderr=subprocess.DEVNULL).returncode == 0


def ways(run, options, folder):
    """Name and command of each way of computing the members."""
    isolation = [f"--set=run.isolation={options.isolation}"] if options.isolation else []
    yield "floes alone", [*run, *isolation, f"--threads={options.cores}", "-o", "a.h5"]
    yield "floes, two ranks", [*MPIRUN, "-n", "2", *run, *isolation, f"--threads={max(1, options.cores // 2)}", "-o", "a.h5"]
    one = [*run, "--threads=1"]
    if shutil.which("parallel"):
        yield "GNU parallel", ["parallel", "--will-cite", f"-j{options.cores}", *one, f"--part={{}}/{options.members}",
                               "-o", "m{}.h5", ":::", *map(str, range(1, options.members + 1))]
    else:
        print("GNU parallel is not installed (packages-bench.txt)", file=sys.stderr)
    if has_futures():
        script = folder / "futures.py"
        script.write_text(FUTURES)
        yield "mpi4py.futures", [*MPIRUN, "-n", str(options.cores + 1), "/usr/bin/python3", "-m", "mpi4py.futures", str(script),
                                 str(options.members), *one]
    else:
        print("mpi4py is not installed (packages-bench.txt)", file=sys.stderr)


def window_for(floes, seconds, folder):
    """The window that makes the quicker of two members take a little more than `seconds` of processor time."""
    window = 21  # s, like all of them in three equal segments
    trial = [floes, "run", str(CONFIG), *settings_of(2, window), "--threads=1", "-o", str(folder / "trial.h5")]
    subprocess.run(trial, check=True, env=own_environment(), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    per_second = cpu_times([folder / "trial.h5"]).min() / (STEADY_START + window)
    return max(3, 3 * round((1.3 * seconds / per_second - STEADY_START) / 3))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("floes", help="the program")
    parser.add_argument("-o", "--output", help="the result as JSON; standard output when not given")
    parser.add_argument("--members", type=int, default=60)
    parser.add_argument("--seconds", type=float, default=2.0, help="of processor time a member, at least")
    parser.add_argument("--cores", type=int, default=len(os.sched_getaffinity(0)))
    parser.add_argument("--isolation", help="none or process: run.isolation of the two runs of floes")
    options = parser.parse_args()
    floes = str(Path(options.floes).resolve())
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        window = window_for(floes, options.seconds, folder)
        run = [floes, "run", str(CONFIG), *settings_of(options.members, window)]
        results = [measure(name, command, folder / str(number), options)
                   for number, (name, command) in enumerate(ways(run, options, folder))]
    report = {"members": options.members, "cores": options.cores, "window_s": window, "isolation": options.isolation,
              "machine": platform.platform(), "processor": processor(), "ways": results}
    text = json.dumps(report, indent=2) + "\n"
    if options.output:
        Path(options.output).write_text(text)
    else:
        print(text, end="")


def processor():
    names = [line.split(":", 1)[1].strip() for line in Path("/proc/cpuinfo").read_text().splitlines()
             if line.startswith("model name")]
    return names[0] if names else ""


if __name__ == "__main__":
    main()
