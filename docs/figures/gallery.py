#!/usr/bin/python3
"""docs/field.md: of every campaign of configs/gallery its purpose and a picture.

Usage: gallery.py FLOES [FOLDER]      FOLDER: where the campaign files are, or come to be; default: a temporary one

Runs what FOLDER lacks, a minute or two of one core. The comment at the top of a file is its purpose; a line "# picture: …" has
options of `floes replay` for the picture, which else is the moment of the largest load.
"""
import pathlib
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


def title(config):
    words = config.stem.replace("_", " ")
    return words[0].upper() + words[1:]


def entry(floes, config, folder):
    """Its section."""
    purpose, view = comment(config)
    campaign = folder / f"{config.stem}.h5"
    subprocess.run([floes, "run", config, "-o", campaign, "--resume", "--threads", "1"], check=True, stdout=subprocess.DEVNULL)
    picture = PICTURES / f"{config.stem}.png"
    subprocess.run([floes, "replay", campaign, *view, "-o", picture], check=True, stdout=subprocess.DEVNULL)
    return f"### {title(config)}\n\n{textwrap.fill(purpose, 128)}\n\n![{title(config)}](gallery/{picture.name})\n"


def main(floes, folder):
    PICTURES.mkdir(exist_ok=True)
    sections = [entry(floes, config, folder) for config in sorted(CONFIGS.glob("*.toml"))]
    before, mark, _ = PAGE.read_text().partition("<!-- gallery -->\n")
    PAGE.write_text(before + mark + "\n" + "\n".join(sections))


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    with tempfile.TemporaryDirectory() as temporary:
        main(sys.argv[1], pathlib.Path(sys.argv[2] if len(sys.argv) == 3 else temporary))
