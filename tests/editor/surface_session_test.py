#!/usr/bin/env python3
"""A surface by mouse: elements of a field are put and dragged, a drawing and a shape grammar grow, what has grown is written.

usage: surface_session_test.py RINCEAU-EDITOR SOURCE-FOLDER [FOLDER-FOR-PICTURES]
"""
import json
import pathlib
import struct
import sys

import numpy
from PIL import Image

from window import Display, Editor


def keep(editor, pictures, name):
    if pictures:
        pictures.mkdir(parents=True, exist_ok=True)
        Image.fromarray(editor.frame().astype('uint8')).save(pictures / f'{name}.png')


def at(editor, x, y):
    """A point of the canvas by shares of its width and height."""
    place = editor.places()['canvas']
    return (place['left'] + x * (place['right'] - place['left']), place['top'] + y * (place['bottom'] - place['top']))


def changed(before, after):
    """The share of pixels that differ."""
    return (numpy.abs(before.astype(int) - after.astype(int)).max(axis=2) > 24).mean()


def choose(editor, what, value):
    editor.click(f'growth/{what}')
    editor.click(f'growth/{what}/{value}')


def turns(editor):
    """A drag turns the surface, and turning back shows it as it was."""
    before = editor.canvas()
    editor.drag(at(editor, 0.5, 0.5), at(editor, 0.7, 0.6))
    editor.settle()
    turned = editor.canvas()
    assert changed(before, turned) > 0.02, 'a drag does not turn the surface'
    editor.drag(at(editor, 0.7, 0.6), at(editor, 0.5, 0.5))
    editor.settle()
    assert changed(before, editor.canvas()) < 0.01, 'dragging back does not turn the surface back'


def designs(editor, pictures):
    """Elements make a field, with lines along it; one that is dragged changes it; a right click takes it away."""
    bare = editor.canvas()
    choose(editor, 'left button', 'puts field elements')
    choose(editor, 'element', 'node')
    editor.click(at(editor, 0.5, 0.6))
    editor.wait(lambda: 'surface/element 1' in editor.places(), 'no element stands where it was put')
    editor.settle()
    lines = editor.canvas()
    assert changed(bare, lines) > 0.02, 'the field is not drawn'
    keep(editor, pictures, 'field')
    editor.drag(at(editor, 0.5, 0.6), at(editor, 0.6, 0.65))
    editor.settle()
    assert changed(lines, editor.canvas()) > 0.01, 'the field does not follow its element'
    editor.click(at(editor, 0.6, 0.65), button=3)
    editor.wait(lambda: 'surface/element 1' not in editor.places(), 'a right click does not take the element away')
    choose(editor, 'left button', 'turns')
    choose(editor, 'field', 'smoothest')


def grows(editor, pictures):
    """The shape grammar that was opened: rule by rule, then all."""
    editor.click('growth/surface.steps')
    editor.settle()
    few = editor.canvas()
    editor.click('growth/surface.grow')
    editor.settle()
    all_of_it = editor.canvas()
    keep(editor, pictures, 'shapes')
    assert changed(few, all_of_it) > 0.05, 'all rules draw no more than the first fifty'


def writes(editor, folder):
    file = folder / 'pattern.glb'
    editor.fill_in('growth/write to', str(file))
    editor.click('growth/Write write to')
    editor.settle()
    data = file.read_bytes()
    magic, version, length = struct.unpack('<4sII', data[:12])
    assert (magic, version, length) == (b'glTF', 2, len(data)), 'what was written is no binary glTF'
    size, kind = struct.unpack('<I4s', data[12:20])
    nodes = json.loads(data[20:20 + size])['nodes']
    assert kind == b'JSON' and len(nodes) > 1, 'the file does not hold what has grown'


def main(program, source, pictures=None):
    pictures = pictures and pathlib.Path(pictures)
    samples = pathlib.Path(source) / 'samples' / 'surface'
    with Display() as display:
        with Editor(display, program, samples / 'blob.obj') as editor:
            editor.wait(lambda: 'growth/mesh facts' in editor.places(), 'the mesh is not shown')
            editor.settle()
            turns(editor)
            designs(editor, pictures)
            editor.fill_in('growth/grammar', str(samples / 'tiles.fgsg'))
            grows(editor, pictures)
            writes(editor, editor.home)
            assert not editor.title().startswith('*'), 'a surface is no edit of the document'
            editor.tool('key', 'ctrl+q')
            assert editor.leave() == 0


if __name__ == '__main__':
    main(*sys.argv[1:])
