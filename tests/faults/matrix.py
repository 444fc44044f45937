#!/usr/bin/python3
"""Which process breaks, when, and how: every ending is the file of an undisturbed run.

    matrix.py FAULTY MPIEXEC members|processes|kills [COUNT [SEED]]

members    one member breaks in every way, in its rank's process and in its own
processes  a rank, a helper, a member's process, mpirun are killed or stopped in the middle
kills      COUNT kills at random moments of random processes, resumed each time
"""
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

FAULTY, MPIEXEC, WHAT = sys.argv[1:4]
MPIRUN = [MPIEXEC, "--allow-run-as-root", "--oversubscribe", "--bind-to", "none"]
ENV = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
PATIENCE = 100  # s; a run takes one, and one whose rank is stopped at its very end a minute


def command(folder, isolation="none", ranks=1, recovery=False, fault=()):
    launcher = MPIRUN + (["--enable-recovery"] if recovery else []) + ["-n", str(ranks)] if ranks > 1 else []
    return [*launcher, FAULTY, folder, "a.h5", isolation, "2", *fault]


def begin(folder, **how):
    for name in os.listdir(folder):
        if name.startswith("rank"):
            os.remove(os.path.join(folder, name))
    log = open(os.path.join(folder, "log"), "ab")
    return subprocess.Popen(command(folder, **how), env=ENV, stdout=log, stderr=log, start_new_session=True)


def at_work(folder):
    """Ranks of the last run that are still there: those of a killed mpirun take a moment to notice."""
    ranks = []
    for name in os.listdir(folder):
        if not name.startswith("rank"):
            continue
        try:
            with open(os.path.join(folder, name)) as file:
                pid = int(file.read().split()[0])
            with open(f"/proc/{pid}/stat") as file:
                if file.read().rsplit(")", 1)[1].split()[0] not in "ZX":
                    ranks.append(pid)
        except (OSError, IndexError):
            pass
    return ranks


def end(process, folder, patience=PATIENCE):
    """The exit status; a run that hangs is ended and fails the test."""
    last = time.monotonic() + patience
    try:
        status = process.wait(patience)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()
        raise AssertionError("the run hangs")
    while at_work(folder):
        assert time.monotonic() < last, "a rank outlives its run"
        time.sleep(0.01)
    return status


def run_to_end(folder, **how):
    return end(begin(folder, **how), folder)


def pids(folder, rank):
    """Numbers of the rank's process and of its helper, as soon as it is there."""
    for _ in range(2000):
        try:
            with open(os.path.join(folder, f"rank{rank}")) as file:
                words = file.read().split()
                if len(words) == 2:
                    return [int(word) for word in words]
        except FileNotFoundError:
            pass
        time.sleep(0.005)
    raise AssertionError(f"rank {rank} did not begin")


def children(pid):
    try:
        with open(f"/proc/{pid}/task/{pid}/children") as file:
            return [int(word) for word in file.read().split()]
    except OSError:
        return []


def strike(pid, how):
    try:
        os.kill(pid, how)
    except ProcessLookupError:
        pass  # it was quicker


def same(folder, whole):
    result = subprocess.run(["h5diff", "--exclude-path", "/provenance", whole, os.path.join(folder, "a.h5")],
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    assert result.returncode == 0, "the file differs: " + result.stdout


def complete(folder, whole, isolation="none", fault=()):
    status = run_to_end(folder, isolation=isolation, fault=fault)
    assert status == 0, f"the resumed run ended with {status}"
    same(folder, whole)


def said(folder, text):
    with open(os.path.join(folder, "log"), errors="replace") as file:
        assert text in file.read(), f"nobody said '{text}'"


def member_breaks(folder, whole, way, isolation):
    """Once: the run, or its resume, completes as if nothing had been."""
    fault = (way, "7")
    status = run_to_end(folder, isolation=isolation, fault=fault)
    if isolation == "process":
        assert status == 0, f"the run ended with {status}"
        same(folder, whole)
    complete(folder, whole, fault=fault)


def member_always_breaks(folder, whole, way, isolation):
    """Every time: it is set aside with its reason, the others are there, and nothing more is tried."""
    fault = ("always_" + way, "7")
    for _ in range(3):
        status = run_to_end(folder, isolation=isolation, fault=fault)
        if status == 1:
            break
    assert status == 1, f"the member is not set aside: {status}"
    said(folder, "was set aside")
    assert run_to_end(folder, isolation=isolation, fault=fault) == 1
    said(folder, "30 members reused, 0 to compute")


def process_breaks(folder, whole, victim, how, isolation, ranks, recovery):
    run = begin(folder, isolation=isolation, ranks=ranks, recovery=recovery)
    rank = 1 if victim.startswith("worker") else 0
    process, helper = pids(folder, rank)
    time.sleep(random.uniform(0.05, 0.3))
    target = run.pid if victim == "mpirun" else process
    if victim.endswith("helper"):
        target = helper
    if victim.endswith("member"):
        target = (children(helper) or [helper])[0]
    strike(target, how)
    if how == signal.SIGSTOP and victim in ("master", "mpirun"):
        time.sleep(1)  # nobody is left to notice it: somebody kills it
        strike(target, signal.SIGKILL)
    status = end(run, folder)
    if victim == "worker" and recovery:
        assert status == 0, f"the others did not go on: {status}"
        same(folder, whole)
    complete(folder, whole, isolation=isolation)


def random_kill(folder, whole, number):
    isolation = random.choice(["none", "process"])
    ranks = random.choice([1, 1, 2])
    run = begin(folder, isolation=isolation, ranks=ranks, recovery=ranks > 1 and random.random() < 0.5)
    process, helper = pids(folder, random.randrange(ranks))
    time.sleep(random.uniform(0, 0.5))
    target = random.choice([process, process, helper, *children(helper), run.pid])
    strike(target, random.choice([signal.SIGKILL, signal.SIGKILL, signal.SIGSEGV, signal.SIGABRT]))
    end(run, folder)
    if number % 3 == 2:  # a campaign is killed up to three times
        complete(folder, whole)
        for name in os.listdir(folder):
            os.remove(os.path.join(folder, name))


def cases():
    kill, stop = signal.SIGKILL, signal.SIGSTOP
    if WHAT == "members":
        for way in ("segv", "abort", "kill", "hang", "stop", "memory", "nan", "throw"):
            yield member_breaks, (way, "process")
            if way not in ("hang", "stop", "memory"):  # these would break the machine's own patience in-process
                yield member_breaks, (way, "none")
        for way in ("segv", "nan"):
            yield member_always_breaks, (way, "process")
        yield member_always_breaks, ("abort", "none")
    if WHAT == "processes":
        for isolation in ("none", "process"):
            yield process_breaks, ("master", kill, isolation, 1, False)
            yield process_breaks, ("mpirun", kill, isolation, 2, False)
            yield process_breaks, ("worker", kill, isolation, 2, False)
            yield process_breaks, ("worker", kill, isolation, 3, True)
            yield process_breaks, ("master", kill, isolation, 2, True)
        yield process_breaks, ("master", signal.SIGSEGV, "none", 2, False)
        yield process_breaks, ("worker", signal.SIGABRT, "none", 2, True)
        yield process_breaks, ("worker", stop, "none", 2, False)
        yield process_breaks, ("worker", stop, "process", 2, True)
        yield process_breaks, ("master", stop, "none", 1, False)
        for how in (kill, stop):
            yield process_breaks, ("master's member", how, "process", 1, False)
        yield process_breaks, ("master's helper", kill, "process", 1, False)
        yield process_breaks, ("worker's helper", kill, "process", 2, False)
    if WHAT == "kills":
        for number in range(int(sys.argv[4])):
            yield random_kill, (number,)


def main():
    random.seed(int(sys.argv[5]) if len(sys.argv) > 5 else 1)
    top = tempfile.mkdtemp(prefix="floes-faults-")
    failures, tried = 0, 0
    try:
        os.mkdir(os.path.join(top, "whole"))
        assert run_to_end(os.path.join(top, "whole")) == 0, "the undisturbed run fails"
        whole = os.path.join(top, "whole", "a.h5")
        folder = os.path.join(top, "work")
        for what, arguments in cases():
            if what is not random_kill:
                shutil.rmtree(folder, ignore_errors=True)
            os.makedirs(folder, exist_ok=True)
            tried += 1
            begun = time.monotonic()
            try:
                what(folder, whole, *arguments)
                verdict = "ok"
            except AssertionError as error:
                failures += 1
                verdict = f"FAILED: {error}"
                with open(os.path.join(folder, "log"), errors="replace") as file:
                    verdict += "\n" + file.read()[-3000:]
                shutil.rmtree(folder)
            print(f"{what.__name__} {' '.join(map(str, arguments))}: {verdict} ({time.monotonic() - begun:.1f} s)",
                  flush=True)
    finally:
        shutil.rmtree(top, ignore_errors=True)
    print(f"{tried} faults, {tried - failures} with the digest of the undisturbed run")
    return 1 if failures else 0


sys.exit(main())
