#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# SPDX-FileCopyrightText: 2026 pcl_shape contributors
"""The scripts that build PCL from its source refuse what they cannot use, remove only what they made, and build and
run what they are asked for. Without PCL, and with a stand-in for CMake and CTest that writes down its calls."""
import os
import pathlib
import subprocess
import tempfile
import unittest

from stand_in import make_stand_in

SCRIPTS = pathlib.Path(__file__).resolve().parent.parent.parent / "scripts"
NAMES = ("upstream", "test_pcl_source")
COMMAND = """#!/bin/sh
echo "$(basename "$0") $*" >>"$CALLS"
case "$*" in
  *"/default/pcl "*"--target install") mkdir -p "$BUILD/default/prefix" && touch "$BUILD/default/prefix/PCLConfig.cmake" ;;
esac
"""


class Script(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.root = pathlib.Path(directory.name).resolve()
        self.pcl = self.root / "source"
        self.pcl.mkdir()
        (self.pcl / "PCLConfig.cmake.in").touch()

    def run_script(self, name, *arguments, **variables):
        return subprocess.run([SCRIPTS / f"{name}.sh", *arguments], cwd=self.root, capture_output=True, text=True,
                              check=False, env={**os.environ, **variables})


class Commands(Script):
    def setUp(self):
        super().setUp()
        self.calls = self.root / "calls"
        commands = self.root / "commands"
        commands.mkdir()
        for name in ("cmake", "ctest"):
            (commands / name).write_text(COMMAND, encoding="utf-8")
            (commands / name).chmod(0o755)
        self.variables = {"PATH": f"{commands}:{os.environ['PATH']}", "CALLS": str(self.calls), "JOBS": "1",
                          "BUILD": str(self.root / "build")}

    def called(self, name, *arguments, **variables):
        """The calls of CMake and CTest."""
        self.calls.write_text("", encoding="utf-8")
        result = self.run_script(name, *arguments, **self.variables, **variables)
        self.assertEqual(0, result.returncode, result.stderr)
        return self.calls.read_text(encoding="utf-8").splitlines()

    def test_targets_bring_their_tests(self):
        every = self.called("test_pcl_source", "source", "default")
        self.assertIn("-DPCL_NO_PRECOMPILE=ON", self.called("test_pcl_source", "source", "default",
                                                            PCL_OPTIONS="-DPCL_NO_PRECOMPILE=ON")[0])
        some = self.called("test_pcl_source", "source", "default", TARGETS="test_a test_b", TESTS="Point")
        self.assertTrue(every[-2].endswith("--target all"))
        self.assertTrue(every[-1].endswith("-R ."))
        self.assertTrue(some[-2].endswith("--target test_a test_b"))
        self.assertTrue(some[-1].endswith("-R Point -L ^(test_a|test_b)$"))

    def test_an_old_installation_is_not_found(self):
        self.called("test_pcl_source", "source", "default")
        old = self.root / "build" / "default" / "prefix" / "old"
        old.touch()
        self.called("test_pcl_source", "source", "default")
        self.assertFalse(old.exists())

    def test_pull_requests_with_and_without_the_tests_of_pcl(self):
        make_stand_in(self.pcl)
        all_tests = self.called("upstream", "source", "3")
        self.assertTrue(all_tests[1].endswith(
            "--target test_neighborhood_sweep test_inad_estimation pcl_inad_estimation pcl_features pcl_segmentation "
            "test/features/all test/segmentation/all"), all_tests[1])
        self.assertEqual(["features", "segmentation"],
                         [call.split(" --parallel")[0].rsplit("/", 1)[1] for call in all_tests[2:]])
        own = self.called("upstream", "source", "3", PCL_TESTS="OFF")
        self.assertTrue(own[1].endswith("--target test_neighborhood_sweep test_inad_estimation pcl_inad_estimation"))
        self.assertTrue(own[2].endswith("-R ^(neighborhood_sweep|inad_estimation)$"))
        self.assertEqual(3, len(own))


class Refusals(Script):
    def refusal(self, name, *arguments, build="build"):
        """What the script says before it has done anything."""
        result = self.run_script(name, *arguments, BUILD=build)
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
