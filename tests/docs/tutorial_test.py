#!/usr/bin/python3
"""Runs every command of docs/tutorial.md (or docs/year.md, docs/moorings.md) in order, and compares what it prints with what the page shows.

Usage: tutorial_test.py FLOES PAGE.md [--update]

A command is an indented line that begins with $; the lines below it are what it prints, where a line … stands for lines
that are left out. Blocks of Python run between them, in one Python. --update writes outputs and pictures anew, when the
physics, the defaults or the page changed; the picture of the report is made by Chromium.
"""
import contextlib
import io
import os
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PIECE = re.compile(r"^    \$ (?P<command>[^\n]*)\n(?P<shown>(?:    (?!\$ )[^\n]*\n|\n(?=\n*    (?!\$ )))*)"
                   r"|^```python\n(?P<code>.*?)^```\n(?:\n```text\n(?P<printed>.*?)^```\n)?", re.S | re.M)
PICTURE = re.compile(r"!\[[^\]]*\]\(tutorial/([^)]+)\)")
SPOKEN = re.compile(r"`([+-]?\d[^`]*)`")  # figures of outputs in the text
REPORT = "report.png"  # the first screen of my.html


def lines_of(text):
    return [line.rstrip() for line in text.rstrip("\n").splitlines()]


def anchor(line):
    """What a line begins with, up to its first number."""
    return " ".join(re.split(r"\d", line)[0].split())


def parts_of(shown):
    """Lines between those that are left out, and which of them begins the output."""
    parts = [[]]
    for line in shown:
        if line.strip() == "…":
            parts.append([])
        else:
            parts[-1].append(line)
    return parts


def renewed(shown, output, command):
    """The shown lines, each part as long as before, with what is printed now."""
    made, at = [], 0
    for number, part in enumerate(parts_of(shown)):
        made += ["…"] if number else []
        if not part:
            continue
        if number:
            found = [i for i in range(at, len(output)) if anchor(output[i]) == anchor(part[0])]
            if not found:
                sys.exit(f"`{command}` no longer prints a line that begins with: {anchor(part[0])}")
            at = found[0]
        made += output[at:at + len(part)]
        at += len(part)
    if "…" not in [line.strip() for line in shown] and at != len(output):
        return output
    return made


class Session:
    def __init__(self, floes, folder):
        self.folder, self.names, self.said = folder, {}, ""
        pathlib.Path(folder, "floes").symlink_to(floes)
        for name in ("configs", "docs"):
            pathlib.Path(folder, name).symlink_to(ROOT / name)
        self.environment = dict(os.environ, COLUMNS="112")

    def printed_by(self, command):
        run = subprocess.run(["sh", "-ec", command], cwd=self.folder, env=self.environment, capture_output=True,
                             text=True)
        if run.returncode != 0:
            sys.exit(f"`{command}` ends with {run.returncode}:\n{run.stdout}{run.stderr}")
        self.said += run.stdout
        return lines_of(run.stdout)

    def printed_by_block(self, code):
        output = io.StringIO()
        with contextlib.redirect_stdout(output):
            exec(compile(code, "a block of the tutorial", "exec"), self.names)
        return "".join(line + "\n" for line in lines_of(output.getvalue()))

    def piece(self, match):
        """A command or a block, with what it prints now."""
        if match["code"]:
            printed = self.printed_by_block(match["code"])
            return f"```python\n{match['code']}```\n" + (f"\n```text\n{printed}```\n" if match["printed"] else "")
        output = self.printed_by(match["command"])
        shown = [line[4:] for line in lines_of(match["shown"])]
        made = renewed(shown, output, match["command"]) if shown else []
        return f"    $ {match['command']}\n" + "".join(f"    {line}".rstrip() + "\n" for line in made)


def look_of(picture):
    """Width and height of a PNG, in pixels; of any other all that it has."""
    data = picture.read_bytes()
    return struct.unpack(">II", data[16:24]) if data.startswith(b"\x89PNG") else data


def photograph(folder):
    subprocess.run(["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
                    f"--screenshot={folder}/{REPORT}", "--window-size=900,730", f"file://{folder}/my.html"],
                   check=True, capture_output=True)


def main(floes, page_path, update):
    os.environ["MPLBACKEND"] = "agg"
    sys.path.insert(0, str(ROOT / "python"))
    sys.dont_write_bytecode = True
    page = page_path.read_text(encoding="utf-8")
    if len(PIECE.findall(page)) < 6:
        sys.exit(f"{page_path.name} has hardly any commands: {len(PIECE.findall(page))}")
    faults = []
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        session = Session(floes, folder)

        def checked(match):
            made = session.piece(match)
            if made != match[0] and not update:
                faults.append(f"the page shows\n{match[0]}and now it is\n{made}")
            return made

        made = PIECE.sub(checked, page)
        if update and REPORT in PICTURE.findall(page):
            photograph(folder)
        faults += [f"the page speaks of {number}, which no command prints now" for number in SPOKEN.findall(page)
                   if number not in session.said]
        for name in PICTURE.findall(page):
            drawn, kept = pathlib.Path(folder, name), page_path.parent / "tutorial" / name
            if name != REPORT and not drawn.exists():
                faults.append(f"no command of the page makes {name}")
            elif update:
                shutil.copy(drawn, kept)
            elif name != REPORT and look_of(drawn) != look_of(kept):
                faults.append(f"{name} has other pixels now, or other lines, than in the page")
        os.chdir(ROOT)
    if update:
        page_path.write_text(made, encoding="utf-8")
    if faults:
        sys.exit("\n".join(faults) + f"\n\n{page_path.name}: run tests/docs/tutorial_test.py FLOES PAGE.md --update")
    print(f"{len(PIECE.findall(page))} commands and blocks ran, and print what the page shows")


if __name__ == "__main__":
    if len(sys.argv) < 3 or sys.argv[3:] not in ([], ["--update"]):
        sys.exit(__doc__)
    main(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve(), "--update" in sys.argv)
