#!/usr/bin/python3
"""python/first_look.ipynb runs from top to bottom, cell by cell, and shows what it says.

    notebook.py FLOES PROJECT     (without Jupyter: what a cell ends with is shown as a notebook shows it)
"""
import ast
import json
import os
import pathlib
import subprocess
import sys
import tempfile

os.environ["MPLBACKEND"] = "agg"
FLOES, PROJECT = sys.argv[1], pathlib.Path(sys.argv[2])
sys.dont_write_bytecode = True
sys.path.insert(0, str(PROJECT / "python"))


def shown_by(cell, names):
    """Runs a cell; the HTML of the value that it ends with, or ""."""
    tree = ast.parse(cell)
    last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
    exec(compile(tree, "cell", "exec"), names)
    value = eval(compile(ast.Expression(last.value), "cell", "eval"), names) if last else None
    return value._repr_html_() if value is not None else ""


book = json.loads((PROJECT / "python/first_look.ipynb").read_text(encoding="utf-8"))
assert (book["nbformat"], book["nbformat_minor"]) == (4, 4)
for cell in book["cells"]:
    wanted = {"cell_type", "metadata", "source"} | ({"outputs", "execution_count"} if cell["cell_type"] == "code" else set())
    assert set(cell) == wanted, f"no cell of nbformat 4: {cell}"
    assert not cell.get("outputs"), "the notebook is stored without what it shows"
with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    subprocess.run([FLOES, "run", PROJECT / "configs/smoke.toml", "-o", "smoke.h5", "--set", "campaign.arrangements=2"],
                   check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    names = {}
    shown = [shown_by("".join(cell["source"]), names) for cell in book["cells"] if cell["cell_type"] == "code"]
    members = names["campaign"].members
    names["campaign"].close()
    closed = names["campaign"]._repr_html_()
    os.chdir("/")
assert sum(html != "" for html in shown) == 5, "not every table was shown"
assert f"{len(members)} members in 3 cases" in shown[0], shown[0]
for case in ("E30", "E60", "E200"):
    assert case in shown[0] and case in shown[1] and case in shown[3], f"{case} is not shown"
mean = members.mean_load[members.case == "E60"].mean()
assert f"{mean:.2f} [" in shown[0] and f"{mean:.2f}" in shown[1], f"{mean} is not shown"
assert len(names["figure"].axes) > 0 and names["long"].value.notna().any()
assert "closed" in closed and "<table" not in closed, closed
print(f"{len(shown)} cells ran")
