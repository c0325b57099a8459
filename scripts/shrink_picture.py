#!/usr/bin/env python3
"""shrink_picture.py FROM.png TO.png: the picture with a palette, small enough to stand in a page: of as many colours as fit
into MOST_BYTES. Without dithering, which would grow the file and make noise of even shades."""

import io
import pathlib
import sys

from PIL import Image

MOST_BYTES = 60_000
COLOURS = [128, 96, 64, 48, 32]


def shrunk(picture):
    """The bytes of the best picture that is small enough; of the smallest if none is."""
    for colours in COLOURS:
        file = io.BytesIO()
        picture.quantize(colours, method=Image.MEDIANCUT, dither=Image.NONE).save(file, "PNG", optimize=True)
        if len(file.getvalue()) <= MOST_BYTES:
            break
    return file.getvalue()


if __name__ == "__main__":
    pathlib.Path(sys.argv[2]).write_bytes(shrunk(Image.open(sys.argv[1]).convert("RGB")))
