#!/usr/bin/env bash
# Runs the commands of docs/gallery.md and docs/gallery_growth.md and puts what they make where it belongs: grammars and drawings of
# the paper's figures into samples/figures, pictures into docs/images/gallery and, of growth, docs/images/growth.
#   scripts/make_figures.sh [PROGRAM]
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
rinceau=${1:-$root/build/release/cli/rinceau}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
/usr/bin/python3 "$root/scripts/run_commands.py" "$rinceau" "$root/docs/gallery.md" "$work"
mkdir -p "$root/docs/images/gallery" "$root/samples/figures"
rm -f "$root"/docs/images/gallery/* "$root"/samples/figures/fig*
mv "$work"/fig*.lsys "$work"/fig*.svg "$root/samples/figures/"
mv "$work"/*.svg "$work"/*.png "$root/docs/images/gallery/"

work_growth="$work/growth"
/usr/bin/python3 "$root/scripts/run_commands.py" "$rinceau" "$root/docs/gallery_growth.md" "$work_growth"
mkdir -p "$root/docs/images/growth"
rm -f "$root"/docs/images/growth/*
for picture in $(grep -o 'images/growth/[^")]*' "$root/docs/gallery_growth.md" | sort -u); do
  mv "$work_growth/$(basename "$picture")" "$root/docs/images/growth/"
done
