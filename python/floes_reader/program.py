"""What the program itself says of a campaign, as tables, and campaigns started from Python. It is $FLOES, `floes` on the
PATH, or the launcher of the clone that this package stands in."""

import json
import os
import pathlib
import shutil
import subprocess
import sys
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


def compute(config: str | os.PathLike, output: str | os.PathLike, changes: dict[str, Any], **options: Any) -> None:
    """`floes run CONFIG -o OUTPUT`; its progress goes to sys.stderr, which a notebook shows. CampaignError where it ends
    before every member is done or set aside."""
    command = [executable(), "run", os.fspath(config), "-o", os.fspath(output), *words_of(options)]
    for key, value in changes.items():
        command += ["--set", f"{key}={json.dumps(value)}"]
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as process:
        last = ""
        for line in process.stderr or ():
            last = line.strip() or last
            print(line.rstrip("\n"), end="\r" if " done, " in line else "\n", file=sys.stderr, flush=True)
    print(file=sys.stderr)
    if process.returncode == STOPPED:
        raise CampaignError(f"The run was stopped; resume=True goes on with {os.fspath(output)}.")
    if process.returncode not in (0, 1) or not pathlib.Path(output).exists():
        raise CampaignError(f"floes run ended with status {process.returncode}: {last}")
