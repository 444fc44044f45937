#!/usr/bin/python3
"""The picture of the page of floes explore in docs/replay.md, with members marked and one picked.

Usage: explore.py FLOES CAMPAIGN.h5          (configs/smoke.toml with 12 arrangements; needs chromium)
"""
import pathlib
import subprocess
import sys
import tempfile

PICTURE = pathlib.Path(__file__).resolve().parent.parent / "replay" / "explore.png"
BROWSER = ["chromium", "--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
           "--virtual-time-budget=8000", "--window-size=1280,1420"]
# As a hand would brush the points.
BRUSH = """<script>
const wait = setInterval(() => {
  if (document.body.dataset.ready !== 'yes') return;
  clearInterval(wait);
  explorer.marks.ranges.set(explorer.x.place, [18, 26]).set(explorer.y.place, [105, 150]);
  explorer.mark();
  explorer.pick(explorer.marks.some(2)[1]);
}, 20);
</script>"""


def main(floes, campaign):
    with tempfile.TemporaryDirectory() as folder:
        page = pathlib.Path(folder) / "explore.html"
        subprocess.run([floes, "explore", campaign, "-o", page], check=True, stdout=subprocess.DEVNULL)
        page.write_text(page.read_text().replace("</body>", BRUSH + "</body>"))
        subprocess.run([*BROWSER, f"--screenshot={PICTURE}", page.as_uri()], check=True, capture_output=True)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
