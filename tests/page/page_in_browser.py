#!/usr/bin/python3
"""The report and the status of a real campaign, opened in headless Chromium: no word on the console, nothing asked of
the network, every figure has a size, axes and words, and nothing sticks out of it.

Usage: page_in_browser.py FLOES CONFIG.toml
"""
import html
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

PROBE = """
<script>
const found = [...document.querySelectorAll('svg:not([aria-hidden])')].map(svg => {
  const box = svg.getBoundingClientRect();
  const texts = [...svg.querySelectorAll('text')];
  const out = texts.map(t => [t.textContent, t.getBoundingClientRect()])
                   .filter(([w, b]) => b.left < box.left - 1 || b.right > box.right + 1 || b.top < box.top - 1 ||
                                       b.bottom > box.bottom + 1).map(([w]) => w);
  return {name: svg.getAttribute('aria-label'), width: box.width, height: box.height, outside: out,
          texts: texts.length, labels: [...svg.querySelectorAll('text.label')].map(t => t.textContent),
          marks: svg.querySelectorAll('.line,.area,.dot').length};
});
document.body.dataset.found = JSON.stringify(found);
document.body.dataset.width = JSON.stringify([document.documentElement.scrollWidth, innerWidth]);
</script>
"""


def opened(page):
    """The document after its load, and what the browser wrote on its console."""
    with tempfile.TemporaryDirectory() as profile:
        run = subprocess.run(
            ["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
             "--window-size=900,2000", f"--user-data-dir={profile}", "--enable-logging=stderr", "--dump-dom",
             page.as_uri()], capture_output=True, text=True, timeout=120, check=True)
    return run.stdout, [line for line in run.stderr.splitlines() if "CONSOLE" in line]


def looked_at(page):
    """What the probe found on a page that asks for nothing, says nothing and fits into the window."""
    text = page.read_text()
    for foreign in re.findall(r"(?:src|href)=\"(?!data:)[^\"]*\"|url\([^)]*\)|@import|<script", text):
        sys.exit(f"{page.name} asks for something from elsewhere: {foreign}")
    page.write_text(text.replace("</body>", PROBE + "</body>"))
    document, console = opened(page)
    if console:
        sys.exit(f"the browser's console says of {page.name}:\n" + "\n".join(console))
    data = {key: json.loads(html.unescape(value))
            for key, value in re.findall(r"data-(found|width)=\"([^\"]*)\"", document)}
    if data["width"][0] > data["width"][1]:
        sys.exit(f"{page.name} is wider than the window: {data['width']}")
    return data["found"]


def check(figures, wanted, width, height, labels):
    """Each of the wanted figures is there; all are at least so large, have content and words, and these stay inside.
    labels: of the axes, where each figure must have them."""
    for words in wanted:
        if not any(words in figure["name"] for figure in figures):
            sys.exit(f"no figure of {words}: {[figure['name'] for figure in figures]}")
    for figure in figures:
        name = figure["name"]
        if figure["width"] < width or figure["height"] < height:
            sys.exit(f"figure without size: {figure}")
        if not name or figure["texts"] < 4 or (labels and (len(figure["labels"]) != 2 or not figure["labels"][0])):
            sys.exit(f"figure without words: {figure}")
        if figure["marks"] < 2:
            sys.exit(f"figure without content: {figure}")
        if figure["outside"]:
            sys.exit(f"words stick out of the figure {name}: {figure['outside']}")
    print(f"{len(figures)} figures, all with size and words")


def main(floes, config):
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        campaign = folder / "smoke.h5"
        subprocess.run([floes, "run", config, "-o", campaign, "--set", "campaign.arrangements=3"], check=True,
                       stdout=subprocess.DEVNULL)
        subprocess.run([floes, "report", campaign, "-o", folder / "report.html"], check=True)
        subprocess.run([floes, "status", campaign, "--html", folder / "status.html"], check=True)
        subprocess.run([floes, "report", campaign, "--pictures", "none", "-o", folder / "report.pdf"], check=True)
        if not (folder / "report.pdf").read_bytes().startswith(b"%PDF"):
            sys.exit("the report is not printed")
        looked_at(folder / "status.html")
        figures = looked_at(folder / "report.html")
    if len(figures) < 12:
        sys.exit(f"only {len(figures)} figures: {[figure['name'] for figure in figures]}")
    check(figures, ("by angle and height", "by height on", "along the tow", "seen from above", "the joints of a floe"),
          250, 120, labels=True)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
