"""Commands of every verb that writes, small enough to be run many times, and the files that each writes."""
import dataclasses


@dataclasses.dataclass(frozen=True)
class Command:
    name: str       # verb and what it writes
    words: tuple    # without the program; {s} stands for the folder of samples
    outputs: tuple  # in the working folder
    thorough: bool = True  # only where every command is asked for


def command(name, words, *outputs, thorough=True):
    return Command(name, tuple(words.split()), outputs, thorough)


COMMANDS = [
    command('analyze', 'analyze {s}/border.svg -o a.lsys --report a.json --spaces a.csv', 'a.lsys', 'a.json', 'a.csv',
            thorough=False),
    command('analyze plots', 'analyze {s}/border.svg -o a.lsys --spaces a.svg', 'a.lsys', 'a.svg'),
    command('render svg', 'render {s}/rosette.lsys -o a.svg', 'a.svg', thorough=False),
    command('render png', 'render {s}/rosette.lsys -o a.png --width 40', 'a.png'),
    command('render pdf', 'render {s}/rosette.lsys -o a.pdf', 'a.pdf'),
    command('derive', 'derive {s}/rosette.lsys -o a.txt', 'a.txt'),
    command('set', 'set {s}/rosette.lsys canvas.width=300 -o a.lsys', 'a.lsys'),
    command('randomize', 'randomize {s}/tiles.lsys --angle 4 --seed 3 -o a.lsys', 'a.lsys'),
    command('symmetrize', 'symmetrize {s}/border.svg -o a.svg', 'a.svg'),
    command('replace', 'replace {s}/tiles.lsys Kite={s}/vine.svg -o a.lsys', 'a.lsys'),
    command('export json', 'export {s}/rosette.lsys --to json -o a.json', 'a.json'),
    command('export cpfg', 'export {s}/rosette.lsys --to cpfg -o a.l', 'a.l', 'a.v', 'a.map', thorough=False),
    command('normalize', 'normalize {s}/tiles.svg -o a.svg', 'a.svg'),
    command('arrange', 'arrange {s}/bricks.svg --count 9 -o a.svg --report a.json --connectivity b.svg --numbering c.svg',
            'a.svg', 'b.svg', 'c.svg', 'a.json'),
    command('arrange lsys', 'arrange {s}/bricks.svg --count 9 -o a.lsys', 'a.lsys'),
    command('pack', 'pack {s}/growth/dots.svg --size 90,60 -o a.svg --report a.json --height-map a.png --shaded b.png '
            '--width 40', 'a.svg', 'a.png', 'b.png', 'a.json'),
    command('pack json', 'pack {s}/growth/dots.svg --size 90,60 -o a.json', 'a.json'),
    command('pack obj', 'pack {s}/surface/torus.obj --size 9,6 -o a.obj', 'a.obj'),
    command('pack glb', 'pack {s}/surface/torus.obj --size 9,6 -o a.glb', 'a.glb', thorough=False),
    command('field', 'field {s}/surface/vase.obj --curvature --lines 0.1 --width 40 -o a.json -o a.png -o a.obj -o a.ply '
            '-o a.glb --report b.json', 'a.json', 'a.png', 'a.obj', 'a.ply', 'a.glb', 'b.json'),
    command('field svg', 'field --size 2,1 --element wedge,5 --lines 0.1 -o a.svg', 'a.svg'),
    command('grow glb', 'grow {s}/border.lsys --on {s}/surface/vase.obj -o a.glb --report a.json', 'a.glb', 'a.json'),
    command('grow obj', 'grow {s}/border.lsys --on {s}/surface/vase.obj -o a.obj', 'a.obj'),
    command('grow ply', 'grow {s}/border.lsys --on {s}/surface/vase.obj -o a.ply', 'a.ply'),
    command('grow png', 'grow {s}/border.lsys --on {s}/surface/vase.obj -o a.png --width 40', 'a.png'),
    command('grow svg', 'grow {s}/border.lsys -o a.svg', 'a.svg'),
]
