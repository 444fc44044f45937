#!/usr/bin/python3
"""The pages of the site, as pages.txt lists them. As a program: says which pages are missing there.

Usage: pages.py PROJECT_FOLDER
"""
import pathlib
import re
import sys

LIST = "docs/site/pages.txt"
FRONT = "README.md"
WHERE = ["*.md", "docs/*.md", "docs/notebook/*.ipynb", "slurm/*.md", "bench/*.md", "python/*.md", "packaging/*.md"]


def version_of(root):
    return re.search(r"project\(floes VERSION ([0-9.]+)", (root / "CMakeLists.txt").read_text(encoding="utf-8"))[1]


def groups_of(root):
    """Group -> its pages, as paths from the project's folder."""
    groups = {}
    for line in (root / LIST).read_text(encoding="utf-8").splitlines():
        if not line.strip() or line.startswith("#"):
            continue
        if not line.startswith(" "):
            groups[line.strip()] = []
        elif not groups:
            sys.exit(f"{LIST} lists {line.strip()} before the first group: write Manual above it.")
        else:
            list(groups.values())[-1].append(line.strip())
    return groups


def faults_of(root):
    """Sentences, one for each page that is there and not listed, or listed and not there."""
    groups = groups_of(root)
    listed = [page for pages in groups.values() for page in pages]
    there = {path.relative_to(root).as_posix() for pattern in WHERE for path in root.glob(pattern)} - {FRONT}
    for page in sorted(there - set(listed)):
        yield f"{LIST} does not list {page}: add it below {' or '.join(groups)}."
    for page in listed:
        if page not in there:
            yield f"{LIST} lists {page}, and there is no such page: remove the line, or give the page's new name."
    for page in sorted({page for page in listed if listed.count(page) > 1}):
        yield f"{LIST} lists {page} twice: keep one of the lines."


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    found = list(faults_of(pathlib.Path(sys.argv[1]).resolve()))
    print("\n".join(found) or "every page is listed")
    sys.exit(bool(found))
