#!/usr/bin/python3
"""readers_test.py SYNTHETIC_FILE PAGE [--update]: what h5py, pandas, xarray and h5dump make of a campaign file, and whether the page
that describes it names every dataset with its unit and dimensions. --update writes the page's table of quantities anew."""

import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy
import pandas
import xarray

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from stored import datasets_of, described_on, stored_in  # noqa: E402

GROUPS = ["members", "cases", "arrangements", "exceedance", "averaged", "history", "load_map", "breaks", "pieces",
          "provenance"]  # of every file
CALIBRATION = {"calibration": {"calibration_point": 6}}  # of one with calibrated cases
ENGINES = ["netcdf4", "h5netcdf"]
DONE, MISSING, FAILED = 0, -1, 1
WRITER, PAGE = sys.argv[1:3]
UPDATE = "--update" in sys.argv
QUANTITIES = re.compile(r"(?<=<!-- quantities -->\n).*?(?=<!-- end -->)", re.S)
WORK = "work over the distance towed that goes into "  # which the page says once
FAMILIES = {  # quantities of one unit that share a row, and its words
    ("mean_load", "sd_load", "maximum_load"): "surge load over the window: mean, population standard deviation, largest",
    ("skewness", "excess_kurtosis"): "of the surge load over the window",
    ("mean_maximum", "sd_maximum"): "mean and population standard deviation of the segment maxima of the surge load",
    ("floes_entered", "floes_met"): "floes that were computed, and that touched the structure, at any time of the run",
    ("split_ratio", "cracked_ratio"): "floes that a crack went through, and of which a joint began to crack, over all "
                                      "floes, at the end of the run",
    ("mean_sway", "mean_heave"): "mean load over the window",
    ("peak_compression", "peak_tension", "peak_shear"): "largest in any joint over the run",
    ("peak_bending", "peak_torsion", "peak_in_plane_bending"): "largest in any joint over the run",
    tuple(f"failures_{mode}" for mode in ("bending", "shear", "compression", "tension", "torsion", "in_plane_bending")):
        "joints that failed so",
}


def quantities_of(file):
    """{name: column} of what is one number of a member, in the order in which the file was made."""
    names, members = [], file["members"]
    members.id.links.iterate(names.append, idx_type=h5py.h5.INDEX_CRT_ORDER)
    columns = {name.decode(): members[name] for name in names}
    return {name: column for name, column in columns.items() if column.dtype == float and column.ndim == 1}


def rows_of(columns):
    """Rows of the page: a quantity each, a family of them, or mean, standard deviation and largest amount of one."""
    done = set()
    for name, column in columns.items():
        stem = name.removeprefix("mean_")
        three = [f"{part}_{stem}" for part in ("mean", "sd", "largest")]
        whole = name != stem and all(one in columns for one in three)
        if name in done:
            continue
        done.update(three if whole else [])
        family = next((names for names in FAMILIES if name in names), ())
        if family:
            done.update(family)
            units, = {columns[one].attrs["units"] for one in family}
            yield f"| {', '.join(f'`{one}`' for one in family)} | {units} | {FAMILIES[family]} |"
            continue
        shown = f"`{name}`, `sd_…`, `largest_…`" if whole else f"`{name}`"
        words = column.attrs["long_name"].removeprefix("mean " if whole else WORK)
        yield f"| {shown} | {column.attrs['units']} | {words} |"


class Readers(unittest.TestCase):
    how = []

    @classmethod
    def setUpClass(cls):
        folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        cls.path, cls.empty_path = folder / "full.h5", folder / "empty.h5"
        subprocess.run([WRITER, cls.path, *cls.how], check=True)
        subprocess.run([WRITER, cls.empty_path, "none"], check=True)

    def test_xarray_opens_every_group_with_named_dimensions(self):
        expected = {
            "members": {"member": 12, "segment": 3},
            "cases": {"case": 3, "profile_point": 3},
            "arrangements": {"arrangement": 8, "floe": 6, "coordinate": 3},
            "history": {"member": 12, "time": 110},
            "load_map": {"member": 12, "height": 12, "angle": 36, "tow": 24},
            "breaks": {"break": 15},
            "pieces": {"piece": 16},
            "exceedance": {"member": 12, "level": 3},
            "averaged": {"member": 12, "averaging_time": 3, "segment": 3, "peak": 3},
            "provenance": {"member": 12, "session": 2, **({"piece": 3} if self.how else {})},
            **CALIBRATION,
        }
        for engine in ENGINES:
            for group in expected:
                with self.subTest(engine=engine, group=group):
                    with xarray.open_dataset(self.path, group=group, engine=engine) as data:
                        self.assertEqual(dict(data.sizes), expected[group])
                        self.assertGreater(len(data.to_dataframe()), 0)
            with xarray.open_dataset(self.path, engine=engine) as root:
                self.assertEqual(root.attrs["filetype"], "floes campaign")
                self.assertAlmostEqual(float(root["time"][-1]), 2.2)
                self.assertEqual(list(root["coordinate"].values), ["x", "z", "yaw"])

    def test_xarray_opens_a_file_without_results(self):
        for engine in ENGINES:
            for group in GROUPS:
                with self.subTest(engine=engine, group=group):
                    with xarray.open_dataset(self.empty_path, group=group, engine=engine) as data:
                        data.load()
        with h5py.File(self.empty_path) as file:
            self.assertTrue((file["members/status"][:] == MISSING).all())
            self.assertEqual(file["breaks/time"].shape, (0,))
            self.assertNotIn("calibration", file)
            self.assertNotIn("calibration_point", file)

    def test_what_is_missing_is_missing_to_every_reader(self):
        with h5py.File(self.path) as file:
            status = file["members/status"][:]
            not_done = status != DONE
            self.assertEqual(list(numpy.flatnonzero(not_done)), [4, 7])
            self.assertEqual(status[4], FAILED)
            self.assertEqual(status[7], MISSING)
            for name, column in file["members"].items():
                if numpy.isnan(column[:]).all() if column.dtype == numpy.float64 else True:
                    continue  # no number, or of a structure that gives way or turns
                if column.ndim == 1:
                    self.assertTrue((numpy.isnan(column[:]) == not_done).all(), name)
            for column in file["history"].values():
                self.assertTrue(numpy.isnan(column[4]).all() and numpy.isnan(column[7]).all())
            self.assertFalse(numpy.isin(file["breaks/member"][:], [4, 7]).any())
            self.assertIn("ran away at 12.34 s: 11 m/s, allowed ≤ 10 m/s", file["members/reason"][4].decode())
        for engine in ENGINES:
            with xarray.open_dataset(self.path, group="members", engine=engine) as members:
                self.assertEqual(list(numpy.flatnonzero(numpy.isnan(members["steady"]))), [4, 7])
                self.assertEqual(list(numpy.flatnonzero(numpy.isnan(members["failures_shear"]))), [4, 7])

    def test_values(self):
        with h5py.File(self.path) as file:
            self.assertEqual(file["members/mean_load"][8], 900.1)
            self.assertEqual(file["members/failures_compression"][8], 26)
            self.assertEqual(list(file["members/case"][:4]), [0, 1, 2, 0])
            self.assertEqual(list(file["members/arrangement"][:6]), [0, 0, 1, 2, 2, 3])
            surge = file["history/surge_load"]
            self.assertAlmostEqual(surge[3, 20], 400 * numpy.sin(0.1 * 20))
            self.assertFalse(numpy.isnan(surge[0]).any())
            self.assertEqual(numpy.isnan(surge[2]).sum(), 10)
            if not surge.is_virtual:
                self.assertEqual(surge.chunks, (1, 110))
                self.assertTrue(surge.shuffle and surge.compression == "gzip")
            self.assertEqual(list(file["arrangements/pose"][2, 1]), [6.0 + 1 + 0.1, 0.3 * 6 - 1, 0.01])
            self.assertTrue(numpy.isnan(file["arrangements/pose"][1, 4:]).all())
            self.assertEqual(list(file["arrangements/number"][:]), [0, 0, 1, 1, 2, 2, 3, 3])
            self.assertEqual(list(file["cases/far_end"][:]), [0, 0, 1])
            self.assertEqual(file["cases/far_end"].attrs["flag_meanings"], "ice_sheet open never")
            self.assertEqual([name.decode() for name in file["cases/name"]], ["soft", "stiff", "open"])
            self.assertEqual(list(file["cases/profile_height"][2]), [-0.443, 0.0, 0.122])
            self.assertTrue((numpy.diff(file["breaks/member"][:]) >= 0).all())
            modes = file["breaks/mode"].attrs
            self.assertEqual(len(modes["flag_values"]), len(modes["flag_meanings"].split()))

    def test_levels(self):
        with h5py.File(self.path) as file:
            self.assertEqual(list(file["level"][:]), [100, 300, 500])
            above, rises = file["exceedance/steps_above"], file["exceedance/upcrossings"]
            self.assertEqual(list(above[3, :2]), [23, 13])  # of its case's own levels alone
            self.assertEqual(list(rises[8, 1:]), [13, 8])
            self.assertTrue(numpy.isnan(above[3, 2]) and numpy.isnan(above[8, 0]))
            self.assertTrue(numpy.isnan(above[4]).all() and numpy.isnan(rises[7]).all())
            self.assertEqual(above.dims[1][0].name, "/level")
            self.assertEqual(list(file["cases/history_stride"][:]), [1, 1, 1])
        with xarray.open_dataset(self.path) as root:
            self.assertEqual(list(root["level"].values), [100, 300, 500])
            self.assertEqual(root["level"].attrs["units"], "N")

    def test_load_map(self):
        with h5py.File(self.path) as file:
            found = {name: column[:] for name, column in file["load_map"].items()}
            self.assertEqual([file[name].shape[0] for name in ("height", "angle", "tow")], [12, 36, 24])
            numpy.testing.assert_allclose(file["height"][[0, 11]], [0.5 / 12, 11.5 / 12])
            numpy.testing.assert_allclose(file["angle"][[0, 17, 18, 35]], [-175, -5, 5, 175])
            numpy.testing.assert_allclose(file["tow"][[0, 23]], [0.5 / 24, 23.5 / 24])
        self.assertEqual(found["surge_load"][8, 2, 3], 900 + 0.001 * (2 * 36 + 3))
        self.assertEqual(found["normal_force"][8, 11, 35], 1800 + 0.001 * 431)
        self.assertEqual(found["surge_load_along_tow"][3, 23], 400 + 0.1 * 23)
        for column in found.values():
            self.assertEqual(list(numpy.flatnonzero(numpy.isnan(column).all(axis=tuple(range(1, column.ndim))))), [4, 7])

    def test_averaged(self):
        with h5py.File(self.path) as file:
            self.assertEqual(list(file["averaging_time"][:]), [0.1, 0.2, 0.4])
            found = {name: column[:] for name, column in file["averaged"].items()}
        self.assertEqual(list(found["sd_load"][3, [0, 2]]), [400.1, 400.4])  # of its case's own times alone
        self.assertEqual(list(found["mean_maximum"][8, 1:]), [902, 904])
        self.assertEqual(found["sd_maximum"][8, 1], 920)
        self.assertTrue(numpy.isnan(found["sd_load"][3, 1]) and numpy.isnan(found["mean_maximum"][8, 0]))
        numpy.testing.assert_allclose(found["segment_maximum"][3, 2], [400.4, 400.41, 400.42], rtol=1e-14)
        self.assertTrue(numpy.isnan(found["segment_maximum"][8, 2, 2]))  # its case has two segments
        for column in found.values():
            self.assertTrue(numpy.isnan(column[[4, 7]]).all())

    def test_calibration(self):
        with h5py.File(self.path) as file:
            curve = {name: list(column[:]) for name, column in file["calibration"].items()}
        self.assertEqual(curve["case"], [1, 1, 1, 2, 2, 2])
        self.assertEqual(curve["iterations"], [50, 51, 52] * 2)
        first = [curve[name][0] for name in ("sheet", "element", "thickness", "time_step", "erp", "cfm", "slope",
                                             "elastic_modulus", "elastic_modulus_point")]
        self.assertEqual(first, [5.4, 0.2, 0.03, 0.02, 0.8, 0.016, 1e4, 6e7, 7e7])
        self.assertEqual(curve["elastic_modulus_point"], [7e7, 7e7 + 1, 7e7 + 2] * 2)

    def test_provenance(self):
        with h5py.File(self.path) as file:
            provenance = file["provenance"]
            self.assertIn('name = "synthetic"', provenance["configuration"][()].decode())
            for name in ("date", "seed", "machine", "floes", "git_revision", "compiler", "compiler_flags", "bullet",
                         "eigen", "hdf5", "tbb", "boost"):
                self.assertNotEqual(str(provenance.attrs[name]), "", name)
            self.assertEqual(provenance["host"][1].decode(), "node1")
            self.assertEqual(provenance["attempts"][7], 0)
            self.assertEqual(provenance["rank"][7], -1)
            self.assertEqual(provenance["wall_time"][2], 14.5)
            self.assertEqual(provenance["cpu_time"][2], 14.0)
            self.assertEqual(list(provenance["session_ranks"][:]), [2, 1])

    def test_no_times_are_stored_and_order_of_creation_is_kept(self):
        with h5py.File(self.path) as file:
            for name, dataset in datasets_of(file).items():
                self.assertFalse(dataset.id.get_create_plist().get_obj_track_times(), name)
            order = file["members"].id.get_create_plist().get_link_creation_order()
            self.assertTrue(order & h5py.h5p.CRT_ORDER_TRACKED)

    def test_pandas_and_h5dump(self):
        with h5py.File(self.path) as file:
            table = pandas.DataFrame({name: column[:] for name, column in file["members"].items() if column.ndim == 1})
        self.assertEqual(table[table.status == DONE].groupby("case").mean_load.count().tolist(), [4, 2, 4])
        dump = subprocess.run(["h5dump", self.path], capture_output=True, text=True)
        self.assertEqual(dump.returncode, 0, dump.stderr)
        self.assertIn("surge_load", dump.stdout)

    def test_every_dataset_has_unit_and_long_name(self):
        with h5py.File(self.path) as file:
            for name, dataset in datasets_of(file).items():
                self.assertTrue(dataset.attrs["long_name"] and dataset.attrs["units"], name)

    def test_page_has_the_quantities(self):
        with h5py.File(self.path) as file:
            rows = list(rows_of(quantities_of(file)))
        self.assertGreater(len(rows), 40)
        table = "\n".join(["", "| of `/members` | unit | meaning |", "|---|---|---|", *rows]) + "\n"
        text = pathlib.Path(PAGE).read_text(encoding="utf-8")
        if UPDATE:
            text = QUANTITIES.sub(lambda _: table, text)
            pathlib.Path(PAGE).write_text(text, encoding="utf-8")
        self.assertEqual(QUANTITIES.search(text).group(), table, "run readers_test.py SYNTHETIC_FILE PAGE --update")

    def test_page_and_file_agree(self):
        text = pathlib.Path(PAGE).read_text(encoding="utf-8")
        with h5py.File(self.path) as file:
            stored = stored_in(file)
            for name in quantities_of(file):  # which have a table of their own
                del stored[f"/members/{name}"]
            for name in [*file.attrs, *file["provenance"].attrs]:
                self.assertIn(f"`{name}`", text, "an attribute is not described")
            version = ".".join(str(part) for part in file.attrs["version"])
        if "/provenance/piece" in stored:
            self.assertLessEqual(stored.items(), described_on(text).items())
            return
        # a held structure of one part has none of these, and a file with rows of its own no pieces
        others = ("/part", "/parts/", "/responses/", "/provenance/piece")
        of_others = {name for name in described_on(text) if name == others[0] or name.startswith(others[1:])}
        self.assertEqual(len(of_others), 16)
        self.assertEqual({name: what for name, what in described_on(text).items() if name not in of_others}, stored)
        self.assertIn(f"layout version {version}", text)


class ReadersOverPieces(Readers):
    """The same of a file whose rows lie in pieces."""

    how = ["pieces"]

    def test_h5py_says_where_the_rows_lie_and_gives_nan_for_those_of_a_lost_piece(self):
        with h5py.File(self.path) as file:
            loads = file["members/mean_load"]
            self.assertEqual([source.file_name for source in loads.virtual_sources()],
                             [f"full.pieces/1-{k}.h5" for k in (1, 2, 3)])
            whole = loads[:]
        piece, aside = self.path.with_suffix(".pieces") / "1-2.h5", self.path.with_suffix(".aside")
        piece.rename(aside)
        try:
            with h5py.File(self.path) as file:
                lost = file["members/mean_load"][:]
            self.assertTrue(numpy.isnan(lost[3:6]).all())
            numpy.testing.assert_array_equal(numpy.delete(lost, [3, 4, 5]), numpy.delete(whole, [3, 4, 5]))
        finally:
            aside.rename(piece)

    def test_pieces_can_be_read_alone(self):
        with h5py.File(self.path) as file, h5py.File(self.path.with_suffix(".pieces") / "1-3.h5") as piece:
            self.assertEqual(list(piece["member"][:]), list(range(6, 12)))
            numpy.testing.assert_array_equal(piece["members/mean_load"][:], file["members/mean_load"][6:])
            self.assertTrue((piece["breaks/member"][:] >= 6).all())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
