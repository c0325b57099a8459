#!/usr/bin/env python3
"""Makes the meshes of samples/surface: closed forms, solids of revolution and smooth bodies given by a function.

usage: scripts/make_meshes.py [FOLDER]      (FOLDER: samples/surface)

All have y up, triangles that are nearly even, and a box whose diagonal is 2.
"""
import pathlib
import sys

import numpy as np

root = pathlib.Path(__file__).resolve().parent.parent

DIAGONAL = 2.0  # of every mesh's box
DIGITS = 6


# ---------------------------------------------------------------- closed forms

def torus(around=72, across=36, major=1.0, minor=0.42):
    """Rows of triangles that are even at the tube's top: every second row is shifted by half a triangle."""
    points, faces = [], []
    for j in range(across):
        v = 2 * np.pi * j / across
        for i in range(around):
            u = 2 * np.pi * (i + 0.5 * (j % 2)) / around
            ring = major + minor * np.cos(v)
            points.append((ring * np.cos(u), minor * np.sin(v), -ring * np.sin(u)))
    at = lambda j, i: (j % across) * around + i % around
    for j in range(across):
        for i in range(around):
            left, right = (0, 1) if j % 2 == 0 else (1, 1)
            faces.append((at(j, i), at(j, i + 1), at(j + 1, i + left)))
            if j % 2 == 0:
                faces.append((at(j, i + 1), at(j + 1, i + 1), at(j + 1, i)))
            else:
                faces.append((at(j, i), at(j + 1, i + right), at(j + 1, i)))
    return np.array(points), np.array(faces)


def icosphere(levels=4):
    """An icosahedron, every triangle cut into four `levels` times."""
    g = (1 + 5 ** 0.5) / 2
    points = [(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g),
              (0, -1, -g), (0, 1, -g), (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1)]
    points = [np.array(p, float) / np.linalg.norm(p) for p in points]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6), (7, 1, 8),
             (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    for _ in range(levels):
        middle = {}

        def half(a, b):
            key = (min(a, b), max(a, b))
            if key not in middle:
                p = points[a] + points[b]
                points.append(p / np.linalg.norm(p))
                middle[key] = len(points) - 1
            return middle[key]

        finer = []
        for a, b, c in faces:
            ab, bc, ca = half(a, b), half(b, c), half(c, a)
            finer += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
        faces = finer
    return np.array(points), np.array(faces)


# ---------------------------------------------------------------- solids of revolution

def spline(corners, per_piece=60):
    """A smooth line through `corners` (Catmull and Rom's)."""
    p = np.array([corners[0]] + list(corners) + [corners[-1]], float)
    t = np.linspace(0, 1, per_piece, endpoint=False)[:, None]
    pieces = []
    for i in range(1, len(p) - 2):
        a, b, c, d = p[i - 1], p[i], p[i + 1], p[i + 2]
        pieces.append(0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t ** 2 + (3 * b - a - 3 * c + d) * t ** 3))
    return np.vstack(pieces + [p[-1:]])


def along(line, step):
    """Points on a line, about `step` apart."""
    length = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1))])
    count = max(2, round(length[-1] / step) + 1)
    places = np.linspace(0, length[-1], count)
    return np.stack([np.interp(places, length, line[:, k]) for k in range(line.shape[1])], axis=1)


def revolved(profile, edge):
    """(radius, height) from bottom to top. Rings have as many points as they need; radius 0 at an end closes it."""
    rows = along(profile, edge * 3 ** 0.5 / 2)
    points, faces, rings = [], [], []
    for j, (r, y) in enumerate(rows):
        count = 1 if r < 1e-9 else max(6, round(2 * np.pi * r / edge))
        turn = 0.5 * (j % 2)
        first = len(points)
        for i in range(count):
            a = 2 * np.pi * (i + turn) / count
            points.append((r * np.cos(a), y, -r * np.sin(a)))
        rings.append((first, count, turn))
    for low, high in zip(rings, rings[1:]):
        faces += between_rings(low, high)
    return np.array(points), np.array(faces)


def between_rings(low, high):
    """The strip between two rings of unlike numbers of points: always on with the one that lags behind."""
    (a0, na, ta), (b0, nb, tb) = low, high
    faces, i, j = [], 0, 0
    while i < na * (na > 1) or j < nb * (nb > 1):
        next_a = (i + 1 + ta) / na if na > 1 and i < na else np.inf
        next_b = (j + 1 + tb) / nb if nb > 1 and j < nb else np.inf
        a, b = a0 + i % na, b0 + j % nb
        if next_a <= next_b:
            i += 1
            faces.append((a, a0 + i % na, b))
        else:
            j += 1
            faces.append((a, b0 + j % nb, b))
    return faces


def vase():
    """A foot, a belly, a neck and a rolled lip; open at the top, the border is inside the neck."""
    corners = [(0.0, 0.0), (0.30, 0.0), (0.335, 0.03), (0.30, 0.075), (0.36, 0.20), (0.56, 0.52), (0.63, 0.86), (0.54, 1.18),
               (0.33, 1.44), (0.245, 1.62), (0.27, 1.78), (0.37, 1.90), (0.40, 1.93), (0.385, 1.955), (0.34, 1.935),
               (0.25, 1.82), (0.21, 1.68)]
    return revolved(spline(corners), 0.046)


# ---------------------------------------------------------------- bodies given by a function

CUBE = np.array([(i, j, k) for i in (0, 1) for j in (0, 1) for k in (0, 1)])


def surface_nets(function, low, high, cell):
    """The zero set of `function` (negative inside) as triangles: a point in each cell that it crosses, a quad about each edge."""
    counts = np.ceil((np.array(high) - low) / cell).astype(int) + 1
    axes = [low[k] + cell * np.arange(counts[k]) for k in range(3)]
    grid = np.stack(np.meshgrid(*axes, indexing='ij'), axis=-1)
    value = function(grid.reshape(-1, 3)).reshape(counts)
    inside = value < 0
    index, points = {}, []
    corner = [inside[i:counts[0] - 1 + i, j:counts[1] - 1 + j, k:counts[2] - 1 + k] for i, j, k in CUBE]
    inside_corners = np.sum(corner, axis=0)
    for cell_at in np.argwhere((inside_corners > 0) & (inside_corners < 8)):
        places = cell_at + CUBE
        v = value[places[:, 0], places[:, 1], places[:, 2]]
        crossings = []
        for a in range(8):
            for bit in (1, 2, 4):
                b = a | bit
                if b != a and (v[a] < 0) != (v[b] < 0):
                    s = v[a] / (v[a] - v[b])
                    crossings.append(places[a] + s * (places[b] - places[a]))
        index[tuple(cell_at)] = len(points)
        points.append(low + cell * np.mean(crossings, axis=0))
    faces = []
    for axis in range(3):
        u, v = [(1, 2), (2, 0), (0, 1)][axis]
        step = np.eye(3, dtype=int)
        here = tuple(slice(0, counts[k] - (k == axis)) for k in range(3))
        there = tuple(slice(int(k == axis), counts[k]) for k in range(3))
        for edge in np.argwhere(inside[here] != inside[there]):
            quad = [index[tuple(edge - a * step[u] - b * step[v])] for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
            if not inside[tuple(edge)]:
                quad.reverse()
            faces += [(quad[0], quad[1], quad[2]), (quad[0], quad[2], quad[3])]
    return np.array(points), np.array(faces)


def project(function, points, reach):
    """Newton's steps along the gradient onto the zero set, none longer than `reach`."""
    h = 1e-5
    for _ in range(4):
        value = function(points)
        gradient = np.stack([(function(points + h * e) - function(points - h * e)) / (2 * h) for e in np.eye(3)], axis=1)
        step = -value[:, None] * gradient / np.maximum(np.sum(gradient ** 2, axis=1), 1e-12)[:, None]
        length = np.linalg.norm(step, axis=1)[:, None]
        points = points + step * np.minimum(1, reach / np.maximum(length, 1e-30))
    return points


def edges_of(faces):
    """Undirected edge -> the two (face, opposite corner) that it has."""
    sides = {}
    for f, (a, b, c) in enumerate(faces):
        for p, q, r in ((a, b, c), (b, c, a), (c, a, b)):
            sides.setdefault((min(p, q), max(p, q)), []).append((f, r))
    return sides


def flip_edges(points, faces):
    """Turns edges whose opposite angles sum to more than half a turn (Delaunay's rule)."""
    faces = [tuple(f) for f in faces]
    for _ in range(3):
        sides, touched, flips = edges_of(faces), set(), 0
        for (a, b), ends in sides.items():
            (f, c), (g, d) = ends
            if f in touched or g in touched or (min(c, d), max(c, d)) in sides:
                continue
            angle = 0
            for tip in (c, d):
                p, q = points[a] - points[tip], points[b] - points[tip]
                angle += np.arctan2(np.linalg.norm(np.cross(p, q)), np.dot(p, q))
            if angle > np.pi + 1e-6:
                if b != faces[f][(faces[f].index(a) + 1) % 3]:
                    a, b = b, a
                faces[f], faces[g] = (c, a, d), (d, b, c)
                touched |= {f, g}
                flips += 1
        if flips == 0:
            break
    return np.array(faces)


def relaxed(function, points, faces, cell, rounds=24):
    """Points drawn to the middle of their neighbours along the surface, and edges turned, until triangles are even."""
    for turn in range(rounds):
        if turn % 4 == 0:
            faces = flip_edges(points, faces)
            pairs = np.array(sorted(edges_of(faces)))
            degree = np.bincount(pairs.ravel(), minlength=len(points))[:, None]
        total = np.zeros_like(points)
        np.add.at(total, pairs[:, 0], points[pairs[:, 1]])
        np.add.at(total, pairs[:, 1], points[pairs[:, 0]])
        points = project(function, points + 0.6 * (total / degree - points), 0.5 * cell)
    return points, flip_edges(points, faces)


def body(function, low, high, cell):
    points, faces = surface_nets(function, np.array(low, float), np.array(high, float), cell)
    return relaxed(function, points, faces, cell)


def smooth_union(distances, softness):
    """Of signed distances: rounded where two meet."""
    lowest = np.min(distances, axis=0)
    return lowest - softness * np.log(sum(np.exp((lowest - d) / softness) for d in distances))


def ellipsoid(points, centre, radii, turn=(0, 0, 0)):
    """About the signed distance; `turn`: degrees about x, y and z."""
    p = points - np.array(centre)
    for axis, degrees in enumerate(turn):
        a = np.radians(-degrees)
        u, v = (axis + 1) % 3, (axis + 2) % 3
        p = p.copy()
        p[:, u], p[:, v] = np.cos(a) * p[:, u] - np.sin(a) * p[:, v], np.sin(a) * p[:, u] + np.cos(a) * p[:, v]
    scaled = np.linalg.norm(p / np.array(radii), axis=1)
    slope = np.linalg.norm(p / np.array(radii) ** 2, axis=1)
    return np.where(scaled < 1e-9, -min(radii), scaled * (scaled - 1) / np.maximum(slope, 1e-9))


def torus_distance(points, axis, major, minor):
    u, v = (axis + 1) % 3, (axis + 2) % 3
    ring = np.hypot(points[:, u], points[:, v]) - major
    return np.hypot(ring, points[:, axis]) - minor


def blob():
    """A pebble grown together of five."""
    balls = [((0, 0, 0), (0.62, 0.5, 0.5)), ((0.62, 0.28, 0.1), (0.36, 0.36, 0.34)), ((-0.5, 0.42, -0.12), (0.34, 0.4, 0.34)),
             ((-0.62, -0.25, 0.2), (0.36, 0.3, 0.32)), ((0.3, -0.42, -0.15), (0.42, 0.3, 0.36))]
    function = lambda p: smooth_union([ellipsoid(p, c, r) for c, r in balls], 0.09)
    return body(function, (-1.3, -1.1, -0.9), (1.3, 1.2, 0.9), 0.052)


def cub():
    """A sitting bear cub: genus 0, with two ears, a snout, four paws."""
    parts = [((0, 0.52, 0), (0.50, 0.56, 0.46), (0, 0, 0)), ((0, 1.26, 0.08), (0.40, 0.37, 0.37), (0, 0, 0)),
             ((0, 1.17, 0.42), (0.17, 0.14, 0.16), (0, 0, 0)),
             ((0.31, 1.58, 0.02), (0.145, 0.15, 0.09), (0, 0, -20)), ((-0.31, 1.58, 0.02), (0.145, 0.15, 0.09), (0, 0, 20)),
             ((0.36, 0.10, 0.36), (0.19, 0.16, 0.32), (0, 25, 0)), ((-0.36, 0.10, 0.36), (0.19, 0.16, 0.32), (0, -25, 0)),
             ((0.42, 0.72, 0.20), (0.16, 0.30, 0.16), (-50, 0, 25)), ((-0.42, 0.72, 0.20), (0.16, 0.30, 0.16), (-50, 0, -25))]
    function = lambda p: smooth_union([ellipsoid(p, c, r, t) for c, r, t in parts], 0.06)
    return body(function, (-0.9, -0.35, -0.8), (0.9, 2.0, 0.95), 0.0435)


def three_rings():
    """Three tori at right angles about one centre, joined: genus 7."""
    function = lambda p: smooth_union([torus_distance(p, k, 1.0, 0.2) for k in range(3)], 0.03)
    return body(function, (-1.35,) * 3, (1.35,) * 3, 0.0745)


# ---------------------------------------------------------------- files

def written(name, points, faces):
    low, high = points.min(axis=0), points.max(axis=0)
    middle = (low + high) / 2
    middle[1] = low[1]
    points = (points - middle) * (DIAGONAL / np.linalg.norm(high - low))
    text = ['# %s: made by scripts/make_meshes.py' % name]
    text += ['v ' + ' '.join(shortest(v) for v in p) for p in points]
    text += ['f %d %d %d' % tuple(int(i) + 1 for i in f) for f in faces]
    return '\n'.join(text) + '\n'


def shortest(number):
    text = ('%.*f' % (DIGITS, number)).rstrip('0').rstrip('.')
    return '0' if text == '-0' else text


MESHES = {'torus': torus, 'sphere': icosphere, 'vase': vase, 'blob': blob, 'cub': cub, 'three_rings': three_rings}


def main(folder):
    for name, make in MESHES.items():
        points, faces = make()
        text = written(name, points, faces)
        (folder / (name + '.obj')).write_text(text, encoding='utf-8')
        edges = len({tuple(sorted(e)) for f in faces for e in ((f[0], f[1]), (f[1], f[2]), (f[2], f[0]))})
        print('%-12s %6d faces, Euler characteristic %d, %d bytes' % (name, len(faces), len(points) - edges + len(faces), len(text)))


if __name__ == '__main__':
    main(pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else root / 'samples' / 'surface')
