# SPDX-License-Identifier: BSD-3-Clause
# SPDX-FileCopyrightText: 2026 pcl_shape contributors
"""A landscape, a room, a street and a sheet of any number of points, in several files.

For scripts/measure/measure_tiles.py. But for the landscape's, some points are not finite, some equal, some far away.
"""
import math

import numpy

FILES_HEADER = ("VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH {0}\n"
                "HEIGHT 1\nVIEWPOINT 3 2 1.5 1 0 0 0\nPOINTS {0}\nDATA binary\n")


class Surfaces:
    """Rectangles and upright cylinders, sampled evenly."""

    def __init__(self, points, seed):
        self.points, self.random, self.patches = points, numpy.random.default_rng(seed), []

    def rectangle(self, corner, u, v):
        u, v = numpy.array(u, float), numpy.array(v, float)
        normal = numpy.cross(u, v)
        area = numpy.linalg.norm(normal)

        def sample(s, t, off):
            return corner + s * u + t * v + off * normal / area
        self.patches.append((area, sample))

    def cylinder(self, foot, radius, height):
        def sample(s, t, off):
            turn = 2.0 * numpy.pi * s
            return numpy.hstack([foot[0] + (radius + off) * numpy.cos(turn),
                                 foot[1] + (radius + off) * numpy.sin(turn),
                                 foot[2] + height * t])
        self.patches.append((2.0 * numpy.pi * radius * height, sample))

    def box(self, low, size):
        """Without a bottom."""
        (x, y, z), (a, b, c) = low, size
        self.rectangle((x, y, z + c), (a, 0, 0), (0, b, 0))
        for off in (0, b):
            self.rectangle((x, y + off, z), (a, 0, 0), (0, 0, c))
        for off in (0, a):
            self.rectangle((x + off, y, z), (0, b, 0), (0, 0, c))

    def sample(self, noise):
        """Points; noise is a share of the distance between them."""
        area = sum(area for area, _ in self.patches)
        sigma = noise * (area / self.points) ** 0.5
        parts = []
        for own, sample in self.patches:
            count = round(self.points * own / area)
            s, t = self.random.random((2, count, 1))
            parts.append(sample(s, t, sigma * self.random.standard_normal((count, 1))))
        return numpy.vstack(parts)


def room(points):
    """6 x 5 x 2.5 m with a table and a pillar."""
    surfaces = Surfaces(points, 7)
    for z in (0, 2.5):
        surfaces.rectangle((0, 0, z), (6, 0, 0), (0, 5, 0))
    for y in (0, 5):
        surfaces.rectangle((0, y, 0), (6, 0, 0), (0, 0, 2.5))
    for x in (0, 6):
        surfaces.rectangle((x, 0, 0), (0, 5, 0), (0, 0, 2.5))
    surfaces.box((2, 2, 0), (1.5, 0.9, 0.7))
    surfaces.cylinder((4.8, 3.5, 0), 0.3, 2.5)
    return surfaces.sample(0.1)


def street(points):
    """60 m of a road with curbs, walls, poles and a car, denser near its middle."""
    surfaces = Surfaces(1.38 * points, 8)
    surfaces.rectangle((0, -3, 0), (60, 0, 0), (0, 6, 0))
    for curb, walk in ((3, 3), (-3, -5)):
        surfaces.rectangle((0, curb, 0), (60, 0, 0), (0, 0, 0.15))
        surfaces.rectangle((0, walk, 0.15), (60, 0, 0), (0, 2, 0))
    surfaces.rectangle((0, 5, 0.15), (60, 0, 0), (0, 0, 6))
    surfaces.rectangle((0, -5, 0.15), (40, 0, 0), (0, 0, 6))
    for x in range(5, 60, 12):
        surfaces.cylinder((x, 4, 0.15), 0.15, 4)
    surfaces.box((20, -2.5, 0), (4, 1.8, 1.4))
    cloud = surfaces.sample(0.05)
    kept = surfaces.random.random(len(cloud)) < 1.0 / (1.0 + 0.02 * abs(cloud[:, 0] - 30.0))
    return cloud[kept]


def sheet(points):
    """20 x 20 m with waves, without noise and without an edge."""
    random = numpy.random.default_rng(9)
    x, y = random.uniform(-10.0, 10.0, (2, points))
    return numpy.column_stack([x, y, 0.5 * numpy.sin(0.8 * x) * numpy.cos(0.6 * y)])


SCENES = {"room": room, "street": street, "sheet": sheet}


def with_trouble(cloud):
    """One point in 50 is that of another, one in 200 not finite, and nine are far away."""
    random = numpy.random.default_rng(10)
    size = len(cloud)
    cloud[random.integers(size, size=size // 50)] = cloud[random.integers(size, size=size // 50)]
    cloud[random.integers(size, size=size // 200), random.integers(3, size=size // 200)] = numpy.nan
    far = random.uniform((-50, -60, -30), (90, 60, 40), (8, 3))
    cloud[random.integers(size, size=8)] = far
    cloud[random.integers(size, size=2), 1:] = ((numpy.inf, 2.0), (2.0, 1e9))
    return cloud


def write(name, directory, points, files):
    """Files that overlap, each in an order without a system. Returns the scene's longest edge."""
    directory.mkdir()
    cloud = SCENES[name](points)
    edge = numpy.ptp(cloud, axis=0).max()
    cloud = with_trouble(cloud).astype("<f4")
    random = numpy.random.default_rng(11)
    # By place along x, give or take a fifth of the scene.
    along = numpy.nan_to_num(cloud[:, 0]) + random.uniform(-0.1, 0.1, len(cloud)) * edge
    for number, part in enumerate(numpy.array_split(numpy.argsort(along), files)):
        random.shuffle(part)
        (directory / f"{name}_{number}.pcd").write_bytes(
            FILES_HEADER.format(len(part)).encode() + cloud[part].tobytes())
    return edge


def hash_of(a, b, c):
    """Random bits of a place: steps of SplitMix64."""
    bits = numpy.zeros(1, numpy.uint64)
    for word in (a, b, c):
        bits = bits + numpy.asarray(word, numpy.uint64) + numpy.uint64(0x9e3779b97f4a7c15)
        for shift, factor in ((30, 0xbf58476d1ce4e5b9), (27, 0x94d049bb133111eb)):
            bits = (bits ^ bits >> numpy.uint64(shift)) * numpy.uint64(factor)
        bits ^= bits >> numpy.uint64(31)
    return bits


def share_of(bits, part):
    """0 to 1, some bits of a hash."""
    return (bits >> numpy.uint64(16 * part) & numpy.uint64(0xffff)) / 65536.0


def ground(x, y):
    return 9.0 * numpy.sin(0.011 * x) * numpy.cos(0.007 * y) + 2.0 * numpy.sin(0.05 * x + 0.03 * y)


def on_surfaces(x, y, share):
    """Places on the ground, a roof or a wall: a wall takes the points of a strip of the ground beside it."""
    lot, eaves, rise, beside = 24.0, 5.0, 3.0, 1.5  # meters
    lots = numpy.floor(x / lot), numpy.floor(y / lot)
    bits = hash_of(*lots, 7)
    half_x, half_y = 4.0 + 3.0 * share_of(bits, 1), 3.0 + 3.0 * share_of(bits, 2)
    middle_x, middle_y = ((of + 0.5) * lot for of in lots)
    off_x, off_y = x - middle_x, y - middle_y
    base = ground(middle_x, middle_y)
    out_x, out_y = abs(off_x) - half_x, abs(off_y) - half_y
    out = numpy.maximum(out_x, out_y)
    is_ground = (share_of(bits, 0) > 0.6) | (out > beside)  # gardens
    is_wall = ~is_ground & (out > 0.0)
    wall_x = numpy.where(out_x > out_y, numpy.copysign(half_x, off_x), numpy.clip(off_x, -half_x, half_x))
    wall_y = numpy.where(out_x > out_y, numpy.clip(off_y, -half_y, half_y), numpy.copysign(half_y, off_y))
    above = numpy.where(is_wall, eaves * share, eaves + rise * (1.0 - abs(off_y) / half_y))
    return numpy.stack([numpy.where(is_wall, middle_x + wall_x, x), numpy.where(is_wall, middle_y + wall_y, y),
                        numpy.where(is_ground, ground(x, y), base + above)], axis=-1)


def write_landscape(directory, points, files):
    """Hills with houses, 16 points a square meter, in strips; a block of rows at a time. Returns its edge."""
    spacing, noise, block = 0.25, 0.02, 1 << 18
    edge = math.floor(math.sqrt(points) + 0.5)
    directory.mkdir()
    for number in range(files):
        columns = numpy.arange(number * edge // files, (number + 1) * edge // files, dtype=numpy.uint64)
        step = max(1, block // len(columns))
        with open(directory / f"strip_{number:03}.pcd", "wb") as file:
            file.write(FILES_HEADER.format(len(columns) * edge).encode())
            for first in range(0, edge, step):
                rows = numpy.arange(first, min(first + step, edge), dtype=numpy.uint64)[:, None]
                bits, more = hash_of(columns, rows, 1), hash_of(columns, rows, 2)
                places = on_surfaces((columns + share_of(bits, 0)) * spacing, (rows + share_of(bits, 1)) * spacing,
                                     share_of(bits, 2))
                # Three uniform values have the standard deviation of one half.
                places[..., 2] += 2.0 * noise * (sum(share_of(more, part) for part in range(3)) - 1.5)
                file.write(places.astype("<f4").tobytes())
    return edge * spacing
