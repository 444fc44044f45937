#!/usr/bin/python3
"""tools/add.py finds the places where a new finding and a new key go, makes their files once, and refuses what is no name.

Usage: add_test.py PROJECT_FOLDER
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(sys.argv.pop()).resolve()


class Add(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        for part in ("tools", "src/scenario", "src/shapes", "src/solver", "ensemble/findings", "tests/findings",
                     "tests/scenario", "tests/campaign"):
            shutil.copytree(ROOT / part, self.folder / part)
        shutil.copy(ROOT / ".clang-format", self.folder)  # by which what is made is formatted, where there is clang-format

    def add(self, *words):
        return subprocess.run([sys.executable, "-B", self.folder / "tools/add.py", *words], capture_output=True, text=True)

    def has(self, path, text):
        self.assertIn(text, (self.folder / path).read_text(encoding="utf-8"))

    def test_finding(self):
        made = self.add("finding", "wind_rose", "Loads by direction")
        self.assertEqual(made.returncode, 0, made.stderr)
        self.has("ensemble/findings/sections.hpp", "Section wind_rose_section(Evidence& evidence);")
        self.has("ensemble/findings/catalogue.cpp", '{"wind_rose", one<wind_rose_section>, ')
        self.has("ensemble/findings/wind_rose.cpp", "// Loads by direction.\n")
        self.has("tests/findings/wind_rose_test.cpp", "TEST(WindRose, ")
        self.assertIn("is there already", self.add("finding", "wind_rose", "Again").stderr)
        self.assertIn("is no name", self.add("finding", "Wind", "Loads").stderr)

    def test_key(self):
        for table, header in (("ice", "scenario/scenario"), ("water", "scenario/scenario"), ("moorings", "shapes/moorings")):
            made = self.add("key", f"{table}.for_{table}_m")
            self.assertEqual(made.returncode, 0, made.stderr)
            self.has(f"src/{header}.hpp", f"double for_{table} = 0;")
            self.assertIn(f"src/{header}.hpp", made.stdout)
            self.has(f"tests/scenario/for_{table}_test.cpp", f'"{table}.for_{table}_m"')
        self.has("src/scenario/tables_field.cpp", 'number_key("water.for_water_m", water.for_water, ')
        self.has("tests/campaign/digests_test.cpp", '"ice.for_ice_m"')  # moorings came later as a whole
        self.assertIn("there is no table wave", self.add("key", "wave.height_m").stderr)
        self.assertIn("is no key", self.add("key", "height").stderr)


if __name__ == "__main__":
    unittest.main()
