#!/usr/bin/python3
"""films.py FLOES CONFIG: every kind of film that ffmpeg makes has all frames in the right size, and a replay that is
stopped while it draws leaves nothing."""

import pathlib
import signal
import subprocess
import sys
import tempfile
import time


def probed(film):
    """Frames, width and height, as ffprobe counts them; of .webp, which it cannot read, as the file says."""
    if film.suffix == ".webp":
        data = film.read_bytes()
        at = data.index(b"VP8X") + 12
        size = [1 + int.from_bytes(data[at + k:at + k + 3], "little") for k in (0, 3)]
        return [data.count(b"ANMF"), *size]
    answer = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-select_streams", "v", "-show_entries",
                             "stream=nb_read_frames,width,height", "-of", "csv=p=0", film],
                            check=True, capture_output=True, text=True).stdout
    width, height, frames = map(int, answer.strip().split(","))
    return [frames, width, height]


def main(floes, config):
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        campaign, recording = folder / "short.h5", folder / "recording.h5"
        subprocess.run([floes, "run", config, "-o", campaign, "--set", "campaign.arrangements=1", "--set",
                        "analysis.window_s=6.0"], check=True, capture_output=True)
        subprocess.run([floes, "replay", campaign, "0", "--from", "10", "--to", "12", "-o", recording], check=True,
                       capture_output=True)
        for ending in ("mp4", "webm", "webp", "gif"):
            film = folder / f"film.{ending}"
            subprocess.run([floes, "replay", recording, "-o", film, "--size", "320x200"], check=True, capture_output=True)
            if probed(film) != [21, 320, 200]:
                sys.exit(f"{film.name} has {probed(film)} frames, width, height")
        film = folder / "case:E60.mp4"  # ffmpeg would take it for a protocol
        subprocess.run([floes, "replay", recording, "-o", film, "--size", "320x200"], check=True, capture_output=True)
        if not film.stat().st_size:
            sys.exit(f"{film.name} is empty")
        film = folder / "stopped.mp4"
        run = subprocess.Popen([floes, "replay", campaign, "0", "--every", "0.02", "-o", film, "--size", "1920x1200"],
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        deadline = time.monotonic() + 60
        while not list(folder.glob("stopped*.mp4")) and time.monotonic() < deadline:
            time.sleep(0.02)
        run.send_signal(signal.SIGINT)
        if run.wait(60) != 85:
            sys.exit(f"a stopped replay exits with {run.returncode}")
        left = sorted(path.name for path in folder.iterdir() if path.name.startswith("stopped"))
        if left:
            sys.exit(f"a stopped replay leaves {left}")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
