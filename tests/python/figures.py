"""The figures of floes_reader.plots show the numbers of the file."""

import unittest

import matplotlib
import numpy
from campaigns import FULL, SMOKE

import floes_reader

matplotlib.use("agg")
from floes_reader import plots  # noqa: E402


class Figures(unittest.TestCase):
    def tearDown(self):
        plots.pyplot.close("all")

    def test_loads(self):
        for path, quantity in ((SMOKE, "mean_load"), (SMOKE, "mean_maximum_0.5s"), (FULL, "sd_load_0.2s"),
                               (FULL, "failure_ratio")):
            with self.subTest(path=path.name, quantity=quantity), floes_reader.open(path) as campaign:
                axes = plots.loads(campaign, quantity).axes[0]
                members, summary = campaign.members, campaign.summary()
                self.assertEqual([label.get_text() for label in axes.get_yticklabels()], list(campaign.cases.index))
                self.assertIn(campaign.quantities.long_name[quantity], axes.get_xlabel())
                for row, case in enumerate(campaign.cases.index):
                    dots, prediction, confidence, mean = axes.lines[4 * row:4 * row + 4]
                    own = members[members.case == case][quantity].dropna()
                    numpy.testing.assert_array_equal(dots.get_xdata(), own)
                    found = summary.loc[(case, quantity)]
                    shown = [*prediction.get_xdata(), *confidence.get_xdata()]
                    limits = found[["prediction_low", "prediction_high", "low", "high"]]
                    numpy.testing.assert_array_equal(shown, limits.to_numpy(float))
                    self.assertTrue(mean.get_xdata() == found.estimate or not len(own))
                    self.assertTrue((numpy.round(dots.get_ydata()) == row).all())
                self.assertEqual(axes.get_xlim()[0] == 0, summary.xs(quantity, level=1).prediction_low.min() >= 0)

    def test_histories(self):
        with floes_reader.open(SMOKE) as campaign:
            figure = plots.histories(campaign, arrangement=2, over=1.0, cases=["E200", "E30"])
            self.assertEqual([axes.get_title("left").split(":")[0] for axes in figure.axes], ["E30", "E200"])
            for axes, member in zip(figure.axes, (6, 8)):
                load = campaign.history(member).surge_load.values
                every, mean = axes.lines
                numpy.testing.assert_array_equal(every.get_ydata(), load)
                means = numpy.convolve(load, numpy.ones(50) / 50, "valid")
                numpy.testing.assert_allclose(mean.get_ydata()[25:-24], means)
                self.assertAlmostEqual(mean.get_ydata()[0], load[:25].mean())
                self.assertIn(f"mean {campaign.members.mean_load[member]:.1f} N", axes.get_title("left"))

    def test_what_cannot_be_drawn(self):
        with floes_reader.open(SMOKE) as campaign:
            for draw, words in ((lambda: plots.loads(campaign, "mean_lod"), "no quantity 'mean_lod'; it has mean_load"),
                                (lambda: plots.loads(campaign, cases=["E31"]), "no case 'E31'"),
                                (lambda: plots.histories(campaign, arrangement=9), "0 cases have arrangement 9")):
                with self.assertRaisesRegex(floes_reader.CampaignError, words):
                    draw()
