#!/usr/bin/python3
"""record_test.py FLOES CONFIG PAGE: what h5py and xarray make of a recording of floes replay, and whether the page that
describes it names every dataset with its unit and dimensions."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy
import xarray

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from stored import datasets_of, described_on, stored_in  # noqa: E402

FLOES, CONFIG, PAGE = sys.argv[1:4]


class Recording(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        cls.campaign, cls.path = folder / "short.h5", folder / "recording.h5"
        subprocess.run([FLOES, "run", CONFIG, "-o", cls.campaign, "--set", "campaign.arrangements=1", "--set",
                        "analysis.window_s=6.0"], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        run = subprocess.run([FLOES, "replay", cls.campaign, "--worst", "--case", "E60", "--every", "0.2", "-o", cls.path],
                             capture_output=True, text=True)
        if run.returncode != 0 or run.stdout.strip() != str(cls.path):
            sys.exit(f"floes replay says: {run.stdout} {run.stderr}")

    def test_has_the_load_of_the_campaign_file(self):
        with h5py.File(self.campaign) as campaign, h5py.File(self.path) as recording:
            stored = campaign["history/surge_load"][recording.attrs["member"][0]]
            self.assertTrue((recording["history/surge_load"][:] == stored).all())
            steps = recording["frames/step"][:]
            self.assertTrue((recording["frames/surge_load"][:] == stored[steps - 1]).all())
            worst = campaign["members/maximum_load"][recording.attrs["member"][0]]
            self.assertIn(worst, recording["frames/surge_load"][:])
            failed = recording["joints/failure_time"][:]
            breaks = campaign["breaks/time"][:][campaign["breaks/member"][:] == recording.attrs["member"][0]]
            self.assertEqual(sorted(failed[~numpy.isnan(failed)]), sorted(breaks))

    def test_forces_of_contacts_add_up(self):
        with h5py.File(self.path) as recording:
            first, count = recording["frames/first_contact"][:], recording["frames/contacts"][:]
            for frame in range(len(first)):
                rows = slice(first[frame], first[frame] + count[frame])
                on_structure = recording["contacts/other"][rows] == -1
                force = recording["contacts/normal_force"][rows] + recording["contacts/friction_force"][rows]
                load = [recording[f"frames/{name}_load"][frame] for name in ("surge", "heave", "sway")]
                rounding = 1e-9 + sum(numpy.linalg.norm(recording[f"contacts/{name}_force"][rows][on_structure], axis=1).sum()
                                      for name in ("normal", "friction")) / 4096  # forces are kept to 2^-13
                numpy.testing.assert_allclose(-force[on_structure].sum(0) * [-1, 1, 1], load, rtol=0, atol=rounding)

    def test_orientations_are_rotations(self):
        with h5py.File(self.path) as recording:
            numpy.testing.assert_allclose(numpy.linalg.norm(recording["frames/orientation"][:], axis=2), 1, atol=2**-14)

    def test_xarray_opens_every_group_with_named_dimensions(self):
        for engine in ("netcdf4", "h5netcdf"):
            for group in ("frames", "contacts", "ice", "joints", "history", "structure", "ice_sheets"):
                with self.subTest(engine=engine, group=group):
                    with xarray.open_dataset(self.path, group=group, engine=engine) as data:
                        self.assertFalse([name for name in data.sizes if "phony" in name])
                        data.load()
            with xarray.open_dataset(self.path, group="frames", engine=engine) as frames:
                self.assertEqual(frames["position"].dims, ("time", "element", "coordinate"))

    def test_page_and_file_agree(self):
        text = pathlib.Path(PAGE).read_text(encoding="utf-8")
        with h5py.File(self.path) as file:
            for name, dataset in datasets_of(file).items():
                self.assertTrue(dataset.attrs["long_name"] and dataset.attrs["units"], name)
            stored = stored_in(file)
            for name in [*file.attrs, *file["ice"].attrs]:
                self.assertIn(f"`{name}`", text, "an attribute is not described")
            version = ".".join(str(part) for part in file.attrs["version"])
        self.maxDiff = None
        self.assertEqual(described_on(text), stored)
        self.assertIn(f"layout version {version}", text)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
