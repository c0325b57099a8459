"""The manual page and the completion scripts know every verb and option that help knows.  manual_test.py PROGRAM"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile


def run(*words, **options):
    return subprocess.run(words, check=True, capture_output=True, text=True, **options)


def help_entries(text):
    """The first words of the entries in a help text, and those of the positional arguments."""
    section, options, positionals, verbs = '', [], [], []
    for line in text.splitlines():
        if line and not line.startswith(' '):
            section = line
        entry = re.match(r'  (\S.*)', line)
        if entry is None:
            continue
        if section == 'Options:':
            options += re.findall(r'(?:^|,)(--?[A-Za-z-]+)', entry.group(1).split(' ')[0])
        elif section == 'Positionals:':
            positionals.append(entry.group(1).split(' ')[0])
        elif section == 'Subcommands:':
            verbs.append(entry.group(1).split(' ')[0])
    return options, positionals, verbs


def manual_is_clean_and_whole(program, known):
    page = run(program, 'man').stdout
    for command in (['groff', '-ww', '-man', '-z', '-Tutf8'], ['man', '--warnings', '-l', '-']):
        if shutil.which(command[0]) is not None:
            said = run(*command, input=page, env=dict(os.environ, MANWIDTH='100', LC_ALL='C.UTF-8')).stderr
            assert said == '', said
    sections = dict(zip(*[iter(re.split(r'^\.SS (.*)\n', page, flags=re.M)[1:])] * 2))
    plain = {verb.replace('\\-', '-'): text.replace('\\-', '-') for verb, text in sections.items()}
    assert list(plain) == list(known), 'the verbs of the page are those of the help'
    for verb, (options, positionals) in known.items():
        for name in options + positionals:
            assert re.search(r'\\f[BI]' + re.escape(name) + r'\\fR', plain[verb]), f'{verb}: {name} is not in the manual'


def completed(script, folder, *words):
    """What bash offers for the last word."""
    asked = ('source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _rinceau; '
             'printf "%s\\n" "${COMPREPLY[@]}"')
    return set(run('bash', '-c', asked, 'bash', str(script), 'rinceau', *words, cwd=folder).stdout.split())


def bash_completes(program, known, folder):
    script = folder / 'rinceau.bash'
    script.write_text(run(program, 'completion', 'bash').stdout)
    run('bash', '-n', str(script))
    place = folder / 'place'
    (place / 'folder').mkdir(parents=True)
    for name in ('a.svg', 'b.lsys', 'c.json', 'd.png', 'e.txt', 'f.fgsg', 'g.obj'):
        (place / name).touch()

    def offers(*words):
        return completed(script, place, *words)

    assert set(known) <= offers('')
    assert offers('ana') == {'analyze'}
    assert '--version' in offers('--')
    for verb, (options, _) in known.items():
        assert offers(verb, '-') == set(options), verb
    assert offers('grow', '') == {'a.svg', 'b.lsys', 'c.json', 'f.fgsg', 'folder'}
    assert offers('grow', 'f.fgsg', '--on', '') == {'g.obj', 'folder'}
    assert offers('grow', 'f.fgsg', '--instancing', 'n') == {'nodes'}
    assert offers('check', '') == {'b.lsys', 'f.fgsg', 'folder'}
    assert offers('field', '') == {'g.obj', 'folder'}
    assert offers('field', 'g.obj', '--elements', '') == {'c.json', 'folder'}
    assert offers('field', 'g.obj', '--image', '') == {'d.png', 'folder'}
    assert offers('analyze', '') == {'a.svg', 'folder'}
    assert offers('analyze', '--tolerance', '0.1', '') == {'a.svg', 'folder'}
    assert offers('analyze', 'a.svg', '-o', '') == {'b.lsys', 'folder'}
    assert offers('analyze', 'a.svg', '--report', '=', 'c') == {'c.json'}
    assert offers('analyze', 'a.svg', '--report', '=') == {'c.json', 'folder'}
    assert offers('analyze', '--objective', '') == {'bits', 'paper'}
    assert offers('render', '') == {'b.lsys', 'folder'}
    assert offers('render', 'b.lsys', '-o', '') == {'a.svg', 'd.png', 'folder'}
    assert offers('render', 'b.lsys', '--color-by', 'l') == {'level'}
    assert 'svg' in offers('export', 'b.lsys', '--to', '')
    assert offers('completion', '') == {'bash', 'zsh', 'fish'}


def other_shells_can_read_theirs(program, known, folder):
    for shell in ('zsh', 'fish'):
        text = run(program, 'completion', shell).stdout
        for verb, (options, _) in known.items():
            assert re.search(rf'\b{verb}\b', text), f'{shell}: {verb}'
            for name in options:
                assert name.lstrip('-') in text, f'{shell}: {verb} {name}'
        if shutil.which(shell) is None:
            print(f'{shell} is not installed: its script was not read by it')
            continue
        script = folder / f'rinceau.{shell}'
        script.write_text(text)
        run(shell, '-n', str(script))


def main(program):
    known = {}
    for verb in help_entries(run(program, '--help').stdout)[2]:
        options, positionals, _ = help_entries(run(program, verb, '--help').stdout)
        assert '--help' in options, verb
        known[verb] = options, positionals
    assert {'analyze', 'render', 'export', 'completion'} <= set(known)
    manual_is_clean_and_whole(program, known)
    with tempfile.TemporaryDirectory() as folder:
        bash_completes(program, known, pathlib.Path(folder))
        other_shells_can_read_theirs(program, known, pathlib.Path(folder))


if __name__ == '__main__':
    main(*sys.argv[1:])
