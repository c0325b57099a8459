#!/usr/bin/env bash
# Reads every source of the product with clang-tidy (.clang-tidy), eight sources as one, as many of these at a time as there
# are processors.
#   scripts/tidy.sh [PATTERN]    only groups with a path in which the regular expression is found, such as analyzer/
# Prints what clang-tidy says, once each. The last line reads "N sources, M warnings"; the exit status is 0 only if M = 0.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
. scripts/packages.sh
install_packages "${build_packages[@]}" "${tidy_packages[@]}"
cmake --preset tidy >/dev/null
export pattern=${1-.}

log=build/tidy/log
rm -rf "$log"
mkdir -p "$log"
# The paths of the sources that are compiled as one in FILE: its own, unless CMake wrote it.
sources_of() {  # FILE
    case $1 in
        */Unity/*) sed -nE 's/^#include "(.*\.cpp)"$/\1/p' "$1" ;;
        *) printf '%s\n' "$1" ;;
    esac | sed "s|^$PWD/||"
}
read_one() {  # FILE
    local own=build/tidy/log/${1//\//_}
    sources_of "$1" | grep -qE -- "$pattern" || return 0
    sources_of "$1" >"$own.sources"
    clang-tidy -p build/tidy --quiet "$1" >"$own.said" 2>"$own.errors" || cat "$own.errors" >>"$own.said"
}
export -f read_one sources_of
python3 -c 'import json; print("\n".join(row["file"] for row in json.load(open("build/tidy/compile_commands.json"))))' |
    xargs -P "$(nproc)" -I{} bash -c 'read_one {}'
find "$log" -name '*.said' | sort | xargs -r cat | sed "s|$PWD/||g" >build/tidy/said
awk '/: (warning|error): / { shown = !seen[$0]++ } shown' build/tidy/said
warnings=$({ grep -E ': (warning|error): ' build/tidy/said || true; } | sort -u | wc -l)
printf '%d sources, %d warnings\n' "$(find "$log" -name '*.sources' | xargs -r cat | wc -l)" "$warnings"
[ "$warnings" -eq 0 ]
