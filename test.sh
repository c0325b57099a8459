#!/usr/bin/env bash
# Installs what the tests need, builds everything with warnings as errors, runs every test.
# The last line reads "N passed, M failed"; the exit status is 0 only if M = 0.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
cd "$root"
. scripts/packages.sh
usage() {
    cat <<'END'
Usage: ./test.sh [MODE]
  --sanitize            all tests, by clang, under the address and undefined-behaviour sanitizers
  --thread              all tests, by clang, under the thread sanitizer
  coverage [FILE.html]  which share of the core's lines the tests run; the page shows the lines
  tidy [PATTERN]        reads the sources, or those whose path matches, with clang-tidy
  fuzz [SECONDS]        looks for inputs that break the readers, instead; 300 seconds unless told otherwise
  package               makes the packages for Debian and tests those, instead
END
}

preset=dev
case ${1-} in
    '') ;;
    --sanitize) preset=sanitize ;;
    --thread) preset=thread ;;
    coverage) exec scripts/coverage.sh "${@:2}" ;;
    tidy) exec scripts/tidy.sh "${@:2}" ;;
    fuzz) exec scripts/fuzz.sh "${@:2}" ;;
    package) exec tests/package/package.sh ;;
    -h | --help) usage; exit 0 ;;
    *) usage >&2; exit 2 ;;
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
