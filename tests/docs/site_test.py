#!/usr/bin/python3
"""The site of the pages is built and opened: every page is there, every link and anchor leads somewhere, nothing is asked of
the network, the search finds words on a disk, and no page is wider than a phone.

Usage: site_test.py PROJECT_FOLDER
"""
import html
import html.parser
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import urllib.parse

sys.dont_write_bytecode = True
ROOT = pathlib.Path(sys.argv[1]).resolve() if len(sys.argv) == 2 else sys.exit(__doc__)
sys.path[:0] = [str(ROOT / "docs/site"), str(ROOT / "tests/docs")]
import build  # noqa: E402
import pages  # noqa: E402
import pages_test  # noqa: E402

LOADING = {"src", "srcset", "poster", "data", "action"}  # and href of all but <a>
PHONE = 420  # pixels


class Seen(html.parser.HTMLParser):
    """Of a page: its anchors, where its links lead, what the browser loads for it."""

    def __init__(self, path):
        super().__init__()
        self.anchors, self.links, self.loaded = set(), [], []
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name == "id":
                self.anchors.add(value)
            elif name == "href" and tag == "a":
                self.links.append(value)
            elif name in LOADING or name == "href":
                self.loaded.append(value)


def outside(address):
    return bool(re.match(r"[a-z]+:|/", address)) and not address.startswith("data:")


def faults_of_links(site, seen, written):
    """`written`: the text of all pages, in which every address of the network stands."""
    for path, page in seen.items():
        name = path.relative_to(site)
        for address in page.loaded:
            if outside(address):
                yield f"{name} loads {address}"
        for address in page.links + page.loaded:
            if address.startswith("data:"):
                continue
            if outside(address):
                if address not in written:
                    yield f"{name} leads to {address}, which no page says"
                continue
            file, _, anchor = urllib.parse.unquote(address.split("?")[0]).partition("#")
            target = (path.parent / file).resolve() if file else path
            if urllib.parse.urlparse(address).path and not target.is_file():
                yield f"{name}: there is no {address}"
            elif anchor and target in seen and anchor not in seen[target].anchors:
                yield f"{name}: {target.name} has no #{anchor}"


def faults_of_network(site):
    """Addresses in scripts and styles, but for those in comments, and what a style imports."""
    for path in [*site.rglob("*.js"), *site.rglob("*.css")]:
        if path.name in ("texts.js", "searchindex.js"):  # words of the pages
            continue
        text = re.sub(r"/\*.*?\*/|^\s*//[^\n]*", "", path.read_text(encoding="utf-8"), flags=re.S | re.M)
        for address in re.findall(r"https?://(?!www\.w3\.org/)\S+|@import[^;]*|url\(['\"]?/[^)]*\)|^import .*$", text, re.M):
            yield f"{path.relative_to(site)} has {address}"


def faults_of_pages(site, listed):
    version = pages.version_of(ROOT)
    for name in listed:
        page = site / pathlib.Path(name).with_suffix(".html")
        if not page.is_file():
            yield f"{name} is no page of the site"
            continue
        text = page.read_text(encoding="utf-8")
        if f"floes {version}" not in text:
            yield f"{name} does not say that it is of version {version}"
        for group in pages.groups_of(ROOT):
            if f">{group}</span>" not in text:
                yield f"{name} has no group {group} in its navigation"
        if name.endswith(".md"):
            there = Seen(page).anchors
            yield from (f"{name} has no anchor #{anchor} in the site" for anchor in pages_test.anchors(ROOT / name)
                        if anchor not in there)
    for path in site.rglob("*"):
        if path.suffix in (".html", ".js", ".css", ".txt") and str(ROOT) + "/" in path.read_text(encoding="utf-8"):
            yield f"{path.relative_to(site)} names the folder in which it was built"


def opened(address, *options):
    """The page as it is when its scripts have run, and what the browser wrote on its console."""
    with tempfile.TemporaryDirectory() as profile:
        run = subprocess.run(["chromium", "--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--disable-gpu",
                              f"--user-data-dir={profile}", "--enable-logging=stderr", "--virtual-time-budget=60000",
                              "--window-size=1280,1000", *options, "--dump-dom", address],
                             capture_output=True, text=True, timeout=200, check=True)
    return run.stdout, [line for line in run.stderr.splitlines() if "CONSOLE" in line]


def faults_of_search(site):
    found, console = opened((site / "search.html").as_uri() + "?q=added+mass")
    yield from (f"the search says on the console: {line}" for line in console)
    results = re.findall(r'<a href="([^"]*)"[^>]*>.*?</a>.*?<p class="context">(.*?)</p>', found, re.S)
    if len(results) < 3:
        yield f"the search of 'added mass' finds {len(results)} pages with their words"
    elif "mass</span>" not in results[0][1]:
        yield f"the search of 'added mass' shows of {results[0][0]}: {results[0][1]}"


WIDTHS = """<!doctype html><iframe style="width: {width}px; height: 900px; border: 0"></iframe><script>
const frame = document.querySelector("iframe"), names = {names}, notes = {{}};
const next = () => names.length ? frame.src = names.shift() : document.body.dataset.notes = JSON.stringify(notes);
frame.onload = () => {{
  const page = frame.contentDocument;
  notes[frame.src] = [page.documentElement.scrollWidth, page.querySelector(".content").scrollWidth,
                      [...page.images].filter((image) => !image.naturalWidth).map((image) => image.src)];
  next();
}};
next();
</script>"""


def faults_of_widths(site, names):
    """Every page in a frame as wide as a phone: only its tables and blocks of code scroll, and its pictures are seen."""
    frame = site / "widths.html"
    frame.write_text(WIDTHS.format(width=PHONE, names=json.dumps(names)), encoding="utf-8")
    shown, console = opened(frame.as_uri(), "--allow-file-access-from-files")
    frame.unlink()
    notes = re.search(r'data-notes="([^"]*)"', shown)
    if not notes:
        yield "the pages were not opened in time"
        return
    notes = json.loads(html.unescape(notes[1]))
    if len(notes) != len(names):
        yield f"{len(notes)} of {len(names)} pages were opened"
    for page, (width, content, unseen) in notes.items():
        name = pathlib.Path(page).name
        if max(width, content) > PHONE:
            yield f"{name} is {max(width, content)} pixels wide on a phone of {PHONE}"
        yield from (f"{name} does not show {picture}" for picture in unseen)
    yield from (f"the pages say on the console: {line}" for line in console)


def faults_of_list(folder):
    """What is said of a list that does not have the pages."""
    (folder / "docs/site").mkdir(parents=True)
    for name in ("README.md", "docs/one.md", "docs/two.md"):
        (folder / name).write_text("# A page\n", encoding="utf-8")
    (folder / pages.LIST).write_text("# why\nManual\n\n    docs/one.md\n    docs/one.md\nEvidence\n    docs/three.md\n",
                                     encoding="utf-8")
    said = list(pages.faults_of(folder))
    for word in ("does not list docs/two.md", "lists docs/three.md, and there is no such page", "lists docs/one.md twice"):
        if sum(word in sentence for sentence in said) != 1:
            yield f"of a list with faults it is said: {said}"


def faults_of_versions(folder, listed):
    """Two releases side by side: each is listed, the newest first, with its pages; a page leads to itself in the other."""
    version = pages.version_of(ROOT)
    old = folder / "1.9.0/docs"
    old.mkdir(parents=True)
    for page in (folder / "1.9.0/index.html", old / "tutorial.html"):
        page.write_text("<!doctype html><title>old</title>", encoding="utf-8")
    built(folder, "--versions")
    text = (folder / "versions.js").read_text(encoding="utf-8")
    versions = json.loads(text.removeprefix("showVersions(").removesuffix(");\n"))
    if list(versions) != [version, "1.9.0"] or versions["1.9.0"] != ["docs/tutorial.html", "index.html"]:
        yield f"versions.js has {text[:200]}"
    for page, other in {"docs/tutorial": "../../1.9.0/docs/tutorial.html", "docs/year": "../../1.9.0/index.html"}.items():
        if f"{page}.md" not in listed:
            continue
        shown, console = opened((folder / version / f"{page}.html").as_uri())
        link = re.search(r'<nav class="versions".*?<strong>(.*?)</strong><a href="(.*?)">1.9.0</a>', shown, re.S)
        path = link and (folder / version / "docs" / link[2]).resolve()
        if not link or link[1] != version or path != (folder / version / "docs" / other).resolve() or console:
            yield f"{page}.html shows of the versions {link and link[0]}; console: {console}"


def built(folder, option="-o"):
    run = subprocess.run([ROOT / "docs/site/build.py", option, folder], capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit(run.stdout + run.stderr)
    return pathlib.Path(run.stdout.strip()).parent


def faults(folder):
    listed = [pages.FRONT, *(page for group in pages.groups_of(ROOT).values() for page in group)]
    written = "".join((ROOT / name).read_text(encoding="utf-8") for name in listed)
    site = built(folder / "a site")  # with a space, as folders have
    seen = {path: Seen(path) for path in site.rglob("*.html")}
    if site / "index.html" not in seen:
        yield "the site has no index.html"
    yield from faults_of_pages(site, listed)
    yield from faults_of_links(site, seen, written)
    yield from faults_of_network(site)
    yield from faults_of_search(site)
    yield from faults_of_widths(site, sorted(path.relative_to(site).as_posix() for path in seen))
    yield from faults_of_list(folder / "list")
    yield from faults_of_versions(folder / "releases", listed)


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as stage:
        found = list(faults(pathlib.Path(stage)))
    print("\n".join(found) or "the site is whole")
    sys.exit(bool(found))
