#!/usr/bin/env python3
"""More of the same by mouse: elements are grown and sprayed, used as the drawing, and taken back.

usage: growth_session_test.py RINCEAU-EDITOR SOURCE-FOLDER [FOLDER-FOR-PICTURES]
"""
import pathlib
import sys

from PIL import Image

from window import Display, Editor, ink


def keep(editor, pictures, name):
    if pictures:
        pictures.mkdir(parents=True, exist_ok=True)
        Image.fromarray(editor.frame().astype('uint8')).save(pictures / f'{name}.png')


def inked(editor, box):
    """The share of a part of the canvas, given by shares of its width and height, that is drawn on."""
    canvas = editor.canvas()
    height, width = canvas.shape[:2]
    left, top, right, bottom = (round(share * side) for share, side in zip(box, (width, height, width, height)))
    return ink(canvas[top:bottom, left:right]).mean()


def at(editor, x, y):
    """A point of the canvas by shares of its width and height."""
    place = editor.places()['canvas']
    return (place['left'] + x * (place['right'] - place['left']), place['top'] + y * (place['bottom'] - place['top']))


def sprays(editor, pictures):
    """Elements grow where the mouse is dragged, and nowhere else; Esc takes the brush away, then what has grown."""
    middle, corner = (0.35, 0.45, 0.65, 0.55), (0.1, 0.1, 0.25, 0.25)
    editor.click('growth/Spray')
    editor.move((5, 5))
    editor.settle()
    assert inked(editor, middle) < 0.01, 'the canvas to paint on is not blank'
    editor.drag(at(editor, 0.3, 0.5), at(editor, 0.7, 0.5))
    keep(editor, pictures, 'sprayed')
    assert inked(editor, middle) > 0.3, f'only {inked(editor, middle):.0%} of the sprayed part are drawn on'
    assert inked(editor, corner) < 0.01, 'elements stand where nobody sprayed'
    assert not editor.title().startswith('*'), 'a preview is no edit'
    editor.keys('Escape', 'Escape')


def grows_and_uses(editor, pictures):
    editor.click('growth/until')
    editor.click('growth/until/the canvas is full')
    editor.click('growth/Grow')
    keep(editor, pictures, 'grown')
    whole = (0.1, 0.1, 0.9, 0.9)
    assert inked(editor, whole) > 0.3, f'only {inked(editor, whole):.0%} of the canvas are drawn on'
    assert not editor.title().startswith('*'), 'a preview is no edit'
    editor.click('growth/growth.use')
    assert editor.title().startswith('*'), 'what was used is no edit'
    assert inked(editor, whole) > 0.3, 'what was used is not drawn'
    editor.keys('ctrl+z')
    assert not editor.title().startswith('*'), 'one step of undo does not bring the drawing back'


def main(program, source, pictures=None):
    pictures = pictures and pathlib.Path(pictures)
    with Display() as display:
        with Editor(display, program, pathlib.Path(source) / 'samples' / 'honeycomb.lsys') as editor:
            editor.keys('ctrl+7')
            editor.wait(lambda: 'growth/Grow' in editor.places(), 'Ctrl+7 does not show the panel')
            sprays(editor, pictures)
            grows_and_uses(editor, pictures)
            editor.tool('key', 'ctrl+q')
            assert editor.leave() == 0


if __name__ == '__main__':
    main(*sys.argv[1:])
