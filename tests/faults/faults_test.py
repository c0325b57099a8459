"""Faults while the program works: nothing that existed is lost, and it is said what went wrong.

faults_test.py PROGRAM SHIM ROOT FAULT... [--all]

Each fault is one of those at the end of this file; without --all it meets a handful of commands. A line tells what was tried.
"""
import errno
import os
import resource
import signal
import subprocess
import sys
import threading
import time

from commands import COMMANDS
from workshop import OLD, TEMPORARY, Workshop, same

MOST_CALLS = 500  # that change files, by one command
OUTPUT_NOT_WRITTEN = 4
LIMIT_REACHED = 3


def last_line(run):
    """The last that the program says; counters of `./test.sh coverage`, which fail too, have their word after it."""
    lines = [line for line in run.stderr.decode().strip().splitlines()
             if not line.startswith(('profiling:', 'libgcov profiling error:'))]
    return lines[-1] if lines else ''


def expect_not_written(run, command, code, where):
    """Status 4 and one sentence: the name, the cause and what to do."""
    assert run.returncode == OUTPUT_NOT_WRITTEN, f'{where}: status {run.returncode}, {run.stderr}'
    said = last_line(run)
    starts = [f'{name}: cannot be written: {os.strerror(code)}; ' for name in command.outputs]
    assert any(said.startswith(start) and len(said) > len(start) for start in starts), f'{where}: said {said!r}'


def killed(shop, commands, thorough):
    """SIGKILL at every call that changes a file"""
    kills = temporaries = 0
    for command in commands:
        new = shop.new_contents(command)
        for n in range(1, MOST_CALLS):
            shop.lay_out(command)
            run = shop.run(shop.words(command), fault=f'kill:{n}')
            if run.returncode == 0:
                break
            where = f'{command.name}, killed at call {n}'
            assert run.returncode == -signal.SIGKILL, f'{where}: {run.returncode} {run.stderr}'
            shop.expect_old_or_new(command, new, where, temporaries=1)
            kills += 1
            temporaries += sum(1 for entry in shop.desk.iterdir() if TEMPORARY.match(entry.name))
        assert n > 3, f'{command.name}: too few calls were seen'
        shop.expect_old_or_new(command, new, command.name)
    return f'{kills} kills: every file the old or the new one; {temporaries} left a temporary file'


def killed_late(shop, commands, thorough):
    """SIGKILL after a growing delay"""
    kills = 0
    for command in commands:
        new = shop.new_contents(command)
        start = time.monotonic()
        shop.run(shop.words(command))
        whole = time.monotonic() - start
        for part in range(1, 20 if thorough else 6):
            shop.lay_out(command)
            process = subprocess.Popen(shop.words(command), cwd=shop.desk, stdout=subprocess.DEVNULL,
                                       stderr=subprocess.DEVNULL)
            time.sleep(whole * part / (19 if thorough else 5))
            process.kill()
            kills += process.wait() == -signal.SIGKILL
            shop.expect_old_or_new(command, new, f'{command.name}, killed in between', temporaries=1)
        done = shop.run(shop.words(command))  # what is left over is in nobody's way
        assert done.returncode == 0, (command.name, done.stderr)
    return f'{kills} kills: every file the old or the new one'


def disk(shop, commands, thorough):
    """a disk that is full, or fails, from any call on"""
    failures = 0
    for command in commands:
        new = shop.new_contents(command)
        for code in (errno.ENOSPC, errno.EDQUOT, errno.EIO, errno.EROFS) if thorough else (errno.ENOSPC,):
            for n in range(1, MOST_CALLS):
                shop.lay_out(command)
                run = shop.run(shop.words(command), fault=f'{code}:{n}')
                where = f'{command.name}, {errno.errorcode[code]} from call {n} on'
                shop.expect_old_or_new(command, new, where)
                if run.returncode == 0:
                    break
                expect_not_written(run, command, code, where)
                failures += 1
            assert n > 3, f'{command.name}: too few calls were seen'
    return f'{failures} failures: status 4 with the name, the cause and the cure, nothing left over'


def small_disk(shop, commands, thorough):
    """a real disk of 64 KiB with an old file on it, and no room for the new one"""
    script = ('mount -t tmpfs -o size=64k tmpfs . 2>/dev/null || exit 77; cd "$PWD" && printf old > a.svg && head -c 60000 /dev/zero > full; '
              '"$1" render "$2" -o a.svg; status=$?; [ "$(cat a.svg)" = old ] || exit 78; [ "$(ls -A)" = "a.svg\nfull" ] || exit 79; exit $status')
    script = script.replace('\\n', '\n')
    run = shop.run(['unshare', '-rm', 'sh', '-c', script, 'sh', shop.program, shop.samples / 'fern.lsys'])
    if run.returncode in (1, 77) and b'cannot be written' not in run.stderr:
        return 'left out: no disk can be mounted here'
    assert run.returncode == OUTPUT_NOT_WRITTEN, (run.returncode, run.stderr)
    assert last_line(run).startswith('a.svg: cannot be written: No space left on device; make room'), run.stderr
    return 'status 4, the old file stands'


def too_large(shop, commands, thorough):
    """files may not become larger than 100 bytes (ulimit -f)"""
    for command in commands:
        shop.lay_out(command)
        run = shop.run(shop.words(command), limits=[(resource.RLIMIT_FSIZE, 100)])
        expect_not_written(run, command, errno.EFBIG, command.name)
        shop.expect_old_or_new(command, {name: OLD for name in command.outputs}, command.name)
    return f'{len(commands)} commands: status 4, the old files stand'


def forbidden(shop, commands, thorough):
    """a folder, or a file, that may not be written"""
    for command in commands:
        for case, folder_mode, file_mode in (('folder', 0o555, 0o666), ('file', 0o777, 0o444)):
            shop.lay_out(command, file_mode)
            shop.desk.chmod(folder_mode)
            run = shop.run(shop.words(command), as_nobody=True)
            where = f'{command.name}, read-only {case}'
            expect_not_written(run, command, errno.EACCES, where)
            shop.expect_old(command, where)
    return f'{2 * len(commands)} cases: status 4 before any work, the old files stand'


def stdout_full(shop, commands, thorough):
    """standard output is full, closed, or a pipe that nobody reads"""
    to_stdout = [['render', shop.samples / 'rosette.lsys'], ['derive', shop.samples / 'rosette.lsys'], ['--help'],
                 ['set', shop.samples / 'rosette.lsys']]
    if thorough:
        to_stdout += [['analyze', shop.samples / 'border.svg'], ['normalize', shop.samples / 'tiles.svg'], ['man'],
                      ['check', shop.samples / 'rosette.lsys'], ['completion', 'bash'], ['render', '--help'],
                      ['export', shop.samples / 'rosette.lsys', '--to', 'json'], ['--version'],
                      ['field', '--size', '2,1', '--element', 'wedge,5'], ['grow', shop.samples / 'border.lsys']]
    shop.clear()
    for words in to_stdout:
        words = [shop.program, *words]
        heard = shop.run(words)
        if not heard.stdout:
            continue
        with open('/dev/full', 'wb') as full:
            run = shop.run(words, stdout=full)
        assert run.returncode == OUTPUT_NOT_WRITTEN, (words, run.returncode, run.stderr)
        assert last_line(run).startswith('<stdout>: cannot be written: No space left on device; '), (words, run.stderr)
        run = shop.run(['sh', '-c', '"$@" >&-', 'sh', *words])
        assert run.returncode == OUTPUT_NOT_WRITTEN, (words, run.returncode, run.stderr)
        reader, writer = os.pipe()
        os.close(reader)
        run = shop.run(words, stdout=writer)
        os.close(writer)
        # no word of it; what there is to say of the input is said as ever
        assert run.returncode == -signal.SIGPIPE and heard.stderr.startswith(run.stderr), (words, run.returncode, run.stderr)
    # messages that nobody can hear neither end the program nor get into its output
    words = ['analyze', shop.samples / 'border.svg', '-o', 'a.lsys']
    shop.run([shop.program, *words])
    rules = (shop.desk / 'a.lsys').read_bytes()
    for silence in ('2>&-', '2>/dev/full', '2>&1 >/dev/null | true', '<&- >&- 2>&-'):
        (shop.desk / 'a.lsys').write_bytes(OLD)
        shop.run(['sh', '-c', f'"$@" {silence}', 'sh', shop.program, *words])
        assert (shop.desk / 'a.lsys').read_bytes() == rules, silence
    return f'{len(to_stdout)} commands: status 4 if it is full or closed, a quiet end by SIGPIPE if nobody reads'


def interrupted(shop, commands, thorough):
    """Ctrl-C, SIGTERM and SIGHUP after a growing delay"""
    ended = 0
    for command in commands:
        new = shop.new_contents(command)
        for what in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            for delay in (0.02, 0.05, 0.1, 0.2, 0.4) if thorough else (0.03, 0.2):
                shop.lay_out(command)
                process = subprocess.Popen(shop.words(command), cwd=shop.desk, stdout=subprocess.DEVNULL,
                                           stderr=subprocess.DEVNULL, preexec_fn=lambda: signal.signal(what, signal.SIG_DFL))
                time.sleep(delay)
                process.send_signal(what)
                status = process.wait()
                where = f'{command.name}, {what.name} after {delay} s'
                assert status in (0, -what), f'{where}: {status}'
                ended += status != 0
                shop.expect_old_or_new(command, new, where)
    return f'{ended} runs ended so: every file the old or the new one, nothing left over'


def least_memory(shop):
    """MiB of address space that let the program say its version: below, its libraries cannot be loaded."""
    low, high = 1, 4096
    while low < high:
        middle = (low + high) // 2
        run = shop.run([shop.program, '--version'], limits=[(resource.RLIMIT_AS, middle << 20)])
        low, high = (low, middle) if run.returncode == 0 else (middle + 1, high)
    return low


def memory(shop, commands, thorough):
    """address space (ulimit -v) from what loads the program to what suffices"""
    least = least_memory(shop)
    refused = 0
    for command in commands:
        new = shop.new_contents(command)
        for mib in range(least, least + 4096, 1 if thorough else 3):
            shop.lay_out(command)
            run = shop.run(shop.words(command), limits=[(resource.RLIMIT_AS, mib << 20)])
            where = f'{command.name} in {mib} MiB'
            shop.expect_old_or_new(command, new, where)
            if run.returncode == 0:
                break
            assert run.returncode == LIMIT_REACHED, f'{where}: status {run.returncode}, {run.stderr}'
            assert 'memory' in last_line(run), f'{where}: {run.stderr}'
            refused += 1
    return f'{refused} refusals: status 3 and a sentence, the files whole'


def together(shop, commands, thorough):
    """two processes write the same file again and again while a third reads it"""
    shop.clear()
    target = shop.desk / 'a.svg'
    words = [[shop.program, 'render', shop.samples / f'{name}.lsys', '-o', 'a.svg'] for name in ('fern', 'rosette')]
    whole = []
    for run in words:
        shop.run(run)
        whole.append(target.read_bytes())
    rounds = 60 if thorough else 8
    faults, seen, ending = [], set(), threading.Event()

    def write(run):
        for _ in range(rounds):
            faults.extend([] if shop.run(run).returncode == 0 else ['a writer failed'])

    def read():
        while not ending.is_set():
            now = target.read_bytes()
            seen.add(now)

    reader = threading.Thread(target=read)
    writers = [threading.Thread(target=write, args=(run,)) for run in words]
    for thread in (reader, *writers):
        thread.start()
    for writer in writers:
        writer.join()
    ending.set()
    reader.join()
    assert not faults, faults
    assert seen <= set(whole) and target.read_bytes() in whole, 'a file of neither was read'
    assert [entry.name for entry in shop.desk.iterdir()] == ['a.svg'], 'something is left over'
    return f'{2 * rounds} writes: every reader saw a whole file of one of them'


def put_drawings(shop, count):
    """art/00.svg ...: the first is large enough to wait for."""
    (shop.desk / 'art').mkdir()
    border = (shop.samples / 'border.svg').read_bytes()
    tiles = (shop.samples / 'tiles.svg').read_bytes()
    for i in range(count):
        (shop.desk / 'art' / f'{i:02}.svg').write_bytes(tiles if i == 0 else border)


def batch_words(shop, *more):
    return [str(shop.program), 'analyze', 'art', '-o', 'out', '--jobs', '1', *more]


def batches_together(shop, commands, thorough):
    """two batches into one folder"""
    shop.clear()
    put_drawings(shop, 6)
    processes = [subprocess.Popen(batch_words(shop), cwd=shop.desk, stderr=subprocess.PIPE) for _ in range(2)]
    said = [process.communicate()[1].decode() for process in processes]
    status = sorted(process.returncode for process in processes)
    assert status == [0, OUTPUT_NOT_WRITTEN], (status, said)
    assert any('another rinceau is at work in this folder' in text for text in said), said
    rows = (shop.desk / 'out/.rinceau/rows.jsonl').read_text().splitlines()
    assert len(rows) == 6 and all('"status":"done"' in row.replace(' ', '') for row in rows), rows
    return 'the second is refused with status 4, the first does all'


def vanished(shop, commands, thorough):
    """inputs that go, change or are cut off while a batch works; an output folder that goes"""
    shop.clear()
    put_drawings(shop, 6)
    process = subprocess.Popen(batch_words(shop, '--report', 'table.csv'), cwd=shop.desk, stderr=subprocess.PIPE)
    # the first is at work, the others are listed
    (shop.desk / 'art/03.svg').unlink()
    (shop.desk / 'art/04.svg').write_bytes((shop.samples / 'border.svg').read_bytes()[:200])
    said = process.communicate()[1].decode()
    rows = (shop.desk / 'table.csv').read_text().splitlines()[1:] if (shop.desk / 'table.csv').exists() else []
    assert process.returncode == 5, (process.returncode, said)
    assert sum(',done,' in row for row in rows) >= 4, rows
    assert not (shop.desk / 'out/04.lsys').exists() and (shop.desk / 'out/05.lsys').exists()

    shop.run(['rm', '-rf', 'out', 'table.csv'])
    process = subprocess.Popen(batch_words(shop), cwd=shop.desk, stderr=subprocess.PIPE)
    deadline = time.monotonic() + 20
    while not (shop.desk / 'out/00.lsys').exists() and time.monotonic() < deadline:
        time.sleep(0.002)
    os.rename(shop.desk / 'out', shop.desk / 'gone')
    said = process.communicate()[1].decode()
    assert process.returncode in (OUTPUT_NOT_WRITTEN, 5), (process.returncode, said)
    assert 'cannot be written: No such file or directory' in said, said

    (shop.desk / 'a.lsys').write_text('lsystem 1\nuse "leaf.lsys" as Leaf\naxiom: Leaf\n')
    run = shop.run([shop.program, 'render', 'a.lsys', '-o', 'a.svg'])
    assert run.returncode == 1 and b'leaf.lsys' in run.stderr, (run.returncode, run.stderr)
    assert not (shop.desk / 'a.svg').exists()
    return 'a row or a sentence for each, all others done'


FAULTS = {fault.__name__: fault for fault in (killed, killed_late, disk, small_disk, too_large, forbidden, stdout_full,
                                              interrupted, memory, together, batches_together, vanished)}


def main():
    words = [word for word in sys.argv[1:] if word != '--all']
    thorough = '--all' in sys.argv
    program, shim, root, *names = words
    commands = [command for command in COMMANDS if thorough or not command.thorough]
    for name in names or FAULTS:
        with Workshop(program, shim, root) as shop:
            start = time.monotonic()
            result = FAULTS[name](shop, commands, thorough)
            print(f'{name:16}  {FAULTS[name].__doc__}: {result}  ({time.monotonic() - start:.1f} s)', flush=True)


if __name__ == '__main__':
    main()
