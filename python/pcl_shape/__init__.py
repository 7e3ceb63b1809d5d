"""Edges, surfaces, objects, grasps, labels and ground of point clouds.

Arrays in, arrays out: points are float32 or float64 of shape (n, 3), in meters, in any
memory layout. float64 with large coordinates, as of maps, is brought within the reach of
float32 by an offset that is subtracted in float64. Results are float32 and the same as
those of the C++ library, bit for bit. Bad input raises ValueError that says what is wrong
and what is expected. Python's lock is released while the library computes, and Ctrl-C
ends it.

    import pcl_shape
    field = pcl_shape.detect(points)
    print(field.edges.sum(), "points are on edges")
"""
from ._pcl_shape import (CreaseLine, Grasp, Instance, Instances, NeighborhoodSweep, ShapeField, ShapeModel,
                         __version__, detect, grasps, ground, inad, instances, labels, normals)

__all__ = ["CreaseLine", "Grasp", "Instance", "Instances", "NeighborhoodSweep", "ShapeField", "ShapeModel",
           "__version__", "detect", "grasps", "ground", "inad", "instances", "labels", "normals"]
