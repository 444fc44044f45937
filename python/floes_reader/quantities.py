"""The quantities that summary() shows, with the ranges that their intervals are cut to, as
src/member/quantity.hpp lists them. Their units and long names stand in the file. A test compares the result with
`floes summarize`."""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from math import inf


@dataclass(frozen=True)
class Quantity:
    """A single number of a member."""

    key: str  # column of Campaign.members, and its name in JSON and CSV of `floes summarize`
    least: float = 0
    most: float = inf
    positive: bool = False  # ranges of single runs are taken on a logarithmic scale
    averaged: bool = False  # also exists for the averaged load


IN_SUMMARY = [
    Quantity("mean_load", least=-inf),
    Quantity("sd_load", averaged=True),
    Quantity("maximum_load", least=-inf, positive=True, averaged=True),
    Quantity("mean_maximum", least=-inf, positive=True, averaged=True),
    Quantity("sd_maximum", averaged=True),
    Quantity("failure_ratio", most=1),
    Quantity("split_ratio", most=1),
    Quantity("cracked_ratio", most=1),
    Quantity("pieces"),
    Quantity("failures_bending"),
    Quantity("failures_shear"),
    Quantity("failures_compression"),
    Quantity("failures_tension"),
    Quantity("failures_torsion"),
    Quantity("failures_in_plane_bending"),
    Quantity("local_order", least=-1, most=1),
    Quantity("coverage_ahead", most=1),
]


def over(key: str, time: float) -> str:
    """The key of a quantity of the load averaged over `time`, s: "mean_maximum_0.5s"."""
    return f"{key}_{str(float(time)).removesuffix('.0')}s"


def with_times(averaging_times: Iterable[float]) -> list[Quantity]:
    """IN_SUMMARY with, after each quantity that also exists for the averaged load, the same for each time, s."""
    made = []
    for one in IN_SUMMARY:
        made.append(one)
        for time in averaging_times if one.averaged else ():
            made.append(replace(one, key=over(one.key, time)))
    return made
