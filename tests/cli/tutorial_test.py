"""What docs/tutorial.md tells to type works, and makes the pictures and the rules that it shows.
tutorial_test.py PROGRAM SOURCE_FOLDER"""
import pathlib
import re
import subprocess
import sys
import tempfile

import numpy
from PIL import Image

LARGEST_DIFFERENCE = 0.01  # of the pixels: what another version of the rasteriser may draw otherwise


def pixels(path):
    ground = Image.new('RGBA', Image.open(path).size, 'white')
    return numpy.asarray(Image.alpha_composite(ground, Image.open(path).convert('RGBA')).convert('RGB')).astype(int)


def main(program, source):
    source = pathlib.Path(source)
    text = (source / 'docs' / 'tutorial.md').read_text()
    shown = set(re.findall(r'\(images/(tutorial_\w+\.png)\)', text))
    assert len(shown) >= 8
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([str(source / 'scripts' / 'draw_tutorial.sh'), program, folder], check=True, timeout=300)
        made = {path.name for path in pathlib.Path(folder).iterdir()}
        assert made == shown, f'shown but not made: {shown - made}; made but not shown: {made - shown}'
        for name in sorted(shown):
            new, old = pixels(pathlib.Path(folder) / name), pixels(source / 'docs' / 'images' / name)
            assert new.shape == old.shape, f'{name}: run scripts/draw_tutorial.sh'
            different = (numpy.abs(new - old).max(axis=2) > 32).mean()
            assert different < LARGEST_DIFFERENCE, f'{name}: {different:.1%} differs; run scripts/draw_tutorial.sh'
            assert (new < 200).any(), f'{name} is empty'

    # the rules that the text shows are those that are found
    block = re.search(r'```\n(define .*?)```', text, flags=re.S).group(1).split(' ...')[0]
    found = subprocess.run([program, 'analyze', str(source / 'samples' / 'rosette.svg')], check=True, capture_output=True,
                           text=True).stdout
    assert ' '.join(block.split()) in ' '.join(found.split()), 'the rules of the rosette are others than the tutorial shows'


if __name__ == '__main__':
    main(*sys.argv[1:])
