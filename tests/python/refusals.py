"""What floes_reader says of files that it cannot read, or not wholly: always a sentence."""

import shutil
import unittest
import warnings

import h5py
import numpy
import pandas
from campaigns import FOLDER, FULL, SMOKE, WRITER, run

import floes_reader

BAD = FOLDER / "bad.h5"


class Refusals(unittest.TestCase):
    def refused(self, words, use=lambda campaign: None, path=BAD):
        with self.assertRaises(floes_reader.CampaignError) as caught:
            with floes_reader.open(path) as campaign:
                use(campaign)
        sentence = str(caught.exception)
        self.assertIn(words, sentence)
        self.assertTrue(sentence.endswith("."), sentence)

    def changed(self, change):
        """BAD becomes the synthetic file with a change."""
        shutil.copy(FULL, BAD)
        with h5py.File(BAD, "r+") as file:
            change(file)

    def test_what_is_no_campaign_file(self):
        with self.assertRaisesRegex(FileNotFoundError, "There is no file .*none.h5."):
            floes_reader.open(FOLDER / "none.h5")
        self.refused("is a folder", path=FOLDER)
        for content, words in ((b"", "is no HDF5 file"), (b"case,mean\n", "is no HDF5 file"),
                               (b"floesjnl....", "is a journal"), (FULL.read_bytes()[:90_000], "is damaged")):
            BAD.write_bytes(content)
            self.refused(words)
        mine = FOLDER / "mine.py"
        mine.write_text("import floes_reader\n")
        self.refused("open() takes a campaign file that floes run wrote", path=mine)
        BAD.unlink()
        with h5py.File(BAD, "w") as file:
            file["a"] = 1
        self.refused("is an HDF5 file, but no campaign of floes.")
        self.changed(lambda file: file.attrs.modify("filetype", "floes record"))
        self.refused("is a file of the kind 'floes record', but no campaign of floes.")

    def test_pieces_that_are_not_as_they_were(self):
        path = FOLDER / "over.h5"
        run(WRITER, path, "pieces")
        with floes_reader.open(path) as over, floes_reader.open(FULL) as one:
            pandas.testing.assert_frame_equal(over.summary(), one.summary())
            numpy.testing.assert_array_equal(over.group("history").surge_load, one.group("history").surge_load)
            self.assertEqual(list(over.costs), list(one.costs))
        piece = FOLDER / "over.pieces" / "1-3.h5"
        content = piece.read_bytes()
        piece.write_bytes(content[:-40_000])
        self.refused("over.pieces/1-3.h5, a piece of", path=path)
        shutil.copy(FOLDER / "over.pieces" / "1-2.h5", piece)
        self.refused("is not the piece with arrangements 2 to 3", path=path)
        piece.unlink()
        self.refused("over.pieces/1-3.h5 with arrangements 2 to 3 is not there", path=path)
        piece.write_bytes(content)
        with floes_reader.open(path) as over:
            piece.rename(FOLDER / "over.pieces" / "old.h5")
            with self.assertRaisesRegex(floes_reader.CampaignError, "was published anew since it was opened"):
                over.summary()
            piece.write_bytes(content)  # another file of the same name
            with self.assertRaisesRegex(floes_reader.CampaignError, "was published anew since it was opened"):
                over.summary()

    def test_a_newer_major_layout(self):
        self.changed(lambda file: file.attrs.modify("version", numpy.array([2, 0], "i4")))
        self.refused("has layout 2.0, of floes ")
        self.changed(lambda file: file.attrs.pop("version"))
        self.refused("its layout version cannot be read")

    def test_a_newer_minor_layout_is_read_with_a_warning(self):
        def change(file):
            file.attrs.modify("version", numpy.array([1, 99], "i4"))
            file.create_group("tides", track_order=True)

        self.changed(change)
        words = "has layout 1.99, .* knows layout 1.*; new are tides"
        with self.assertWarnsRegex(floes_reader.NewerLayoutWarning, words) as caught:
            campaign = floes_reader.open(BAD)
        self.assertEqual(caught.filename, __file__, "it points at the call of open()")
        self.assertEqual(campaign.members.mean_load[0], 100.1)
        campaign.close()
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            floes_reader.open(FULL).close()

    def test_what_the_campaign_does_not_have(self):
        cases = "There is no case 'E1' in this campaign; its cases are soft, stiff, open."
        for words, use in ((cases, lambda c: c.keys("E1")),
                           ("There is no case 'E1'", lambda c: c.histories("E1")),
                           ("Member 4 has no history: it failed: an element ran away", lambda c: c.history(4)),
                           ("Member 7 has no history: it is missing.", lambda c: c.history(7)),
                           ("There is no member 12", lambda c: c.history(12)),
                           ("has no group tides; it has cases, members, exceedance", lambda c: c.group("tides"))):
            self.refused(words, use, FULL)
        campaign = floes_reader.open(FULL)
        campaign.close()
        with self.assertRaisesRegex(floes_reader.CampaignError, "full.h5 is closed"):
            campaign.members
        self.assertIn("closed", repr(campaign))

    def test_no_history_was_kept(self):
        def change(file):
            for name in file["history"]:
                file["history"][name][:] = numpy.nan

        self.changed(change)
        self.refused("analysis.history_steps was 0", lambda campaign: campaign.history(0))

    def test_damage(self):
        def shorten(file):
            del file["members/mean_load"]
            file["members"].create_dataset("mean_load", data=numpy.zeros(5)).attrs.update(units="N", long_name="mean")

        def displace(file):
            file.move("cases/cfm", "c")
            file.create_group("cases/cfm")

        def change(name, value):
            return lambda file: file[name].__setitem__(0, value)

        for words, use, damage in (
                ("/cases/cfm cannot be read", lambda c: c.cases, displace),
                ("members/status cannot be read", lambda c: c.members, lambda file: file.pop("members/status")),
                ("/members/status has a value without a meaning", lambda c: c.summary(), change("members/status", 5)),
                ("/members/case names a row that /cases does not have", lambda c: c.members, change("members/case", 3)),
                ("/members/arrangement names a row", lambda c: c.members, change("members/arrangement", -1)),
                ("mean_load of the members has 5 values, not 12", lambda c: c.members, shorten),
                ("/breaks/member names a member", lambda c: c.breaks, change("breaks/member", 12)),
                ("/provenance/configuration cannot be read", lambda c: c.overrides,
                 lambda file: file["provenance/configuration"].__setitem__((), "[campaign")),
        ):
            with self.subTest(words):
                self.changed(damage)
                self.refused(words, use)
                self.refused("is damaged", use)

    def test_a_damaged_history(self):
        with h5py.File(SMOKE) as file:
            at = file["history/surge_load"].id.get_chunk_info_by_coord((3, 0)).byte_offset + 20
        content = bytearray(SMOKE.read_bytes())
        content[at] ^= 255
        BAD.write_bytes(content)
        with floes_reader.open(BAD) as campaign:
            campaign.history(2)
        self.refused("/history/surge_load cannot be read", lambda campaign: campaign.history(3))
