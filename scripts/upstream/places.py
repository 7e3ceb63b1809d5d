# SPDX-License-Identifier: BSD-3-Clause
# SPDX-FileCopyrightText: 2026 pcl_shape contributors
"""Where a file goes in PCL's tree, and what changes in it on the way."""
import re

# The rooms keep their names below one folder of each module: their includes begin with them.
SHAPE = "shape"
FEATURES_ROOMS = ("common", "geometry", "sweep", "features")
SEGMENTATION_TESTS = ("geometry", "edges", "surfaces", "instances", "segmentation")
# Longer beginnings first.
PLACES = [
    ("include/pcl/features/", "features/include/pcl/features/"),
    ("include/pcl/segmentation/", "segmentation/include/pcl/segmentation/"),
    *((f"src/{room}/", f"features/src/{SHAPE}/{room}/") for room in FEATURES_ROOMS),
    ("src/", f"segmentation/src/{SHAPE}/"),
    ("models/", f"features/src/{SHAPE}/models/"),
    *((f"test/{room}/", f"test/segmentation/{SHAPE}/{room}/") for room in SEGMENTATION_TESTS),
    ("test/", f"test/features/{SHAPE}/"),
    ("tools/scene/", f"test/segmentation/{SHAPE}/scene/"),
    ("tools/upstream/", "tools/"),
    ("doc/", "doc/"),
]
LICENSE = """/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 *  Point Cloud Library (PCL) - www.pointclouds.org
 *  Copyright (c) {owner}
 *
 *  All rights reserved
 */

"""
SPDX = re.compile(r"// SPDX-License-Identifier: BSD-3-Clause\n// SPDX-FileCopyrightText: (\d+) (.+)\n")
REPLACED = [
    ("#include <pcl/pcl_shape_exports.h>", "#include <pcl/pcl_exports.h>"),
    ("#include <pcl/pcl_shape_alignment.h>\n", ""),  # PCL looks after alignment itself
    ('#include "upstream/', '#include "'),  # PCL's tools are in one folder
    ("#include <gtest/gtest.h>", "#include <pcl/test/gtest.h>"),
    ("PCL_SHAPE_EXPORTS", "PCL_EXPORTS"),
    ("PCL_SHAPE_HAS_HIGHWAY", "PCL_HAS_HIGHWAY"),
    ("pcl_shape_parallel_error", "pcl_parallel_error"),
]
# PCL compiles its classes for more point types, or for none.
INSTANTIATIONS = re.compile(r"^PCL_INSTANTIATE(?:_PRODUCT)?\((?:[^()]|\((?:[^()]|\([^()]*\))*\))*\)\n", re.M)
POINT_TYPES = re.compile(r"#ifdef PCL_SHAPE_ONLY_CORE_POINT_TYPES .*?#else\n// Others need PCL_NO_PRECOMPILE\.\n"
                         r"// clang-format off\n(.*)// clang-format on\n#endif\n", re.S)
ALL_POINT_TYPES = """#ifdef PCL_ONLY_CORE_POINT_TYPES
// clang-format off
{core}// clang-format on
#else
#define PCL_SHAPE_POINT_TYPES PCL_XYZ_POINT_TYPES
#define PCL_SHAPE_NORMAL_TYPES PCL_NORMAL_POINT_TYPES
#endif
"""


def place_of(name):
    """A file's place, both from the roots of their trees."""
    for begin, place in PLACES:
        if name.startswith(begin):
            return place + name[len(begin):]
    raise ValueError(f"{name}: no place is known; expected one of {[begin for begin, _ in PLACES]}")


def only_if_precompiled(text):
    """Explicit instantiations, one after the other to the last, unless PCL compiles none."""
    found = list(INSTANTIATIONS.finditer(text))
    if not found:
        return text
    begin, end = found[0].start(), found[-1].end()
    return f"{text[:begin]}#ifndef PCL_NO_PRECOMPILE\n{text[begin:end]}#endif\n{text[end:]}"


def text_of(name, text):
    """A C++ file as PCL has it."""
    text = SPDX.sub(lambda match: LICENSE.format(owner=", ".join(match.groups())), text, count=1)
    for ours, theirs in REPLACED:
        text = text.replace(ours, theirs)
    if name == "src/common/point_types.h":
        text, changes = POINT_TYPES.subn(lambda match: ALL_POINT_TYPES.format(core=match[1]), text)
        if changes != 1:
            raise ValueError(f"{name}: the point types are not where they were")
    elif name.startswith("src/"):
        text = only_if_precompiled(text)
    return text
