#!/usr/bin/env bash
# Makes the site of all pages (docs/README.md) and of the interfaces of all headers, and checks every link in it.
# scripts/make_docs.sh [FOLDER]: without one, build/docs/site. Begin with FOLDER/index.html.
set -euo pipefail
case ${1-} in
    -h | --help) printf 'Usage: %s [FOLDER]\n' "$0"; exit 0 ;;
    -*) printf 'Usage: %s [FOLDER]\n' "$0" >&2; exit 2 ;;
esac
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
. "$root/scripts/packages.sh"
install_packages "${docs_packages[@]}"
python=/usr/bin/python3 # the system's, which the packages are for
[ -x "$python" ] || python=python3

mkdir -p "${1:-$root/build/docs/site}"
site=$(cd -- "${1:-$root/build/docs/site}" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
version=$(sed -nE 's/^project\(rinceau VERSION ([0-9.]+).*/\1/p' "$root/CMakeLists.txt")

say "The interfaces"
mkdir "$work/api"
sed "s|@VERSION@|$version|; s|@OUTPUT@|$work|; s|@ROOT@|$root|" "$root/docs/site/Doxyfile.in" > "$work/Doxyfile"
(cd "$root" && doxygen "$work/Doxyfile")

say "The pages"
RINCEAU_TAGS=$work/api/rinceau.tag "$python" -m sphinx -q -n -W --keep-going -b html -c "$root/docs/site" -d "$work/doctrees" \
    "$root" "$work/pages"
mv "$work/api" "$work/pages/api"

say "The links"
"$python" "$root/docs/site/check_site.py" "$work/pages"

# What a site of before has left in the folder goes, and only that.
for name in "$work"/pages/*; do rm -rf "${site:?}/${name##*/}"; done
mv "$work"/pages/* "$site"
say "$site/index.html"
