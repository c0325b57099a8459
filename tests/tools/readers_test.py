#!/usr/bin/env python3
"""The readers of exports notice it when a file draws something else: numbers of it are changed, one at a time."""
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(Path(__file__).resolve().parent))

from readers import cpfg, fractint, houdini, lpy  # noqa: E402
from readers.picture import Disagreement, Element, Picture, largest_distance  # noqa: E402

BEGIN = {"lpy": "from openalea", "cpfg": "axiom:", "houdini": "Premise:", "fractint": "Axiom"}
WITHOUT_EFFECT = re.compile(r"maximum depth|derivation length|Generations|rinceau_lines\(")
CHANGES = 5


def accepted(reader, exported, picture, **options):
    try:
        pairs = reader.pairs(exported, picture, exported.parent, **options)
    except (Disagreement, ArithmeticError, LookupError):
        return False
    wanted, found = ([Element(pair[side]) for pair in pairs] for side in (0, 1))
    return largest_distance(wanted, found) <= reader.LIMIT * picture.diagonal()


def numbers_in(text, begin):
    """Places of numbers behind `begin` that mean something: no digits of names."""
    start = text.index(begin)
    for found in re.finditer(r"(?<![\w.])\d+(?:\.\d+)?(?!\w)", text[start:]):
        line_start = text.rfind("\n", 0, start + found.start()) + 1
        line = text[line_start:text.find("\n", start + found.start())]
        if not WITHOUT_EFFECT.search(line) and not line.lstrip().startswith("#"):
            yield start + found.start(), start + found.end()


def check(program, reader, sample, folder):
    exported = folder / ("picture" + reader.ENDING)
    for name, output in ((reader.FORMAT, exported), ("placements", folder / "placements.json")):
        subprocess.run([program, "export", str(ROOT / "samples" / sample), "--to", name, "-o", str(output)],
                       check=True, capture_output=True)
    picture = Picture(json.loads((folder / "placements.json").read_text()))
    assert accepted(reader, exported, picture), f"{reader.FORMAT} of {sample} is not accepted"
    text = exported.read_text()
    places = list(numbers_in(text, BEGIN[reader.FORMAT]))
    assert len(places) > 20
    missed = []
    for begin, end in places[::max(1, len(places) // CHANGES)]:
        value = float(text[begin:end])
        if value in (0, 1, 180):  # weights of points, depths, half turns either way
            continue
        exported.write_text(text[:begin] + f"{value * 1.1 + 1:.6f}" + text[end:])
        if accepted(reader, exported, picture):
            missed.append(text[max(0, begin - 30):end + 10])
    assert not missed, f"{reader.FORMAT} of {sample}: a changed number is not noticed: {missed}"


def main():
    program = sys.argv[1]
    for reader in (lpy, cpfg, houdini, fractint):
        for sample in ("bricks.lsys", "snowflake.lsys"):
            with tempfile.TemporaryDirectory(prefix="readers-") as folder:
                check(program, reader, sample, Path(folder))
    print("good")


if __name__ == "__main__":
    main()
