"""Sphinx makes the site of the project's pages as they stand: no page is written for it, none is moved."""
import json
import pathlib
import re
import shutil
import sys

from docutils import nodes
from sphinx import addnodes

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(HERE))
import pages  # noqa: E402
from notebook import NotebookParser  # noqa: E402

groups = pages.groups_of(ROOT)
listed = [pages.FRONT, *(page for group in groups.values() for page in group)]

project = "floes"
version = release = pages.version_of(ROOT)
extensions = ["myst_parser"]
root_doc = pages.FRONT.removesuffix(".md")
include_patterns = listed
exclude_patterns = [path.name for path in ROOT.iterdir() if path.name not in {page.split("/")[0] for page in listed}]
# Pages are Markdown as GitHub shows it, so what MyST adds to it is off, and headings have GitHub's anchors.
myst_heading_anchors = 6
myst_disable_syntax = ["myst_line_comment", "myst_block_break", "myst_target", "myst_role"]
highlight_language = "none"
smartquotes = False

html_theme = "furo"
html_title = f"floes {version}"
html_static_path = ["static"]
templates_path = ["templates"]
html_css_files = ["site.css"]
html_js_files = ["site.js"]
html_use_index = html_copy_source = html_show_copyright = False
html_sidebars = {"**": ["sidebar/brand.html", *(["sidebar/versions.html"] if tags.has("versions") else []),  # noqa: F821
                        "sidebar/search.html", "sidebar/scroll-start.html", "sidebar/navigation.html",
                        "sidebar/scroll-end.html"]}


def add_navigation(app, page, source):
    """The groups of pages.txt stand below the front page; GitHub does not see them."""
    if page == root_doc:
        for group, names in groups.items():
            lines = [f"/{name.rsplit('.', 1)[0]}" for name in names]
            source[0] += "\n\n" + "\n".join(["```{toctree}", ":hidden:", f":caption: {group}", "", *lines, "```"]) + "\n"


def give_githubs_anchors(app, doctree):
    """Sphinx leaves out of an anchor what is not ASCII; links from elsewhere have what GitHub makes."""
    for section in doctree.findall(nodes.section):
        anchor = section.get("myst-anchor", "").partition("#")[2]
        if anchor and anchor not in section["ids"]:
            section["ids"].insert(0, anchor)


def unlink_folders(app, doctree):
    """A link to a folder of the source leads nowhere in the site; its name says enough."""
    for link in list(doctree.findall(addnodes.pending_xref)):
        if pathlib.Path(app.env.doc2path(app.env.docname)).parent.joinpath(link["reftarget"]).is_dir():
            link.replace_self(link.children)


# Sphinx adds these for themes that are older than ours.
UNUSED = ["jquery.js", "underscore.js", "_sphinx_javascript_frameworks_compat.js"]


def leave_out(app, page, template, context, doctree):
    context["script_files"] = [file for file in context["script_files"] if pathlib.Path(file).name not in UNUSED]
    context["metatags"] = ""  # only names the generator and its address


def complete(app, exception):
    """What the finished pages lack to be read from a disk."""
    if exception:
        return
    site = pathlib.Path(app.outdir)
    shutil.copy(site / f"{root_doc}.html", site / "index.html")
    # For static/search.js.
    texts = {page: app.env.get_doctree(page).astext() for page in sorted(app.env.found_docs)}
    (site / "_static/texts.js").write_text(f"const siteTexts = {json.dumps(texts, ensure_ascii=False)};\n", encoding="utf-8")
    bundle_theme(site / "_static")
    for name in [*(f"_static/{name}" for name in UNUSED), ".buildinfo"]:
        (site / name).unlink(missing_ok=True)


def bundle_theme(static):
    """Debian's Furo is for a web server: its style is imported from /javascript, and its script is a module that imports
    another. From a disk neither is loaded, so what is imported is put in its place. Its style, moreover, is dark only for
    those who press the button, not for those whose browser asks for it. Furo from elsewhere passes unchanged."""
    path = static / "styles/furo.css"
    style = re.sub(r"@import url\((/javascript/[^)]+)\);",
                   lambda found: pathlib.Path("/usr/share" + found[1]).read_text(encoding="utf-8"),
                   path.read_text(encoding="utf-8"))
    if "prefers-color-scheme" not in style:
        dark = re.search(r'body\[data-theme="dark"\] (\{[^}]*\})', style)[1]
        style += f'@media screen and (prefers-color-scheme: dark) {{ body:not([data-theme="light"]) {dark} }}\n'
    path.write_text(style, encoding="utf-8")
    path, module = static / "scripts/furo.js", static / "scripts/gumshoe-patched.js"
    script, imports = re.subn(r'^import Gumshoe from "./gumshoe-patched.js";\n', "", path.read_text(encoding="utf-8"))
    if imports:
        path.write_text(module.read_text(encoding="utf-8") + script, encoding="utf-8")
        module.unlink()


def setup(app):
    app.add_source_suffix(".ipynb", "notebook")
    app.add_source_parser(NotebookParser)
    app.connect("source-read", add_navigation)
    app.connect("doctree-read", give_githubs_anchors, priority=100)
    app.connect("doctree-read", unlink_folders, priority=100)
    app.connect("html-page-context", leave_out, priority=900)
    app.connect("build-finished", complete, priority=900)
