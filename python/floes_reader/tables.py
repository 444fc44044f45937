"""Tables made of the datasets of a campaign file."""

from typing import Any

import numpy
import pandas
import xarray

from .quantities import over
from .stored import CampaignError, Stored

LOADS = ("surge_load", "sway_load", "heave_load")


def table(stored: Stored, group: str, prefix: str = "") -> pandas.DataFrame:
    """The columns of a group whose names begin with `prefix`, which is taken off; flags in words."""
    columns = {}
    for name in stored.names(group):
        path = f"{group}/{name}"
        if not name.startswith(prefix) or name == prefix or len(stored.shape(path)) != 1:
            continue
        flags = "flag_meanings" in stored.attributes_of(path)
        columns[name.removeprefix(prefix)] = stored.words(path) if flags else stored.read(path)
    if len({len(column) for column in columns.values()}) > 1:
        raise stored.damaged(f"the columns of /{group} are not equally long")
    return pandas.DataFrame(columns)


def averaging_times(stored: Stored) -> list[float]:
    """s; none if no case averages the load."""
    return stored.read("averaging_time").tolist() if stored.has("averaged") else []


FROM_SEGMENTS = "maximum_load"  # of the averaged load the file has it by segments


def has_averaged(stored: Stored, name: str) -> bool:
    return stored.has(f"averaged/{'segment_maximum' if name == FROM_SEGMENTS else name}")


def averaged(stored: Stored, name: str, place: int) -> numpy.ndarray:
    """A quantity of each member, averaged over the time in that place."""
    if name == FROM_SEGMENTS:
        maxima = stored.read("averaged/segment_maximum", (slice(None), place))
        return numpy.fmax.reduce(maxima, axis=1, initial=numpy.nan)
    return stored.read(f"averaged/{name}", (slice(None), place))


def quantities(stored: Stored) -> pandas.DataFrame:
    """By key: `units`, `long_name`, `averaging_time`."""
    rows = {}
    for name in stored.names("members"):
        path = f"members/{name}"
        if len(stored.shape(path)) != 1 or stored.kind(path) != "f":
            continue
        about = stored.attributes_of(path)
        rows[name] = {"units": about["units"], "long_name": about["long_name"], "averaging_time": 0.0}
        for time in averaging_times(stored) if has_averaged(stored, name) else []:
            words = f"{about['long_name']}, averaged over {str(time).removesuffix('.0')} s"
            rows[over(name, time)] = {"units": about["units"], "long_name": words, "averaging_time": time}
    return pandas.DataFrame.from_dict(rows, orient="index").rename_axis("quantity")


def members(stored: Stored, cases: list[str], known: pandas.DataFrame) -> pandas.DataFrame:
    """A row for each member, with the quantities that are `known`."""
    case, arrangement = stored.read("members/case"), stored.read("members/arrangement")
    numbers, times = stored.read("arrangements/number"), averaging_times(stored)
    for indices, length, what in ((case, len(cases), "case"), (arrangement, len(numbers), "arrangement")):
        if len(indices) and not (0 <= indices.min() and indices.max() < length):
            raise stored.damaged(f"/members/{what} names a row that /{what}s does not have")
    status = stored.words("members/status")
    if any(word is None for word in status):
        raise stored.damaged("/members/status has a value without a meaning")
    steady = [None if word is None else word == "steady" for word in stored.words("members/steady")]
    columns: dict[str, Any] = {"case": numpy.array(cases, object)[case], "arrangement": arrangement,
                               "arrangement_number": numbers[arrangement], "status": status,
                               "steady": pandas.array(steady, "boolean"), "reason": stored.read("members/reason")}
    for key, time in known.averaging_time.items():
        if time == 0:
            columns[key] = stored.read(f"members/{key}")
        else:
            base = key.removesuffix(over("", time))
            columns[key] = averaged(stored, base, times.index(time))
    for name, column in columns.items():
        if len(column) != len(case):
            raise stored.damaged(f"{name} of the members has {len(column)} values, not {len(case)}")
    return pandas.DataFrame(columns, pandas.RangeIndex(len(case), name="member"))


def histories(stored: Stored, numbers: list[int], time_step: float, stride: int) -> xarray.Dataset:
    """Histories of done members of one case, over `member` and `time`: loads, and what else these members have."""
    found = {name: stored.array(f"history/{name}", numbers) for name in stored.names("history")}
    found = {name: array for name, array in found.items() if name in LOADS or numpy.isfinite(array.values).any()}
    kept = numpy.flatnonzero(numpy.isfinite(found["surge_load"].values).any(axis=0))
    if numbers and not len(kept):
        raise CampaignError(f"{stored.path} has no history of these members: analysis.history_steps was 0.")
    length = kept[-1] + 1 if len(kept) else 0
    # Motions have an axis of their own in the file, which ends with the longest case that moves. Steps are the same.
    found = {name: array.rename({array.dims[1]: "time"}).isel(time=slice(length)) for name, array in found.items()}
    time = stored.array("time")[:length]
    if time.attrs["units"] != "s":  # cases differ in their steps, so the file numbers the values
        time = time * (time_step * stride)
    time = time.assign_attrs(units="s", long_name="time since the tow began")
    return xarray.Dataset(found).assign_coords(member=numbers, time=time)
