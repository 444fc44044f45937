#!/usr/bin/python3
"""Floes at a gap keep their threshold: of floes of 0.08 of the gap none arch, of a third of it some do (docs/trends.md).

Usage: arch_test.py FLOES CONFIGURATION
"""
import pathlib
import subprocess
import sys
import tempfile

import h5py

CASES = ["side_0.08", "side_0.33"]
ARRANGEMENTS = 6


def with_cases(text):
    head, *cases = text.split("[[case]]\n")
    return "[[case]]\n".join([head] + [one for one in cases if any(f'name = "{name}"' in one for name in CASES)])


def main(floes, configuration):
    text = with_cases(pathlib.Path(configuration).read_text(encoding="utf-8"))
    with tempfile.TemporaryDirectory() as folder:
        own = pathlib.Path(folder) / "arch.toml"
        own.write_text(text, encoding="utf-8")
        subprocess.run([floes, "run", own.name, "--set", f"campaign.arrangements={ARRANGEMENTS}"], cwd=folder, check=True)
        with h5py.File(own.with_suffix(".h5")) as file:
            assert (file["members/status"][:] == 0).all(), "a member failed"
            names = file["cases/name"].asstr()[()]
            assert list(names) == CASES, names
            passed = {name: file["members/floes_astern"][:][file["members/case"][:] == k] for k, name in enumerate(names)}
    print(passed)
    assert (passed["side_0.08"] > 0).all(), "small floes arched"
    assert (passed["side_0.33"] == 0).any(), "no large floes arched"


if __name__ == "__main__":
    main(*sys.argv[1:])
