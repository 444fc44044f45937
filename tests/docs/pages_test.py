#!/usr/bin/python3
"""Pages lead where they say: relative links and their headings exist, every page of docs/ says for whom it is and is
listed by the README, and what the README shows of a summary is what the tutorial shows.

Usage: pages_test.py PROJECT_FOLDER
"""
import pathlib
import re
import sys

LINK = re.compile(r"!?\[[^\]]*\]\(([^)\s]+)\)")
FOLDERS = [".", "docs", "slurm", "bench", "python", "packaging"]


def prose(text):
    """A page without its code, in which brackets are no links."""
    text = re.sub(r"^```.*?^```$", "", text, flags=re.S | re.M)
    return re.sub(r"`[^`\n]*`", "code", re.sub(r"^    .*$", "", text, flags=re.M))


def anchors(page):
    """Headings of a page as the ends of links, by GitHub's rule."""
    found = []
    text = re.sub(r"^```.*?^```$", "", page.read_text(encoding="utf-8"), flags=re.S | re.M)
    for heading in re.findall(r"^#+ (.*)$", text, re.M):
        words = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).lower()
        slug = re.sub(r"[^\w\- ]", "", words).replace(" ", "-")
        found.append(slug if slug not in found else f"{slug}-{found.count(slug)}")
    return found


def broken_links(page, root):
    for target in LINK.findall(prose(page.read_text(encoding="utf-8"))):
        if re.match(r"[a-z]+:", target):
            continue
        path, _, heading = target.partition("#")
        file = (page.parent / path).resolve() if path else page
        if not file.exists():
            yield f"{page.relative_to(root)}: there is no {target}"
        elif heading and file.suffix == ".md" and heading not in anchors(file):
            yield f"{page.relative_to(root)}: {file.name} has no heading #{heading}"


def faults(root):
    pages = [page for folder in FOLDERS for page in sorted((root / folder).glob("*.md"))]
    if len(pages) < 30:
        yield f"only {len(pages)} pages were found"
    for page in pages:
        yield from broken_links(page, root)
    readme = (root / "README.md").read_text(encoding="utf-8")
    for page in sorted((root / "docs").glob("*.md")):
        if not re.match(r"# .+\n\n\*For [^*]+\.\*\n", page.read_text(encoding="utf-8")):
            yield f"docs/{page.name} does not say below its title for whom it is, as *For ….*"
        if f"](docs/{page.name})" not in readme:
            yield f"README.md does not list docs/{page.name}"
    tutorial = (root / "docs/tutorial.md").read_text(encoding="utf-8")
    shown = [line for line in readme.splitlines() if line.startswith("    ") and "±" in line]
    if len(shown) < 2:
        yield "README.md shows no summary"
    for line in shown:
        if line not in tutorial:
            yield f"README.md shows a line of a summary that the tutorial has not: {line.strip()}"


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    found = list(faults(pathlib.Path(sys.argv[1]).resolve()))
    print("\n".join(found) or "all links lead somewhere")
    sys.exit(bool(found))
