"""Runs one command and says what it took: python3 -I -S one_run.py RESULT COMMAND...

A process of its own, because the memory that a process is said to have had at its peak is never less than that of the one
that started it: this one is small. Writes status, seconds of the processor, seconds by the clock and KiB at the peak."""

import os
import sys
import time

result, command = sys.argv[1], sys.argv[2:]
begin = time.monotonic()
try:
    child = os.posix_spawnp(command[0], command, os.environ)
except OSError as error:
    sys.exit(f"{command[0]}: {error.strerror}")
_, status, used = os.wait4(child, 0)
wall = time.monotonic() - begin
with open(result, "w") as out:
    out.write(f"{os.waitstatus_to_exitcode(status)} {used.ru_utime + used.ru_stime} {wall} {used.ru_maxrss}\n")
