#!/bin/sh
# Everything that must hold: format, lints, documentation, tests. Run it from anywhere.
set -eu
cd "$(dirname "$0")/.."

start=$(date +%s)
step() { printf '\n== %s\n' "$1"; }

if cargo fmt --version >/dev/null 2>&1; then
    step "format"
    cargo fmt --all --check
else
    echo "skipped: format (rustfmt is not installed)"
fi
if cargo clippy --version >/dev/null 2>&1; then
    step "lints"
    cargo clippy --quiet --locked --workspace --all-targets --all-features -- -D warnings
else
    echo "skipped: lints (clippy is not installed)"
fi
msrv=$(sed -n 's/^rust-version = "\(.*\)"$/\1/p' Cargo.toml)
if cargo "+$msrv" --version >/dev/null 2>&1; then
    step "Rust $msrv, the oldest promised"
    CARGO_TARGET_DIR="${CARGO_TARGET_DIR:-target}/msrv" cargo "+$msrv" check --quiet --locked --workspace --all-features
else
    echo "skipped: Rust $msrv (rustup toolchain install $msrv --profile minimal)"
fi
features=$(sed -n '/^\[features\]/,/^\[dep/s/^\([a-z-]*\) = .*/\1/p' crates/trimalla/Cargo.toml)
for feature in $features; do # The first is the default, which has none.
    step "the library with the feature $feature alone"
    cargo check --quiet --locked -p trimalla --no-default-features --features "$feature"
done
if rustup target list --installed 2>/dev/null | grep -qx wasm32-unknown-unknown; then
    step "the library for wasm32"
    cargo check --quiet --locked -p trimalla --all-features --target wasm32-unknown-unknown
else
    echo "skipped: wasm32 (rustup target add wasm32-unknown-unknown)"
fi
step "documentation"
RUSTDOCFLAGS="-D warnings" cargo doc --quiet --locked --workspace --all-features --no-deps --document-private-items
step "tests"
cargo test --locked --workspace --all-features
step "examples"
cargo run --quiet --locked -p trimalla --example five_points
cargo run --quiet --locked -p trimalla --example refine_to_32 | tail -n 1
cargo run --quiet --locked -p trimalla --example own_steps | tail -n 1
cargo run --quiet --locked -p trimalla --example history_cost 20000 | tail -n 1
cargo run --quiet --locked -p trimalla-compare --example own_strategy | tail -n 1
step "the library for C"
sh scripts/c.sh
step "studio"
scripts/studio.sh
step "random inputs"
# fuzz/ is a workspace of its own, with packages of its own.
if cargo fetch --quiet --locked --manifest-path fuzz/Cargo.toml 2>/dev/null; then
    scripts/fuzz.sh --corpus fuzz/corpus
    scripts/fuzz.sh --executions 40000
else
    echo "skipped: random inputs (the packages of fuzz/ cannot be fetched)"
fi
step "the package for Python"
if [ $(($(date +%s) - start)) -lt 960 ]; then
    sh scripts/python.sh
else
    echo "skipped: the package for Python (16 minutes are over; scripts/python.sh runs it)"
fi
step "studio in a browser"
# The last one, as all else matters more: everything is to end within 25 minutes.
if [ $(($(date +%s) - start)) -lt 1020 ]; then
    scripts/web.sh --check
else
    echo "skipped: the studio in a browser (17 minutes are over; scripts/web.sh --check runs it)"
fi
