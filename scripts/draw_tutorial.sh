#!/usr/bin/env bash
# Types what docs/tutorial.md says, and takes the pictures out.  draw_tutorial.sh [RINCEAU [FOLDER FOR THE PICTURES]]
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
rinceau=$(realpath -- "${1:-$root/build/release/cli/rinceau}")
pictures=${2:-$root/docs/images}
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
mkdir -p -- "$pictures" "$work/bin"
pictures=$(realpath -- "$pictures")
ln -s -- "$rinceau" "$work/bin/rinceau"
ln -s -- "$root/samples" "$work/samples"
cd "$work"
PATH=$work/bin:$PATH bash -euo pipefail -c "$(sed -n '/^```sh$/,/^```$/{/^```/!p}' "$root/docs/tutorial.md")" >"$work/said" 2>&1 ||
    { cat "$work/said" >&2; exit 1; }
mv -- tutorial_*.png "$pictures/"
