# SPDX-License-Identifier: BSD-3-Clause
# SPDX-FileCopyrightText: 2026 pcl_shape contributors
"""The pull requests to PCL, one after the other, and the files of each."""
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
HEADERS, SEGMENTATION = "include/pcl/features/", "include/pcl/segmentation/"


def named(pattern, *names):
    return [pattern.format(name) for name in names]


# Titles, and patterns of files. A file belongs to the first pull request that names it.
SERIES = [
    ("`NeighborhoodSweep`, without SIMD", [
        *named(HEADERS + "{}.h", "neighborhood_sweep", "sweep_index", "xyz_view", "cancellation"),
        "src/common/*", "src/sweep/*.*", "src/sweep/index/*", "src/sweep/portable/*", "test/sweep/*",
        *named("test/support/{}.*", "bits", "differences", "errors", "heap_count", "kernel_targets", "random",
               "reference", "shapes", "sweep"),
        "test/features/test_cancellation.cpp"]),
    ("its SIMD kernels, with Highway if it is found", ["src/sweep/simd/*"]),
    ("`INAD` and `INADEstimation`", [
        *named(HEADERS + "{}", "adaptive_radius.h", "cloud_numbers.h", "inad.h", "inad_parameters.h", "inad_point.h",
               "impl/inad.hpp", "impl/neighborhoods.hpp"),
        *named("src/features/{}.*", "inad", "neighborhoods", "listed_neighborhoods", "spacing/local_spacing",
               "spacing/some_points"),
        "tools/upstream/extended_cloud.h", "tools/upstream/inad_estimation.cpp", "test/support/clouds.h",
        *named("test/features/test_{}.cpp", "inad", "listed_neighborhoods"),
        "doc/tutorials/content/inad_estimation.rst"]),
    ("`NormalEstimationSweep`", [
        HEADERS + "normal_3d_sweep.h", HEADERS + "impl/normal_3d_sweep.hpp", "src/features/normal_3d_sweep.cpp",
        "test/support/counting_search.h",
        *named("test/features/test_{}.cpp", "normal_3d_sweep", "search_methods", "point_types", "feature_errors"),
        "doc/tutorials/content/normal_estimation_sweep.rst"]),
    ("`ShapeHistogram` and `ShapeModel`", [
        HEADERS + "shape_*.h", "src/features/models/shape_*", "src/features/models/default_models*", "models/*",
        "test/support/temporary_directory.h", "test/features/test_shape_*",
        "doc/tutorials/content/shape_model.rst"]),
    ("`ShapeFieldEstimation`, `ShapeEdgeDetection`, `ShapeBackProjection`", [
        HEADERS + "*", "src/features/**/*", "src/geometry/*", "src/edges/*", "src/surfaces/*",
        *named(SEGMENTATION + "*{}*", "shape_field", "shape_detection", "shape_edge_detection",
               "shape_back_projection", "unknown_points", "cloud_reach", "faces_of_parts",
               "known_parts", "means_of_parts"),
        *named(SEGMENTATION + "impl/{}*", "shape_field", "shape_detection", "shape_edge", "shape_back"),
        *named("src/segmentation/{}*", "cloud_reach", "compiled_estimations", "faces_of_parts",
               "field_of_points", "field_places", "field_stages", "known_parts", "means_of_parts", "shape_detection",
               "shape_field", "uneven_field", "unknown_points", "resolution_zones", "zoned_field"),
        "tools/scene/**/*", "test/features/*", "test/geometry/*", "test/edges/*",
        *named("test/segmentation/{}*", "bumpy_plane", "detect", "field_of", "measured_numbers", "test_adaptive",
               "test_coincident", "test_detection", "test_generated", "test_known", "test_own", "test_paper",
               "test_shape_detection", "test_uneven", "test_unknown"),
        *named("doc/tutorials/content/{}.rst", "shape_edge_detection", "shape_back_projection")]),
    ("`ShapeInstanceSegmentation`", [
        "src/instances/**/*", SEGMENTATION + "*instance*", SEGMENTATION + "impl/*instance*", "src/segmentation/*instance*",
        "test/surfaces/*", "test/instances/*", "test/segmentation/test_parts_of_clouds.cpp",
        "test/segmentation/test_resolution_zones.cpp",
        "tools/upstream/shape_instance_segmentation.cpp", "doc/tutorials/content/shape_instances.rst"]),
]


def files_of_series():
    """Titles and files, from the root of the repository, of each pull request."""
    taken, series = set(), []
    for title, patterns in SERIES:
        files = []
        for pattern in patterns:
            found = [path for path in sorted(ROOT.glob(pattern)) if path.is_file()]
            if not found:
                sys.exit(f"{pattern}: no such file; expected those of the pull request {title}")
            files += [path for path in found if path not in taken and path.name != "CMakeLists.txt"]
            taken.update(found)
        series.append((title, [path.relative_to(ROOT).as_posix() for path in files]))
    return series
