"""Read PCD files without PCL: the values of each field as bytes. Used by other scripts."""
import re
import struct

CODES = {("F", 4): "f", ("F", 8): "d", ("U", 1): "B", ("U", 2): "H", ("U", 4): "I", ("U", 8): "Q",
         ("I", 1): "b", ("I", 2): "h", ("I", 4): "i", ("I", 8): "q"}


def unpacked(data, size):
    """LZF decompression."""
    out = bytearray()
    i = 0
    while i < len(data):
        control = data[i]
        i += 1
        if control < 32:
            out += data[i:i + control + 1]
            i += control + 1
            continue
        length = control >> 5
        if length == 7:
            length += data[i]
            i += 1
        start = len(out) - ((control & 31) << 8) - data[i] - 1
        i += 1
        for at in range(start, start + length + 2):
            out.append(out[at])
    if len(out) != size:
        raise ValueError(f"{len(out)} bytes instead of {size}")
    return bytes(out)


def read_pcd(path):
    """The header's lines but DATA, and the bytes of each field's values."""
    header, data, rest = re.match(rb"(.*?)^DATA (\w+)\n(.*)", path.read_bytes(), re.S | re.M).groups()
    lines = dict(line.split(" ", 1) for line in header.decode().splitlines() if not line.startswith("#"))
    names, types = lines["FIELDS"].split(), lines["TYPE"].split()
    sizes, counts = ([int(n) for n in lines[key].split()] for key in ("SIZE", "COUNT"))
    points = int(lines["POINTS"])
    if data == b"ascii":
        rows = [line.split() for line in rest.decode().splitlines()]
    elif data == b"binary_compressed":
        packed, size = struct.unpack_from("<II", rest)
        rest = unpacked(rest[8:8 + packed], size)
    stride = sum(size * count for size, count in zip(sizes, counts))
    columns = {}
    cells = first = 0  # of the field, in a row
    for name, kind, size, count in zip(names, types, sizes, counts):
        width = size * count
        if data == b"ascii":
            values = [(float if kind == "F" else int)(cell) for row in rows for cell in row[cells:cells + count]]
            columns[name] = struct.pack(f"<{len(values)}{CODES[kind, size]}", *values)
        elif data == b"binary":
            columns[name] = b"".join(rest[i + first:i + first + width] for i in range(0, points * stride, stride))
        else:  # field after field
            columns[name] = rest[first * points:(first + width) * points]
        cells += count
        first += width
    return lines, columns


def pcd_difference(old, new, names):
    """What differs between two point clouds, or None; names are OLD's fields that NEW calls otherwise."""
    if old.read_bytes() == new.read_bytes():
        return None
    (old_lines, old_columns), (new_lines, new_columns) = read_pcd(old), read_pcd(new)
    old_lines["FIELDS"] = " ".join(names.get(name, name) for name in old_lines["FIELDS"].split())
    if old_lines != new_lines:
        return f"header {old_lines} | {new_lines}"
    points = int(old_lines["POINTS"])
    for name, values in old_columns.items():
        others = new_columns[names.get(name, name)]
        if values != others:
            width = len(values) // points
            different = [i for i in range(points) if values[i * width:][:width] != others[i * width:][:width]]
            return f"field {name}: {len(different)} of {points} points, the first {different[0]}"
    return None
