#!/usr/bin/env python3
"""The package for Python beside others, on the same points, each run in a process of its own.

    python.py [--points 100000] [--angle 30] [--repeat 3]

`pip install triangle scipy`, and trimalla from `crates/trimalla-py` (`pip install .`). Conversion of arrays is part of the
time; the best of the runs counts, in wall time. Peak memory is that of the process, beside what it had before the call. Packages that
are not installed are left out. They are measured, never shipped.
"""

import argparse
import json
import subprocess
import sys

RUN = """
import json, resource, sys, time
import numpy as np
task, count, angle = sys.argv[1], int(sys.argv[2]), sys.argv[3]
points = np.random.default_rng(1).random((count, 2))
if task == "trimalla delaunay":
    import trimalla
    call = lambda: trimalla.delaunay(points)
elif task == "trimalla.scipy Delaunay":
    from trimalla.scipy import Delaunay
    call = lambda: Delaunay(points).simplices
elif task == "scipy Delaunay":
    from scipy.spatial import Delaunay
    call = lambda: Delaunay(points).simplices
elif task == "triangle delaunay":
    import triangle
    call = lambda: triangle.delaunay(points)
elif task == "trimalla mesh":
    import trimalla
    call = lambda: trimalla.mesh(points, min_angle=float(angle)).triangles
elif task == "trimalla.triangle triangulate":
    import trimalla.triangle as triangle
    call = lambda: triangle.triangulate({"vertices": points}, "q" + angle)["triangles"]
elif task == "triangle triangulate":
    import triangle
    call = lambda: triangle.triangulate({"vertices": points}, "q" + angle)["triangles"]
before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
start, cpu = time.perf_counter(), time.process_time()
made = call()
seconds, cpu = time.perf_counter() - start, time.process_time() - cpu
peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before
print(json.dumps({"seconds": seconds, "cpu": cpu, "triangles": len(made), "peak": peak / 1024}))
"""

TASKS = {
    "Delaunay": ["trimalla delaunay", "trimalla.scipy Delaunay", "scipy Delaunay", "triangle delaunay"],
    "refined": ["trimalla mesh", "trimalla.triangle triangulate", "triangle triangulate"],
}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--points", type=int, default=100_000)
    parser.add_argument("--angle", default="30")
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--limit", type=float, default=300.0, help="seconds for a run")
    asked = parser.parse_args()
    print(f"{asked.points} points, seed 1, best of {asked.repeat}\n\n| task | call | seconds | CPU seconds | triangles | peak MB |\n|---|---|---|---|---|---|")
    for task, calls in TASKS.items():
        for call in calls:
            runs = [run(call, asked) for _ in range(asked.repeat)]
            done = [found for found in runs if isinstance(found, dict)]
            if done:
                best = min(done, key=lambda found: found["seconds"])
                print(f"| {task} | {call} | {best['seconds']:.3f} | {best['cpu']:.3f} | {best['triangles']} | {best['peak']:.0f} |", flush=True)
            else:
                print(f"| {task} | {call} | {runs[0]} | | | |", flush=True)


def run(call: str, asked: argparse.Namespace) -> dict[str, float] | str:
    """One run: its figures, or what went wrong in a word."""
    command = [sys.executable, "-c", RUN, call, str(asked.points), asked.angle]
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=asked.limit)
    except subprocess.TimeoutExpired:
        return f"more than {asked.limit:.0f} s"
    if "ModuleNotFoundError" in done.stderr:
        return "not installed"
    return json.loads(done.stdout) if done.returncode == 0 else f"ended with {done.returncode}"


if __name__ == "__main__":
    main()
