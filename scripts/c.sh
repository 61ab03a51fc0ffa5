#!/bin/sh
# The C library: builds it, static and shared; runs its example and its tests, under valgrind where that is installed;
# relinks a program that was written for Triangle's library.
#
#   sh scripts/c.sh                    the tests
#   sh scripts/c.sh --install PREFIX   the library, optimized, its headers and its pkg-config file below PREFIX
#   NO_BUILD=1                         takes the library as it was built before
set -eu
cd "$(dirname "$0")/.."
c=crates/trimalla-c
target=${CARGO_TARGET_DIR:-target}

install_below() {
    prefix=$1
    cargo build --quiet --locked --release -p trimalla-c
    version=$(sed -n 's/^version = "\(.*\)"$/\1/p' Cargo.toml | head -n 1)
    mkdir -p "$prefix/include" "$prefix/lib/pkgconfig"
    cp "$c/include/trimalla.h" "$c/include/triangle_compat.h" "$prefix/include/"
    for file in libtrimalla_c.a libtrimalla_c.so libtrimalla_c.dylib; do
        [ ! -e "$target/release/$file" ] || cp "$target/release/$file" "$prefix/lib/"
    done
    prefix=$(cd "$prefix" && pwd)
    sed "s|@PREFIX@|$prefix|; s|@VERSION@|$version|" "$c/trimalla_c.pc.in" >"$prefix/lib/pkgconfig/trimalla_c.pc"
    echo "installed below $prefix"
}

if [ "${1:-}" = --install ]; then
    install_below "$2"
    exit 0
fi
if ! command -v gcc >/dev/null; then
    echo "skipped: the C library (gcc is not installed)"
    exit 0
fi
[ -n "${NO_BUILD:-}" ] || cargo build --quiet --locked -p trimalla-c
built=$target/debug
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
flags="-std=c11 -D_POSIX_C_SOURCE=200809L -Wall -Wextra -Werror -Wno-discarded-qualifiers -O1 -g"

# A program written for Triangle finds its header under that name. Triangle's own is taken where it was fetched.
cp "$c/include/triangle_compat.h" "$work/triangle.h"

# shellcheck disable=SC2086
build() { # how it is linked, the source, include folders before ours
    how=$1 source=$2 name=$work/$(basename "$2" .c)-$1
    shift 2
    case $how in
    static) libraries="$built/libtrimalla_c.a -lpthread -ldl -lm" ;;
    shared) libraries="-L$built -ltrimalla_c -Wl,-rpath,$(cd "$built" && pwd) -lpthread -lm" ;;
    esac
    gcc $flags "$@" -I"$c/include" -I"$work" "$source" $libraries -o "$name"
}

# What a driver prints after the two times: points and triangles.
counts() { echo "$1" | awk '{ print $3, $4 }'; }

under=""
if command -v valgrind >/dev/null; then
    under="valgrind --quiet --error-exitcode=9 --leak-check=full --show-leak-kinds=definite,indirect,possible --errors-for-leak-kinds=definite,indirect"
else
    echo "skipped: valgrind (it is not installed)"
fi
for how in static shared; do
    build $how $c/examples/plate.c
    build $how $c/tests/api.c
    build $how $c/tests/compat.c
    "$work/plate-$how"
    "$work/api-$how"
    "$work/compat-$how" 2>"$work/messages"
    grep -q "the switch -u is not supported" "$work/messages"
done
if [ -n "$under" ]; then
    $under "$work/plate-static" >/dev/null
    $under "$work/compat-shared" 2>"$work/valgrind" || { grep "^==" "$work/valgrind" && false; }
    echo "valgrind: no error, nothing lost"
fi

# The driver that measures Triangle's library, linked against ours instead. Without refinement the counts must be equal.
lax="-Wno-unused-parameter -Wno-unused-result -Wno-missing-field-initializers -Wno-unused-function"
build static $c/tests/drawing.c
# shellcheck disable=SC2086
build static bench/drivers/triangle.c $lax
peer=bench/target/triangle/c
if [ -e $peer/triangle.c ]; then
    mv "$work/triangle.h" "$work/ours.h"
    build static $c/tests/compat.c -w -I$peer
    "$work/compat-static" 2>/dev/null
    echo "compiled with Triangle's own header: the same"
    # shellcheck disable=SC2086
    gcc -O1 -w -ffp-contract=off -DREAL=double -DVOID=void -DTRILIBRARY -DANSI_DECLARATORS -I$peer \
        bench/drivers/triangle.c $peer/triangle.c -lm -o "$work/theirs"
else
    echo "skipped: Triangle itself (bench/get_triangle.sh fetches it)"
fi
for name in guitar key plate star; do
    "$work/drawing-static" data/shapes/$name.poly "$work/$name.drawing"
    for task in "constrained 0 0" "polygon 0 0" "quality 30 0.5"; do
        # shellcheck disable=SC2086
        set -- $task
        ours=$("$work/triangle-static" triangle "$1" "$work/$name.drawing" "$2" "$3" 0)
        theirs=none
        [ ! -e "$work/theirs" ] || theirs=$("$work/theirs" triangle "$1" "$work/$name.drawing" "$2" "$3" 0)
        echo "$name, $1: ours $(counts "$ours"), Triangle's $(counts "$theirs")"
        [ "$theirs" = none ] || [ "$1" = quality ] || [ "$(counts "$ours")" = "$(counts "$theirs")" ]
    done
done

if command -v cmake >/dev/null; then
    mkdir -p "$work/lib" && cp "$built"/libtrimalla_c.* "$work/lib/"
    cmake -S "$c/examples/cmake" -B "$work/cmake" "-DCMAKE_PREFIX_PATH=$work" "-DTRIMALLA_INCLUDE=$PWD/$c/include" >/dev/null
    cmake --build "$work/cmake" >/dev/null
    "$work/cmake/plate"
else
    echo "skipped: the CMake example (cmake is not installed)"
fi
if command -v pkg-config >/dev/null; then
    sed "s|@PREFIX@|/usr/local|; s|@VERSION@|0.1.0|" "$c/trimalla_c.pc.in" >"$work/trimalla_c.pc"
    PKG_CONFIG_PATH=$work pkg-config --libs trimalla_c | grep -q -- -ltrimalla_c
fi
