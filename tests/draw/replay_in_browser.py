#!/usr/bin/python3
"""The page of a real replay, opened in headless Chromium: ice, water, structure and arrows are drawn, time moves them,
values are those of the recording, controls work, no word on the console, and nothing is asked of the network.

Usage: replay_in_browser.py FLOES CONFIG.toml
"""
import html
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import h5py
import numpy

PROBE = Path(__file__).with_name("replay_probe.js")


def opened(page, fragment, size):
    """What the probe in the page found, and what the browser wrote on its console."""
    with tempfile.TemporaryDirectory() as profile:
        run = subprocess.run(
            ["chromium", "--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--use-gl=angle",
             "--use-angle=swiftshader", "--enable-unsafe-swiftshader", f"--window-size={size}",
             f"--user-data-dir={profile}", "--enable-logging=stderr", "--virtual-time-budget=30000", "--dump-dom",
             page.as_uri() + fragment], capture_output=True, text=True, timeout=200, check=True)
    found = re.search(r"data-notes=\"([^\"]*)\"", run.stdout)
    if not found:
        sys.exit("the page was not ready in time")
    # WebGL in software says so on the console; that is not the page's doing.
    console = [line for line in run.stderr.splitlines() if "CONSOLE" in line and "GPU stall" not in line]
    return json.loads(html.unescape(found[1])), console


def newtons(words):
    return float(words.removesuffix(" N"))


def expect(holds, words):
    if not holds:
        sys.exit(words)


def check(notes, recording):
    """`recording`: what the HDF5 file says at the same time."""
    expect("error" not in notes, f"the page fails: {notes.get('error')}")
    expect(not notes["notice"], f"the page says: {notes['notice']}")
    expect(notes["hash"] == [f"{recording['hash']:.2f} s", "above"], f"its address asked for another view: {notes['hash']}")
    for what in ("ice", "structure", "water"):
        expect(notes["first"][what] > 600, f"no {what} in the picture: {notes['first']}")
    expect(notes["same"] < 20, f"the picture changes by itself: {notes['same']} pixels")
    expect(notes["scrubbed"] > 1500, f"time moves nothing: {notes['scrubbed']} pixels")
    expect(notes["time"] == f"{recording['time']:.2f} s", f"wrong time: {notes['time']}")
    for word, value in zip(notes["values"][:4], recording["loads"]):
        expect(abs(newtons(word) - value) <= 0.051,
               f"loads {notes['values']} are not {recording['loads']}")
    expect(notes["values"][4] == recording["broken"], f"broken floes: {notes['values'][4]}, not {recording['broken']}")
    expect(notes["failed"] == recording["failed"], f"failed joints: {notes['failed']}, not {recording['failed']}")
    expect(notes["values"][5] == str(recording["contacts"]), f"contacts: {notes['values'][5]}, not {recording['contacts']}")
    expect(numpy.allclose(notes["places"], recording["place"], atol=1e-3),
           f"an element stands at {notes['places']}, not at {recording['place']}")
    expect(abs(notes["share"] - 0.25) < 0.01, f"ice does not move between frames: share {notes['share']}")
    for name, (view, seen) in notes["views"].items():
        expect(view == name and seen["structure"] > 100 and seen["ice"] + seen["water"] > 3000,
               f"view {name}: {view}, {seen}")
    expect(notes["apart"]["piece"][0] < 20, f"colours do not come back: {notes['apart']}")
    for colour, unit in (("speed", "m/s"), ("utilisation", "%")):
        expect(notes["apart"][colour][0] > 1500 and unit in notes["apart"][colour][1],
               f"colouring by {colour} shows nothing: {notes['apart'][colour]}")
    expect(notes["withoutArrows"] > 30, f"no arrows are drawn: {notes['withoutArrows']} pixels")
    expect(notes["withArrows"] < 20, f"arrows do not come back: {notes['withArrows']} pixels")
    expect(notes["step"] == f"{recording['next']:.2f} s", f"a step leads to {notes['step']}, not {recording['next']} s")
    expect(notes["home"] == "0.00 s", f"home is {notes['home']}")
    expect(notes["played"] >= 0.05, f"playing does not move the time: {notes['played']} s")
    expect(abs(notes["clicked"] - recording["end"] / 2) < 0.01 * recording["end"], f"a click led to {notes['clicked']} s")
    for how in ("turned", "moved", "zoomed", "pinched"):
        expect(notes[how] > 1500, f"the view cannot be {how}: {notes[how]} pixels")
    expect(notes["nothing"] < 20, f"a pointer that is not pressed moves the view: {notes['nothing']} pixels")
    expect(notes["help"], "? does not open the help")
    expect(not notes["requests"], f"the page asks for {notes['requests']}")
    expect(notes["width"][0] <= notes["width"][1], f"the page is wider than the window: {notes['width']}")
    expect(not notes["unlabelled"], f"controls without a name: {notes['unlabelled']}")


def read_record(path, frame, element):
    with h5py.File(path) as file:
        frames = file["frames"]
        surge, sway, heave = (float(frames[f"{name}_load"][frame]) for name in ("surge", "sway", "heave"))
        first, count = int(frames["first_contact"][frame]), int(frames["contacts"][frame])
        failed = file["joints/failure_time"][:]
        floe = file["ice/floe"][:][file["joints/a"][:]]
        times = file["time"][:]
        broken = len(set(floe[failed <= times[frame] + 1e-9]))
        return {"time": times[frame], "next": times[frame + 1], "hash": 5.0, "end": times[-1],
                "loads": [surge, sway, heave, float(numpy.hypot(numpy.hypot(surge, sway), heave))],
                "failed": int((failed <= times[frame] + 1e-9).sum()), "broken": f"{broken} of {floe.max() + 1}",
                "contacts": int((file["contacts/other"][first:first + count] == -1).sum()),
                "place": frames["position"][frame, element].tolist()}


def main(floes, config):
    element = 100
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        campaign, kept, page = (folder / name for name in ("smoke.h5", "recording.h5", "replay.html"))
        subprocess.run([floes, "run", config, "-o", campaign, "--set", "campaign.arrangements=1"], check=True,
                       stdout=subprocess.DEVNULL)
        subprocess.run([floes, "replay", campaign, "0", "-o", kept, "-o", page], check=True)
        with h5py.File(kept) as file:
            # Where a floe has failed and the load is not small.
            loads = file["frames/surge_load"][:]
            after = file["time"][:] >= numpy.nanmin(file["joints/failure_time"][:])
            frame = int(numpy.argmax(numpy.where(after, loads, 0)[:-1]))
        recording = read_record(kept, frame, element)
        probe = PROBE.read_text().replace("TIME,", f"{recording['time']},").replace("* ELEMENT", f"* {element}")
        page.write_text(page.read_text().replace("</body>", f"<script>{probe}</script></body>"))
        for size in ("1200,900", "500,900"):
            notes, console = opened(page, "#t=5&view=above", size)
            expect(not console, "the browser's console says:\n" + "\n".join(console))
            check(notes, recording)
    print(f"drawn, moved and read at {recording['time']:.2f} s: {notes['first']}")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
