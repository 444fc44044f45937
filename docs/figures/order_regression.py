"""Load over order: least squares with errors by arrangement, and what order is worth as a control variate."""
import numpy as np
from scipy import stats


def centred(table, columns, groups):
    """The columns less their means within groups ("sweeps" or "arrangement"), or less their means if groups is None."""
    values = table[columns]
    return (values - (values.mean() if groups is None else values.groupby(table[groups]).transform("mean"))).to_numpy()


def slopes(table, measure, predictors, groups=None):
    """Slopes of `measure` over `predictors`, all less their means within `groups`."""
    x, y = centred(table, predictors, groups), centred(table, [measure], groups)[:, 0]
    return np.linalg.lstsq(x, y, rcond=None)[0]


def fit(table, measure, predictors, groups=None):
    """Slopes, their standard errors and the half widths of their 95 % intervals, by the jackknife over arrangements: the
    same field at several levels of order is not several fields. Student's t has one degree of freedom less than there are
    arrangements."""
    estimate = slopes(table, measure, predictors, groups)
    without = np.array([slopes(table[~rows], measure, predictors, groups) for rows in clusters(table)])
    count = len(without)
    errors = np.sqrt((count - 1) / count * np.sum((without - estimate) ** 2, axis=0))
    return estimate, errors, stats.t.ppf(0.975, count - 1) * errors


def explained(table, measure, predictors, groups=None):
    """R2, adjusted for the number of slopes."""
    x, y = centred(table, predictors, groups), centred(table, [measure], groups)[:, 0]
    rest = y - x @ slopes(table, measure, predictors, groups)
    freedom = len(y) - (1 if groups is None else table[groups].nunique())
    return 1 - (rest @ rest / (freedom - len(predictors))) / (y @ y / freedom)


def clusters(table):
    arrangement = table.arrangement.to_numpy()
    return [arrangement == number for number in np.unique(arrangement)]


def predicted(table, measure, predictors):
    """R2 within a level on arrangements that the fit has not seen: each arrangement is left out in turn, and level means
    and slopes come from the others. Below 0: the level mean alone predicts better."""
    error = baseline = 0.0
    for rows in clusters(table):
        others, own = table[~rows], table[rows]
        means = others.groupby("sweeps")[[measure, *predictors]].mean().loc[own.sweeps]
        plain = own[measure].to_numpy() - means[measure].to_numpy()
        shift = own[predictors].to_numpy() - means[predictors].to_numpy()
        moved = shift @ slopes(others, measure, predictors, "sweeps")
        error += np.sum((plain - moved) ** 2)
        baseline += np.sum(plain**2)
    return 1 - error / baseline


def within_level_sd(table, measure):
    """SD over arrangements, pooled over the levels."""
    y = centred(table, [measure], "sweeps")
    return np.sqrt(np.sum(y**2) / (len(y) - table.sweeps.nunique()))


def holm(probabilities):
    """Holm's adjustment, in the given order."""
    order = np.argsort(probabilities)
    raised = np.maximum.accumulate((len(order) - np.arange(len(order))) * np.asarray(probabilities)[order])
    adjusted = np.empty(len(order))
    adjusted[order] = np.minimum(raised, 1.0)
    return adjusted
