"""Inkscape without a screen, with the extension installed in a profile of its own."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET

import numpy
from PIL import Image

SKIPPED = 77  # the test's exit status, as its CMakeLists.txt says
SVG = '{http://www.w3.org/2000/svg}'
HREF = '{http://www.w3.org/1999/xlink}href'


class Session:
    def __init__(self, program, source):
        for needed in ('inkscape', 'Xvfb', 'rsvg-convert'):
            if shutil.which(needed) is None:
                print(f'skipped: {needed} is not installed')
                sys.exit(SKIPPED)
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.profile = self.folder / 'profile'
        self.environment = dict(os.environ, INKSCAPE_PROFILE_DIR=str(self.profile))
        self.install = [str(pathlib.Path(source) / 'inkscape' / 'install.sh')]
        said = self.run_install('--program', program)
        assert str(self.profile) in said, said
        read_end, write_end = os.pipe()
        self.display = subprocess.Popen(['Xvfb', '-displayfd', str(write_end), '-screen', '0', '640x480x24'],
                                        pass_fds=[write_end], stderr=subprocess.DEVNULL)
        os.close(write_end)
        with os.fdopen(read_end) as number:
            self.environment['DISPLAY'] = ':' + number.readline().strip()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.display.terminate()
        self.display.wait()
        shutil.rmtree(self.folder, ignore_errors=True)

    def run_install(self, *arguments):
        return subprocess.run([*self.install, *arguments], env=self.environment, check=True, capture_output=True, text=True).stdout

    def file(self, name, text=None):
        path = self.folder / name
        if text is not None:
            path.write_text(text)
        return path

    def set_parameters(self, parameters):
        """What the dialogs were left with: {'randomize.seed': 7}."""
        values = ' '.join(f'org.rinceau.{name}="{value}"' for name, value in parameters.items())
        (self.profile / 'preferences.xml').write_text(
            '<inkscape xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd" version="1">'
            f'<group id="extensions" {values}/></inkscape>')

    def act(self, document, *stages):
        """The document after each stage; a stage is a list of actions. One run of Inkscape, which takes seconds to start."""
        results, actions = [], []
        for number, stage in enumerate(stages):
            results.append(self.folder / f'{number}_{document.name}')
            actions += [*stage, f'export-filename:{results[-1]}', 'export-overwrite', 'export-do']
        subprocess.run(['inkscape', str(document), '--batch-process', '--actions=' + ';'.join(actions)],
                       env=self.environment, check=True, capture_output=True, timeout=300)
        return results

    def picture(self, document, width=500):
        """By librsvg, as an array of pixels over white."""
        png = self.folder / 'picture.png'
        subprocess.run(['rsvg-convert', '-w', str(width), '-b', 'white', str(document), '-o', str(png)], check=True)
        return numpy.asarray(Image.open(png).convert('RGB')).astype(int)


def difference(one, other):
    """The share of pixels that differ visibly, beyond the antialiasing of edges."""
    assert one.shape == other.shape
    far = numpy.abs(one - other).max(axis=2) > 48
    # an edge that moves by a fraction of a pixel makes a line one pixel wide
    return (far[1:-1, 1:-1] & far[:-2, 1:-1] & far[2:, 1:-1] & far[1:-1, :-2] & far[1:-1, 2:]).mean()


def tree(document):
    return ET.parse(document).getroot()


def by_id(root, name):
    found = [element for element in root.iter() if element.get('id') == name]
    assert len(found) == 1, f'{len(found)} elements have the id {name}'
    return found[0]


def clones(element):
    return [use for use in element.iter(SVG + 'use')]


def rules_groups(root):
    return [group for group in root.iter(SVG + 'g') if group.get('data-rinceau') == 'rules']


def rules_of(group):
    return group.find(SVG + 'desc').text


def canonical(element):
    return ET.canonicalize(ET.tostring(element), strip_text=True)
