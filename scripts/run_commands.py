#!/usr/bin/env python3
"""run_commands.py PROGRAM DOCUMENT FOLDER: runs the commands that a document shows, one after the other, in a folder that has
the samples: every line of a ```sh block that begins with `rinceau`. Stops at the first that fails."""

import pathlib
import re
import shlex
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent


def commands(document):
    """The words of every command, without the program's name."""
    found = []
    for block in re.findall(r"^```sh\n(.*?)^```", document, re.MULTILINE | re.DOTALL):
        for line in block.replace("\\\n", " ").splitlines():
            if line.startswith("rinceau "):
                found.append(shlex.split(re.sub(r"\s#\s.*$", "", line))[1:])
    return found


def run(program, document, folder, wanted=lambda words: True):
    """Runs the commands whose words are wanted; returns them."""
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    samples = folder / "samples"
    if not samples.exists():
        samples.symlink_to(ROOT / "samples")
    lines = [words for words in commands(pathlib.Path(document).read_text(encoding="utf-8")) if wanted(words)]
    for words in lines:
        done = subprocess.run([program, *words], cwd=folder, capture_output=True, text=True, timeout=120)
        if done.returncode != 0:
            sys.exit("rinceau %s\n%s" % (shlex.join(words), done.stderr))
    return lines


if __name__ == "__main__":
    run(str(pathlib.Path(sys.argv[1]).resolve()), *sys.argv[2:])
