#!/bin/sh
# The studio in a real window of a display that nobody sees: opened on a file, refined by clicking, and looked at.
#
#   scripts/studio.sh            checks; with KEEP=1 in the environment the picture becomes docs/tour/studio.png
#   scripts/studio.sh --tests    the tests of the panels alone, which need no display
#
# What it needs is installed where it is missing (Debian, Ubuntu: as root, or with sudo); else it is skipped with one line.
set -eu
cd "$(dirname "$0")/.."

room=crates/trimalla-studio
if ! cargo fetch --quiet --locked --manifest-path $room/Cargo.toml 2>/dev/null; then
    echo "skipped: the studio (its packages cannot be fetched)"
    exit 0
fi
needed=$(sed -n 's/^rust-version = "\(.*\)"$/\1/p' $room/Cargo.toml)
present=$(rustc --version | cut -d ' ' -f 2 | cut -d . -f 1-2)
if [ "$(printf '%s\n%s\n' "$needed" "$present" | sort -V | head -n 1)" != "$needed" ]; then
    echo "skipped: the studio (it needs Rust $needed, and this is $present)"
    exit 0
fi
cargo test --quiet --locked --manifest-path $room/Cargo.toml
if ls /usr/share/vulkan/icd.d/lvp_icd*.json >/dev/null 2>&1; then
    XDG_RUNTIME_DIR=${XDG_RUNTIME_DIR:-/tmp} cargo test --quiet --locked --manifest-path $room/Cargo.toml --test tour -- --ignored
else
    echo "skipped: the pictures of docs/tour (Mesa's software Vulkan is not installed)"
fi
[ "${1:-}" != --tests ] || exit 0

for program in Xvfb xdotool import; do
    if ! command -v $program >/dev/null; then
        as_root=$([ "$(id -u)" = 0 ] || echo sudo)
        packages="xvfb xauth xdotool imagemagick libgl1-mesa-dri libegl1 libgl1 mesa-vulkan-drivers libxkbcommon-x11-0"
        packages="$packages libxcursor1 libxi6 libxrandr2 libx11-xcb1"
        if ! { $as_root apt-get update && $as_root apt-get install -y --no-install-recommends $packages; } >/dev/null 2>&1; then
            echo "skipped: the studio's window ($program cannot be installed)"
            exit 0
        fi
    fi
done

# The tests have built the program, too: another build would compile the toolkit once more with fewer features.
temporary=$(mktemp -d)
processes=
trap 'kill $processes 2>/dev/null || true; rm -rf "$temporary"' EXIT
export XDG_RUNTIME_DIR="$temporary"
chmod 700 "$temporary"
unset WAYLAND_DISPLAY
display=:$((70 + $$ % 900))
Xvfb $display -screen 0 1280x860x24 -nolisten tcp >/dev/null 2>&1 &
processes=$!
export DISPLAY=$display
sleep 2
"${CARGO_TARGET_DIR:-$room/target}/debug/trimalla-studio" data/shapes/key.poly >"$temporary/log" 2>&1 &
studio=$!
processes="$processes $studio"

window=
for _ in $(seq 60); do
    window=$(xdotool search --pid $studio --name trimalla 2>/dev/null | head -n 1 || true)
    [ -z "$window" ] || break
    sleep 0.5
done
if [ -z "$window" ]; then
    echo "skipped: the studio's window (none can be shown here: $(tail -n 1 "$temporary/log"))"
    exit 0
fi
xdotool windowmove "$window" 0 0 windowsize "$window" 1280 860
sleep 3

click() { # x y
    xdotool mousemove "$1" "$2"
    sleep 0.3
    xdotool click 1
    sleep 1
}
xdotool windowfocus "$window"
click 763 12 # Triangulate
click 434 58 # Refine
click 1001 12 # Check
click 545 388 # a triangle
sleep 0.5
import -window root "$temporary/studio.png"
kill -0 $studio || { echo "error: the studio has ended" >&2; cat "$temporary/log" >&2; exit 1; }
colours=$(identify -format %k "$temporary/studio.png")
[ "$colours" -gt 50 ] || { echo "error: the window shows $colours colours only" >&2; exit 1; }
mkdir -p docs/tour
if [ "${KEEP:-}" = 1 ]; then
    cp "$temporary/studio.png" docs/tour/studio.png
fi
echo "the studio: opened on a file, refined by clicks, $colours colours in its window"
