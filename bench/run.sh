#!/bin/sh
# Builds trimalla and the other programs, runs them alternately on the same inputs, writes bench/target/report.md and .svg.
#
#   bench/run.sh                                             everything (about an hour)
#   bench/run.sh --only points --runs 3 --programs trimalla,cgal
#   bench/run.sh --help
#
#   CXXFLAGS="-O3 -march=native"   what CGAL is compiled with, CFLAGS the same for Triangle
#   A_POLY=path                    the example of Triangle's manual, if not the one that comes with its source
#   NO_BUILD=1                     builds nothing
set -eu
cd "$(dirname "$0")"
bin=target/bin
mkdir -p "$bin"

skipped() { echo "skipped: $1" >&2; }

build_ours() {
    cargo build --release --quiet
    cp target/release/ours "$bin/ours"
}

build_triangle() {
    ./get_triangle.sh || return 0
    flags="${CFLAGS:--O3 -march=native} -ffp-contract=off -w -DREAL=double -DVOID=void"
    # shellcheck disable=SC2086
    gcc $flags -DTRILIBRARY -DANSI_DECLARATORS -Itarget/triangle/c drivers/triangle.c target/triangle/c/triangle.c -lm -o "$bin/triangle" 2>/dev/null ||
        skipped "Triangle: its source does not compile"
}

build_cgal() {
    if [ ! -e /usr/include/CGAL/Delaunay_triangulation_2.h ] || ! command -v g++ >/dev/null; then
        echo "Installing g++ and libcgal-dev ..." >&2
        as_root=$([ "$(id -u)" = 0 ] || echo sudo)
        if ! { $as_root apt-get update && $as_root apt-get install -y g++ libcgal-dev; } >/dev/null 2>&1; then
            skipped "CGAL: needs g++ and libcgal-dev"
            return 0
        fi
    fi
    # What CGAL asks of gcc: no assumption about rounding, no fused operations behind its back.
    # shellcheck disable=SC2086
    g++ ${CXXFLAGS:--O3 -march=native} -std=c++17 -DNDEBUG -frounding-math -ffp-contract=off drivers/cgal.cpp -lgmp -lmpfr -o "$bin/cgal" ||
        skipped "CGAL: its driver does not compile"
}

build_crates() {
    if (cd peers && CARGO_TARGET_DIR=../target/peers RUSTFLAGS="${RUSTFLAGS:--C target-cpu=native}" cargo build --release --quiet --locked); then
        cp target/peers/release/trimalla-bench-peers "$bin/peers"
    else
        skipped "spade, delaunator, cdt, i_triangle, earcut: the crates cannot be had"
    fi
}

newer() { [ -e "$1" ] && [ -z "$(find "$2" -newer "$1")" ]; }

if [ -z "${NO_BUILD:-}" ]; then
    build_ours
    newer "$bin/triangle" drivers || build_triangle
    newer "$bin/cgal" drivers || build_cgal
    [ -e "$bin/peers" ] && [ -z "$(find peers/src peers/Cargo.toml src/clock.rs -newer "$bin/peers")" ] || build_crates
fi
exec target/release/race target "$@"
