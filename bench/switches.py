#!/usr/bin/env python3
"""Goes through Triangle's switches beside Triangle itself: same files, same numbers, same markers and attributes?

    bench/switches.py                    builds both programs, prints a table; exit 1 where a row differs that should not
    bench/switches.py --trimalla PATH    with a program built before

Triangle is compiled from its Python source package (bench/get_triangle.sh), measured and never shipped. Without
refinement the two are compared item by item: vertices, triangles whose corners lie on no common circle with a
neighbour's, subsegments, markers, attributes. With refinement what can be equal is compared: files, headers, input
vertices and their markers; and the counts of both are shown.
"""

import argparse
import pathlib
import shutil
import subprocess
import sys
import tempfile

BENCH = pathlib.Path(__file__).resolve().parent
BOX = """8 2 0 1
1 0 0 0
2 0 3.1 0
3 3 0.2 0
4 3.3 3 33
5 1.1 1.2 0
6 1 2 0
7 2.2 1 0
8 2 2.1 0
5 1
1 1 2 5
2 5 7 0
3 7 8 0
4 8 6 10
5 6 5 0
1
1 1.5 1.5
1
1 0.5 0.5 7 0.2
"""
# Points on no common circle, numbered from 0, with two attributes and a duplicate.
DOTS = """9 2 2 0
0 0 0 1 2
1 3.1 0.2 2 1
2 3.3 3.9 5 0
3 -0.4 2.9 4 4
4 1.1 1.3 3 1
5 1.9 0.8 2 2
6 0.7 2.3 1 9
7 2.2 2.6 8 8
8 1.1 1.3 3 1
"""
# A drawing whose triangulation is unique: two regions, a T of segments, a crossing.
PLATE = """9 2 1 0
1 0 0 1
2 5 0.3 2
3 5.5 4 3
4 -0.2 3.7 4
5 1.2 0.9 0
6 3.9 1.1 0
7 1.4 2.8 0
8 4.1 2.9 0
9 8 8 5
6 1
1 1 2 2
2 2 3 3
3 3 4 0
4 4 1 4
5 5 8 6
6 6 7 0
0
1
1 0.4 0.4 1.5 0.3
"""
INPUTS = {"box.poly": BOX, "dots.node": DOTS, "plate.poly": PLATE}

# Switches and file; whether the run refines.
EXACT = [
    ("", "dots"), ("-c", "dots"), ("-e", "dots"), ("-n", "dots"), ("-v", "dots"), ("-g", "dots"), ("-j", "dots"),
    ("-B", "dots"), ("-N", "dots"), ("-E", "dots"), ("-I", "dots"), ("-i", "dots"), ("-F", "dots"), ("-l", "dots"),
    ("-X", "dots"), ("-C", "dots"), ("-V", "dots"), ("-z", "dots"), ("-o2", "dots"),
    ("-p", "plate"), ("-pA", "plate"), ("-pe", "plate"), ("-pc", "plate"), ("-pj", "plate"), ("-pB", "plate"),
    ("-pP", "plate"), ("-pI", "plate"), ("-pO", "box"), ("-pc", "box"), ("-pcA", "box"), ("-pco2", "box"),
    ("", "plate.poly"), ("-pS0", "plate"),
]
REFINED = [
    ("-q", "dots"), ("-pq", "plate"), ("-pq30", "plate"), ("-pa0.1", "plate"), ("-pa", "plate"), ("-pqaA", "plate"),
    ("-pqc", "box"), ("-pqD", "plate"), ("-pD", "plate"), ("-ps", "plate"), ("-pqY", "plate"), ("-pqYY", "plate"),
    ("-pqS3", "plate"), ("-pqo2", "plate"), ("-pqej", "plate"), ("-pqI", "plate"),
]
AGAIN = [("-rq25", "x.1"), ("-rpa0.05", "x.1"), ("-rpa", "x.1"), ("-rc", "x.1"), ("-rNEP", "x.1")]


def build():
    subprocess.run(["sh", "get_triangle.sh"], cwd=BENCH, check=True)
    triangle = BENCH / "target" / "triangle_program"
    flags = "-O2 -ffp-contract=off -w -DNO_TIMER -DREAL=double -DVOID=void -DANSI_DECLARATORS".split()
    source = BENCH / "target" / "triangle" / "c" / "triangle.c"
    subprocess.run(["gcc", *flags, str(source), "-lm", "-o", str(triangle)], check=True)
    return triangle


def rows(path):
    lines = (line.split("#")[0].split() for line in path.read_text().splitlines())
    return [[float(word) for word in line] for line in lines if line]


class Result:
    """The files that a run has written, as numbers."""

    def __init__(self, program, switches, name, before):
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            for file, text in before.items():
                (folder / file).write_text(text)
            words = [switches] if switches else []
            run = subprocess.run([*program, *words, name], cwd=folder, capture_output=True, text=True, timeout=60)
            self.status = run.returncode
            written = sorted(file for file in folder.iterdir() if before.get(file.name) != file.read_text())
            self.texts = {file.name: file.read_text() for file in written}
            # An .off file has no row numbers and begins with a word.
            self.files = {file.name: rows(file) for file in written if file.suffix != ".off"}

    def part(self, ending):
        found = [content for name, content in self.files.items() if name.endswith(ending) and ".v." not in name]
        return found[0] if found else None


def triangles(result):
    """Triangles by their corners' numbers, the smallest first, with their attributes."""
    ele = result.part(".ele")
    if ele is None:
        return None
    turned = []
    for row in ele[1:]:
        corners, rest = row[1:4], tuple(row[1 + int(ele[0][1]):])
        start = corners.index(min(corners))
        turned.append((tuple(corners[start:] + corners[:start]), rest))
    return sorted(turned)


def segments(result):
    poly = result.part(".poly")
    if poly is None:
        return None
    count = int(poly[1][0])
    return sorted((tuple(sorted(row[1:3])), tuple(row[3:])) for row in poly[2:2 + count]), poly[2 + count:]


def edges(result):
    edge = result.part(".edge")
    return edge and sorted((tuple(sorted(row[1:3])), tuple(row[3:])) for row in edge[1:])


def close(p, q):
    return all(abs(x - y) < 1e-9 * max(1, abs(x)) for x, y in zip(p, q))


def compare_exactly(one, other):
    """What differs between two results that should be equal."""
    faults = []
    if sorted(one.texts) != sorted(other.texts):
        return [f"files {sorted(one.texts)} and {sorted(other.texts)}"]
    for ending in [".node", ".ele", ".poly", ".edge", ".neigh"]:
        a, b = one.part(ending), other.part(ending)
        if a and b and a[0] != b[0]:
            faults.append(f"header of {ending}: {a[0]} and {b[0]}")
        if a and b and len(a) != len(b):
            faults.append(f"rows of {ending}: {len(a)} and {len(b)}")
    nodes = [result.part(".node") for result in (one, other)]
    if all(nodes):
        # Middles of edges come in the order of edges, which is free.
        columns = [sorted(row[1:] for row in part[1:]) for part in nodes]
        # Where segments cross, both round the place.
        if not all(p == q or close(p, q) for p, q in zip(*columns)):
            faults.append("vertices, attributes or markers")
        if nodes[0][1][0] != nodes[1][1][0]:
            faults.append("first number")
    for what, of in [("triangles", triangles), ("segments", segments), ("edges", edges)]:
        if of(one) != of(other):
            faults.append(what)
    voronoi = [sorted(name for name in result.files if ".v." in name) for result in (one, other)]
    for name in voronoi[0]:
        a, b = one.files[name], other.files[name]
        if a[0] != b[0]:
            faults.append(f"header of {name}")
        if name.endswith(".v.node"):
            pairs = zip(sorted(row[1:] for row in a[1:]), sorted(row[1:] for row in b[1:]))
            if not all(close(p, q) for p, q in pairs):
                faults.append("Voronoi vertices")
        elif sorted(row[2:] for row in a[1:] if len(row) == 5) != sorted(row[2:] for row in b[1:] if len(row) == 5):
            faults.append("Voronoi rays")
    return faults


def compare_headers(one, other, vertices):
    """What differs between two refined results that should not: files, columns, the input's vertices."""
    faults = []
    if sorted(one.texts) != sorted(other.texts):
        return [f"files {sorted(one.texts)} and {sorted(other.texts)}"]
    for ending in [".node", ".ele", ".poly", ".edge"]:
        a, b = one.part(ending), other.part(ending)
        start = 0 if ending == ".poly" else 1
        if a and b and a[0][start:] != b[0][start:]:
            faults.append(f"columns of {ending}: {a[0]} and {b[0]}")
    nodes = [result.part(".node") for result in (one, other)]
    if all(nodes) and nodes[0][1:1 + vertices] != nodes[1][1:1 + vertices]:
        faults.append("input vertices, their attributes or markers")
    return faults


def counts(result):
    return " / ".join(f"{int(part[0][0])}" for part in (result.part(".node"), result.part(".ele")) if part) or "–"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--trimalla", help="the program, if it is built")
    ours = parser.parse_args().trimalla
    if ours is None:
        subprocess.run(["cargo", "build", "--release", "--quiet", "-p", "trimalla-cli"], cwd=BENCH.parent, check=True)
        ours = BENCH.parent / "target" / "release" / "trimalla"
    programs = [[str(build())], [str(pathlib.Path(ours).resolve()), "triangle"]]
    inputs = dict(INPUTS)
    failed = 0
    print("| switches | Triangle: vertices / triangles | trimalla | compared |\n|---|---|---|---|")
    mesh = Result(programs[0], "-pqcQ", "box", INPUTS)
    again = {name.replace("box", "x"): text for name, text in mesh.texts.items()}
    number = int(mesh.part(".ele")[0][0])
    again["x.1.area"] = "\n".join([str(number)] + [f"{i + 1} {0.05 if i < 3 else -1}" for i in range(number)]) + "\n"
    todo = [(EXACT, inputs, True), (REFINED, inputs, False), (AGAIN, again, False)]
    for calls, before, is_exact in todo:
        for switches, name in calls:
            one, other = (Result(program, switches, name, before) for program in programs)
            if one.status or other.status:
                faults = [f"status {one.status} and {other.status}"]
            elif is_exact:
                faults = compare_exactly(one, other)
            else:
                vertices = int(mesh.part(".node")[0][0]) if before is again else {"dots": 8, "plate": 8}.get(name, 8)
                faults = compare_headers(one, other, vertices)
            failed += bool(faults)
            same = "item by item: the same" if is_exact else "files, columns, input vertices: the same"
            print(f"| `{switches} {name}` | {counts(one)} | {counts(other)} | {'; '.join(faults) or same} |")
    sys.exit(failed > 0)


if __name__ == "__main__":
    main()
