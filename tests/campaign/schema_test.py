#!/usr/bin/python3
"""The JSON Schema of floes config --schema, by another program's validator: every configuration of the repository is one,
what is wrong is refused where it is wrong, and the schema has the keys of the reference.

    /usr/bin/python3 -B tests/campaign/schema_test.py FLOES PROJECT
"""

import copy
import json
import pathlib
import subprocess
import sys
import tempfile
import tomllib
import unittest

import jsonschema

FLOES, PROJECT = sys.argv.pop(1), pathlib.Path(sys.argv.pop(1))


def floes(*words):
    return subprocess.run([FLOES, *words], check=True, capture_output=True, text=True).stdout


SCHEMA = json.loads(floes("config", "--schema"))

# What is wrong, and what of it the validator names.
WRONG = [
    ("ice.thickness = 0.03", "thickness"),  # without its unit
    ("ice.thickness_m = 0", "exclusiveMinimum|minimum"),
    ("ice.thickness_m = 11.0", "maximum"),
    ("ice.thickness_m = '0.03'", "type"),
    ("ice.thickness_m = [0.03, 0.04]", "type"),  # several values are cases, or an axis
    ("iec.thickness_m = 0.03", "iec"),
    ("campaign.arrangements = 2.5", "type"),
    ("campaign.arrangements = 0", "minimum"),
    ("field.far_end = 'wall'", "enum"),
    ("field.far_end = true", "enum|type"),
    ("run.nominal_modulus = 1", "type"),
    ("moorings.free = ['surge', 'sideways']", "enum"),
    ("moorings.free = 'surge'", "type"),
    ("analysis.averaging_s = 1.0", "type"),
    ("structure.profile_m = [[-0.4, 0.4], [0.1, 0.6, 0.7]]", "additionalItems|maxItems"),
    ("structure.profile_m = [[-0.4], [0.1, 0.6]]", "minItems"),
    ("structure.profile_m = [[-0.4, -0.4], [0.1, 0.6]]", "minimum"),
    ("hull.shape = 'file'\nhull.file = 'a.stl'\nhull.pieces = [[0, 0, 1.0, 0.5, 1.0]]", "not"),
    ("path.legs = [[0, 0.1, 10, 0]]\npath.places = [[0, 0, 0, 0], [10, 1, 0, 0]]", "not"),
    ("[[case]]\nice.thickness_m = 0.03", "required"),  # no name
    ("[[case]]\nname = 'a b'", "pattern"),
    ("[[case]]\nname = 'a'\ncampaign.seed = 3", "campaign"),
    ("[case]\nname = 'a'", "type"),
    ("[[design.axis]]\nfrom = 1\nto = 2", "required"),
    ("[[design.axis]]\nkey = 'ice.thickness_m'", "oneOf"),
    ("[[design.axis]]\nkey = 'ice.thickness_m'\nvalues = [0.02]\nfrom = 0.01\nto = 0.02", "oneOf"),
    ("[[design.axis]]\nkey = 'ice.thickness_m'\nvalues = [0.02]\nscale = 'cubic'", "enum"),
]


def configurations():
    files = [path for folder in ("configs", "ensemble/cli/starters") for path in (PROJECT / folder).rglob("*.toml")
             if not path.name.startswith("targets")]
    return sorted(files) + [PROJECT / "tests/campaign/every_key.toml"]


def faults(text):
    """Keywords of the schema that the text breaks, with the keys that there are not."""
    found = []
    for error in jsonschema.Draft7Validator(SCHEMA).iter_errors(tomllib.loads(text)):
        found.append(error.message if error.validator == "additionalProperties" else error.validator)
    return found


class Schema(unittest.TestCase):
    def test_is_a_schema(self):
        jsonschema.Draft7Validator.check_schema(SCHEMA)

    def test_takes_every_configuration_of_the_repository(self):
        files = configurations()
        self.assertGreater(len(files), 60)
        for path in files:
            self.assertEqual(faults(path.read_text(encoding="utf-8")), [], path)

    def test_takes_what_floes_writes(self):
        self.assertEqual(faults(floes("config", "--defaults")), [])
        for name in ("configs/table3.toml", "configs/design_sobol.toml", "configs/barge.toml", "configs/floating.toml"):
            self.assertEqual(faults(floes("config", "--resolved", str(PROJECT / name))), [], name)

    def test_refuses_what_is_wrong_where_it_is_wrong(self):
        for text, keywords in WRONG:
            found = faults(text)
            self.assertTrue(any(word in fault for word in keywords.split("|") for fault in found), f"{text}: {found}")

    def test_every_wrong_one_is_refused_by_floes_too(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "wrong.toml"
            for text, _ in WRONG:
                path.write_text(text + "\n", encoding="utf-8")
                status = subprocess.run([FLOES, "config", "--check", str(path)], capture_output=True, check=False).returncode
                self.assertEqual(status, 2, text)

    def test_has_the_keys_of_the_reference_with_their_defaults(self):
        reference = json.loads(floes("config", "--reference", "--format", "json"))["keys"]
        keys = {f"{table}.{name}": what for table, one in SCHEMA["properties"].items() if table != "case"
                for name, what in one["properties"].items() if (table, name) != ("design", "axis")}
        self.assertEqual({one["key"] for one in reference}, set(keys))
        for one in reference:
            text = f"value = {one['default']}"
            self.assertEqual(keys[one["key"]].get("default"), tomllib.loads(text)["value"], one["key"])
            self.assertTrue(keys[one["key"]]["description"].startswith(one["meaning"]), one["key"])

    def test_a_default_takes_itself(self):
        for table, one in SCHEMA["properties"].items():
            for name, what in one.get("properties", {}).items():
                if "default" in what:
                    self.assertTrue(jsonschema.Draft7Validator(what).is_valid(what["default"]), (table, name))

    def test_a_broken_schema_is_noticed(self):
        broken = copy.deepcopy(SCHEMA)
        del broken["properties"]["ice"]["properties"]["thickness_m"]
        text = (PROJECT / "configs/kulluk.toml").read_text(encoding="utf-8")
        self.assertTrue(faults(text) == [] and list(jsonschema.Draft7Validator(broken).iter_errors(
            {"ice": {"thickness_m": 1.0}})))


class New(unittest.TestCase):
    def test_names_the_schema_that_it_writes_beside(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "my.toml"
            floes("new", str(path), "--schema")
            first = path.read_text(encoding="utf-8").splitlines()[0]
            self.assertEqual(first, "#:schema ./floes.schema.json")
            beside = path.parent / first.removeprefix("#:schema ")
            self.assertEqual(json.loads(beside.read_text(encoding="utf-8")), SCHEMA)
            floes("config", "--check", str(path))
            floes("new", str(path.with_name("other.toml")))
            self.assertFalse(path.with_name("other.toml").read_text(encoding="utf-8").startswith("#:"))


if __name__ == "__main__":
    unittest.main()
