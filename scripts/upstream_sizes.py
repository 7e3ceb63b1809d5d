#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# SPDX-FileCopyrightText: 2026 pcl_shape contributors
"""Write into doc/upstream.md how large the pull requests to PCL would be: files and lines of each.

Usage: scripts/upstream_sizes.py
"""
from upstream.series import ROOT, files_of_series

KINDS = {"headers": ("include/",), "sources": ("src/", "models/"), "tests": ("test/", "tools/scene/"),
         "tools and tutorials": ("tools/upstream/", "doc/")}
BEGIN, END = "<!-- begin upstream -->\n", "<!-- end upstream -->"


def lines_of(name):
    return len((ROOT / name).read_text(encoding="utf-8").splitlines())


def row(number, what, names):
    """One line of the table."""
    cells = []
    for folders in KINDS.values():
        lines = [lines_of(name) for name in names if name.startswith(folders)]
        cells.append(f"{len(lines)} file{'s'[:len(lines) != 1]}, {sum(lines):,} lines" if lines else "–")
    return f"| {number} | {what} | {' | '.join(cells)} |\n"


def main():
    page = ROOT / "doc" / "upstream.md"
    table = f"| | pull request | {' | '.join(KINDS)} |\n" + "|---" * (2 + len(KINDS)) + "|\n"
    for number, (what, names) in enumerate(files_of_series(), 1):
        table += row(number, what, names)
    text = page.read_text(encoding="utf-8")
    before, rest = text.split(BEGIN)
    page.write_text(before + BEGIN + table + END + rest.split(END)[1], encoding="utf-8")


if __name__ == "__main__":
    main()
