#!/usr/bin/env bash
# Builds the programs of tests/fuzz and lets them look for inputs that break the readers (docs/fuzzing.md).
#   scripts/fuzz.sh [--keep] [SECONDS [KIND...]]
# SECONDS in all, 300 unless told otherwise, shared equally by the kinds of input that are named, or by all. With --keep they
# go on with what they found worth keeping in earlier runs; else they begin with samples, seeds and the same random numbers.
# Prints a table; the exit status is 1 if anything was found, which then lies in build/fuzz/found.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
. scripts/packages.sh

all_kinds=(svg path css lsys grammar export laid fgsg obj off ply png field project analyze)
usage() { say "Usage: ./test.sh fuzz [--keep] [SECONDS [KIND...]]   with KIND of: ${all_kinds[*]}"; exit 2; }
keep=
[ "${1-}" != --keep ] || { keep=yes; shift; }
seconds=${1:-300}
[[ $seconds =~ ^[1-9][0-9]*$ ]] || usage
[ $# -eq 0 ] || shift
kinds=("${@:-${all_kinds[@]}}")
for kind in "${kinds[@]}"; do [[ " ${all_kinds[*]} " == *" $kind "* ]] || usage; done
share=$(((seconds + ${#kinds[@]} - 1) / ${#kinds[@]}))

# Longer inputs break nothing that short ones do not, and take longer to change; an analysis of many elements takes its time.
longest_of() { case $1 in analyze) printf 3072 ;; *) printf 16384 ;; esac; }

# Files below a folder by the ending of their names, into the corpus $corpus.
take_files() {
    local ending=$1 name
    shift
    find "$@" -name "*$ending" -type f -size -"${longest}c" | sort | while IFS= read -r name; do
        cp "$name" "$corpus/$(tr / _ <<<"$name")"
    done
}

# The values of attributes in the samples, one a file: path data, transforms, paints.
take_attributes() {
    local value n=0
    grep -rhoE ' (d|transform|fill)="[^"]*"' samples tests/svg --include='*.svg' | awk 'length($0) < 400' | sort -u |
        awk 'NR % 16 == 1' | sed -E 's/^[^"]*"//; s/"$//' | while IFS= read -r value; do
            n=$((n + 1))
            printf '%s' "$value" >"$corpus/attribute$n"
        done
}

take_seeds() {
    case $1 in
        svg | analyze) take_files .svg samples tests/svg ;;
        path) take_attributes ;;
        lsys | export | laid) take_files .lsys samples ;;
        fgsg) take_files .fgsg samples ;;
        obj) take_files .obj samples ;;
        png) take_files .png samples tests ;;
        field) take_files design.json samples ;;
    esac
    [ ! -d "tests/fuzz/seeds/$1" ] || take_files '' "tests/fuzz/seeds/$1"
}

# Where kinds share a language they share its words.
dictionary() {
    case $1 in
        analyze) printf svg ;;
        export | laid) printf lsys ;;
        *) printf '%s' "$1" ;;
    esac
}

# The last number behind a word in libFuzzer's log, 0 if there is none.
last_number() { { grep -oE "$1 *[0-9]+" "$log" || true; } | tail -n 1 | grep -oE '[0-9]+$' || printf 0; }

run_kind() {
    local kind=$1 status=0 begin=$SECONDS words seed options findings edges
    longest=$(longest_of "$kind")
    corpus=build/fuzz/corpus/$kind
    log=build/fuzz/$kind.log
    [ -n "$keep" ] || rm -rf "$corpus"
    mkdir -p "$corpus" build/fuzz/found
    take_seeds "$kind"
    words=tests/fuzz/dictionaries/$(dictionary "$kind").dict
    seed=1
    [ -z "$keep" ] || seed=$RANDOM
    options=(-seed="$seed" -max_total_time="$share" -max_len="$longest" -timeout=10 -rss_limit_mb=2048 -report_slow_units=5
        -artifact_prefix="build/fuzz/found/$kind-" -print_final_stats=1)
    [ ! -f "$words" ] || options+=(-dict="$words")
    touch "$log.begin"
    "build/fuzz/tests/fuzz/${kind}_fuzz" "${options[@]}" "$corpus" >"$log" 2>&1 || status=$?
    findings=$(find build/fuzz/found -name "$kind-*" -newer "$log.begin" | wc -l)
    [ "$status" -eq 0 ] || [ "$findings" -gt 0 ] || findings=1
    edges=$(sed -nE 's/.*\(([0-9]+) inline 8-bit counters\).*/\1/p' "$log" | head -n 1)
    printf '%-8s %8d %12d %9d %8d %8d %8d %7d %9d\n' "$kind" $((SECONDS - begin)) "$(last_number 'number_of_executed_units:')" \
        "$(last_number 'average_exec_per_sec:')" "$(last_number 'cov:')" "${edges:-0}" "$(last_number 'ft:')" \
        "$(find "$corpus" -type f | wc -l)" "$findings"
    [ "$findings" -eq 0 ] || { grep -E 'ERROR|runtime error|SUMMARY|Test unit written|what\(\)' "$log" || tail -n 5 "$log"; } >&2
    found_in_all=$((found_in_all + findings))
}

install_packages "${build_packages[@]}" "${fuzz_packages[@]}"
cmake --preset fuzz
cmake --build --preset fuzz --parallel "$(nproc)" --target "${kinds[@]/%/_fuzz}"

found_in_all=0
printf '%-8s %8s %12s %9s %8s %8s %8s %7s %9s\n' kind seconds executions a_second edges of features corpus findings
for kind in "${kinds[@]}"; do run_kind "$kind"; done
if [ "$found_in_all" -gt 0 ]; then
    say "Inputs that break something are in build/fuzz/found; build/fuzz/tests/fuzz/KIND_fuzz FILE takes one again."
    exit 1
fi
