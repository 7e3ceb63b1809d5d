# SPDX-License-Identifier: BSD-3-Clause
# SPDX-FileCopyrightText: 2026 pcl_shape contributors
"""Tutorials with their programs and pictures, and their entries in PCL's list of tutorials."""
import re
import shutil

from upstream.series import ROOT

CONTENT = "doc/tutorials/content"
ENTRY = """  * :ref:`{name}`

     ======  ======
     |{name}|  Title: **{title}**

             Author: *pcl_shape contributors*

             Compatibility: > PCL {version}

             {about}
     ======  ======

     .. |{name}| image:: {image}
               :height: 100px

"""
NOTE = """.. note::

   The scenes of this tutorial are generated, and its pictures are drawn, by the applications of
   pcl_shape, which are not a part of PCL.

"""
# What the list says of each tutorial, and in which part of it.
ABOUT = {
    "inad_estimation": (
        "features", "In this tutorial we will learn how much the normals around a point differ, and what that says "
                    "about its surface."),
    "normal_estimation_sweep": (
        "features", "In this tutorial we will replace NormalEstimationOMP by a class that gives the same normals in a "
                    "fraction of the time."),
    "shape_model": (
        "segmentation", "In this tutorial we will learn models of surfaces from samples, and find these surfaces in a "
                        "scene."),
    "shape_edge_detection": (
        "segmentation", "In this tutorial we will learn how to find creases, corners and borders in unorganized point "
                        "clouds."),
    "shape_back_projection": (
        "segmentation", "In this tutorial we will learn how to tell planar from curved surfaces."),
    "shape_instances": ("segmentation", "In this tutorial we will learn how to find all cylinders in a scene."),
}
TITLE = re.compile(r"^(?:[=-]{4,}\n)?([^\n:.=][^\n]*)\n[=-]{4,}\n", re.M)
PICTURE = re.compile(r"images/[\w.]+")
APPLICATION = re.compile(r"\bpcl_shape_(?:scene|viewer)\b")
FIND_US = re.compile(r"find_package\(pcl_shape .*\)\n")
FIND_PCL = re.compile(r"find_package\(PCL .*\)\n")
LINK = re.compile(r"(target_link_libraries\(\w+ PRIVATE) [^)]*\)")


def version_of(tree):
    """The last released version before the tree."""
    found = re.search(r"project\(PCL VERSION (\d+\.\d+\.\d+)", (tree / "CMakeLists.txt").read_text(encoding="utf-8"))
    return found[1]


def program_file(path, tree):
    text = path.read_text(encoding="utf-8")
    if path.name != "CMakeLists.txt":
        return text
    text = FIND_PCL.sub(f"find_package(PCL {version_of(tree)} REQUIRED)\n", FIND_US.sub("", text))
    return LINK.sub(r"\1 ${PCL_LIBRARIES})", text)


def copy_programs(name, tree):
    source, target = (root / CONTENT / "sources" / name for root in (ROOT, tree))
    target.mkdir(parents=True, exist_ok=True)
    for path in sorted(source.iterdir()):
        if path.name != "arguments.cmake":
            (target / path.name).write_text(program_file(path, tree), encoding="utf-8")


def list_tutorial(name, text, tree):
    """Add the tutorial to the end of its part of the list."""
    path = tree / CONTENT / "index.rst"
    index = path.read_text(encoding="utf-8")
    part, about = ABOUT[name]
    begin = index.index(f".. _{part}_tutorial:")
    following = re.compile(r"^\.\. _\w+:", re.M).search(index, begin + 1)
    end = following.start() if following else len(index)
    picture = PICTURE.search(text)
    entry = ENTRY.format(name=name, title=TITLE.search(text)[1], about=about, version=version_of(tree),
                         image=picture[0] if picture else "images/pcl_logo.png")
    path.write_text(index[:end] + entry + index[end:], encoding="utf-8")


def lay_tutorial(name, tree):
    text = (ROOT / CONTENT / f"{name}.rst").read_text(encoding="utf-8")
    if APPLICATION.search(text):
        title = TITLE.search(text)
        text = f"{text[:title.end()]}\n{NOTE}{text[title.end():].lstrip()}"
    for picture in set(PICTURE.findall(text)):
        shutil.copy(ROOT / CONTENT / picture, tree / CONTENT / picture)
    copy_programs(name, tree)
    (tree / CONTENT / f"{name}.rst").write_text(text, encoding="utf-8")
    list_tutorial(name, text, tree)
