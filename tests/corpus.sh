#!/usr/bin/env bash
# Every drawing of a folder there and back: how much was found, how exact it is, how long it took.
set -euo pipefail

usage='Usage: tests/corpus.sh FOLDER [KEEP]
  FOLDER  a folder of .svg files
  KEEP    a folder for the grammars, reports and pictures; without it they are thrown away
Builds the release program, then prints for each drawing: file, elements, terminals, rules, bits of the drawing and of the
grammar, largest deviation (share of the diagonal), per cent of inked pixels that differ, seconds. Exit status 0 only if
every drawing comes back with less than 0.5 % of its inked pixels differing.'
case ${1-} in -h | --help) printf '%s\n' "$usage"; exit 0 ;; esac
[ $# -ge 1 ] && [ $# -le 2 ] || { printf '%s\n' "$usage" >&2; exit 2; }

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
. "$root/scripts/packages.sh"
install_packages "${build_packages[@]}" "${test_packages[@]}"
(cd "$root" && cmake --preset release && cmake --build --preset release --parallel "$(nproc)") >&2
python=/usr/bin/python3 # the one that the packages are for
[ -x "$python" ] || python=python3
PYTHONDONTWRITEBYTECODE=1 "$python" "$root/tests/tools/corpus_table.py" "$root/build/release/cli/rinceau" "$@"
