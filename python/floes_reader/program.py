"""What the program itself says of a campaign, as tables, and campaigns started from Python. It is $FLOES, `floes` on the
PATH, or the launcher of the clone that this package stands in."""

import json
import os
import pathlib
import shutil
import subprocess
import sys
from collections.abc import Iterable
from typing import Any

from .stored import CampaignError

STOPPED = 85  # exit status of a run that --resume goes on with


def executable() -> str:
    """The program to call; CampaignError where there is none."""
    launcher = pathlib.Path(__file__).parents[2] / "floes"
    found = os.environ.get("FLOES") or shutil.which("floes") or (str(launcher) if launcher.is_file() else None)
    if found is None:
        raise CampaignError("There is no program floes on the PATH; install it, or name it by the variable FLOES.")
    return found


def words_of(options: dict[str, Any]) -> list[str]:
    """Options of the command line: exposure_h=10 is --exposure-h 10, True is a flag, lists are comma-separated, and what
    is None or False is left out."""
    words = []
    for name, value in options.items():
        if value is None or value is False:
            continue
        words.append("--" + name.replace("_", "-"))
        if value is not True:
            words.append(",".join(map(str, value)) if isinstance(value, (list, tuple)) else str(value))
    return words


def ask(verb: str, path: str | os.PathLike, **options: Any) -> dict[str, Any]:
    """The JSON of `floes VERB PATH`, also where it says that there is no answer (exit status 1)."""
    command = [executable(), verb, os.fspath(path), "--format", "json", *words_of(options)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    try:
        return json.loads(done.stdout)
    except json.JSONDecodeError:
        raise CampaignError(f"floes {verb} has no answer: {done.stderr.strip()}") from None


def show(lines: Iterable[str]) -> str:
    """Copies what the program says to sys.stderr, which a notebook shows: a state of the run takes the place of the one
    before it. Returns the last line."""
    last, under_way = "", 0  # characters of a state that the next line has to cover
    for line in lines:
        text = line.replace("\033[K", "").strip()
        if not text:
            continue
        last, state = text, " done, " in text and " running" in text
        print(text.ljust(under_way), end="\r" if state else "\n", file=sys.stderr, flush=True)
        under_way = len(text) if state else 0
    if under_way:
        print(file=sys.stderr)
    return last


def compute(config: str | os.PathLike, output: str | os.PathLike, changes: dict[str, Any], **options: Any) -> None:
    """`floes run CONFIG -o OUTPUT`; its progress goes to sys.stderr, which a notebook shows. CampaignError where it ends
    before every member is done or set aside."""
    command = [executable(), "run", os.fspath(config), "-o", os.fspath(output), *words_of(options)]
    for key, value in changes.items():
        command += ["--set", f"{key}={json.dumps(value)}"]
    often = {**os.environ, "FLOES_PROGRESS": "live"}  # as on a terminal, where a state ends with \r; text=True splits there
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, env=often) as process:
        try:
            last = show(process.stderr or ())
        except KeyboardInterrupt:  # a notebook's, which need not reach the program
            process.terminate()
            process.wait()
            raise
    if process.returncode == STOPPED:
        raise CampaignError(f"The run was stopped; resume=True goes on with {os.fspath(output)}.")
    if process.returncode not in (0, 1) or not pathlib.Path(output).exists():
        raise CampaignError(f"floes run ended with status {process.returncode}: {last}")
