#!/usr/bin/env python3
"""gallery_test.py PROGRAM SOURCE_FOLDER: the commands that the gallery and other pages show run and make what is shown."""

import pathlib
import re
import sys
import tempfile

sys.dont_write_bytecode = True
SOURCE = pathlib.Path(sys.argv[2])
sys.path.insert(0, str(SOURCE / "scripts"))
from run_commands import commands, run  # noqa: E402

try:
    from PIL import Image, ImageChops, ImageStat
except ImportError:
    Image = None  # then pixels are not compared

MOST_BYTES = 130_000  # of a picture; most are below 40,000
MOST_PIXEL_BYTES = 250_000  # of one that is made of pixels: reliefs hardly shrink
GROWTH = "docs/gallery_growth.md"
SURFACE = "docs/gallery_surface.md"
MOST_SURFACE_BYTES = 62_000
MADE_AGAIN = ["tree_plane.png", "merging_b.png", "field_smooth.png", "vine_torus.png"]  # all of them would take too long
MOST_DIFFERENCE = 6  # of 255, on average: what a palette takes away
OTHER_PAGES = ["docs/replace.md"]


def squeezed(text):
    return re.sub(r"\s+", " ", text)


def pictures(page):
    """The files that a page shows, in the source folder."""
    names = re.findall(r'<img src="([^"]+)"', page) + re.findall(r"!\[[^]]*\]\(([^)]+)\)", page)
    return [(SOURCE / "docs" / name).resolve() for name in names]


def expect_made(folder, shown):
    """Every picture is there, small, and what the commands make."""
    for picture in shown:
        assert picture.exists(), "%s is shown and missing" % picture
        if picture.parent in (SOURCE / "samples", SOURCE / "samples/growth"):
            continue  # drawn from its grammar: samples_test
        most = MOST_PIXEL_BYTES if picture.suffix == ".png" else MOST_BYTES
        assert picture.stat().st_size < most, "%s is too large" % picture
        made = folder / picture.name
        assert made.exists(), "no command makes %s" % picture.name
        if picture.suffix == ".png":
            continue  # their bytes depend on the library that draws them
        assert made.read_bytes() == picture.read_bytes(), "%s is not what its commands make: scripts/make_figures.sh" % picture


def expect_rules(folder, page):
    """Every rule shown is one of the grammars that the commands below it make."""
    for section in re.split(r"^### ", page, flags=re.MULTILINE)[1:]:
        names = [folder / name for name in re.findall(r"-o (\S+\.lsys)", section)]
        made = squeezed(" ".join(name.read_text(encoding="utf-8") for name in names))
        for block in re.findall(r"^```lsys\n(.*?)^```", section, re.MULTILINE | re.DOTALL):
            for rule in block.splitlines():
                assert squeezed(rule) in made, "not found: " + rule


def expect_committed(folder):
    """What the figures' commands made is what samples/figures holds."""
    figures = SOURCE / "samples" / "figures"
    for name in sorted(figures.glob("fig*")):
        assert (folder / name.name).read_bytes() == name.read_bytes(), "%s is not what its commands make" % name
    for name in sorted(folder.glob("fig*.lsys")):
        assert (figures / name.name).exists(), "%s is missing in samples/figures: scripts/make_figures.sh" % name.name


def expect_every_sample(page):
    for drawing in sorted((SOURCE / "samples").glob("*.svg")):
        assert "samples/%s" % drawing.name in page, "%s is not in the gallery" % drawing.name


def difference(made, shown):
    """The mean difference of two pictures' pixels; they are as large."""
    pixels = [Image.open(name).convert("RGB") for name in (made, shown)]
    assert pixels[0].size == pixels[1].size, "%s: %s instead of %s" % (shown, pixels[1].size, pixels[0].size)
    return sum(ImageStat.Stat(ImageChops.difference(*pixels)).mean) / 3


def expect_surfaces(program):
    """Every picture has its command and is small; some are made again and look as those shown."""
    page = (SOURCE / SURFACE).read_text(encoding="utf-8")
    made = {words[words.index("-o") + 1] for words in commands(page)}
    shown = [picture for picture in pictures(page) if picture.parent.name == "surface" and "images" in picture.parts]
    for picture in shown:
        assert picture.exists(), "%s is shown and missing" % picture
        assert picture.name in made, "no command makes %s" % picture.name
        assert picture.stat().st_size < MOST_SURFACE_BYTES, "%s is too large" % picture
    assert made == {picture.name for picture in shown}, "made and not shown: %s" % (made - {picture.name for picture in shown})
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        lines = run(program, SOURCE / SURFACE, folder, lambda words: set(words) & set(MADE_AGAIN))
        assert len(lines) == len(MADE_AGAIN)
        print("%s: %d of %d commands, %d pictures" % (SURFACE, len(lines), len(made), len(shown)))
        for picture in MADE_AGAIN if Image else []:
            apart = difference(folder / picture, SOURCE / "docs/images/surface" / picture)
            assert apart < MOST_DIFFERENCE, "%s is not what its command makes: scripts/make_figures.sh (%.1f apart)" % (picture, apart)


def main(program):
    page = (SOURCE / "docs/gallery.md").read_text(encoding="utf-8")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        lines = run(program, SOURCE / "docs/gallery.md", folder)
        print("%d commands, %d pictures" % (len(lines), len(pictures(page))))
        expect_made(folder, pictures(page))
        expect_rules(folder, page)
        expect_committed(folder)
        expect_every_sample(page)
    with tempfile.TemporaryDirectory() as folder:
        lines = run(program, SOURCE / GROWTH, folder)
        shown = pictures((SOURCE / GROWTH).read_text(encoding="utf-8"))
        print("%s: %d commands, %d pictures" % (GROWTH, len(lines), len(shown)))
        expect_made(pathlib.Path(folder), shown)
    expect_surfaces(program)
    for other in OTHER_PAGES:
        with tempfile.TemporaryDirectory() as folder:
            print("%s: %d commands" % (other, len(run(program, SOURCE / other, folder))))


if __name__ == "__main__":
    main(sys.argv[1])
