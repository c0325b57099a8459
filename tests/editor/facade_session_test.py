#!/usr/bin/env python3
"""A session as a person would have it: a drawing is opened, changed by hand, and written for others.

usage: facade_session_test.py RINCEAU RINCEAU-EDITOR SOURCE-FOLDER [FOLDER-FOR-PICTURES]

The exported files are compared with what the command line makes by the same edits; the frames with what rsvg-convert draws.
"""
import difflib
import math
import pathlib
import subprocess
import sys
import tempfile

import numpy
from PIL import Image

from window import Display, Editor

PANE = '''<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 40 40">
  <path d="M20 2 38 20 20 38 2 20Z" fill="#c0392b"/>
  <circle cx="20" cy="20" r="7" fill="#f1c40f"/>
</svg>
'''
FITTED = 0.94  # share of the canvas that a picture takes when it is opened


def far(a, b):
    """Pixels of a that differ by more than an eighth of the range from every pixel of b within one pixel."""
    height, width = a.shape[:2]
    padded = numpy.pad(b, ((1, 1), (1, 1), (0, 0)), mode='edge')
    best = numpy.full((height, width), 999, numpy.int16)
    for y in range(3):
        for x in range(3):
            best = numpy.minimum(best, numpy.abs(a - padded[y:y + height, x:x + width]).max(2))
    return best > 32


def difference(a, b):
    """Share of inked pixels that differ beyond antialiasing."""
    inked = ((a.min(2) < 250) | (b.min(2) < 250)).sum()
    return (far(a, b) | far(b, a)).sum() / max(1, inked)


def drawn(svg, zoom):
    png = pathlib.Path(svg).with_suffix('.test.png')
    subprocess.run(['rsvg-convert', '--zoom', str(zoom), '--background-color', 'white', str(svg), '-o', str(png)], check=True)
    return numpy.asarray(Image.open(png).convert('RGB')).astype(numpy.int16)


def canvas_difference(editor, svg):
    """Between the fitted picture on the canvas and the same drawing by rsvg-convert."""
    canvas = editor.canvas()
    size = drawn(svg, 1).shape
    zoom = FITTED * min(canvas.shape[1] / size[1], canvas.shape[0] / size[0])
    expected = drawn(svg, zoom)
    corner = ((canvas.shape[0] - size[0] * zoom) / 2, (canvas.shape[1] - size[1] * zoom) / 2)
    # the picture may begin between two pixels: the nearest whole places are tried
    best = 1
    for top in {math.floor(corner[0]), math.ceil(corner[0])}:
        for left in {math.floor(corner[1]), math.ceil(corner[1])}:
            shown = canvas[top:top + expected.shape[0], left:left + expected.shape[1]]
            best = min(best, difference(shown, expected[:shown.shape[0], :shown.shape[1]]))
    return best


class Session:
    def __init__(self, program, editor, folder, pictures):
        self.program = program
        self.editor = editor
        self.folder = folder
        self.pictures = pictures

    def run(self, *words):
        subprocess.run([self.program, *map(str, words)], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def by_command(self, name, *edits):
        """The analysed drawing after edits by the command line, as grammar; its picture stands beside it."""
        grammar = self.folder / f'{name}.lsys'
        words = [*edits]
        if words:
            self.run(*words, '-o', grammar)
        self.run('render', grammar, '-o', grammar.with_suffix('.svg'))
        return grammar

    def picture(self, name):
        if self.pictures:
            Image.fromarray(self.editor.frame().astype('uint8')).save(self.pictures / f'{name}.png')

    def expect(self, name, limit=0.015):
        """The canvas shows the fitted picture of that grammar."""
        self.editor.keys('Escape')
        self.editor.move((5, 5))
        self.editor.settle()
        found = canvas_difference(self.editor, self.folder / f'{name}.svg')
        self.picture(name)
        print(f'{name}: {found:.2%} of the inked pixels differ from what rsvg-convert draws')
        assert found < limit, f'{name}: {found:.2%} of the inked pixels differ from what rsvg-convert draws'

    def export(self, format_name, path):
        self.editor.keys('ctrl+e')
        self.editor.click(f'export/{format_name}')
        self.editor.fill_in('export/Path', str(path))
        self.editor.click('export/OK')
        self.editor.wait(path.exists, f'{path.name} is not written')
        self.editor.settle()


def change_by_hand(session):
    """The column of floors becomes longer by a drag; noise; and all of it is taken back."""
    editor = session.editor
    editor.click('canvas')  # a window pane stands in the middle
    x, y = editor.place('handle/count Grid.count')
    floor = editor.places()['canvas']['bottom'] - editor.places()['canvas']['top']
    zoom = FITTED * floor / 490
    editor.drag('handle/count Grid.count', (x, y - 2 * 90 * zoom))
    session.by_command('five_floors', 'set', session.folder / 'facade.lsys', 'Grid.count=5')
    session.expect('five_floors')
    editor.click('tab/Tools')
    editor.enter_number('tools/Randomize angle', '8')
    editor.fill_in('tools/Seed', '7')
    editor.keys('Return')
    editor.click('tools/Randomize')
    session.by_command('random', 'randomize', session.folder / 'five_floors.lsys', '--angle', '8', '--seed', '7')
    session.expect('random')
    assert editor.title().startswith('*'), editor.title()
    editor.keys('ctrl+z', 'ctrl+z')
    assert not editor.title().startswith('*'), editor.title()
    session.expect('facade')


def replace_and_export(session):
    editor = session.editor
    pane = session.folder / 'pane.svg'
    pane.write_text(PANE)
    editor.click('terminals/Pane')
    editor.click('terminals/Pane replace')
    editor.fill_in('tools/Replace with', str(pane))
    editor.click('tools/Replace')
    session.by_command('diamonds', 'replace', session.folder / 'facade.lsys', f'Pane={pane}')
    session.expect('diamonds')
    editor.click('tools/Symmetrize')
    session.by_command('regular', 'symmetrize', session.folder / 'diamonds.lsys')
    session.expect('regular')
    session.export('picture-svg', session.folder / 'exported.svg')
    session.export('lpy', session.folder / 'exported.lpy')
    found = difference(drawn(session.folder / 'exported.svg', 1), drawn(session.folder / 'regular.svg', 1))
    assert found == 0, f'the exported picture differs by {found:.2%}'
    expected = session.folder / 'expected' / 'exported.lpy'
    expected.parent.mkdir()
    session.run('export', session.folder / 'regular.lsys', '--to', 'lpy', '-o', expected)
    lines = list(difflib.unified_diff(expected.read_text().splitlines()[1:],  # but for the grammar's name
                                      (session.folder / 'exported.lpy').read_text().splitlines()[1:], lineterm=''))
    assert not lines, 'the command line writes another L-Py file:\n' + '\n'.join(lines[:20])


def main(program, editor_program, source, pictures=None):
    pictures = pathlib.Path(pictures) if pictures else None
    with tempfile.TemporaryDirectory() as scratch, Display() as display:
        folder = pathlib.Path(scratch)
        art = folder / 'art' / 'facade.svg'
        art.parent.mkdir()
        art.write_bytes((pathlib.Path(source) / 'samples' / 'facade.svg').read_bytes())
        with Editor(display, editor_program, art, home=folder / 'home') as editor:
            session = Session(program, editor, folder, pictures)
            session.run('analyze', art, '-o', folder / 'facade.lsys')
            session.by_command('facade')
            change_by_hand(session)
            replace_and_export(session)
            editor.keys('ctrl+q')
            editor.click('ask/Discard', settle=False)
            assert editor.leave() == 0, editor.said()
    print('the session went as a person would expect')


if __name__ == '__main__':
    main(*sys.argv[1:])
