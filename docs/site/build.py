#!/usr/bin/python3
"""Builds the pages as a site that opens without a network, and prints where its first page is. ./floes docs runs this.

Usage: build.py [-o FOLDER | --versions FOLDER | --api FOLDER]

-o: into FOLDER, in place of build/docs/html. --versions: into FOLDER/VERSION, beside other releases that were built so;
the pages of each link to all that are there. --api: what the headers of src/ declare, from their comments, into FOLDER.
"""
import importlib.util
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(HERE))
sys.dont_write_bytecode = True
import pages  # noqa: E402


def stop(message, status=1):
    print(f"floes docs: {message}", file=sys.stderr)
    sys.exit(status)


def need(missing):
    """Stops if packages are missing."""
    if missing:
        stop(f"{sys.executable} has no {' and no '.join(missing)}; packaging/debian/packages-docs.txt names what Debian "
             "has of them.", 2)


def check():
    """Stops if the site cannot be built: a package is missing, or a page is."""
    need([name for name, module in {"Sphinx": "sphinx", "MyST-Parser": "myst_parser", "Furo": "furo"}.items()
          if not importlib.util.find_spec(module)])
    faults = list(pages.faults_of(ROOT))
    if faults:
        stop("\n".join(faults))


def build(target, make):
    """What `make` makes in a folder becomes `target`, whole or not at all. A warning is an error."""
    target.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix=".site-", dir=target.parent) as stage:
        made = pathlib.Path(stage, "html")
        if make(made).returncode != 0:
            stop(f"the site was not built; the messages above say why. {target} is as it was.")
        shutil.rmtree(target, ignore_errors=True)
        made.rename(target)


def site(made, versions=False):
    words = ["-q", "-W", "--keep-going", "-b", "html", "-c", HERE, "-d", made.parent / "doctrees"]
    words += ["-t", "versions"] if versions else []
    return subprocess.run([sys.executable, "-B", "-m", "sphinx", *words, ROOT, made])


def api(made):
    made.mkdir()
    asked = f'{(HERE / "Doxyfile").read_text()}\nPROJECT_NUMBER = {pages.version_of(ROOT)}\nOUTPUT_DIRECTORY = "{made}"\n'
    return subprocess.run(["doxygen", "-"], input=asked, text=True, cwd=ROOT)


def list_versions(folder):
    """Writes which releases are in the folder, the newest first, and which pages each has."""
    def number(name):
        return [int(part) for part in re.findall(r"\d+", name)]

    there = sorted((path.parent for path in folder.glob("*/index.html")), key=lambda path: number(path.name), reverse=True)
    listed = {path.name: sorted(page.relative_to(path).as_posix() for page in path.rglob("*.html")) for path in there}
    (folder / "versions.js").write_text(f"showVersions({json.dumps(listed)});\n", encoding="utf-8")


def main(words):
    if words not in ([], ["-h"], ["--help"]) and (len(words) != 2 or words[0] not in ("-o", "--versions", "--api")):
        stop(f"there is no '{' '.join(words)}'. {__doc__.splitlines()[2]}", 2)
    if words and words[0] in ("-h", "--help"):
        print(__doc__.strip())
        return
    how = words[0] if words else "-o"
    target = pathlib.Path(words[1]).resolve() if words else ROOT / "build/docs/html"
    if how == "--api":
        need([] if shutil.which("doxygen") else ["doxygen"])
        build(target, api)
    else:
        check()
    if how == "-o":
        build(target, site)
    elif how == "--versions":
        folder, target = target, target / pages.version_of(ROOT)
        build(target, lambda made: site(made, versions=True))
        list_versions(folder)
    print(target / "index.html")


if __name__ == "__main__":
    main(sys.argv[1:])
