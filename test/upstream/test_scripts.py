#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# SPDX-FileCopyrightText: 2026 pcl_shape contributors
"""The scripts that build PCL from its source refuse what they cannot use, and remove only what they made: without PCL."""
import os
import pathlib
import subprocess
import tempfile
import unittest

SCRIPTS = pathlib.Path(__file__).resolve().parent.parent.parent / "scripts"
NAMES = ("upstream", "test_pcl_source")


class Refusals(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.root = pathlib.Path(directory.name)
        self.pcl = self.root / "source"
        self.pcl.mkdir()
        (self.pcl / "PCLConfig.cmake.in").touch()

    def refusal(self, name, *arguments, build="build"):
        """What the script says before it has done anything."""
        result = subprocess.run([SCRIPTS / f"{name}.sh", *arguments], cwd=self.root, capture_output=True, text=True,
                                check=False, env={**os.environ, "BUILD": build})
        self.assertEqual(2, result.returncode, result.stdout + result.stderr)
        self.assertEqual("", result.stdout)
        return result.stderr

    def test_no_source_tree(self):
        for name in NAMES:
            self.assertIn(f"expected PCL's source tree: scripts/{name}.sh PCL_SOURCE", self.refusal(name))
            self.assertIn(f"{self.root}/missing is no source tree of PCL", self.refusal(name, "missing"))

    def test_a_build_in_the_source_tree_or_around_it(self):
        for name in NAMES:
            for build in ("source", "source/build", "."):
                self.assertIn("must not hold PCL's source tree", self.refusal(name, "source", build=build))
        self.assertEqual([self.pcl / "PCLConfig.cmake.in"], list(self.pcl.iterdir()))

    def test_a_build_with_files_of_somebody_else(self):
        for folder in ("pcl", "default/prefix"):
            (self.root / "build" / folder).mkdir(parents=True)
            (self.root / "build" / folder / "mine").touch()
        for name in NAMES:
            self.assertIn("which holds other files: expected a new or empty directory", self.refusal(name, "source"))
        self.assertEqual(2, len(list(self.root.glob("build/**/mine"))))

    def test_indices(self):
        self.assertEqual("indices '32': it must be default or 64\n", self.refusal("test_pcl_source", "source", "32"))


if __name__ == "__main__":
    unittest.main()
