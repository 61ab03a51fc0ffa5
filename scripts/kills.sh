#!/bin/sh
# Kills the program while it saves meshes, pictures, a recipe, a trace and frames into two directories: N times at random moments
# (500 unless given), and, where strace may trace, once at each system call that changes a directory. Fails where a file is half
# written, or where the run after the kill leaves a mixture of old and new files or a temporary one. Run it from anywhere.
#
#   sh scripts/kills.sh [N]
set -eu
cd "$(dirname "$0")/.."
TRIMALLA_KILLS=${1:-500} cargo test --quiet --locked -p trimalla-cli --test program kills::g02 -- --nocapture --test-threads 1
