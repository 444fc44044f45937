#!/usr/bin/python3
"""A notebook of docs/notebook runs from top to bottom and prints what is stored in it; its pictures have their sizes.

Usage: notebook_test.py FLOES PROJECT_FOLDER NOTEBOOK [--update]

--update stores what it shows now, without words of this machine.
"""
import base64
import json
import os
import pathlib
import re
import struct
import subprocess
import sys
import tempfile

PATHS = re.compile(r"/(?:home|root|tmp|usr|work|opt|var|srv)/\S*")


def executed(floes, project, name, folder):
    """The notebook with its outputs, run where only a clone's files are beside it."""
    (folder / "docs/notebook").mkdir(parents=True)
    (folder / "python").symlink_to(project / "python")
    (folder / name).write_bytes((project / name).read_bytes())
    environment = {**os.environ, "FLOES": str(floes), "HOME": str(folder), "PYTHONDONTWRITEBYTECODE": "1"}
    environment.pop("MPLBACKEND", None)  # the kernel has its own
    run = subprocess.run(["/usr/bin/python3", "-m", "nbconvert", "--to", "notebook", "--execute", "--inplace", "--log-level",
                          "ERROR", "--ExecutePreprocessor.timeout=900", "--ExecutePreprocessor.kernel_name=python3",
                          folder / name], env=environment, capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit(f"{name} does not run:\n{run.stdout}{run.stderr}")
    return json.loads((folder / name).read_text(encoding="utf-8"))


def plain(book):
    """Without times, identities of cells and the versions of this machine."""
    for number, cell in enumerate(book["cells"]):
        cell.pop("id", None)
        cell["metadata"] = {}
        for output in cell.get("outputs", []):
            if "data" in output:
                output["metadata"] = {}
            if "image/png" in output.get("data", {}):
                output["data"] = {"image/png": output["data"]["image/png"]}
        if cell["cell_type"] == "code":
            cell["execution_count"] = sum(one["cell_type"] == "code" for one in book["cells"][:number + 1])
    return {"cells": book["cells"],
            "metadata": {"kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
                         "language_info": {"name": "python"}},
            "nbformat": 4, "nbformat_minor": 4}


def shown(cell):
    """What it printed, and the sizes of what it drew."""
    for output in cell.get("outputs", []):
        if "text" in output:
            yield output.get("name", ""), "".join(output["text"])
        for kind, data in output.get("data", {}).items():
            if kind == "image/png":
                yield kind, struct.unpack(">II", base64.b64decode("".join(data))[16:24])
            else:
                yield kind, "".join(data)


def faults(stored, now):
    words = json.dumps(stored, ensure_ascii=False)
    yield from (f"the notebook has a path of a machine: {path}" for path in PATHS.findall(words))
    for number, (before, after) in enumerate(zip(stored["cells"], now["cells"]), start=1):
        if list(shown(before)) != list(shown(after)):
            yield f"cell {number} shows\n{list(shown(before))}\nand now\n{list(shown(after))}"
    if not any(kind == "image/png" for cell in now["cells"] for kind, _ in shown(cell)):
        yield "it draws no picture"
    if any(kind == "stderr" for cell in now["cells"] for kind, _ in shown(cell)):
        yield "it writes to standard error"


def main(floes, project, name, update):
    with tempfile.TemporaryDirectory() as folder:
        now = plain(executed(floes, project, name, pathlib.Path(folder)))
    if update:
        (project / name).write_text(json.dumps(now, ensure_ascii=False, indent=1) + "\n", encoding="utf-8")
    found = list(faults(json.loads((project / name).read_text(encoding="utf-8")), now))
    if found:
        sys.exit("\n".join(found) + "\n\nrun tests/docs/notebook_test.py FLOES PROJECT_FOLDER NOTEBOOK --update")
    print(f"{len(now['cells'])} cells ran, and show what is stored")


if __name__ == "__main__":
    if len(sys.argv) < 4 or sys.argv[4:] not in ([], ["--update"]):
        sys.exit(__doc__)
    program, folder = (pathlib.Path(one).resolve() for one in sys.argv[1:3])
    main(program, folder, f"docs/notebook/{sys.argv[3]}.ipynb", "--update" in sys.argv)
