"""The extension in Inkscape.  extension_test.py PROGRAM SOURCE_FOLDER"""
import subprocess
import sys
import xml.etree.ElementTree as ET

import numpy

from documents import flower
from inkscape_session import HREF, SVG, Session, by_id, canonical, clones, difference, rules_groups, rules_of, tree

PETALS = [f'petal{i}' for i in range(8)]
UNTOUCHED = ['paper', 'stem', 'text', 'hidden', 'clone', 'lin']
NO_DIFFERENCE = 0.0005
GREEN = [0, 255, 0]


def select(*ids):
    return 'select-by-id:' + ','.join(ids)


def command(name):
    return f'org.rinceau.{name}.noprefs'


def expect_untouched(before, after, ids=UNTOUCHED):
    for name in ids:
        assert canonical(by_id(before, name)) == canonical(by_id(after, name)), f'{name} has changed'


def expect_all_around(where, number, least):
    """So many things around their middle: pixels in each of as many sectors."""
    rows, columns = numpy.nonzero(where)
    angles = numpy.arctan2(rows - rows.mean(), columns - columns.mean())
    counts, _ = numpy.histogram(angles, bins=number, range=(-numpy.pi, numpy.pi))
    assert (counts > least).all(), counts


def original_of_clones(group):
    """The id of the one thing that the group has clones of."""
    name, = {clone.get(HREF)[1:] for clone in clones(group)}
    return name


def name_of_the_original(program, document):
    arguments = ['--command=find_rules', *(f'--id={petal}' for petal in PETALS)]
    changed = subprocess.run([program, 'inkscape', *arguments, str(document)], check=True, capture_output=True).stdout
    group, = rules_groups(ET.fromstring(changed))
    return original_of_clones(group)


def find_rules_makes_live_clones(inkscape, program):
    document = inkscape.file('flower.svg', flower())
    name = name_of_the_original(program, document)
    before, found, painted = inkscape.act(document, [], [select(*PETALS), command('find-rules')],
                                          ['select-clear', select(name), 'object-set-property:fill,#00ff00'])
    assert difference(inkscape.picture(before), inkscape.picture(found)) < NO_DIFFERENCE
    old, new = tree(before), tree(found)
    expect_untouched(old, new)

    # the group with the rules stands where the petals stood
    ring = by_id(new, 'ring')
    assert ring.attrib == by_id(old, 'ring').attrib
    group, = rules_groups(new)
    assert group in list(ring)
    assert 'Ring_count = 8' in rules_of(group), rules_of(group)

    # one petal is real, the others are its clones: it turned green, and they did
    assert len(clones(group)) == 7
    assert original_of_clones(group) == name
    original = by_id(group, name)
    assert original.tag == SVG + 'path' and not any(original in list(defs) for defs in group.iter(SVG + 'defs'))
    assert not (inkscape.picture(found) == GREEN).all(axis=2).any()
    expect_all_around((inkscape.picture(painted) == GREEN).all(axis=2), number=8, least=50)


def symmetrize_makes_even(inkscape):
    crooked = inkscape.file('crooked.svg', flower([0, 43, 93, 136, 178, 226, 271, 313]))
    before, done = inkscape.act(crooked, [], [select(*PETALS), command('symmetrize')])
    even = inkscape.picture(inkscape.file('even.svg', flower()))
    apart = difference(even, inkscape.picture(crooked))
    left = difference(even, inkscape.picture(done))
    assert left < apart / 2, (left, apart)
    group, = rules_groups(tree(done))
    assert 'Ring_count = 8' in rules_of(group)
    expect_untouched(tree(before), tree(done))


def randomize_uses_the_rules_that_were_found(inkscape):
    inkscape.set_parameters({'randomize.angle': 6, 'randomize.distance': 10, 'randomize.seed': 5})
    before, random, again, even = inkscape.act(
        inkscape.file('random.svg', flower()), [], [select(*PETALS), command('find-rules'), command('randomize')],
        [command('randomize')], [command('symmetrize')])
    picture = inkscape.picture(random)
    assert difference(inkscape.picture(before), picture) > 0.005
    group, = rules_groups(tree(random))
    assert 'normal(' in rules_of(group) and 'seed 5' in rules_of(group), rules_of(group)
    assert len(clones(group)) == 7
    # the same noise takes the place of the same noise, and goes without a trace
    assert difference(picture, inkscape.picture(again)) < NO_DIFFERENCE
    assert difference(inkscape.picture(before), inkscape.picture(even)) < NO_DIFFERENCE
    expect_untouched(tree(before), tree(even))


def replace_takes_a_file_or_a_selected_object(inkscape):
    leaf = inkscape.file('leaf.svg', '<svg xmlns="http://www.w3.org/2000/svg"><circle r="3" fill="#00ff00"/></svg>')
    document = inkscape.file('replace.svg', flower())
    found, by_object = inkscape.act(document, [select(*PETALS), command('find-rules')],
                                    [select('stem'), command('replace')])
    inkscape.set_parameters({'replace.symbol': 'Petal', 'replace.with': leaf})
    by_file, = inkscape.act(found, [select(PETALS[-1]), command('replace')])
    expect_all_around((inkscape.picture(by_file) == GREEN).all(axis=2), number=8, least=20)
    for done in (by_object, by_file):
        group, = rules_groups(tree(done))
        assert len(clones(group)) == 7
        assert 'Petal' not in rules_of(group).split('terminal')[1].split(':')[0].replace('PetalNew', '')
        expect_untouched(tree(found), tree(done))
    dark_green = (numpy.abs(inkscape.picture(by_object) - [0, 128, 0]).max(axis=2) < 8).sum()
    assert dark_green > 1.5 * (numpy.abs(inkscape.picture(found) - [0, 128, 0]).max(axis=2) < 8).sum()


def without_rules_a_message_says_so(inkscape, program):
    """Asked as Inkscape asks: its dialog with the message would wait for a click."""
    document = inkscape.file('flower.svg', flower())
    for arguments, words in ((['--command=find_rules', '--id=stem', '--id=text'], 'No rule was found'),
                             (['--command=find_rules', '--id=hidden', '--id=paper'], 'nothing to work on'),
                             (['--command=replace', '--id=ring'], 'Nothing was given')):
        run = subprocess.run([program, 'inkscape', *arguments, str(document)], capture_output=True, text=True)
        assert words in run.stderr, run.stderr
        assert run.stdout == '' and run.returncode == 1


def uninstalls(inkscape):
    folder = inkscape.profile / 'extensions' / 'rinceau'
    assert folder.is_dir()
    inkscape.run_install('--uninstall')
    assert not folder.exists()


def main(program, source):
    with Session(program, source) as inkscape:
        without_rules_a_message_says_so(inkscape, program)
        find_rules_makes_live_clones(inkscape, program)
        symmetrize_makes_even(inkscape)
        randomize_uses_the_rules_that_were_found(inkscape)
        replace_takes_a_file_or_a_selected_object(inkscape)
        uninstalls(inkscape)


if __name__ == '__main__':
    main(*sys.argv[1:])
