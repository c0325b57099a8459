"""Other programs from Debian and npm where they do the same work: derivation, an L-system as SVG, SVG in and out, packing."""

import re
import shutil
import subprocess
from pathlib import Path

from peers import speed_table

from . import made_drawings
from .figures import figure, of_taken
from .measure import CommandFailed, taken
from .tables import table

SYSTEM_PYTHON = Path("/usr/bin/python3")  # the one that Debian's modules are for
INKSCAPE_EXTENSIONS = Path("/usr/share/inkscape/extensions")
KOCH_STEPS, QUICK_KOCH_STEPS = 7, 5  # Inkscape's extension takes as long as the square of the lines
LEAST_SHARE_DRAWN = 0.999  # of the lines that Context Free writes: it leaves out what is too small to be seen
DRAWING_SIZE, QUICK_DRAWING_SIZE = 10_000, 1_000


def node_program(bench, name):
    program = bench.build / "peers/node_modules/.bin" / name
    return program if program.exists() and shutil.which("node") else None


def missing(bench, name, cure):
    bench.say(f"{name} is left out: {cure}")


def measure_all(bench, group, programs, product):
    """Rows of programs [(name, command, what it wrote)], slowest last as given; the first is ours."""
    rows, figures, first = [], [], None
    for name, command, out in programs:
        bench.say(f"{group}: {name}")
        try:
            result = taken(command, bench.runs, bench.folders)
        except CommandFailed as error:
            bench.fail(str(error))
            continue
        first = first or result.seconds
        rows.append([name, result.seconds, result.seconds / first, result.peak_mib, product(out)])
        figures += of_taken("peers", f"{group}: {name}", result)
    return figures, rows


# --- derivation and interpretation -------------------------------------------------------------------------------------


def interpreters(bench):
    """bench/peers/speed_table.py: the same drawings, derived and interpreted."""
    package = bench.build / "peers/node_modules/lindenmayer"
    if not (bench.build / "bench/peers/interpreter_bench").exists():
        bench.fail("interpreter_bench is not built")
        return [], ""
    if not package.exists():
        missing(bench, "lindenmayer", "npm install --prefix build/peers lindenmayer")
    figures, texts = [], []
    for name, title in speed_table.DRAWINGS.items():
        bench.say(title)
        rows = speed_table.measured(name, bench.build, package, bench.work, bench.runs)
        speed_table.expect_the_same(rows)
        texts.append(speed_table.text_of(name, title, rows))
        figures += [figure("peers", f"{title}: {program}", "s", [seconds]) for program, _, seconds in rows]
    return figures, "\n\n".join(texts)


# --- an L-system as an SVG file ------------------------------------------------------------------------------------------


def koch_files(bench, steps):
    """Koch's snowflake for the programs that read files."""
    lsys, cfdg, blank = (bench.work / name for name in ("koch.lsys", "koch.cfdg", "blank.svg"))
    text = made_drawings.with_definitions((speed_table.HERE / "koch.lsys").read_text(), {"steps": steps})
    lsys.write_text(text.replace("canvas none", "canvas 0 0 7000 8000"))
    cfdg.write_text((speed_table.HERE / "koch.cfdg").read_text().replace("10", str(steps)))
    blank.write_text('<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" '
                     'width="100" height="100" viewBox="0 0 100 100"/>')
    return lsys, cfdg, blank


def lines_in(file):
    """Lines that the SVG file draws, however it writes them."""
    text = file.read_text(errors="replace")
    uses = text.count("<use")
    return uses if uses > 1 else len(re.findall(r"[Ll]", " ".join(re.findall(r'\sd="([^"]*)"', text))))


def lsystem_svg(bench):
    steps = QUICK_KOCH_STEPS if bench.quick else KOCH_STEPS
    koch_lines = 3 * 4**steps
    lsys, cfdg, blank = koch_files(bench, steps)
    out = {name: bench.work / f"koch_{name}.svg" for name in ("rinceau", "cfdg", "inkscape")}
    programs = [("rinceau render", [bench.rinceau, "render", lsys, "-o", out["rinceau"], "--max-modules", "100000000"],
                 out["rinceau"])]
    extension = INKSCAPE_EXTENSIONS / "lindenmayer.py"
    if extension.exists() and SYSTEM_PYTHON.exists():
        programs.append(("Inkscape's extension L-System (lindenmayer.py)",
                         [SYSTEM_PYTHON, extension, f"--order={steps}", "--axiom=F++F++F", "--rules=F=F-F++F-F",
                          "--langle=60", "--rangle=60", "--step=1", f"--output={out['inkscape']}", blank], out["inkscape"]))
    else:
        missing(bench, "Inkscape's extension", "apt-get install inkscape python3-lxml python3-cssselect")
    if shutil.which("cfdg"):
        programs.append(("Context Free, cfdg --svg", ["cfdg", "-V", "-q", "-m", "100000000", cfdg, out["cfdg"]], out["cfdg"]))
    else:
        missing(bench, "cfdg", "apt-get install contextfree")
    figures, rows = measure_all(bench, "L-system to SVG", programs, lambda file: file)
    for row in rows:
        file, lines = row[-1], lines_in(row[-1])
        if lines < LEAST_SHARE_DRAWN * koch_lines:
            bench.fail(f"{row[0]} draws {lines:,} lines, expected {koch_lines:,}")
        row[-1:] = [file.stat().st_size / 1e6, lines]
    head = ["program", "seconds", "times ours", "peak MiB", "MB written", "lines"]
    return figures, f"Koch's snowflake of {koch_lines:,} lines as an SVG file\n\n" + table(head, rows)


# --- SVG in, SVG out -----------------------------------------------------------------------------------------------------


def svg_cleaners(bench):
    size = QUICK_DRAWING_SIZE if bench.quick else DRAWING_SIZE
    drawing, elements = made_drawings.drawing(bench.rinceau, "clutter", size, bench.work)

    def out(name):
        return bench.work / f"cleaned_{name}.svg"

    programs = [("rinceau normalize", [bench.rinceau, "normalize", drawing, "-o", out("rinceau")], out("rinceau"))]
    if shutil.which("rsvg-convert"):
        programs.append(("rsvg-convert --format svg", ["rsvg-convert", "--format", "svg", drawing, "-o", out("rsvg")], out("rsvg")))
    svgo = node_program(bench, "svgo")
    if svgo:
        programs.append(("svgo", ["node", svgo, "-q", drawing, "-o", out("svgo")], out("svgo")))
    else:
        missing(bench, "svgo", "npm install --prefix build/peers svgo")
    if shutil.which("scour"):
        programs.append(("scour", ["scour", "-q", "-i", drawing, "-o", out("scour")], out("scour")))
    else:
        missing(bench, "scour", "apt-get install scour")
    if shutil.which("inkscape"):
        programs.append(("inkscape --export-plain-svg", ["inkscape", "--export-plain-svg", "--export-filename", out("inkscape"),
                                                         drawing], out("inkscape")))
    programs.append(("for comparison: rinceau analyze --threads 1 (nested rows, to a grammar)", *analysis(bench, size)))
    figures, rows = measure_all(bench, "SVG in and out", programs, lambda file: file.stat().st_size / 1024)
    title = f"A drawing of {elements:,} paths ({drawing.stat().st_size / 1024:,.0f} KiB) read and written as SVG"
    return figures, f"{title}\n\n" + table(["program", "seconds", "times ours", "peak MiB", "KiB written"], rows)


def analysis(bench, size):
    drawing, _ = made_drawings.drawing(bench.rinceau, "ornament", size, bench.work)
    out = bench.work / "found.lsys"
    return [bench.rinceau, "analyze", drawing, "-o", out, "--threads", "1"], out


# --- how small -----------------------------------------------------------------------------------------------------------


SMALL = ["fig10_facade", "fig09_helix", "fig11_arcade", "fig12_fair", "mandala", "vine", "tiles", "fence"]


def sizes(bench):
    """Bytes of samples as they are, cleaned by svgo with its search for equal paths, and as the grammar that is found."""
    svgo = node_program(bench, "svgo")
    config = bench.work / "svgo.config.mjs"
    config.write_text("export default { multipass: true, plugins: ['preset-default', 'reusePaths'] };\n")
    rows, figures = [], []
    for name in SMALL:
        used, plain, found = bench.samples / f"{name}.svg", bench.work / f"{name}.svg", bench.work / f"{name}.lsys"
        reused = bench.work / f"{name}.reused.svg"
        subprocess.run([bench.rinceau, "normalize", used, "-o", plain], check=True, capture_output=True)
        subprocess.run([bench.rinceau, "analyze", plain, "-o", found], check=True, capture_output=True)
        cells = [plain.stat().st_size]
        if svgo:
            subprocess.run(["node", svgo, "-q", "--config", config, plain, "-o", reused], check=True, capture_output=True)
            cells.append(reused.stat().st_size)
        cells.append(found.stat().st_size)
        figures.append(figure("peers", f"bytes of the grammar: {name}", "bytes", [cells[-1]]))
        rows.append([name, *cells, cells[0] / cells[-1]])
    head = ["sample", "plain SVG", *(["svgo with reusePaths"] if svgo else []), "grammar found (.lsys)", "SVG / grammar"]
    return figures, "Bytes of drawings\n\n" + table(head, rows)


PARTS = {"interpreters": interpreters, "lsystem": lsystem_svg, "svg": svg_cleaners, "bytes": sizes}


def run(bench):
    figures, texts = [], []
    for name, part in PARTS.items():
        if not bench.wants(name):
            continue
        try:
            found, text = part(bench)
        except (CommandFailed, subprocess.CalledProcessError) as error:
            bench.fail(f"{name}: {error}")
            continue
        figures += found
        texts += [text] if text else []
    return figures, "\n\n".join(texts)
