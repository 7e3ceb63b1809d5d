# SPDX-License-Identifier: BSD-3-Clause
# SPDX-FileCopyrightText: 2026 pcl_shape contributors
"""The changes in PCL's CMake lists."""
import pathlib
import re
import textwrap

from upstream.places import SHAPE

NANOFLANN = re.compile(r"find_package\(nanoflann .*?endif\(\)\n", re.S)
OPTIONAL = """
# nlohmann_json (optional: reads the models of surfaces)
find_package(nlohmann_json 3.11 QUIET)
if(TARGET nlohmann_json::nlohmann_json)
  message(STATUS "Found nlohmann_json")
else()
  message(STATUS "nlohmann_json was not found, so pcl::ShapeModel and what needs it will not be available.")
endif()
"""
HIGHWAY = """# Google Highway (optional): without it the portable kernels do all
option(WITH_HIGHWAY "Vector kernels for NeighborhoodSweep, if Google Highway is found" TRUE)
if(WITH_HIGHWAY)
  find_path(HIGHWAY_INCLUDE_DIR hwy/highway.h)
  find_library(HIGHWAY_LIBRARY hwy)
  mark_as_advanced(HIGHWAY_INCLUDE_DIR HIGHWAY_LIBRARY)
endif()
if(WITH_HIGHWAY AND HIGHWAY_INCLUDE_DIR AND HIGHWAY_LIBRARY)
  list(APPEND {shape}_srcs
{files}
  )
endif()

"""
# Each file has names of its own in an unnamed namespace.
PROPERTIES = """list(APPEND srcs ${{{shape}_srcs}})
set_source_files_properties(${{{shape}_srcs}} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)

"""
UNFUSED = """if(NOT MSVC)
  # What counts as a neighbor must not depend on fused operations.
  set_source_files_properties({files}
    PROPERTIES COMPILE_OPTIONS "-ffp-contract=off")
endif()

"""
COUNTING = """if(NOT MSVC)
  # What counts as a point of a primitive must not depend on fused operations. Square roots that
  # set no errno are vectorized.
  set_source_files_properties({files}
    PROPERTIES COMPILE_OPTIONS "-ffp-contract=off;-fno-math-errno")
endif()
"""
HIGHWAY_TARGET = """if(WITH_HIGHWAY AND HIGHWAY_INCLUDE_DIR AND HIGHWAY_LIBRARY)
  target_compile_definitions("${LIB_NAME}" PRIVATE PCL_HAS_HIGHWAY)
  target_include_directories("${LIB_NAME}" SYSTEM PRIVATE ${HIGHWAY_INCLUDE_DIR})
  target_link_libraries("${LIB_NAME}" ${HIGHWAY_LIBRARY})
endif()
"""
TEST = """
PCL_ADD_TEST({name} test_{name}
             FILES {files}
                   "${{GTEST_SRC_DIR}}/src/gtest_main.cc"
             LINK_WITH {libraries})
target_include_directories(test_{name} PRIVATE {folders})
set_target_properties(test_{name} PROPERTIES UNITY_BUILD OFF)
if(NOT MSVC)
  target_compile_options(test_{name} PRIVATE -ffp-contract=off)
endif()
"""
MODEL_FILES = """  # The default models are part of the library: nothing to find at run time.
  foreach(model edges surfaces)
    set(model_file ${{CMAKE_CURRENT_SOURCE_DIR}}/src/{shape}/models/${{model}}.json)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${{model_file}})
    file(READ ${{model_file}} PCL_SHAPE_MODEL_${{model}})
  endforeach()
  configure_file(src/{shape}/features/models/default_models.cpp.in default_models.cpp @ONLY)
  list(APPEND {shape}_srcs "${{CMAKE_CURRENT_BINARY_DIR}}/default_models.cpp")
"""
IF_JSON, END_IF = "if(TARGET nlohmann_json::nlohmann_json)\n", "endif()\n\n"


class BuildFile:
    """A CMake list in PCL's tree."""

    def __init__(self, path):
        self.path = pathlib.Path(path)
        self.text = self.path.read_text(encoding="utf-8")

    def replace(self, old, new):
        """Replace what is there exactly once."""
        if self.text.count(old) != 1:
            raise ValueError(f"{self.path}: expected once, found {self.text.count(old)} times: {old!r}")
        self.text = self.text.replace(old, new)

    def insert_before(self, mark, what):
        self.replace(mark, what + mark)

    def insert_after(self, mark, what):
        self.replace(mark, mark + what)

    def extend_list(self, name, files):
        """Add to what set(name ...) holds."""
        begin = self.text.index(f"set({name}\n")
        end = self.text.index("\n)\n", begin)
        self.text = self.text[:end] + "".join(f"\n  {file}" for file in files) + self.text[end:]

    def write(self):
        self.path.write_text(self.text, encoding="utf-8")


def lines_of(files, indent):
    return ("\n" + " " * indent).join(files)


def set_of(name, files):
    return f"set({name}\n  {lines_of(files, 2)}\n)\n\n"


def appended(files, name):
    return f"  list(APPEND {name}\n    {lines_of(files, 4)}\n  )\n" if files else ""


class Module:
    """The files of one module of PCL, from its folder: those that need JSON apart."""

    def __init__(self, name, places, json_places):
        self.name = name
        self.plain, self.json = (self.sorted_out(which) for which in (places, json_places))

    def sorted_out(self, places):
        own = [place[len(self.name) + 1:] for place in places if place.startswith(self.name + "/")]
        named = [place.replace(f"/{self.name}/", "/${SUBSYS_NAME}/", 1) for place in own]
        headers = [f'"{place}"' for place in named if place.startswith("include/")]
        return {"incs": [place for place in headers if "/impl/" not in place],
                "impl_incs": [place for place in headers if "/impl/" in place],
                "srcs": [place for place in own if place.endswith(".cpp") and "/simd/" not in place],
                "simd": [place for place in own if place.endswith(".cpp") and "/simd/" in place]}

    def lists(self, models):
        """CMake of the lists that are appended to, before the library."""
        text = set_of(f"{SHAPE}_srcs", self.plain["srcs"]) if self.plain["srcs"] else ""
        if self.plain["simd"]:
            text += HIGHWAY.format(shape=SHAPE, files="\n".join("    " + file for file in self.plain["simd"]))
        if any(self.json.values()):
            text += IF_JSON
            text += "".join(appended(self.json[kind], kind) for kind in ("incs", "impl_incs"))
            text += appended(self.json["srcs"], f"{SHAPE}_srcs")
            text += MODEL_FILES.format(shape=SHAPE) if models else ""
            text += "" if self.plain["srcs"] else textwrap.indent(PROPERTIES.format(shape=SHAPE).rstrip(), "  ") + "\n"
            counting = [file for file in self.json["srcs"] if "counting_models" in file]
            text += textwrap.indent(COUNTING.format(files=lines_of(counting, 4)), "  ") if counting else ""
            text += END_IF
        if not self.plain["srcs"]:
            return text
        unfused = [file for file in self.plain["srcs"] + self.plain["simd"]
                   if "/sweep/" in file or "listed_neighborhoods" in file]
        text += PROPERTIES.format(shape=SHAPE)
        return text + (UNFUSED.format(files=lines_of(unfused, 4)) if unfused else "")


def extend_module(tree, module, folders, models=False):
    build = BuildFile(tree / module.name / "CMakeLists.txt")
    for kind in ("incs", "impl_incs"):
        build.extend_list(kind, module.plain[kind])
    build.insert_before('set(LIB_NAME "pcl_${SUBSYS_NAME}")\n', module.lists(models))
    target = f'target_include_directories("${{LIB_NAME}}" PRIVATE {" ".join(folders)})\n'
    target += HIGHWAY_TARGET if module.plain["simd"] else ""
    if models:
        target += f'{IF_JSON}  target_link_libraries("${{LIB_NAME}}" nlohmann_json::nlohmann_json)\nendif()\n'
    build.insert_before("PCL_MAKE_PKGCONFIG(${LIB_NAME} COMPONENT ${SUBSYS_NAME}", target)
    build.write()


def add_tests(tree, module, tests, before=""):
    """tests: dictionaries for TEST, with `json` for those that need it."""
    build = BuildFile(tree / "test" / module / "CMakeLists.txt")
    build.text = build.text.rstrip("\n") + "\n"
    build.text += before
    for test in tests:
        text = TEST.format(name=test["name"], files=lines_of(test["files"], 19), libraries=test["libraries"],
                           folders=" ".join(test["folders"]))
        if test["json"]:
            text = f"\n{IF_JSON}{textwrap.indent(text.strip(), '  ')}\nendif()\n"
        build.text += text
    build.write()


def find_json(tree):
    build = BuildFile(tree / "CMakeLists.txt")
    build.insert_after(NANOFLANN.search(build.text)[0], OPTIONAL)
    build.write()


def add_tool(tree, name, neighbor, libraries, json):
    """A command-line tool, behind one that is there: `neighbor` is how that one is linked."""
    build = BuildFile(tree / "tools" / "CMakeLists.txt")
    text = (f"PCL_ADD_EXECUTABLE(pcl_{name} COMPONENT ${{SUBSYS_NAME}} SOURCES {name}.cpp)\n"
            f"target_link_libraries (pcl_{name} pcl_common pcl_io {libraries})\n")
    if json:
        text = f"{IF_JSON}{textwrap.indent(text, '  ')}endif()\n"
    build.insert_after(f"  target_link_libraries ({neighbor})\n", "\n" + textwrap.indent(text, "  "))
    build.write()
