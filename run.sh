#!/usr/bin/env bash
# From a bare machine to the rules behind a drawing.
set -euo pipefail

usage() {
    cat <<'TEXT'
Usage: ./run.sh [-o FOLDER] [--no-editor] [ART.svg]

Installs what is missing, builds the program, finds the rules behind ART.svg (default: a sample), prints them, and writes
  FOLDER/NAME.lsys  the grammar
  FOLDER/NAME.svg   the picture that the grammar draws
  FOLDER/NAME.png   the same as pixels
FOLDER is by default the folder out/ of the project. With a display it then builds the editor and opens it on ART.svg;
  --no-editor   does not
TEXT
}

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
folder=$root/out
art=$root/samples/facade.svg
editor=yes
while [ $# -gt 0 ]; do
    case $1 in
        -h | --help) usage; exit 0 ;;
        -o) [ $# -ge 2 ] || { usage >&2; exit 2; }; folder=$2; shift 2 ;;
        --no-editor) editor=no; shift ;;
        --) shift; [ $# -gt 0 ] && art=$1; break ;;
        -*) usage >&2; exit 2 ;;
        *) art=$1; shift ;;
    esac
done
[ -f "$art" ] || { printf '%s: no such file\n' "$art" >&2; exit 1; }

. "$root/scripts/packages.sh"
install_packages "${build_packages[@]}"

log=$root/build/release.log
mkdir -p "$root/build"
build() {  # TARGET
    (cd "$root" && cmake --preset release && cmake --build --preset release --parallel "$(nproc)" --target "$1") >"$log" 2>&1 &&
        return 0
    tail -n 40 "$log" >&2
    is_debian || say_what_to_install "${build_packages[@]}"
    exit 1
}
say "Building (the first time takes a few minutes; details in $log)"
build rinceau

name=$(basename -- "$art")
name=${name%.*}
mkdir -p -- "$folder"
folder=$(cd -- "$folder" && pwd)
rinceau=$root/build/release/cli/rinceau
case $art in -*) art=./$art ;; esac
"$rinceau" analyze --print -o "$folder/$name.lsys" "$art"
"$rinceau" render -o "$folder/$name.svg" "$folder/$name.lsys"
"$rinceau" render -o "$folder/$name.png" --width 900 "$folder/$name.lsys"
printf '\nThe grammar:  %s\nIts picture:  %s\n              %s\n' "$folder/$name.lsys" "$folder/$name.svg" "$folder/$name.png"

[ "$editor" = yes ] && [ -n "${DISPLAY-}${WAYLAND_DISPLAY-}" ] || exit 0
say 'Building the editor, and opening it (./run.sh --no-editor does neither)'
build rinceau-editor
# What was asked for is done: a display that does not work is told, and is no failure.
"$rinceau" edit "$art" || true
