"""What the figures were measured on, and of which commit."""

import datetime
import os
import platform
import re
import subprocess
from pathlib import Path


def first_line(command, cwd=None):
    try:
        done = subprocess.run(command, capture_output=True, text=True, cwd=cwd)
    except OSError:
        return ""
    return done.stdout.splitlines()[0] if done.returncode == 0 and done.stdout else ""


def processor():
    try:
        found = re.search(r"model name\s*:\s*(.*)", Path("/proc/cpuinfo").read_text())
    except OSError:
        found = None
    return found.group(1).strip() if found else platform.processor() or "unknown"


def memory_gib():
    try:
        return round(os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 2**30, 1)
    except (OSError, ValueError):
        return None


def cached(build, name):
    """A value of CMake's cache, "" if it has none."""
    cache = Path(build) / "CMakeCache.txt"
    found = re.search(rf"^{name}:\w+=(.*)$", cache.read_text(), re.M) if cache.exists() else None
    return found.group(1) if found else ""


def commit(root):
    """The commit that the tree is at, with + if it was changed since; "unknown" outside of a repository."""
    name = first_line(["git", "rev-parse", "--short=12", "HEAD"], cwd=root)
    if not name:
        return "unknown"
    changed = subprocess.run(["git", "diff", "--quiet", "HEAD"], cwd=root).returncode != 0
    return name + ("+" if changed else "")


def described(root, build):
    compiler = cached(build, "CMAKE_CXX_COMPILER")
    return {
        "date": datetime.date.today().isoformat(),
        "commit": commit(root),
        "processor": processor(),
        "cores": len(os.sched_getaffinity(0)),
        "memory_gib": memory_gib(),
        "system": platform.platform(terse=True),
        "compiler": first_line([compiler, "--version"]) if compiler else "unknown",
        "build_type": cached(build, "CMAKE_BUILD_TYPE") or "unknown",
        "load": round(os.getloadavg()[0], 1),
    }


def sentence(machine):
    return (f"{machine['date']}, commit {machine['commit']}; {machine['processor']}, {machine['cores']} cores, "
            f"{machine['memory_gib']} GiB; {machine['compiler']}, {machine['build_type']}; load at the start {machine['load']}.")
