#!/usr/bin/env python3
"""Runs two builds of the program over drawings, with and without bounds on sizes, and compares what they write.

    scripts/same_meshes.py OLD NEW FOLDER...

Every file below the folders is tried: as it is, under an area bound, with a region of a bound of its own, and as a mesh
that is refined under bounds triangle by triangle. Files, status and messages must be the same byte for byte.
"""
import collections
import filecmp
import pathlib
import subprocess
import sys
import tempfile

SECONDS = 60
DRAWING = ["--crossings", "split"]
LIMITS = ["--max-vertices", "20000", "--quiet"]


def run(program, folder, *args):
    """Status and messages of a run in a folder."""
    try:
        done = subprocess.run([program, *map(str, args)], cwd=folder, capture_output=True, timeout=SECONDS)
    except subprocess.TimeoutExpired:
        return "timeout"
    return done.returncode, done.stdout, done.stderr


def mesh_of(folder, stem):
    """Points and triangles of a mesh in Triangle's format, counted from its first number on; `None` without one."""
    def rows(ending):
        lines = (folder / f"{stem}{ending}").read_text().splitlines()
        return [line.split() for line in lines if line.strip() and not line.startswith("#")][1:]
    try:
        points = {row[0]: (float(row[1]), float(row[2])) for row in rows(".node")}
        triangles = [[points[v] for v in row[1:4]] for row in rows(".ele")]
    except (FileNotFoundError, KeyError, IndexError, ValueError):
        return None
    return triangles or None


def area(triangle):
    (ax, ay), (bx, by), (cx, cy) = triangle
    return 0.5 * abs((bx - ax) * (cy - ay) - (by - ay) * (cx - ax))


class Pair:
    """The same runs of both programs, each in a folder of its own."""

    def __init__(self, programs, folders):
        self.programs, self.folders = programs, folders
        self.statuses, self.differences = collections.Counter(), []

    def same(self, *args):
        answers = [run(program, folder, *args) for program, folder in zip(self.programs, self.folders)]
        if "timeout" in answers:
            self.statuses["timeout"] += 1
            return print("  timeout:", *args)
        self.statuses[answers[0][0]] += 1
        names = [sorted(path.name for path in folder.iterdir()) for folder in self.folders]
        differing = filecmp.cmpfiles(*self.folders, names[0], shallow=False)[1:]
        if answers[0] != answers[1] or names[0] != names[1] or any(differing):
            self.differences.append(" ".join(map(str, args)))
            print("  DIFFERS:", *args, *differing)

    def write(self, name, text):
        for folder in self.folders:
            (folder / name).write_text(text)

    def try_drawing(self, path):
        self.same("mesh", path, "-o", "m.ele", *DRAWING, *LIMITS)
        drawing = DRAWING if mesh_of(self.folders[0], "m") else [*DRAWING, "--domain", "hull"]
        self.same("mesh", path, "-o", "m.ele", *drawing, *LIMITS)
        triangles = mesh_of(self.folders[0], "m")
        if triangles is None:
            return
        bound = sum(map(area, triangles)) / 300
        self.same("mesh", path, "-o", "a.ele", "--max-area", bound, *drawing, *LIMITS)
        self.same("mesh", path, "-o", "f.ele", "--max-area", bound, *drawing, "--fill", "none", "--min-angle", 20, *LIMITS)
        self.same("mesh", path, "-o", "l.ele", "--max-area", bound, *drawing, "--algorithm", "lepp-centroid", *LIMITS)
        bounds = [0.4 * area(t) if i % 3 else -1 for i, t in enumerate(triangles)]
        self.write("m.area", "\n".join([str(len(bounds)), *(f"{i} {b!r}" for i, b in enumerate(bounds))]) + "\n")
        self.same("refine", "m.ele", "-o", "r.ele", *LIMITS)
        self.same("refine", "m.ele", "-o", "s.ele", "--max-area", bound, "--initial", "given", *LIMITS)
        self.try_region(path, triangles, bound)

    def try_region(self, path, triangles, bound):
        self.same("convert", path, "d.poly")
        drawing = self.folders[0] / "d.poly"
        if not drawing.exists():
            return
        largest = max(triangles, key=area)
        x, y = (sum(p[k] for p in largest) / 3 for k in (0, 1))
        region = f"1\n0 {x!r} {y!r} 7 {bound!r}\n"
        self.write("d.poly", drawing.read_text().rstrip() + "\n" + region)
        self.same("mesh", "d.poly", "-o", "g.ele", *DRAWING, *LIMITS)
        self.same("mesh", "d.poly", "-o", "e.ele", "--max-area", 1.7 * bound, *DRAWING, *LIMITS)
        self.same("refine", "m.ele", "--input", "d.poly", "-o", "p.ele", *LIMITS)
        self.same("refine", "m.ele", "--input", "d.poly", "-o", "q.ele", "--max-area", 0.8 * bound, *LIMITS)


def main(old, new, *folders):
    programs = [str(pathlib.Path(program).resolve()) for program in (old, new)]
    paths = sorted(path for folder in folders for path in pathlib.Path(folder).resolve().rglob("*") if path.is_file())
    statuses, differences = collections.Counter(), []
    for path in paths:
        with tempfile.TemporaryDirectory() as one, tempfile.TemporaryDirectory() as other:
            pair = Pair(programs, [pathlib.Path(one), pathlib.Path(other)])
            pair.try_drawing(path)
            statuses += pair.statuses
            differences += [f"{path}: {d}" for d in pair.differences]
    by_status = ", ".join(f"{n} of status {status}" for status, n in sorted(statuses.items(), key=str))
    print(f"{len(paths)} files, {sum(statuses.values())} runs ({by_status}), {len(differences)} differences")
    sys.exit(1 if differences else 0)


if __name__ == "__main__":
    main(*sys.argv[1:])
