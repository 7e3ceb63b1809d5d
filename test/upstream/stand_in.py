# SPDX-License-Identifier: BSD-3-Clause
# SPDX-FileCopyrightText: 2026 pcl_shape contributors
"""A stand-in for PCL's source tree: it has only the lines that the layout of the pull requests looks for."""
MODULE = """set(SUBSYS_NAME {name})
set(incs
  "include/pcl/${{SUBSYS_NAME}}/own.h"
)
set(impl_incs
  "include/pcl/${{SUBSYS_NAME}}/impl/own.hpp"
)
set(srcs
  src/own.cpp
)
set(LIB_NAME "pcl_${{SUBSYS_NAME}}")
PCL_ADD_LIBRARY(${{LIB_NAME}} COMPONENT ${{SUBSYS_NAME}} SOURCES ${{srcs}} ${{incs}} ${{impl_incs}})
PCL_MAKE_PKGCONFIG(${{LIB_NAME}} COMPONENT ${{SUBSYS_NAME}})
"""
STAND_IN = {
    "CMakeLists.txt": "project(PCL VERSION 1.2.3)\nfind_package(nanoflann 1.4.2 QUIET)\nif(TRUE)\nendif()\n",
    "features/CMakeLists.txt": MODULE.format(name="features"),
    "segmentation/CMakeLists.txt": MODULE.format(name="segmentation"),
    "test/features/CMakeLists.txt": "set(SUBSYS_NAME tests_features)\n",
    "test/segmentation/CMakeLists.txt": "set(SUBSYS_NAME tests_segmentation)\n",
    "tools/CMakeLists.txt":
        "  target_link_libraries (pcl_crf_segmentation pcl_common pcl_io pcl_segmentation)\n"
        "  target_link_libraries (pcl_normal_estimation pcl_common pcl_io pcl_kdtree pcl_features)\n",
    "doc/tutorials/content/index.rst":
        ".. _features_tutorial:\n\n.. _filtering_tutorial:\n\n.. _segmentation_tutorial:\n\n.. _surface_tutorial:\n",
    "doc/tutorials/content/images/pcl_logo.png": "",
    "doc/tutorials/content/sources/own/CMakeLists.txt": "",
}


def make_stand_in(tree):
    for name, text in STAND_IN.items():
        path = tree / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
