#!/bin/sh
# Delaunay triangulation of points against CGAL, one thread, measured alternately.
#
#   bench/run_points.sh [N] [WORKLOAD...]      1 000 000 uniform points by default
#   workloads: uniform clustered grid grid0.1 circle line
#   RUNS=7          runs of each program
#   CXXFLAGS="..."  what CGAL is compiled with
set -eu
cd "$(dirname "$0")"
n=${1:-1000000}
[ $# -gt 0 ] && shift
[ $# -gt 0 ] || set -- uniform

if [ ! -e /usr/include/CGAL/Delaunay_triangulation_2.h ] || ! command -v g++ >/dev/null; then
    echo "Installing g++ and libcgal-dev ..." >&2
    as_root=$([ "$(id -u)" = 0 ] || echo sudo)
    if ! { $as_root apt-get update && $as_root apt-get install -y g++ libcgal-dev; } >/dev/null; then
        echo "This needs g++ and CGAL's headers; install them by hand (Debian, Ubuntu: apt-get install g++ libcgal-dev)." >&2
        exit 1
    fi
fi

cargo build --release --quiet
flags=${CXXFLAGS:--O3 -march=native}
# What CGAL asks of gcc: no assumption about rounding, no fused operations behind its back.
g++ $flags -std=c++17 -DNDEBUG -frounding-math -ffp-contract=off cgal_points.cpp -lgmp -lmpfr -o target/cgal_points
exec target/release/compare "$n" "${RUNS:-7}" target/cgal_points "$@"
