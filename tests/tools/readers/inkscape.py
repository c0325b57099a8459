"""Inkscape: opens the SVG with clones, unlinks them, saves the plain drawing, which is then read."""
import os
import shutil
import subprocess

from .picture import Disagreement
from .svg import elements, elements_of_file

FORMAT = "svg"
ENDING = ".svg"
LIMIT = 2e-6  # Inkscape writes eight digits

__all__ = ["elements"]


def missing():
    return None if shutil.which("inkscape") else "inkscape is not installed (Debian: inkscape)"


def run(source, actions, folder):
    """Inkscape without a window; with folders of its own, so that several can run at a time."""
    environment = {**os.environ, "HOME": str(folder), "XDG_CONFIG_HOME": str(folder / "config"), "SELF_CALL": "1"}
    environment.pop("DISPLAY", None)
    done = subprocess.run(["inkscape", "--actions=" + ";".join(actions), str(source)], env=environment, capture_output=True,
                          text=True, timeout=300)
    if done.returncode != 0:
        raise Disagreement("inkscape: " + done.stderr.strip()[:300])


def read(exported, picture, folder):
    flat = folder / "flat.svg"
    # a group's clones may hold clones: unlinking is repeated until none is left
    run(exported, ["select-all:all", "clone-unlink-recursively", f"export-filename:{flat}", "export-plain-svg", "export-do"], folder)
    if not flat.exists():
        raise Disagreement("inkscape wrote nothing")
    return elements_of_file(flat)
