#!/usr/bin/env python3
"""Tables of docs/smallest.md: how small meshes get by --improve sift.

    python3 scripts/smallest.py [--effort N] [--angles 30,36] [DRAWING ...]

A line for each drawing (data/shapes where none is named): its vertices, and for each angle those of the refined and of
the sifted mesh, the Steiner vertices now over before, and the bound met where it is a lower one; then the geometric
means. Drawings in which the bound is not met are left out of the means. The program is built first.
"""

import argparse
import json
import math
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--effort", default="5", help="as of trimalla mesh")
    parser.add_argument("--angles", default="30,36", help="in degrees, with commas between")
    parser.add_argument("drawings", nargs="*", type=Path)
    return parser.parse_args()


def sifted(program: Path, drawing: Path, angle: str, effort: str) -> "dict | None":
    """The report of a run; None where there is no mesh."""
    command = [program, "mesh", drawing, "--min-angle", angle, "--improve", "sift", "--effort", effort, "--json"]
    run = subprocess.run(command, capture_output=True, text=True)
    return json.loads(run.stdout) if run.stdout else None


def cells(report: "dict | None", angle: str) -> "tuple[list[str], float | None]":
    """What the table says of a run, and the ratio of Steiner vertices."""
    if report is None or report["improved_from"] is None:
        return ["not made smaller", "", ""], None
    given = report["vertices"] - report["steiner_points"]
    before, now = report["improved_from"], report["vertices"]
    met = report["bound_met"] if report["bound_met"] is not None else float(angle)
    is_met = met >= float(angle)
    ratio = (now - given) / (before - given) if before > given else None
    shown = f"{now}" if is_met else f"{now}, met {met:g}"
    return [str(before), shown, "" if ratio is None else f"{ratio:.2f}"], ratio if is_met else None


def main() -> int:
    options = arguments()
    build = ["cargo", "build", "--release", "--quiet", "--locked", "-p", "trimalla-cli"]
    subprocess.run(build, cwd=ROOT, check=True)
    program = ROOT / "target/release/trimalla"
    angles = options.angles.split(",")
    drawings = options.drawings or sorted((ROOT / "data/shapes").glob("*.poly"))
    print("| drawing | " + " | ".join(f"refined, {a} degrees | sifted | Steiner" for a in angles) + " |")
    print("|--|" + "--|--|--|" * len(angles))
    ratios: "dict[str, list[float]]" = {angle: [] for angle in angles}
    for drawing in drawings:
        row = []
        for angle in angles:
            texts, ratio = cells(sifted(program, drawing, angle, options.effort), angle)
            row += texts
            if ratio is not None:
                ratios[angle].append(max(ratio, 1e-3))
        print(f"| {drawing.stem} | " + " | ".join(row) + " |", flush=True)
    for angle, all_of in ratios.items():
        if all_of:
            mean = math.exp(sum(map(math.log, all_of)) / len(all_of))
            print(f"\nGeometric mean at {angle} degrees: {mean:.2f} of {len(all_of)} drawings, the largest {max(all_of):.2f}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
