#!/usr/bin/env bash
# Runs `rinceau normalize` on every drawing of the SVG test suite in Debian's librsvg2-tests (or another folder laid out like
# it), compares the pictures, and prints a line for each drawing and a table of rates.
#     scripts/svg_conformance.sh [RINCEAU] [SUITE] [--only PATTERN] [--keep FOLDER]
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
rinceau=$root/build/release/cli/rinceau
suite=/usr/libexec/installed-tests/RSVG/fixtures
if [ $# -gt 0 ] && [[ $1 != -* ]] && [ ! -d "$1" ]; then
    rinceau=$1
    shift
fi
if [ $# -gt 0 ] && [[ $1 != -* ]]; then
    suite=$1
    shift
else
    . "$root/scripts/packages.sh"
    install_packages librsvg2-tests librsvg2-bin python3 python3-numpy python3-pil
fi
[ -x "$rinceau" ] || { echo "$rinceau is no program: build it, or name one" >&2; exit 2; }
[ -d "$suite" ] || { echo "$suite is no folder: install librsvg2-tests, or name the folder of a test suite" >&2; exit 2; }
python=/usr/bin/python3 # the system's, which the packages are for
[ -x "$python" ] || python=python3
PYTHONDONTWRITEBYTECODE=1 exec "$python" "$root/tests/tools/svg_conformance.py" "$rinceau" "$suite" "$@"
