"""How much of the scatter of a load within a level of order is explained by what is known before the tow."""
import numpy as np


def centred(table, columns):
    """The columns less their means within levels."""
    return (table[columns] - table.groupby("sweeps")[columns].transform("mean")).to_numpy()


def slopes(table, measure, predictors):
    """Slopes of `measure` over `predictors`, all less their means within levels."""
    return np.linalg.lstsq(centred(table, predictors), centred(table, [measure])[:, 0], rcond=None)[0]


def predicted(table, measure, predictors):
    """R2 within a level on arrangements that the fit has not seen: each arrangement is left out in turn, and level means
    and slopes come from the others. Below 0: the level mean alone predicts better."""
    error = baseline = 0.0
    for number in table.arrangement.unique():
        others, own = table[table.arrangement != number], table[table.arrangement == number]
        means = others.groupby("sweeps")[[measure, *predictors]].mean().loc[own.sweeps]
        plain = own[measure].to_numpy() - means[measure].to_numpy()
        shift = own[predictors].to_numpy() - means[predictors].to_numpy()
        error += np.sum((plain - shift @ slopes(others, measure, predictors)) ** 2)
        baseline += np.sum(plain**2)
    return 1 - error / baseline
