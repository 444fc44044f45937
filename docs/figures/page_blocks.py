"""Pages of which some blocks are made from data: between <!-- NAME --> and <!-- end -->."""
import inspect
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


def make(pages, usage, **first):
    """What a page's script does: writes `pages`, path -> blocks; with --check only compares them; with --WORD first calls
    first[WORD] with the words behind it. Returns whether it wrote them."""
    words = sys.argv[1:]
    act = first.get(words[0].removeprefix("--")) if words else None
    try:
        if act is not None:
            inspect.signature(act).bind(*words[1:])
        elif words not in ([], ["--check"]):
            raise TypeError
    except TypeError:
        sys.exit(usage)
    if act is not None:
        act(*words[1:])
    fill_or_check(pages, words == ["--check"], pathlib.Path(sys.argv[0]).name)
    return words != ["--check"]
