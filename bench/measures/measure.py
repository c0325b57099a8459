"""What a command takes: seconds of the processor, of all its processes together, and memory at its peak."""

import subprocess
import sys
import tempfile
from dataclasses import dataclass, field
from pathlib import Path

ONE_RUN = Path(__file__).with_name("one_run.py")
LONG_SECONDS = 10  # a run that takes so long is not repeated: what disturbs it evens out


class CommandFailed(Exception):
    pass


@dataclass
class Taken:
    """Of several runs of one command."""

    command: str
    runs: list = field(default_factory=list)  # seconds of the processor
    walls: list = field(default_factory=list)  # seconds by the clock
    peak_mib: float = 0.0

    @property
    def seconds(self):
        """The least: what else the machine does only ever adds."""
        return min(self.runs)


def shown(command, folders):
    """The command as a person types it: `folders` maps long paths to what stands for them."""
    text = " ".join(str(word) for word in command)
    for long, short in folders.items():
        text = text.replace(str(long), short)
    return text


def taken(command, runs=1, folders=None, cwd=None, good=(0,)):
    """Runs the command so often, or once if that is long; its output goes nowhere. Raises CommandFailed unless it ends with a status in `good`."""
    words = [str(word) for word in command]
    result = Taken(shown(words, folders or {}))
    with tempfile.TemporaryDirectory() as folder:
        numbers, said = Path(folder) / "numbers", Path(folder) / "said"
        for _ in range(runs):
            with open(said, "wb") as out:
                ended = subprocess.run([sys.executable, "-I", "-S", ONE_RUN, numbers, *words], cwd=cwd,
                                       stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=out)
            if ended.returncode != 0:
                raise CommandFailed(f"{result.command}: {said.read_text(errors='replace').strip()[-300:]}")
            status, seconds, wall, kib = (float(number) for number in numbers.read_text().split())
            if int(status) not in good:
                words_said = said.read_text(errors="replace").strip()[-300:]
                raise CommandFailed(f"{result.command}: exit status {int(status)}: {words_said}")
            result.runs.append(seconds)
            result.walls.append(wall)
            result.peak_mib = max(result.peak_mib, kib / 1024)
            if seconds > LONG_SECONDS:
                break
    return result
