"""The editor under a virtual display, used as a person would: by mouse and keyboard, seen as pixels.

    with Display() as display, Editor(display, program, 'samples/facade.svg') as editor:
        editor.click('file/Save')
        editor.keys('ctrl+z')
        picture = editor.frame()

Widgets are found by the names that the editor gives them in its trace (option --places): a JSON document with the window's
title, whether work is under way, and the rectangle of each widget that was drawn.
"""
import json
import os
import pathlib
import shutil
import signal
import subprocess
import tempfile
import time

import numpy
from PIL import ImageGrab

PATIENCE = 40  # seconds: a loaded machine without a graphics processor


class Display:
    """An X server without a screen, under a number that is free."""

    def __init__(self, width=1280, height=800):
        read, write = os.pipe()
        self.server = subprocess.Popen(
            ['Xvfb', '-displayfd', str(write), '-screen', '0', f'{width}x{height}x24', '-nolisten', 'tcp', '+extension', 'GLX',
             '+extension', 'RANDR'],
            pass_fds=[write], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as told:
            number = told.readline().strip()
        assert number, 'Xvfb has not started'
        self.name = ':' + number

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.server.terminate()
        self.server.wait()


class Editor:
    """A running editor with preferences, recovered files and locks of its own (in `home`, kept if it is given)."""

    def __init__(self, display, program, *arguments, home=None, size=(1280, 800)):
        self.display = display
        self.own_home = home is None
        self.home = pathlib.Path(home or tempfile.mkdtemp(prefix='editor-'))
        self.home.mkdir(parents=True, exist_ok=True)
        self.trace = self.home / 'places.json'
        self.trace.unlink(missing_ok=True)
        self.environment = dict(os.environ, DISPLAY=display.name, HOME=str(self.home), LIBGL_ALWAYS_SOFTWARE='1',
                                XDG_CONFIG_HOME=str(self.home / 'config'), XDG_STATE_HOME=str(self.home / 'state'),
                                XDG_CACHE_HOME=str(self.home / 'cache'), XDG_RUNTIME_DIR=str(self.home))
        self.environment.pop('WAYLAND_DISPLAY', None)
        self.errors = open(self.home / 'errors.txt', 'w')
        self.process = subprocess.Popen(
            [str(pathlib.Path(program).resolve()), '--places', str(self.trace), '--size', f'{size[0]}x{size[1]}', *map(str, arguments)],
            env=self.environment, stderr=self.errors, cwd=self.home)

    def __enter__(self):
        self.wait(lambda: 'canvas' in self.places())
        self.settle()
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.terminate()
            try:
                self.process.wait(5)
            except subprocess.TimeoutExpired:
                self.process.kill()
                self.process.wait()
        self.errors.close()
        if self.own_home:
            shutil.rmtree(self.home, ignore_errors=True)

    # What it shows.

    def state(self):
        try:
            return json.loads(self.trace.read_text())
        except (FileNotFoundError, json.JSONDecodeError):
            return {'widgets': []}

    def places(self):
        return {widget['name']: widget for widget in self.state()['widgets']}

    def place(self, name):
        """The middle of a widget; waits until it is there."""
        self.wait(lambda: name in self.places(), f'no widget {name!r}')
        widget = self.places()[name]
        return ((widget['left'] + widget['right']) / 2, (widget['top'] + widget['bottom']) / 2)

    def title(self):
        return self.state().get('title', '')

    def frame(self):
        """The pixels of the window: height x width x 3."""
        return numpy.asarray(ImageGrab.grab(xdisplay=self.display.name).convert('RGB')).astype(numpy.int16)

    def canvas(self):
        widget = self.places()['canvas']
        left, top, right, bottom = (int(widget[side]) for side in ('left', 'top', 'right', 'bottom'))
        return self.frame()[top:bottom, left:right]

    def wait(self, condition, what='the editor does not get there', patience=PATIENCE):
        end = time.monotonic() + patience
        while not condition():
            status = self.process.poll()
            assert status is None, f'the editor has left with {status}: {self.said()}'
            assert time.monotonic() < end, f'{what}; widgets: {sorted(self.places())}'
            time.sleep(0.02)

    def settle(self):
        """Waits until no work is under way and the picture is as fine as it gets."""
        def idle():
            state = self.state()
            return not state.get('busy', True) and not state.get('refining', True)
        steady = 0
        while steady < 3:
            self.wait(idle, 'the editor stays busy')
            before = self.state().get('frame')
            time.sleep(0.06)
            steady = steady + 1 if idle() and self.state().get('frame') == before else 0
            if steady == 0 and idle():
                steady = 1

    def said(self):
        self.errors.flush()
        return (self.home / 'errors.txt').read_text()

    # What a person does.

    def tool(self, *words):
        subprocess.run(['xdotool', *map(str, words)], env=self.environment, check=True, timeout=30)

    def point(self, where):
        return self.place(where) if isinstance(where, str) else where

    def seen(self, *words):
        """Does it and waits until the editor has drawn the frames in which it sees it."""
        before = self.state().get('frame', 0)
        self.tool(*words)
        end = time.monotonic() + 2  # where nothing changes, nothing is drawn
        while self.state().get('frame', 0) < before + 2 and time.monotonic() < end:
            time.sleep(0.01)

    def move(self, where):
        x, y = self.point(where)
        self.seen('mousemove', round(x), round(y))

    def click(self, where, button=1, settle=True):
        self.move(where)
        self.seen('mousedown', button)
        self.seen('mouseup', button)
        if settle:
            self.settle()

    def double_click(self, where):
        self.move(where)
        self.tool('click', '--repeat', 2, '--delay', 90, 1)
        self.settle()

    def drag(self, start, end, steps=6, button=1, release=True):
        x0, y0 = self.point(start)
        x1, y1 = self.point(end)
        self.move((x0, y0))
        self.seen('mousedown', button)
        for step in range(1, steps + 1):
            share = step / steps
            self.move((x0 + share * (x1 - x0), y0 + share * (y1 - y0)))
        if release:
            self.seen('mouseup', button)
        self.settle()

    def keys(self, *combinations):
        for combination in combinations:
            keys = combination.split('+') if combination != '+' else ['plus']
            words = []
            for key in keys:
                words += ['keydown', key, 'sleep', '0.06']
            for key in reversed(keys):
                words += ['keyup', key, 'sleep', '0.03']
            self.tool(*words)
        self.settle()

    def type(self, text):
        self.tool('type', '--delay', 25, text)
        self.settle()

    def fill_in(self, field, text):
        """Puts a text into a text field, in place of what is there."""
        self.click(field)
        self.keys('ctrl+a')
        self.type(text)

    def enter_number(self, field, text):
        """Types a number into a field that is dragged, which Ctrl+click makes a text field."""
        self.move(field)
        self.seen('keydown', 'ctrl')
        self.seen('mousedown', 1)
        self.seen('mouseup', 1)
        self.seen('keyup', 'ctrl')
        self.keys('ctrl+a')
        self.type(text)
        self.keys('Return')

    def kill(self):
        self.process.send_signal(signal.SIGKILL)
        self.process.wait()

    def leave(self):
        """Waits until the editor has left by itself; its exit status."""
        return self.process.wait(PATIENCE)


def ink(pixels, ground=255):
    """Where something is drawn: mask of pixels that are not nearly white."""
    return pixels.min(axis=2) < ground - 10
