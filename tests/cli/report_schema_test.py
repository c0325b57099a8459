#!/usr/bin/env python3
"""report_schema_test.py PROGRAM SOURCE_FOLDER: the reports of all samples are as docs/report.schema.json says, those of
arranging as docs/arrange_report.schema.json, of many drawings as docs/batch_report.schema.json, of packing as
docs/pack_report.schema.json, of growing on surfaces as docs/grow_report.schema.json and of fields as
docs/field_report.schema.json says. So are fields and designs of fields as docs/field.schema.json and
docs/field_design.schema.json say."""

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
    faults += field_faults(program, source)
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


def validator_of(source, name):
    schema = json.loads((source / "docs" / name).read_text(encoding="utf-8"))
    jsonschema.Draft202012Validator.check_schema(schema)
    return schema, jsonschema.Draft202012Validator(schema)


def field_faults(program, source):
    schema, validator = validator_of(source, "field_report.schema.json")
    _, fields = validator_of(source, "field.schema.json")
    _, designs = validator_of(source, "field_design.schema.json")
    design = json.loads((source / "samples/surface/design.json").read_text(encoding="utf-8"))
    faults = ["the design of samples: %s" % error.message for error in designs.iter_errors(design)]
    wrong = [{**design, "n": 3}, [{"type": "wedge"}], [{"type": "wedge", "vertex": 0, "at": [0, 0, 0]}], []]
    faults += ["the schema of designs lets %s be" % json.dumps(bad) for bad in wrong if designs.is_valid(bad)]
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        subprocess.run([program, "field", "samples/surface/torus.obj", "--curvature", "--smooth", "0.1", "--report",
                        str(folder / "report.json"), "-o", str(folder / "field.json")], check=True, capture_output=True,
                       cwd=source)
        subprocess.run([program, "field", "samples/surface/torus.obj", "--field", str(folder / "field.json"), "--frame",
                        "edge", "-o", str(folder / "edge.json")], check=True, capture_output=True, cwd=source)
        report, field, edge = (json.loads((folder / name).read_text(encoding="utf-8"))
                               for name in ("report.json", "field.json", "edge.json"))
    faults += ["field: %s" % error.message for error in validator.iter_errors(report)]
    faults += ["a saved field: %s" % error.message for one in (field, edge) for error in fields.iter_errors(one)]
    faults += ["the schema of fields lets '%s' be left out" % key for key, one in (("vectors", field), ("z", edge))
               if fields.is_valid({k: v for k, v in one.items() if k != key})]
    if len(field["vectors"]) != report["vertices"]:
        faults.append("field: not one vector for each vertex")
    return faults + ["field %s" % fault for fault in unable_to_refuse(schema, validator, report)]


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
