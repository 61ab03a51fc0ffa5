#!/bin/sh
# Instructions of trimalla's call on a few fixed inputs, counted by valgrind: the same on a busy machine. Printed, not gated.
#
#   bench/callgrind.sh            then, for one of them: callgrind_annotate bench/target/callgrind/NAME.out
set -eu
cd "$(dirname "$0")"
if ! command -v valgrind >/dev/null; then
    echo "Installing valgrind ..." >&2
    as_root=$([ "$(id -u)" = 0 ] || echo sudo)
    if ! { $as_root apt-get update && $as_root apt-get install -y valgrind; } >/dev/null 2>&1; then
        echo "This needs valgrind; install it by hand (Debian, Ubuntu: apt-get install valgrind)." >&2
        exit 1
    fi
fi
CARGO_PROFILE_RELEASE_DEBUG=1 CARGO_TARGET_DIR=target/debuginfo cargo build --release --quiet --bin ours --bin inputs
mkdir -p target/callgrind

count() { # task input angle area
    target/debuginfo/release/inputs "$2"
    out="target/callgrind/$1-$2.out"
    valgrind --tool=callgrind --callgrind-out-file="$out" --toggle-collect='*timed_*' \
        target/debuginfo/release/ours trimalla "$1" "target/workloads/$2" "$3" "$4" 0 >target/callgrind/answer 2>target/callgrind/log
    instructions=$(sed -n 's/^.*Collected : \([0-9]*\).*$/\1/p' target/callgrind/log)
    read -r _ _ vertices triangles _ <target/callgrind/answer
    echo "| $1 | $2 | $instructions | $vertices | $triangles | $((instructions / vertices)) |"
}

echo "| task | input | instructions | vertices | triangles | a vertex |"
echo "|--|--|--|--|--|--|"
count points u10k 0 0
count points clus10k 0 0
count points grid10k 0 0
count points grid0.1-10k 0 0
count points circ10k 0 0
count points line10k 0 0
count constrained w5a-20k 0 0
count constrained w5b-20k 0 0
count constrained w5c-20k 0 0
count constrained channel10k 0 0
count polygon poly10k 0 0
count refine w6b-5k 30 0
count refine w6bs-5k 30 0
