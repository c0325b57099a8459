#!/usr/bin/env python3
"""corpus_table.py PROGRAM FOLDER [KEEP]: every drawing of a folder there and back (used by tests/corpus.sh)

Analyses each .svg and .svgz, renders its grammar, compares the pictures (compare.py), and prints a line for each and one
for all. With KEEP, the grammars and pictures stay in that folder. Exit status 0 only if every drawing comes back with less
than 0.5 % of its inked pixels differing."""

import json
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

from compare import difference

MOST_PIXELS = 0.5  # per cent
SECONDS = 600
COLUMNS = "%-34s %8s %5s %5s %10s %10s %9s %7s %8s"


def call(command):
    """Runs a command; raises with its last line of complaint if it fails."""
    done = subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=SECONDS)
    if done.returncode != 0:
        lines = done.stderr.strip().splitlines() or ["no message"]
        raise RuntimeError("%s: exit %d: %s" % (command[1], done.returncode, lines[-1]))


def there_and_back(program, drawing, folder):
    """The report of a drawing, with "pixels" (per cent) and "wall" (seconds of analysis) added."""
    base = folder / drawing.stem
    grammar, picture, report = (str(base) + ending for ending in (".lsys", ".svg", ".json"))
    start = time.monotonic()
    call([program, "analyze", str(drawing), "-o", grammar, "--report", report])
    wall = time.monotonic() - start
    call([program, "render", grammar, "-o", picture])
    with open(report, encoding="utf-8") as file:
        found = json.load(file)
    return found | {"pixels": difference(str(drawing), picture), "wall": wall}


def print_row(name, found):
    size = found["size"]
    mark = "" if found["pixels"] < MOST_PIXELS else "  <--"
    print(COLUMNS % (name, found["elements"], len(found["terminals"]), len(found["productions"]), round(size["drawing_bits"]),
                     round(size["grammar_bits"]), "%.1e" % found["error"]["max"], "%.3f" % found["pixels"],
                     "%.2f" % found["wall"]) + mark, flush=True)


def main(program, folder, keep=None):
    drawings = sorted(p for p in pathlib.Path(folder).iterdir() if p.suffix.lower() in (".svg", ".svgz"))
    if not drawings:
        sys.exit("%s: no .svg in it" % folder)
    print(COLUMNS % ("file", "elements", "term.", "rules", "bits", "as rules", "deviation", "pixels%", "seconds"))
    good, ratios = 0, []
    with tempfile.TemporaryDirectory() as scratch:
        kept = pathlib.Path(keep or scratch)
        kept.mkdir(parents=True, exist_ok=True)
        for drawing in drawings:
            try:
                found = there_and_back(program, drawing, kept)
            except (RuntimeError, subprocess.SubprocessError, OSError, ValueError) as error:
                print("%-34s FAILED %s" % (drawing.name, error), flush=True)
                continue
            print_row(drawing.name, found)
            good += found["pixels"] < MOST_PIXELS
            ratios.append(found["size"]["drawing_bits"] / max(1.0, found["size"]["grammar_bits"]))
    middle = statistics.median(ratios) if ratios else 0
    print("%d of %d drawings come back (less than %s %% of inked pixels differ); median of bits before / after: %.2f" %
          (good, len(drawings), MOST_PIXELS, middle))
    return 0 if good == len(drawings) else 1


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
