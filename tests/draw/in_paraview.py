#!/usr/bin/python3
"""The series of a replayed member, opened in ParaView by its default reader: every time step and part is there, the ice
lies where the recording has it, and the state beside it draws a picture of ice, structure and forces whose camera follows
the structure. Neither says a word on standard error.

Usage: in_paraview.py FLOES CONFIG.toml
"""
import runpy
import subprocess
import sys
import tempfile
from pathlib import Path

import h5py
import numpy as np

PARTS = ["ice", "structure", "load", "contacts", "ice_sheets"]


def said(*command):
    """What a command wrote; an error if it failed or wrote on standard error."""
    run = subprocess.run([str(part) for part in command], capture_output=True, text=True, timeout=500)
    assert run.returncode == 0 and not run.stderr, f"{command}: status {run.returncode}\n{run.stderr}"
    return run.stdout


def corners(recording, frame):
    """x, y, z of all corners of all elements, first of the lower face; NaN where an element has fewer."""
    x, z = recording["ice/corner_x"][:], recording["ice/corner_z"][:]
    half = np.broadcast_to(recording["ice/sides"][:, 1:2] / 2, x.shape)
    own = np.concatenate([np.stack([x, side * half, z], 1) for side in (-1, 1)], 2)
    w, x, y, z = recording["frames/orientation"][frame].T.astype(float)
    rotation = np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                         [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                         [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])
    return recording["frames/position"][frame][:, :, None] + np.einsum("ije,ejc->eic", rotation, own)


def leaves(source):
    """The data set of each part by its name; None where it has nothing."""
    data = source.GetClientSideObject().GetOutputDataObject(0)
    return {data.GetMetaData(i).Get(data.NAME()): data.GetBlock(i) for i in range(data.GetNumberOfBlocks())}


def check_volumes(ice, element, recording):
    """The cells of an element are its prism, none of them inside out."""
    from vtk.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter

    sizes = vtkCellSizeFilter()
    sizes.SetInputData(ice)
    sizes.Update()
    volumes = vtk_to_numpy(sizes.GetOutput().GetCellData().GetArray("Volume"))
    assert volumes.min() > 0, volumes.min()
    x, z = recording["ice/corner_x"][:].astype(float), recording["ice/corner_z"][:].astype(float)
    wanted = []
    for own_x, own_z, thickness in zip(x, z, recording["ice/sides"][:, 1]):
        own_x, own_z = own_x[~np.isnan(own_x)], own_z[~np.isnan(own_z)]
        wanted.append(thickness * (own_x * np.roll(own_z, -1) - np.roll(own_x, -1) * own_z).sum() / 2)
    assert np.allclose(np.bincount(element, volumes), wanted, rtol=1e-4)


def check_data(series, recording):
    from paraview.simple import OpenDataFile
    from vtk.util.numpy_support import vtk_to_numpy

    source = OpenDataFile(str(series))
    times = recording["time"][:]
    assert np.array_equal(list(source.TimestepValues), times), (list(source.TimestepValues), times)
    radius = None
    for frame, time in enumerate(times):
        source.UpdatePipeline(time)
        parts = leaves(source)
        assert sorted(parts) == sorted(PARTS), list(parts)
        there = corners(recording, frame)
        ice = parts["ice"]
        points = vtk_to_numpy(ice.GetPoints().GetData())
        laid = there.transpose(0, 2, 1)
        assert np.allclose(points, laid[~np.isnan(laid).any(2)], atol=1e-5), frame
        cells = {name: vtk_to_numpy(ice.GetCellData().GetArray(name))
                 for name in ["element", "floe", "piece", "broken", "utilisation", "velocity"]}
        element = cells["element"]
        assert np.array_equal(np.unique(element), np.arange(len(there)))
        if frame == 0:
            check_volumes(ice, element, recording)
        assert np.array_equal(cells["floe"], recording["ice/floe"][:][element])
        assert np.array_equal(cells["piece"], recording["frames/piece"][frame][element])
        assert np.allclose(cells["velocity"], recording["frames/velocity"][frame][element])
        assert np.allclose(cells["utilisation"], recording["frames/utilisation"][frame][element])

        first, count = recording["frames/first_contact"][frame], recording["frames/contacts"][frame]
        contacts = parts["contacts"]
        assert (contacts.GetNumberOfPoints() if contacts else 0) == count
        if count:
            force = vtk_to_numpy(contacts.GetPointData().GetArray("force"))
            rows = slice(first, first + count)
            whole = recording["contacts/normal_force"][rows] + recording["contacts/friction_force"][rows]
            assert np.allclose(force, whole, rtol=1e-5, atol=1e-3)
        load = vtk_to_numpy(parts["load"].GetPointData().GetArray("force"))
        assert np.allclose(load[3], [-recording["frames/surge_load"][frame], recording["frames/heave_load"][frame],
                                     recording["frames/sway_load"][frame]], rtol=1e-5)
        assert np.allclose(load[:3].sum(0), load[3])
        west, east = parts["structure"].GetBounds()[:2]
        assert np.isclose((west + east) / 2, recording["frames/structure"][frame], atol=1e-5)
        radius = radius or (east - west) / 2
        assert np.isclose((east - west) / 2, radius, atol=1e-5) and radius > 0
    ice = leaves(source)["ice"].GetCellData()
    broken, floe = (vtk_to_numpy(ice.GetArray(name)) for name in ("broken", "floe"))
    shares = np.bincount(floe, broken) / np.bincount(floe)
    assert set(shares) == {0, 1}, "floes broken at the end"


def check_state(state, recording):
    """The camera goes with the structure, and forces are drawn where there are contacts."""
    from paraview.simple import FindSource, GetActiveView, GetAnimationScene, GetDisplayProperties

    times = recording["time"][:]
    sys.argv = [str(state), "--time", str(times[3])]
    runpy.run_path(str(state))
    ahead = [GetActiveView().CameraPosition[0] - recording["frames/structure"][3]]
    for frame in range(len(times)):
        GetAnimationScene().AnimationTime = times[frame]
        ahead.append(GetActiveView().CameraPosition[0] - recording["frames/structure"][frame])
    assert np.ptp(ahead) < 1e-3, ahead
    for name, each in {"normal forces": recording["frames/contacts"][-1], "friction": recording["frames/contacts"][-1],
                       "load": 4}.items():
        lines = FindSource(name)
        assert lines and GetDisplayProperties(lines).Visibility, name
        assert lines.GetDataInformation().GetNumberOfCells() == each > 0, name


def check_picture(path):
    from vtk.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOImage import vtkPNGReader

    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())[:, :3].astype(int)
    red, green, blue = pixels.T
    shares = {"white ice": (pixels.min(1) > 220).mean(),
              "yellow structure": ((red > 180) & (green > 130) & (blue < 90)).mean(),
              "blue water": ((blue > red + 40) & (blue > green + 15)).mean(),
              "red forces": ((red > 180) & (green < 80) & (blue < 80)).mean()}
    least = {"white ice": 0.05, "yellow structure": 0.02, "blue water": 0.05, "red forces": 1e-4}
    assert all(shares[name] > least[name] for name in least), shares


def inside(folder):
    """What is checked in ParaView's own Python."""
    with h5py.File(folder / "recording.h5") as recording:
        check_data(folder / "series.xdmf2", recording)
        check_state(folder / "series.py", recording)
    check_picture(folder / "picture.png")


def main(floes, config):
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        subprocess.run([floes, "run", config, "-o", folder / "c.h5", "--set", "campaign.arrangements=1"], check=True,
                       capture_output=True)
        subprocess.run([floes, "replay", folder / "c.h5", "--case", "E60", "--every", "1", "-o",
                        folder / "recording.h5", "-o", folder / "series.xdmf2"], check=True, capture_output=True)
        # Without -noreset the display starts anew whenever its last window closes, and may not be there for the next.
        pvpython = ["xvfb-run", "-a", "-s", "-noreset", "pvpython"]
        said(*pvpython, folder / "series.py", "--screenshot", folder / "picture.png")
        said(*pvpython, __file__, "--inside", folder)


if __name__ == "__main__":
    if sys.argv[1] == "--inside":
        inside(Path(sys.argv[2]))
    else:
        main(*sys.argv[1:])
