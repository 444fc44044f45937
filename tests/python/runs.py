"""Campaigns that Python starts: what the program refuses, what is known of a run under way, and how it ends."""

import contextlib
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import tomllib
import unittest
import unittest.mock

import h5py
import numpy
from campaigns import FLOES, FOLDER, PROJECT, SITE, SMOKE, run

import floes_reader
from floes_reader import program
from floes_reader.toml_text import toml_text

TWO = {"campaign.arrangements": 2}  # of three cases
CONFIGURATION = PROJECT / "configs/smoke.toml"
IN_PYTHON = f"""
import sys, time
sys.path.insert(0, {str(SITE)!r})
import floes_reader
run = floes_reader.start({str(CONFIGURATION)!r}, sys.argv[1], {TWO}, threads=1, outlives=sys.argv[2] == "outlives")
while run.progress.done < 1: time.sleep(0.05)
print(run._process.pid, flush=True)
if sys.argv[2] == "killed": sys.stdin.read()
"""


def tables():
    return tomllib.loads(CONFIGURATION.read_text(encoding="utf-8"))


def datasets(path):
    """Bytes of every dataset that is no provenance, by its name."""
    found = {}

    def keep(name, one):
        if isinstance(one, h5py.Dataset) and not name.startswith("provenance"):
            values = one.asstr()[()] if h5py.check_string_dtype(one.dtype) else one[()]
            found[name] = values.tolist() if values.dtype == object else values.tobytes()

    with h5py.File(path) as file:
        file.visititems(keep)
    return found


def lives(pid):
    with contextlib.suppress(ProcessLookupError):
        os.kill(pid, 0)
        return "\nState:\tZ" not in pathlib.Path(f"/proc/{pid}/status").read_text()
    return False


class InAFolder(unittest.TestCase):
    def setUp(self):
        made = self.enterContext(tempfile.TemporaryDirectory(dir=FOLDER))
        self.folder = pathlib.Path(made, "a folder with 'spaces'")
        self.folder.mkdir()

    def started(self, name, **options):
        """Of the smoke campaign, on one thread, with a member done."""
        made = floes_reader.start(CONFIGURATION, self.folder / name, TWO, threads=1, **options)
        self.addCleanup(made.stop)
        while made.progress.done < 1:
            self.assertIsNone(made.poll(), made.messages)
        return made


class Dicts(InAFolder):
    def test_text_is_read_back_as_it_was(self):
        hostile = {"a": "é \\ \" \n \x7f \x01 🌊", "b c": [1, 2.5, True, [], ["x"]], "": {"'": {"deep": [{"x": 1}]}},
                   "case": [{"name": "1", "floe": {"size": 1e-7}}, {"name": "2"}], "none": [], "table": {}}
        self.assertEqual(tomllib.loads(toml_text(hostile)), hostile)
        of_numpy = {"campaign": {"arrangements": numpy.int64(4)}, "general": {"time_step_s": numpy.float32(0.5)},
                    "structure": {"profile_m": numpy.eye(2)}, "x": (numpy.bool_(True), pathlib.Path("a b.stl"))}
        plain = {"campaign": {"arrangements": 4}, "general": {"time_step_s": 0.5},
                 "structure": {"profile_m": [[1.0, 0.0], [0.0, 1.0]]}, "x": [True, "a b.stl"]}
        self.assertEqual(tomllib.loads(toml_text(of_numpy)), plain)
        self.assertEqual(tomllib.loads(toml_text({"ice.thickness_m": 0.03})), {"ice": {"thickness_m": 0.03}})
        with self.assertRaisesRegex(TypeError, "no NoneType: None"):
            toml_text({"ice": {"thickness_m": None}})

    def test_a_dict_is_run_as_its_file_is(self):
        own = tables()
        own["campaign"]["arrangements"] = numpy.int64(1)
        with floes_reader.start(own, self.folder / "dict.h5").wait() as campaign:
            self.assertEqual(campaign.keys("E60")["ice.elastic_modulus_MPa"], 60)
            loads = campaign.members.mean_load
        with floes_reader.open(SMOKE) as smoke:
            numpy.testing.assert_array_equal(loads, smoke.members.mean_load[:3])
        subprocess.run([FLOES, "config", "--check", self.folder / "dict.toml"], check=True, stdout=subprocess.DEVNULL)

    def test_a_file_of_somebody_else_is_not_replaced(self):
        mine = self.folder / "mine.toml"
        mine.write_text("[campaign]\n")
        with self.assertRaisesRegex(floes_reader.CampaignError, "mine.toml is not from a dict"):
            floes_reader.start(tables(), self.folder / "mine.h5")
        self.assertEqual(mine.read_text(), "[campaign]\n")


class Refusing(InAFolder):
    def refused(self, words, configuration, by_start=True, **options):
        """By start() itself, or by the run that it starts. Its sentences."""
        with self.assertRaises(floes_reader.Refused) as caught:
            started = floes_reader.start(configuration, self.folder / "bad.h5", **options)
            self.addCleanup(started.stop)
            if not by_start:
                started.wait()
        self.assertIn(words, str(caught.exception))
        self.assertFalse((self.folder / "bad.h5").exists())
        return caught.exception.sentences

    def test_configurations_before_anything_is_computed(self):
        wrong = self.folder / "wrong.toml"
        wrong.write_text('[ice]\nthicknes_m = 3\nthickness_m = "a"\n')
        sentences = self.refused("did you mean ice.thickness_m?", wrong)
        self.assertEqual([one.partition(" = ")[0] for one in sentences],
                         [f"{wrong}:2: ice.thicknes_m", f"{wrong}:3: ice.thickness_m"])
        self.refused("bad.toml:4: ice.thicknes_m = 3 is not a key", {"ice": {"thicknes_m": 3}})
        self.refused("did you mean campaign.arrangements", CONFIGURATION, set={"campaign.arrangement": 1})
        self.refused("none.toml: this file cannot be read", self.folder / "none.toml")
        self.refused("none: this file cannot be read", "none", by_start=False)

    def test_words_and_outputs(self):
        self.refused("did you mean --threads?", CONFIGURATION, by_start=False, thread=1)
        with self.started("bad.h5") as begun:
            begun.stop()
            with self.assertRaisesRegex(floes_reader.Refused, "^.*bad.h5 exists already: --resume continues it"):
                floes_reader.start(CONFIGURATION, begun.path).wait()

    def test_the_last_thing_that_was_said(self):
        said = "floes: a note\nfloes: a.toml:1: one\na.toml:2: two\n" + "-" * 74 + "\nmpirun noticed\n"
        self.assertEqual(program.sentences_of(said), ("a.toml:1: one", "a.toml:2: two"))

    def test_no_call_builds(self):
        clone = self.folder / "clone"
        shutil.copytree(SITE / "floes_reader", clone / "python/floes_reader")
        shutil.copy(PROJECT / "floes", clone)
        script = ("import floes_reader\ntry: floes_reader.open(r'%s').design_loads()\n"
                  "except floes_reader.Refused as error: print(error)" % SMOKE)
        bare = {"PATH": "/usr/bin:/bin", "PYTHONPATH": str(clone / "python"), "PYTHONDONTWRITEBYTECODE": "1"}
        told = subprocess.run(["/usr/bin/python3", "-c", script], env=bare, capture_output=True, text=True)
        self.assertIn("is not built yet, and FLOES_BUILD=never allows no build here", told.stdout, told.stderr)
        self.assertIn(f"build it in a terminal, which takes some minutes at first: {clone}/floes version", told.stdout)
        self.assertFalse((clone / "build/release").exists())

    def test_an_older_campaign_is_not_the_result_of_a_run_that_broke_off(self):
        old = self.folder / "old.h5"
        shutil.copy(SMOKE, old)
        broken = self.folder / "floes"
        broken.write_text("#!/bin/sh\necho 'floes: old.h5 cannot be written (No space left on device).' >&2\nexit 1\n")
        broken.chmod(0o755)
        with unittest.mock.patch.dict(os.environ, {"FLOES": str(broken)}):
            with self.assertRaisesRegex(floes_reader.CampaignError, "status 1: floes: old.h5 cannot be written"):
                floes_reader.run(CONFIGURATION, old, resume=True, set={"campaign.arrangements": 200})

    def test_a_program_that_is_none(self):
        with unittest.mock.patch.dict(os.environ, {"FLOES": "/none/floes"}):
            with self.assertRaisesRegex(floes_reader.CampaignError, "FLOES names /none/floes, which is no program"):
                floes_reader.start(CONFIGURATION, self.folder / "a.h5")


class Background(InAFolder):
    @classmethod
    def setUpClass(cls):
        whole = FOLDER / "whole.h5"
        run(FLOES, "run", CONFIGURATION, "-o", whole, "--set", "campaign.arrangements=2")
        cls.whole = datasets(whole)

    def test_progress_goes_up_while_nothing_waits(self):
        under_way = self.started("a.h5")
        seen = [under_way.progress]
        with self.assertRaisesRegex(TimeoutError, r"a.h5 is still under way: \d+ of 6 done, 0 failed"):
            under_way.wait(timeout=0.01)
        self.assertIn("under way, ", repr(under_way))
        while under_way.poll() is None:
            seen.append(under_way.progress)
            time.sleep(0.1)
        self.assertEqual({one.of for one in seen}, {6})
        done = [one.done for one in seen]
        self.assertEqual(done, sorted(done))
        self.assertGreater(len(set(done)), 3, done)
        self.assertTrue(any(one.seconds_left for one in seen))
        self.assertEqual(under_way.progress[:3], (6, 0, 6))
        with under_way.wait() as campaign:
            self.assertTrue(campaign.complete)
        self.assertIn("ended with status 0", repr(under_way))

    def test_stopped_and_resumed_it_has_the_same_bits(self):
        under_way = self.started("stopped.h5")
        under_way.stop()
        self.assertEqual(under_way.poll(), program.STOPPED)
        self.assertLess(under_way.progress.done, 6)
        with self.assertRaisesRegex(floes_reader.CampaignError, "resume=True goes on with .*stopped.h5"):
            under_way.wait()
        with under_way.campaign as campaign:
            self.assertFalse(campaign.complete)
        floes_reader.start(CONFIGURATION, under_way.path, set=TWO, resume=True).wait().close()
        self.assertEqual(datasets(under_way.path), self.whole)

    def test_killed_it_says_so_and_is_resumed(self):
        under_way = self.started("killed.h5")
        os.kill(under_way._process.pid, signal.SIGKILL)
        with self.assertRaisesRegex(floes_reader.CampaignError, "ended by SIGKILL; resume=True goes on"):
            under_way.wait()
        floes_reader.start(CONFIGURATION, under_way.path, set=TWO, resume=True).wait().close()
        self.assertEqual(datasets(under_way.path), self.whole)

    def test_two_side_by_side(self):
        first, second = (self.started(name) for name in ("first.h5", "second.h5"))
        first.stop()
        self.assertIsNone(second.poll())
        with second.wait() as campaign:
            self.assertTrue(campaign.complete)
        self.assertEqual(first.poll(), program.STOPPED)

    def test_a_block_that_ends_stops_it(self):
        with self.started("block.h5") as under_way:
            self.assertIsNone(under_way.poll())
        self.assertEqual(under_way.poll(), program.STOPPED)

    def in_python(self, how):
        """A Python of its own that starts a run: its process, and the run's."""
        command = ["/usr/bin/python3", "-c", IN_PYTHON, self.folder / f"{how}.h5", how]
        python = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                  text=True)
        self.addCleanup(python.communicate)
        return python, int(python.stdout.readline())

    def ends_soon(self, pid):
        until = time.monotonic() + 60
        while lives(pid) and time.monotonic() < until:
            time.sleep(0.05)
        return not lives(pid)

    def test_it_does_not_outlive_a_python_that_ends(self):
        python, pid = self.in_python("ends")
        self.assertIn("ends.h5 is stopped, since Python ends; resume=True goes on", python.communicate()[1])
        self.assertFalse(lives(pid))

    def test_it_does_not_outlive_a_python_that_is_killed(self):
        python, pid = self.in_python("killed")
        self.assertTrue(lives(pid))
        python.kill()
        self.assertTrue(self.ends_soon(pid))
        with floes_reader.start(CONFIGURATION, self.folder / "killed.h5", set=TWO, resume=True).wait() as campaign:
            self.assertEqual(list(campaign.sessions.outcome)[-1], "complete")
            self.assertEqual(campaign.sessions.outcome[0], "stopped")

    def test_an_interrupted_call_of_run_stops_it(self):
        path = self.folder / "interrupted.h5"
        script = f"import sys; sys.path.insert(0, {str(SITE)!r}); import floes_reader; floes_reader.run(*sys.argv[1:])"
        python = subprocess.Popen(["/usr/bin/python3", "-c", script, CONFIGURATION, path], stderr=subprocess.PIPE, text=True)
        self.addCleanup(python.wait)
        while not path.with_suffix(".journal").exists() or program.ask("status", path)["done"] < 1:
            self.assertIsNone(python.poll())
            time.sleep(0.05)
        python.send_signal(signal.SIGINT)
        said = python.communicate()[1]
        self.assertIn("stopped by SIGTERM", said)
        self.assertTrue(said.rstrip().endswith("KeyboardInterrupt"), said)
        self.assertFalse(program.ask("status", path)["at_work"])

    def test_unless_it_is_asked_to(self):
        python, pid = self.in_python("outlives")
        python.communicate()
        self.assertTrue(lives(pid))
        self.assertTrue(self.ends_soon(pid))
        with floes_reader.open(self.folder / "outlives.h5") as campaign:
            self.assertTrue(campaign.complete)
