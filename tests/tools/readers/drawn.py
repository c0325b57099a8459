"""Drawings made of lines and filled polygons, compared with the outlines that rinceau draws.

A reader gives what its program draws in order: Line and Fill. Curves are exact (Bezier pieces) or polylines; polylines must
lie on the outline at their corners and keep to it between them. The distance that counts is that of the outline's own corners.
"""
import math
from dataclasses import dataclass, field
from typing import Optional

import numpy as np

from .picture import Disagreement, Element, placed

FLATNESS = 1 / 2000  # of a shape's size: by so much a polyline may leave its curve
ON_CURVE = 1e-3      # share of that: corners of polylines lie on the curve to within this, or a file's own precision


@dataclass
class Line:
    pieces: list                    # each an n x 2 polyline or, with n = 4 and in `curved`, a cubic; joined end to end
    curved: list = field(default_factory=list)  # numbers of the pieces that are cubics
    color: Optional[tuple] = None
    width: Optional[float] = None   # as drawn, in the picture's units
    exact: bool = False             # segment by segment as the outline, curves as cubics


@dataclass
class Fill:
    polygon: np.ndarray             # n x 2
    color: Optional[tuple] = None


class Outline:
    """A terminal's sub-paths as lists of segments, each 2 x 2 (straight) or 4 x 2 (cubic), y down."""

    def __init__(self, data):
        self.paths = [path for path in sub_paths(data) if path]
        every = [segment for path in self.paths for segment in path]
        self.size = float(np.hypot(*np.ptp(np.vstack([bounds_of(s) for s in every]), axis=0))) if every else 0.0

    def placed(self, matrix):
        return [[placed(matrix, segment) for segment in path] for path in self.paths]


def bounds_of(segment):
    if len(segment) == 2:
        return segment
    return cubic(segment, np.linspace(0, 1, 65))


def sub_paths(data):
    import re
    number = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"
    paths, path, at, start = [], [], np.zeros(2), np.zeros(2)
    closed_at = None
    for command, text in re.findall(r"([MLHVCZz])([^MLHVCZz]*)", data):
        values = [float(v) for v in re.findall(number, text)]
        if command in "Zz":
            if np.any(at != start):
                path.append(np.array([at, start]))
            at, closed_at = start, True
            paths.append(path)
            path = []
            continue
        if command == "M":
            if path:
                paths.append(path)
            path, at = [], np.array(values[:2])
            start, values, command = at, values[2:], "L"
        size = {"L": 2, "H": 1, "V": 1, "C": 6}[command]
        for k in range(0, len(values), size):
            part = values[k:k + size]
            if command == "H":
                part = [part[0], at[1]]
            elif command == "V":
                part = [at[0], part[0]]
            points = np.array([at[0], at[1], *part]).reshape(-1, 2)
            if command == "C" or np.any(points[0] != points[1]):
                path.append(points)
            at = points[-1]
    if path:
        paths.append(path)
    return paths


def cubic(points, t):
    t = np.asarray(t, dtype=float)[:, None]
    u = 1 - t
    return u**3 * points[0] + 3 * u * u * t * points[1] + 3 * u * t * t * points[2] + t**3 * points[3]


def distance_to_segment(points, segment):
    """Of each point to a straight or cubic segment."""
    points = np.atleast_2d(points)
    if len(segment) == 2:
        a, way = segment[0], segment[1] - segment[0]
        share = np.clip(((points - a) @ way) / max(float(way @ way), 1e-300), 0, 1)
        return np.hypot(*(points - a - share[:, None] * way).T)
    t = np.linspace(0, 1, 129)
    on = cubic(segment, t)
    best = np.argmin(((points[:, None, :] - on[None, :, :])**2).sum(axis=2), axis=1)
    low, high = t[np.maximum(best - 1, 0)], t[np.minimum(best + 1, 128)]
    for _ in range(60):  # golden sections would do; thirds are simple
        a, b = low + (high - low) / 3, high - (high - low) / 3
        nearer = np.hypot(*(points - cubic(segment, a)).T) < np.hypot(*(points - cubic(segment, b)).T)
        high, low = np.where(nearer, b, high), np.where(nearer, low, a)
    return np.hypot(*(points - cubic(segment, (low + high) / 2)).T)


def corners_of(path):
    return np.vstack([path[0][:1]] + [segment[-1:] for segment in path])


def polyline_of(line):
    """All corners of a line whose pieces are polylines."""
    return np.vstack([line.pieces[0]] + [piece[1:] for piece in line.pieces[1:]])


class Comparison:
    """Of what a format draws with what is wanted; gives pairs of corresponding points."""

    def __init__(self, picture, precision, colors=True, width_of=None, fills=True):
        """fills: False where a fill without stroke is drawn as its outline. precision: the format's, as a share of the diagonal; width_of(style width, scale) -> width as drawn."""
        self.picture, self.colors, self.width_of, self.fills = picture, colors, width_of, fills
        self.precision = precision * picture.diagonal()
        self.outlines = [Outline(t["path"] or "") for t in picture.terminals]
        self.thoroughly_checked = set()

    def pairs(self, drawn):
        """[(wanted points, found points)], one for each line and fill; Disagreement if they do not correspond."""
        faults = []
        for order in self.orders():
            try:
                return self.pairs_in_order(order, drawn)
            except Disagreement as fault:
                faults.append(fault)
        raise faults[0]

    def orders(self):
        """In paint order; and, for programs without layers, in order of derivation."""
        placements = self.picture.placements
        yield placements
        if all("order" in p for p in placements) and len({p["layer"] for p in placements}) > 1:
            yield sorted(placements, key=lambda p: p["order"])

    def wanted(self, placements):
        for placement in placements:
            terminal = self.picture.terminals[placement["terminal"]]
            if terminal["verbatim"]:
                continue
            outline = self.outlines[placement["terminal"]]
            style = self.picture.styles.get(placement["style"], {"fill": "#000000", "stroke": "none"})
            fill = placement.get("fill", style["fill"])
            stroke = placement.get("stroke", style["stroke"])
            a, b, c, d = placement["matrix"][:4]
            scale = math.sqrt(abs(a * d - b * c))
            paths = outline.placed(placement["matrix"])
            key = (placement["terminal"], placement["style"], fill, stroke)
            parts = []
            if fill != "none" and self.fills:
                parts.append(("fill", fill, None))
            elif fill != "none" and (stroke == "none" or style["stroke_width"] <= 0):
                paths = [closed(path) for path in paths if encloses(path)]
                parts.append(("line", fill, None))
            if stroke != "none" and style["stroke_width"] > 0:
                parts.append(("line", stroke, (style["stroke_width"], 1.0 if style.get("fixed") else scale)))
            if style.get("stroke_first"):
                parts.reverse()
            for kind, paint, width in parts:
                yield key, kind, paint, width, paths, outline.size * scale, style.get("fill_rule", "nonzero")

    def pairs_in_order(self, placements, drawn):
        result, at, drawn = [], 0, list(drawn)
        for key, kind, paint, width, paths, size, rule in self.wanted(placements):
            if kind == "line":
                for path in paths:
                    found = self.next(drawn, at, Line, key)
                    self.check_paint(found, paint, key)
                    if width and self.width_of and found.width is not None:
                        self.check_width(found.width, self.width_of(*width), key)
                    pair, rest = self.line_pair(path, found, size, key)
                    result.append(pair)
                    if rest is None:
                        at += 1
                    else:  # the next sub-path begins where this one ends
                        drawn[at] = rest
            else:
                rings = [path for path in paths if encloses(path)]
                taken = []
                while len(taken) < outlines_of(rings, rule):
                    found = self.next(drawn, at, Fill, key)
                    self.check_paint(found, paint, key)
                    taken.append(found.polygon)
                    at += 1
                if rings:
                    result.append(self.fill_pair(rings, taken, size, rule, key))
        if at != len(drawn):
            raise Disagreement(f"draws {len(drawn) - at} lines and fills more than wanted")
        return result

    def next(self, drawn, at, kind, key):
        name = self.picture.terminals[key[0]]["symbol"]
        if at >= len(drawn):
            raise Disagreement(f"draws {at} lines and fills only; a {kind.__name__.lower()} of {name} is missing")
        if not isinstance(drawn[at], kind):
            raise Disagreement(f"{at}: draws a {type(drawn[at]).__name__} instead of a {kind.__name__} of {name}")
        return drawn[at]

    def check_paint(self, found, paint, key):
        if not self.colors or found.color is None or not paint.startswith("#"):
            return
        wanted = tuple(int(paint[k:k + 2], 16) for k in (1, 3, 5))
        if any(abs(a - b) > 0.51 for a, b in zip(wanted, found.color)):
            raise Disagreement(f"{self.picture.terminals[key[0]]['symbol']} has the colour {found.color} instead of {wanted}")

    def check_width(self, found, wanted, key):
        if abs(found - wanted) > 1e-4 * wanted:
            raise Disagreement(f"{self.picture.terminals[key[0]]['symbol']} has the width {found} instead of {wanted}")

    def line_pair(self, path, found, size, key):
        """The pair, and what of the line lies behind its end, or None."""
        if found.exact:
            return self.exact_pair(path, found, key)
        corners = polyline_of(found)
        wanted = corners_of(path)
        places = walk(wanted, corners, size, self.name(key))
        if ("line", key) not in self.thoroughly_checked:
            self.thoroughly_checked.add(("line", key))
            for segment, first, last in zip(path, places, places[1:]):
                self.check_run(segment, corners[first:last + 1], size, key)
        last = places[-1]
        rest = Line([corners[last:]], [], found.color, found.width) if last < len(corners) - 1 else None
        return (wanted, corners[places]), rest

    def check_run(self, segment, corners, size, key):
        tolerance = max(FLATNESS * size * ON_CURVE, 4 * self.precision)
        off = distance_to_segment(corners, segment).max()
        if off > tolerance:
            raise Disagreement(f"a corner of {self.name(key)} is {off:.3g} off its curve")
        if len(corners) > 1:
            off = distance_to_segment((corners[1:] + corners[:-1]) / 2, segment).max()
            if off > 1.01 * FLATNESS * size + tolerance:
                raise Disagreement(f"a line of {self.name(key)} leaves its curve by {off:.3g}")

    def exact_pair(self, path, found, key):
        """Curve by curve; runs of straight segments are one polyline."""
        want, have = [], []
        for i, piece in enumerate(found.pieces):
            if len(want) == len(path):
                rest = Line(found.pieces[i:], [k - i for k in found.curved if k >= i], found.color, found.width, True)
                return (np.vstack(want), np.vstack(have)), rest
            parts = [piece] if i in found.curved else [np.array(ends) for ends in zip(piece, piece[1:])]
            for part in parts:
                if len(want) >= len(path) or len(path[len(want)]) != len(part):
                    raise Disagreement(f"segment {len(want)} of {self.name(key)} is no {'curve' if i in found.curved else 'line'}")
                want.append(path[len(want)])
                have.append(part)
        if len(want) != len(path):
            raise Disagreement(f"{self.name(key)} has {len(want)} segments instead of {len(path)}")
        return (np.vstack(want), np.vstack(have)), None

    def fill_pair(self, rings, polygons, size, rule, key):
        every = np.vstack(polygons) if polygons else np.zeros((0, 2))
        want, have = [], []
        for ring in rings:
            corners = corners_of(ring)
            distance = np.hypot(*(corners[:, None, :] - every[None, :, :]).transpose(2, 0, 1))
            nearest = distance.argmin(axis=1)
            missing = distance[np.arange(len(corners)), nearest] > 1e-3 * size + self.precision
            if missing.any() and not (rule == "nonzero" and missing.all() and surrounded(ring, rings)):
                raise Disagreement(f"a corner of the filled {self.name(key)} is missing")
            if not missing.any():
                want.append(corners)
                have.append(every[nearest])
        if ("fill", key) not in self.thoroughly_checked:
            self.thoroughly_checked.add(("fill", key))
            self.check_fill(rings, polygons, size, rule, key)
        if not want:
            return np.zeros((0, 2)), np.zeros((0, 2))
        return np.vstack(want), np.vstack(have)

    def check_fill(self, rings, polygons, size, rule, key):
        """Corners lie on the outline; and the same points of a raster are covered, but for those at its edge."""
        segments = [segment for ring in rings for segment in ring]
        off = np.full(sum(len(p) for p in polygons), math.inf)
        every = np.vstack(polygons)
        closing = [np.array([ring[-1][-1], ring[0][0]]) for ring in rings]
        for segment in segments + closing:
            off = np.minimum(off, distance_to_segment(every, segment))
        if off.max() > max(FLATNESS * size * ON_CURVE, 4 * self.precision):
            raise Disagreement(f"a corner of the filled {self.name(key)} is {off.max():.3g} off its outline")
        low, high = every.min(axis=0), every.max(axis=0)
        x, y = np.meshgrid(np.linspace(low[0], high[0], 23), np.linspace(low[1], high[1], 29))
        raster = np.column_stack((x.ravel(), y.ravel()))
        edge = np.full(len(raster), math.inf)
        for segment in segments + closing:
            edge = np.minimum(edge, distance_to_segment(raster, segment))
        raster = raster[edge > 3 * FLATNESS * size + self.precision]
        wanted = covered(raster, [flat(ring) for ring in rings], rule)
        found = np.zeros(len(raster), dtype=int)
        for polygon in polygons:
            found += winding(raster, polygon) % 2 != 0
        if np.any(wanted != (found == 1)) or np.any(found > 1):
            raise Disagreement(f"the filled {self.name(key)} covers something else")

    def name(self, key):
        return self.picture.terminals[key[0]]["symbol"]


def encloses(path):
    """A straight line encloses nothing that could be filled."""
    return len(corners_of(path)) > 2 or len(path[0]) == 4


def closed(path):
    ends = np.array([path[-1][-1], path[0][0]])
    return path if np.all(ends[0] == ends[1]) else path + [ends]


def walk(wanted, corners, size, name):
    """Numbers of the corners that are the wanted points, one after the other."""
    places, at = [], 0
    for point in wanted:
        distance = np.hypot(*(corners[at:] - point).T)
        if not len(distance):
            raise Disagreement(f"a line of {name} ends too early")
        near = np.flatnonzero(distance <= distance.min() + 1e-3 * FLATNESS * size)
        close = np.flatnonzero(distance < 1e-4 * size)
        at += int(close[0]) if len(close) and close[0] < near[0] and distance[close[0]] < 2 * distance[near[0]] else int(near[0])
        places.append(at)
    return places


def flat(ring):
    return np.vstack([ring[0][:1]] + [cubic(s, np.linspace(0, 1, 65)[1:]) if len(s) == 4 else s[1:] for s in ring])


def winding(points, polygon):
    """How many times the polygon goes around each point."""
    a, b = polygon, np.roll(polygon, -1, axis=0)
    y, x = points[:, 1][:, None], points[:, 0][:, None]
    side = (b[:, 0] - a[:, 0]) * (y - a[:, 1]) - (x - a[:, 0]) * (b[:, 1] - a[:, 1])
    up = (a[:, 1] <= y) & (b[:, 1] > y) & (side > 0)
    down = (a[:, 1] > y) & (b[:, 1] <= y) & (side < 0)
    return up.sum(axis=1) - down.sum(axis=1)


def covered(points, rings, rule):
    total = sum(winding(points, ring) for ring in rings)
    return total % 2 != 0 if rule == "evenodd" else total != 0


def surrounded(ring, rings):
    """Does the ring begin inside others?"""
    return sum(winding(ring[0][:1], flat(other))[0] for other in rings if other is not ring) != 0


def outlines_of(rings, rule):
    """How many polygons the filled area has: rings with the area inside and not outside, that do not cross."""
    flats = [flat(ring) for ring in rings]
    count = 0
    for ring in flats:
        middle = ring[:1]
        others = [other for other in flats if other is not ring]
        around = sum((winding(middle, other) for other in others), np.zeros(1, dtype=int))[0]
        own = 1 if signed_area(ring) > 0 else -1
        depth = sum(winding(middle, other)[0] != 0 for other in others)
        if rule == "evenodd":
            count += depth % 2 == 0
        else:
            count += around == 0 and around + own != 0
    return count


def signed_area(polygon):
    x, y = polygon.T
    return float((x * np.roll(y, -1) - np.roll(x, -1) * y).sum()) / 2


def elements_of(pairs, side):
    return [Element(pair[side]) for pair in pairs]
