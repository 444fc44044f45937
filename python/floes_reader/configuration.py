"""The resolved configuration of a campaign: which key has which value in which case. Names are those of the version
that wrote the file; for those of 1.0.0 see docs/configuration.md, "Coming from 1.0.0"."""

import tomllib
from typing import Any

import pandas

NOT_OF_CASES = {"campaign", "case", "design", "run", "stop"}  # tables that are not the same for each case
PARTS = {"structure.keel_radius_m": lambda keys: keys["structure.profile_m"][0][1]}  # of other keys, so not stored


def flat(table: dict[str, Any], prefix: str = "") -> dict[str, Any]:
    """{"ice": {"thickness_m": 0.03}} -> {"ice.thickness_m": 0.03}"""
    keys = {}
    for name, value in table.items():
        keys.update(flat(value, f"{prefix}{name}.") if isinstance(value, dict) else {prefix + name: value})
    return keys


class Configuration:
    """A resolved configuration. Values have the unit that their key's name ends in."""

    def __init__(self, text: str):
        self.tables: dict[str, Any] = tomllib.loads(text)
        self._base = flat({name: table for name, table in self.tables.items() if name not in NOT_OF_CASES})
        self._own = {case["name"]: flat(case) for case in self.tables["case"]}

    def keys(self, case: str) -> dict[str, Any]:
        """Every key of the scenario as the case has it."""
        own = {key: value for key, value in self._own[case].items() if key != "name" and not key.startswith("design.")}
        return self._base | own

    def overrides(self) -> pandas.DataFrame:
        """A row for each case, a column for each key that has more than one value among them."""
        keys = {case: self.keys(case) for case in self._own}
        names = list(dict.fromkeys(name for one in keys.values() for name in one))
        differing = [name for name in names if len({repr(one.get(name)) for one in keys.values()}) > 1]
        return _frame({case: {name: one.get(name) for name in differing} for case, one in keys.items()}, differing)

    def design(self) -> pandas.DataFrame | None:
        """A row for each case: `base` (the case that was laid out; empty if there was none), `point`, and its value
        on each axis by key. None if the campaign has no design."""
        if "design" not in self.tables:
            return None
        axes = [axis["key"] for axis in self.tables["design"]["axis"]]
        rows = {}
        for case, own in self._own.items():
            keys = self.keys(case)
            rows[case] = {"base": own["design.base"], "point": own["design.point"],
                          **{axis: keys[axis] if axis in keys else PARTS[axis](keys) for axis in axes}}
        return _frame(rows, ["base", "point", *axes])


def _frame(rows: dict[str, dict[str, Any]], columns: list[str]) -> pandas.DataFrame:
    index = pandas.Index(list(rows), name="case")
    series = {name: pandas.Series([row[name] for row in rows.values()], index) for name in columns}
    return pandas.DataFrame(series, index)
