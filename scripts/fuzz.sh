#!/bin/sh
# Random inputs for every door of the library: scripts/fuzz.sh MINUTES. Run it from anywhere; --help says more.
set -eu
cd "$(dirname "$0")/.."
cargo build --quiet --release --locked --manifest-path fuzz/Cargo.toml --bin trimalla-fuzz
exec "${CARGO_TARGET_DIR:-fuzz/target}/release/trimalla-fuzz" "$@"
