"""Runs of the program `faulty`, with fake members of some milliseconds, and what must hold when they end."""
import os
import signal
import subprocess
import sys
import time

FAULTY, MPIEXEC = sys.argv[1:3]
MPIRUN = [MPIEXEC, "--allow-run-as-root", "--oversubscribe", "--bind-to", "none"]
ENV = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
PATIENCE = 100  # s; a run takes one, and one whose rank is stopped at its very end a minute


def command(folder, isolation="none", ranks=1, recovery=False, fault=(), program=None, writers=0):
    launcher = MPIRUN + (["--enable-recovery"] if recovery else []) + ["-n", str(ranks)] if ranks > 1 else []
    return [*launcher, *(program or [FAULTY, folder, "a.h5", isolation, f"2/{writers}", *fault])]


def begin(folder, output="log", popen=None, **how):
    """`output`: the file in the folder that gets what the run says; `popen`: more arguments of Popen. `program` runs in
    place of `faulty`; it, too, writes its process number into FOLDER/rankN."""
    for name in os.listdir(folder):
        if name.startswith("rank"):
            os.remove(os.path.join(folder, name))
    with open(os.path.join(folder, output), "ab") as log:
        return subprocess.Popen(command(folder, **how), **{"env": ENV, **(popen or {})}, stdout=log, stderr=log,
                                start_new_session=True)


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


def complete(folder, whole, **how):
    status = run_to_end(folder, **how)
    assert status == 0, f"the resumed run ended with {status}"
    same(folder, whole)


def said(folder, text):
    with open(os.path.join(folder, "log"), errors="replace") as file:
        assert text in file.read(), f"nobody said '{text}'"
