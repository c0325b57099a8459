#!/usr/bin/env python3
"""Derives and interprets the same drawings with three programs, in one run on one core, and prints a table (Markdown).

    npm install --prefix build/peers lindenmayer
    apt-get install contextfree
    bench/peers/speed_table.py build

Modules are counted in the string of F + - [ ] that the drawing has as an L-system, for every program. Seconds are the
processor's, the least of several runs; memory is the largest resident set of the process.
A peer that is not installed is left out and said so.
"""

import argparse
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
DRAWINGS = {"koch": "Koch's snowflake, depth 10", "tree": "a branching weed, depth 9"}
SAME_SUM = 1e-9  # relative: sums of millions of rounded coordinates


def on_one_core(command):
    core = str(min(os.sched_getaffinity(0)))
    return ["taskset", "-c", core, *map(str, command)]


def json_of(command):
    return json.loads(subprocess.run(on_one_core(command), check=True, capture_output=True, text=True).stdout)


def ours(build, mode, drawing):
    return json_of([build / "bench/peers/interpreter_bench", mode, HERE / f"{drawing}.lsys"])


def lindenmayer(package, drawing):
    return json_of(["node", HERE / "lindenmayer.js", package, drawing])


def contextfree(drawing, folder):
    """Its own figures: 'execute' is the derivation, what follows sorts the shapes and paints 200 x 200 pixels."""
    command = ["cfdg", "-t", "-m", "100000000", "-s", "200", HERE / f"{drawing}.cfdg", folder / "picture.png"]
    process = subprocess.Popen(on_one_core(command), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    said = process.stdout.read()
    _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        sys.exit(f"cfdg: {said}")
    execute = re.search(r"took ([\d,]+) msec to execute", said)
    shapes = re.findall(r"([\d,]+) shapes", said)
    number = lambda text: int(text.replace(",", ""))
    return {
        "lines": number(shapes[-1]),
        "derived": number(execute.group(1)) / 1000,
        "seconds": usage.ru_utime + usage.ru_stime,
        "peak_kib": usage.ru_maxrss,
    }


def best(runs, measure):
    results = [measure() for _ in range(runs)]
    least = min(results, key=lambda result: result["seconds"])
    if "derived" in least:
        least["derived"] = min(result["derived"] for result in results)
    return least


def measured(name, build, package, folder, runs):
    """[(program and what it does, result, seconds)]"""
    rows = []
    stream = best(runs, lambda: ours(build, "stream", name))
    listed = best(runs, lambda: ours(build, "list", name))
    rows.append(("rinceau: read, derive, interpret; a visitor gets every line", stream, stream["seconds"]))
    rows.append(("rinceau: the same, kept as a list of placements", listed, listed["seconds"]))
    if package.exists() and shutil.which("node"):
        peer = best(runs, lambda: lindenmayer(package, name))
        rows.append(("lindenmayer: iterate, final with a turtle of our own", peer, peer["seconds"]))
        rows.append(("lindenmayer: iterate alone", peer, peer["derived"]))
    if shutil.which("cfdg"):
        peer = best(min(runs, 2), lambda: contextfree(name, folder))
        rows.append(("contextfree: derive, sort, paint 200 x 200 pixels", peer, peer["seconds"]))
        rows.append(("contextfree: derive alone (its own clock)", peer, peer["derived"]))
    return rows


def expect_the_same(rows):
    first = rows[0][1]
    for program, result, _ in rows[1:]:
        same = result["lines"] == first["lines"]
        if "sum" in result:
            same = same and abs(result["sum"] - first["sum"]) <= SAME_SUM * abs(first["sum"])
        if not same:
            sys.exit(f"{program} does not draw the same: {result}, rinceau {first}")


def modules_of(name):
    """Of the string that the comment of the .lsys names; what lindenmayer derives agrees with it."""
    return int(re.search(r"([\d,]+) modules", (HERE / f"{name}.lsys").read_text()).group(1).replace(",", ""))


def text_of(name, title, rows):
    modules = modules_of(name)
    for program, result, _ in rows:
        if result.get("modules", modules) != modules:
            sys.exit(f"{program} derives {result['modules']} modules, expected {modules}")
    least = rows[0][2]
    lines = [f"{title}: {modules:,} modules, {rows[0][1]['lines']:,} lines", "",
             "| program | seconds | million modules a second | times ours | peak MiB |", "|---|--:|--:|--:|--:|"]
    for program, result, seconds in rows:
        lines.append(f"| {program} | {seconds:.2f} | {modules / seconds / 1e6:.1f} | {seconds / least:.1f} "
                     f"| {result['peak_kib'] / 1024:.0f} |")
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=Path, help="the folder that rinceau was built in, with RINCEAU_BUILD_BENCH=ON")
    parser.add_argument("--runs", type=int, default=5, help="of each program; contextfree, the slowest, twice at most")
    options = parser.parse_args()
    build = options.build.resolve()
    package = build / "peers/node_modules/lindenmayer"
    if not package.exists():
        print(f"lindenmayer is left out: npm install --prefix {options.build}/peers lindenmayer")
    if not shutil.which("cfdg"):
        print("contextfree is left out: apt-get install contextfree")
    with tempfile.TemporaryDirectory() as folder:
        for name, title in DRAWINGS.items():
            rows = measured(name, build, package, Path(folder), options.runs)
            expect_the_same(rows)
            print("\n" + text_of(name, title, rows))


if __name__ == "__main__":
    main()
