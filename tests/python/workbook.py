#!/usr/bin/python3
"""The workbook of floes summarize has what its CSV has, as numbers, on sheets that other programs read.

    workbook.py FLOES SYNTHETIC_FILE
"""
import csv
import io
import subprocess
import sys
import tempfile
import warnings

import openpyxl

FLOES, MAKE_FILE = sys.argv[1:]


def floes(*words, folder):
    return subprocess.run([FLOES, *words], cwd=folder, check=True, capture_output=True, text=True).stdout


def rows_of(sheet):
    return [["" if cell is None else cell for cell in row] for row in sheet.iter_rows(values_only=True)]


def same(cell, text):
    if isinstance(cell, str):
        return cell == text
    return abs(float(cell) - float(text)) <= 1e-12 * abs(float(text))


def compare(book, name, table):
    """The sheet beside the CSV of the same part."""
    found = rows_of(book[name])
    expected = list(csv.reader(io.StringIO(table)))
    assert len(found) == len(expected) > 1, f"{name}: {len(found)} lines, not {len(expected)}"
    for row, line in zip(found, expected):
        assert len(row) == len(line), f"{name}: {row} beside {line}"
        for cell, text in zip(row, line):
            assert same(cell, text), f"{name}: {cell!r} where the CSV has {text!r}"
    numbers = [cell for row in found[1:] for cell in row if not isinstance(cell, str)]
    assert len(numbers) > len(found), f"{name} has no numbers"


with tempfile.TemporaryDirectory() as folder, warnings.catch_warnings():
    warnings.simplefilter("error")  # openpyxl warns of what it cannot read
    subprocess.run([MAKE_FILE, f"{folder}/a.h5"], check=True)
    floes("summarize", "a.h5", "-o", "a.xlsx", folder=folder)
    book = openpyxl.load_workbook(f"{folder}/a.xlsx")
    assert book.sheetnames == ["overview", "contents", "cases", "members", "pairs"], book.sheetnames
    for name in book.sheetnames[2:]:
        compare(book, name, floes("summarize", "a.h5", "--format", "csv", "--parts", name, folder=folder))
        assert book[name].freeze_panes == "B2" and book[name]["A1"].font.bold, name
    overview = rows_of(book["overview"])
    head = next(k for k, row in enumerate(overview) if row[0] == "case")
    assert overview[head][2:4] == ["mean load, N", "± (95 %)"], overview[head]
    about = list(csv.DictReader(io.StringIO(floes("summarize", "a.h5", "--format", "csv", "--parts", "cases", folder=folder))))
    for row, case in zip(overview[head + 1:], about):
        assert row[0] == case["name"] and same(row[2], case["mean_load"]), (row, case)
        for heading, key, factor in (("mean load, N", "mean_load", 1), ("broken floes, %", "failure_ratio", 100)):
            at = overview[head].index(heading)
            value, low, high = (float(case[name]) for name in (key, f"{key}_low", f"{key}_high"))
            longer = factor * max(high - value, value - low)  # as the screen has it
            assert row[at + 1] == "" or same(row[at + 1], longer), (heading, row, case)
    assert len(book["overview"]._charts) == 1
    contents = {row[0]: row[1] for row in rows_of(book["contents"])}
    assert set(book.sheetnames[2:]) < set(contents) and contents["campaign"] == "synthetic", contents

    floes("summarize", "a.h5", "--parts", "long,design", "-o", "some.xlsx", folder=folder)
    some = openpyxl.load_workbook(f"{folder}/some.xlsx")
    assert some.sheetnames[1:4] == ["contents", "long", "design loads"], some.sheetnames
    compare(some, "long", floes("summarize", "a.h5", "--format", "csv", "--long", folder=folder))

    floes("new", "d.toml", "--design", folder=folder)
    floes("run", "d.toml", "--set", "campaign.arrangements=2", "--set", "analysis.steady_start_s=4",
          "--set", "analysis.window_s=6", "--set", "general.solver=direct", "--set", "joint.model=beam", folder=folder)
    floes("summarize", "d.h5", "--format", "xlsx", "-o", "d.xlsx", folder=folder)
    design = openpyxl.load_workbook(f"{folder}/d.xlsx")
    assert "design" in design.sheetnames, design.sheetnames
    header = rows_of(design["design"])[0]
    assert "ice.thickness_m" in header and "mean_load" in header, header
print("workbooks agree")
