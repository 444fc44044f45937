#!/usr/bin/python3
"""docs/field.md: a table of every campaign of configs/gallery, and of each its purpose and a picture.

Usage: gallery.py FLOES [FOLDER]      FOLDER: where the campaign files are, or come to be; default: a temporary one

Runs what FOLDER lacks, a minute or two of one core. The comment at the top of a file is its purpose; a line "# picture: …" has
options of `floes replay` for the picture, which else is the moment of the largest load.
"""
import pathlib
import re
import subprocess
import sys
import tempfile
import textwrap

PROJECT = pathlib.Path(__file__).resolve().parents[2]
CONFIGS = PROJECT / "configs" / "gallery"
PAGE, PICTURES = PROJECT / "docs" / "field.md", PROJECT / "docs" / "gallery"
VIEW = ["--worst", "--size", "720x480"]


def comment(config):
    """The words before the first table, and the options of the picture."""
    lines = []
    for line in config.read_text().splitlines():
        if not line.startswith("#"):
            break
        lines.append(line.removeprefix("#").strip())
    options = [line.removeprefix("picture:").split() for line in lines if line.startswith("picture:")]
    return " ".join(line for line in lines if not line.startswith("picture:")), options[0] if options else VIEW


def figures(floes, campaign):
    """Of the only case, as the summary prints them: mean load, largest over 1 s, broken floes, members that are not steady."""
    text = subprocess.run([floes, "summarize", campaign], check=True, capture_output=True, text=True).stdout
    row = re.search(r"^E60 .*$", text, re.M).group()
    unsteady = re.search(r"^! (\d+) of \d+ members not steady", text, re.M)
    return [*re.split(r" {2,}", row)[2:5], unsteady.group(1) if unsteady else "–"]


def title(config):
    words = config.stem.replace("_", " ")
    return words[0].upper() + words[1:]


def entry(floes, config, folder):
    """Row of the table, and section."""
    purpose, view = comment(config)
    campaign = folder / f"{config.stem}.h5"
    subprocess.run([floes, "run", config, "-o", campaign, "--resume", "--threads", "1"], check=True, stdout=subprocess.DEVNULL)
    picture = PICTURES / f"{config.stem}.png"
    subprocess.run([floes, "replay", campaign, *view, "-o", picture], check=True, stdout=subprocess.DEVNULL)
    row = " | ".join([f"[{config.stem}](#{config.stem.replace('_', '-')})", *figures(floes, campaign)])
    return (f"| {row} |\n", f"## {title(config)}\n\n{textwrap.fill(purpose, 128)}\n\n![{title(config)}](gallery/{picture.name})\n")


def main(floes, folder):
    PICTURES.mkdir(exist_ok=True)
    rows, sections = zip(*(entry(floes, config, folder) for config in sorted(CONFIGS.glob("*.toml"))))
    before, mark, _ = PAGE.read_text().partition("<!-- gallery -->\n")
    PAGE.write_text(before + mark + "\n| campaign | mean load, N | largest over 1 s, N | broken floes, % | members not steady |\n"
                    "|---|---|---|---|---|\n" + "".join(rows) + "\n" + "\n".join(sections))


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    with tempfile.TemporaryDirectory() as temporary:
        main(sys.argv[1], pathlib.Path(sys.argv[2] if len(sys.argv) == 3 else temporary))
