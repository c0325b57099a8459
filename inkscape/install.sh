#!/usr/bin/env bash
# Puts Rinceau into Inkscape's menu Extensions, or takes it out again.
set -euo pipefail

usage() {
    cat <<'TEXT'
Usage: inkscape/install.sh [--system] [--program FILE] [--uninstall]

Installs the commands of the menu Extensions > Rinceau for the user who calls it: into the folder that Inkscape names,
or that INKSCAPE_PROFILE_DIR names. Inkscape shows them when it is started the next time.
  --system        for all users of the machine
  --program FILE  the rinceau to use; without it, the one that was built here, else the one in the PATH, else it is built now
  --uninstall     removes them
TEXT
}

here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
root=$(dirname -- "$here")
system=no program= uninstall=no
while [ $# -gt 0 ]; do
    case $1 in
        -h | --help) usage; exit 0 ;;
        --system) system=yes; shift ;;
        --program) [ $# -ge 2 ] || { usage >&2; exit 2; }; program=$2; shift 2 ;;
        --uninstall) uninstall=yes; shift ;;
        *) usage >&2; exit 2 ;;
    esac
done

data_folder() {
    if [ "$system" = yes ]; then
        inkscape --system-data-directory 2>/dev/null || printf '%s\n' /usr/share/inkscape
    elif [ -n "${INKSCAPE_PROFILE_DIR:-}" ]; then
        printf '%s\n' "$INKSCAPE_PROFILE_DIR"
    else
        inkscape --user-data-directory 2>/dev/null || printf '%s\n' "${XDG_CONFIG_HOME:-$HOME/.config}/inkscape"
    fi
}
target=$(data_folder)/extensions/rinceau

if [ "$uninstall" = yes ]; then
    [ -d "$target" ] || { printf 'Nothing is installed in %s\n' "$target"; exit 0; }
    rm -f -- "$target"/*.inx "$target/rinceau-inkscape"
    rmdir -- "$target"
    printf 'Removed %s\n' "$target"
    exit 0
fi

built=$root/build/release/cli/rinceau
if [ -z "$program" ] && [ ! -x "$built" ]; then
    program=$(command -v rinceau || true)
    if [ -z "$program" ]; then
        # run.sh installs what the build needs, and builds
        "$root/run.sh" --no-editor -o "$root/out" >/dev/null
    fi
fi
program=${program:-$built}
[ -x "$program" ] || { printf '%s: no such program\n' "$program" >&2; exit 1; }
program=$(cd -- "$(dirname -- "$program")" && pwd)/$(basename -- "$program")

mkdir -p -- "$target"
cp -- "$here"/*.inx "$target/"
# Built programs move and vanish with their folder; an installed one stays, and is updated in its place.
rm -f -- "$target/rinceau-inkscape"
case $program in
    /usr/bin/* | /usr/local/bin/* | /opt/*) ln -s -- "$program" "$target/rinceau-inkscape" ;;
    *) cp -- "$program" "$target/rinceau-inkscape" ;;
esac
chmod -R a+rX -- "$target"
printf 'Installed from %s into %s\nInkscape shows the commands in Extensions > Rinceau when it is started the next time.\n' \
    "$program" "$target"
