#!/bin/sh
# The studio in a browser: one folder to put on any static server.
#
#   scripts/web.sh [FOLDER]    builds the folder (target/web where nothing is said)
#   scripts/web.sh --check     builds one without optimization, opens it in a browser that nobody sees by a link that
#                              carries a script, clicks, drops a file and downloads one; with KEEP=1 in the environment
#                              the picture becomes docs/tour/browser.png
#
# What it needs is installed where it is missing (the browser on Debian, Ubuntu: as root, or with sudo); else it is
# skipped with one line.
set -eu
cd "$(dirname "$0")/.."

room=crates/trimalla-studio
skip() { echo "skipped: the studio in a browser ($1)"; exit 0; }
if ! cargo fetch --quiet --locked --manifest-path $room/Cargo.toml 2>/dev/null; then
    skip "its packages cannot be fetched"
fi
needed=$(sed -n 's/^rust-version = "\(.*\)"$/\1/p' $room/Cargo.toml)
present=$(rustc --version | cut -d ' ' -f 2 | cut -d . -f 1-2)
if [ "$(printf '%s\n%s\n' "$needed" "$present" | sort -V | head -n 1)" != "$needed" ]; then
    skip "it needs Rust $needed, and this is $present"
fi
platform=wasm32-unknown-unknown
if [ ! -d "$(rustc --print sysroot)/lib/rustlib/$platform" ] && ! rustup target add $platform >/dev/null 2>&1; then
    skip "rustup target add $platform does not work"
fi

products=${CARGO_TARGET_DIR:-$room/target}
if [ "${1:-}" = --check ]; then
    folder=$products/web-check
    # What runs while building is shared with the tests of the studio.
    export CARGO_PROFILE_DEV_OPT_LEVEL=0
    profile=dev
    built=debug
else
    folder=${1:-target/web}
    profile=web
    built=web
fi
# Cargo.lock gives both the same version of wasm-bindgen.
cargo build --quiet --locked --manifest-path $room/Cargo.toml --profile $profile --target $platform
cargo build --quiet --locked --manifest-path $room/Cargo.toml --profile $profile --package trimalla-bindgen
mkdir -p "$folder"
"$products/$built/trimalla-bindgen" "$products/$platform/$built/trimalla-studio.wasm" "$folder"
cp $room/index.html "$folder"
bytes=$(cat "$folder/index.html" "$folder/studio.js" "$folder/studio_bg.wasm" | wc -c)
packed=$(cat "$folder/index.html" "$folder/studio.js" "$folder/studio_bg.wasm" | gzip -6 | wc -c)
echo "$folder: $((bytes / 1000)) kB, $((packed / 1000)) kB as servers compress it"
[ "${1:-}" = --check ] || exit 0

command -v python3 >/dev/null || skip "python3 is missing"
for program in chromium chromedriver; do
    if ! command -v $program >/dev/null; then
        as_root=$([ "$(id -u)" = 0 ] || echo sudo)
        packages="chromium chromium-driver"
        if ! { $as_root apt-get update && $as_root apt-get install -y --no-install-recommends $packages; } >/dev/null 2>&1; then
            skip "$program cannot be installed"
        fi
    fi
done
picture=$products/browser.png
python3 scripts/web_check.py "$folder" "$picture"
if [ "${KEEP:-}" = 1 ]; then
    mkdir -p docs/tour
    cp "$picture" docs/tour/browser.png
fi
