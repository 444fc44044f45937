#!/usr/bin/python3
"""The pictures and the film of docs/replay.md and README.md, of the largest load in the paper's tank.

Usage: replay.py FLOES CAMPAIGN.h5          (configs/table3_physical.toml with one arrangement; needs chromium, ffmpeg,
                                             and paraview with xvfb-run)
"""
import pathlib
import subprocess
import sys
import tempfile

import h5py

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "replay"
BROWSER = ["chromium", "--headless=new", "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader",
           "--enable-unsafe-swiftshader", "--hide-scrollbars", "--virtual-time-budget=8000"]


def photograph(page, view, picture, size):
    subprocess.run([*BROWSER, f"--window-size={size}", f"--screenshot={picture}", f"{page.as_uri()}#{view}"],
                   check=True, capture_output=True)


def largest(record):
    """Time of the frame with the largest load, s."""
    with h5py.File(record) as file:
        return file["time"][file["frames/surge_load"][()].argmax()]


def main(floes, campaign):
    FOLDER.mkdir(exist_ok=True)

    def replay(source, output, *options):
        subprocess.run([floes, "replay", source, *options, "-o", output], check=True)

    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        record, page, series = folder / "worst.h5", folder / "worst.html", folder / "worst.xdmf2"
        replay(campaign, record, "--worst", "--every", "0.2")
        replay(record, FOLDER / "fig5.png")
        replay(record, FOLDER / "below.png", "--view", "below", "--size", "960x600")
        replay(record, FOLDER / "utilisation.png", "--view", "above", "--colours", "utilisation", "--size", "960x600")
        replay(record, FOLDER / "plan.png", "--view", "plan", "--size", "1040x600")
        replay(record, FOLDER / "worst.webp", "--size", "720x450", "--rate", "12")
        replay(record, page)
        time = f"t={largest(record):.2f}"
        photograph(page, time, FOLDER / "page.png", "1280,860")
        replay(record, series)
        large = folder / "paraview.png"
        subprocess.run(["xvfb-run", "-a", "-s", "-noreset", "pvpython", series.with_suffix(".py"), "--screenshot",
                        large], check=True)
        subprocess.run(["ffmpeg", "-loglevel", "error", "-y", "-i", large, "-vf", "scale=960:-1", FOLDER /
                        "paraview.png"], check=True)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
