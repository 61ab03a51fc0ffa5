#!/bin/sh
# Makes the archive of a release: the program, its manual and completions, licences. Run it from anywhere.
#
#   scripts/release.sh             builds for this machine, writes target/archives/trimalla-VERSION-TARGET.tar.gz
#   scripts/release.sh TARGET      builds for another target that rustup has, for instance x86_64-unknown-linux-musl
#
# The same sources and compiler give an archive with the same bytes: names are sorted, owners and times fixed.
set -eu
cd "$(dirname "$0")/.."
host=$(rustc -vV | sed -n 's/^host: //p')
target=${1:-$host}
built=${CARGO_TARGET_DIR:-target}
version=$(sed -n 's/^version = "\(.*\)"$/\1/p' Cargo.toml | head -n 1)
name="trimalla-$version-$target"
folder="$built/archives/$name"

cargo build --release --locked -p trimalla-cli --target "$target"
rm -rf "$folder"
mkdir -p "$folder/bin" "$folder/man/man1" "$folder/completions"
ending=""
case $target in *windows*) ending=".exe" ;; esac
cp "$built/$target/release/trimalla$ending" "$folder/bin/"
cp README.md CHANGELOG.md LICENSE-MIT LICENSE-APACHE CITATION.cff "$folder/"

if [ "$target" = "$host" ]; then
    program="$folder/bin/trimalla$ending"
else # The pages and completions do not depend on the target.
    cargo build --release --locked -p trimalla-cli --target "$host"
    program="$built/$host/release/trimalla"
fi
"$program" man >"$folder/man/man1/trimalla.1"
for subcommand in $("$program" man --list); do
    "$program" man "$subcommand" >"$folder/man/man1/trimalla-$subcommand.1"
done
"$program" completions bash >"$folder/completions/trimalla.bash"
"$program" completions zsh >"$folder/completions/_trimalla"
"$program" completions fish >"$folder/completions/trimalla.fish"
"$program" completions powershell >"$folder/completions/_trimalla.ps1"

epoch=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct)}
(cd "$built/archives" && tar --sort=name --owner=0 --group=0 --numeric-owner --mtime="@$epoch" -cf - "$name" | gzip -n9 >"$name.tar.gz")
(cd "$built/archives" && sha256sum "$name.tar.gz" >"$name.tar.gz.sha256")
echo "written: $built/archives/$name.tar.gz"
