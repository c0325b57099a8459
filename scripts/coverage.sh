#!/usr/bin/env bash
# Builds with counters, runs every test, and prints which share of the core's lines the tests run, for each folder.
#   scripts/coverage.sh [FILE.html]    the page shows every line
# The exit status is 0 only if all tests pass and the share of the whole is at least 90 %.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
page=${1:+$(realpath -m -- "$1")}
cd "$root"
. scripts/packages.sh
install_packages "${build_packages[@]}" "${test_packages[@]}" "${coverage_packages[@]}"
core='(geometry|scene|lsystem|analyzer|exports|growth|files)/'
build=build/coverage

cmake --preset coverage
cmake --build --preset coverage --parallel "$(nproc)"
find "$build" -name '*.gcda' -delete
status=0
ctest --preset coverage --parallel "$(nproc)" >"$build/test.log" 2>&1 || status=$?
grep -E '^[0-9]+% tests passed|\(Failed\)|\(Timeout\)' "$build/test.log" >&2

gcovr --root . --object-directory "$build" --filter "$core" --exclude-unreachable-branches -j "$(nproc)" \
    --json-summary "$build/coverage.json" ${page:+--html-details "$page"} "$build" >/dev/null
python3 scripts/coverage_table.py "$build/coverage.json" 90 || status=1
exit "$status"
