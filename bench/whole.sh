#!/bin/sh
# Whole processes on a million points, from .node to .ele, reading and writing included: trimalla beside Triangle's own program.
#
#   bench/whole.sh [WORKLOAD] [RUNS]      u1m and 5 by default
set -eu
cd "$(dirname "$0")"
name=${1:-u1m}
runs=${2:-5}
mkdir -p target/bin target/whole
cargo build --release --quiet
CARGO_TARGET_DIR=target/program cargo build --release --quiet --manifest-path ../Cargo.toml -p trimalla-cli
target/release/inputs "$name" "target/whole/$name.node"
set -- target/program/release/trimalla triangulate "target/whole/$name.node" -o "target/whole/ours.ele" --quiet
if ./get_triangle.sh; then
    # shellcheck disable=SC2086
    if gcc ${CFLAGS:--O3 -march=native} -ffp-contract=off -w -DREAL=double -DVOID=void target/triangle/c/triangle.c -lm -o target/bin/triangle-program 2>/dev/null; then
        set -- "$@" -- target/bin/triangle-program -Q "target/whole/$name.node"
    else
        echo "skipped: Triangle: its source does not compile as a program" >&2
    fi
fi
target/release/whole "$runs" "$@"
if [ -e "target/whole/$name.1.ele" ]; then
    ours=$(head -n 1 target/whole/ours.ele | cut -d' ' -f1)
    theirs=$(head -n 1 "target/whole/$name.1.ele" | cut -d' ' -f1)
    if [ "$ours" = "$theirs" ]; then echo "Both: $ours triangles."; else
        echo "The programs disagree: $ours and $theirs triangles." >&2
        exit 1
    fi
fi
