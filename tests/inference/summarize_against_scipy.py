#!/usr/bin/python3
"""summarize_against_scipy.py FLOES CONFIG: runs the campaign of CONFIG, reads its file with h5py, computes with scipy what
`floes summarize --format json` prints, and compares. Nothing here knows how floes computes.

    summarize_against_scipy.py FLOES --file CAMPAIGN.h5     the same for a campaign that has been run"""

import json
import os
import re
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy as np
from scipy import stats

QUANTITIES = ["mean_load", "sd_load", "maximum_load", "mean_maximum", "sd_maximum", "failure_ratio", "failures_bending",
              "failures_shear", "failures_compression", "failures_tension", "failures_torsion",
              "failures_in_plane_bending"]
LOADS = ("_load", "_maximum")
POSITIVE = ["maximum_load", "mean_maximum"]  # single runs on a logarithmic scale
LEAST = {"mean_load": -np.inf, "maximum_load": -np.inf, "mean_maximum": -np.inf}
MOST = {"failure_ratio": 1}
TIGHT = 1e-9
np.seterr(all="ignore")  # of scipy's noncentral t at sizes far from the answer
FLOES = sys.argv[1]


def close(a, b, tolerance=TIGHT):
    return abs(a - b) <= tolerance * max(1, abs(a), abs(b))


def mser(load):
    batch = -(-len(load) // 50)
    means = load[: len(load) // batch * batch].reshape(-1, batch).mean(axis=1)
    errors = [np.sum((means[d:] - means[d:].mean()) ** 2) / (len(means) - d) ** 2 for d in range(len(means) // 2 + 1)]
    best = int(np.argmin(errors))
    return None if best == len(means) // 2 else batch * best


def steady_by_members(loads):
    """MSER of the mean, or the first fiftieth after it from which the members' load is not seen to change."""
    mean = loads.mean(axis=0)
    start = mser(mean)
    if start is None:
        return None
    parts = np.array([part_means(load, 50) for load in loads])
    part = len(mean) / 50
    first = int(np.ceil(start / part - 1e-9))
    for k in range(first, 25):
        if not has_trend(parts[:, k:]):
            return start if k == first else k * part
    return start if first >= 25 and not has_trend(parts[:, first:]) else None


def part_means(load, count):
    ends = np.linspace(0, len(load), count + 1)
    sums = np.interp(ends, np.arange(len(load) + 1), np.concatenate([[0], np.cumsum(load)]))
    return np.diff(sums) / np.diff(ends)


def has_trend(parts):
    count = parts.shape[1]
    changes = np.array([stats.linregress(np.arange(count), one).slope * count for one in parts])
    if len(changes) < 3:
        return False
    half = stats.t.ppf(0.975, len(changes) - 1) * stats.sem(changes)
    return abs(changes.mean()) - half > 0.1 * abs(parts.mean())


def far_from_the_others(values, both):
    """How many, by Rosner's test at 1 %: one-sided upwards or two-sided."""
    left, found = np.sort(values), 0
    for k in range(len(values) // 4 if len(values) >= 5 else 0):
        n = len(left)
        departures = (left - left.mean()) / left.std(ddof=1)
        upper = not both or departures[-1] >= -departures[0]
        t = stats.t.isf(0.01 / (2 * n if both else n), n - 2)
        if abs(departures[-1 if upper else 0]) > (n - 1) * t / np.sqrt((n - 2 + t * t) * n):
            found = k + 1
        left = left[:-1] if upper else left[1:]
    return found


def effective_samples(load):
    means = load[: len(load) // 5 * 5].reshape(-1, 5).mean(axis=1)
    deviations = means - means.mean()
    tau = 1
    for lag in range(1, len(means)):
        tau += 2 * np.dot(deviations[:-lag], deviations[lag:]) / np.dot(deviations, deviations)
        if lag >= 5 * tau:
            break
    return len(means) * load.var() / (means.var() * tau)


class Summarize(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = cls.enterClassContext(tempfile.TemporaryDirectory())
        if sys.argv[2] == "--file":
            cls.path = sys.argv[3]
        else:
            cls.path = os.path.join(cls.folder, "campaign.h5")
            levels = "analysis.exceedance_levels_N=[10,30,60,90,1000]"
            times = "analysis.averaging_s=[0.02,0.1,0.5,1]"
            subprocess.run([FLOES, "run", sys.argv[2], "-o", cls.path, "--set", levels, "--set", times], check=True,
                           stdout=subprocess.DEVNULL)
        cls.summary = cls.summarize("--parts", "cases,pairs,extremes,exceedance,steady")
        with h5py.File(cls.path) as file:
            cls.members = {name: file["members"][name][:] for name in file["members"]}
            cls.names = [name.decode() for name in file["cases/name"][:]]
            cls.time_step = file["cases/time_step"][:]
            cls.window = file["cases/window"][:]
            cls.surge = file["history/surge_load"][:]
            cls.levels = file["level"][:] if "level" in file else []
            cls.times = file["averaging_time"][:] if "averaging_time" in file else []
            cls.averaged = {name: file["averaged"][name][:] for name in file.get("averaged", {})}
            if cls.averaged:
                cls.averaged["maximum_load"] = np.fmax.reduce(cls.averaged["segment_maximum"], axis=2)
            cls.segments = file["cases/segments"][:]
            cls.counts = {name: file["exceedance"][name][:] for name in file.get("exceedance", {})}
        cls.done = cls.members["status"] == 0

    @classmethod
    def summarize(cls, *arguments):
        run = [FLOES, "summarize", cls.path, "--format", "json", *arguments]
        return json.loads(subprocess.run(run, check=True, stdout=subprocess.PIPE).stdout)

    def column_of(self, name):
        """Of /members, or of /averaged as /members would have it: "sd_load_0.5s" is sd_load over 0.5 s."""
        averaged = re.fullmatch(r"(.*)_([0-9.]+)s", name)
        if averaged is None:
            return name
        base = averaged[1]
        self.members[name] = self.averaged[base][:, list(self.times).index(float(averaged[2]))]
        return name

    def values(self, case, column):
        chosen = self.done & (self.members["case"] == case)
        order = np.argsort(self.members["arrangement"][chosen])
        return self.members["arrangement"][chosen][order], self.members[column][chosen][order]

    def test_moments_and_intervals(self):
        for case, row in enumerate(self.summary["cases"]):
            for key in QUANTITIES:
                _, x = self.values(case, key)
                n, mean, s = len(x), x.mean(), x.std(ddof=1)
                cut = lambda value: min(max(value, LEAST.get(key, 0)), MOST.get(key, np.inf))
                t = stats.t.ppf(0.975, n - 1)
                out = far_from_the_others(np.log(x), False) if key.endswith(LOADS) and np.all(x > 0) else 0
                self.assertEqual(row.get(f"{key}_standing_out", 0), out)
                if out > 0:  # a mixture, which nobody else has
                    self.assertTrue(close(row[key], mean))
                    self.assertLessEqual(row[f"{key}_low"], mean)
                    self.assertGreaterEqual(row[f"{key}_high"], mean)
                    continue
                expected = {
                    "": mean,
                    "_low": cut(mean - t * s / np.sqrt(n)),
                    "_high": cut(mean + t * s / np.sqrt(n)),
                    "_prediction_low": cut(mean - t * s * np.sqrt(1 + 1 / n)),
                    "_prediction_high": cut(mean + t * s * np.sqrt(1 + 1 / n)),
                }
                if key in POSITIVE:
                    logs = np.log(x)
                    half = t * logs.std(ddof=1) * np.sqrt(1 + 1 / n)
                    expected["_prediction_low"] = np.exp(logs.mean() - half)
                    expected["_prediction_high"] = np.exp(logs.mean() + half)
                for part, value in expected.items():
                    with self.subTest(case=self.names[case], key=key, part=part):
                        self.assertTrue(close(row[key + part], value), f"{row[key + part]} is not {value}")

    def in_window(self, member):
        case = self.members["case"][member]
        load = self.surge[member][np.isfinite(self.surge[member])]
        return load[len(load) - round(self.window[case] / self.time_step[case]):]

    def test_what_members_counted_is_what_their_histories_show(self):
        for member in np.flatnonzero(self.done):
            load = self.in_window(member)
            for place, level in enumerate(self.levels):
                above = load > level
                self.assertEqual(self.counts["steps_above"][member, place], above.sum())
                self.assertEqual(self.counts["upcrossings"][member, place], (above[1:] & ~above[:-1]).sum())
            self.assertTrue(close(self.members["skewness"][member], stats.skew(load)))
            self.assertTrue(close(self.members["excess_kurtosis"][member], stats.kurtosis(load)))

    def test_averaged_loads_are_what_histories_show(self):
        self.assertTrue(len(self.times) > 0 or "--file" in sys.argv)
        for member in np.flatnonzero(self.done):
            load, case = self.in_window(member), self.members["case"][member]
            ends = np.arange(len(load)) // (len(load) // self.segments[case])
            for place, time in enumerate(self.times):
                found = {name: values[member, place] for name, values in self.averaged.items()}
                if np.isnan(found["mean_maximum"]):  # of another case, or of an older version
                    continue
                steps = round(time / self.time_step[case])
                means = np.array([load[end - steps:end].mean() for end in range(steps, len(load) + 1)])
                maxima = np.array([means[ends[steps - 1:] == k].max() for k in range(self.segments[case])])
                expected = {"sd_load": means.std(), "mean_maximum": maxima.mean(), "sd_maximum": maxima.std()}
                for name, value in expected.items():
                    with self.subTest(member=member, time=time, name=name):
                        self.assertLessEqual(abs(found[name] - value), 1e-12 * maxima.max())
                kept = found["segment_maximum"][:self.segments[case]]
                self.assertTrue(np.allclose(kept, maxima, rtol=1e-12, atol=0))

    def test_averaged_lines_are_intervals_like_others(self):
        for case, row in enumerate(self.summary["cases"]):
            chosen = self.done & (self.members["case"] == case)
            for place, time in enumerate(self.times):
                x = self.averaged["mean_maximum"][chosen, place]
                x = x[np.isfinite(x)]
                key = f"mean_maximum_{time:g}s"
                half = stats.t.ppf(0.975, len(x) - 1) * x.std(ddof=1) / np.sqrt(len(x))
                self.assertTrue(close(row[key], x.mean()))
                self.assertTrue(close(row[f"{key}_low"], x.mean() - half))

    def test_levels(self):
        rows = self.summary["load_levels"]
        self.assertEqual(len(rows), len(self.names) * len(self.levels))
        for row in rows:
            case, place = self.names.index(row["case"]), list(self.levels).index(row["level"])
            chosen = self.done & (self.members["case"] == case)
            share = self.counts["steps_above"][chosen, place] * self.time_step[case] / self.window[case]
            half = stats.t.ppf(0.975, len(share) - 1) * share.std(ddof=1) / np.sqrt(len(share))
            self.assertTrue(close(row["time_above"], share.mean()))
            self.assertTrue(close(row["time_above_low"], max(0, share.mean() - half)))
            rate = self.counts["upcrossings"][chosen, place] / self.window[case]
            self.assertTrue(close(row["upcrossings_per_s"], rate.mean()))

    def test_pairs(self):
        self.assertGreater(len(self.summary["pairs"]), 0)
        t_p = {}
        for row in self.summary["pairs"]:
            a, x = self.values(self.names.index(row["first"]), self.column_of(row["quantity"]))
            b, y = self.values(self.names.index(row["second"]), self.column_of(row["quantity"]))
            shared, i, j = np.intersect1d(a, b, return_indices=True)
            x, y = x[i], y[j]
            with self.subTest(**{key: row[key] for key in ("quantity", "first", "second")}):
                self.assertEqual(row["arrangements"], len(shared))
                self.assertTrue(close(row["difference"], np.mean(y - x)))
                if np.ptp(y - x) == 0:
                    continue
                test = stats.ttest_rel(y, x)
                half = stats.t.ppf(0.975, len(shared) - 1) * stats.sem(y - x)
                self.assertTrue(close(row["t_interval_low"], np.mean(y - x) - half))
                self.assertEqual(row["apart"], far_from_the_others(y - x, True))
                if row["apart"] == 0:
                    for end in ("low", "high"):
                        self.assertEqual(row[f"difference_{end}"], row[f"t_interval_{end}"])
                self.assertTrue(close(row["t"], test.statistic))
                self.assertTrue(close(row["t_p"], test.pvalue))
                t_p.setdefault(row["quantity"], []).append((test.pvalue, row["t_p_holm"]))
                d = y - x
                if np.all(d != 0) and len(np.unique(np.abs(d))) == len(d) and len(d) <= 50:
                    self.assertTrue(close(row["wilcoxon_p"], stats.wilcoxon(d, mode="exact").pvalue))
                saved = 1 - np.var(y - x, ddof=1) / (np.var(x, ddof=1) + np.var(y, ddof=1))
                self.assertTrue(close(row["variance_saved"], saved))
                self.assertEqual(row["arrangements_for_observed"], self.needed(np.mean(d), d.std(ddof=1)))
                self.assertEqual(row["arrangements_for_resolve"], self.needed(0.1 * x.mean(), d.std(ddof=1)))
        for pairs in t_p.values():
            p = sorted(pairs)
            expected = np.minimum(1, np.maximum.accumulate([(len(p) - i) * one[0] for i, one in enumerate(p)]))
            np.testing.assert_allclose([one[1] for one in p], expected, rtol=1e-9)

    @staticmethod
    def needed(difference, sd):
        def power(n):
            limit = stats.t.ppf(0.975, n - 1)
            shift = abs(difference) / sd * np.sqrt(n)
            return stats.nct.sf(limit, n - 1, shift) + stats.nct.cdf(-limit, n - 1, shift)

        low, high = 1, 2
        while not power(high) >= 0.8:
            if high >= 10**6:
                return 10**6
            low, high = high, min(2 * high, 10**6)
        while high - low > 1:
            middle = (low + high) // 2
            low, high = (low, middle) if power(middle) >= 0.8 else (middle, high)
        return high

    def test_extremes(self):
        times = list(self.times)
        place = times.index(1) if 1 in times else -1  # what the headlines are averaged over
        for case, name in enumerate(self.names):
            averaged = self.averaged["segment_maximum"][self.done & (self.members["case"] == case), place]
            maxima = averaged[:, :self.segments[case]].ravel()
            curve = sorted(maxima)
            points = [point for point in self.summary["exceedance"] if point["case"] == name]
            self.assertEqual([point["load"] for point in points], curve)
            for i, point in enumerate(points):
                self.assertTrue(close(point["empirical"], (len(curve) - i) / (len(curve) + 1)))
            fits = {row["distribution"]: row for row in self.summary["extremes"] if row["case"] == name}
            for kind, scipys in (("Gumbel", stats.gumbel_r), ("GEV", stats.genextreme)):
                fit = fits[kind]
                self.assertEqual(fit["maxima"], len(maxima))
                shape = (-fit["shape"],) if kind == "GEV" else ()
                own = scipys(*shape, fit["location"], fit["scale"])
                with self.subTest(case=name, kind=kind):
                    self.assertTrue(close(fit["log_likelihood"], own.logpdf(maxima).sum(), 1e-9))
                    guess = (0.0,) if kind == "GEV" else ()
                    theirs = scipys(*scipys.fit(maxima, *guess, loc=fit["location"], scale=fit["scale"]))
                    self.assertGreater(fit["log_likelihood"], theirs.logpdf(maxima).sum() - 1e-6 * len(maxima))
                    self.assertTrue(close(fit["kolmogorov_smirnov"], stats.kstest(maxima, own.cdf).statistic))
                    for segments in (10, 100, 1000):
                        self.assertTrue(close(fit[f"level_{segments}"], own.isf(1 / segments)))

    def test_steady(self):
        steady = self.summary["steady"]
        self.assertEqual([row["member"] for row in steady["members"]], list(np.flatnonzero(self.done)))
        for row in steady["members"]:
            case = self.members["case"][row["member"]]
            load = self.surge[row["member"]]
            load = load[~np.isnan(load)]
            start = mser(load)
            window = load[-int(round(self.window[case] / self.time_step[case])) :]
            with self.subTest(member=row["member"]):
                if start is None:
                    self.assertIsNone(row["steady_start"])
                else:
                    self.assertTrue(close(row["steady_start"], start * self.time_step[case]))
                self.assertTrue(close(row["effective_samples"], effective_samples(window), 1e-7))
        for case, row in enumerate(steady["cases"]):
            histories = self.surge[self.done & (self.members["case"] == case)]
            start = steady_by_members(histories[:, ~np.all(np.isnan(histories), axis=0)])
            found = row["steady_start"]
            self.assertTrue(found is None if start is None else close(found, start * self.time_step[case]))

    def test_automatic_window(self):
        automatic = self.summarize("--window", "auto", "--parts", "cases")
        for case, row in enumerate(automatic["cases"]):
            count = int(round(row["window"] / self.time_step[case]))
            means = [
                load[~np.isnan(load)][-count:].mean()
                for load in self.surge[self.done & (self.members["case"] == case)]
            ]
            self.assertTrue(close(row["mean_load"], np.mean(means)))
            given = self.summary["cases"][case]
            self.assertTrue(close(row["window"] / row["segments"], given["window"] / given["segments"]))
            start = self.summary["steady"]["cases"][case]["steady_start"]
            if start is not None and row["window"] != given["window"]:
                self.assertGreaterEqual(row["steady_start"], start - 1e-6)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
