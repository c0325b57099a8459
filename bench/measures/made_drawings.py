"""Grammars and drawings of any size, from bench/drawings."""

import math
import re
import subprocess
from pathlib import Path

DRAWINGS = Path(__file__).resolve().parent.parent / "drawings"
IN_A_SPRIG = 4  # elements of ornament.lsys
AREA_OF_ONE = 50 * 50  # of clutter.lsys


def with_definitions(text, values):
    for name, value in values.items():
        text, changed = re.subn(rf"^define {name} = .*$", f"define {name} = {value}", text, flags=re.M)
        if changed != 1:
            raise ValueError(f"no definition of {name}")
    return text


def ornament_rows(elements):
    """(rows, columns) of about so many elements."""
    sprigs = max(1, elements // IN_A_SPRIG)
    rows = max(1, math.isqrt(sprigs))
    return rows, sprigs // rows


def grammar(kind, elements, folder):
    """(file, the elements that it really draws); kind: ornament, clutter."""
    text = (DRAWINGS / f"{kind}.lsys").read_text()
    if kind == "ornament":
        rows, columns = ornament_rows(elements)
        text, size = with_definitions(text, {"rows": rows, "columns": columns}), IN_A_SPRIG * rows * columns
    else:
        side = math.isqrt(AREA_OF_ONE * elements)
        text, size = with_definitions(text, {"count": elements, "side": side}), elements
    file = Path(folder) / f"{kind}_{elements}.lsys"
    file.write_text(text)
    return file, size


def drawing(rinceau, kind, elements, folder):
    """The same as plain SVG without <use>: each element a path of its own, as drawing programs write them."""
    rules, size = grammar(kind, elements, folder)
    used, plain = rules.with_suffix(".use.svg"), rules.with_suffix(".svg")
    if not plain.exists():
        subprocess.run([rinceau, "render", rules, "-o", used, "--max-modules", "100000000"], check=True, capture_output=True)
        subprocess.run([rinceau, "normalize", used, "-o", plain], check=True, capture_output=True)
        used.unlink()
    return plain, size
