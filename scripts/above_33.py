#!/usr/bin/env python3
"""Meshes drawings at bounds of 34 to 44 degrees, and writes a table of what the program reaches.

Usage: above_33.py PROGRAM DRAWING... [-- OPTION...]

Each row is a drawing, each column a bound: the bound that was met, vertices over those of the mesh for 30 degrees, and
seconds. The last lines check two promises: no smallest angle is below that of the mesh for 30 degrees, and no mesh has
more than 20 times the vertices of the forecast. The exit status is 1 if one is broken.
"""
import json
import pathlib
import subprocess
import sys

ANGLES = [34, 35, 36, 37, 38, 40, 42, 44]


def run(program, drawing, angle, options):
    command = [program, "mesh", drawing, "--min-angle", str(angle), "--json", "--quiet", *options]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    return json.loads(done.stdout) if done.stdout else None


def main():
    program, *drawings = sys.argv[1:]
    at = drawings.index("--") if "--" in drawings else len(drawings)
    drawings, options = drawings[:at], drawings[at + 1:]
    print("| drawing | 30° | " + " | ".join(f"{angle}°" for angle in ANGLES) + " |")
    print("|---|---|" + "---|" * len(ANGLES))
    runs, worse, larger, slowest = 0, [], [], (0, "")
    for drawing in drawings:
        name, safe = pathlib.Path(drawing).stem, run(program, drawing, 30, options)
        if safe is None or not safe["triangles"]:
            continue
        cells = [f"{safe['vertices']} in {safe['seconds']:.3f} s, {safe['min_angle']:.2f}°"]
        for angle in ANGLES:
            made = run(program, drawing, angle, options)
            runs += 1
            if made["min_angle"] < safe["min_angle"] - 1e-9:
                worse.append(f"{name} at {angle}: {made['min_angle']} for {safe['min_angle']}")
            # Half as many vertices as triangles.
            if made["vertices"] > 20 * max(made["forecast_triangles"] / 2, safe["vertices"]):
                larger.append(f"{name} at {angle}: {made['vertices']} vertices")
            slowest = max(slowest, (made["seconds"], f"{name} at {angle}"))
            met = made["bound_met"]
            ratio = made["vertices"] / safe["vertices"]
            cells.append(f"{met:g}°, {ratio:.1f} ×, {made['seconds']:.2f} s")
        print(f"| {name} | " + " | ".join(cells) + " |", flush=True)
    print(f"\n{runs} meshes. Worse than at 30 degrees: {len(worse)}. Larger than 20 forecasts: {len(larger)}.", end=" ")
    print(f"The slowest took {slowest[0]:.1f} s ({slowest[1]}).")
    for line in worse + larger:
        print(f"- {line}")
    return 1 if worse or larger else 0


if __name__ == "__main__":
    sys.exit(main())
