#!/usr/bin/env python3
"""conformance_test.py RINCEAU PROJECT: all samples and grammars drawn at random in every format, and a wrong file is found."""
import json
import subprocess
import sys
import tempfile
from pathlib import Path

rinceau, project = sys.argv[1], Path(sys.argv[2])
tools = project / "tests/tools"
sys.path.insert(0, str(tools))
from readers.picture import Disagreement, Picture, largest_distance  # noqa: E402


def run(*arguments):
    return subprocess.run([sys.executable, *map(str, arguments)], capture_output=True, text=True, timeout=900)


def every_sample():
    done = run(tools / "conformance.py", "--rinceau", rinceau, "--require")
    print(done.stdout, done.stderr)
    assert done.returncode == 0
    assert len(done.stdout.splitlines()) > len(list((project / "samples").glob("*.lsys")))


def grammars_at_random(folder, count):
    assert run(tools / "random_rules.py", folder, count, 100).returncode == 0
    done = run(tools / "conformance.py", "--rinceau", rinceau, "--require", *sorted(folder.glob("*.lsys")))
    print(done.stdout, done.stderr)
    assert done.returncode == 0


def a_wrong_file_is_found(folder):
    """The comparison itself: a number changed, two elements swapped, one lost."""
    subprocess.run([rinceau, "export", str(project / "samples/rosette.lsys"), "--to", "placements", "-o", folder / "p.json"],
                   check=True)
    document = json.loads((folder / "p.json").read_text())
    wanted = Picture(document).elements()
    assert largest_distance(wanted, Picture(document).elements()) == 0
    document["placements"][3]["matrix"][4] += 0.5
    assert abs(largest_distance(wanted, Picture(document).elements()) - 0.5) < 1e-9
    for damage in (lambda places: places.pop(), lambda places: places.insert(0, places.pop())):
        damage(document["placements"])
        try:
            assert largest_distance(wanted, Picture(document).elements()) > 1
        except Disagreement:
            pass


with tempfile.TemporaryDirectory() as scratch:
    a_wrong_file_is_found(Path(scratch))
    grammars_at_random(Path(scratch) / "random", 10)
    every_sample()
