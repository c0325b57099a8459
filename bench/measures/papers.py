"""Every figure of speed and size that the four papers state, beside ours. Where a paper's drawing is not to be had, ours is
one of the same kind and of about as many elements."""

import json
import math
import subprocess

from . import made_meshes
from .figures import figure, of_taken
from .measure import CommandFailed, taken
from .tables import table

STAVA, IJIRI, SAKURAI, LI = "Šťava et al. 2010", "Ijiri et al. 2008", "Sakurai & Miyata 2014", "Li et al. 2010"
HEAD = ["paper", "where", "what", "paper", "ours", "paper / ours", "ours is"]


class Rows:
    """Lines of the table, and the figures that are kept of them: counts, and seconds with all their runs."""

    def __init__(self):
        self.rows, self.figures = [], []

    def tell(self, paper, where, what, theirs, ours, ours_is):
        ratio = theirs / ours if isinstance(theirs, (int, float)) and ours else None
        self.rows.append([paper, where, what, theirs, ours, ratio, ours_is])

    def add(self, paper, where, what, theirs, ours, ours_is):
        """A number of things."""
        self.tell(paper, where, what, theirs, ours, ours_is)
        self.figures.append(figure("papers", f"{paper}, {where}: {what}", "number", [ours]))

    def seconds(self, paper, where, what, theirs, result, ours_is):
        self.tell(paper, where, what, theirs, result.seconds, f"{ours_is}: `{result.command}`")
        self.figures += of_taken("papers", f"{paper}, {where}: {what}", result)


def run_verb(bench, *arguments):
    return taken([bench.rinceau, *arguments], bench.runs, bench.folders)


def report_of(bench, *arguments):
    report = bench.work / "report.json"
    subprocess.run([bench.rinceau, *map(str, arguments), "--report", report], check=True, capture_output=True)
    return json.loads(report.read_text())


# Table 2: figure, elements, rules, seconds to begin with, to generate rules, in all; our drawing
STAVA_TABLE = [
    ("10", 72, 4, 14, 2, 16, "fig10_facade.svg", "the figure, windows by its printed rules"),
    ("11", 1184, 182, 605, 610, 1215, "figures/fig11b.svg", "an arcade of our own of as many elements"),
    ("12", 500, 42, 55, 154, 209, "figures/fig12b.svg", "a fair of our own of as many elements"),
]


def stava(bench, rows):
    for number, elements, rules, begin, generate, total, file, ours_is in STAVA_TABLE:
        arguments = ["analyze", bench.samples / file, "-o", bench.work / "out.lsys", "--threads", "1"]
        where, report = f"table 2, figure {number}", report_of(bench, *arguments)
        result = run_verb(bench, *arguments)
        rows.add(STAVA, where, "elements", elements, report["elements"], ours_is)
        rows.add(STAVA, where, "rules", rules, len(report["productions"]), "productions found")
        for what, theirs, parts in [("initialisation, s", begin, ["import", "similarity", "clusters"]),
                                    ("generation of rules, s", generate, ["rules", "verify"])]:
            share = sum(report["seconds"][part] for part in parts) / report["seconds"]["total"]
            rows.tell(STAVA, where, what, theirs, share * result.seconds,
                      f"the part of the command that its report calls {', '.join(parts)}")
        rows.seconds(STAVA, where, "all, s", total, result, "the command")
    for where, what, theirs, file in [
        ("figure 8 a", "elements of the sequence", 5, "fig08_sequence.svg"),
        ("figure 9 a", "repetitions of the helix", 336, "fig09_helix.svg"),
    ]:
        report = report_of(bench, "analyze", bench.samples / file, "-o", bench.work / "out.lsys")
        rows.add(STAVA, where, what, theirs, longest_rule(report), "the figure, by its printed numbers: the longest rule found")


def longest_rule(report):
    return max(max(production["lengths"]) for production in report["productions"])


def ijiri(bench, rows):
    arguments = ["arrange", bench.samples / "growth/stones.svg", "--count", "1000", "-o", bench.work / "out.svg",
                 "--threads", "1"]
    for what, theirs, more, ours_is in [
        ("1,000 elements, s", 5, ["--no-finish"], "the paper's process"),
        ("1,000 elements without relaxation, s", "< 1", ["--no-finish", "--no-relax"], "the paper's process"),
        ("1,000 elements, as we do by default, s", 5, [], "relaxed and repaired"),
    ]:
        rows.seconds(IJIRI, "section 6", what, theirs, run_verb(bench, *arguments, *more), ours_is)


# Section 5.1 and table 1: where, our shapes, options, seconds and elements of their method, of naive darts
SAKURAI_TABLE = [
    ("section 5.1, figures 1 b and 4", ["toy_plane", "toy_dinosaur", "toy_caterpillar"], [], 18.3, 224, 250, 210),
    ("table 1 a", ["toy_plane"], [], 17.2, 321, 316.2, 323),
    ("table 1 b", ["toy_dinosaur"], [], 11.5, 64, 93.3, 61),
    ("table 1 c", ["toy_caterpillar"], [], 13.2, 58, 177.8, 61),
    ("table 1 d", ["trees"], ["--scale", "0.2,1"], 31.5, 244, 488.0, 258),
]
NAIVE = ["--method", "naive", "--stop", "10000"]  # the paper's: 10,000 cancellations in a row end it
FIRST_SIDE = 1500


def square_for(bench, shapes, options, count):
    """The side of the square in which our naive darts place about as many as the paper's."""
    side = FIRST_SIDE
    for _ in range(3):
        placed = report_of(bench, "pack", *shapes, *options, *NAIVE, "--size", f"{side},{side}", "-o",
                           bench.work / "out.svg")["placed"]
        side = round(side * math.sqrt(count / placed))
    return side


def sakurai(bench, rows):
    for where, names, options, seconds, count, naive_seconds, naive_count in SAKURAI_TABLE:
        shapes = [bench.samples / f"growth/{name}.svg" for name in names]
        side = square_for(bench, shapes, options, naive_count)
        for what, more, their_seconds, their_count in [
            ("naive darts", NAIVE, naive_seconds, naive_count),
            ("filled gaps, the paper's method", ["--method", "gaps"], seconds, count),
            ("filled gaps, our default", [], seconds, count),
        ]:
            arguments = ["pack", *shapes, *options, *more, "--size", f"{side},{side}", "-o", bench.work / "out.svg",
                         "--threads", "1"]
            rows.add(SAKURAI, where, f"{what}: elements", their_count, report_of(bench, *arguments)["placed"],
                     "shapes of our own; a square in which our darts place as many as theirs")
            rows.seconds(SAKURAI, where, f"{what}, s", their_seconds, run_verb(bench, *arguments), "the command")


# Table 1: figure, rules, faces in, faces out, seconds; our grammar, mesh, how often its faces are cut in four, and how large
# its shapes are, so that about as many faces come out
LI_TABLE = [
    ("13 a", 10, 9_600, 568_000, 0.5, "vine", "torus", 0, ["u=0.0074*diagonal"]),
    ("13 b", 10, 12_000, 352_000, 1, "vine", "cub", 0, ["u=0.0095*diagonal"]),
    ("13 c", 10, 1_280, 750_000, 3, "vine", "sphere", 0, ["u=0.0065*diagonal"]),
    ("14 a", 9, 1_280, 739_000, 9, "stars", "sphere", 0, ["s=0.0049*diagonal"]),
    ("14 b", 9, 21_504, 723_000, 17, "stars", "vase", 1, ["s=0.0048*diagonal"]),
    ("1", 7, 12_000, 521_000, 182, "cracks", "cub", 0, ["u=0.0065*diagonal"]),
    ("15 a", 7, 1_280, 265_000, 15, "cracks", "sphere", 0, ["u=0.0095*diagonal"]),
    ("15 b", 14, 12_000, 867_000, 1, "radial", "cub", 0, ["d=0.0043*diagonal"]),
    ("15 c", 13, 2_748, 483_000, 13, "tree", "vase", 0, ["u=0.005*diagonal", "levels=9"]),
    ("16 a", 12, 23_242, 1_200_000, 10, "tiles", "torus", 1, ["s=0.0237*diagonal"]),
    ("16 c", 12, 40_000, 965_000, 42, "tiles", "cub", 1, ["s=0.0267*diagonal"]),
    ("17", 12, 40_000, 4_000_000, 12, "rings_b", "three_rings", 1, ["s=0.0141*diagonal"]),
    ("18", 30, 20_000, 662_000, 1, "radial", "sphere", 1, ["d=0.0052*diagonal"]),
    ("19", 13, 8_704, 134_000, 3, "places", "cub", 0, ["s=0.032*diagonal"]),
]


def rules_of(grammar):
    """Rules of a .fgsg: its lines with an arrow, or one for each probability of a line."""
    return sum("~" in line.split("#")[0] for line in grammar.read_text().splitlines())


def li(bench, rows):
    for number, rules, faces_in, faces_out, seconds, name, mesh, cuts, settings in LI_TABLE:
        grammar = bench.samples / f"surface/{name}.fgsg"
        surface = made_meshes.cut_in_four(bench.samples / f"surface/{mesh}.obj", cuts, bench.work)
        arguments = ["grow", grammar, "--on", surface, "-o", bench.work / "out.glb",
                     *(word for setting in settings for word in ("--set", setting))]
        report = report_of(bench, *arguments)
        where, ours_is = f"table 1, figure {number}", f"{name} on our {mesh}"
        rows.add(LI, where, "rules", rules, rules_of(grammar), f"samples/surface/{name}.fgsg")
        rows.add(LI, where, "faces in", faces_in, report["surface"]["faces"], ours_is)
        rows.add(LI, where, "faces out", faces_out, report["faces"], ours_is)
        rows.seconds(LI, where, "all, s", seconds, run_verb(bench, *arguments), "read, solved, grown, written")


PARTS = {"stava": stava, "ijiri": ijiri, "sakurai": sakurai, "li": li}


def run(bench):
    rows = Rows()
    for name, part in PARTS.items():
        if not bench.wants(name):
            continue
        bench.say(f"papers: {name}")
        try:
            part(bench, rows)
        except (CommandFailed, subprocess.CalledProcessError) as error:
            bench.fail(f"{name}: {error}")
    return rows.figures, table(HEAD, rows.rows, text=(0, 1, 2, -1)) if rows.rows else ""
