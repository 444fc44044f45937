#!/usr/bin/python3
"""floes export --fmu, as its users meet it: the archive, a host in Python (docs/coupling), and what is refused.

Usage: export_test.py FLOES
"""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree
import zipfile

PROJECT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(PROJECT / "docs" / "coupling"))
sys.dont_write_bytecode = True
from fmu_host import Fmu  # noqa: E402
import mass_on_a_spring  # noqa: E402

FLOES = sys.argv.pop(1) if len(sys.argv) > 1 else "floes"
CONFIG = str(PROJECT / "configs" / "moored_free.toml")
BRIEF = ["--set", "analysis.steady_start_s=2", "--set", "analysis.window_s=2", "--set", "analysis.segments=1"]
HULL = str(PROJECT / "docs" / "coupling" / "hull.toml")


class Export(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))

    def export(self, *options, config=CONFIG, status=0):
        run = subprocess.run([FLOES, "export", config, *options], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(run.returncode, status, run.stderr)
        return run.stdout, run.stderr

    def test_archives(self):
        for version, binary in (("2", "binaries/linux64/"), ("3", "binaries/x86_64-linux/")):
            said, _ = self.export("--case", "moored", "--fmu", "ice.fmu", "--version", version)
            self.assertEqual(said, "ice.fmu\n")
            with zipfile.ZipFile(self.folder / "ice.fmu") as archive:
                self.assertIsNone(archive.testzip())
                names = archive.namelist()
                root = xml.etree.ElementTree.fromstring(archive.read("modelDescription.xml"))
                self.assertEqual(root.get("fmiVersion"), version + ".0")
                self.assertEqual(root.get("modelName"), "moored_free")
                self.assertIn(b"[moorings]", archive.read("resources/configuration.toml"))
            for name in (binary + "floes.so", "documentation/index.html", "documentation/licenses/license.txt"):
                self.assertIn(name, names)
            # What the library needs beside it lies beside it.
            self.assertTrue(any(name.startswith(binary + "libBulletCollision") for name in names), names)
            self.assertTrue(any(name.startswith(binary + "libLinearMath") for name in names), names)

    def test_both_ways_give_one_offset_until_bits_matter(self):
        self.export("--case", "free", *BRIEF, "--fmu", "inside.fmu", config=HULL)
        self.export("--case", "led", *BRIEF, "--fmu", "outside.fmu", config=HULL)
        inside = list(mass_on_a_spring.moved_inside(self.folder / "inside.fmu"))
        outside = list(mass_on_a_spring.moved_outside(self.folder / "outside.fmu"))
        self.assertEqual(len(inside), 200)
        self.assertGreater(max(-x for _, x in inside), 1e-3)
        for (time, here), (_, there) in list(zip(inside, outside))[:100]:
            self.assertAlmostEqual(here, there, delta=2e-3, msg=f"at {time} s")

    def test_a_host_elsewhere_and_its_parameters(self):
        self.export("--case", "moored", "--arrangement", "2", *BRIEF, "--fmu", "ice.fmu")
        here = os.getcwd()
        os.chdir("/")
        self.addCleanup(os.chdir, here)
        with Fmu(self.folder / "ice.fmu") as ice:
            self.assertEqual(ice["arrangement"], 2)
            self.assertEqual(ice["case"], b"moored")
            ice["settings"] = "ice.thicknes_m=0.05"
            with self.assertRaisesRegex(RuntimeError, "ice.thicknes_m.*ice.thickness_m"):
                ice.begin()

    def test_says_what_is_wrong(self):
        for words, *options in (
                ("has no moorings.*--motion outside", "--case", "fixed", "--motion", "inside", "--fmu", "a.fmu"),
                ("no case nothing", "--case", "nothing", "--fmu", "a.fmu"),
                ("takes --case and --arrangement alone", "--case", "moored", "--fmu", "a.fmu", "--all"),
                ("--fmu names the FMU", "--case", "moored"),
                ("fmu", "--case", "moored", "--fmu", "a.zip")):
            self.assertRegex(self.export(*options, status=2)[1], words)
        self.assertFalse((self.folder / "a.fmu").exists())

    def test_warns_where_ice_outweighs_a_hull_that_is_led(self):
        _, said = self.export("--case", "fixed", "--fmu", "a.fmu")
        self.assertNotIn("heaviest floe", said)
        _, said = self.export("--case", "E60", "--set", "floe.length_m=2.0", "--set", "floe.breadth_m=2.0", "--set",
                              "field.floes=4", "--fmu", "a.fmu", config=str(PROJECT / "configs" / "smoke.toml"))
        self.assertRegex(said, "times the heaviest floe with its water")
        self.assertRegex(said, "added_mass")


if __name__ == "__main__":
    unittest.main()
