#!/usr/bin/python3
"""The pictures and the film of docs/replay.md and README.md, of the worst moment of case E60.

Usage: replay.py FLOES CAMPAIGN.h5          (a campaign of configs/table3_physical.toml; needs chromium, ffmpeg, and
                                             paraview with xvfb-run)
"""
import pathlib
import subprocess
import sys
import tempfile

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "replay"
BROWSER = ["chromium", "--headless=new", "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader",
           "--enable-unsafe-swiftshader", "--hide-scrollbars", "--virtual-time-budget=8000"]


def photograph(page, view, picture, size, *options):
    subprocess.run([*BROWSER, f"--window-size={size}", f"--screenshot={picture}", *options, f"{page.as_uri()}#{view}"],
                   check=True, capture_output=True)


def main(floes, campaign):
    FOLDER.mkdir(exist_ok=True)

    def replay(source, output, *options):
        subprocess.run([floes, "replay", source, *options, "-o", output], check=True)

    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        record, page, series = folder / "worst.h5", folder / "worst.html", folder / "worst.pvd"
        worst = ["--worst", "--case", "E60"]
        replay(campaign, record, *worst)
        replay(record, FOLDER / "fig5.png")
        replay(record, FOLDER / "below.png", "--view", "below", "--size", "960x600")
        replay(record, FOLDER / "utilisation.png", "--view", "above", "--colours", "utilisation", "--size", "960x600")
        replay(record, FOLDER / "plan.png", "--view", "plan", "--size", "1040x600")
        replay(record, page)
        for name, view, size in (("page", "t=241.36", "1280,860"), ("page_above", "t=241.36&view=above", "1280,860"),
                                 ("page_phone", "t=241.36&view=below", "420,900")):
            photograph(page, view, FOLDER / f"{name}.png", size, *(["--force-dark-mode"] if "above" in name else []))
        replay(record, series)
        large = folder / "paraview.png"
        subprocess.run(["xvfb-run", "-a", "-s", "-noreset", "pvpython", series.with_suffix(".py"), "--screenshot",
                        large], check=True)
        subprocess.run(["ffmpeg", "-loglevel", "error", "-y", "-i", large, "-vf", "scale=960:-1", FOLDER /
                        "paraview.png"], check=True)
        slow = folder / "slow.h5"
        replay(campaign, slow, *worst, "--every", "0.2")
        replay(slow, FOLDER / "worst.webp", "--size", "720x450", "--rate", "12")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
