"""Pages of which some blocks are made from data: between <!-- NAME --> and <!-- end -->."""
import pathlib
import sys


def filled(page, blocks, path):
    """The text of the page at `path` with each block made anew; `blocks`: name -> function that gives Markdown."""
    for name, make in blocks.items():
        begin = f"<!-- {name} -->\n"
        if begin not in page:
            sys.exit(f"docs/{path.name} has no place for {name}: write {begin.strip()} and <!-- end -->")
        head, rest = page.split(begin, 1)
        page = head + begin + "\n" + make() + "\n<!-- end -->" + rest.split("<!-- end -->", 1)[1]
    return page


def fill_or_check(pages, check, script):
    """`pages`: path -> blocks. Writes the pages, or fails if one differs from the data."""
    for path, blocks in pages.items():
        path = pathlib.Path(path)
        page = path.read_text()
        made = filled(page, blocks, path)
        if check and made != page:
            sys.exit(f"docs/{path.name} differs from its data; run docs/figures/{script}")
        if not check:
            path.write_text(made)
