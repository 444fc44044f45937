"""Campaign files of floes as tables (pandas) and labelled arrays (xarray), in SI units, and campaigns computed from
Python.

    import floes_reader

    with floes_reader.open("smoke.h5") as campaign:
        print(campaign.summary().loc["E60", ["estimate", "low", "high"]])

`floes_reader.run("smoke.toml", set={"campaign.arrangements": 8})` computes a campaign and opens it;
`floes_reader.start` does so in the background. Both take a dict as well as a file.
`floes_reader.plots` draws two figures of the report; it alone needs matplotlib.
"""

import os
from typing import Any

from .campaign import Campaign
from .program import Refused
from .runs import Configuration, Progress, Run, begun, show
from .stored import CampaignError, LAYOUT, NewerLayoutWarning

__all__ = ["Campaign", "CampaignError", "LAYOUT", "NewerLayoutWarning", "Progress", "Refused", "Run", "open", "run",
           "start"]

__version__ = "4.0.0"  # of floes


def open(path: str | os.PathLike) -> Campaign:
    """Opens a campaign file for reading, as a context manager or until close().

    Raises FileNotFoundError, or CampaignError where the file is damaged, is no campaign file, or has a newer major
    layout. Warns (NewerLayoutWarning) where a newer floes wrote it and it may have more than the tables show."""
    return Campaign(path)


def run(configuration: Configuration, output: str | os.PathLike | None = None, set: dict[str, Any] | None = None,
        **options: Any) -> Campaign:
    """Computes a campaign by the program (`floes run`) and opens it. Progress goes to standard error.

    `configuration`: a file, or its tables as a dict ({"ice": {"thickness_m": 0.03}, "case": [{"name": "a"}, …]}, or
    with the keys of Campaign.keys), which is kept beside the campaign file with the ending .toml: files that it names
    are looked for from there. `output`: the campaign file; by default CONFIG.h5 in this folder, of a dict campaign.h5.
    `set`: keys over those of the configuration. `options` as on the command line: threads=4, ranks=2, resume=True,
    overwrite=True.

    Raises Refused where the program refuses the configuration or its output, with its sentences, before anything is
    computed; CampaignError where the run ends early."""
    under_way = begun(configuration, output, set or {}, True, False, options)
    try:
        show(under_way.said())
    except BaseException:  # also where a cell of a notebook is interrupted
        under_way.stop()
        raise
    return under_way.wait()


def start(configuration: Configuration, output: str | os.PathLike | None = None, set: dict[str, Any] | None = None,
          outlives: bool = False, **options: Any) -> Run:
    """The same without waiting for it: the run in the background, with its `progress`, stop() and wait(). A
    configuration that the program refuses is Refused at once. `outlives`: the run goes on where Python ends before it;
    otherwise it is stopped then."""
    return begun(configuration, output, set or {}, False, outlives, options)
