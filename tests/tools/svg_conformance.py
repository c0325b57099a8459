#!/usr/bin/env python3
"""svg_conformance.py PROGRAM SUITE [--only PATTERN] [--keep FOLDER] [--seconds N]  (used by scripts/svg_conformance.sh)

Runs `PROGRAM normalize` on every .svg and .svgz of a test suite (a folder laid out as Debian's librsvg2-tests), draws the
original and what was written with rsvg-convert, and compares the pixels as compare.py does. Prints a line for each drawing:

    same        less than 0.5 % of the inked pixels differ
    differs     they look different, though scene/NORMAL_FORM.md claims everything that the drawing uses
    not claimed they look different, and a warning names what the normal form leaves out
    refused     the program says why it does not read the file, or which limit the file exceeds
    no picture  the program reads the file, but rsvg-convert does not draw it: nothing to compare
    CRASH       the program ended in another way
    HANG        the program did not end in time

and then a table of the groups of features. Its rate is same / (same + differs). --only takes the files whose path within the
suite matches a regular expression. With --keep, what was written stays in FOLDER/suite beside the originals, as
NAME.normal.svg, with both pictures of what is not the same. Exit status 0 only if the rate of all is at least 95 %, there
was something to compare, and nothing crashed or hung."""

import argparse
import collections
import io
import os
import pathlib
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

import numpy
from PIL import Image

from compare import pixels_that_differ

WHITE = 255
MOST_PIXELS = 0.5  # per cent that may differ in a drawing that is the same
LEAST_RATE = 95.0  # per cent of the claimed drawings that are to be the same
SIDE = 600  # pixels of the longer side of a picture
SECONDS = 20  # of the processor for one run of a program, unless told;
PATIENCE = 6  # on a busy machine it may take so many times as long
MEMORY = 4 << 30  # bytes of address space for one run
REFUSED = (1, 3)  # exit status: the input is at fault, a limit is exceeded
WORDS = ("same", "differs", "not claimed", "refused", "no picture", "CRASH", "HANG")
CHAPTERS = {  # of the SVG 1.1 test suite, by the beginnings of names
    "coords": "coordinates", "filters": "filters", "masking": "masking", "painting": "painting", "paths": "paths",
    "pservers": "gradients, patterns", "shapes": "shapes", "struct": "structure", "styling": "style sheets", "text": "text"}
FOLDERS = {  # the other folders of the suite
    "adwaita": "icons", "crash": "hostile files", "render-crash": "hostile files", "errors": "hostile files", "text": "text",
    "svg2": "SVG 2", "svg2-reftests": "SVG 2", "bugs": "reported faults", "bugs-reftests": "reported faults"}
# Warnings that name what NORMAL_FORM.md leaves out though other programs may draw it.
NOT_CLAIMED = re.compile("XInclude|style rule skipped|style sheets in other files|refer to other files and are left out|"
                         "animations are left out|which is not supported")

Outcome = collections.namedtuple("Outcome", "word share reason")


def group_of(drawing):
    """The group of features that a drawing of the suite is about."""
    folder, chapter = drawing.parent.name, re.sub("^ignore-", "", drawing.name).split("-")[0]
    return CHAPTERS.get(chapter, "others") if folder == "svg1.1" else FOLDERS.get(folder, "others")


def run(command, seconds=SECONDS):
    """Raises TimeoutExpired if the program works or waits for too long."""
    def limit_run():
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1))
    done = subprocess.run(command, capture_output=True, timeout=seconds * PATIENCE, preexec_fn=limit_run)
    if done.returncode in (-signal.SIGXCPU, -signal.SIGKILL):
        raise subprocess.TimeoutExpired(command, seconds)
    return done


def picture_of(drawing):
    """What rsvg-convert draws over white, or None if it does not; the language is the scene's, English."""
    command = ["rsvg-convert", "--width", str(SIDE), "--height", str(SIDE), "--keep-aspect-ratio", "--background-color", "white",
               "--accept-language", "en", str(drawing)]
    try:
        done = run(command)
    except subprocess.TimeoutExpired:
        return None
    if done.returncode != 0 or not done.stdout:
        return None
    return numpy.asarray(Image.open(io.BytesIO(done.stdout)).convert("RGB")).astype(numpy.int16)


def compare_pictures(drawing, plain, warnings, keep):
    wanted = picture_of(drawing)
    if wanted is None:
        return Outcome("no picture", None, "")
    found = picture_of(plain)
    if found is None and int(wanted.min()) == WHITE:  # a drawing without size and paint has no picture, and is no worse
        return Outcome("same", 0.0, "")
    if found is None:
        return Outcome("differs", 100.0, "rsvg-convert does not draw what was written")
    share = pixels_that_differ(wanted, found)
    if share < MOST_PIXELS:
        return Outcome("same", share, "")
    if keep:
        for pixels, ending in ((wanted, ".wanted.png"), (found, ".found.png")):
            Image.fromarray(numpy.uint8(pixels)).save(str(plain.with_suffix(ending)))
    missing = [line for line in warnings if NOT_CLAIMED.search(line)]
    return Outcome("not claimed" if missing else "differs", share, missing[0] if missing else "")


def outcome_of(program, drawing, seconds, keep):
    """`drawing` lies in a copy of the suite, so that what is written beside it finds the images that it shows."""
    plain = drawing.with_suffix(".normal.svg")
    try:
        done = run([program, "normalize", str(drawing), "-o", str(plain)], seconds)
    except subprocess.TimeoutExpired:
        return Outcome("HANG", None, "no end within %d seconds" % seconds)
    said = [re.sub(r"^(warning: )?.*?%s:" % re.escape(drawing.name), "", line)
            for line in done.stderr.decode("utf-8", "replace").splitlines()]
    if done.returncode in REFUSED and said:
        return Outcome("refused", None, said[-1])
    if done.returncode != 0:
        return Outcome("CRASH", None, "status %d: %s" % (done.returncode, said[-1] if said else "no message"))
    return compare_pictures(drawing, plain, said, keep)


def drawings_of(suite, pattern):
    return sorted(path for path in suite.rglob("*.svg*") if path.suffix in (".svg", ".svgz")
                  and not path.name.endswith(".normal.svg") and re.search(pattern, str(path.relative_to(suite))))


def rate(counts):
    claimed = counts["same"] + counts["differs"]
    return 100.0 * counts["same"] / claimed if claimed else None


def print_table(groups):
    """In Markdown, as it stands in docs/conformance.md."""
    print("\n| features | drawings | " + " | ".join(WORDS) + " | same of claimed |\n|---|" + "--:|" * (len(WORDS) + 2))
    for name, counts in sorted(groups.items(), key=lambda entry: (entry[0] == "all", entry[0])):
        share = rate(counts)
        cells = [name, sum(counts.values()), *(counts[word] for word in WORDS), "" if share is None else "%.1f %%" % share]
        print("| " + " | ".join(map(str, cells)) + " |")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[1], usage=__doc__.split("\n")[0])
    parser.add_argument("program")
    parser.add_argument("suite", type=pathlib.Path)
    parser.add_argument("--only", default="")
    parser.add_argument("--keep", type=pathlib.Path)
    parser.add_argument("--seconds", type=int, default=SECONDS)
    options = parser.parse_args()
    groups = {"all": collections.Counter()}
    with tempfile.TemporaryDirectory(prefix="conformance-") as scratch:
        copy = (options.keep or pathlib.Path(scratch)) / "suite"
        shutil.copytree(options.suite, copy, dirs_exist_ok=True)
        drawings = drawings_of(copy, options.only)
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            outcomes = pool.map(lambda drawing: outcome_of(options.program, drawing, options.seconds, bool(options.keep)), drawings)
            for drawing, outcome in zip(drawings, outcomes):
                groups["all"][outcome.word] += 1
                groups.setdefault(group_of(drawing), collections.Counter())[outcome.word] += 1
                share = "" if outcome.share is None else "%.3f" % outcome.share
                print("%-60s %-11s %7s  %s" % (drawing.relative_to(copy), outcome.word, share, outcome.reason), flush=True)
    print_table(groups)
    everything = groups["all"]
    share = rate(everything)
    return 0 if share is not None and share >= LEAST_RATE and not everything["CRASH"] + everything["HANG"] else 1


if __name__ == "__main__":
    sys.exit(main())
