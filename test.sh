#!/usr/bin/env bash
# Installs what the tests need, builds everything with warnings as errors, runs every test.
# The last line reads "N passed, M failed"; the exit status is 0 only if M = 0.
set -euo pipefail
usage='Usage: ./test.sh [--sanitize | --thread | coverage [FILE.html] | tidy [PATTERN] | package]'
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
cd "$root"
. scripts/packages.sh

preset=dev
case ${1-} in
    '') ;;
    --sanitize) preset=sanitize ;;
    --thread) preset=thread ;;
    coverage) exec scripts/coverage.sh "${@:2}" ;;
    tidy) exec scripts/tidy.sh "${@:2}" ;;
    package) exec tests/package/package.sh ;;
    -h | --help)
        cat <<END
$usage
  --sanitize  by clang, under the address and undefined-behaviour sanitizers
  --thread    by clang, under the thread sanitizer
  coverage    which share of the core's lines the tests run; FILE.html shows the lines
  tidy        reads the sources, or those whose path matches, with clang-tidy
  package     makes the packages for Debian and tests those
END
        exit 0 ;;
    *) say "$usage"; exit 2 ;;
esac
[ "$preset" = dev ] || test_packages+=("${sanitize_packages[@]}")
install_packages "${build_packages[@]}" "${test_packages[@]}"

cmake --preset "$preset"
cmake --build --preset "$preset" --parallel "$(nproc)"

log=build/$preset/test.log
status=0
ctest --preset "$preset" --parallel "$(nproc)" 2>&1 | tee "$log" || status=$?

# "97% tests passed, 2 tests failed out of 80"
summary=$(grep -E '^[0-9]+% tests passed, [0-9]+ tests? failed out of [0-9]+' "$log" | tail -n 1) ||
    { say "No test ran"; exit 1; }
failed=$(sed -E 's/^[0-9]+% tests passed, ([0-9]+) tests? failed.*/\1/' <<<"$summary")
total=$(sed -E 's/.* out of ([0-9]+).*/\1/' <<<"$summary")
printf '%d passed, %d failed\n' $((total - failed)) "$failed"
[ "$failed" -eq 0 ] && exit "$status"
exit 1
