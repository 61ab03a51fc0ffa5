#!/usr/bin/env python3
"""Vertices of trimalla's meshes beside Triangle's, on one drawing and on copies of it with seeded noise.

    against_triangle.py DRAWING.poly [--angles 20..35] [--copies 20] [--noise 1e-4] [--program target/release/trimalla]

Triangle 1.6 comes from the Python package `triangle` (pip install triangle numpy); it is measured, never shipped. Each of
its runs is a process of its own with a time limit, for it may crash or not end. Every mesh of trimalla is asked to be
complete; the geometric mean and the greatest ratio are printed, and the exit status is 1 where a mesh is not complete.
"""
import argparse
import json
import math
import multiprocessing
import os
import random
import subprocess
import sys
import tempfile

try:
    import triangle
except ImportError:
    sys.exit("skipped: the Python package `triangle` is not installed")


def read_poly(path):
    rows = [line.split("#")[0].split() for line in open(path)]
    rows = [r for r in rows if r]
    n = int(rows[0][0])
    base = int(rows[1][0])
    points = [(float(r[1]), float(r[2])) for r in rows[1 : 1 + n]]
    m = int(rows[1 + n][0])
    segments = [(int(r[1]) - base, int(r[2]) - base) for r in rows[2 + n : 2 + n + m]]
    h = int(rows[2 + n + m][0])
    holes = [(float(r[1]), float(r[2])) for r in rows[3 + n + m : 3 + n + m + h]]
    return points, segments, holes


def write_poly(path, points, segments, holes):
    with open(path, "w") as f:
        f.write(f"{len(points)} 2 0 0\n")
        f.writelines(f"{i} {x!r} {y!r}\n" for i, (x, y) in enumerate(points))
        f.write(f"{len(segments)} 0\n")
        f.writelines(f"{i} {a} {b}\n" for i, (a, b) in enumerate(segments))
        f.write(f"{len(holes)}\n")
        f.writelines(f"{i} {x!r} {y!r}\n" for i, (x, y) in enumerate(holes))


def peer_worker(queue, points, segments, holes, angle):
    drawing = {"vertices": points, "segments": segments}
    if holes:
        drawing["holes"] = holes
    queue.put(len(triangle.triangulate(drawing, f"pq{angle}")["vertices"]))


def peer(points, segments, holes, angle, seconds=20):
    queue = multiprocessing.Queue()
    process = multiprocessing.Process(target=peer_worker, args=(queue, points, segments, holes, angle))
    process.start()
    try:
        return queue.get(timeout=seconds)
    except Exception:
        return None
    finally:
        process.terminate()
        process.join()


def ours(program, path, angle):
    run = subprocess.run([program, "mesh", path, "--min-angle", str(angle), "--json"], capture_output=True, text=True)
    report = json.loads(run.stdout)
    return report["vertices"], report["complete"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("drawing")
    parser.add_argument("--angles", default="20..35")
    parser.add_argument("--copies", type=int, default=20)
    parser.add_argument("--noise", type=float, default=1e-4)
    parser.add_argument("--program", default=os.path.join(os.path.dirname(__file__), "..", "target", "release", "trimalla"))
    options = parser.parse_args()
    low, high = (int(a) for a in options.angles.split(".."))
    points, segments, holes = read_poly(options.drawing)
    complete = True

    print("| angle | trimalla | Triangle 1.6 | ratio |\n|---|---|---|---|")
    ratios = []
    for angle in range(low, high + 1):
        mine, whole = ours(options.program, options.drawing, angle)
        complete &= whole
        other = peer(points, segments, holes, angle)
        ratio = mine / other if other else None
        ratios += [ratio] if ratio else []
        print(f"| {angle} | {mine} | {other or 'no end'} | {f'{ratio:.3f}' if ratio else '-'} |")
    print(f"geometric mean {math.exp(sum(map(math.log, ratios)) / len(ratios)):.4f}, greatest {max(ratios):.3f}")

    noisy = random.Random(1)
    ratios = []
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "copy.poly")
        for _ in range(options.copies):
            moved = [tuple(c + noisy.uniform(-options.noise, options.noise) for c in p) for p in points]
            write_poly(path, moved, segments, holes)
            for angle in (20, 25, 30, 33):
                if low <= angle <= high:
                    mine, whole = ours(options.program, path, angle)
                    complete &= whole
                    other = peer(moved, segments, holes, angle)
                    ratios += [mine / other] if other else []
    if ratios:
        mean = sum(ratios) / len(ratios)
        print(f"{options.copies} copies with noise {options.noise:g} at 20, 25, 30, 33 degrees: mean ratio {mean:.4f}")
    return 0 if complete else 1


if __name__ == "__main__":
    sys.exit(main())
