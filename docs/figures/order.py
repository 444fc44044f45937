#!/usr/bin/python3
"""The tables of docs/field.md and its picture, from the summaries in docs/order.

Usage:
    order.py                            writes tables and picture
    order.py --check                    writes nothing; fails if the page differs from the summaries
    order.py --collect FOLDER [--program FLOES]
                                        first takes the summaries of the finished campaigns in FOLDER (order.h5,
                                        wall_far_end.h5) with the program FLOES (default ./floes)
"""
import argparse
import pathlib

import order_tables
from order_data import SUMMARIES, collect, collect_walls
from page_blocks import fill_or_check

PAGE = SUMMARIES.parent / "field.md"


def main():
    parser = argparse.ArgumentParser(description="The tables of docs/field.md and its picture.")
    parser.add_argument("--check", action="store_true", help="write nothing; fail if the page differs")
    parser.add_argument("--collect", type=pathlib.Path, metavar="FOLDER", help="take the summaries first")
    parser.add_argument("--program", default="./floes", metavar="FLOES")
    options = parser.parse_args()
    if options.collect is not None:
        for name, take in (("order", collect), ("wall_far_end", collect_walls)):
            if (campaign := options.collect / f"{name}.h5").exists():
                take(campaign, options.program)
    fill_or_check({PAGE: order_tables.BLOCKS}, options.check, "order.py")
    if options.check:
        return
    import order_figure  # needs matplotlib, which --check does not

    order_figure.draw_fields(SUMMARIES / "fields.svg")


if __name__ == "__main__":
    main()
