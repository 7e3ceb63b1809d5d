# SPDX-License-Identifier: BSD-3-Clause
# SPDX-FileCopyrightText: 2026 pcl_shape contributors
"""The rim of a suction cup, for the scripts that draw grasps."""
import numpy


def rim(grasp, radius):
    """Points of the cup's rim, once around."""
    axis = numpy.array(grasp["approach"])
    u = numpy.cross(axis, [1.0, 0.0, 0.0] if abs(axis[0]) < 0.5 else [0.0, 1.0, 0.0])
    u /= numpy.linalg.norm(u)
    turn = numpy.linspace(0.0, 2.0 * numpy.pi, 60)[:, None]
    return numpy.array(grasp["position"]) + radius * (numpy.cos(turn) * u + numpy.sin(turn) * numpy.cross(axis, u))
