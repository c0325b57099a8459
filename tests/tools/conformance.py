#!/usr/bin/env python3
"""Draws every grammar with every export in the program that the export is for, and compares element by element.

    conformance.py --rinceau PROGRAM [--formats cfdg,svg] [GRAMMAR.lsys ..]

Without grammars: all of samples/. Prints a table, grammar by format, of the largest distance between a point of an element
as the other program draws it and as rinceau does, as a share of the picture's diagonal; what is refused or cannot be run here
is listed below with its reason. Exit status 1 if a distance exceeds its format's limit or an export draws other elements.

A format is a module of readers/, named as in --formats, with
    FORMAT         as in `rinceau export --to FORMAT`
    LIMIT          largest share of the diagonal that is accepted
    missing()      None, or what has to be installed to run it
    read(exported, picture, folder) -> [Element]
                   the elements that the program (or an independent reader) makes of the exported file, in paint order;
                   `folder` is for files of its own
    elements(picture) -> [Element]   optional: what is to be compared with, if it is not picture.elements()
    pairs(exported, picture, folder) -> [(wanted points, found points)]
                   instead of read and elements, where lines and fills are compared (drawn.py)
"""
import argparse
import importlib
import json
import os
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(Path(__file__).resolve().parent))

from readers.picture import Disagreement, Element, Picture, largest_distance  # noqa: E402

SHARED = {"__init__", "picture", "drawn"}  # modules of readers/ that are no format
FORMATS = sorted(module.stem for module in (ROOT / "tests/tools/readers").glob("*.py") if module.stem not in SHARED)


class Refused(Exception):
    """The export says that its format cannot hold the grammar."""


def run_export(program, grammar, name, output):
    done = subprocess.run([program, "export", str(grammar), "--to", name, "-o", str(output)],
                          capture_output=True, text=True, timeout=120)
    if done.returncode == 1:
        raise Refused(done.stderr.strip())
    if done.returncode != 0:
        raise Disagreement(f"export --to {name} ended with status {done.returncode}: {done.stderr.strip()}")
    return [line.removeprefix("note: ") for line in done.stderr.splitlines() if line.startswith("note: ")]


class Result:
    def __init__(self, share=None, elements=0, reason="", failed=False, notes=()):
        self.share, self.elements, self.reason, self.failed, self.notes = share, elements, reason, failed, notes

    def cell(self):
        if self.failed and self.share is None:
            return "FAILED"
        if self.share is None:
            return "refused"
        return f"{self.share:.1e}" + (" !" if self.failed else "")


def compare(program, grammar, reader):
    with tempfile.TemporaryDirectory(prefix="conformance-") as scratch:
        folder = Path(scratch)
        try:
            run_export(program, grammar, "placements", folder / "placements.json")
            picture = Picture(json.loads((folder / "placements.json").read_text()))
            exported = folder / ("picture" + getattr(reader, "ENDING", "." + reader.FORMAT))
            notes = run_export(program, grammar, reader.FORMAT, exported)
            if hasattr(reader, "pairs"):
                pairs = reader.pairs(exported, picture, folder)
                wanted, found = ([Element(pair[side]) for pair in pairs] for side in (0, 1))
            else:
                wanted = reader.elements(picture) if hasattr(reader, "elements") else picture.elements()
                found = reader.read(exported, picture, folder)
            share = largest_distance(wanted, found) / picture.diagonal()
        except Refused as refused:
            return Result(reason=str(refused))
        except Exception as fault:  # a reader that stumbles over a file has found a fault of the file
            return Result(reason=f"{type(fault).__name__}: {fault}", failed=True)
        reason = f"{share:.3g} of the diagonal, more than {reader.LIMIT:g}"
        failed = not share <= reader.LIMIT
        return Result(share, len(wanted), reason if failed else "", failed, notes)


def print_table(grammars, readers, results):
    width = max(len(grammar.stem) for grammar in grammars)
    columns = [max(8, len(reader.NAME)) for reader in readers]
    print(f"{'grammar':{width}}  elements  " + "  ".join(f"{r.NAME:>{c}}" for r, c in zip(readers, columns)))
    for grammar in grammars:
        row = [results[grammar, reader.NAME] for reader in readers]
        count = max((result.elements for result in row), default=0)
        print(f"{grammar.stem:{width}}  {count or '':>8}  " +
              "  ".join(f"{result.cell():>{c}}" for result, c in zip(row, columns)))
    print(f"{'limit':{width}}  {'':>8}  " + "  ".join(f"{r.LIMIT:>{c}.0e}" for r, c in zip(readers, columns)))


def print_reasons(grammars, readers, results):
    for reader in readers:
        for grammar in grammars:
            result = results[grammar, reader.NAME]
            if result.reason:
                print(f"{reader.NAME}, {grammar.stem}: {result.reason}")
    notes = {}
    for reader in readers:
        for grammar in grammars:
            for note in results[grammar, reader.NAME].notes:
                notes.setdefault((reader.NAME, note), []).append(grammar.stem)
    for (name, note), stems in notes.items():
        print(f"{name} notes: {note} ({', '.join(stems)})")


def main():
    parser = argparse.ArgumentParser(description="Compares every export with what its program draws.")
    parser.add_argument("--rinceau", default=str(ROOT / "build/release/cli/rinceau"), help="the program")
    parser.add_argument("--formats", default=",".join(FORMATS), help="some of: " + ",".join(FORMATS))
    parser.add_argument("--require", action="store_true", help="a program that is not installed is a failure")
    parser.add_argument("grammars", nargs="*", type=Path, metavar="GRAMMAR.lsys")
    options = parser.parse_args()
    grammars = options.grammars or sorted((ROOT / "samples").glob("*.lsys"))
    readers, absent = [], {}
    for name in options.formats.split(","):
        reader = importlib.import_module("readers." + name)
        reader.NAME = name
        lack = reader.missing()
        if lack:
            absent[name] = lack
        else:
            readers.append(reader)
    pairs = [(grammar, reader) for grammar in grammars for reader in readers]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        found = pool.map(lambda pair: compare(options.rinceau, *pair), pairs)
        results = {(grammar, reader.NAME): result for (grammar, reader), result in zip(pairs, found)}
    print_table(grammars, readers, results)
    print_reasons(grammars, readers, results)
    for name, lack in absent.items():
        print(f"{name}: not run, {lack}")
    failed = any(result.failed for result in results.values()) or (options.require and absent)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
