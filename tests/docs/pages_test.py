#!/usr/bin/python3
"""Pages lead where they say: relative links and their headings exist, docs/index.md lists every page of docs/ and all that
the site lists, in the same order, every table has a head and rows, and what the README shows of a summary is what the
tutorial shows.

Usage: pages_test.py PROJECT_FOLDER
"""
import pathlib
import re
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "docs/site"))
import pages as site  # noqa: E402

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


def torn_tables(page, root):
    """Lines of dashes without a head above or a row below."""
    lines = ["", *prose(page.read_text(encoding="utf-8")).splitlines(), ""]
    for before, line, after in zip(lines, lines[1:], lines[2:]):
        if re.fullmatch(r"\|[-|: ]*-[-|: ]*\|", line) and not (before.startswith("|") and after.startswith("|")):
            yield f"{page.relative_to(root)}: a table lacks its head or its rows, below {before!r}"


def listed_by(index, root):
    """Group -> the pages that docs/index.md links below it, as paths from the project's folder."""
    groups = {}
    for heading, text in re.findall(r"^## (.*)\n((?:(?!## ).*\n?)*)", index.read_text(encoding="utf-8"), re.M):
        targets = [target.partition("#")[0] for target in re.findall(r"^\* \[[^\]]*\]\(([^)\s]+)\): \S", text, re.M)]
        groups[heading] = [(index.parent / target).resolve().relative_to(root).as_posix() for target in targets]
    return groups


def faults_of_index(root):
    index = root / "docs/index.md"
    shown = listed_by(index, root)
    of_site = {group: [name for name in names if name != "docs/index.md"] for group, names in site.groups_of(root).items()}
    if list(shown) != list(of_site):
        yield f"docs/index.md has the groups {list(shown)}, and {site.LIST} {list(of_site)}"
    for group in of_site:
        ours, theirs = shown.get(group, []), of_site[group]
        yield from (f"docs/index.md does not list {name} under {group}, with what it answers" for name in theirs
                    if name not in ours)
        yield from (f"{site.LIST} does not list {name} under {group}, and docs/index.md does" for name in ours
                    if name not in theirs)
        if sorted(ours) == sorted(theirs) and ours != theirs:
            yield f"docs/index.md and {site.LIST} list {group} in another order"
    for page in sorted((root / "docs").glob("*.md")):
        if page != index and f"docs/{page.name}" not in sum(shown.values(), []):
            yield f"docs/index.md does not list docs/{page.name}"


def faults(root):
    pages = [page for folder in FOLDERS for page in sorted((root / folder).glob("*.md"))]
    if len(pages) < 30:
        yield f"only {len(pages)} pages were found"
    for page in pages:
        yield from broken_links(page, root)
        yield from torn_tables(page, root)
    yield from faults_of_index(root)
    for page in sorted((root / "docs").glob("*.md")):
        if not page.read_text(encoding="utf-8").startswith("# "):
            yield f"docs/{page.name} does not begin with a title"
    readme = (root / "README.md").read_text(encoding="utf-8")
    if "](docs/index.md)" not in readme:
        yield "README.md does not lead to docs/index.md"
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
