"""The extension in Inkscape.  extension_test.py PROGRAM SOURCE_FOLDER"""
import subprocess
import sys

import numpy

from documents import flower
from inkscape_session import (Session, by_id, canonical, clones, difference, rules_groups, rules_of, tree)

PETALS = [f'petal{i}' for i in range(8)]
NO_DIFFERENCE = 0.0005
UNTOUCHED = ['paper', 'stem', 'text', 'hidden', 'clone', 'lin']


def select(ids):
    return 'select-by-id:' + ','.join(ids)


def expect_untouched(before, after, ids):
    for name in ids:
        assert canonical(by_id(before, name)) == canonical(by_id(after, name)), f'{name} has changed'


def find_rules_keeps_the_picture(inkscape):
    document = inkscape.act(inkscape.file('flower.svg', flower()))  # as Inkscape itself writes it
    found = inkscape.act(document, select(PETALS), 'org.rinceau.find-rules.noprefs')
    before, after = tree(document), tree(found)
    assert difference(inkscape.picture(document), inkscape.picture(found)) < NO_DIFFERENCE
    expect_untouched(before, after, UNTOUCHED)

    # the group with the rules stands where the petals stood
    ring = by_id(after, 'ring')
    assert ring.attrib == by_id(before, 'ring').attrib
    group, = rules_groups(after)
    assert group in list(ring)
    assert 'Ring_count = 8' in rules_of(group), rules_of(group)
    assert len(clones(group)) == 7, 'one petal is real, the others are its clones'
    return found


def clones_are_live(inkscape, found):
    root = tree(found)
    group, = rules_groups(root)
    original = clones(group)[0].get('{http://www.w3.org/1999/xlink}href')[1:]
    assert not any(by_id(root, original) in list(defs) for defs in root.iter('{http://www.w3.org/2000/svg}defs'))
    painted = inkscape.act(found, select([original]), 'object-set-property:fill,#00ff00')
    green = (inkscape.picture(painted) == [0, 255, 0]).all(axis=2)
    was_blue_or_red = inkscape.picture(found)
    assert not (was_blue_or_red == [0, 255, 0]).all(axis=2).any()
    # all eight turned green: the green pixels lie around their middle on all sides
    rows, columns = numpy.nonzero(green)
    middle = rows.mean(), columns.mean()
    angles = numpy.arctan2(rows - middle[0], columns - middle[1])
    counts, _ = numpy.histogram(angles, bins=8, range=(-numpy.pi, numpy.pi))
    assert (counts > 50).all(), counts


def symmetrize_makes_even(inkscape):
    crooked = inkscape.file('crooked.svg', flower([0, 43, 93, 136, 178, 226, 271, 313]))
    even = inkscape.act(inkscape.file('even.svg', flower()))
    done = inkscape.act(crooked, select(PETALS), 'org.rinceau.symmetrize.noprefs')
    apart = difference(inkscape.picture(even), inkscape.picture(crooked))
    left = difference(inkscape.picture(even), inkscape.picture(done))
    assert left < apart / 2, (left, apart)
    assert 'Ring_count = 8' in rules_of(*rules_groups(tree(done)))
    expect_untouched(tree(even), tree(done), UNTOUCHED)


def without_rules_a_message_says_so(inkscape, program):
    """Asked as Inkscape asks: its dialog with the message would wait for a click."""
    document = inkscape.file('flower.svg', flower())
    for ids, words in ((['stem', 'text'], 'No rule was found'), (['hidden', 'paper'], 'nothing to work on')):
        run = subprocess.run([program, 'inkscape', '--command=find_rules', *(f'--id={name}' for name in ids), str(document)],
                             capture_output=True, text=True)
        assert words in run.stderr, run.stderr
        assert run.stdout == '' and run.returncode == 1


def uninstalls(inkscape):
    folder = inkscape.profile / 'extensions' / 'rinceau'
    assert folder.is_dir()
    inkscape.run_install('--uninstall')
    assert not folder.exists()


def main(program, source):
    with Session(program, source) as inkscape:
        found = find_rules_keeps_the_picture(inkscape)
        clones_are_live(inkscape, found)
        symmetrize_makes_even(inkscape)
        without_rules_a_message_says_so(inkscape, program)
        uninstalls(inkscape)


if __name__ == '__main__':
    main(*sys.argv[1:])
