#!/bin/sh
# The package for Python: lints, a wheel, a fresh environment with it alone, its tests, doctests and types.
# The first run takes about three minutes; wheels of other packages come from the index of pip.
set -eu
cd "$(dirname "$0")/.."
crate=crates/trimalla-py
python=${PYTHON:-python3}

if ! "$python" -c 'import sys, venv, ensurepip; sys.exit(sys.version_info < (3, 10))' 2>/dev/null; then
    echo "skipped: the package for Python (no Python 3.10 or later with venv)"
    exit 0
fi
if ! cargo fetch --quiet --locked --manifest-path $crate/Cargo.toml 2>/dev/null; then
    echo "skipped: the package for Python (the packages of $crate cannot be fetched)"
    exit 0
fi
target=${CARGO_TARGET_DIR:-target}
mkdir -p "$target"
target=$(cd "$target" && pwd)/python
tools=$target/tools # Kept, so that a second run fetches nothing.
if ! { "$python" -m venv "$tools" && "$tools/bin/pip" install --quiet --disable-pip-version-check 'maturin>=1.9,<2'; } >/dev/null 2>&1; then
    echo "skipped: the package for Python (maturin cannot be installed)"
    exit 0
fi

export CARGO_TARGET_DIR="$target/cargo" PYO3_PYTHON="$tools/bin/python"
if cargo fmt --version >/dev/null 2>&1; then
    cargo fmt --manifest-path $crate/Cargo.toml --check
fi
rm -rf "$target/wheels" "$target/fresh"
"$tools/bin/maturin" build --quiet --profile quick --locked --manifest-path $crate/Cargo.toml --interpreter "$tools/bin/python" --out "$target/wheels"
"$python" -m venv "$target/fresh"
fresh=$target/fresh/bin
# What is tested beside the package: only some of it may be had, and tests say what they skip.
if ! "$fresh/pip" install --quiet --disable-pip-version-check "$target"/wheels/*.whl pytest; then
    echo "skipped: the package for Python (numpy or pytest cannot be installed)"
    exit 0
fi
for package in matplotlib meshio mypy networkx scipy shapely triangle xarray; do
    "$fresh/pip" install --quiet --disable-pip-version-check --only-binary :all: "$package" >/dev/null 2>&1 || echo "not installed: $package"
done

# The installed package is tested, not the folder: its modules are copied for the doctests.
installed=$("$fresh/python" -c 'import os, trimalla; print(os.path.dirname(trimalla.__file__))')
"$fresh/python" -m pytest --quiet --doctest-modules -c $crate/pyproject.toml --rootdir $crate $crate/tests "$installed"
if "$fresh/python" -c 'import mypy' 2>/dev/null; then
    "$fresh/mypy" --config-file $crate/pyproject.toml --cache-dir "$target/mypy" -p trimalla
    "$fresh/python" -m mypy.stubtest --mypy-config-file $crate/pyproject.toml trimalla._native
else
    echo "skipped: types (mypy cannot be installed)"
fi
