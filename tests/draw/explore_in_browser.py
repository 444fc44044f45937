#!/usr/bin/python3
"""The page of floes explore of a real campaign and of a synthetic one of 99,999 members, opened in headless Chromium:
members are drawn, what is brushed in one picture is marked in all, keys and clicks pick, no word on the console, nothing
sticks out of the window, and 99,999 members are brushed without a stutter.

Usage: explore_in_browser.py FLOES CONFIG.toml SYNTHETIC_FILE
"""

import base64
import json
import os
import re
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

import h5py
import numpy

PROBE = """
<script>
(async () => {
  const notes = {};
  const later = ms => new Promise(resolve => setTimeout(resolve, ms));
  try {
    while (document.body.dataset.ready !== 'yes') await later(20);
    const inked = canvas => {
      const copy = document.createElement('canvas');
      Object.assign(copy, {width: canvas.width, height: canvas.height});
      const context = copy.getContext('2d', {willReadFrequently: true});
      context.drawImage(canvas, 0, 0);
      const {data} = context.getImageData(0, 0, copy.width, copy.height);
      let count = 0;
      for (let i = 3; i < data.length; i += 4) count += data[i] > 0;
      return count;
    };
    const ink = () => explorer.plots.map(plot => inked(plot.top));
    notes.said = byId('about').textContent;
    notes.mean = byId('marked').textContent;
    notes.all = ink();
    // A drag of the hand across the left half of the points.
    const box = document.querySelector('#scatter .brush .background').getBoundingClientRect();
    const mouse = (type, x, y, target) => target.dispatchEvent(new MouseEvent(type, {view: window, bubbles: true,
      cancelable: true, clientX: x, clientY: y, button: 0}));
    const background = document.querySelector('#scatter .brush .background');
    mouse('mousedown', box.left + 1, box.top + 1, background);
    mouse('mousemove', box.left + box.width / 2, box.bottom - 1, window);
    mouse('mouseup', box.left + box.width / 2, box.bottom - 1, window);
    await later(200);
    notes.brushed = explorer.marks.count;
    notes.range = explorer.marks.ranges.get(explorer.x.place);
    notes.some = ink();
    notes.inputs = [...document.querySelectorAll('#ranges input')].length;
    const input = document.querySelector('#ranges input');
    input.value = explorer.x.high;
    input.dispatchEvent(new Event('change'));
    await later(200);
    notes.typed = explorer.marks.count;
    document.dispatchEvent(new KeyboardEvent('keydown', {key: 'Escape'}));
    await later(200);
    notes.cleared = explorer.marks.count;
    explorer.setWindow({from: 0, to: 1e9, low: 0.999 * explorer.histories.y.domain()[1] / 1.03, high: 1e9}, null);
    await later(200);
    notes.through = explorer.marks.count;
    explorer.clear();
    await later(200);
    const before = explorer.picked;
    const press = key => byId('scatter').dispatchEvent(new KeyboardEvent('keydown', {key}));
    press('ArrowLeft');
    if (explorer.picked === before) press('ArrowRight');  // from the first one there is none to the left
    notes.stepped = explorer.picked !== before;
    const member = Math.floor(explorer.data.count / 2);
    const x = box.left + explorer.scatter.xs[member];
    const y = box.top + explorer.scatter.ys[member];
    mouse('mousedown', x, y, background);
    mouse('mouseup', x, y, window);
    await later(100);
    notes.picked = [explorer.data.numbers[explorer.picked], byId('picked').textContent];
    notes.values = Object.fromEntries(['mean_load', 'failure_ratio'].map(key =>
      [key, explorer.column(key).values[explorer.picked]]));
    notes.unlabelled = [...document.querySelectorAll('select,input,button')].filter(one => !one.closest('label') &&
      !one.getAttribute('aria-label') && !one.textContent.trim()).length;
    notes.wide = document.documentElement.scrollWidth - innerWidth;
    const column = explorer.column('mean_load');
    const times = [];
    for (let k = 1; k <= 9; ++k) {
      explorer.marks.ranges.set(column.place, [column.low, column.low + k / 10 * (column.high - column.low)]);
      const begin = performance.now();
      explorer.mark();
      times.push(performance.now() - begin);
    }
    notes.brush = times.sort((a, b) => a - b)[4];
    explorer.drawAll();
    notes.draw = explorer.times.draw;
  } catch (error) {
    notes.error = String(error.stack);
  }
  document.body.dataset.notes = JSON.stringify(notes);
  console.log('NOTES ' + btoa(unescape(encodeURIComponent(JSON.stringify(notes)))));
})();
</script>
"""


def expect(holds, words):
    if not holds:
        sys.exit(words)


def opened(page, size):
    """What the probe in the page found, with the real clock; nothing else may be on the console."""

    # The browser's own processes may write into its profile a moment longer than it lives.
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        with subprocess.Popen(["chromium", "--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
                               "--remote-debugging-port=0", f"--window-size={size}", f"--user-data-dir={profile}",
                               "--enable-logging=stderr", page.as_uri()], stderr=subprocess.PIPE, text=True,
                              start_new_session=True) as browser:
            try:
                for line in browser.stderr:
                    if "CONSOLE" not in line:
                        continue
                    found = re.search(r'"NOTES ([^"]*)"', line)
                    expect(found, f"the browser's console says: {line}")
                    return json.loads(base64.b64decode(found[1]))
            finally:
                os.killpg(browser.pid, signal.SIGKILL)
                browser.wait()
    sys.exit("the page was not ready in time")


def check(notes, members, first):
    """`members`: of the campaign file; `first`: what the page says at first."""
    expect("error" not in notes, f"the page fails: {notes.get('error')}")
    expect(notes["said"].startswith(first), f"it says: {notes['said']}")
    expect(len(notes["all"]) == 4 and min(notes["all"]) > 200, f"a picture is empty: {notes['all']}")
    expect(0 < notes["brushed"] < notes["cleared"], f"the brush marks {notes['brushed']} of {notes['cleared']}")
    expect(all(some < full for some, full in zip(notes["some"], notes["all"])),
           f"what is brushed in one is not marked in all: {notes['some']} of {notes['all']}")
    load = members["mean_load"]
    inside = ((load >= notes["range"][0]) & (load <= notes["range"][1])).sum()
    expect(abs(int(inside) - notes["brushed"]) <= 1, f"{notes['brushed']} are marked, {inside} lie in the range")
    expect(notes["inputs"] == 4, f"ranges of {notes['inputs']} limits can be typed")
    expect(notes["typed"] <= 1, f"a typed limit leaves {notes['typed']}")
    expect(notes["cleared"] == len(load), f"after Escape {notes['cleared']} are marked")
    expect(1 <= notes["through"] < len(load), f"{notes['through']} histories reach the largest load")
    expect(notes["stepped"], "an arrow key picks no other member")
    number, words = notes["picked"]
    expect(f"Member {number:,}" in words and f" {number} -o member_{number}.html" in words, f"picked: {words}")
    row = int(numpy.flatnonzero(members["number"] == number)[0])
    expect(abs(notes["values"]["mean_load"] - load[row]) < 1e-3 * abs(load[row]), f"{notes['values']} is not {load[row]}")
    expect(notes["unlabelled"] == 0, f"{notes['unlabelled']} controls without a name")
    expect(notes["wide"] <= 0, f"{notes['wide']} px wider than the window")


def read_members(path):
    with h5py.File(path) as file:
        done = file["members/status"][:] == 0
        return {"mean_load": file["members/mean_load"][:][done], "number": numpy.flatnonzero(done)}


def main(floes, config, synthetic_file):
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        smoke, many = folder / "smoke.h5", folder / "many.h5"
        subprocess.run([floes, "run", config, "-o", smoke, "--set", "campaign.arrangements=3"], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        subprocess.run([synthetic_file, many, "33333"], check=True)
        for campaign, first, sizes in ((smoke, "9 members of 3 cases", ("1280,1400", "500,1400")),
                                       (many, "99,999 members of 3 cases", ("1280,1400",))):
            page = campaign.with_suffix(".html")
            subprocess.run([floes, "explore", campaign, "-o", page], check=True, stdout=subprocess.DEVNULL)
            page.write_text(page.read_text().replace("</body>", PROBE + "</body>"))
            for size in sizes:
                notes = opened(page, size)
                check(notes, read_members(campaign), first)
                print(f"{first} at {size}: page {page.stat().st_size / 1e6:.1f} MB, all drawn in {notes['draw']:.0f} ms, "
                      f"brushed in {notes['brush']:.0f} ms")
        expect(notes["brush"] < 250, f"a brush of many members takes {notes['brush']:.0f} ms")


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2], sys.argv[3])
