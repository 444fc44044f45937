#!/usr/bin/python3
"""A thousand disturbances of campaigns: every one ends with the digest of an undisturbed run, or with a sentence that
says what is damaged.

    soak.py FAULTY MPIEXEC [COUNT [SEED]]

Each campaign is disturbed up to three times, in ways drawn at random, resumed each time, and completed:
killed at a random moment; stopped and continued; its disk full; its folder read-only, or moved under it; its journal
torn or a byte of it flipped; its campaign file damaged; the clock set by years, before or during the run; a second run
started into the same file.
"""
import collections
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

from faulty_runs import ENV, begin, children, command, complete, end, pids, run_to_end, strike

ALLOWED = (0, 1, 85)  # complete; the run failed or members were set aside; stopped


def a_run(folder, **how):
    """A run of a random kind, under way."""
    ranks = random.choice([1, 1, 1, 2])
    run = begin(folder, isolation=random.choice(["none", "process"]), ranks=ranks, writers=random.randint(1, ranks),
                recovery=ranks > 1 and random.random() < 0.5, **how)
    process, helper = pids(folder, random.randrange(ranks))
    return run, process, helper


def a_moment(longest=0.5):
    time.sleep(random.uniform(0, longest))


def killed(folder):
    run, process, helper = a_run(folder)
    a_moment()
    target = random.choice([process, process, helper, *children(helper), run.pid])
    strike(target, random.choice([signal.SIGKILL, signal.SIGKILL, signal.SIGSEGV, signal.SIGABRT]))
    end(run, folder)


def stopped_and_continued(folder):
    run, process, helper = a_run(folder)
    a_moment(0.3)
    target = random.choice([process, helper, run.pid])
    strike(target, signal.SIGSTOP)
    a_moment(0.4)
    strike(target, signal.SIGCONT)
    status = end(run, folder)
    assert status in ALLOWED, f"a run that was stopped and continued ended with {status}"


def asked_to_stop(folder):
    run, _, _ = a_run(folder)
    a_moment(0.3)
    strike(run.pid, signal.SIGTERM)
    end(run, folder)


def disk_full(folder):
    """A limit on the size of files stands for the disk."""
    size = random.randrange(1, 20000)
    limited = dict(preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size)),
                   restore_signals=False)  # SIGXFSZ stays ignored, so that a write fails as on a full disk
    status = end(begin(folder, output="disk", popen=limited), folder)
    assert status in (0, 1, 2), f"a run with a full disk ended with {status}"
    if status:
        says(folder, "disk", "Is the disk full")


def read_only(folder):
    """As a file system that cannot be written any more; the run and its ranks see it so, and nobody else."""
    mounted = ["unshare", "--mount", "sh", "-c", f"mount --bind {folder} {folder} && mount -o remount,ro,bind {folder} && "
               'exec "$@"', "sh"]
    if os.getuid() != 0:
        mounted = []  # without root a folder without write permission does it
        os.chmod(folder, 0o555)
    with open(folder + ".log", "wb") as log:
        status = subprocess.run([*mounted, *command(folder)], env=ENV, stdout=log, stderr=log).returncode
    os.chmod(folder, 0o755)
    assert status in (1, 2), f"a run in a read-only folder ended with {status}"
    shutil.move(folder + ".log", os.path.join(folder, "read_only"))
    says(folder, "read_only", "cannot be written", "cannot be opened")


def folder_moved(folder):
    run, _, _ = a_run(folder)
    a_moment(0.3)
    moved = folder + ".moved"
    os.rename(folder, moved)
    status = end(run, moved)
    assert status in (0, 1, 2, 85), f"a run whose folder was moved ended with {status}"
    if os.path.isdir(folder):
        assert not os.path.exists(os.path.join(folder, "a.journal")), "a journal was begun where the folder had been"
        shutil.rmtree(folder)
    os.rename(moved, folder)


def journal_of(folder):
    """The journal, or a piece of it."""
    paths = [os.path.join(folder, name) for name in ("a.journal", "a.journal.1")]
    return random.choice([path for path in paths if os.path.exists(path) and os.path.getsize(path)] or [None])


def journal_torn(folder):
    killed(folder)
    if path := journal_of(folder):
        os.truncate(path, random.randrange(os.path.getsize(path)))


def flip(path):
    """A random bit of the file."""
    with open(path, "r+b") as file:
        place = random.randrange(os.path.getsize(path))
        file.seek(place)
        byte = file.read(1)[0]
        file.seek(place)
        file.write(bytes([byte ^ 1 << random.randrange(8)]))


def journal_flipped(folder):
    """The campaign is completed, or the header is damaged, which is said, and the journal stays as it is."""
    killed(folder)
    path = journal_of(folder)
    if not path:
        return
    shutil.copy(path, path + ".good")
    flip(path)
    with open(path, "rb") as file:
        flipped = file.read()
    status = end(begin(folder, output="flipped"), folder)
    if status == 2:
        with open(path, "rb") as file:
            assert file.read() == flipped, "a journal that was refused was changed"
        says(folder, "flipped", "damaged", "is not a journal of floes", "is a journal of schema")
        shutil.copy(path + ".good", path)
    else:
        assert status == 0, f"a run with a flipped bit in its journal ended with {status}"


def campaign_file_damaged(folder):
    """The file is made from the journal; whatever it was before counts for nothing."""
    killed(folder)
    path = os.path.join(folder, "a.h5")
    if os.path.exists(path):
        random.choice([flip, lambda one: os.truncate(one, os.path.getsize(one) // 2), os.remove])(path)


def clock_set(folder):
    """Before the run by up to ten years, and during it by as much."""
    rate = os.path.join(folder, "clock")

    def set_clock():
        with open(rate + ".new", "w") as file:
            file.write(f"{random.choice('+-')}{random.randrange(10 * 365)}d\n")
        os.rename(rate + ".new", rate)

    set_clock()
    faked = dict(ENV, LD_PRELOAD=FAKETIME, FAKETIME_TIMESTAMP_FILE=rate, FAKETIME_NO_CACHE="1",
                 FAKETIME_DONT_FAKE_MONOTONIC="1")
    run = begin(folder, popen=dict(env=faked))
    for _ in range(random.randrange(3)):
        a_moment(0.2)
        set_clock()
    if random.random() < 0.5:
        strike(run.pid, signal.SIGKILL)
    status = end(run, folder)
    assert status in (0, -signal.SIGKILL), f"a run whose clock was set ended with {status}"


def two_runs(folder):
    run, _, _ = a_run(folder)
    for _ in range(400):
        if journal_of(folder) or run.poll() is not None:
            break
        time.sleep(0.005)
    second = subprocess.run(command(folder), env=ENV, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    first = end(run, folder)
    if second.returncode == 2:
        assert "is being written by another run" in second.stdout, "the second run does not say why: " + second.stdout
    assert second.returncode in (0, 2) and first in (0, 2), f"two runs ended with {first} and {second.returncode}"


def says(folder, log, *any_of):
    with open(os.path.join(folder, log), errors="replace") as file:
        text = file.read()
    assert any(words in text for words in any_of), f"nobody said '{any_of[0]}': {text}"


WAYS = {killed: 12, stopped_and_continued: 2, asked_to_stop: 1, disk_full: 2, read_only: 1, folder_moved: 1,
        journal_torn: 2, journal_flipped: 2, campaign_file_damaged: 1, clock_set: 1, two_runs: 1}
FAKETIME = next((os.path.join(root, "libfaketimeMT.so.1") for root, _, files in os.walk("/usr/lib")
                 if "libfaketimeMT.so.1" in files), None)


def main():
    count = int(sys.argv[3]) if len(sys.argv) > 3 else 1000
    random.seed(int(sys.argv[4]) if len(sys.argv) > 4 else 1)
    ways = {way: weight for way, weight in WAYS.items() if way is not clock_set or FAKETIME}
    top = tempfile.mkdtemp(prefix="floes-soak-")
    tried, failed = collections.Counter(), collections.Counter()
    try:
        os.mkdir(os.path.join(top, "whole"))
        assert run_to_end(os.path.join(top, "whole")) == 0, "the undisturbed run fails"
        whole = os.path.join(top, "whole", "a.h5")
        folder = os.path.join(top, "work")
        os.mkdir(folder)
        disturbed = []
        while sum(tried.values()) < count:
            way = random.choices(list(ways), list(ways.values()))[0]
            tried[way.__name__] += 1
            disturbed.append(way.__name__)
            try:
                way(folder)
                if len(disturbed) == 3:
                    complete(folder, whole)
            except AssertionError as error:
                failed[way.__name__] += 1
                log = os.path.join(folder, "log")
                said_last = open(log, errors="replace").read()[-2000:] if os.path.exists(log) else ""
                print(f"FAILED after {', '.join(disturbed)}: {error}\n{said_last}", flush=True)
                disturbed = [None] * 3
            if len(disturbed) == 3:
                shutil.rmtree(folder, ignore_errors=True)
                os.mkdir(folder)
                disturbed = []
            if sum(tried.values()) % 100 == 0:
                print(f"{sum(tried.values())} of {count}", flush=True)
        if disturbed:
            complete(folder, whole)
    finally:
        shutil.rmtree(top, ignore_errors=True)
    for name in sorted(tried, key=lambda name: -tried[name]):
        print(f"{name.replace('_', ' ')}: {tried[name]}, failed {failed[name]}")
    print(f"{sum(tried.values())} disturbances, {sum(failed.values())} failed")
    return 1 if failed else 0


sys.exit(main())
