"""Campaigns that Python starts: `floes run`, waited for or in the background."""

import atexit
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
from collections.abc import Iterable, Iterator, Mapping
from typing import IO, Any, NamedTuple

from . import program
from .campaign import Campaign
from .stored import CampaignError
from .toml_text import toml_text

WRITTEN = "# Written by floes_reader from a dict, and replaced by the next one.\n"
ORPHANED = 'read -r released || kill -TERM "$0"'  # ends what Python left running: its end closes the pipe

Configuration = str | os.PathLike | Mapping[str, Any]


class Progress(NamedTuple):
    """How far a run is, in members."""

    done: int
    failed: int
    of: int  # 0 until the program has laid out its campaign
    seconds_left: float | None = None  # None while it cannot be known

    def __str__(self) -> str:
        left = "" if self.seconds_left is None else f", {self.seconds_left:.0f} s left"
        return f"{self.done} of {self.of} done, {self.failed} failed{left}"


class Run:
    """A campaign under way; made by start(). It is stopped, and can be resumed, where Python ends before it or is
    killed, unless it was told to outlive Python. As a context manager it is stopped at the end of the block."""

    def __init__(self, path: pathlib.Path, words: list[str], live: bool = False, outlives: bool = False):
        self.path = path  # of the campaign file
        self._log: IO[bytes] | None = None if live else tempfile.TemporaryFile()
        command, around = [program.executable(), "run", *words], program.surroundings()
        if live:
            around["FLOES_PROGRESS"] = "live"  # as on a terminal, where a state ends with \r; text=True splits there
        # A session of its own: what interrupts a cell of a notebook does not reach it.
        self._process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                         stderr=self._log or subprocess.PIPE, text=True, errors="replace", env=around,
                                         start_new_session=True)
        self._lines: list[str] = []
        self._watch: subprocess.Popen | None = None
        if not outlives:
            self._watch = subprocess.Popen(["/bin/sh", "-c", ORPHANED, str(self._process.pid)],
                                           stdin=subprocess.PIPE, stdout=subprocess.DEVNULL,
                                           stderr=subprocess.DEVNULL, start_new_session=True)
            atexit.register(self._end)

    def __enter__(self) -> "Run":
        return self

    def __exit__(self, *_: object) -> None:
        self.stop()

    def __repr__(self) -> str:
        status = self.poll()
        state = {None: "under way", program.STOPPED: "stopped"}.get(status, f"ended with status {status}")
        return f"<run into {self.path}: {state}, {self.progress}>"

    @property
    def progress(self) -> Progress:
        """How far it is now, as `floes status` says; it does not wait for the run."""
        try:
            told = program.ask("status", self.path)
        except CampaignError:  # nothing is laid out yet, or it was refused: wait() says which
            return Progress(0, 0, 0)
        return Progress(told["done"], told["failed"], told["total"], told["seconds_left"])

    @property
    def messages(self) -> list[str]:
        """What the program has said so far, a sentence a line."""
        if self._log is not None:  # the program writes at the end of the file, which is left as it is
            said = os.pread(self._log.fileno(), os.fstat(self._log.fileno()).st_size, 0)
            self._lines = said.decode(errors="replace").splitlines()
        return list(self._lines)

    def poll(self) -> int | None:
        """None while it runs; then the exit status of floes: 0 done, 1 some member failed, 2 refused, 85 stopped, below
        0 ended by that signal."""
        status = self._process.poll()
        if status is not None:
            self._released()
        return status

    def wait(self, timeout: float | None = None) -> Campaign:
        """Its campaign, opened, once every member is done or set aside. `timeout`: s, after which TimeoutError is
        raised and the run goes on. Raises Refused where the program refuses it, CampaignError where it ends early."""
        try:
            status = self._process.wait(timeout)
        except subprocess.TimeoutExpired:
            raise TimeoutError(f"The run into {self.path} is still under way: {self.progress}.") from None
        self._released()
        if status == program.REFUSED:
            raise program.Refused("\n".join(self.messages))
        if status == program.STOPPED:
            raise CampaignError(f"The run was stopped; resume=True goes on with {self.path}.")
        if status < 0:
            name = signal.Signals(-status).name
            raise CampaignError(f"The run was ended by {name}; resume=True goes on with {self.path}.")
        # Status 1 is of members that were set aside, and of a run that could not go on, which says so: an older campaign
        # may then stand in its place.
        errors = [line for line in self.messages if re.match("floes: (?!member|rank)", line)] if status == 1 else []
        if errors or status not in (0, 1) or not self.path.exists():
            last = (errors or self.messages or ["it said nothing"])[-1]
            raise CampaignError(f"floes run ended with status {status}: {last}")
        return self.campaign

    def stop(self) -> None:
        """Stops it in an orderly way, and waits for that; what is done stays, and resume=True goes on with it. Nothing
        happens where it has ended."""
        if self.poll() is None:
            self._process.terminate()
            show(self.said())  # a live run's last words: it would end otherwise at a pipe that nobody reads
            self._process.wait()
            self._released()

    @property
    def campaign(self) -> Campaign:
        """Its campaign file, opened; of a run under way or stopped as it was last published."""
        return Campaign(self.path)

    def said(self) -> Iterator[str]:
        """Lines of a live run as they come, each without what moves a terminal's cursor."""
        for line in self._process.stderr or ():
            text = line.replace("\033[K", "").strip()
            if not text:
                continue
            if is_state(text) and self._lines and is_state(self._lines[-1]):
                self._lines.pop()
            self._lines.append(text)
            yield text

    def _released(self) -> None:
        """It has ended: nobody has to look after it."""
        if self._log is not None:
            self._lines = self.messages
            self._log.close()
            self._log = None
        if self._process.stderr is not None:
            self._process.stderr.close()
        if self._watch is not None:
            self._watch.communicate(b"released\n")
            self._watch = None
            atexit.unregister(self._end)

    def _end(self) -> None:
        if self.poll() is None:
            print(f"floes: the run into {self.path} is stopped, since Python ends; resume=True goes on with it",
                  file=sys.stderr)
            self.stop()


def is_state(line: str) -> bool:
    return " done, " in line and " running" in line


def show(lines: Iterable[str]) -> None:
    """Copies what the program says to sys.stderr, which a notebook shows: a state of the run takes the place of the one
    before it."""
    under_way = 0  # characters of a state that the next line has to cover
    for text in lines:
        state = is_state(text)
        print(text.ljust(under_way), end="\r" if state else "\n", file=sys.stderr, flush=True)
        under_way = len(text) if state else 0
    if under_way:
        print(file=sys.stderr)


def begun(configuration: Configuration, output: str | os.PathLike | None, changes: dict[str, Any], live: bool,
          outlives: bool, options: dict[str, Any]) -> Run:
    """Checks the configuration, and starts its run."""
    if isinstance(configuration, Mapping):
        path = pathlib.Path("campaign.h5" if output is None else output)
        file = _written(configuration, path)
    else:
        file = pathlib.Path(configuration)
        path = pathlib.Path(file.stem + ".h5" if output is None else output)
    program.check(file, changes)
    words = [str(file), "-o", str(path), *program.words_of(options), *program.changes_of(changes)]
    return Run(path, words, live, outlives)


def _written(tables: Mapping[str, Any], output: pathlib.Path) -> pathlib.Path:
    """A dict as a file beside the campaign file, where the command line finds it too."""
    file = output.with_suffix(".toml")
    if file.exists() and not file.read_text(encoding="utf-8", errors="replace").startswith(WRITTEN):
        raise CampaignError(f"{file} is not from a dict and is not replaced by one; give the campaign another name.")
    file.write_text(WRITTEN + toml_text(tables), encoding="utf-8")
    return file
