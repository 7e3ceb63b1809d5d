#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# SPDX-FileCopyrightText: 2026 pcl_shape contributors
"""Write into doc/upstream.md how large the pull requests to PCL would be: files and lines of each.

Usage: scripts/upstream_sizes.py
"""
from benchmark_tables import rewrite, table
from upstream.series import ROOT, files_of_series

KINDS = {"headers": ("include/",), "sources": ("src/", "models/"), "tests": ("test/", "tools/scene/"),
         "tools and tutorials": ("tools/upstream/", "doc/")}


def lines_of(name):
    return len((ROOT / name).read_text(encoding="utf-8").splitlines())


def row(number, what, names):
    """One line of the table."""
    cells = [number, what]
    for folders in KINDS.values():
        lines = [lines_of(name) for name in names if name.startswith(folders)]
        cells.append(f"{len(lines)} file{'s'[:len(lines) != 1]}, {sum(lines):,} lines" if lines else "–")
    return cells


def main():
    rows = [row(number, *of) for number, of in enumerate(files_of_series(), 1)]
    rewrite(ROOT / "doc/upstream.md", {"upstream": table(["", "pull request", *KINDS], rows)})


if __name__ == "__main__":
    main()
