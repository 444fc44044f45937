#!/usr/bin/python3
"""Which process breaks, when, and how: every ending is the file of an undisturbed run.

    matrix.py FAULTY MPIEXEC members|processes|writers|kills [COUNT [SEED]]

members    one member breaks in every way, in its rank's process and in its own
processes  a rank, a helper, a member's process, mpirun are killed or stopped in the middle
writers    likewise, where two ranks keep the results
kills      COUNT kills at random moments of random processes, resumed each time
"""
import os
import random
import shutil
import signal
import sys
import tempfile
import time

from faulty_runs import begin, children, complete, end, pids, run_to_end, said, same, strike

WHAT = sys.argv[3]


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


def process_breaks(folder, whole, victim, how, isolation, ranks, recovery, writers=1, resumed_with=None):
    """With two writers the second half of the ranks has the first of them as its writer."""
    rank = 1 if victim.startswith("worker") else 0
    if victim.startswith("writer"):
        rank = ranks // 2
    if victim.startswith("writer's worker"):
        rank = ranks - 1
    while True:
        run = begin(folder, isolation=isolation, ranks=ranks, recovery=recovery, writers=writers)
        process, helper = pids(folder, rank)
        # Others go on only without a rank that had said hello: a run that lacks one from its start ends.
        if writers == 1 and not recovery:
            time.sleep(random.uniform(0.05, 0.3))
            break
        if keeps_members(run, os.path.join(folder, "a.journal.1" if writers > 1 else "a.journal")):
            time.sleep(random.uniform(0, 0.05))
            break
        complete_alone(run, folder, whole)
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
    if victim in ("worker", "writer", "writer's worker") and recovery:
        assert status == 0, f"the others did not go on: {status}"
        same(folder, whole)
    if victim == "writer" and recovery and ranks > 2:
        said(folder, "since it kept their results")
    complete(folder, whole, isolation=isolation, **(resumed_with or {}))


def keeps_members(run, journal):
    """Waits until the journal has some; false where the run ended before that was seen."""
    while run.poll() is None:
        try:
            if os.path.getsize(journal) > 30000:
                return True
        except FileNotFoundError:
            pass
        time.sleep(0.005)
    return False


def complete_alone(run, folder, whole):
    """It was quicker than who would strike it; the folder is empty again."""
    assert end(run, folder) == 0, "a run that nobody disturbed fails"
    same(folder, whole)
    shutil.rmtree(folder)
    os.mkdir(folder)


def random_kill(folder, whole, number):
    isolation = random.choice(["none", "process"])
    ranks = random.choice([1, 1, 2])
    writers = random.randint(1, ranks)
    run = begin(folder, isolation=isolation, ranks=ranks, recovery=ranks > 1 and random.random() < 0.5, writers=writers)
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
    if WHAT == "writers":
        for victim in ("master", "writer", "writer's worker", "mpirun"):
            yield process_breaks, (victim, kill, "none", 4, False, 2)
        for victim in ("writer", "writer's worker"):
            yield process_breaks, (victim, kill, "none", 4, True, 2)
        yield process_breaks, ("master", kill, "none", 4, True, 2)
        yield process_breaks, ("writer", kill, "process", 2, True, 2)
        yield process_breaks, ("writer", stop, "none", 4, True, 2)
        yield process_breaks, ("writer's helper", kill, "process", 2, False, 2)
        for others in ({"ranks": 2}, {"ranks": 3, "writers": 3}, {"ranks": 4, "writers": 2}):
            yield process_breaks, ("writer", kill, "none", 4, False, 2, others)
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
