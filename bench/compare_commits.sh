#!/usr/bin/env bash
# Measures two commits in turn, A B A B .., on the machine as it is, and says what is worse. Usage:
#     bench/compare_commits.sh A B [--rounds N] [-- OPTIONS OF bench/run.py]
# Both are built (Release) in worktrees of a temporary folder. The measuring scripts are those of this tree, so that commits
# that have none, or older ones, can be compared; kernels are measured if both commits have them.
set -euo pipefail

usage() { sed -n '2,5s/^# \{0,1\}//p' "$0" >&2; exit 2; }
[ $# -ge 2 ] || usage
first=$1 second=$2 rounds=2
shift 2
while [ $# -gt 0 ]; do
    case $1 in
        --rounds) [ $# -ge 2 ] || usage; rounds=$2; shift 2 ;;
        --) shift; break ;;
        *) usage ;;
    esac
done

here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
root=$(git -C "$here" rev-parse --show-toplevel)
folder=$(mktemp -d)
cleanup() {
    for side in a b; do git -C "$root" worktree remove --force "$folder/$side" 2>/dev/null || true; done
    rm -rf "$folder"
}
trap cleanup EXIT

parts=commands,kernels
build() { # side commit
    git -C "$root" worktree add --quiet --detach "$folder/$1" "$2"
    local bench=OFF
    if [ -d "$folder/$1/bench/kernels" ]; then bench=ON; else parts=commands; fi
    cmake -S "$folder/$1" -B "$folder/$1/build" -G Ninja -D CMAKE_BUILD_TYPE=Release -D RINCEAU_BUILD_TESTS=OFF \
        -D RINCEAU_BUILD_EDITOR=OFF -D "RINCEAU_BUILD_BENCH=$bench" -D CMAKE_CXX_COMPILER_LAUNCHER="${RINCEAU_LAUNCHER-}" >/dev/null
    if [ "$bench" = ON ]; then ninja -C "$folder/$1/build" rinceau kernels >&2; else ninja -C "$folder/$1/build" rinceau >&2; fi
}
build a "$first"
build b "$second"

# One run at a time, in turn: what changes on the machine meanwhile meets both.
for round in $(seq "$rounds"); do
    for side in a b; do
        "$here/run.py" "$folder/$side/build" --only "$parts" --runs 1 --json "$folder/$side.$round.json" "$@" >/dev/null
    done
done
for side in a b; do
    python3 "$here/join_runs.py" "$folder/$side.json" "$folder/$side".[0-9]*.json --tree "$folder/$side"
done
"$here/compare.py" "$folder/a.json" "$folder/b.json"
