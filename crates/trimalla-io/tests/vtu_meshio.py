"""Reads .vtu files with meshio and compares them, bit for bit, with the .node, .ele and .poly files beside them.

Run by hand after `cargo test -p trimalla-io --test one_file`:
    pip install meshio && python crates/trimalla-io/tests/vtu_meshio.py target/tmp/vtu-meshio
"""

import pathlib
import sys

import meshio
import numpy as np


def rows(path):
    lines = [line.split() for line in path.read_text().splitlines()]
    return iter([list(map(float, line)) for line in lines if line])


def take(source, count):
    return np.array([next(source)[1:] for _ in range(int(count))])


def same_bits(a, b):
    a, b = np.ascontiguousarray(a, float), np.ascontiguousarray(b, float)
    return a.shape == b.shape and np.array_equal(a.view(np.uint64), b.view(np.uint64))


def check(path):
    mesh = meshio.read(path)
    source = rows(path.with_suffix(".node"))
    count, _, width, has_markers = map(int, next(source))
    node = take(source, count)
    source = rows(path.with_suffix(".ele"))
    triangles, _, attributes = map(int, next(source))
    ele = take(source, triangles)
    source = rows(path.with_suffix(".poly"))
    next(source)
    segments, segment_markers = map(int, next(source))
    poly = take(source, segments)

    assert same_bits(mesh.points[:, :2], node[:, :2])
    assert same_bits(mesh.points[:, 2], node[:, 2] if width else np.zeros(count))
    assert [block.type for block in mesh.cells] == ["triangle", "line"]
    assert np.array_equal(mesh.cells[0].data, ele[:, :3]) and np.array_equal(mesh.cells[1].data, poly[:, :2])
    assert np.array_equal(mesh.point_data["marker"], node[:, 2 + width] if has_markers else np.zeros(count))
    for i in range(width):
        assert same_bits(mesh.point_data[f"attribute{i}"], node[:, 2 + i])
    region, angle, marker = (mesh.cell_data[name] for name in ("region", "min_angle", "marker"))
    assert same_bits(region[0], ele[:, 3] if attributes else np.zeros(triangles)) and (region[1] == -1).all()
    assert ((0 <= angle[0]) & (angle[0] <= 60)).all() and (angle[1] == -1).all()
    assert not marker[0].any() and np.array_equal(marker[1], poly[:, 2] if segment_markers else np.zeros(segments))
    print(f"{path}: {count} points, {triangles} triangles, {segments} lines, all equal")


files = sorted(pathlib.Path(sys.argv[1]).glob("*.vtu"))
assert files, "no .vtu files"
for file in files:
    check(file)
