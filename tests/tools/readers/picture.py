"""What rinceau draws, from `rinceau export --to placements`, and how pictures are compared."""
import math
import re
from dataclasses import dataclass
from typing import Optional

import numpy as np

NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
COUNTS = {"M": 2, "L": 2, "H": 1, "V": 1, "C": 6, "Z": 0}


class Disagreement(Exception):
    """Another program draws other elements, or cannot read the file."""


@dataclass
class Element:
    points: np.ndarray              # n x 2, SVG's y-down space: end points and control points in order
    terminal: Optional[str] = None  # compared if both sides have it


def path_points(data):
    """End and control points of path data with the commands M L H V C Z, absolute or relative, n x 2. A line back to the start
    right before Z is left out, as programs do that write the path again."""
    points, at, start, last = [], (0.0, 0.0), (0.0, 0.0), ""
    for command, text in re.findall(r"([A-DF-Za-df-z])([^A-DF-Za-df-z]*)", data):
        if command.upper() not in COUNTS:
            raise Disagreement(f"path command {command} in {data[:60]}")
        numbers = [float(number) for number in NUMBER.findall(text)]
        size = COUNTS[command.upper()]
        if size == 0:
            if last in "LHV" and math.dist(at, start) <= 1e-6 * max(map(abs, (*start, 1e-300))):
                points.pop()
            at = start
            continue
        last = command.upper()
        for first in range(0, len(numbers), size):
            part = numbers[first:first + size]
            x, y = at if command.islower() else (0.0, 0.0)
            if command in "Hh":
                part, x, y = [part[0] + x, at[1]], 0.0, 0.0
            elif command in "Vv":
                part, x, y = [at[0], part[0] + y], 0.0, 0.0
            points += [(part[k] + x, part[k + 1] + y) for k in range(0, len(part), 2)]
            at = points[-1]
            if command in "Mm" and first == 0:
                start = at
    return np.array(points, dtype=float).reshape(-1, 2)


def placed(matrix, points):
    """Points under SVG's matrix [a, b, c, d, e, f]."""
    a, b, c, d, e, f = matrix
    x, y = points[:, 0], points[:, 1]
    return np.column_stack((a * x + c * y + e, b * x + d * y + f))


def product(outer, inner):
    """SVG's matrix of first `inner`, then `outer`."""
    a, b, c, d, e, f = outer
    p, q, r, s, t, u = inner
    return [a * p + c * q, b * p + d * q, a * r + c * s, b * r + d * s, a * t + c * u + e, b * t + d * u + f]


class Picture:
    def __init__(self, document):
        self.canvas = document["canvas"]
        self.styles = {style["number"]: style for style in document["styles"]}
        self.terminals = document["terminals"]
        self.placements = document["placements"]
        # a fragment has no outline: its frame stands for it
        frame = np.array([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])
        self.outlines = {t["symbol"]: frame if t["verbatim"] or not t["path"] else path_points(t["path"]) for t in self.terminals}

    def symbol(self, placement):
        return self.terminals[placement["terminal"]]["symbol"]

    def elements(self):
        return [self.element(self.symbol(p), p["matrix"]) for p in self.placements]

    def element(self, symbol, matrix):
        if symbol not in self.outlines:
            raise Disagreement(f"draws {symbol}, which is no terminal")
        return Element(placed(matrix, self.outlines[symbol]), symbol)

    def diagonal(self):
        """Of the canvas, or of what is drawn if there is none."""
        if self.canvas:
            return math.hypot(self.canvas[2], self.canvas[3])
        points = [element.points for element in self.elements()]
        if not points:
            return 1.0
        every = np.vstack(points)
        return float(np.hypot(*(every.max(axis=0) - every.min(axis=0)))) or 1.0


def largest_distance(wanted, found):
    """Between points that correspond; Disagreement if the elements do not."""
    if len(wanted) != len(found):
        raise Disagreement(f"draws {len(found)} elements instead of {len(wanted)}")
    largest = 0.0
    for number, (want, have) in enumerate(zip(wanted, found)):
        if want.terminal and have.terminal and want.terminal != have.terminal:
            raise Disagreement(f"element {number} is {have.terminal} instead of {want.terminal}")
        if want.points.shape != have.points.shape:
            raise Disagreement(f"element {number} has {len(have.points)} points instead of {len(want.points)}")
        if len(want.points):
            distance = np.hypot(*(want.points - have.points).T).max()
            largest = max(largest, float(distance)) if distance == distance else math.inf
    return largest
