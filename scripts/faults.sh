#!/usr/bin/env bash
# Every fault with every command that writes a file: what docs/faults.md tells.  scripts/faults.sh [FAULT...]
# FAULT: killed killed_late disk small_disk too_large forbidden stdout_full interrupted memory together batches_together vanished
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
. scripts/packages.sh
install_packages "${build_packages[@]}" python3 util-linux

build=${RINCEAU_BUILD:-build/release}
[ -n "${RINCEAU_BUILD-}" ] || { cmake --preset release >&2; cmake --build --preset release --target rinceau >&2; }
shim=$(mktemp --suffix .so)
trap 'rm -f -- "$shim"' EXIT
"${CXX:-g++}" -std=c++20 -O1 -shared -fPIC -o "$shim" tests/faults/fault_shim.cpp -ldl
/usr/bin/python3 tests/faults/faults_test.py "$build/cli/rinceau" "$shim" "$root" --all "$@"
