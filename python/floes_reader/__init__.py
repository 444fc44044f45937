"""Campaign files of floes as tables (pandas) and labelled arrays (xarray), in SI units.

    import floes_reader

    with floes_reader.open("smoke.h5") as campaign:
        print(campaign.summary().loc["E60", ["estimate", "low", "high"]])

`floes_reader.plots` draws two figures of the report; it alone needs matplotlib.
"""

import os

from .campaign import Campaign
from .stored import CampaignError, LAYOUT, NewerLayoutWarning

__all__ = ["Campaign", "CampaignError", "LAYOUT", "NewerLayoutWarning", "open"]

__version__ = "2.0.0"  # of floes


def open(path: str | os.PathLike) -> Campaign:
    """Opens a campaign file for reading, as a context manager or until close().

    Raises FileNotFoundError, or CampaignError where the file is damaged, is no campaign file, or has a newer major
    layout. Warns (NewerLayoutWarning) where a newer floes wrote it and it may have more than the tables show."""
    return Campaign(path)
