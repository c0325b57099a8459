"""Context Free: cfdg draws the file as SVG, with a group per fill or stroke: one <use> of a path, and its matrix."""
import math
import shutil
import subprocess
import xml.etree.ElementTree as tree

import numpy as np

from .picture import Disagreement, Element, path_points, placed
from .svg import SVG, XLINK, matrix_of

FORMAT = "cfdg"
LIMIT = 2e-6  # cfdg writes eight digits

WIDEST = 1000  # pixels of the drawing that is compared


def missing():
    return None if shutil.which("cfdg") else "cfdg is not installed (Debian: contextfree)"


def paints(picture, placement):
    """How many groups cfdg writes for it: fill, stroke."""
    terminal = picture.terminals[placement["terminal"]]
    style = picture.styles.get(placement["style"], {"fill": "#000000", "stroke": "none"})
    if terminal["verbatim"] or not terminal["path"]:
        return 0
    return sum(style[paint] != "none" for paint in ("fill", "stroke"))


def drawn(picture):
    return [p for p in picture.placements if paints(picture, p)]


def elements(picture):
    return [picture.element(picture.symbol(p), p["matrix"]) for p in drawn(picture)]


def outlines(root):
    found = {}
    for path in root.iter(SVG + "path"):
        found[path.get("id")] = path_points(path.get("d", ""))
    return found


def from_pixels(picture, width, height, points):
    """From cfdg's drawing, which shows the canvas as large as it goes, to the picture."""
    left, top, across, down = picture.canvas
    scale = min(width / across, height / down)
    middle = np.array([width / 2, height / 2])
    return (points - middle) / scale + np.array([left + across / 2, top + down / 2])


def outside(picture, points):
    """Nothing of the outline lies on the canvas: cfdg leaves out what cannot be seen."""
    left, top, across, down = picture.canvas
    low, high = points.min(axis=0), points.max(axis=0)
    return high[0] <= left or high[1] <= top or low[0] >= left + across or low[1] >= top + down


def read(exported, picture, folder):
    output = folder / "cfdg.svg"
    size = []
    if picture.canvas:
        ratio = WIDEST / max(picture.canvas[2:])
        size = ["-s", f"{math.ceil(picture.canvas[2] * ratio)}x{math.ceil(picture.canvas[3] * ratio)}"]
    # lines of one width in all sizes come out of cfdg's SVG, and of it only, where the first of them is
    scaling = folder / "scaling.cfdg"
    scaling.write_text(exported.read_text().replace(" + CF::IsoWidth", "").replace(", CF::IsoWidth", ""))
    done = subprocess.run(["cfdg", "-q", "-V", *size, str(scaling), str(output)], capture_output=True, text=True, timeout=120)
    if done.returncode != 0 or not output.exists():
        raise Disagreement("cfdg: " + " ".join(done.stderr.split()))
    root = tree.parse(output).getroot()
    shapes = outlines(root)
    groups = []
    for group in root.iter(SVG + "g"):
        for node in group:
            name = node.get("id") if node.tag == SVG + "path" else node.get(XLINK, "")[1:]
            groups.append((name, placed(matrix_of(group), shapes[name])))
    if picture.canvas:
        width, height = (float(root.get(side).removesuffix("px")) for side in ("width", "height"))
        groups = [(name, from_pixels(picture, width, height, points)) for name, points in groups]
    else:
        groups = fitted(picture, groups)
    return paired(picture, groups)


def paired(picture, groups):
    """One element for the groups of its fill and its stroke."""
    found, at = [], 0
    near = picture.diagonal() * 1e-3
    for placement in drawn(picture):
        wanted = picture.element(picture.symbol(placement), placement["matrix"])
        part = groups[at:at + paints(picture, placement)]
        same = len(part) and all(name == part[0][0] and points.shape == wanted.points.shape and
                                 np.abs(points - wanted.points).max() < near for name, points in part)
        if same:
            at += len(part)
            found.append(Element(part[0][1]))
        elif picture.canvas and outside(picture, wanted.points):
            found.append(wanted)
        else:
            raise Disagreement(f"element {len(found)}, {picture.symbol(placement)}, is not drawn, or in another place or order")
    if at != len(groups):
        raise Disagreement(f"draws {len(groups)} fills and strokes instead of {at}")
    return found


def fitted(picture, groups):
    """Without a canvas cfdg chooses what to show: the scale and the shift that fit best are taken away."""
    wanted = [picture.element(picture.symbol(p), p["matrix"]).points for p in drawn(picture) for _ in range(paints(picture, p))]
    if not groups or [len(points) for _, points in groups] != [len(points) for points in wanted]:
        return groups
    have, want = np.vstack([points for _, points in groups]), np.vstack(wanted)
    centre, target = have.mean(axis=0), want.mean(axis=0)
    spread = ((have - centre) ** 2).sum()
    scale = ((have - centre) * (want - target)).sum() / spread if spread else 1.0
    return [(name, (points - centre) * scale + target) for name, points in groups]
