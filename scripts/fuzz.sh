#!/usr/bin/env bash
# Builds the programs of tests/fuzz and lets them look for inputs that break the readers.
#   scripts/fuzz.sh [SECONDS]    in all, 300 unless told otherwise
# The last line reads "N passed, M failed": kinds of input; the exit status is 0 only if M = 0.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
. scripts/packages.sh
seconds=${1:-300}
[[ $seconds =~ ^[1-9][0-9]*$ ]] || { say "Usage: ./test.sh fuzz [SECONDS]"; exit 2; }
install_packages "${build_packages[@]}" "${fuzz_packages[@]}"

cmake --preset fuzz
cmake --build --preset fuzz --parallel "$(nproc)"

kinds=(svg lsys obj off ply json fgsg)
found=build/fuzz/found
passed=0
failed=0
for kind in "${kinds[@]}"; do
    corpus=build/fuzz/corpus/$kind
    rm -rf "$corpus"
    mkdir -p "$corpus" "$found"
    find samples tests/fuzz/seeds -name "*.$kind" -size -64k -exec cp {} "$corpus" \;
    say "$kind: $(find "$corpus" -type f | wc -l) inputs to begin with"
    log=build/fuzz/$kind.log
    if "build/fuzz/tests/fuzz/${kind}_fuzz" -seed=1 -max_total_time=$(((seconds + ${#kinds[@]} - 1) / ${#kinds[@]})) \
        -max_len=65536 -timeout=10 -rss_limit_mb=2048 -artifact_prefix="$found/$kind-" -print_final_stats=1 \
        "$corpus" >"$log" 2>&1; then
        passed=$((passed + 1))
        say "$kind: $(sed -nE 's/^stat::number_of_executed_units: *//p' "$log") inputs, nothing found"
    else
        failed=$((failed + 1))
        grep -E 'ERROR|runtime error|SUMMARY|Test unit written' "$log" >&2 || tail -n 5 "$log" >&2
    fi
done
printf '%d passed, %d failed\n' "$passed" "$failed"
[ "$failed" -eq 0 ]
