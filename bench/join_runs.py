#!/usr/bin/env python3
"""Joins files of bench/run.py --json of one program: join_runs.py OUT FILES.. [--tree FOLDER]. The runs of each figure stand
together; --tree names the commit of another tree than that of the scripts."""

import argparse
import json
from pathlib import Path

from measures import machine
from measures.figures import key


def joined(many):
    """The first file's figures with the runs of all."""
    runs = {}
    for kept in many:
        for one in kept["figures"]:
            runs.setdefault(key(one), []).extend(one["runs"])
    return {**many[0], "figures": [{**one, "runs": runs[key(one)]} for one in many[0]["figures"]]}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("out", type=Path)
    parser.add_argument("files", type=Path, nargs="+")
    parser.add_argument("--tree", type=Path)
    options = parser.parse_args()
    result = joined([json.loads(file.read_text()) for file in options.files])
    if options.tree:
        result["machine"] = {**result["machine"], "commit": machine.commit(options.tree)}
    options.out.write_text(json.dumps(result, indent=1) + "\n")


if __name__ == "__main__":
    main()
