#!/usr/bin/python3
"""sensitivity_against_numpy.py FLOES CONFIG: runs a small design over the field of CONFIG, reads its file with h5py and its
configuration as TOML, computes with numpy what `floes summarize --parts sensitivity --format json` prints, and compares.
The estimators are those of scipy.stats.sobol_indices (scipy 1.11: saltelli_2010, jansen_1999), written out here since
Debian's scipy is older. Nothing here knows how floes computes.

    sensitivity_against_numpy.py FLOES --file CAMPAIGN.h5     the same for a campaign that has been run"""

import json
import os
import subprocess
import sys
import tempfile
import tomllib
import unittest

import h5py
import numpy as np
from scipy import stats

COLUMNS = ["mean_load", "sd_load", "mean_maximum", "failure_ratio"]
DESIGN = """
[design]
method = "sobol_indices"
points = 4
[[design.axis]]
key = "ice.bending_strength_kPa"
from = 20
to = 60
[[design.axis]]
key = "ice.elastic_modulus_MPa"
from = 30.0
to = 1000.0
scale = "log"
[[case]]
name = "slow"
structure.speed_m_s = 0.15
[[case]]
name = "fast"
structure.speed_m_s = 0.2
"""
SMALL = ["campaign.arrangements=3", "field.floes=8", "analysis.steady_start_s=2", "analysis.window_s=3"]
FLOES = sys.argv[1]


def sobol_indices(a, b, ab):
    mean, variance = np.mean([a, b]), np.var([a, b])
    a, b, ab = a - mean, b - mean, ab - mean
    return np.mean(b * (ab - a), axis=-1) / variance, 0.5 * np.mean((a - ab) ** 2, axis=-1) / variance


class Sensitivity(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = cls.enterClassContext(tempfile.TemporaryDirectory())
        if sys.argv[2] == "--file":
            cls.path = sys.argv[3]
        else:
            cls.path = os.path.join(cls.folder, "design.h5")
            with open(sys.argv[2]) as given:
                text = given.read().split("[[case]]")[0] + DESIGN
            config = os.path.join(cls.folder, "design.toml")
            with open(config, "w") as file:
                file.write(text)
            settings = [word for setting in SMALL for word in ("--set", setting)]
            subprocess.run([FLOES, "run", config, "-o", cls.path, *settings], check=True, stdout=subprocess.DEVNULL)
        run = [FLOES, "summarize", cls.path, "--format", "json", "--parts", "sensitivity"]
        cls.found = json.loads(subprocess.run(run, check=True, stdout=subprocess.PIPE).stdout)["sensitivity"]
        with h5py.File(cls.path) as file:
            cls.members = {name: file["members"][name][:] for name in ["case", "status", *COLUMNS]}
            times = file["averaging_time"][:] if "averaging_time" in file else []
            for place, time in enumerate(times):
                for column in ("sd_load", "mean_maximum"):
                    cls.members[f"{column}_{time:g}s"] = file["averaged"][column][:, place]
            cls.figures = 4 + 2 * len(times)
            cls.config = tomllib.loads(file["provenance/configuration"][()].decode())
        cls.cases = len(cls.config["case"])
        cls.axes = cls.config["design"]["axis"]

    def chosen(self, base):
        cases = [k for k, case in enumerate(self.config["case"]) if case["design"]["base"] == base]
        return sorted(cases, key=lambda k: self.config["case"][k]["design"]["point"])

    def axis_values(self, base, axis):
        table, name = axis["key"].split(".", 1)
        return np.array([self.config["case"][k][table][name] for k in self.chosen(base)], dtype=float)

    def coordinates(self, base):
        columns = []
        for axis in self.axes:
            scale = np.log if axis["scale"] == "log" else np.asarray
            x, low, high = scale(self.axis_values(base, axis)), scale(axis["from"]), scale(axis["to"])
            columns.append(2 * (x - low) / (high - low) - 1)
        return np.array(columns).T

    def values(self, row):
        every = self.members[row["quantity"]].reshape(-1, self.cases)
        done = self.members["status"].reshape(-1, self.cases) == 0
        return np.where(done, every, np.nan)[:, self.chosen(row["base"])]

    def rows(self):
        """What stands in the rows of a quantity of a base case, and these rows, one for each axis."""
        of = {}
        for row in self.found["rows"]:
            of.setdefault((row["base"], row["quantity"]), []).append(row)
        self.assertEqual(len(of), self.figures * len({case["design"]["base"] for case in self.config["case"]}))
        for rows in of.values():
            self.assertEqual([row["axis"] for row in rows], [axis["key"] for axis in self.axes])
        return [(rows[0], rows) for rows in of.values()]

    def test_points_are_a_sobol_sequence_in_saltellis_order(self):
        count, each = self.config["design"]["points"], len(self.axes) + 2
        for base in {case["design"]["base"] for case in self.config["case"]}:
            x = self.coordinates(base).reshape(count, each, len(self.axes))
            for i in range(len(self.axes)):
                expected = x[:, 0].copy()
                expected[:, i] = x[:, 1, i]
                np.testing.assert_array_equal(x[:, 2 + i], expected)
                if count & (count - 1) == 0:  # each of `count` equal parts of an axis once, by A and by B
                    for r in (0, 1):
                        parts = np.floor((x[:, r, i] + 1) / 2 * count).astype(int)
                        self.assertEqual(sorted(parts), list(range(count)))

    def test_indices(self):
        varied = 0
        for row, axes in self.rows():
            means = np.nanmean(self.values(row), axis=0).reshape(-1, len(self.axes) + 2)
            means = means[np.isfinite(means).all(axis=1)]
            self.assertEqual(row["base_points"], len(means))
            if np.ptp(means[:, :2]) == 0:
                continue
            varied += 1
            first, total = sobol_indices(means[:, 0], means[:, 1], means[:, 2:].T)
            np.testing.assert_allclose([axis["first_order"] for axis in axes], first, atol=1e-9)
            np.testing.assert_allclose([axis["total"] for axis in axes], total, atol=1e-9)
        self.assertGreaterEqual(varied, 3)

    def test_planes(self):
        for row, axes in self.rows():
            values = self.values(row)
            values = values[np.isfinite(values).all(axis=1)]
            self.assertGreaterEqual(len(values), 2)
            self.assertEqual(row["arrangements_fitted"], len(values))
            model = np.c_[np.ones(values.shape[1]), self.coordinates(row["base"])]
            each = np.linalg.lstsq(model, values.T, rcond=None)[0]
            means = each.mean(axis=1)
            half = stats.t.ppf(0.975, len(values) - 1) * each.std(axis=1, ddof=1) / np.sqrt(len(values))
            close = {"rtol": 1e-8, "atol": 1e-9}
            np.testing.assert_allclose(row["centre"], means[0], **close)
            np.testing.assert_allclose([axis["slope"] for axis in axes], means[1:], **close)
            np.testing.assert_allclose([axis["slope_low"] for axis in axes], (means - half)[1:], **close)
            np.testing.assert_allclose([axis["slope_high"] for axis in axes], (means + half)[1:], **close)
            mean = values.mean(axis=0)
            if np.ptp(mean) > 0:
                left = np.sum((mean - model @ means) ** 2) / np.sum((mean - mean.mean()) ** 2)
                np.testing.assert_allclose(row["r_squared"], 1 - left, **close)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
