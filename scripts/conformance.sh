#!/usr/bin/env bash
# Writes every sample (or the grammars given) in every format, draws it with that format's program, compares element by
# element and prints a table of the largest deviations.  scripts/conformance.sh [RINCEAU] [GRAMMAR.lsys ..]
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
rinceau=$root/build/release/cli/rinceau
if [ $# -gt 0 ] && [[ $1 != *.lsys ]]; then
    rinceau=$1
    shift
fi
python=/usr/bin/python3 # the system's, which the packages are for
[ -x "$python" ] || python=python3
exec "$python" "$root/tests/tools/conformance.py" --rinceau "$rinceau" "$@"
