#!/usr/bin/env python3
"""Times two builds of trimalla alternately: what a change costs, or gains.

    python3 bench/two_builds.py NEW OLD RUNS WORKLOAD...

NEW and OLD are two programs `ours`, as `cargo build --release` makes them in bench/ (of two worktrees). A workload is
named as in `bench/run.sh`, with an angle where it is refined: u100k w5a poly10k A w6bs:30 w6c. Inputs are those in
bench/target/workloads; `target/release/inputs WORKLOAD...` makes them. Every run is a process of its own. Each line
has the medians of CPU seconds, and the median of the ratios of neighbouring runs.
"""
import pathlib
import statistics
import subprocess
import sys

INPUTS = pathlib.Path(__file__).resolve().parent / "target" / "workloads"
AREAS = {"A": 1.3e-7, "w6c": 7.5e-7}
ANGLES = {"A": 30}


def arguments(workload):
    """What `ours` is called with."""
    name, _, angle = workload.partition(":")
    if angle or name in AREAS:
        task = "refine"
    elif name.startswith(("w5", "channel")):
        task = "constrained"
    else:
        task = "polygon" if name.startswith("poly") else "points"
    bounds = [angle or ANGLES.get(name, 0), AREAS.get(name, 0), 0]
    return ["trimalla", task, INPUTS / name, *bounds]


def cpu_and_vertices(program, workload):
    done = subprocess.run([program, *map(str, arguments(workload))], capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(f"{program} {workload}: {done.stderr.strip()}")
    _, cpu, vertices, *_ = done.stdout.split()
    return float(cpu), int(vertices)


def main():
    if len(sys.argv) < 5:
        raise SystemExit(__doc__)
    programs, runs, workloads = {"new": sys.argv[1], "old": sys.argv[2]}, int(sys.argv[3]), sys.argv[4:]
    for workload in workloads:
        measured = {which: [] for which in programs}
        for run in range(runs):
            for which in ("new", "old") if run % 2 else ("old", "new"):
                measured[which].append(cpu_and_vertices(programs[which], workload))
        seconds = {which: statistics.median(cpu for cpu, _ in measured[which]) for which in programs}
        ratio = statistics.median(n / o for (n, _), (o, _) in zip(measured["new"], measured["old"]))
        new, old = (measured[which][0][1] for which in ("new", "old"))
        counted = "" if new == old else f", {new} and {old} vertices"
        print(f"{workload:12} new {seconds['new']:.4f} s, old {seconds['old']:.4f} s, ratio {ratio:.3f}{counted}", flush=True)


if __name__ == "__main__":
    main()
