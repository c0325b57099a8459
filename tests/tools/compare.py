#!/usr/bin/env python3
"""Do two drawings look the same?  compare.py FIRST.svg SECOND.svg [WIDTH]

Both are drawn by rsvg-convert, WIDTH pixels wide (900 unless told), over white. A pixel is inked if it is not white in
either picture. It differs if its colour in one picture is more than 32/255 (in some channel) away from the colours of
all nine pixels about the same place in the other picture, so that edges may shift by less than a pixel. Prints the
share of inked pixels that differ, in per cent; 0.000 = the same picture."""

import io
import subprocess
import sys

import numpy
from PIL import Image

DEFAULT_WIDTH = 900
WHITE_ENOUGH = 250
FAR_APART = 32
SECONDS = 120


def draw(name, width):
    """The picture of an SVG file as an array of height x width x 3 signed numbers."""
    command = ["rsvg-convert", "--width", str(width), "--keep-aspect-ratio", "--background-color", "white", name]
    png = subprocess.run(command, check=True, capture_output=True, timeout=SECONDS).stdout
    return numpy.asarray(Image.open(io.BytesIO(png)).convert("RGB")).astype(numpy.int16)


def far_from_neighbours(picture, other):
    """Where `picture` is unlike every pixel of `other` within one pixel."""
    height, width, _ = picture.shape
    framed = numpy.pad(other, ((1, 1), (1, 1), (0, 0)), mode="edge")
    nearest = numpy.full((height, width), 255, dtype=numpy.int16)
    for down in range(3):
        for right in range(3):
            shifted = framed[down:down + height, right:right + width]
            nearest = numpy.minimum(nearest, numpy.abs(picture - shifted).max(axis=2))
    return nearest > FAR_APART


def pixels_that_differ(a, b):
    """Per cent of the inked pixels of two pictures that differ; 100 if the pictures have different shapes."""
    if abs(a.shape[0] - b.shape[0]) > 2:
        return 100.0
    height = min(a.shape[0], b.shape[0])
    a, b = a[:height], b[:height]
    if numpy.abs(a - b).max() <= FAR_APART:  # then no pixel needs its neighbours
        return 0.0
    inked = (a.min(axis=2) < WHITE_ENOUGH) | (b.min(axis=2) < WHITE_ENOUGH)
    differing = far_from_neighbours(a, b) | far_from_neighbours(b, a)
    return 100.0 * int(differing.sum()) / max(1, int(inked.sum()))


def difference(first, second, width=DEFAULT_WIDTH):
    """Per cent of the inked pixels in which the pictures of two SVG files differ."""
    return pixels_that_differ(draw(first, width), draw(second, width))


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    print("%.3f" % difference(sys.argv[1], sys.argv[2], *map(int, sys.argv[3:])))
