#!/usr/bin/env python3
"""Measures the kernels, whole commands, and what other programs do, and prints the tables of docs/benchmarks.md (Markdown).

    bench/run.py --json today.json

Without the name of a build it installs what it needs (Debian; elsewhere it says what), builds the program in build/bench
and gets lindenmayer and svgo from npm into build/bench/peers. Parts: papers (their figures beside ours), commands (cost by size), kernels (each step by itself), peers (other programs).
Seconds are the processor's, of all processes and threads together, the least of several runs: what else runs on the machine
disturbs them little. Commands that can use several threads get one. bench/compare.py compares two files of --json. Peers
that are not installed are left out and said so. Exit status 1 if something could not be measured.
"""

import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

from measures import growth_of_cost, kernels, machine, other_programs, papers

ROOT = Path(__file__).resolve().parent.parent
PARTS = {
    "papers": ("Figures of the papers", papers.run),
    "commands": ("Cost by size", growth_of_cost.run),
    "kernels": ("Kernels", kernels.run),
    "peers": ("Peers", other_programs.run),
}


class Bench:
    """What all parts need to know."""

    def __init__(self, options, work):
        self.build = options.build.resolve()
        self.rinceau = options.rinceau.resolve() if options.rinceau else self.build / "cli/rinceau"
        self.samples = ROOT / "samples"
        self.work = work
        self.runs = 1 if options.quick else options.runs
        self.quick = options.quick
        self.match = options.match
        self.faults = 0
        self.folders = {self.rinceau: "rinceau", f"{ROOT}/": "", f"{work}/": "", f"{self.build}/": "build/"}

    def wants(self, name):
        return self.match in name

    def say(self, what):
        print(f"  {what}", file=sys.stderr, flush=True)

    def fail(self, what):
        self.faults += 1
        print(f"not measured: {what}", file=sys.stderr, flush=True)


def prepared():
    """The folder of a build of our own, up to date."""
    build = ROOT / "build/bench"
    install = 'set -e; . scripts/packages.sh; install_packages "${build_packages[@]}" "${bench_packages[@]}"'
    configure = ["cmake", "-S", ROOT, "-B", build, "-G", "Ninja", "-D", "CMAKE_BUILD_TYPE=Release", "-D", "RINCEAU_BUILD_BENCH=ON",
                 "-D", "RINCEAU_BUILD_TESTS=OFF", "-D", "RINCEAU_BUILD_EDITOR=OFF"]
    for command in (["bash", "-c", install], configure,
                    ["ninja", "-C", build, "rinceau", "kernels", "interpreter_bench"],
                    ["npm", "install", "--silent", "--prefix", build / "peers", "lindenmayer", "svgo"]):
        try:
            status = subprocess.run(command, cwd=ROOT, stdout=sys.stderr).returncode
        except OSError as error:
            sys.exit(f"{command[0]}: {error.strerror}")
        if status != 0 and command[0] != "npm":  # without it peers are left out, and that is said
            sys.exit(f"{command[0]} failed")
    return build


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=Path, nargs="?", help="a folder that rinceau, kernels and interpreter_bench are built in "
                        "already, with RINCEAU_BUILD_BENCH=ON; it is taken as it is")
    parser.add_argument("--only", default=",".join(PARTS), metavar="PART,..", help="of " + ", ".join(PARTS))
    parser.add_argument("--match", default="", metavar="TEXT", help="only what has this in its name: a command, a kernel, a paper")
    parser.add_argument("--runs", type=int, default=3, help="of everything (3)")
    parser.add_argument("--quick", action="store_true", help="one run, sizes to 10,000: to see that all works")
    parser.add_argument("--json", type=Path, metavar="FILE", help="also keep all figures, with the machine, for bench/compare.py")
    parser.add_argument("--rinceau", type=Path, help="another program than the build's cli/rinceau")
    options = parser.parse_args()
    options.parts = options.only.split(",")
    unknown = [part for part in options.parts if part not in PARTS]
    if unknown:
        parser.error(f"no part '{unknown[0]}'; there are {', '.join(PARTS)}")
    if options.runs < 1:
        parser.error("--runs is 1 or more")
    return options


def main():
    options = parse()
    options.build = options.build or prepared()
    with tempfile.TemporaryDirectory(prefix="rinceau_bench_") as work:
        bench = Bench(options, Path(work))
        if not bench.rinceau.exists():
            sys.exit(f"{bench.rinceau} is not there: build the target rinceau")
        told = machine.described(ROOT, bench.build)
        print(f"{machine.sentence(told)} Seconds of the processor, the least of {bench.runs}.")
        figures = []
        for part in options.parts:
            title, run = PARTS[part]
            found, text = run(bench)
            figures += found
            if text:
                print(f"\n## {title}\n\n{text}", flush=True)
        if options.json:
            options.json.write_text(json.dumps({"schema": 1, "machine": told, "figures": figures}, indent=1) + "\n")
    sys.exit(1 if bench.faults else 0)


if __name__ == "__main__":
    main()
