#!/usr/bin/python3
"""The page of a matching of a small real campaign, opened in headless Chromium: as page_in_browser.py looks at pages.

Usage: match_in_browser.py FLOES
"""
import subprocess
import sys
import tempfile
from pathlib import Path

import h5py

from page_in_browser import check, looked_at

CAMPAIGN = """
[campaign]
seed = 1
arrangements = 2
[design]
method = "latin_hypercube"
points = 6
[[design.axis]]
key = "contact.ice_ice_friction"
from = 0.1
to = 0.5
[[design.axis]]
key = "ice.elastic_modulus_MPa"
from = 30.0
to = 1000.0
scale = "log"
[field]
floes = 6
concentration_percent = 60.0
begin_m = 2.0
half_width_m = 1.25
far_end = "ice_sheet"
[structure]
start_m = 1.38
speed_m_s = 0.1
[analysis]
steady_start_s = 4.0
window_s = 6.0
segments = 3
"""
TARGETS = """
[[target]]
quantity = "mean_load"
value = {:.3f}                          # a quarter above the largest of the design
runs = 100
"""


def main(floes):
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        (folder / "wave.toml").write_text(CAMPAIGN)
        targets = folder / "targets.toml"
        subprocess.run([floes, "run", folder / "wave.toml", "-o", folder / "wave.h5"], check=True, capture_output=True)
        with h5py.File(folder / "wave.h5") as file:
            load, case = file["members/mean_load"][:], file["members/case"][:]
            targets.write_text(TARGETS.format(1.25 * max(load[case == k].mean() for k in set(case))))
        subprocess.run([floes, "match", folder / "wave.h5", "--targets", targets, "--samples", "512", "--next",
                        folder / "next.toml", "--points", "4"], check=True, capture_output=True)
        subprocess.run([floes, "run", folder / "next.toml", "-o", folder / "next.h5"], check=True, capture_output=True)
        subprocess.run([floes, "match", folder / "wave.h5", folder / "next.h5", "--targets", targets, "--samples", "512",
                        "-o", folder / "match.html"], check=True, stdout=subprocess.DEVNULL)
        page = (folder / "match.html").read_text()
        for wanted in ("Wave by wave", "wave.h5", "next.h5"):
            if wanted not in page:
                sys.exit(f"the page says nothing of {wanted}")
        figures = looked_at(folder / "match.html")
    check(figures, ("each pair of inputs", "left-out points of mean_load", "Inputs before and after"), 200, 100,
          labels=False)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
