"""A configuration as a dict, written as the TOML that floes reads. Python reads TOML and does not write it."""

import json
import os
import re
from collections.abc import Mapping
from typing import Any

BARE = re.compile(r"[A-Za-z0-9_.-]+")  # also the dotted keys of Campaign.keys


def value_text(value: Any) -> str:
    """A value of TOML; numbers and arrays of numpy as those of Python. TypeError for what TOML does not have."""
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, (str, os.PathLike)):
        return json.dumps(os.fspath(value), ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{_key(name)} = {value_text(one)}" for name, one in value.items()) + "}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(value_text, value)) + "]"
    raise TypeError(f"A configuration has numbers, texts, lists and tables, and no {type(value).__name__}: {value!r}.")


def toml_text(tables: Mapping[str, Any]) -> str:
    """{"ice": {"thickness_m": 0.03}}, or {"ice.thickness_m": 0.03}, as TOML with a line for each key, so that what
    floes refuses has a line of its own. A list of dicts is an array of tables, such as "case"."""
    lines, blocks = [], []
    for name, value in tables.items():
        if isinstance(value, Mapping):
            blocks += ["", f"[{_key(name)}]", *_lines(value)]
        elif isinstance(value, (list, tuple)) and value and all(isinstance(one, Mapping) for one in value):
            for one in value:
                blocks += ["", f"[[{_key(name)}]]", *_lines(one)]
        else:
            lines += _lines({name: value})
    return "\n".join([*lines, *blocks]) + "\n"


def _lines(table: Mapping[str, Any]) -> list[str]:
    return [f"{_key(name)} = {value_text(value)}" for name, value in table.items()]


def _key(name: str) -> str:
    return name if BARE.fullmatch(name) else value_text(name)
