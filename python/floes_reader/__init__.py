"""Campaign files of floes as tables (pandas) and labelled arrays (xarray), in SI units.

    import floes_reader

    with floes_reader.open("smoke.h5") as campaign:
        print(campaign.summary().loc["E60", ["estimate", "low", "high"]])

`floes_reader.run("smoke.toml", set={"campaign.arrangements": 8})` computes a campaign and opens it.
`floes_reader.plots` draws two figures of the report; it alone needs matplotlib.
"""

import os
import pathlib
from typing import Any

from . import program
from .campaign import Campaign
from .stored import CampaignError, LAYOUT, NewerLayoutWarning

__all__ = ["Campaign", "CampaignError", "LAYOUT", "NewerLayoutWarning", "open", "run"]

__version__ = "3.0.0"  # of floes


def open(path: str | os.PathLike) -> Campaign:
    """Opens a campaign file for reading, as a context manager or until close().

    Raises FileNotFoundError, or CampaignError where the file is damaged, is no campaign file, or has a newer major
    layout. Warns (NewerLayoutWarning) where a newer floes wrote it and it may have more than the tables show."""
    return Campaign(path)


def run(config: str | os.PathLike, output: str | os.PathLike | None = None, set: dict[str, Any] | None = None,
        **options: Any) -> Campaign:
    """Computes a campaign by the program (`floes run`) and opens it. `output`: the campaign file; CONFIG.h5 in this
    folder by default. `set`: keys over those of the file. `options` as on the command line: threads=4, ranks=2,
    resume=True, overwrite=True. Progress goes to standard error.

    Raises CampaignError where the configuration is refused or the run ends early, with what the program said."""
    path = pathlib.Path(output) if output is not None else pathlib.Path(pathlib.Path(config).stem + ".h5")
    program.compute(config, path, set or {}, **options)
    return Campaign(path)
