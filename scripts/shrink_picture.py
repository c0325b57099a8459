#!/usr/bin/env python3
"""shrink_picture.py FROM.png TO.png: the picture with a palette, small enough to stand in a page: of as many colours as fit
into MOST_BYTES. Without dithering, which would grow the file and make noise of even shades."""

import io
import pathlib
import sys

from PIL import Image

MOST_BYTES = 60_000
COLOURS = [128, 96, 64, 48, 32]


def palette_of(picture, colours):
    """A picture with that palette: two thirds for what there is much of, one for what differs most, however little of it."""
    much = picture.quantize(colours - colours // 3, method=Image.MEDIANCUT).getpalette()
    rare = picture.quantize(colours // 3, method=Image.MAXCOVERAGE).getpalette()
    palette = Image.new("P", (1, 1))
    palette.putpalette((much[: 3 * (colours - colours // 3)] + rare[: 3 * (colours // 3)]))
    return palette


def shrunk(picture):
    """The bytes of the best picture that is small enough; of the smallest if none is."""
    for colours in COLOURS:
        file = io.BytesIO()
        picture.quantize(palette=palette_of(picture, colours), dither=Image.NONE).save(file, "PNG", optimize=True)
        if len(file.getvalue()) <= MOST_BYTES:
            break
    return file.getvalue()


if __name__ == "__main__":
    pathlib.Path(sys.argv[2]).write_bytes(shrunk(Image.open(sys.argv[1]).convert("RGB")))
