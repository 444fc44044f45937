"""For the tests of python/floes_reader: installs the package with pip, as a user does, and makes the campaign files
that they read. Arguments of the program: FLOES SYNTHETIC_FILE PROJECT."""

import atexit
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

FLOES, WRITER = sys.argv[1:3]
PROJECT = pathlib.Path(sys.argv[3])
AXES = """
[design]
method = "grid"
[[design.axis]]
key = "structure.keel_radius_m"
values = [0.40, 0.43]
[[design.axis]]
key = "general.time_step_s"
values = [0.01, 0.02]
[[case]]
name = "open"
field.far_end = "open"
[[case]]
name = "closed"
"""
CHANGES = ["campaign.arrangements=2", "analysis.steady_start_s=1", "analysis.window_s=3", "analysis.history_steps=2"]


def run(*command):
    return subprocess.run([str(part) for part in command], check=True, capture_output=True, text=True).stdout


def install():
    """Into SITE, by way of a source distribution, which must need nothing above python/. Made from a copy: building
    leaves files behind."""
    tree = FOLDER / "tree"
    shutil.copytree(PROJECT / "python", tree, ignore=shutil.ignore_patterns("build", "*.egg-info"))
    made = subprocess.run(["/usr/bin/python3", "-c", "from setuptools import build_meta; build_meta.build_sdist('.')"],
                          cwd=tree, check=True, capture_output=True, text=True)
    source = next(tree.glob("floes*reader-*.tar.gz"), None) or sys.exit(f"no source distribution: {made.stdout}")
    run("/usr/bin/python3", "-m", "pip", "install", "--quiet", "--no-index", "--no-build-isolation", "--no-deps",
        "--target", SITE, source)


def compute():
    smoke, axes = PROJECT / "configs/smoke.toml", FOLDER / "design.toml"
    run(WRITER, FULL)
    run(WRITER, EMPTY, "none")
    run(FLOES, "run", smoke, "-o", SMOKE)
    run(FLOES, "run", PROJECT / "configs/gallery/moored.toml", "-o", MOORED, "--set", "campaign.arrangements=2", "--set",
        "analysis.steady_start_s=4", "--set", "analysis.window_s=3")
    axes.write_text(smoke.read_text().split("[[case]]")[0] + AXES)
    run(FLOES, "run", axes, "-o", DESIGN, *(word for change in CHANGES for word in ("--set", change)))


_folder = tempfile.TemporaryDirectory()
atexit.register(_folder.cleanup)
FOLDER = pathlib.Path(_folder.name)
SITE = FOLDER / "site"
FULL, EMPTY, SMOKE, DESIGN, MOORED = (
    FOLDER / name for name in ("full.h5", "empty.h5", "smoke.h5", "design.h5", "moored.h5"))
install()
compute()
os.environ["FLOES"] = str(FLOES)  # of floes_reader
sys.path.insert(0, str(SITE))
