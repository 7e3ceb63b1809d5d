#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# SPDX-FileCopyrightText: 2026 pcl_shape contributors
"""The pull requests to PCL are complete, and laid where PCL looks for them. Without PCL: what they are laid into
has only the lines that the layout looks for. scripts/upstream.sh builds them in PCL itself."""
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "scripts"))

from stand_in import STAND_IN, make_stand_in  # noqa: E402
from upstream.places import place_of  # noqa: E402
from upstream.series import files_of_series  # noqa: E402

# Where a file's quoted includes are looked for, by the beginning of its place.
ROOTS = {
    "features/": ["features/src/shape"],
    "segmentation/": ["segmentation/src/shape", "features/src/shape"],
    "test/features/": ["test/features/shape", "features/src/shape"],
    "test/segmentation/": ["test/segmentation/shape", "test/features/shape", "segmentation/src/shape",
                           "features/src/shape"],
    "tools/": [],
}
INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"', re.M)
ENDINGS = (".h", ".hpp", ".cpp", ".in")
# What CMake reads when it configures.
FOREACH = re.compile(r"foreach\((\w+) ([^)]*)\)\n(.*?)endforeach\(\)", re.S)
SET = re.compile(r"^\s*set\((\w+) (\S+)\)$", re.M)
READ = re.compile(r"(?:configure_file\(|file\(READ )(\S+)")


def lay_out(tree, *arguments):
    return subprocess.run([ROOT / "scripts" / "upstream" / "lay_out.py", tree, *arguments], capture_output=True,
                          text=True, check=False)


def files_read(text, folder):
    """The files that the CMake list of a folder names in configure_file() and file(READ)."""
    for name, items, body in FOREACH.findall(text):
        text += "".join(body.replace(f"${{{name}}}", item) for item in items.split())
    variables = {"CMAKE_CURRENT_SOURCE_DIR": folder}
    found = []
    for line in FOREACH.sub("", text).splitlines():
        for name, value in variables.items():
            line = line.replace(f"${{{name}}}", str(value))
        variables.update(SET.findall(line))
        found += READ.findall(line)
    return [folder / name for name in found]


class Layout(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.tree = pathlib.Path(directory.name)
        make_stand_in(self.tree)

    def text(self, name):
        return (self.tree / name).read_text(encoding="utf-8")

    def laid(self):
        """The places of all C++ files that are there."""
        return sorted(path.relative_to(self.tree).as_posix() for path in self.tree.rglob("*")
                      if path.suffix in ENDINGS and "doc" not in path.relative_to(self.tree).parts)

    def lay(self, *arguments):
        result = lay_out(self.tree, *arguments)
        self.assertEqual(0, result.returncode, result.stderr)
        return result.stdout.split()

    def test_every_file_has_its_place(self):
        targets = self.lay()
        self.assertEqual("test_neighborhood_sweep", targets[0])
        self.assertEqual("pcl_shape_instance_segmentation", targets[-1])
        expected = sorted(place_of(name) for _, names in files_of_series() for name in names
                          if name.endswith(ENDINGS))
        self.assertEqual(expected, self.laid())

    def test_every_source_is_compiled_and_every_header_installed(self):
        self.lay()
        for place in self.laid():
            if place.endswith((".cpp", ".hpp")) or "/include/" in place:
                folder = next(folder for folder in ROOTS if place.startswith(folder) and folder != "test/")
                lists = self.text(folder + "CMakeLists.txt").replace("${SUBSYS_NAME}", folder.rstrip("/"))
                if place.startswith("test/"):
                    lists = "".join(self.text(f"test/{module}/CMakeLists.txt")
                                    for module in ("features", "segmentation"))
                self.assertIn(place[len(folder):], lists)

    def test_what_cmake_reads_is_there(self):
        self.lay()
        read = files_read(self.text("features/CMakeLists.txt"), self.tree / "features")
        self.assertCountEqual(["edges.json", "surfaces.json", "default_models.cpp.in"], [path.name for path in read])
        for module in ("features", "segmentation", "test/features", "test/segmentation", "tools"):
            for path in files_read(self.text(f"{module}/CMakeLists.txt"), self.tree / module):
                self.assertTrue(path.is_file(), path)

    def test_what_counts_is_decided_by_unfused_operations(self):
        self.lay()
        for module, file in (("features", "features/listed_neighborhoods"), ("features", "sweep/block_sweep"),
                             ("segmentation", "instances/primitives/counting_models")):
            self.assertRegex(self.text(f"{module}/CMakeLists.txt"),
                             rf"set_source_files_properties\([^)]*src/shape/{file}\.cpp[^)]*-ffp-contract=off")

    def test_includes_are_found(self):
        self.lay()
        for place in self.laid():
            folder = next(folder for folder in ROOTS if place.startswith(folder))
            roots = [self.tree / root for root in ROOTS[folder]] + [(self.tree / place).parent]
            for written in INCLUDE.findall(self.text(place)):
                self.assertTrue(any((root / written).is_file() for root in roots), f"{place}: {written}")

    def test_files_are_as_pcl_has_them(self):
        self.lay()
        for place in self.laid():
            text = self.text(place)
            self.assertTrue(text.startswith("/*\n * SPDX-License-Identifier: BSD-3-Clause\n *\n"), place)
            self.assertIn("Point Cloud Library (PCL) - www.pointclouds.org", text)
            for ours in ("PCL_SHAPE_EXPORTS", "pcl_shape_exports.h", "pcl_shape_alignment.h", "<gtest/gtest.h>",
                         "PCL_SHAPE_ONLY_CORE_POINT_TYPES"):
                self.assertNotIn(ours, text, place)
        self.assertIn("#ifndef PCL_NO_PRECOMPILE\nPCL_INSTANTIATE", self.text("features/src/shape/features/inad.cpp"))

    def test_the_first_needs_neither_json_nor_highway(self):
        self.assertEqual(["test_neighborhood_sweep"], self.lay("1"))
        self.assertEqual(STAND_IN["CMakeLists.txt"], self.text("CMakeLists.txt"))
        self.assertEqual(STAND_IN["segmentation/CMakeLists.txt"], self.text("segmentation/CMakeLists.txt"))
        self.assertNotIn("HIGHWAY", self.text("features/CMakeLists.txt"))

    def test_tutorials_are_listed_and_do_not_look_for_this_library(self):
        self.lay()
        index = self.text("doc/tutorials/content/index.rst")
        self.assertLess(index.index(":ref:`inad_estimation`"), index.index("_filtering_tutorial"))
        self.assertLess(index.index("_filtering_tutorial"), index.index(":ref:`shape_instances`"))
        for path in (self.tree / "doc/tutorials/content/sources").rglob("CMakeLists.txt"):
            self.assertNotIn("pcl_shape", path.read_text(encoding="utf-8"), path)

    def test_refusals(self):
        for count in ("0", "8", "-1", "x", "1.5", "", "\u0661"):
            self.assertEqual(f"'{count}' pull requests: it must be a number from 1 to 7\n",
                             lay_out(self.tree, count).stderr)
        self.lay("2")
        self.assertIn("has the files already", lay_out(self.tree).stderr)
        self.assertIn("no source tree of PCL", lay_out(self.tree / "doc").stderr)


if __name__ == "__main__":
    unittest.main()
