"""What the program says on standard output: as text, or with --format json as data."""
import json
import subprocess


def said(*command):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout


def told(*command):
    return json.loads(said(*command, "--format", "json"))
