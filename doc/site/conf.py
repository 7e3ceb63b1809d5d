# SPDX-License-Identifier: BSD-3-Clause
# SPDX-FileCopyrightText: 2026 pcl_shape contributors
# Sphinx's configuration of the documentation site; make_site.py lays out its sources and runs it.
import os
import pathlib
import re

from docutils import nodes

project = "pcl_shape"
author = "pcl_shape contributors"
copyright = "2026, pcl_shape contributors"
version = release = os.environ["PCL_SHAPE_SITE_VERSION"]
extensions = ["myst_parser", "breathe"]
source_suffix = {".md": "markdown", ".rst": "restructuredtext"}
root_doc = "README"
include_patterns = ["*.md", "doc/*.md", "doc/tutorials/content/*.rst", "reference/*.rst"]
nitpicky = False

html_theme = "sphinx_rtd_theme"
html_theme_options = {"collapse_navigation": False, "navigation_depth": 3}
html_title = f"pcl_shape {release}"
html_static_path = ["static"]
html_css_files = ["site.css"]
html_favicon = "static/icon.svg"
html_show_sourcelink = False
html_copy_source = False

myst_heading_anchors = 4  # as GitHub makes them
breathe_projects = {"pcl_shape": os.environ["PCL_SHAPE_SITE_XML"]}
breathe_default_project = "pcl_shape"
cpp_id_attributes = ["PCL_SHAPE_EXPORTS"]

# The pages are written to be read in the repository, too, which knows no tables of contents: they are added here.
CONTENTS = {
    "README": [("Documentation", ["doc/README", "doc/using", "doc/method", "doc/files", "doc/errors"]),
               ("Tutorials", ["doc/tutorials/content/index"]),
               ("Tasks", ["doc/instances", "doc/grasps", "doc/labels", "doc/ground", "doc/keypoints", "doc/worlds"]),
               ("Reference", ["reference/index"]),
               ("Project", ["doc/evaluation", "doc/performance", "CONTRIBUTING", "CHANGELOG"])]}


def contents_of(docname, app):
    """The tables of contents of a page, and pages of doc/ that none of them names."""
    groups = CONTENTS.get(docname, [])
    if not groups:
        return ""
    named = {name for _, names in groups for name in names}
    more = sorted(name for name in app.env.found_docs
                  if name.startswith("doc/") and name.count("/") == 1 and name not in named)
    text = ""
    for caption, names in groups:
        entries = names + (more if caption == "Documentation" else [])
        text += f"\n```{{toctree}}\n:hidden:\n:caption: {caption}\n\n" + "\n".join(entries) + "\n```\n"
    return text


def add_contents(app, docname, source):
    source[0] += contents_of(docname, app)


def link_living_pictures(app, document, docname):
    """A picture that pcl_shape_viewer has also written as a page leads there."""
    pages = pathlib.Path(os.environ["PCL_SHAPE_SITE_PICTURES"])
    up = "../" * docname.count("/")
    for image in list(document.findall(nodes.image)):
        page = pages / (pathlib.PurePath(image["uri"]).stem + ".html")
        if not page.is_file() or isinstance(image.parent, nodes.reference):
            continue
        target = f"{up}pictures/{page.name}"
        parent = image.parent
        wrapped = nodes.reference("", "", image, refuri=target, internal=False)
        parent.replace(image, wrapped)
        invite(parent, wrapped, nodes.reference("", "Turn it in your browser", refuri=target, internal=False))


def invite(parent, picture, link):
    """Say that the picture can be turned: in its caption, or below it."""
    caption = next(iter(parent.findall(nodes.caption)), None) if isinstance(parent, nodes.figure) else None
    if caption is not None:
        caption += [nodes.Text(" "), link, nodes.Text(".")]
    else:
        parent.insert(parent.index(picture) + 1, nodes.paragraph("", "", link, nodes.Text(".")))


def on_read(app, document):
    link_living_pictures(app, document, app.env.docname)


def setup(app):
    app.connect("source-read", add_contents)
    app.connect("doctree-read", on_read)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
