#!/usr/bin/env python3
"""Makes the outlines and the picture that the grammars of samples/surface use.

usage: scripts/make_surface_shapes.py [FOLDER]      (FOLDER: samples/surface)
"""
import math
import pathlib
import sys

import numpy as np
from PIL import Image

root = pathlib.Path(__file__).resolve().parent.parent


# ---------------------------------------------------------------- outlines

def svg(size, path, fill):
    return ('<svg xmlns="http://www.w3.org/2000/svg" width="%g" height="%g" viewBox="0 0 %g %g">\n'
            '<path d="%s" fill="%s"/>\n</svg>\n' % (size[0], size[1], size[0], size[1], path, fill))


def leaf():
    """Its stalk is at the left end, its tip at the right one."""
    return svg((100, 50), 'M0 25 C10 23 14 10 34 4 C58 -3 82 10 100 25 C82 40 58 53 34 46 C14 40 10 27 0 25 Z', '#5a8f4e')


def petal():
    return svg((100, 60), 'M0 30 C18 26 38 0 70 2 C86 3 96 12 100 22 C94 26 94 34 100 38 C96 48 86 57 70 58 C38 60 18 34 0 30 Z',
               '#c8553d')


def star(points=5, inner=0.45):
    """One tip at the right."""
    at = []
    for k in range(2 * points):
        r = 50 * (1 if k % 2 == 0 else inner)
        a = math.pi * k / points
        at.append('%.4g %.4g' % (50 + r * math.cos(a), 50 - r * math.sin(a)))
    return svg((100, 100), 'M' + ' L'.join(at) + ' Z', '#d9a441')


def drop():
    """A tear, its tip at the right."""
    return svg((100, 56), 'M100 28 C74 26 62 0 30 0 C10 0 0 12 0 28 C0 44 10 56 30 56 C62 56 74 30 100 28 Z', '#4a7fa5')


# ---------------------------------------------------------------- the picture

SIZE = 300


def picture():
    """A ginger cat's face before a blue ground: shades change slowly, so that lines along edges run round eyes and cheeks."""
    y, x = np.mgrid[0:SIZE * 2, 0:SIZE * 2] / (SIZE * 2.0) * 2 - 1
    y = -y
    ground = np.stack([0.36 + 0.10 * y, 0.52 + 0.12 * y, 0.66 + 0.10 * y], axis=-1)
    fur, dark, pale = np.array([0.86, 0.55, 0.25]), np.array([0.55, 0.28, 0.10]), np.array([0.98, 0.92, 0.82])
    image = ground - 0.10 * np.exp(-(x ** 2 + y ** 2))[..., None]

    def ellipse(cx, cy, rx, ry, turn=0.0):
        c, s = math.cos(turn), math.sin(turn)
        u, v = (c * (x - cx) + s * (y - cy)) / rx, (-s * (x - cx) + c * (y - cy)) / ry
        return np.sqrt(u * u + v * v)

    def paint(cover, colour):
        nonlocal image
        image = image * (1 - cover[..., None]) + np.asarray(colour) * cover[..., None]

    def triangle(u, v, a, b, c):
        # the greatest distance to the right of its sides, which go round counter-clockwise
        sides = [((q[1] - p[1]) * (u - p[0]) - (q[0] - p[0]) * (v - p[1])) / math.dist(p, q) for p, q in ((a, b), (b, c), (c, a))]
        return np.maximum(np.maximum(*sides[:2]), sides[2])

    inside = lambda d, soft=0.03: np.clip((1 - d) / soft + 0.5, 0, 1)
    body = ellipse(0, -1.15, 0.78, 0.62)
    paint(inside(body), fur[None, None] * (0.80 + 0.25 * np.clip(1 - body, 0, 1))[..., None])
    for side in (-1, 1):
        u, v = side * x, y
        ear = triangle(u, v, (0.08, 0.48), (0.70, 0.18), (0.60, 0.95))
        paint(np.clip(-ear / 0.02, 0, 1), fur * 0.82)
        paint(np.clip((-ear - 0.07) / 0.05, 0, 1), np.array([0.92, 0.66, 0.58]))
    head = ellipse(0, 0.02, 0.74, 0.62)
    paint(inside(head), fur[None, None] * (0.74 + 0.42 * np.sqrt(np.clip(1 - head, 0, 1)))[..., None])
    for cx, width in ((0.0, 0.05), (-0.17, 0.045), (0.17, 0.045)):
        stripe = np.exp(-((x - cx * (1 + (y - 0.4))) / width) ** 2) * np.clip((y - 0.26) / 0.12, 0, 1) * inside(head)
        paint(0.75 * stripe, dark)
    for side in (-1, 1):
        for row in (0.05, -0.10, -0.24):
            line = (y - row - 0.25 * (side * x - 0.5)) / 0.035
            paint(0.7 * np.exp(-line ** 2) * np.clip((side * x - 0.46) / 0.1, 0, 1) * inside(head), dark)
        eye = ellipse(side * 0.29, 0.12, 0.165, 0.135, side * 0.12)
        paint(inside(eye, 0.12), np.array([0.13, 0.10, 0.08]))
        iris = ellipse(side * 0.29, 0.12, 0.135, 0.11, side * 0.12)
        paint(inside(iris, 0.12), np.array([0.62, 0.78, 0.30]) * (0.75 + 0.35 * np.clip(1 - iris, 0, 1))[..., None])
        paint(inside(ellipse(side * 0.28, 0.12, 0.045, 0.10), 0.2), np.array([0.04, 0.04, 0.05]))
        paint(inside(ellipse(side * 0.28 + 0.03, 0.165, 0.025, 0.025), 0.3), np.array([1.0, 1.0, 1.0]))
        cheek = ellipse(side * 0.155, -0.26, 0.215, 0.165)
        paint(inside(cheek, 0.25), pale[None, None] * (0.84 + 0.2 * np.clip(1 - cheek, 0, 1))[..., None])
    paint(inside(ellipse(0, -0.44, 0.13, 0.10), 0.25), pale * 0.92)
    paint(inside(ellipse(0, -0.125, 0.095, 0.06), 0.2), np.array([0.80, 0.42, 0.40]))
    for side in (-1, 1):
        mouth = np.abs(ellipse(side * 0.085, -0.235, 0.085, 0.09) - 1)
        paint(np.clip(1 - mouth / 0.22, 0, 1) * (y < -0.23), dark * 0.8)
    small = np.clip(image, 0, 1).reshape(SIZE, 2, SIZE, 2, 3).mean(axis=(1, 3))
    return Image.fromarray((small * 255).round().astype(np.uint8))


def main(folder):
    for name, text in (('leaf', leaf()), ('petal', petal()), ('star', star()), ('drop', drop())):
        (folder / (name + '.svg')).write_text(text, encoding='utf-8')
    picture().save(folder / 'cat.png', optimize=True)


if __name__ == '__main__':
    main(pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else root / 'samples' / 'surface')
