"""SVG with clones: every leaf element and <use> that is drawn, with its transforms multiplied out."""
import xml.etree.ElementTree as tree
import math
import re

from .picture import Disagreement, Element, path_points, placed, product

FORMAT = "svg"
ENDING = ".svg"
LIMIT = 1e-9  # numbers in the file are rounded to 1e-11 of the picture

SVG = "{http://www.w3.org/2000/svg}"
XLINK = "{http://www.w3.org/1999/xlink}href"
IDENTITY = [1, 0, 0, 1, 0, 0]


def missing():
    return None


def matrix_of(node):
    """Of a transform attribute."""
    total = IDENTITY
    for name, text in re.findall(r"(\w+)\(([^)]*)\)", node.get("transform", "")):
        numbers = [float(number) for number in re.split(r"[\s,]+", text.strip())]
        if name == "matrix":
            step = numbers
        elif name == "translate":
            step = [1, 0, 0, 1, numbers[0], numbers[1] if len(numbers) > 1 else 0]
        elif name == "scale":
            step = [numbers[0], 0, 0, numbers[-1], 0, 0]
        elif name == "rotate":
            angle = math.radians(numbers[0])
            x, y = numbers[1:] or (0, 0)
            about = [math.cos(angle), math.sin(angle), -math.sin(angle), math.cos(angle), 0, 0]
            step = product(product([1, 0, 0, 1, x, y], about), [1, 0, 0, 1, -x, -y])
        else:
            raise Disagreement(f"transform {name}")
        total = product(total, step)
    return total


def offset(node):
    return [1, 0, 0, 1, float(node.get("x", 0)), float(node.get("y", 0))]


def drawn(node, matrix, by_id, depth=0):
    """(matrix, leaf element) of everything below a node that is painted."""
    if depth > 200:
        raise Disagreement("clones nested deeper than 200")
    if node.get("display") == "none" or "display:none" in node.get("style", ""):
        return
    matrix = product(matrix, matrix_of(node))
    tag = node.tag.removeprefix(SVG)
    if tag == "use":
        target = by_id.get((node.get(XLINK) or node.get("href", ""))[1:])
        if target is None:
            raise Disagreement("a clone of nothing")
        yield from drawn(target, product(matrix, offset(node)), by_id, depth + 1)
    elif tag in ("svg", "g", "symbol"):
        for child in node:
            if child.tag != SVG + "defs" and child.tag != SVG + "symbol":
                yield from drawn(child, matrix, by_id, depth)
    elif tag == "path":
        yield matrix, node


def elements_of_file(name):
    root = tree.parse(name).getroot()
    by_id = {node.get("id"): node for node in root.iter() if node.get("id")}
    return [Element(placed(matrix, path_points(node.get("d", "")))) for matrix, node in drawn(root, IDENTITY, by_id)]


def elements(picture):
    """Fragments are compared by the eye only: they have no outline of their own."""
    kept = [p for p in picture.placements if not picture.terminals[p["terminal"]]["verbatim"]]
    return [picture.element(picture.symbol(p), p["matrix"]) for p in kept]


def read(exported, picture, folder):
    return elements_of_file(exported)
