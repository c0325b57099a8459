#!/usr/bin/env bash
# Reads every source of the product with clang-tidy (.clang-tidy), as many at a time as there are processors.
#   scripts/tidy.sh [PATTERN]    only paths in which the regular expression is found, such as analyzer/
# The last line reads "N clean, M not"; the exit status is 0 only if M = 0.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
. scripts/packages.sh
install_packages "${build_packages[@]}" "${tidy_packages[@]}"
cmake --preset tidy >/dev/null

log=build/tidy/log
rm -rf "$log"
mkdir -p "$log"
read_one() {  # SOURCE
    local own=$1.txt
    own=build/tidy/log/${own//\//_}
    clang-tidy -p build/tidy --quiet --warnings-as-errors='*' "$1" >"$own" 2>/dev/null && rm "$own" || cat "$own"
}
export -f read_one
git ls-files '*.cpp' ':!tests' ':!docs' | { grep -E -- "${1-.}" || true; } |
    tee build/tidy/sources | xargs -P "$(nproc)" -I{} bash -c 'read_one {}'
faulty=$(find "$log" -type f | wc -l)
printf '%d clean, %d not\n' $(($(wc -l <build/tidy/sources) - faulty)) "$faulty"
[ "$faulty" -eq 0 ]
