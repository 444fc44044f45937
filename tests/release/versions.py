"""One version: what CMakeLists.txt says is what the program, the change log, the citation and the recipes say.

    versions.py PROJECT_FOLDER PROGRAM
"""

import pathlib
import re
import subprocess
import sys

import yaml

# (file, what the version stands in); CMakeLists.txt is the place from which it comes.
PLACES = [
    ("CITATION.cff", r"^version: (\S+)$"),
    ("packaging/spack/package.py", r'^    version\("([^"]+)"\)$'),
    ("packaging/conda/recipe/meta.yaml", r'^  version: "([^"]+)"$'),
    ("python/floes_reader/__init__.py", r'^__version__ = "([^"]+)"  # of floes$'),
    ("README.md", r"floes_([0-9.]+)_amd64\.deb"),
    ("docs/start.md", r"floes_([0-9.]+)_amd64\.deb"),
    ("docs/start.md", r"spack dev-build floes@([0-9.]+) "),
    ("docs/tutorial.md", r"^    floes ([0-9.]+)$"),
]


def main():
    project, program = pathlib.Path(sys.argv[1]), sys.argv[2]
    files = ("CMakeLists.txt", "CHANGELOG.md", "CITATION.cff")
    text = {name: (project / name).read_text(encoding="utf-8") for name in files}
    version = re.search(r"^project\(floes VERSION (\S+)", text["CMakeLists.txt"], re.M)[1]
    faults = []

    said = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout
    if not said.startswith(f"floes {version}\n"):
        faults.append(f"the program says {said.splitlines()[0]}, and CMakeLists.txt {version}")
    for part in ("git_revision", "bullet", "hdf5", "mpi", "lane_widths"):
        if not re.search(rf"^{part}: \S+", said, re.M):
            faults.append(f"floes --version does not say {part}")

    headings = re.findall(r"^## (.*)$", text["CHANGELOG.md"], re.M)
    released = [heading for heading in headings if heading != "Unreleased"]
    if headings[0] != "Unreleased" or not re.fullmatch(rf"{re.escape(version)} - \d{{4}}-\d\d-\d\d", released[0]):
        faults.append(f"CHANGELOG.md begins with {headings[:2]}, not with Unreleased, then {version} and its date")
    for name, place in PLACES:
        found = re.search(place, (project / name).read_text(encoding="utf-8"), re.M)
        if found is None or found[1] != version:
            faults.append(f"{name} says {found and found[1]}, and CMakeLists.txt {version}")

    citation = yaml.safe_load(text["CITATION.cff"])
    if str(citation["date-released"]) != released[0].split(" - ")[-1]:
        faults.append(f"CITATION.cff has the date {citation['date-released']}, and CHANGELOG.md {released[0]}")
    if not all(citation.get(key) for key in ("cff-version", "message", "title", "authors", "license", "references")):
        faults.append("CITATION.cff lacks a part that its format requires")
    if citation["license"] != "BSD-3-Clause" or "BSD 3-Clause" not in (project / "LICENSE").read_text(encoding="utf-8"):
        faults.append("CITATION.cff and LICENSE do not name the same licence")

    print("\n".join(faults) or f"one version: {version}")
    sys.exit(bool(faults))


if __name__ == "__main__":
    main()
