#!/usr/bin/env python3
"""Meshes a square under a size field with trimalla and with Gmsh: seconds, triangles, smallest angle, sizes.

Usage: against_gmsh.py PROGRAM [LENGTH GROWTH]

Needs `pip install gmsh`. The edges are LENGTH long at the left side of the unit square, and grow by GROWTH times the
distance from it. Gmsh takes the length for that of a typical edge, trimalla for that of the largest triangle: its
second row asks for the number of triangles that Gmsh made. Then the same number of triangles of one size. The sizes are
those of equilateral triangles with the same area, over what the field asks at the middle of the triangle; the growth
is that from a triangle to its neighbours over the distance of their middles, the 99th percentile.
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import time

SQUARE = "4 2 0 0\n0 0 0\n1 1 0\n2 1 1\n3 0 1\n4 1\n0 0 1 1\n1 1 2 1\n2 2 3 1\n3 3 0 4\n0\n"


def measure(points, triangles, field):
    """The smallest angle in degrees, sizes over the field (5th percentile, median, 95th), growth."""
    least, ratios, sides, middles, sizes = 180.0, [], {}, [], []
    slopes = []
    for number, corners in enumerate(triangles):
        (ax, ay), (bx, by), (cx, cy) = (points[v] for v in corners)
        squares = [(bx - cx) ** 2 + (by - cy) ** 2, (cx - ax) ** 2 + (cy - ay) ** 2, (ax - bx) ** 2 + (ay - by) ** 2]
        area = abs((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)) / 2
        squares.sort()
        least = min(least, math.degrees(math.asin(min(1.0, 2 * area / math.sqrt(squares[1] * squares[2])))))
        size, middle = math.sqrt(area * 4 / math.sqrt(3)), ((ax + bx + cx) / 3, (ay + by + cy) / 3)
        ratios.append(size / field(*middle))
        for i in range(3):
            side = tuple(sorted((corners[i], corners[(i + 1) % 3])))
            other = sides.pop(side, None)
            if other is None:
                sides[side] = number
            else:
                distance = math.dist(middle, middles[other])
                slopes.append(abs(size - sizes[other]) / distance)
        middles.append(middle)
        sizes.append(size)
    ratios.sort()
    slopes.sort()
    spread = [ratios[int(part * (len(ratios) - 1))] for part in (0.05, 0.5, 0.95)]
    return least, spread, slopes[int(0.99 * (len(slopes) - 1))]


def row(name, seconds, points, triangles, field):
    least, spread, growth = measure(points, triangles, field)
    spread = " / ".join(f"{part:.2f}" for part in spread)
    print(f"| {name} | {seconds:.2f} | {len(triangles)} | {least:.2f}° | {spread} | {growth:.2f} |", flush=True)


def by_gmsh(length, growth, field):
    import gmsh

    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.model.occ.addRectangle(0, 0, 0, 1, 1)
    gmsh.model.occ.synchronize()
    tag = gmsh.model.mesh.field.add("MathEval")
    gmsh.model.mesh.field.setString(tag, "F", f"{length!r}+{growth!r}*x")
    gmsh.model.mesh.field.setAsBackgroundMesh(tag)
    for option in ("MeshSizeExtendFromBoundary", "MeshSizeFromPoints", "MeshSizeFromCurvature"):
        gmsh.option.setNumber(f"Mesh.{option}", 0)
    start = time.perf_counter()
    gmsh.model.mesh.generate(2)
    seconds = time.perf_counter() - start
    tags, coordinates, _ = gmsh.model.mesh.getNodes()
    points = {int(t): (coordinates[3 * i], coordinates[3 * i + 1]) for i, t in enumerate(tags)}
    _, corners = gmsh.model.mesh.getElementsByType(2)
    triangles = [tuple(int(v) for v in corners[i:i + 3]) for i in range(0, len(corners), 3)]
    row(f"Gmsh {gmsh.__version__}", seconds, points, triangles, field)
    gmsh.finalize()
    return len(triangles)


def by_trimalla(program, folder, name, options, field):
    command = [program, "mesh", str(folder / "square.poly"), *options, "--json", "-o", str(folder / "out.ele")]
    made = json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)
    # Without writing the mesh, as Gmsh is timed.
    seconds = []
    for _ in range(3):
        again = subprocess.run(command[:-2], capture_output=True, text=True, check=True)
        seconds.append(json.loads(again.stdout)["seconds"])
    lines = [line.split() for line in (folder / "out.node").read_text().splitlines()[1:]]
    points = {int(line[0]): (float(line[1]), float(line[2])) for line in lines}
    lines = [line.split() for line in (folder / "out.ele").read_text().splitlines()[1:]]
    triangles = [tuple(int(v) for v in line[1:4]) for line in lines]
    row(name, min(seconds), points, triangles, field)
    return made["triangles"]


def main():
    program = sys.argv[1]
    length, growth = (float(text) for text in sys.argv[2:4]) if len(sys.argv) > 3 else (0.0008, 0.002)

    def field(x, _):
        return length + growth * x

    print("| mesh | seconds | triangles | smallest angle | size over the field: 5 %, median, 95 % | growth |")
    print("|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        (folder / "square.poly").write_text(SQUARE)
        count = by_gmsh(length, growth, field)
        near = ["--grow", repr(1 + growth), "--size-near"]
        made = by_trimalla(program, folder, "trimalla, the same lengths", [*near, f"4={length!r}"], field)
        longer = length * math.sqrt(made / count)
        scaled = ["--grow", repr(1 + growth * math.sqrt(made / count)), "--size-near", f"4={longer!r}"]
        made = by_trimalla(program, folder, "trimalla, as many triangles", scaled, field)
        for name, fill in (("one size, by the loop", "none"), ("one size, with a lattice", "lattice")):
            mean = 0.6 if fill == "none" else 0.85
            area = 1 / (made * mean)
            edge = math.sqrt(area * 4 / math.sqrt(3))
            typical = math.sqrt(4 / math.sqrt(3) / made)
            options = ["--size", repr(edge), "--fill", fill]
            by_trimalla(program, folder, f"trimalla, {name}", options, lambda _x, _y: typical)


if __name__ == "__main__":
    main()
