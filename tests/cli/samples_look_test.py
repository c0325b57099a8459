#!/usr/bin/env python3
"""samples_look_test.py PROGRAM SOURCE_FOLDER: every sample, analysed and drawn again, looks as before (tools/compare.py)."""

import pathlib
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "tools"))
from compare import difference  # noqa: E402

MOST_PIXELS = 0.1  # per cent of the inked pixels


def main(program, source):
    faults = []
    with tempfile.TemporaryDirectory() as folder:
        grammar, again = (str(pathlib.Path(folder) / name) for name in ("rules.lsys", "again.svg"))
        for drawing in sorted((pathlib.Path(source) / "samples").glob("*.svg")):
            subprocess.run([program, "analyze", str(drawing), "-o", grammar], check=True, capture_output=True)
            subprocess.run([program, "render", grammar, "-o", again], check=True, capture_output=True)
            pixels = difference(str(drawing), again)
            print("%-28s %.3f %%" % (drawing.name, pixels))
            if pixels > MOST_PIXELS:
                faults.append("%s: %.3f %% of the inked pixels differ" % (drawing.name, pixels))
    sys.exit("\n".join(faults) or 0)


if __name__ == "__main__":
    main(*sys.argv[1:])
