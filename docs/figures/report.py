#!/usr/bin/python3
"""The pictures of docs/design_load.md: sections of a report, as headless Chromium shows them.

Usage: report.py REPORT.html [PICTURE ...]     (floes report CAMPAIGN.h5 -o REPORT.html; needs chromium and matplotlib)
"""
import pathlib
import re
import subprocess
import sys
import tempfile

import numpy as np
from matplotlib import pyplot

PICTURES = {
    "answer": ["The answer"],
    "worst": ["The worst moment"],
    "loads": ["Loads"],
    "design": ["Design load"],
    "where": ["Where the load acts", "Where floes fail"],
}
FOLDER = pathlib.Path(__file__).resolve().parent.parent / "report"


def photograph(page, picture, folder):
    source, raw = folder / "page.html", folder / "page.png"
    source.write_text(page)
    subprocess.run(["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
                    "--window-size=900,4200", f"--screenshot={raw}", source.as_uri()], check=True, capture_output=True)
    image = pyplot.imread(raw)
    rows, columns = np.nonzero((image[..., :3] < 0.99).any(axis=2))
    pyplot.imsave(picture, image[:rows.max() + 12, max(0, columns.min() - 12):columns.max() + 12])


def main(report, *wanted):
    text = pathlib.Path(report).read_text()
    head = text[:text.index("<h1>")].replace("prefers-color-scheme:dark", "prefers-color-scheme:none")
    sections = dict(re.findall(r"(?s)<section><h2>(.*?)</h2>(.*?)</section>", text))
    with tempfile.TemporaryDirectory() as folder:
        for name, titles in PICTURES.items():
            if wanted and name not in wanted:
                continue
            body = "".join(f"<section><h2>{title}</h2>{sections[title]}</section>" for title in titles if title in sections)
            photograph(head + body + "</body></html>", FOLDER / f"{name}.png", pathlib.Path(folder))


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(*sys.argv[1:])
