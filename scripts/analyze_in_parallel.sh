#!/usr/bin/env bash
# Analyses all drawings of a folder by GNU parallel, in shards; ended in the middle and started again, it goes on.
# scripts/analyze_in_parallel.sh FOLDER OUTPUT [SHARDS]; RINCEAU and JOBS may be set: the program, shards at a time.
set -euo pipefail
if [ $# -lt 2 ] || [ $# -gt 3 ]; then
    printf 'Usage: %s FOLDER OUTPUT [SHARDS]\n' "$0" >&2
    exit 2
fi
command -v parallel >/dev/null || { printf 'GNU parallel is missing: apt install parallel\n' >&2; exit 2; }
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
rinceau=${RINCEAU:-$root/build/release/cli/rinceau}
folder=$1 output=$2 shards=${3:-64}
jobs=${JOBS:-$(nproc)}
# A shard with drawings at fault has status 5, and the last command says which they are.
parallel --will-cite --jobs "$jobs" \
    "$rinceau" analyze "$folder" -o "$output" --jobs 1 --resume --shard "{}/$shards" --report "$output/part-{}.html" \
    ::: $(seq "$shards") || true
exec "$rinceau" analyze "$folder" -o "$output" --jobs "$jobs" --resume --report "$output/sheet.html" --report "$output/table.csv"
