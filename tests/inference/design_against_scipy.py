#!/usr/bin/python3
"""design_against_scipy.py FLOES CONFIG: runs the campaign of CONFIG, takes peaks and tails from its histories with numpy and
scipy, and compares them with the file and with `floes design`. Nothing here knows how floes computes."""

import json
import os
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy as np
from scipy import integrate, optimize, stats

FLOES, CONFIG = sys.argv[1:3]
SEPARATION, AVERAGING, EXPOSURE_H, P, SHARE = 0.8, 0.5, 0.2, 0.9, 0.4


def declustered(load, apart, least):
    """From the highest local maximum down, each at least `apart` samples from those before."""
    padded = np.concatenate([[-np.inf], load, [-np.inf]])
    places = np.flatnonzero((padded[1:-1] > padded[:-2]) & (padded[1:-1] >= padded[2:]) & (load > least))
    taken = []
    for place in places[np.argsort(-load[places], kind="stable")]:
        if all(abs(place - other) >= apart for other in taken):
            taken.append(place)
    return load[taken]


def hidden_weight(kept):
    """Rényi: 1 / θ'(u) where θ(u) = kept, by quadrature."""
    exponent = lambda t: integrate.quad(lambda v: -np.expm1(-v) / v if v > 0 else 1.0, 0, t)[0]
    theta = lambda u: integrate.quad(lambda t: np.exp(-2 * exponent(t)), 0, u)[0]
    u = optimize.brentq(lambda u: theta(u) - kept, 0, 3)
    return np.exp(2 * exponent(u))


def fitted(cost, start):
    return optimize.minimize(cost, start, method="Nelder-Mead", options={"xatol": 1e-9, "fatol": 1e-10, "maxiter": 9999})


class Design(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = cls.enterClassContext(tempfile.TemporaryDirectory())
        path = os.path.join(cls.folder, "campaign.h5")
        given = [f"analysis.peak_separation_s={SEPARATION}", f"analysis.averaging_s=[{AVERAGING}]",
                 "campaign.arrangements=20"]
        subprocess.run([FLOES, "run", CONFIG, "-o", path] + [word for one in given for word in ("--set", one)],
                       check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        command = [FLOES, "design", path, "--format", "json", "--averaging-s", str(AVERAGING), "--exposure-h",
                   str(EXPOSURE_H), "--quantile", str(P), "--peaks", str(SHARE), "--rising"]
        cls.told = json.loads(subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout)["design"]
        with h5py.File(path) as file:
            cls.names = [name.decode() for name in file["cases/name"][:]]
            cls.of_case = file["members/case"][:]
            cls.mean = file["members/mean_load"][:]
            cls.peaks = file["averaged/peaks"][:, 0]
            cls.window = file["cases/window"][0]
            step = file["cases/time_step"][0]
            surge = file["history/surge_load"][:]
        steps = round(AVERAGING / step)
        cls.averaged = [np.convolve(load[-round(cls.window / step):], np.ones(steps) / steps, mode="valid")
                        for load in surge]
        cls.apart = round(SEPARATION / step)

    def test_peaks_are_those_of_the_histories(self):
        for load, stored in zip(self.averaged, self.peaks):
            np.testing.assert_allclose(stored[np.isfinite(stored)], declustered(load, self.apart, load.mean()),
                                       rtol=1e-9, atol=1e-9)

    def test_tails_are_the_likeliest(self):
        for index, name in enumerate(self.names):
            with self.subTest(case=name):
                self.check(index, name)

    def check(self, index, name):
        basis = next(one for one in self.told["basis"] if one["case"] == name)
        rows = self.peaks[self.of_case == index]
        peaks = np.sort(rows[np.isfinite(rows)])[::-1]
        time = self.window * len(rows)
        threshold = np.quantile(peaks, 1 - SHARE)
        self.assertAlmostEqual(basis["threshold"], threshold, places=9)
        excess = peaks[peaks > threshold] - threshold
        self.assertEqual(basis["peaks"], len(excess))
        weights = np.array([hidden_weight((k + 0.5) * SEPARATION / time) for k in range(len(excess))])
        rate = weights.sum() / time
        origin = self.mean[self.of_case == index].mean()

        def pareto_cost(x):
            return np.inf if x[1] < -0.5 else -np.dot(weights, stats.genpareto.logpdf(excess, x[1], scale=np.exp(x[0])))

        def weibull_cost(x):
            frozen = stats.weibull_min(np.exp(x[1]), scale=np.exp(x[0]))
            return -np.dot(weights, frozen.logpdf(threshold - origin + excess) - frozen.logsf(threshold - origin))

        pareto = fitted(pareto_cost, [np.log(excess.mean()), 0.0])
        edge = optimize.minimize_scalar(lambda scale: pareto_cost([scale, -0.5]), tol=1e-12,
                                        bracket=(pareto.x[0] - 0.1, pareto.x[0] + 0.1))
        if edge.fun < pareto.fun:  # a simplex collapses at the bound before it finds the best there
            pareto.x, pareto.fun = np.array([edge.x, -0.5]), edge.fun
        weibull = fitted(weibull_cost, [np.log(threshold - origin + excess.mean()), 0.0])
        rarer = -np.log(P) / (3600 * EXPOSURE_H) / rate
        one = threshold + stats.genpareto.isf(rarer, pareto.x[1], scale=np.exp(pareto.x[0]))
        frozen = stats.weibull_min(np.exp(weibull.x[1]), scale=np.exp(weibull.x[0]))
        other = origin + frozen.isf(rarer * frozen.sf(threshold - origin))
        both = next(line for line in self.told["loads"] if line["case"] == name and line["method"] == "both tails" and
                    line["figure"] == "quantile")
        self.assertLess(both["load_low"], max(one, other))  # members may differ, so it is not a mean of the two
        self.assertGreater(both["load_high"], min(one, other))
        for method, load in {"Pareto tail": one, "Weibull tail": other}.items():
            told = next(line["load"] for line in self.told["loads"] if line["case"] == name and
                        line["method"] == method and line["figure"] == "quantile")
            self.assertAlmostEqual(told / load, 1, delta=2e-3, msg=method)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
