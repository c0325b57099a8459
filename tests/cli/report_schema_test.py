#!/usr/bin/env python3
"""report_schema_test.py PROGRAM SOURCE_FOLDER: the reports of all samples are as docs/report.schema.json says, those of
arranging as docs/arrange_report.schema.json, of many drawings as docs/batch_report.schema.json, of packing as
docs/pack_report.schema.json and of growing on surfaces as docs/grow_report.schema.json says."""

import json
import pathlib
import subprocess
import sys
import tempfile

import jsonschema


def report_of(program, drawing, folder):
    name = pathlib.Path(folder) / "report.json"
    subprocess.run([program, "analyze", str(drawing), "--report", str(name)], check=True, capture_output=True)
    return json.loads(name.read_text(encoding="utf-8"))


def main(program, source):
    source = pathlib.Path(source)
    schema = json.loads((source / "docs" / "report.schema.json").read_text(encoding="utf-8"))
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    drawings = sorted((source / "samples").glob("*.svg"))
    faults = [] if drawings else ["no samples"]
    with tempfile.TemporaryDirectory() as folder:
        for drawing in drawings:
            report = report_of(program, drawing, folder)
            faults += ["%s: %s" % (drawing.name, error.message) for error in validator.iter_errors(report)]
            if report["seconds"]["total"] < report["seconds"]["import"]:
                faults.append("%s: the import takes longer than the whole" % drawing.name)
            if sum(t["instances"] for t in report["terminals"]) != report["elements"]:
                faults.append("%s: the terminals' instances are not the elements" % drawing.name)
    faults += unable_to_refuse(schema, validator, report)
    faults += batch_faults(program, source)
    faults += arrange_faults(program, source)
    faults += pack_faults(program, source)
    faults += grow_faults(program, source)
    sys.exit("\n".join(faults) or 0)


def unable_to_refuse(schema, validator, report):
    return ["the schema lets '%s' be left out" % key for key in schema["required"]
            if validator.is_valid({k: v for k, v in report.items() if k != key})]


def batch_faults(program, source):
    schema = json.loads((source / "docs" / "batch_report.schema.json").read_text(encoding="utf-8"))
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    with tempfile.TemporaryDirectory() as folder:
        name = pathlib.Path(folder) / "report.json"
        samples = [str(source / "samples" / each) for each in ("rosette.svg", "tiles.svg", "missing.svg")]
        run = subprocess.run([program, "analyze", *samples, "-o", str(pathlib.Path(folder) / "out"), "--report", str(name)],
                             capture_output=True)
        report = json.loads(name.read_text(encoding="utf-8"))
    faults = ["batch: %s" % error.message for error in validator.iter_errors(report)]
    if (run.returncode, report["drawings"], report["done"], len(report["rows"])) != (5, 3, 2, 3):
        faults.append("batch: two samples are not done, or a missing one is")
    return faults + ["batch %s" % fault for fault in unable_to_refuse(schema, validator, report)]


def grow_faults(program, source):
    schema = json.loads((source / "docs" / "grow_report.schema.json").read_text(encoding="utf-8"))
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    faults = []
    with tempfile.TemporaryDirectory() as folder:
        for words in (["samples/surface/tiles.fgsg", "--on", "samples/surface/torus.obj"],
                      ["samples/flower.lsys", "--on", "samples/surface/torus.obj"]):
            name = pathlib.Path(folder) / "report.json"
            subprocess.run([program, "grow", *words, "-o", str(pathlib.Path(folder) / "out.glb"), "--report", str(name)],
                           check=True, capture_output=True, cwd=source)
            report = json.loads(name.read_text(encoding="utf-8"))
            faults += ["grow %s: %s" % (words[0], error.message) for error in validator.iter_errors(report)]
            if report["overlaps"] != 0 or report["faces"] == 0:
                faults.append("grow %s: shapes overlap, or nothing has grown" % words[0])
        faults += ["grow %s" % fault for fault in unable_to_refuse(schema, validator, report)]
    return faults


def arrange_faults(program, source):
    schema = json.loads((source / "docs" / "arrange_report.schema.json").read_text(encoding="utf-8"))
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    with tempfile.TemporaryDirectory() as folder:
        name = pathlib.Path(folder) / "report.json"
        subprocess.run([program, "arrange", str(source / "samples/growth/stones.svg"), "--size", "200,200",
                        "--report", str(name)], check=True, capture_output=True)
        report = json.loads(name.read_text(encoding="utf-8"))
    faults = ["arrange: %s" % error.message for error in validator.iter_errors(report)]
    if not 0 < report["drawn"] <= report["elements"]:
        faults.append("arrange: more is drawn than has grown, or nothing")
    return faults + unable_to_refuse(schema, validator, report)


def pack_faults(program, source):
    schema = json.loads((source / "docs" / "pack_report.schema.json").read_text(encoding="utf-8"))
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    with tempfile.TemporaryDirectory() as folder:
        name = pathlib.Path(folder) / "report.json"
        subprocess.run([program, "pack", str(source / "samples/growth/trees.svg"), "--size", "200,200", "--scale", "0.3",
                        "--report", str(name)], check=True, capture_output=True)
        report = json.loads(name.read_text(encoding="utf-8"))
    faults = ["pack: %s" % error.message for error in validator.iter_errors(report)]
    if sum(shape["placed"] for shape in report["shapes"]) != report["placed"]:
        faults.append("pack: the shapes' numbers are not what is placed")
    return faults + unable_to_refuse(schema, validator, report)


if __name__ == "__main__":
    main(*sys.argv[1:])
