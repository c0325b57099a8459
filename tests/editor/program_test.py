"""The editor as a program: how it starts and leaves, what it says, and how it is used by keyboard alone.

    program_test.py RINCEAU EDITOR TREE
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

import numpy
from PIL import Image

from window import Display, Editor

PATIENCE = 60  # seconds


def run(*words, **environment):
    return subprocess.run([str(word) for word in words], capture_output=True, text=True, timeout=PATIENCE,
                          env=dict(os.environ, LIBGL_ALWAYS_SOFTWARE='1', **environment))


def leaves(result, status, *said):
    assert result.returncode == status, (result.returncode, result.stderr)
    for words in said:
        assert words in result.stderr, result.stderr


def without_display_it_says_so(rinceau):
    leaves(run(rinceau, 'edit', DISPLAY=''), 1, 'rinceau edit: no window could be opened', 'display')


def without_the_editor_it_says_so(rinceau, folder):
    alone = folder / 'alone'
    alone.mkdir()
    shutil.copy(rinceau, alone / 'rinceau')
    leaves(run(alone / 'rinceau', 'edit', PATH=str(alone)), 1, 'the editor is not installed', 'RINCEAU_BUILD_EDITOR')


def screenshots_are_exact_or_explained(rinceau, display, tree, folder):
    art = tree / 'samples' / 'facade.svg'
    picture = folder / 'window.png'
    environment = {'DISPLAY': display.name, 'XDG_CONFIG_HOME': str(folder), 'XDG_STATE_HOME': str(folder)}
    # Larger than the display: what is drawn is not what fits on it.
    leaves(run(rinceau, 'edit', art, '--screenshot', picture, '--size', '1500x900', **environment), 0)
    pixels = numpy.asarray(Image.open(picture).convert('RGB'))
    assert pixels.shape == (900, 1500, 3), pixels.shape
    middle = pixels[300:600, 500:1000].reshape(-1, 3)
    assert len(numpy.unique(middle, axis=0)) > 10, 'the drawing is not in the middle of the window'

    broken = folder / 'broken.svg'
    broken.write_text('<svg xmlns="http://www.w3.org/2000/svg"><rect width="1"></svg>')
    other = folder / 'other.png'
    leaves(run(rinceau, 'edit', broken, '--screenshot', other, **environment), 1, 'broken.svg:1')
    leaves(run(rinceau, 'edit', folder / 'missing.svg', '--screenshot', other, **environment), 1, 'missing.svg', 'No such file')
    leaves(run(rinceau, 'edit', art, '--screenshot', folder / 'no' / 'x.png', **environment), 4, 'cannot be written')
    leaves(run(rinceau, 'edit', art, '--screenshot', other, '--size', 'huge', **environment), 2, '--size', '1280x800')
    assert not other.exists()


def keys_are_never_lost(editor):
    """Faster than frames (but not in one millisecond, which X takes for a key that is held): each of several presses counts, and what is typed right after a command arrives in its window."""
    before = editor.state()['scale']
    editor.tool('key', '--delay', 25, 'ctrl+shift+minus', 'ctrl+shift+minus', 'ctrl+shift+minus')
    editor.wait(lambda: abs(editor.state()['scale'] - before / 1.1 ** 3) < 1e-4, 'three presses are not three steps')
    editor.tool('key', '--delay', 25, 'ctrl+p')
    editor.tool('type', '--delay', 25, 'text as displx')
    editor.tool('key', '--delay', 25, 'BackSpace', 'a', 'y', 'Return')
    editor.wait(lambda: abs(editor.state()['scale'] - 1) < 1e-4, 'the command that was typed did not run')
    editor.wait(lambda: 'palette/words' not in editor.places(), 'the palette stays open')


def panels_are_reached_by_keyboard(editor):
    assert 'panel/Log' not in editor.places()
    editor.keys('F9')
    editor.wait(lambda: 'panel/Log' in editor.places(), 'F9 does not show the log')
    editor.keys('ctrl+3')
    editor.wait(lambda: 'panel/Tools' in editor.places(), 'Ctrl+3 does not show the tools')
    editor.keys('Alt_L')
    editor.keys('Return')
    editor.wait(lambda: 'menu/file.save' in editor.places(), 'Alt and Enter do not open the first menu')
    editor.keys('Escape')
    editor.keys('Escape')
    editor.wait(lambda: 'menu/file.save' not in editor.places(), 'Esc does not close the menu')
    editor.keys('F1')
    editor.wait(lambda: 'help/File' in editor.places(), 'F1 does not help')
    editor.keys('Escape')
    editor.wait(lambda: 'help/File' not in editor.places(), 'Esc does not close the help')


def idle_costs_nothing(editor):
    def ticks():
        fields = pathlib.Path(f'/proc/{editor.process.pid}/stat').read_text().rsplit(')', 1)[1].split()
        return int(fields[11]) + int(fields[12])
    editor.tool('mousemove', 640, 400, 'sleep', 0.7)
    editor.settle()
    before, frame = ticks(), editor.state()['frame']
    editor.tool('sleep', 1)
    assert editor.state()['frame'] == frame, 'frames are drawn although nothing happens'
    assert ticks() - before <= 0.03 * os.sysconf('SC_CLK_TCK'), 'the processor works although nothing happens'


def everything_fits(editor, width, height):
    """Nothing of the window's own parts is cut off, and no two of them overlap."""
    parts = [place for name, place in editor.places().items() if name.startswith(('panel/', 'splitter/', 'tab/', 'section/'))]
    assert len(parts) >= 6
    for part in parts:
        assert 0 <= part['left'] < part['right'] <= width and 0 <= part['top'] < part['bottom'] <= height, part
    for i, a in enumerate(parts):
        for b in parts[i + 1:]:
            apart = (a['right'] <= b['left'] + 1 or b['right'] <= a['left'] + 1 or a['bottom'] <= b['top'] + 1 or
                     b['bottom'] <= a['top'] + 1)
            assert apart, (a, b)


def main():
    rinceau, program, tree = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    with tempfile.TemporaryDirectory() as name, Display() as display:
        folder = pathlib.Path(name)
        without_display_it_says_so(rinceau)
        without_the_editor_it_says_so(rinceau, folder)
        screenshots_are_exact_or_explained(rinceau, display, tree, folder)
        with Editor(display, program, tree / 'samples' / 'rosette.lsys', size=(1024, 700)) as editor:
            everything_fits(editor, 1024, 700)
            keys_are_never_lost(editor)
            panels_are_reached_by_keyboard(editor)
            everything_fits(editor, 1024, 700)
            idle_costs_nothing(editor)
            editor.tool('key', 'ctrl+q')
            assert editor.leave() == 0
        with Editor(display, program, tree / 'samples' / 'rosette.lsys', '--scale', 2, size=(1024, 700)) as editor:
            everything_fits(editor, 1024, 700)


main()
