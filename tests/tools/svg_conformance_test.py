#!/usr/bin/env python3
"""svg_conformance_test.py PROGRAM ROOT: the conformance table of a handful of our own drawings, and that it notices what
is wrong: programs that write another picture, fail without a word, refuse, break down or never end."""

import pathlib
import subprocess
import sys
import tempfile

HANDFUL = r"^(clip_cuts|gradient_box|markers|mask|pattern|xinclude)\.svg$"
OTHER_PICTURE = "<svg xmlns='http://www.w3.org/2000/svg' width='100' height='100'><path d='M0,0H90V90Z'/></svg>"
STAND_INS = {  # what a program does, after which the word must be said
    "differs": 'echo "%s" > "$4"' % OTHER_PICTURE,
    "not claimed": 'echo "warning: $2:3: 1 XInclude elements are left out" >&2; echo "%s" > "$4"' % OTHER_PICTURE,
    "refused": 'echo "$2:1: not today" >&2; exit 1',
    "CRASH": "kill -SEGV $$",
    "HANG": "while :; do :; done",
}


def table_of(program, suite, pattern, seconds=None):
    tool = pathlib.Path(__file__).resolve().parent / "svg_conformance.py"
    command = [sys.executable, str(tool), str(program), str(suite), "--only", pattern]
    if seconds:
        command += ["--seconds", str(seconds)]
    return subprocess.run(command, capture_output=True, text=True, timeout=300)


def check(wanted, done, text):
    if not wanted:
        sys.exit("%s\n%s%s" % (text, done.stdout, done.stderr))


def main(program, root):
    drawings = pathlib.Path(root) / "tests/svg"
    done = table_of(program, drawings, HANDFUL)
    words = [line[61:72].strip() for line in done.stdout.splitlines() if ".svg " in line]
    check(done.returncode == 0 and words == ["same"] * 6, done, "a drawing of ours does not look the same")
    with tempfile.TemporaryDirectory() as folder:
        for word, body in STAND_INS.items():
            stand_in = pathlib.Path(folder) / "stand_in"
            stand_in.write_text("#!/bin/sh\n%s\n" % body)
            stand_in.chmod(0o755)
            done = table_of(stand_in, drawings, r"^markers\.svg$", seconds=1)
            check(word in done.stdout.splitlines()[0], done, "expected: " + word)
            check(done.returncode == 1, done, "a table without anything that is the same passes")
    print("good")


if __name__ == "__main__":
    main(*sys.argv[1:])
