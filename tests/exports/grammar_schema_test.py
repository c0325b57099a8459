#!/usr/bin/env python3
"""grammar_schema_test.py RINCEAU PROJECT: JSON grammars are as their schema says, and every command reads them."""
import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import jsonschema

rinceau, project = sys.argv[1], Path(sys.argv[2])
schema = json.loads((project / "docs/grammar.schema.json").read_text())
validator = jsonschema.Draft202012Validator(schema)
validator.check_schema(schema)


def run(*arguments, status=0):
    done = subprocess.run([rinceau, *map(str, arguments)], capture_output=True, timeout=60)
    assert done.returncode == status, (arguments, done.stderr)
    return done.stdout


with tempfile.TemporaryDirectory() as scratch:
    name = Path(scratch) / "grammar.json"
    for sample in sorted((project / "samples").glob("*.lsys")):  # which may use one another
        shutil.copy(sample, scratch)
    for sample in sorted(Path(scratch).glob("*.lsys")):
        name.write_bytes(run("export", sample, "--to", "json"))
        validator.validate(json.loads(name.read_text()))
        assert run("export", name, "--to", "lsys") == run("export", sample, "--to", "lsys"), sample
        assert run("render", name) == run("render", sample), sample
        assert run("derive", name) == run("derive", sample), sample
        assert b"good" in run("check", name)

    document = json.loads(name.read_text())
    for damage in ({"version": 2}, {"axiom": "A"}, {"more": 1}, {"styles": [{"number": 1, "fill": {"gradient": "linear"}}]}):
        wrong = {**document, **damage}
        assert not validator.is_valid(wrong), damage
        name.write_text(json.dumps(wrong))
        run("render", name, status=1)
