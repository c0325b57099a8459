#!/usr/bin/env bash
# Draws the pictures of README.md from the samples' grammars.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
rinceau=${1:-$root/build/release/cli/rinceau}
mkdir -p "$root/docs/images"
for name in mandala facade vine tiles spiral snowflake; do
    width=260
    [ "$name" = vine ] && width=75 # as high as the others
    "$rinceau" render "$root/samples/$name.lsys" -o "$root/docs/images/$name.png" --width "$width"
done
