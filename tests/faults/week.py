#!/usr/bin/python3
"""A week in an hour: a campaign of many members over several ranks that are killed again and again. Nothing may be lost,
no status may take a second, and the master may keep a note of each done member and no more.

    week.py FAULTY MPIEXEC FLOES [MEMBERS [RANKS [SECONDS_BETWEEN_KILLS [CONFIG.toml]]]]

Members take no time; with a configuration they are its members, arrangements as many as it takes. Then the memory of
rank 0, which computes as well, is printed and not judged.
"""
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import tomllib

from faulty_runs import at_work, begin, end, same, strike

FLOES = sys.argv[3]
MEMBERS, RANKS, BETWEEN = [int(word) for word in sys.argv[4:7]] + [100002, 8, 2][len(sys.argv[4:7]):]
CONFIG = sys.argv[7] if len(sys.argv) > 7 else None
MIB = 2**20


def cases(config):
    told = subprocess.run([FLOES, "config", "--resolved", config], stdout=subprocess.PIPE, check=True, text=True)
    return len(tomllib.loads(told.stdout)["case"])


ARRANGEMENTS = MEMBERS // cases(CONFIG) if CONFIG else None


def a_run(folder):
    if CONFIG is None:
        return begin(folder, ranks=RANKS, fault=("members", str(MEMBERS)))
    return begin(folder, ranks=RANKS, program=[
        "sh", "-c", 'echo $$ >"$0/rank$OMPI_COMM_WORLD_RANK"; exec "$@"', folder,
        FLOES, "run", CONFIG, "-o", os.path.join(folder, "a.h5"), "--resume", "--threads", "1",
        "--set", f"campaign.arrangements={ARRANGEMENTS}", "--set", "run.attempts=100"])


def memory_of_the_master(folder):
    """Resident bytes of rank 0 that no file backs; None while there is no rank 0."""
    try:
        with open(os.path.join(folder, "rank0")) as file:
            pid = int(file.read().split()[0])
        with open(f"/proc/{pid}/status") as file:
            lines = dict(line.split(":", 1) for line in file)
        return 1024 * int(lines["RssAnon"].split()[0])
    except (OSError, IndexError, ValueError, KeyError):
        return None


def status(folder):
    """Its processor time, s, and what it says."""
    before = os.times()
    told = subprocess.run([FLOES, "status", os.path.join(folder, "a.h5")], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True)
    after = os.times()
    return after.children_user + after.children_system - before.children_user - before.children_system, told.stdout


def size(folder, name):
    path = os.path.join(folder, name)
    return os.path.getsize(path) if os.path.exists(path) else 0


def main():
    random.seed(1)
    top = tempfile.mkdtemp(prefix="floes-week-")
    try:
        folder, whole = os.path.join(top, "killed"), os.path.join(top, "whole")
        os.mkdir(folder)
        os.mkdir(whole)
        begun, kills, sessions, statuses, memories = time.monotonic(), 0, 0, [], []
        while True:
            run = a_run(folder)
            sessions += 1
            last = time.monotonic() + random.uniform(0.3, 1.7) * BETWEEN
            while run.poll() is None:
                time.sleep(0.5)
                if (memory := memory_of_the_master(folder)) is not None:
                    memories.append((size(folder, "a.journal"), memory))
                if os.path.exists(os.path.join(folder, "a.journal")) and random.random() < 0.3:
                    statuses.append(status(folder)[0])
                if time.monotonic() > last:
                    kills += 1
                    victims = [run.pid, *at_work(folder)]
                    strike(random.choice(victims), signal.SIGKILL)
                    break
            end(run, folder)
            if run.returncode == 0 and time.monotonic() <= last:
                break
        took = time.monotonic() - begun
        seconds, told = status(folder)
        statuses.append(seconds)
        assert f"{MEMBERS} of {MEMBERS}" in told, "not all members are done: " + told
        alone = a_run(whole)
        end(alone, whole, patience=60 + 2 * took)
        assert alone.returncode == 0, "the undisturbed run fails"
        same(folder, os.path.join(whole, "a.h5"))
        print(f"{MEMBERS} members, {RANKS} ranks, {kills} kills, {sessions} sessions, {took:.0f} s: the file of an "
              "undisturbed run")
        for part in range(4):
            own = [memory for written, memory in memories if part * memories[-1][0] <= 4 * written
                   < (part + 1) * memories[-1][0] + (part == 3)]
            if own:
                print(f"journal at {25 * part} to {25 * part + 25} %: master {max(own) / MIB:.0f} MiB at most, "
                      f"median {sorted(own)[len(own) // 2] / MIB:.0f}")
        if CONFIG is None:
            grown = max(memory for _, memory in memories) - min(memory for _, memory in memories)
            print(f"master's memory grows by {grown / MEMBERS:.0f} bytes a member")
            assert grown < 500 * MEMBERS, "the master keeps too much of members that are done"
        print(f"journal {size(folder, 'a.journal') / MEMBERS / 1024:.2f} kB a member, file "
              f"{size(folder, 'a.h5') / MEMBERS / 1024:.2f} kB")
        print(f"status: {len(statuses)} times, {sorted(statuses)[len(statuses) // 2]:.2f} s of a processor, at most "
              f"{max(statuses):.2f} s")
        assert max(statuses) < 1, "a status takes too long"
    finally:
        shutil.rmtree(top, ignore_errors=True)
    return 0


sys.exit(main())
