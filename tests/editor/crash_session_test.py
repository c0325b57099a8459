#!/usr/bin/env python3
"""What is not saved survives a crash: the editor is killed in the middle, and the next start offers the document.

usage: crash_session_test.py RINCEAU-EDITOR SOURCE-FOLDER
"""
import json
import pathlib
import shutil
import sys
import tempfile

from window import Display, Editor


def five_floors(state):
    """Does the copy for emergencies hold the edit?"""
    copies = list((state / 'rinceau' / 'recovery').glob('*.rinceau'))
    return any('Grid(5)' in json.dumps(json.loads(copy.read_text())) for copy in copies)


def main(program, source):
    with tempfile.TemporaryDirectory() as home, Display() as display:
        art = pathlib.Path(home) / 'facade.svg'
        shutil.copy(pathlib.Path(source) / 'samples' / 'facade.svg', art)
        before = art.read_bytes()
        with Editor(display, program, '--autosave-seconds', 1, art, home=home) as editor:
            editor.click('canvas')
            x, y = editor.place('handle/count Grid.count')
            editor.drag((x, y), (x, y - 240))
            assert editor.title().startswith('*'), editor.title()
            editor.wait(lambda: five_floors(pathlib.Path(home) / 'state'), 'no copy for emergencies is written')
            editor.kill()
        assert art.read_bytes() == before, 'the file has changed though nothing was saved'
        with Editor(display, program, home=home) as editor:
            editor.click('recover/Open')
            assert editor.title() == '*facade.svg – Rinceau', editor.title()
            editor.click('canvas')
            assert 'handle/count Row2.count' in editor.places(), sorted(editor.places())
            editor.keys('ctrl+q')
            editor.click('ask/Discard', settle=False)
            assert editor.leave() == 0, editor.said()
        assert not five_floors(pathlib.Path(home) / 'state'), 'what was discarded is still kept'


if __name__ == '__main__':
    main(*sys.argv[1:])
