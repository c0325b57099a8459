"""What is built here can be installed, used by another project, and removed.

install_test.py CMAKE BUILD SOURCE VERSION COMPILER FLAGS
"""
import gzip
import os
import pathlib
import re
import subprocess
import sys
import tempfile


def run(*words, **options):
    result = subprocess.run([str(word) for word in words], capture_output=True, text=True, **options)
    assert result.returncode == 0, f'{words}: {result.stdout}{result.stderr}'
    return result.stdout


def files_below(folder):
    return {path.relative_to(folder) for path in folder.rglob('*') if path.is_symlink() or not path.is_dir()}


def only(paths, ending):
    found = [path for path in paths if str(path).endswith(ending)]
    assert len(found) == 1, f'{ending}: {found}'
    return found[0]


class Installation:
    """All that was built, installed below a folder; the build's own list of installed files stays as it was."""

    def __init__(self, cmake, build, folder):
        self.cmake, self.folder = cmake, folder
        self.environment = dict(os.environ, DESTDIR=str(folder))
        own_list = pathlib.Path(build) / 'install_manifest.txt'
        before = own_list.read_bytes() if own_list.exists() else None
        run(cmake, '--install', build, env=self.environment)
        self.manifest = folder.parent / 'install_manifest.txt'
        self.manifest.write_bytes(own_list.read_bytes())
        own_list.unlink() if before is None else own_list.write_bytes(before)
        self.files = files_below(folder)

    def path(self, ending):
        return self.folder / only(self.files, ending)

    def remove(self, source):
        script = pathlib.Path(source) / 'scripts/uninstall.cmake'
        run(self.cmake, '-D', f'MANIFEST={self.manifest}', '-P', script, env=self.environment)


def list_is_complete(installation):
    listed = {line.lstrip('/') for line in installation.manifest.read_text().splitlines()}
    assert listed == {str(path) for path in installation.files}, 'what is installed is in the list of the uninstaller'


def program_runs(installation, version):
    program = installation.path('/bin/rinceau')
    assert run(program, '--version') == f'rinceau {version}\n'
    link = installation.path('/rinceau-inkscape')
    assert link.resolve() == program.resolve(), 'the extension for Inkscape calls the installed program'
    manual = gzip.decompress(installation.path('/man1/rinceau.1.gz').read_bytes()).decode()
    assert f'"rinceau {version}"' in manual
    for ending in ('/completions/rinceau', '/_rinceau', '/rinceau.fish', '/language.md'):
        assert installation.path(ending).stat().st_size > 0, ending


def editor_is_told_to_the_desktop(installation, version):
    assert run(installation.path('/bin/rinceau-editor'), '--version') == f'rinceau-editor {version}\n'
    manual = gzip.decompress(installation.path('/man1/rinceau-editor.1.gz').read_bytes()).decode().replace('\\-', '-')
    assert f'"rinceau {version}"' in manual
    shown = run(installation.path('/bin/rinceau-editor'), '--help')
    options = re.findall(r'^ +(?:-\w,)?(--[a-z-]+)', shown, flags=re.M)
    assert '--screenshot' in options
    for option in options:
        assert option in manual, f'{option} is not in the manual page of the editor'

    entry = installation.path('.desktop').read_text()
    assert re.search(r'^Exec=rinceau-editor %f$', entry, flags=re.M)
    opened = set(re.search(r'^MimeType=(.*);$', entry, flags=re.M).group(1).split(';'))
    kinds = installation.path('/mime/packages/rinceau.xml').read_text()
    declared = dict(re.findall(r'<mime-type type="(.*?)">.*?<glob pattern="\*(.*?)"/>', kinds, flags=re.S))
    assert set(declared.values()) == {'.lsys', '.fgsg', '.rinceau'}
    assert set(declared) <= opened, 'the editor opens every kind of file that it declares'
    assert f'<release version="{version}"' in installation.path('.metainfo.xml').read_text()

    icons = {path.parts[-3]: installation.folder / path for path in installation.files if path.parts[-2:] == ('apps', 'rinceau.png')}
    assert set(icons) == {'48x48', '64x64', '128x128', '256x256'}
    for size, path in icons.items():
        header = path.read_bytes()[:24]
        width, height = int.from_bytes(header[16:20], 'big'), int.from_bytes(header[20:24], 'big')
        assert f'{width}x{height}' == size


def second_project_finds_rules(installation, source, version, compiler, flags, folder):
    """The library, found by CMake and linked into another program, says what the installed program says."""
    prefix = installation.path('/bin/rinceau').parents[1]
    project = pathlib.Path(source) / 'tests/package/second_project'
    wanted = '.'.join(version.split('.')[:2])
    configure = [installation.cmake, '-S', project, '-B', folder / 'build', '-G', 'Ninja', f'-DCMAKE_PREFIX_PATH={prefix}',
                 f'-DCMAKE_CXX_COMPILER={compiler}', f'-DCMAKE_CXX_FLAGS={flags}']
    run(*configure, f'-DWANTED_VERSION={wanted}')
    run(installation.cmake, '--build', folder / 'build')
    found = run(folder / 'build/find_rules')
    assert 'Row(6)' in found and 'f(40)' in found, found
    drawing = re.search(r'<svg.*</svg>', (project / 'find_rules.cpp').read_text(), flags=re.S).group(0)
    (folder / 'row.svg').write_text(drawing)
    run(installation.path('/bin/rinceau'), 'analyze', folder / 'row.svg', '-o', folder / 'row.lsys')
    assert found == (folder / 'row.lsys').read_text()

    next_version = f'{wanted.split(".")[0]}.{int(wanted.split(".")[1]) + 1}'
    refused = subprocess.run([*map(str, configure), f'-DWANTED_VERSION={next_version}'], capture_output=True, text=True)
    assert refused.returncode != 0 and version in refused.stderr, 'a version that is not there is refused'


def removing_leaves_nothing(installation, source):
    kept = installation.folder / only(installation.files, '/cmake/rinceau/rinceauConfig.cmake').parent / 'of_others.txt'
    kept.write_text('not installed from here')
    installation.remove(source)
    left = files_below(installation.folder)
    assert left == {kept.relative_to(installation.folder)}, left
    folders = [path for path in installation.folder.rglob('rinceau*') if path.is_dir()]
    assert folders == [kept.parent], folders


def main(cmake, build, source, version, compiler, flags):
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        installation = Installation(cmake, build, folder / 'installed')
        list_is_complete(installation)
        program_runs(installation, version)
        if any(path.name == 'rinceau-editor' for path in installation.files):
            editor_is_told_to_the_desktop(installation, version)
        second_project_finds_rules(installation, source, version, compiler, flags, folder)
        removing_leaves_nothing(installation, source)


if __name__ == '__main__':
    main(*sys.argv[1:])
