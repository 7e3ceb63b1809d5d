#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# SPDX-FileCopyrightText: 2026 pcl_shape contributors
"""Make the documentation site: the repository's pages, the tutorials, and the reference of the headers.

Usage: doc/site/make_site.py -o DIRECTORY -v VERSION -d DOXYFILE [-s SPHINX_BUILD] [-b APPLICATIONS]
The sources are laid out as links in DIRECTORY/source, and the site is DIRECTORY/html. Doxygen writes DIRECTORY/xml.
With the directory of the applications, some pictures of tutorials are pages of pcl_shape_viewer as
well. Any warning of Doxygen or Sphinx is an error.
"""
import argparse
import os
import pathlib
import shutil
import subprocess
import sys
from xml.etree import ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGES = ["README.md", "CONTRIBUTING.md", "CHANGELOG.md"]
# The scene of doc/tutorials/make_images.sh, whose pictures have these names; so many points that a page loads at once.
SCENE = "pcl_shape_scene scene.pcd -seed 2"
VIEW = "-camera 0,0,0,-0.03,0.02,0.9,0,-1,0,31 -max_points 120000"
PICTURES = {
    "shape_edge_detection_types": ["pcl_shape_edge_detection scene.pcd types.pcd -types -lines lines.json",
                                   "pcl_shape_viewer types.pcd -field edge_type,edge_likelihood,plain"],
    "shape_edge_detection_lines": ["pcl_shape_viewer types.pcd -field plain,edge_type -lines lines.json"],
    "shape_back_projection": ["pcl_shape_back_projection scene.pcd surfaces.pcd",
                              "pcl_shape_viewer surfaces.pcd -field surface,likelihood,plain"],
    "normal_estimation_sweep": ["pcl_shape_edge_detection scene.pcd normals.pcd -normals",
                                "pcl_shape_viewer normals.pcd -field plain,edge -shade -normals"],
    "shape_instances": ["pcl_shape_instances scene.pcd instances.pcd -class object -json instances.json",
                        "pcl_shape_viewer instances.pcd -field instance,plain -instances instances.json"],
    "label_a_data_set": ["pcl_shape_label scene.pcd labels.pcd",
                         "pcl_shape_viewer labels.pcd -field label,confidence,plain"],
}


def run(command, directory):
    """Run a program. Its output is shown if it fails, or if it has warned."""
    result = subprocess.run(command, cwd=directory, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if result.returncode != 0 or "warning:" in result.stdout.lower():
        sys.exit(f"{result.stdout}\n{' '.join(map(str, command))}: failed, or has warned ({result.returncode})")


def make_pictures(applications, directory):
    """The pages of pcl_shape_viewer, each beside the picture of its name."""
    work = directory / "scene"
    work.mkdir(parents=True, exist_ok=True)
    pages = directory / "pictures"
    pages.mkdir(exist_ok=True)

    def run_application(line, *more):
        name, *words = line.split()
        run([applications / name, *words, *more], work)

    run_application(SCENE)
    for name, lines in PICTURES.items():
        for line in lines[:-1]:
            run_application(line)
        run_application(lines[-1], *VIEW.split(), "-html", pages / f"{name}.html")


def heading(text, underline):
    return f"{text}\n{underline * len(text)}\n\n"


def declarations_of(xml):
    """The directives of Breathe for what each header declares, by header: classes first, then the rest."""
    declarations = {}
    for namespace in "pcl", "pcl::tiling":
        add_declarations(xml, namespace, declarations)
    return declarations


def add_declarations(xml, of_namespace, declarations):
    page = of_namespace.replace("::", "_1_1")
    namespace = ElementTree.parse(xml / f"namespace{page}.xml").getroot().find("compounddef")
    for inner in namespace.findall("innerclass"):
        compound = ElementTree.parse(xml / f"{inner.get('refid')}.xml").getroot().find("compounddef")
        name = inner.text
        own_name = name.removeprefix(of_namespace + "::")
        if "::" not in own_name and "<" not in name:  # those inside of classes come with them
            declarations.setdefault(compound.find("location").get("file"), []).append(
                (own_name, f".. doxygen{compound.get('kind')}:: {name}\n   :members:\n   :undoc-members:\n"))
    for member in namespace.iter("memberdef"):
        name, kind = member.findtext("name"), member.get("kind")
        if not name.startswith("operator"):
            arguments = member.findtext("argsstring") or ""
            declarations.setdefault(member.find("location").get("file"), []).append(
                (name + ("()" if kind == "function" else ""), f".. doxygen{kind}:: {of_namespace}::{name}{arguments}\n"))


def write_reference(source, xml):
    """A page for each public header, and one that lists them."""
    reference = source / "reference"
    reference.mkdir()
    entries = []
    for header, declarations in sorted(declarations_of(xml).items()):
        stem = pathlib.PurePath(header).stem
        text = heading(stem + ".h", "=") + f"::\n\n  #include <{header}>\n\n"
        for name in dict.fromkeys(name for name, _ in declarations):
            text += heading(name, "-") + "\n".join(what for other, what in declarations if other == name) + "\n"
        (reference / f"{stem}.rst").write_text(text)
        entries.append(f"   {stem}")
    (reference / "index.rst").write_text(
        heading("Reference", "=") + "The public headers and what they declare. Lengths are in the unit of the cloud, "
        "which is meters in PCL, and angles in radians, unless a description says otherwise.\n\n"
        ".. toctree::\n   :maxdepth: 2\n\n" + "\n".join(entries) + "\n")


def lay_out(directory):
    """A tree of links that looks like the repository, with pages that are made."""
    source = directory / "source"
    shutil.rmtree(source, ignore_errors=True)
    source.mkdir(parents=True)
    for path in ROOT.iterdir():
        if not path.name.startswith((".", "build")):
            (source / path.name).symlink_to(path)
    return source


def run_sphinx(sphinx, directory, source, version):
    html = directory / "html"
    shutil.rmtree(html, ignore_errors=True)
    os.environ.update(PCL_SHAPE_SITE_VERSION=version, PCL_SHAPE_SITE_XML=str(directory / "xml"),
                      PCL_SHAPE_SITE_PICTURES=str(directory / "pictures"))
    run([sphinx, "-q", "-E", "-W", "--keep-going", "-j", "auto", "-c", ROOT / "doc" / "site",
         "-d", directory / "doctrees", source, html], directory)
    # The first page has the name of its source.
    (html / "index.html").write_text('<!DOCTYPE html>\n<html lang="en">\n<meta charset="utf-8">\n'
                                     '<meta http-equiv="refresh" content="0; url=README.html">\n'
                                     '<link rel="icon" href="_static/icon.svg">\n'
                                     '<title>pcl_shape</title>\n<a href="README.html">pcl_shape</a>\n</html>\n')
    if (directory / "pictures").is_dir():
        shutil.copytree(directory / "pictures", html / "pictures")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-o", dest="output", type=pathlib.Path, required=True)
    parser.add_argument("-v", dest="version", required=True)
    parser.add_argument("-d", dest="doxyfile", type=pathlib.Path, required=True)
    parser.add_argument("-s", dest="sphinx", default="sphinx-build")
    parser.add_argument("-b", dest="applications", type=pathlib.Path)
    arguments = parser.parse_args()
    directory = arguments.output.resolve()
    directory.mkdir(parents=True, exist_ok=True)
    run(["doxygen", arguments.doxyfile], ROOT)
    shutil.rmtree(directory / "pictures", ignore_errors=True)
    if arguments.applications:
        make_pictures(arguments.applications.resolve(), directory)
    source = lay_out(directory)
    write_reference(source, directory / "xml")
    run_sphinx(arguments.sphinx, directory, source, arguments.version)
    print(f"{directory / 'html' / 'index.html'}")


if __name__ == "__main__":
    main()
