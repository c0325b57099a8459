"""Whole commands at growing sizes: seconds and memory, and how both grow."""

import json
import math
import subprocess

from . import made_drawings
from .figures import of_taken
from .measure import CommandFailed, taken
from .tables import exponent, table

SIZES = [1_000, 3_162, 10_000, 31_623, 100_000]
QUICK_SIZES = [1_000, 3_162, 10_000]
FITTED = 3  # the exponent is that of so many of the largest sizes: the smallest are mostly the program's start
TOYS = ["toy_plane", "toy_dinosaur", "toy_caterpillar"]
SIDE_OF_A_TOY = 113  # px: a square of this side holds about one, filled by default
HALF_EDGE_OF_1000 = 0.0165  # of the diagonal: rings_a places about 1,000 rings with it on the torus
MANY_MODULES = ["--max-modules", "1000000000"]


def analyze(kind):
    def made(bench, size):
        drawing, elements = made_drawings.drawing(bench.rinceau, kind, size, bench.work)
        return ["analyze", drawing, "-o", bench.work / "out.lsys", "--threads", "1"], elements
    return made


def normalize(bench, size):
    drawing, elements = made_drawings.drawing(bench.rinceau, "clutter", size, bench.work)
    return ["normalize", drawing, "-o", bench.work / "out.svg"], elements


def drawn(verb, ending):
    def made(bench, size):
        rules, elements = made_drawings.grammar("ornament", size, bench.work)
        return [verb, rules, "-o", bench.work / f"out.{ending}", *MANY_MODULES], elements
    return made


def arrange(exemplar):
    def made(bench, size):
        return ["arrange", bench.samples / "growth" / exemplar, "--count", size, "-o", bench.work / "out.svg",
                "--threads", "1"], size
    return made


def reported(bench, command, *keys):
    """The sum of numbers that the command's report has."""
    report = bench.work / "report.json"
    subprocess.run([bench.rinceau, *map(str, command), "--report", report], check=True, capture_output=True)
    said = json.loads(report.read_text())
    return sum(said[key] for key in keys)


def pack(bench, size):
    side = round(SIDE_OF_A_TOY * math.sqrt(size))
    command = ["pack", *(bench.samples / "growth" / f"{toy}.svg" for toy in TOYS), "--size", f"{side},{side}",
               "-o", bench.work / "out.svg", "--threads", "1"]
    return command, lambda: reported(bench, command, "placed")


def grow(bench, size):
    half_edge = HALF_EDGE_OF_1000 * math.sqrt(1000 / size)
    command = ["grow", bench.samples / "surface/rings_a.fgsg", "--on", bench.samples / "surface/torus.obj",
               "--set", f"d={half_edge:.6f}*diagonal", "-o", bench.work / "out.glb"]
    return command, lambda: reported(bench, command, "shapes", "lines")


# what is counted, and the command of a size: (arguments, how many there are or how to find out)
COMMANDS = {
    "analyze, nested rows": ("elements", analyze("ornament")),
    "analyze, clutter": ("elements", analyze("clutter")),
    "normalize": ("elements", normalize),
    "derive": ("elements", drawn("derive", "txt")),
    "render to SVG": ("elements", drawn("render", "svg")),
    "render to PNG": ("elements", drawn("render", "png")),
    "arrange, a lattice (bricks)": ("elements", arrange("bricks.svg")),
    "arrange, irregular (stones)": ("elements", arrange("stones.svg")),
    "pack three toys": ("shapes", pack),
    "grow rings on a torus": ("shapes", grow),
}


def measured(bench, name, size):
    counted, made = COMMANDS[name]
    arguments, things = made(bench, size)
    result = taken([bench.rinceau, *arguments], bench.runs, bench.folders)
    return result, counted, things() if callable(things) else things


def run(bench):
    """[figures], text."""
    figures, rows = [], []
    for name in COMMANDS:
        if not bench.wants(name):
            continue
        taken_at = []
        for size in QUICK_SIZES if bench.quick else SIZES:
            bench.say(f"{name}, {size:,}")
            try:
                result, counted, things = measured(bench, name, size)
            except (CommandFailed, subprocess.CalledProcessError) as error:
                bench.fail(f"{name}, {size:,}: {error}")
                break
            taken_at.append((things, result))
            figures += of_taken("commands", f"{name}, {size:,}", result, size=things)
        if taken_at:
            rows += rows_of(name, counted, taken_at)
    sizes = QUICK_SIZES if bench.quick else SIZES
    head = ["command", "", *(f"{size:,}" for size in sizes), "exponent"]
    return figures, table(head, rows, text=(0, 1)) if rows else ""


def rows_of(name, counted, taken_at):
    last = taken_at[-FITTED:]
    return [
        [name, counted, *(things for things, _ in taken_at)],
        ["", "seconds", *(result.seconds for _, result in taken_at), exponent([(n, r.seconds) for n, r in last])],
        ["", "MiB", *(result.peak_mib for _, result in taken_at), exponent([(n, r.peak_mib) for n, r in last])],
    ]
