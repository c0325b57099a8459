#!/usr/bin/env bash
# ./test.sh package: builds the packages for Debian, installs and removes them in a folder of their own, and reads them with lintian.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)
cd "$root"
. scripts/packages.sh
install_packages "${build_packages[@]}" "${package_packages[@]}"
cmake --workflow --preset package
exec python3 tests/package/deb_test.py build/package
