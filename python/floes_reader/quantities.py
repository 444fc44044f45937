"""The quantities that summary() shows, with the ranges that their intervals are cut to, as
src/quantities/quantity.hpp lists them. Their units and long names stand in the file. A test compares the result with
`floes summarize`."""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from math import inf


@dataclass(frozen=True)
class Quantity:
    """A single number of a member."""

    key: str  # column of Campaign.members
    name: str  # in JSON and CSV of `floes summarize`
    least: float = 0
    most: float = inf
    positive: bool = False  # ranges of single runs are taken on a logarithmic scale
    averaged: bool = False  # also exists for the averaged load


IN_SUMMARY = [
    Quantity("mean_load", "mean_N", least=-inf),
    Quantity("sd_load", "sd_N", averaged=True),
    Quantity("maximum_load", "maximum_N", least=-inf, positive=True),
    Quantity("mean_maximum", "mean_maximum_N", least=-inf, positive=True, averaged=True),
    Quantity("sd_maximum", "sd_maximum_N", averaged=True),
    Quantity("failure_ratio", "failure_ratio", most=1),
    Quantity("split_ratio", "split_ratio", most=1),
    Quantity("cracked_ratio", "cracked_ratio", most=1),
    Quantity("pieces", "pieces_per_run"),
    Quantity("failures_bending", "failures_bending_per_run"),
    Quantity("failures_shear", "failures_shear_per_run"),
    Quantity("failures_compression", "failures_compression_per_run"),
    Quantity("failures_tension", "failures_tension_per_run"),
    Quantity("failures_torsion", "failures_torsion_per_run"),
    Quantity("failures_in_plane_bending", "failures_in_plane_bending_per_run"),
    Quantity("local_order", "local_order", least=-1, most=1),
    Quantity("coverage_ahead", "coverage_ahead", most=1),
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
            made.append(replace(one, key=over(one.key, time), name=over(one.name.removesuffix("_N"), time) + "_N"))
    return made
