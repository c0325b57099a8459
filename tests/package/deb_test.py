"""The Debian packages can be installed, used and removed.  deb_test.py FOLDER

They go into an empty root of their own, not into the system. The last line reads "N passed, M failed".
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import traceback

PACKAGES = {'rinceau', 'rinceau-editor', 'librinceau-dev'}
ENVIRONMENT = dict(os.environ, LC_ALL='C.UTF-8', PATH=os.environ['PATH'] + ':/usr/sbin:/sbin')
AS_ROOT = [] if os.geteuid() == 0 else ['fakeroot']


def run(*words, **options):
    options.setdefault('env', ENVIRONMENT)
    result = subprocess.run([str(word) for word in words], capture_output=True, text=True, **options)
    assert result.returncode == 0, f'{words}: {result.stdout}{result.stderr}'
    return result.stdout


def names_in(dependencies):
    return set(re.findall(r'(?:^|[,|] *)([a-z0-9][a-z0-9+.-]+)', dependencies))


class Packages:
    def __init__(self, folder):
        self.files = {}
        for path in sorted(pathlib.Path(folder).glob('*.deb')):
            self.files[self.field(path, 'Package')] = path
        assert set(self.files) == PACKAGES, self.files

    def field(self, package, name):
        return run('dpkg-deb', '-f', self.files.get(package, package), name).strip()

    def contents(self, package):
        return {line.split()[5].lstrip('.') for line in run('dpkg-deb', '-c', self.files[package]).splitlines()}


class Root:
    """An empty system: nothing but dpkg's own tables. Its packages lack what they depend on, so dpkg is told not to mind."""

    def __init__(self, folder):
        self.folder = folder
        for name in ('updates', 'info', 'triggers'):
            (folder / 'var/lib/dpkg' / name).mkdir(parents=True)
        for name in ('status', 'available'):
            (folder / 'var/lib/dpkg' / name).touch()

    def dpkg(self, *words):
        return run(*AS_ROOT, 'dpkg', f'--root={self.folder}', '--log=/dev/null', '--force-depends', *words)

    def known_packages(self):
        return set(re.findall(r'^Package: (.*)$', (self.folder / 'var/lib/dpkg/status').read_text(), flags=re.M))

    def entries(self):
        """All files and folders but dpkg's."""
        return sorted(path for path in self.folder.rglob('*')
                      if path.relative_to(self.folder).parts[:3] != ('var', 'lib', 'dpkg')
                      and path.relative_to(self.folder).parts not in {('var',), ('var', 'lib')})


def fields_say_what_it_is(packages):
    for package in PACKAGES:
        assert packages.field(package, 'Section') in {'graphics', 'libdevel'}, package
        assert re.fullmatch(r'.+ <.+@.+>', packages.field(package, 'Maintainer')), package
        summary, *text = packages.field(package, 'Description').splitlines()
        assert len(summary) < 80 and len(text) > 3, package
        assert int(packages.field(package, 'Installed-Size')) > 0, package
        papers = f'/usr/share/doc/{package}/'
        assert {papers + 'copyright', papers + 'changelog.Debian.gz'} <= packages.contents(package), package


def no_file_is_in_two_packages(packages):
    owners = {}
    for package in PACKAGES:
        for path in packages.contents(package):
            if not path.endswith('/'):
                assert path not in owners, f'{path} is in {owners[path]} and in {package}'
                owners[path] = package
    for path in owners:
        assert path.startswith('/usr/') and not path.startswith('/usr/local/'), path


def depends_are_what_the_programs_load(packages, root):
    """The loader's own list of libraries, and Debian's list of who holds them, against what the packages say."""
    for package in ('rinceau', 'rinceau-editor'):
        wanted = names_in(packages.field(package, 'Depends'))
        loaded = re.findall(r'\(NEEDED\).*\[(.*)\]', run('readelf', '-dW', root.folder / 'usr/bin' / package))
        assert 'libc.so.6' in loaded
        for library in loaded:
            holders = {line.split(':')[0] for line in run('dpkg-query', '-S', f'*/{library}').splitlines()}
            assert holders & wanted, f'{package} loads {library} of {holders}, and depends on {wanted}'


def apt_can_install_them(packages):
    said = run('apt-get', '--simulate', 'install', *(path.resolve() for path in packages.files.values()))
    for package in PACKAGES:
        assert re.search(rf'^Inst {package} ', said, flags=re.M), said


def programs_run(packages, root):
    version = packages.field('rinceau', 'Version').rpartition('-')[0]
    for program in ('rinceau', 'rinceau-editor'):
        assert run(root.folder / 'usr/bin' / program, '--version') == f'{program} {version}\n'
    drawing = root.folder / 'usr/share/rinceau/samples/fig10_facade.svg'
    assert 'Grid(3)' in run(root.folder / 'usr/bin/rinceau', 'analyze', drawing)


def desktop_knows_the_files(root, scratch):
    share = root.folder / 'usr/share'
    run('desktop-file-validate', share / 'applications/org.rinceau.editor.desktop')
    run('appstreamcli', 'validate', '--no-net', share / 'metainfo/org.rinceau.editor.metainfo.xml')
    kinds = scratch / 'mime'
    shutil.copytree(share / 'mime', kinds)
    run('update-mime-database', kinds)
    known = dict(reversed(line.split(':')[1:]) for line in (kinds / 'globs2').read_text().splitlines() if line[0] != '#')
    assert known['*.lsys'] == 'text/x-rinceau-grammar' and known['*.fgsg'] == 'text/x-rinceau-shape-grammar'


def lintian_finds_no_error(packages):
    if shutil.which('lintian') is None:
        print('lintian is not installed: the packages were not read by it')
        return
    # The packager's address is whatever was asked for.
    said = subprocess.run(['lintian', '--allow-root', '--suppress-tags', 'bogus-mail-host,bogus-mail-host-in-debian-changelog',
                           *map(str, packages.files.values())], capture_output=True, text=True, env=ENVIRONMENT).stdout
    print(said, end='')
    assert not re.search(r'^E:', said, flags=re.M)


def removing_leaves_nothing(root):
    assert root.known_packages() == PACKAGES
    root.dpkg('--remove', *PACKAGES)
    assert root.known_packages() == set(), 'packages without settings are forgotten when they are removed'
    assert root.entries() == [], root.entries()


def main(folder):
    packages = Packages(folder)
    failed = []
    with tempfile.TemporaryDirectory() as scratch:
        scratch = pathlib.Path(scratch)
        root = Root(scratch / 'root')
        root.dpkg('--install', *packages.files.values())
        checks = [(fields_say_what_it_is, packages), (no_file_is_in_two_packages, packages),
                  (depends_are_what_the_programs_load, packages, root), (apt_can_install_them, packages),
                  (programs_run, packages, root), (desktop_knows_the_files, root, scratch),
                  (lintian_finds_no_error, packages), (removing_leaves_nothing, root)]
        for check, *arguments in checks:
            try:
                check(*arguments)
                print(f'passed: {check.__name__.replace("_", " ")}')
            except Exception:  # all are run, whatever one finds
                traceback.print_exc()
                failed.append(check.__name__)
                print(f'FAILED: {check.__name__.replace("_", " ")}')
    print(f'{len(checks) - len(failed)} passed, {len(failed)} failed')
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main(*sys.argv[1:]))
