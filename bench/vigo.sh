#!/bin/sh
# Table 1 of [Vigo97] again: vertices and edges inserted, timed apart, on shapes of ours with the counts of that table; then the same
# on growing shapes.
set -eu
cd "$(dirname "$0")"
cargo build --release --quiet
exec target/release/vigo
