#!/usr/bin/python3
"""Runs the blocks of docs/reading_the_file.md, up to "Without the package", in order, in one Python, and compares what they print with what stands below them.

Usage: python_page.py SMOKE.h5 [--update]     (floes run configs/smoke.toml -o SMOKE.h5; needs matplotlib)

--update writes what they print and their pictures anew, when the physics, the defaults or the page changed.
"""
import contextlib
import difflib
import io
import os
import pathlib
import re
import shutil
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE, PICTURES = ROOT / "docs/reading_the_file.md", ROOT / "docs/python"
BLOCK = re.compile(r"```python\n(?P<code>.*?)```\n(?:\n```text\n.*?```\n)?", re.S)


def run(page):
    """The page with what its blocks print, which run in the current folder."""
    names = {}

    def printed(block):
        output = io.StringIO()
        with contextlib.redirect_stdout(output):
            exec(compile(block["code"], f"the block '{block['code'].splitlines()[0]}'", "exec"), names)
        lines = "".join(line.rstrip() + "\n" for line in output.getvalue().splitlines())
        return f"```python\n{block['code']}```\n" + (f"\n```text\n{lines}```\n" if lines else "")

    own, heading, others = page.partition("\n## Without the package\n")
    return BLOCK.sub(printed, own) + heading + others


def main(campaign, update):
    os.environ["MPLBACKEND"] = "agg"
    sys.path.insert(0, str(ROOT / "python"))
    sys.dont_write_bytecode = True
    page = PAGE.read_text(encoding="utf-8")
    with tempfile.TemporaryDirectory() as folder:
        shutil.copy(campaign, f"{folder}/smoke.h5")
        os.chdir(folder)
        made = run(page)
        pictures = {path.name for path in pathlib.Path(folder).glob("*.png")}
        if pictures != set(re.findall(r"\]\(python/(.*?\.png)\)", page)):
            sys.exit(f"the blocks of {PAGE.name} draw {sorted(pictures)}, and the page shows others")
        if update:
            PAGE.write_text(made, encoding="utf-8")
            for name in pictures:
                shutil.copy(name, PICTURES)
        os.chdir(ROOT)
    if made != page and not update:
        lines = page.splitlines(True), made.splitlines(True)
        sys.stdout.writelines(difflib.unified_diff(*lines, "the page", "the blocks"))
        sys.exit(f"{PAGE.name} does not show what its blocks print; run docs/figures/python_page.py SMOKE.h5 --update")


if __name__ == "__main__":
    if len(sys.argv) < 2 or sys.argv[2:] not in ([], ["--update"]):
        sys.exit(__doc__)
    main(pathlib.Path(sys.argv[1]).resolve(), "--update" in sys.argv)
