"""Intervals over arrangements, with the formulas of docs/statistics.md. Student's t is written out here, since a
reader of files should not need scipy for one quantile."""

from typing import NamedTuple

import numpy
from numpy.typing import ArrayLike

NAN = float("nan")


class Interval(NamedTuple):
    """In the unit of the values; NaN where undefined."""

    estimate: float  # mean over arrangements
    low: float = NAN  # confidence interval of the mean over all arrangements
    high: float = NAN
    prediction_low: float = NAN  # prediction interval of one further run
    prediction_high: float = NAN

    def within(self, least: float, most: float) -> "Interval":
        """Cut to [least, most]; NaN stays."""
        return Interval(*(float(numpy.clip(value, least, most)) for value in self))


def inside_probability(angle: float, freedom: int) -> float:
    """Probability that Student's t lies within ± sqrt(freedom) tan(angle): the finite series for whole degrees of
    freedom (Abramowitz and Stegun, 26.7.3 and 26.7.4)."""
    sine, square = numpy.sin(angle), numpy.cos(angle) ** 2
    if freedom % 2 == 0:
        k = numpy.arange(1, freedom // 2)
        return sine * (1 + numpy.cumprod(square * (2 * k - 1) / (2 * k)).sum())
    k = numpy.arange(1, (freedom - 1) // 2)
    series = 0 if freedom == 1 else numpy.cos(angle) * (1 + numpy.cumprod(square * (2 * k) / (2 * k + 1)).sum())
    return 2 / numpy.pi * (angle + sine * series)


def student_t(freedom: int, tail: float) -> float:
    """Student's t that is exceeded with probability `tail` (below a half), with `freedom` >= 1 degrees of freedom."""
    low, high = 0.0, numpy.pi / 2
    while low < (middle := (low + high) / 2) < high:
        if inside_probability(middle, freedom) < 1 - 2 * tail:
            low = middle
        else:
            high = middle
    return float(numpy.sqrt(freedom) * numpy.tan(high))


def mean_interval(values: ArrayLike, confidence: float = 0.95, positive: bool = False) -> Interval:
    """Mean of `values`, one an arrangement, by Student's t. `positive`: of values above 0 the prediction interval is
    that of their logarithms. Values that are not finite are left out; a single one gives only an estimate, none gives
    NaN."""
    finite = numpy.asarray(values, float)
    finite = finite[numpy.isfinite(finite)]
    count = len(finite)
    if count == 0:
        return Interval(NAN)
    mean = float(finite.mean())
    if count == 1:
        return Interval(mean)
    width = student_t(count - 1, (1 - confidence) / 2) * float(finite.std(ddof=1))
    of_mean, of_run = width / numpy.sqrt(count), width * numpy.sqrt(1 + 1 / count)
    made = Interval(mean, mean - of_mean, mean + of_mean, mean - of_run, mean + of_run)
    if not positive or (finite <= 0).any():
        return made
    logarithmic = mean_interval(numpy.log(finite), confidence)
    return made._replace(prediction_low=float(numpy.exp(logarithmic.prediction_low)),
                         prediction_high=float(numpy.exp(logarithmic.prediction_high)))
