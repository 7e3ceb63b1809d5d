#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# SPDX-FileCopyrightText: 2026 pcl_shape contributors
"""What Doxygen reads in the place of a header: getters and names of types that every class of PCL has get a line of
documentation, which would only repeat their setter's in the header; and protected members are left out, as the
reference is for callers. No line is added.

Usage: doc/site/header_filter.py HEADER
"""
import re
import sys

TYPES = {"Ptr": "A shared pointer to it.", "ConstPtr": "A shared pointer to it, to read only.",
         "PointCloud": "The cloud of its points.", "PointCloudOut": "The cloud of its results.",
         "PointCloudConstPtr": "The cloud of its points, to read only.",
         "PointCloudNConstPtr": "A cloud of normals, to read only.",
         "INADCloudConstPtr": "A cloud of INAD, to read only.", "SearchPtr": "A search method of PCL."}
TYPE = re.compile(r"  using (\w+) =")
GETTER = re.compile(r"  get(\w+)\(\) const$")


def filtered(lines):
    lines = [re.sub(r"^protected:", "private:", line) for line in lines]
    for i, line in enumerate(lines):
        documented = lines[i - 1].rstrip().endswith("*/")
        if (name := TYPE.match(line)) and name[1] in TYPES and not documented:
            lines[i] = f"  /** \\brief {TYPES[name[1]]} */{line}"
        getter = GETTER.match(line)
        if getter and not lines[i - 2].rstrip().endswith("*/"):
            lines[i - 1] = f"  /** \\brief What set{getter[1]}() has set, or the default. */{lines[i - 1]}"
    return lines


with open(sys.argv[1], encoding="utf-8") as header:
    print("\n".join(filtered(header.read().split("\n"))), end="")
