#!/usr/bin/python3
"""reader_test.py FLOES SYNTHETIC_FILE PROJECT: what python/floes_reader makes of campaign files, beside what floes
says of them and what h5py reads. The page docs/reading_the_file.md shows what its blocks print."""

import contextlib
import csv
import io
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

import h5py
import numpy
import pandas
from campaigns import DESIGN, EMPTY, FLOES, FULL, MOORED, PROJECT, SMOKE, run
from figures import Figures  # noqa: F401
from refusals import Refusals  # noqa: F401
from runs import Background, Dicts, Refusing  # noqa: F401
from scipy import stats

import floes_reader
from floes_reader import intervals, stored
from floes_reader.quantities import with_times


def summarize(path, part, form):
    return run(FLOES, "summarize", path, "--parts", part, "--format", form)


PARTS = {"estimate": "", "low": "_low", "high": "_high", "prediction_low": "_prediction_low",
         "prediction_high": "_prediction_high"}  # column of summary() -> what its name in `floes summarize` ends with


class Statistics(unittest.TestCase):
    def test_student_t_is_that_of_scipy(self):
        for freedom in [*range(1, 130), 999, 1000, 100_001]:
            for tail in (0.05, 0.025, 0.005):
                exceeded = stats.t.sf(intervals.student_t(freedom, tail), freedom)  # scipy's isf is good to 5e-9 only
                self.assertAlmostEqual(exceeded / tail, 1, delta=1e-12 * max(10, freedom / 100),
                                       msg=f"{freedom}, {tail}")

    def compare(self, path, parts, value_of):
        """Every figure of `floes summarize`, and no other. `value_of`: (record of a case, name) -> number or
        NaN."""
        with floes_reader.open(path) as campaign:
            summary = campaign.summary()
            shown = with_times(campaign.quantities.averaging_time.unique()[1:])
            for record in parts:
                case = record["name"]
                self.assertEqual(list(summary.loc[case].index), [one.key for one in shown])
                for one in shown:
                    for part in PARTS:
                        expected, found = value_of(record, one.key + PARTS[part]), summary.loc[(case, one.key), part]
                        numpy.testing.assert_allclose(found, expected, 1e-11, 1e-11, err_msg=f"{case} {one.key} {part}")
                about = campaign.cases.loc[case]
                for name, column in (("members", "members"), ("failed_members", "failed"),
                                     ("missing_members", "missing"), ("not_steady", "not_steady")):
                    self.assertEqual(int(record[name]), about[column], name)
            self.assertEqual([record["name"] for record in parts], list(campaign.cases.index))
            return shown

    def test_summary_is_that_of_floes(self):
        for path in (SMOKE, FULL, EMPTY, DESIGN):
            with self.subTest(path=path.name):
                cases = json.loads(summarize(path, "cases", "json"))["cases"]
                shown = self.compare(path, cases, lambda record, name: numpy.nan if record[name] is None else record[name])
                estimated = [name.removesuffix("_prediction_low") for name in cases[0] if name.endswith("_prediction_low")]
                self.assertEqual([one.key for one in shown], estimated)
                rows = list(csv.DictReader(io.StringIO(summarize(path, "cases", "csv"))))
                self.compare(path, rows, lambda record, name: float(record[name] or numpy.nan))

    def test_another_confidence(self):
        with floes_reader.open(SMOKE) as campaign:
            loads = campaign.members.query("case == 'E60'").mean_load
            found = campaign.summary(0.9).loc[("E60", "mean_load")]
        low, high = stats.t.interval(0.9, len(loads) - 1, loads.mean(), stats.sem(loads))
        numpy.testing.assert_allclose([found.low, found.high], [low, high])
        self.assertEqual(found.n, 4)


class Program(unittest.TestCase):
    """What the program is asked for, and campaigns that Python starts."""

    def test_pairs_are_those_of_floes(self):
        expected = json.loads(summarize(SMOKE, "pairs", "json"))["pairs"]
        with floes_reader.open(SMOKE) as campaign:
            pairs, of_e200 = campaign.pairs(), campaign.pairs("E200", resolve=5)
            with self.assertRaisesRegex(floes_reader.CampaignError, "no case 'E2'"):
                campaign.pairs("E2")
        self.assertEqual(pairs.to_dict("records")[0]["difference"], expected[0]["difference"])
        self.assertEqual(len(pairs), len(expected))
        self.assertEqual(set(of_e200["first"]), {"E200"})
        self.assertEqual(set(of_e200["resolve"]), {0.05})

    def test_run_computes_a_campaign_whose_design_loads_are_those_of_floes(self):
        smoke, output = PROJECT / "configs/smoke.toml", SMOKE.parent / "from_python.h5"
        changes = {"campaign.arrangements": 30, "analysis.steady_start_s": 6, "analysis.window_s": 6,
                   "analysis.peak_separation_s": 1}
        with floes_reader.run(smoke, output, set=changes) as campaign:
            self.assertTrue(campaign.complete)
            self.assertEqual(campaign.keys("E60")["analysis.window_s"], 6)
            loads, basis = (ask(exposure_h=10, rising=True, peaks=0.5)
                            for ask in (campaign.design_loads, campaign.design_basis))
            with self.assertRaisesRegex(floes_reader.CampaignError, "did you mean --exposure-h"):
                campaign.design_loads(exposure=10)
            rises = campaign.design_loads(quantile=[0.5, 0.9])
            with self.assertRaisesRegex(floes_reader.Refused, "^E60: .*so it is not known how high it gets later"):
                campaign.design_load("E60")
            quoted = campaign.design_load("E60", rising=True, exposure_h=10, peaks=0.5)
            with self.assertRaisesRegex(floes_reader.CampaignError, "^Which case. .* has E30, E60, E200"):
                campaign.design_load()
        self.assertEqual(len(rises), 3 * 3)  # cases; the expected load and two quantiles
        self.assertTrue(rises.load.isna().all() and rises.reason.str.contains("measure later", case=False).all(), rises)
        command = [FLOES, "design", output, "--format", "json", "--exposure-h", "10", "--rising", "--peaks", "0.5"]
        expected = json.loads(run(*command))["design"]["loads"]
        self.assertGreater(len(expected), 0)
        self.assertEqual(list(loads["load"]), [record["load"] for record in expected])
        self.assertEqual(set(loads.reason), {""})
        self.assertEqual(quoted.load, [one for one in expected if one["case"] == "E60" and one["figure"] == "quantile"][0]["load"])
        self.assertEqual(list(basis["exposure"]), [36000.0] * 3)
        with self.assertRaisesRegex(floes_reader.CampaignError, "did you mean campaign.arrangements"):
            floes_reader.run(smoke, output, set={"campaign.arrangement": 1}, overwrite=True)
        with floes_reader.open(SMOKE) as campaign:
            self.assertIn("too few peaks (3 of 20)", campaign.design_loads(rising=True).reason[0])


class Progress(unittest.TestCase):
    def compute(self, script, **options):
        """What floes_reader says of a program that is this shell script, and its error."""
        with tempfile.TemporaryDirectory() as folder:
            fake = pathlib.Path(folder, "floes")
            fake.write_text("#!/bin/sh\n" + script)
            fake.chmod(0o755)
            said = io.StringIO()
            with unittest.mock.patch.dict(os.environ, {"FLOES": str(fake)}), contextlib.redirect_stderr(said):
                with self.assertRaises(floes_reader.CampaignError) as error:
                    floes_reader.run("a.toml", pathlib.Path(folder, "a.h5"), **options)
        return said.getvalue(), str(error.exception)

    def test_state_is_one_line_that_is_replaced(self):
        said, error = self.compute(r"""printf 'floes: a note\n' >&2
            printf '\r\033[Kfloes: 0 of 12 done, 0 failed, 2 running, a long way to go' >&2
            printf '\r\033[Kfloes: 12 of 12 done, 0 failed, 0 running' >&2
            printf '\r\033[Kfloes: the disk is full\n' >&2
            exit 1""")
        first = "floes: 0 of 12 done, 0 failed, 2 running, a long way to go"
        second = "floes: 12 of 12 done, 0 failed, 0 running"
        self.assertEqual(said, f"floes: a note\n{first}\r{second.ljust(len(first))}\r"
                               f"{'floes: the disk is full'.ljust(len(second))}\n")
        self.assertEqual(error, "floes run ended with status 1: floes: the disk is full")

    def test_program_is_asked_for_a_live_line_and_gets_its_options(self):
        said, error = self.compute('echo "$FLOES_PROGRESS $*" >&2; exit 85', ranks=3, time_left=60, set={"a.b": [1, "c"]})
        self.assertRegex(said, r'live run a.toml -o \S+ --ranks 3 --time-left 60 --set a.b=\[1, "c"\]')
        self.assertIn("resume=True goes on", error)

    def test_ranks_of_a_run_are_mpi_s(self):
        said = io.StringIO()
        changes = {"campaign.arrangements": 1, "analysis.steady_start_s": 4, "analysis.window_s": 3}
        with contextlib.redirect_stderr(said):
            with floes_reader.run(PROJECT / "configs/smoke.toml", SMOKE.parent / "ranks.h5", set=changes, ranks=2) as made:
                self.assertEqual(list(made.sessions.ranks), [2])
        self.assertRegex(said.getvalue(), r"floes: 3 of 3 done, 0 failed, 0 running.*[\r\n]")
        self.assertNotIn("\033", said.getvalue())


class Tables(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.full, cls.smoke, cls.designed = (cls.enterClassContext(floes_reader.open(one)) for one in (FULL, SMOKE, DESIGN))

    def test_the_reader_knows_the_layout_of_floes(self):
        self.assertEqual(self.full.layout, floes_reader.LAYOUT)
        of_moored = {"parts", "responses"}  # and of hulls with parts
        self.assertEqual(set(self.full._stored.groups()) | of_moored, stored.GROUPS)

    def test_members(self):
        members = self.full.members
        self.assertEqual(list(members.status.value_counts()[["done", "failed", "missing"]]), [10, 1, 1])
        self.assertEqual(members.status[4], "failed")
        self.assertIn("ran away at 12.34 s: 11 m/s, allowed ≤ 10 m/s", members.reason[4])
        self.assertEqual(list(members.case[:4]), ["soft", "stiff", "open", "soft"])
        self.assertEqual(list(members.arrangement_number[:4]), [0, 0, 0, 1])
        self.assertEqual(list(members.steady[:5].fillna(False)), [True, False, True, False, False])
        self.assertEqual(list(members.index[members.steady.isna()]), [4, 7])
        with h5py.File(FULL) as file:
            for key in (key for key, time in self.full.quantities.averaging_time.items() if time == 0):
                numpy.testing.assert_array_equal(members[key], file["members"][key][:], key)
                missing = list(members.index[members[key].isna()])  # all: of structures that give way or turn
                self.assertIn(missing, ([4, 7], list(members.index)), key)
                self.assertEqual(self.full.quantities.units[key], file["members"][key].attrs["units"])
                self.assertEqual(self.full.quantities.long_name[key], file["members"][key].attrs["long_name"])
            numpy.testing.assert_array_equal(members["sd_maximum_0.4s"], file["averaged/sd_maximum"][:, 2])
        self.assertEqual(members.columns[6], "mean_load")
        self.assertIn("averaged over 0.4 s", self.full.quantities.long_name["sd_maximum_0.4s"])
        members.loc[:, "mean_load"] = 0.0
        self.assertEqual(self.full.members.mean_load[0], 100.1, "a table is a copy")
        self.assertFalse(self.full.complete)
        self.assertTrue(self.smoke.complete)
        self.assertEqual(repr(self.full), "<campaign synthetic: 12 members in 3 cases, 10 done, 1 failed>")

    def test_cases_and_keys(self):
        cases = self.full.cases
        self.assertEqual(list(cases.far_end), ["ice_sheet", "ice_sheet", "open"])
        self.assertEqual(list(cases.elastic_modulus), [60e6, 200e6, 200e6])
        self.assertEqual(self.full.keys("open")["field.far_end"], "open")
        self.assertEqual(self.full.keys("open")["ice.thickness_m"], 0.033)
        self.assertNotIn("name", self.full.keys("open"))
        self.assertEqual(list(self.smoke.overrides.columns), ["ice.elastic_modulus_MPa"])
        self.assertEqual(list(self.smoke.overrides["ice.elastic_modulus_MPa"]), [30, 60, 200])
        self.assertEqual(self.full.overrides["analysis.averaging_s"]["open"], [0.2, 0.4])
        self.assertEqual(self.full.configuration["campaign"]["seed"], 7)
        self.assertIsNone(self.full.design)

    def test_design_is_that_of_floes(self):
        expected = pandas.read_csv(io.StringIO(summarize(DESIGN, "points", "csv")), index_col=0)
        columns = ["base", "point", "structure.keel_radius_m", "general.time_step_s"]
        pandas.testing.assert_frame_equal(self.designed.design, expected[columns], check_dtype=False)
        self.assertNotIn("design.point", self.designed.keys("open+0.4_0.01"))

    def test_histories(self):
        history = self.full.history(3)
        numpy.testing.assert_allclose(history.surge_load, 400 * numpy.sin(0.1 * numpy.arange(110)), rtol=1e-12)
        numpy.testing.assert_allclose(history.time, 0.02 * numpy.arange(1, 111))
        self.assertEqual(history.attrs, {"case": "soft", "steady_start": 1.0, "member": 3, "arrangement": 2})
        self.assertEqual((history.heave_load.attrs["units"], history.time.attrs["units"]), ("N", "s"))
        self.assertEqual(self.full.history(2).sizes["time"], 100)  # its case ends earlier
        of_case = self.full.histories("stiff")
        self.assertEqual(list(of_case.member.values), [1, 10])  # 4 failed, 7 is missing
        numpy.testing.assert_array_equal(of_case.sway_load[1], self.full.history(10).sway_load)
        with floes_reader.open(EMPTY) as empty:
            self.assertEqual(empty.histories("open").sizes, {"member": 0, "time": 0})

    def test_histories_of_a_moored_structure_share_their_time(self):
        with floes_reader.open(MOORED) as moored, h5py.File(MOORED) as file:
            history, group = moored.history(1), moored.group("history")
            self.assertEqual(history.sizes, {"time": 350})
            for name in ("surge_mooring", "sway_offset", "structure_yaw"):
                numpy.testing.assert_array_equal(history[name], file["history"][name][1])
            for found in (history.surge_load - history.surge_mooring, (group.surge_load - group.surge_mooring)[1]):
                numpy.testing.assert_array_equal(found, file["history/surge_load"][1] - file["history/surge_mooring"][1])
            self.assertEqual(history.surge_offset.attrs["units"], "m")
        quantities = {"surge_load", "sway_load", "heave_load", "concentration", "pile_height", "pile_draught"}
        self.assertEqual(set(self.full.history(3)), quantities)
        self.assertRegex(floes_reader.__version__, r"^\d+\.\d+\.\d+$")

    def test_times_of_cases_that_differ_in_their_steps(self):
        for case, about in self.designed.cases.iterrows():
            loads = self.designed.histories(case).surge_load
            self.assertEqual(loads.attrs["units"], "N")
            numpy.testing.assert_allclose(loads.time, 2 * about.time_step * numpy.arange(1, loads.sizes["time"] + 1))
            self.assertAlmostEqual(float(loads.time[-1]), 4)
            means = loads.where(loads.time > about.steady_start + about.time_step, drop=True).mean("time")
            numpy.testing.assert_allclose(means, self.designed.members.mean_load[means.member], rtol=1e-9)

    def test_breaks(self):
        breaks = self.full.breaks
        with h5py.File(FULL) as file:
            for name in ("member", "time", "floe", "joint"):
                numpy.testing.assert_array_equal(breaks[name], file["breaks"][name][:])
        modes = ["bending", "shear", "compression", "tension", "torsion", "in_plane_bending"]
        self.assertEqual(list(breaks["mode"]), [modes[(member + k) % 6] for member in range(12) if member not in (4, 7)
                                                for k in range(member % 4)])
        self.assertEqual(list(breaks.case[:3]), ["stiff", "open", "open"])
        bending = self.smoke.breaks.query("mode == 'bending'").groupby("member").size()
        self.assertGreater(bending.sum(), 0)
        found = self.smoke.members.failures_bending
        self.assertEqual(bending.reindex(found.index, fill_value=0).tolist(), found.tolist())

    def test_averaged_and_peaks(self):
        averaged, peaks = self.full.averaged, self.full.peaks
        self.assertEqual(float(averaged.mean_maximum.sel(member=3, averaging_time=0.4)), 404)
        self.assertEqual(averaged.sd_load.attrs["units"], "N")
        self.assertEqual(list(averaged.case_name.values[:3]), ["soft", "stiff", "open"])
        own = peaks[(peaks.member == 8) & (peaks.averaging_time == 0.2)]
        numpy.testing.assert_allclose(own.load, [900.4, 900.3, 900.2], rtol=1e-12)
        self.assertEqual(set(own.case), {"open"})
        self.assertEqual(len(peaks), numpy.isfinite(averaged.peaks).sum())

    def test_exceedance_is_that_of_floes(self):
        levels = json.loads(summarize(FULL, "exceedance", "json"))["load_levels"]
        self.assertGreater(len(levels), 3)
        means = self.full.exceedance.groupby("case_name").mean()
        for row in levels:
            found = means.sel(case_name=row["case"], level=row["level"])
            self.assertAlmostEqual(float(found.time_above), row["time_above"], delta=1e-12)
            self.assertAlmostEqual(float(found.upcrossings_per_s), row["upcrossings_per_s"], delta=1e-12)
        self.assertIsNone(self.smoke.exceedance)

    def test_load_map(self):
        found = self.smoke.load_map
        means = self.smoke.members.mean_load
        numpy.testing.assert_allclose(found.surge_load.sum(["height", "angle"]), means, rtol=1e-9)
        numpy.testing.assert_allclose(found.surge_load_along_tow.mean("tow"), means, rtol=1e-9)
        self.assertEqual(found.angle.attrs["units"], "degree")

    def test_provenance(self):
        self.assertEqual(self.full.provenance["seed"], 7)
        self.assertEqual(self.full.provenance["software"], "floes")
        self.assertEqual(list(self.full.sessions.ranks), [2, 1])
        self.assertEqual(self.full.sessions.started[0], "2026-01-01T10:00:00Z")
        costs = self.full.costs
        self.assertEqual((costs.wall_time[2], costs.host[1], costs.attempts[7]), (14.5, "node1", 0))
        pose = self.full.group("arrangements").pose.sel(arrangement=2, floe=1)
        self.assertEqual(list(pose.coordinate.values), ["x", "z", "yaw"])
        numpy.testing.assert_allclose(pose, [7.1, 0.8, 0.01])

    def test_a_file_without_results(self):
        with floes_reader.open(EMPTY) as campaign:
            self.assertTrue((campaign.members.status == "missing").all())
            self.assertTrue(campaign.members.mean_load.isna().all())
            self.assertEqual((len(campaign.breaks), len(campaign.peaks), len(campaign.summary())), (0, 0, 87))


class Page(unittest.TestCase):
    def test_blocks_print_what_the_page_shows(self):
        script = PROJECT / "docs/figures/python_page.py"
        page = subprocess.run(["/usr/bin/python3", script, SMOKE], capture_output=True, text=True)
        self.assertEqual(page.returncode, 0, page.stdout + page.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
