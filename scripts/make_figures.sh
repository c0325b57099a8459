#!/usr/bin/env bash
# Runs the commands of docs/gallery.md, docs/gallery_growth.md and docs/gallery_surface.md and puts what they make where it belongs:
# grammars and drawings of the paper's figures into samples/figures, pictures into docs/images/gallery, growth and surface; those of
# surfaces with a palette (shrink_picture.py).
#   scripts/make_figures.sh [PROGRAM [surface]]      surface: only those of docs/gallery_surface.md
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
rinceau=${1:-$root/build/release/cli/rinceau}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

work_surface="$work/surface"
/usr/bin/python3 "$root/scripts/run_commands.py" "$rinceau" "$root/docs/gallery_surface.md" "$work_surface"
mkdir -p "$root/docs/images/surface"
rm -f "$root"/docs/images/surface/*
for picture in $(grep -o 'images/surface/[^")]*' "$root/docs/gallery_surface.md" | sort -u); do
  name=$(basename "$picture")
  /usr/bin/python3 "$root/scripts/shrink_picture.py" "$work_surface/$name" "$root/docs/images/surface/$name"
done
[[ ${2:-all} == surface ]] && exit

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
