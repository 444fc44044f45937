#!/usr/bin/python3
"""The declarations of src/ become pages: each header that tells its idea, each function with its comment; no warning.

Usage: api_test.py PROJECT_FOLDER
"""
import html
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(sys.argv[1]).resolve() if len(sys.argv) == 2 else sys.exit(__doc__)


def text_of(page):
    return " ".join(html.unescape(re.sub(r"<[^>]*>", "", page.read_text(encoding="utf-8"))).split())


def faults(folder):
    run = subprocess.run([ROOT / "docs/site/build.py", "--api", folder], capture_output=True, text=True)
    if run.returncode != 0 or pathlib.Path(run.stdout.strip()) != folder / "index.html":
        yield run.stdout + run.stderr
        return
    for header in sorted(ROOT.glob("src/*/*.hpp")):
        page = folder / (header.name.replace("_", "__").replace(".", "_8") + ".html")
        if not page.is_file():
            page = next(iter(folder.glob(f"{header.parent.name}_2{page.name}")), page)
        idea = header.read_text(encoding="utf-8").splitlines()[1].removeprefix("// ").split("`")[0].split("#")[0][:40].strip()
        if not page.is_file():
            yield f"{header.relative_to(ROOT)} has no page"
        elif idea not in text_of(page):
            yield f"the page of {header.relative_to(ROOT)} does not say: {idea}"
    if "nouns that take an s" not in text_of(folder / "text_8hpp.html"):
        yield "the page of core/text.hpp does not say what counted() gives"


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as stage:
        found = list(faults(pathlib.Path(stage, "an api")))
    print("\n".join(found) or "every header of src has its page")
    sys.exit(bool(found))
