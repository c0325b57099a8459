"""The kernels (bench/kernels, Google Benchmark): one step of the program each, at 1,000 to 100,000 things."""

import json
import subprocess

from .figures import figure
from .tables import exponent, table

SECONDS_OF = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}
LEAST_SECONDS = "0.05"  # that a kernel runs for at each size, so that a run of microseconds is a mean of many


def parsed(report):
    """{(kernel, asked size): (real size, [seconds of each repetition])} of Google Benchmark's JSON, in its order."""
    kernels = {}
    for one in report["benchmarks"]:
        if one.get("run_type") != "iteration" or one.get("error_occurred"):
            continue
        words = one["run_name"].split("/")
        asked = next(int(word) for word in words if word.isdigit())
        name = ", ".join(word.replace("_", " ") for word in words[:words.index(str(asked))])
        seconds = one["cpu_time"] * SECONDS_OF[one["time_unit"]]
        # items_per_second is by the processor's time, too
        real = round(one["items_per_second"] * seconds) if "items_per_second" in one else asked
        kernels.setdefault((name, asked), (real, []))[1].append(seconds)
    return kernels


def run(bench):
    program = bench.build / "bench/kernels/kernels"
    if not program.exists():
        bench.fail(f"{program} is not built: cmake -D RINCEAU_BUILD_BENCH=ON, target kernels")
        return [], ""
    out = bench.work / "kernels.json"
    command = [program, f"--benchmark_out={out}", "--benchmark_out_format=json", f"--benchmark_repetitions={bench.runs}",
               f"--benchmark_min_time={LEAST_SECONDS}"]
    matching = bench.match.replace(" ", "_") if bench.match else ""
    if bench.quick:
        command.append(f"--benchmark_filter={matching}.*/(1000|10000)(/|$)")
    elif matching:
        command.append(f"--benchmark_filter={matching}")
    bench.say("kernels")
    ended = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    if ended.returncode != 0:
        bench.fail(f"kernels: {ended.stderr.strip()[-300:]}")
        return [], ""
    if not out.stat().st_size:
        return [], ""  # no kernel has such a name
    kernels = parsed(json.loads(out.read_text()))
    figures = [figure("kernels", f"{name}, {asked:,}", "s", seconds, size=real)
               for (name, asked), (real, seconds) in kernels.items()]
    return figures, text_of(kernels)


def text_of(kernels):
    sizes = sorted({asked for _, asked in kernels})
    rows = []
    for name in dict.fromkeys(name for name, _ in kernels):
        cells = [kernels.get((name, size)) for size in sizes]
        points = [(real, min(seconds)) for real, seconds in filter(None, cells)]
        milliseconds = [1e3 * min(cell[1]) if cell else None for cell in cells]
        largest, least = points[-1]
        rows.append([name, *milliseconds, exponent(points), largest / least])
    return table(["kernel, milliseconds", *(f"{size:,}" for size in sizes), "exponent", "a second, at the largest"], rows)
