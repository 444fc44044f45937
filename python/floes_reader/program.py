"""The program floes: which one it is, what it is asked, and what it refuses. It is $FLOES, the one that pip installed
with this package, `floes` on the PATH, or the launcher of the clone that this package stands in, which is never made to
build: a call from Python answers at once."""

import json
import os
import pathlib
import shutil
import subprocess
import sysconfig
from typing import Any

from .stored import CampaignError
from .toml_text import value_text

REFUSED = 2  # exit status of wrong input
STOPPED = 85  # of a run that --resume goes on with


class Refused(CampaignError):
    """The program does not take what it was given, or has no answer, and the message says why: what it said, with file,
    line and key where they matter. `sentences`: the same, one each."""

    def __init__(self, said: str):
        self.sentences = sentences_of(said)
        super().__init__("\n".join(self.sentences))


def sentences_of(said: str) -> tuple[str, ...]:
    """What the program said last: the lines from the last one that begins with its name, without that name. mpirun adds
    a block of its own behind it."""
    lines = said.replace("\033[K", "").splitlines()
    first = max((at for at, line in enumerate(lines) if line.startswith("floes: ")), default=0)
    found = []
    for line in lines[first:]:
        if line.startswith("-----"):
            break
        if line.strip():
            found.append(line.removeprefix("floes: ").rstrip())
    return tuple(found)


def executable() -> str:
    """The program to call; CampaignError where there is none."""
    named = os.environ.get("FLOES")
    if named and shutil.which(named) is None:
        raise CampaignError(f"The variable FLOES names {named}, which is no program.")
    launcher = pathlib.Path(__file__).parents[2] / "floes"
    found = (named or shutil.which("floes", path=sysconfig.get_path("scripts")) or shutil.which("floes")
             or (str(launcher) if launcher.is_file() else None))
    if found is None:
        raise CampaignError("There is no program floes on the PATH; install it, or name it by the variable FLOES.")
    return found


def surroundings() -> dict[str, str]:
    """Environment variables of the program: a launcher that would have to build first refuses, and says how to."""
    return {**os.environ, "FLOES_BUILD": "never"}


def words_of(options: dict[str, Any]) -> list[str]:
    """Options of the command line: exposure_h=10 is --exposure-h 10, True is a flag, lists are comma-separated, and
    what is None or False is left out."""
    words = []
    for name, value in options.items():
        if value is None or value is False:
            continue
        words.append("--" + name.replace("_", "-"))
        if value is not True:
            words.append(",".join(map(str, value)) if isinstance(value, (list, tuple)) else str(value))
    return words


def changes_of(changes: dict[str, Any]) -> list[str]:
    """Keys over those of a configuration, as the command line takes them."""
    return [word for key, value in changes.items() for word in ("--set", f"{key}={value_text(value)}")]


def called(*words: str) -> subprocess.CompletedProcess[str]:
    """`floes WORDS`, ended; Refused where it refuses."""
    done = subprocess.run([executable(), *words], capture_output=True, text=True, errors="replace", check=False,
                          env=surroundings())
    if done.returncode == REFUSED:
        raise Refused(done.stderr)
    return done


def ask(verb: str, path: str | os.PathLike, **options: Any) -> dict[str, Any]:
    """The JSON of `floes VERB PATH`, also where it says that there is no answer (exit status 1)."""
    done = called(verb, os.fspath(path), "--format", "json", *words_of(options))
    try:
        return json.loads(done.stdout)
    except json.JSONDecodeError:
        raise CampaignError(f"floes {verb} has no answer: {done.stderr.strip()}") from None


def check(configuration: str | os.PathLike, changes: dict[str, Any]) -> None:
    """Refused where `floes config --check` finds fault with the file. A name without an ending may be that of an
    installed one, of which the run itself says what it thinks."""
    if os.path.exists(configuration) or pathlib.Path(configuration).suffix:
        called("config", "--check", os.fspath(configuration), *changes_of(changes))
