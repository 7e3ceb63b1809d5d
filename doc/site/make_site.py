#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# SPDX-FileCopyrightText: 2026 pcl_shape contributors
"""Make the documentation site: the repository's pages, the tutorials, and the reference of the headers.

Usage: doc/site/make_site.py -o DIRECTORY -v VERSION -d DOXYFILE -x XML [-b APPLICATIONS]
The sources are laid out as links in DIRECTORY/source, as Sphinx's are, and the site is DIRECTORY/html. Doxygen writes
the directory XML. With the directory of the applications, some pictures of tutorials are pages of pcl_shape_viewer as
well. Any warning of Doxygen or Sphinx is an error.
"""
import argparse
import os
import pathlib
import shutil
import subprocess
import sys

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


def write_reference(source, xml):
    """A page for each public header, and one that lists them."""
    reference = source / "reference"
    reference.mkdir()
    headers = sorted((ROOT / "include").glob("pcl/*/*.h"))
    for header in headers:
        name = header.relative_to(ROOT / "include").as_posix()
        (reference / f"{header.stem}.rst").write_text(
            f"{name}\n{'=' * len(name)}\n\n::\n\n  #include <{name}>\n\n"
            f".. doxygenfile:: {header.name}\n   :project: pcl_shape\n   :sections: innerclass innernamespace "
            "briefdescription detaileddescription enum func typedef public-attrib public-func public-slot "
            "public-static-attrib public-static-func public-type define var\n")
    entries = "\n".join(f"   {header.stem}" for header in headers)
    title = "Reference"
    (reference / "index.rst").write_text(
        f"{title}\n{'=' * len(title)}\n\nThe public headers and what they declare. Lengths are in the unit of the "
        f"cloud, which is meters in PCL, and angles in radians, unless a description says otherwise.\n\n"
        f".. toctree::\n   :maxdepth: 1\n\n{entries}\n")


def lay_out(directory):
    """A tree of links that looks like the repository, with pages that are made."""
    source = directory / "source"
    shutil.rmtree(source, ignore_errors=True)
    source.mkdir(parents=True)
    for path in ROOT.iterdir():
        if not path.name.startswith((".", "build")):
            (source / path.name).symlink_to(path)
    return source


def run_sphinx(directory, source, xml, version):
    html = directory / "html"
    shutil.rmtree(html, ignore_errors=True)
    os.environ.update(PCL_SHAPE_SITE_VERSION=version, PCL_SHAPE_SITE_XML=str(xml),
                      PCL_SHAPE_SITE_PICTURES=str(directory / "pictures"))
    run(["sphinx-build", "-q", "-W", "--keep-going", "-j", "auto", "-c", ROOT / "doc" / "site",
         "-d", directory / "doctrees", source, html], directory)
    # The first page has the name of its source.
    (html / "index.html").write_text('<!DOCTYPE html>\n<html lang="en">\n<meta charset="utf-8">\n'
                                     '<meta http-equiv="refresh" content="0; url=README.html">\n'
                                     '<title>pcl_shape</title>\n<a href="README.html">pcl_shape</a>\n</html>\n')
    if (directory / "pictures").is_dir():
        shutil.copytree(directory / "pictures", html / "pictures")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-o", dest="output", type=pathlib.Path, required=True)
    parser.add_argument("-v", dest="version", required=True)
    parser.add_argument("-d", dest="doxyfile", type=pathlib.Path, required=True)
    parser.add_argument("-x", dest="xml", type=pathlib.Path, required=True)
    parser.add_argument("-b", dest="applications", type=pathlib.Path)
    arguments = parser.parse_args()
    directory = arguments.output.resolve()
    directory.mkdir(parents=True, exist_ok=True)
    run(["doxygen", arguments.doxyfile], ROOT)
    shutil.rmtree(directory / "pictures", ignore_errors=True)
    if arguments.applications:
        make_pictures(arguments.applications.resolve(), directory)
    source = lay_out(directory)
    write_reference(source, arguments.xml)
    run_sphinx(directory, source, arguments.xml.resolve(), arguments.version)
    print(f"{directory / 'html' / 'index.html'}")


if __name__ == "__main__":
    main()
