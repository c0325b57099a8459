"""A folder in which the program is run with faults, and what must stand in it afterwards."""
import json
import os
import pathlib
import re
import resource
import shutil
import subprocess
import tempfile

OLD = b'what stood here before\n'
NOBODY = 65534
TEMPORARY = re.compile(r'\.rinceau-\d+-\d+$')
LONGEST = 120  # seconds, for any run


def without_seconds(data):
    """Reports hold times, which differ from run to run."""
    if isinstance(data, dict):
        return {key: without_seconds(value) for key, value in data.items() if key != 'seconds'}
    return [without_seconds(value) for value in data] if isinstance(data, list) else data


def same(name, one, other):
    if one == other:
        return True
    if not name.endswith('.json') or OLD in (one, other):
        return False
    try:
        return without_seconds(json.loads(one)) == without_seconds(json.loads(other))
    except ValueError:
        return False


class Workshop:
    """Temporary, with a copy of the samples and of the program that everybody may read."""

    def __init__(self, program, shim, root):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix='rinceau-faults-'))
        self.folder.chmod(0o755)
        self.samples = self.folder / 'samples'
        shutil.copytree(pathlib.Path(root) / 'samples', self.samples)
        self.program = self.folder / 'rinceau'
        shutil.copy(program, self.program)
        self.shim = self.folder / 'shim.so'
        shutil.copy(shim, self.shim)
        self.desk = self.folder / 'desk'
        self.desk.mkdir()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        shutil.rmtree(self.folder)

    def clear(self):
        self.desk.chmod(0o755)
        for entry in self.desk.iterdir():
            shutil.rmtree(entry) if entry.is_dir() and not entry.is_symlink() else entry.unlink()

    def lay_out(self, command, mode=0o644):
        """Nothing but an old file for each output."""
        self.clear()
        for name in command.outputs:
            (self.desk / name).write_bytes(OLD)
            (self.desk / name).chmod(mode)

    def words(self, command):
        return [str(self.program)] + [word.format(s=self.samples) for word in command.words]

    def run(self, words, fault=None, limits=(), as_nobody=False, **options):
        """The finished process; `fault` as fault_shim.cpp has it, `limits` pairs of a resource and its limit."""
        environment = dict(os.environ)
        if fault:
            environment.update(LD_PRELOAD=str(self.shim), RINCEAU_FAULT=fault)
            checks = environment.get('ASAN_OPTIONS', '')
            environment['ASAN_OPTIONS'] = checks + ':verify_asan_link_order=0'

        def prepare():
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
            for kind, limit in limits:
                resource.setrlimit(kind, (limit, limit))
            if as_nobody and os.geteuid() == 0:
                os.setgroups([])
                os.setgid(NOBODY)
                os.setuid(NOBODY)

        options.setdefault('stdout', subprocess.PIPE)
        options.setdefault('stderr', subprocess.PIPE)
        options.setdefault('stdin', subprocess.DEVNULL)
        return subprocess.run([str(word) for word in words], cwd=self.desk, env=environment, preexec_fn=prepare,
                              timeout=LONGEST, check=False, **options)

    def new_contents(self, command):
        """What the command writes if nothing goes wrong."""
        self.lay_out(command)
        done = self.run(self.words(command))
        assert done.returncode == 0, (command.name, done.returncode, done.stderr)
        contents = {name: (self.desk / name).read_bytes() for name in command.outputs}
        assert OLD not in contents.values(), command.name
        return contents

    def expect_old_or_new(self, command, new, where, temporaries=0):
        """Every output is as it was, or whole; beside them are at most so many files of the program's own."""
        for name in command.outputs:
            now = (self.desk / name).read_bytes()
            assert now == OLD or same(name, now, new[name]), f'{where}: {name} is neither the old file nor the new one'
        left = {entry.name for entry in self.desk.iterdir()} - set(command.outputs)
        assert all(TEMPORARY.match(name) for name in left) and len(left) <= temporaries, f'{where}: {left} is left over'

    def expect_old(self, command, where):
        for name in command.outputs:
            assert (self.desk / name).read_bytes() == OLD, f'{where}: {name} was changed'
        assert {entry.name for entry in self.desk.iterdir()} == set(command.outputs), where
