"""Reads the HDF5 file, and checks it while reading. This is the only module of the package that uses h5py."""

import contextlib
import os
import pathlib
import warnings
from collections.abc import Iterator
from typing import Any

import h5py
import numpy
import xarray

LAYOUT = (1, 19)  # the newest layout of campaign files that this reader knows (docs/campaign_file.md)
GROUPS = {"arrangements", "averaged", "breaks", "calibration", "cases", "exceedance", "history", "load_map", "members", "parts",
          "pieces", "provenance", "responses"}  # those of that layout
FILETYPE = "floes campaign"
BAD = (OSError, RuntimeError, KeyError, ValueError, TypeError, AttributeError)  # what h5py raises over damaged data


class CampaignError(Exception):
    """The file cannot be read, or lacks what was asked for. The message says what to do."""


class NewerLayoutWarning(UserWarning):
    """A newer floes wrote the file, which may contain more than the tables show."""


class Stored:
    """The datasets of one campaign file, by their names, such as "members/mean_load"."""

    def __init__(self, path: str | os.PathLike):
        self.path = pathlib.Path(path)
        self._file = _opened(self.path)
        self._pieces: list[tuple[pathlib.Path, int]] = []  # and their inodes
        try:
            self.attributes = self.attributes_of("/")
            self._check_kind()
            self.layout = self._checked_layout()
            self._check_pieces()
        except BaseException:
            self.close()
            raise

    def close(self) -> None:
        self._file.close()

    @property
    def closed(self) -> bool:
        return not self._file

    def damaged(self, what: str) -> CampaignError:
        return CampaignError(f"{self.path} is damaged: {what}. {_cure(self.path)}")

    @contextlib.contextmanager
    def reading(self, what: str) -> Iterator[None]:
        """Turns any failure to read `what` within the block into a CampaignError."""
        if self.closed:
            raise CampaignError(f"{self.path} is closed; read it within its `with`, or before close().")
        try:
            yield
        except BAD as error:
            raise self.damaged(f"{what} cannot be read ({error})") from error

    def has(self, name: str) -> bool:
        with self.reading(f"/{name}"):
            return name in self._file

    def names(self, group: str = "/") -> list[str]:
        """Names of the members of a group, in the order of their creation."""
        found: list[bytes] = []
        with self.reading(f"the names in {group}"):
            opened = self._file[group]  # must outlive the loop over its links
            opened.id.links.iterate(found.append, idx_type=h5py.h5.INDEX_CRT_ORDER)
            return [name.decode() for name in found]

    def groups(self) -> list[str]:
        with self.reading("the groups"):
            return [name for name in self.names() if isinstance(self._file[name], h5py.Group)]

    def attributes_of(self, name: str) -> dict[str, Any]:
        """Attributes of a group or dataset, except the digest of its bytes and those that connect dimensions."""
        with self.reading(f"the attributes of {name}"):
            return {key: value for key, value in self._file[name].attrs.items()
                    if key not in ("CLASS", "NAME", "DIMENSION_LIST", "REFERENCE_LIST", "digest")}

    def shape(self, name: str) -> tuple[int, ...]:
        with self.reading(f"/{name}"):
            return self._file[name].shape

    def kind(self, name: str) -> str:
        """The kind of a dataset's values, as numpy's letter: "f" for floating point."""
        with self.reading(f"/{name}"):
            return self._file[name].dtype.kind

    def read(self, name: str, rows: Any = ()) -> numpy.ndarray:
        """Values of a dataset, all of them or those of `rows`; texts as str. Every value that the package takes from
        the file is read here."""
        self._expect_same_pieces()
        with self.reading(f"/{name}"):
            dataset = self._file[name]
            for length, dimension in zip(dataset.shape, dataset.dims):
                if len(dimension) and len(dimension[0]) != length:
                    raise ValueError(f"it has {length} rows where {dimension[0].name} has {len(dimension[0])}")
            text = h5py.check_string_dtype(dataset.dtype) is not None
            return numpy.asarray(dataset.asstr()[rows] if text else dataset[rows])

    def array(self, name: str, rows: Any = ()) -> xarray.DataArray:
        """A dataset with the names of its dimensions and its attributes, such as units. Missing values are NaN."""
        values, attributes = self.read(name, rows), self.attributes_of(name)
        missing = attributes.pop("_FillValue", None)
        if missing is not None and values.dtype.kind == "i":
            values = numpy.where(values == missing, numpy.nan, values)
        with self.reading(f"/{name}"):
            return xarray.DataArray(values, dims=list(self._scales(name)), attrs=attributes)

    def group(self, name: str) -> xarray.Dataset:
        """All datasets of a group, with their coordinates."""
        if name not in self.groups():
            raise CampaignError(f"{self.path} has no group {name}; it has {', '.join(self.groups())}.")
        columns, scales = {}, {}
        for column in self.names(name):
            columns[column] = self.array(f"{name}/{column}")
            scales.update(self._scales(f"{name}/{column}"))
        coordinates = {dimension: self.array(scale) for dimension, scale in scales.items()}
        columns = {column: array for column, array in columns.items() if column not in coordinates}
        for same in _same_times(coordinates):
            del coordinates[same]
            columns = {column: array.rename({same: "time"}) if same in array.dims else array
                       for column, array in columns.items()}
        with self.reading(f"/{name}"):
            return xarray.Dataset(columns, coords=coordinates, attrs=self.attributes_of(name))

    def words(self, name: str) -> numpy.ndarray:
        """A dataset of flags, each replaced by its meaning; None where it is missing."""
        attributes = self.attributes_of(name)
        with self.reading(f"the meanings of /{name}"):
            meanings = dict(zip(attributes["flag_values"].tolist(), attributes["flag_meanings"].split(), strict=True))
        return numpy.array([meanings.get(value) for value in self.read(name).tolist()], object)

    def _scales(self, name: str) -> dict[str, str]:
        """Names of a dataset's dimensions -> path of their coordinates. A coordinate is its own."""
        with self.reading(f"the dimensions of /{name}"):
            dataset = self._file[name]
            if h5py.h5ds.is_scale(dataset.id):
                return {name.split("/")[-1]: name}
            paths = [dimension[0].name for dimension in dataset.dims]
            return {path.split("/")[-1]: path.lstrip("/") for path in paths}

    def _check_kind(self) -> None:
        kind = self.attributes.get("filetype")
        if kind != FILETYPE:
            what = "an HDF5 file" if not isinstance(kind, str) else f"a file of the kind '{kind}'"
            raise CampaignError(f"{self.path} is {what}, but no campaign of floes.")

    def _checked_layout(self) -> tuple[int, int]:
        with self.reading("its layout version"):
            major, minor = (int(part) for part in self.attributes["version"])
        known = f"this reader knows layout {LAYOUT[0]}.{LAYOUT[1]}"
        software = self.attributes.get("softwareVersion", "unknown")
        written = f"{self.path} has layout {major}.{minor}, of floes {software}"
        if major != LAYOUT[0]:
            raise CampaignError(f"{written}; {known}. Install the floes_reader of the floes that wrote it.")
        if minor > LAYOUT[1]:
            unknown = [name for name in self.groups() if name not in GROUPS]
            warnings.warn(f"{written}; {known}. What is new in it is not in summary() and the tables of other names"
                          + (f"; new are {', '.join(unknown)}" if unknown else "") + ". group(NAME) reads any group.",
                          NewerLayoutWarning, stacklevel=5)
        return major, minor


    def _check_pieces(self) -> None:
        """Where the rows of the file lie in pieces: HDF5 gives NaN for those of a piece that is not there."""
        if not self.has("provenance/piece"):
            return
        names, digests = self.read("provenance/piece"), self.read("provenance/piece_digest")
        first, count = self.read("provenance/piece_first"), self.read("provenance/piece_count")
        for k, name in enumerate(names):
            piece = self.path.resolve().parent / name
            rows = f"arrangements {first[k]} to {first[k] + count[k] - 1}"
            if not piece.exists():
                raise CampaignError(f"{self.path} is made of {len(names)} pieces, and {piece} with {rows} is not there. "
                                    f"Keep the file and the folder {piece.parent.name} together. {_cure(self.path)}")
            try:
                with h5py.File(piece, "r") as opened:
                    found = opened.attrs["contents_digest"]
            except BAD as error:
                raise CampaignError(f"{piece}, a piece of {self.path} with {rows}, is damaged ({error}). "
                                    f"{_cure(self.path)}") from error
            if found != digests[k]:
                raise CampaignError(f"{piece} is not the piece with {rows} that {self.path} was made with. "
                                    f"{_cure(self.path)}")
            self._pieces.append((piece, piece.stat().st_ino))

    def _expect_same_pieces(self) -> None:
        """HDF5 opens them by name at each reading; a run that publishes the file anew removes or replaces them."""
        for piece, inode in self._pieces:
            if not piece.exists() or piece.stat().st_ino != inode:
                raise CampaignError(f"{self.path} was published anew since it was opened; open it again.")


def _same_times(coordinates: dict[str, xarray.DataArray]) -> list[str]:
    """Which of them are /time under other names, so that what lies along them goes with what lies along it."""
    time = coordinates.get("time")
    if time is None:
        return []
    return [name for name, one in coordinates.items()
            if name.endswith("_time") and one.attrs.get("units") == time.attrs.get("units")
            and numpy.array_equal(one.values, time.values)]


def _opened(path: pathlib.Path) -> h5py.File:
    if not path.exists():
        raise FileNotFoundError(f"There is no file {path}.")
    if path.is_dir():
        raise CampaignError(f"{path} is a folder; a campaign file ends in .h5.")
    with path.open("rb") as file:
        if file.read(8) == b"floesjnl":
            raise CampaignError(f"{path} is a journal, which only floes reads; open the campaign file beside it, "
                                f"{path.with_suffix('.h5').name}.")
    try:
        return h5py.File(path, "r")
    except BAD as error:
        raise CampaignError(f"{path} is no HDF5 file, or is damaged ({error}). {_cure(path)}") from error


def _cure(path: pathlib.Path) -> str:
    if path.suffix not in (".h5", ".hdf5", ".nc") or not path.with_suffix(".journal").exists():
        return "open() takes a campaign file that floes run wrote, CONFIG.h5; no journal beside it would make it again."
    return f"`floes run CONFIG -o {path} --resume` writes a campaign file again from its journal."
