# SPDX-License-Identifier: BSD-3-Clause
# SPDX-FileCopyrightText: 2026 pcl_shape contributors
"""Docstrings and stubs say what there is; the examples run."""
import ast
import os
import pathlib
import re
import subprocess
import sys

import numpy as np
import pytest

import pcl_shape
from conftest import table_scene

SOURCE = pathlib.Path(os.environ["PCL_SHAPE_SOURCE_DIR"])


def stub():
    path = pathlib.Path(pcl_shape.__file__).with_suffix(".pyi")
    assert (path.parent / "py.typed").exists()
    return ast.parse(path.read_text()).body


def public(thing):
    return {name for name in vars(thing) if not name.startswith("_")}


def test_everything_has_a_docstring():
    for name in set(pcl_shape.__all__) - {"__version__"}:
        thing = getattr(pcl_shape, name)
        assert thing.__doc__, name
        if isinstance(thing, type):
            for member in public(thing):
                assert getattr(thing, member).__doc__, f"{name}.{member}"


def test_stubs_have_what_the_module_has():
    functions = {node.name: node for node in stub() if isinstance(node, ast.FunctionDef)}
    classes = {node.name: node for node in stub() if isinstance(node, ast.ClassDef)}
    assert {*functions, *classes, "__version__"} == set(pcl_shape.__all__)
    for name, node in classes.items():
        methods = {item.name: item for item in node.body if isinstance(item, ast.FunctionDef)}
        assert {m for m in methods if not m.startswith("_")} == public(getattr(pcl_shape, name)), name
        functions.update({f"{name}.{m}": item for m, item in methods.items() if not m.startswith("_")})
    for name, node in functions.items():
        *owner, last = name.split(".")
        documented = getattr(getattr(pcl_shape, owner[0]) if owner else pcl_shape, last).__doc__
        if "->" in documented.splitlines()[0]:  # pybind11's signature
            signature = documented[:documented.index("->")]
            arguments = [a.arg for a in node.args.args + node.args.kwonlyargs if a.arg != "self"]
            assert re.findall(r"(\w+): ", signature.replace("self: ", "")) == arguments, name


def test_module_doc_example(capsys):
    text = pcl_shape.__doc__
    code = "\n".join(line[4:] for line in text.splitlines() if line.startswith("    "))
    exec(code, {"points": table_scene()})
    assert "points are on edges" in capsys.readouterr().out


@pytest.mark.parametrize("example,needs", [("matplotlib_surfaces.py", "matplotlib"), ("open3d_colors.py", "open3d")])
def test_examples(example, needs, tmp_path):
    path = tmp_path / "points.npy"
    np.save(path, table_scene())
    out = tmp_path / "out"
    run = subprocess.run([sys.executable, SOURCE / "python" / "examples" / example, path, out.with_suffix(".png")
                          if needs == "matplotlib" else out.with_suffix(".ply")],
                         stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, env={**os.environ, "MPLBACKEND": "agg"})
    if f"needs {needs}" in run.stdout:
        pytest.skip(run.stdout.strip())
    assert run.returncode == 0, run.stdout
    assert next(tmp_path.glob("out.*")).stat().st_size > 1000
