"""What an HDF5 file stores, and what the page that describes it says: both as {name: (unit, dimensions)}."""

import pathlib
import re

import h5py


def datasets_of(file):
    found = {}
    file.visititems(lambda name, item: found.update({name: item}) if isinstance(item, h5py.Dataset) else None)
    return found


def stored_in(file):
    stored = {}
    for name, dataset in datasets_of(file).items():
        scales = [next(iter(dimension.values())).name for dimension in dataset.dims if len(dimension)]
        # A scale is its own dimension.
        names = [pathlib.PurePath(scale).name for scale in scales] or (
            [name.split("/")[-1]] if h5py.h5ds.is_scale(dataset.id) else [])
        if len(names) != dataset.ndim:
            raise AssertionError(f"{name} has {dataset.ndim} dimensions and the scales {names}")
        stored["/" + name] = (dataset.attrs["units"], ", ".join(names))
    return stored


def described_on(text):
    """Rows of tables begin with a dataset, or with several that share unit and dimensions. Those of dimensions themselves
    have a unit alone."""
    rows = re.findall(r"^\| (`/[a-z0-9_/]+`(?:, `/[a-z0-9_/]+`)*) \| ([^|]+) \| ([^|]*)\|.*\|$", text, re.M)
    names = [(name, unit, dimensions) for cell, unit, dimensions in rows for name in re.findall(r"`([^`]+)`", cell)]
    scales = re.findall(r"^\| (`/[a-z_]+`(?:, `/[a-z_]+`)*) \| ([^|]+) \| [^|]+\|$", text, re.M)
    names += [(name, unit, name[1:]) for cell, unit in scales for name in re.findall(r"`([^`]+)`", cell)]
    described = {name: (unit.strip(), dimensions.strip()) for name, unit, dimensions in names}
    if len(described) != len(names):
        raise AssertionError("a dataset is described twice")
    return described
