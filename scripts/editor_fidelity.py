#!/usr/bin/env python3
"""Compares what the editor draws on its canvas with what librsvg makes of the same picture.

    editor_fidelity.py PROGRAM FILES_OR_FOLDERS.. [--as-drawing] [--width W] [--most MEAN] [--keep FOLDER]

PROGRAM is rinceau-editor; a display is needed (xvfb-run). Of a folder all .svg and .lsys are taken. An SVG is analysed first
and drawn from its grammar, or with --as-drawing as it was read, and compared with the SVG; a grammar is compared with the SVG
that `rinceau render` makes of it. The measure: the share, in per cent, of the inked pixels of either picture that differ by
more than an eighth of the range from every pixel of the other within one pixel. Ends with status 1 if the mean over the files
is above MEAN or a file cannot be drawn.
"""
import argparse
import os
import pathlib
import subprocess
import sys
import tempfile

import numpy
from PIL import Image

PATIENCE = 300  # seconds a picture
PAPER = 250     # a pixel with all channels at least this is no ink
VISIBLE = 32    # levels: an eighth of the range


def read_picture(path):
    return numpy.asarray(Image.open(path).convert('RGB')).astype(numpy.int16)


def unlike(picture, other):
    """Which pixels differ visibly from all pixels of the other within one pixel."""
    height, width = picture.shape[:2]
    padded = numpy.pad(other, ((1, 1), (1, 1), (0, 0)), mode='edge')
    nearest = numpy.full((height, width), 999, numpy.int16)
    for y in range(3):
        for x in range(3):
            distance = numpy.abs(picture - padded[y:y + height, x:x + width]).max(2)
            nearest = numpy.minimum(nearest, distance)
    return nearest > VISIBLE


def difference(picture, other):
    """In per cent; pictures may differ in height by a rounded row."""
    if abs(picture.shape[0] - other.shape[0]) > 2 or picture.shape[1] != other.shape[1]:
        return 100.0
    height = min(picture.shape[0], other.shape[0])
    picture, other = picture[:height], other[:height]
    ink = ((picture.min(2) < PAPER) | (other.min(2) < PAPER)).sum()
    return 100.0 * (unlike(picture, other) | unlike(other, picture)).sum() / max(1, ink)


def run(command):
    subprocess.run(command, check=True, timeout=PATIENCE, stdout=subprocess.DEVNULL)


def as_svg(program, drawing, folder):
    """The drawing itself, or the SVG of a grammar."""
    if drawing.suffix == '.svg':
        return drawing
    svg = folder / 'rendered.svg'
    run([program.parent.parent / 'cli' / 'rinceau', 'render', drawing, '-o', svg])
    return svg


def compared(program, drawing, folder, options):
    drawn, expected = folder / 'drawn.png', folder / 'expected.png'
    as_drawing = ['--as-drawing'] if options.as_drawing and drawing.suffix == '.svg' else []
    run([program, drawing, '--picture', drawn, '--width', str(options.width)] + as_drawing)
    run(['rsvg-convert', '-w', str(options.width), '--keep-aspect-ratio', '--background-color', 'white',
         as_svg(program, drawing, folder), '-o', expected])
    if options.keep:
        for picture in (drawn, expected):
            (options.keep / f'{drawing.stem}_{picture.name}').write_bytes(picture.read_bytes())
    return difference(read_picture(drawn), read_picture(expected))


def drawings_in(places):
    for place in places:
        if place.is_dir():
            yield from sorted(p for p in place.iterdir() if p.suffix in ('.svg', '.lsys'))
        else:
            yield place


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('program', type=lambda path: pathlib.Path(path).resolve())
    parser.add_argument('files', nargs='+', type=pathlib.Path)
    parser.add_argument('--as-drawing', action='store_true')
    parser.add_argument('--width', type=int, default=900)
    parser.add_argument('--most', type=float, default=1.5, help='the mean, in per cent, above which the comparison fails')
    parser.add_argument('--keep', type=pathlib.Path, help='a folder for the pictures')
    options = parser.parse_args()
    if options.keep:
        os.makedirs(options.keep, exist_ok=True)
    shares, failed = [], 0
    for drawing in drawings_in(options.files):
        try:
            with tempfile.TemporaryDirectory() as folder:
                shares.append(compared(options.program, drawing, pathlib.Path(folder), options))
            print(f'{shares[-1]:8.3f} %  {drawing}', flush=True)
        except (subprocess.SubprocessError, OSError) as error:
            failed += 1
            print(f'  failed    {drawing}: {error}', flush=True)
    mean = sum(shares) / max(1, len(shares))
    print(f'{mean:8.3f} %  mean of {len(shares)} files' + (f', {failed} failed' if failed else ''))
    return 1 if failed or mean > options.most or not shares else 0


if __name__ == '__main__':
    sys.exit(main())
