#!/usr/bin/env python3
"""Draws the pictures of docs/editor.md by using the editor under a virtual display.

usage: scripts/draw_editor.py RINCEAU-EDITOR [FOLDER]      (FOLDER: docs/images/editor)
"""
import math
import pathlib
import shutil
import sys
import tempfile

from PIL import Image

root = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(root / 'tests' / 'editor'))
from window import Display, Editor  # noqa: E402

COLOURS = 128  # of a picture: small files


def keep(editor, folder, name, part=None):
    """The window, or a part of it by the name of its widget, as folder/name.png."""
    picture = Image.fromarray(editor.frame().astype('uint8'))
    if part:
        place = editor.places()[part]
        picture = picture.crop(tuple(round(place[side]) for side in ('left', 'top', 'right', 'bottom')))
    picture.quantize(COLOURS).save(folder / f'{name}.png', optimize=True)


def panels(editor, folder):
    editor.click('canvas')
    keep(editor, folder, 'selected', 'canvas')
    keep(editor, folder, 'rules', 'panel/Rules')
    keep(editor, folder, 'terminals', 'panel/Terminals')
    keep(editor, folder, 'analysis', 'panel/Analysis')
    x, y = editor.place('handle/count Grid.count')
    editor.drag((x, y), (x, y - 240), release=False)
    keep(editor, folder, 'handle', 'canvas')
    editor.tool('mouseup', 1)
    editor.settle()
    editor.keys('ctrl+z', 'Escape')
    editor.click('tab/Tools')
    editor.enter_number('tools/Randomize angle', '8')
    keep(editor, folder, 'tools', 'panel/Tools')
    keep(editor, folder, 'preview')
    editor.keys('Escape')
    editor.click('tab/Rules')
    editor.keys('ctrl+t')
    keep(editor, folder, 'text', 'panel/Rules')
    editor.keys('ctrl+t')


def on_canvas(editor, x, y):
    """A point by shares of the canvas."""
    place = editor.places()['canvas']
    return (place['left'] + x * (place['right'] - place['left']), place['top'] + y * (place['bottom'] - place['top']))


def stroke(editor, *points):
    """A line of the mouse through points of the canvas."""
    corners = [on_canvas(editor, *point) for point in points]
    editor.move(corners[0])
    editor.seen('mousedown', 1)
    for corner in corners[1:]:
        editor.move(corner)
    editor.seen('mouseup', 1)
    editor.settle()


def arrangements(editor, folder):
    editor.keys('ctrl+7')
    editor.click('growth/until')
    editor.click('growth/until/the canvas is full')
    editor.click('growth/Grow')
    keep(editor, folder, 'growth')
    editor.click('growth/Clear')
    editor.click('growth/Spray')
    wave = [(0.15 + 0.025 * i, 0.5 + 0.12 * math.sin(0.3 * i)) for i in range(29)]
    stroke(editor, *wave)
    keep(editor, folder, 'spray', 'canvas')
    editor.click('growth/Clear')
    editor.click('growth/Flow')
    stroke(editor, *[(x, y - 0.15) for x, y in wave])
    stroke(editor, *[(x, y + 0.15) for x, y in wave])
    editor.click('growth/Boundary')
    circle = [(0.5 + 0.3 * math.cos(0.2 * i), 0.5 + 0.25 * math.sin(0.2 * i)) for i in range(33)]
    stroke(editor, *circle)
    editor.click('growth/Grow')
    keep(editor, folder, 'flow', 'canvas')
    editor.click('growth/Clear')
    editor.click('growth/Flip edges')
    keep(editor, folder, 'edges', 'canvas')


def aggregates(editor, folder):
    editor.keys('ctrl+7')
    editor.click('growth/tab Aggregate')
    editor.enter_number('growth/canvas', '4')
    editor.click('growth/growth.fill')
    keep(editor, folder, 'aggregate')


def choose(editor, what, value):
    editor.click(f'growth/{what}')
    editor.click(f'growth/{what}/{value}')


def surfaces(editor, folder):
    """With the mandala open: a field by mouse, a shape grammar along it, then the drawing."""
    samples = root / 'samples' / 'surface'
    editor.keys('ctrl+7')
    editor.click('growth/tab Surface')
    editor.fill_in('growth/mesh', str(samples / 'blob.obj'))
    editor.click('growth/Open mesh')
    editor.settle()
    choose(editor, 'left button', 'puts field elements')
    for kind, place in (('centre', (0.38, 0.36)), ('node', (0.62, 0.5)), ('wedge', (0.5, 0.7))):
        choose(editor, 'element', kind)
        editor.click(on_canvas(editor, *place))
        editor.settle()
    keep(editor, folder, 'surface_field', 'canvas')
    choose(editor, 'left button', 'turns')
    editor.click('growth/streamlines')
    editor.fill_in('growth/grammar', str(samples / 'vine.fgsg'))
    editor.click('growth/surface.grow')
    editor.move((5, 5))
    editor.settle()
    keep(editor, folder, 'surface_shapes', 'canvas')
    editor.fill_in('growth/grammar', '')
    editor.keys('ctrl+a', 'Delete')
    choose(editor, 'field', 'none')
    choose(editor, 'left button', 'puts seeds')
    editor.click(on_canvas(editor, 0.42, 0.55))
    editor.click('growth/surface.grow')
    editor.move((5, 5))
    editor.settle()
    keep(editor, folder, 'surface_drawing', 'canvas')


def windows(editor, folder):
    editor.keys('ctrl+e')
    keep(editor, folder, 'export')
    editor.click('export/Cancel')
    editor.keys('ctrl+p')
    editor.type('ring')
    keep(editor, folder, 'palette')
    editor.keys('Escape')
    editor.keys('F1')
    keep(editor, folder, 'help')
    editor.keys('Escape')


def main(program, folder=root / 'docs' / 'images' / 'editor'):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    home = pathlib.Path(tempfile.gettempdir()) / 'editor'  # is seen in the window that asks for a file
    shutil.rmtree(home, ignore_errors=True)
    (home / 'art').mkdir(parents=True)
    art = home / 'art' / 'facade.svg'
    shutil.copy(root / 'samples' / 'facade.svg', art)
    with Display() as display:
        with Editor(display, program, art, home=home) as editor:
            keep(editor, folder, 'window')
            panels(editor, folder)
            windows(editor, folder)
        with Editor(display, program, root / 'samples' / 'honeycomb.lsys') as editor:
            arrangements(editor, folder)
        with Editor(display, program, root / 'samples' / 'flower.lsys') as editor:
            aggregates(editor, folder)
        with Editor(display, program, root / 'samples' / 'mandala.lsys') as editor:
            surfaces(editor, folder)
        with Editor(display, program, '--light', art) as editor:
            keep(editor, folder, 'light')
        with Editor(display, program, '--scale', '2', art) as editor:
            keep(editor, folder, 'large')
        with Editor(display, program) as editor:
            keep(editor, folder, 'empty')
    shutil.rmtree(home)


if __name__ == '__main__':
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    main(*sys.argv[1:])
