"""The reader has the version of the floes beside it."""

import pathlib
import re

from setuptools import setup

FLOES = pathlib.Path(__file__).resolve().parent.parent / "CMakeLists.txt"

setup(version=re.search(r"project\(floes\s+VERSION\s+([\d.]+)", FLOES.read_text(encoding="utf-8"))[1])
