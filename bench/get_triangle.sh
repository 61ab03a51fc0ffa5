#!/bin/sh
# Fetches Triangle's C source, as the Python source package `triangle` carries it, into bench/target/triangle.
# It is measured, never shipped. Fails with one line where it cannot be had.
set -eu
cd "$(dirname "$0")"
[ -e target/triangle/c/triangle.c ] && exit 0
if ! command -v gcc >/dev/null || ! python3 -m pip --version >/dev/null 2>&1; then
    echo "skipped: Triangle: needs gcc and pip" >&2
    exit 1
fi
mkdir -p target/sdist target/triangle
if ! python3 -m pip download --quiet --no-binary :all: --no-deps triangle==20200424 -d target/sdist >/dev/null 2>&1 ||
    ! tar xzf target/sdist/triangle-20200424.tar.gz -C target/triangle --strip-components=1; then
    echo "skipped: Triangle: its source package cannot be had" >&2
    exit 1
fi
