"""L-Py: an independent reader of .lpy files, written from L-Py's documentation of the language and of the turtle's modules.

Rules are Python functions: they are compiled and run. Strings are derived as L-Py derives them (rewriting steps, then
decomposition, interpretation by rules) and walked by a turtle in space. What is not known is a fault, never skipped.
"""
import math
import re
import sys
import types

import numpy as np

from .drawn import Comparison, Fill, Line, elements_of
from .picture import Disagreement

FORMAT = "lpy"
ENDING = ".lpy"
LIMIT = 1e-8

COMMANDS = {"[": "[", "]": "]", "F": "F", "f": "f", "+": "+", "-": "-", "/": "/", "\\": "\\", "^": "^", "&": "&", "|": "|",
            "{": "{", "}": "}", ".": ".", "@Di": "@Di", "@Dd": "@Dd", "@D": "@D", "@g": "@g", "SetColor": "SetColor",
            "SB": "[", "EB": "]", "Left": "+", "Right": "-", "MultScale": "@Di", "BP": "{", "EP": "}", "PP": ".",
            "PglShape": "@g", "RollL": "/", "RollR": "\\"}
UNSUPPORTED = {"X", "x", "any", "all", "or", "nF", "Cut", "%", "Sphere", "Box", "Circle", "Quad", "Frame", "Arrow", "Label",
               "Up", "Down", "None", "new", "surface", "Sweep", "Tropism", "Elasticity", "_", "!", ";", ",", "~", "$", "*"}
SECTIONS = ("production", "decomposition", "interpretation", "homomorphism")


def missing():
    return None


# PlantGL's shapes, as far as they are used

class Curve:
    width = 1

    def __init__(self, points):
        self.points = [tuple(float(v) for v in point) for point in points]


class BezierCurve(Curve):
    def __init__(self, points, stride=30):
        super().__init__(points)
        if any(len(p) != 4 or p[3] != 1 for p in self.points):
            raise Disagreement("a Bezier curve with weights")


class Polyline(Curve):
    def __init__(self, points):
        super().__init__(points)
        if any(len(p) != 3 for p in self.points) or len(self.points) < 2:
            raise Disagreement("a polyline of other than points in space")


class Group:
    def __init__(self, parts):
        self.parts = list(parts)


def plantgl():
    package = types.ModuleType("openalea.plantgl.all")
    package.BezierCurve, package.Polyline, package.Group = BezierCurve, Polyline, Group
    return {"openalea": types.ModuleType("openalea"), "openalea.plantgl": types.ModuleType("openalea.plantgl"),
            "openalea.plantgl.all": package}


# Strings of modules

class Names:
    """Names that a string may hold; the longest that fits is meant."""

    def __init__(self):
        self.names = set(COMMANDS) | UNSUPPORTED

    def module_at(self, text, at):
        word = max((name for name in self.names if text.startswith(name, at)), key=len, default=None)
        if word is None:
            if not text[at].isalpha():
                raise Disagreement(f"no module begins with {text[at:at + 10]!r}")
            word = text[at]
        return word, at + len(word)

    def split(self, text):
        """[(name, text of the arguments or None)]"""
        modules, at = [], 0
        while at < len(text):
            if text[at].isspace():
                at += 1
                continue
            name, at = self.module_at(text, at)
            arguments = None
            if at < len(text) and text[at] == "(":
                end = closing(text, at)
                arguments, at = text[at + 1:end], end + 1
            modules.append((name, arguments))
        return modules

    def code(self, text):
        """A Python list of (name, arguments)."""
        return "[" + ", ".join(f"({name!r}, ({arguments},))" if arguments else f"({name!r}, ())"
                               for name, arguments in self.split(text)) + "]"


def closing(text, at):
    depth = 0
    for end in range(at, len(text)):
        depth += {"(": 1, ")": -1}.get(text[end], 0)
        if depth == 0:
            return end
    raise Disagreement(f"no ) in {text[at:at + 40]}")


class Rule:
    def __init__(self, head, body, names, scope):
        left, strict, right = contexts_of(head)
        self.left, self.right = [split_pattern(p) for p in names.split(left)], [split_pattern(p) for p in names.split(right)]
        (self.name, self.parameters), = [split_pattern(p) for p in names.split(strict)]
        parameters = self.parameters + [p for _, ps in self.left + self.right for p in ps]
        if len(set(parameters)) != len(parameters):
            raise Disagreement(f"parameters named twice in {head}")
        lines = [f"def rule({', '.join(parameters)}):"]
        for line in body:
            found = re.match(r"(\s*(?:.*:\s+)?)produce\b(.*)", line)
            lines.append(found[1] + "return " + names.code(found[2]) if found else line)
        exec("\n".join(lines), scope)
        self.function = scope.pop("rule")

    def fits(self, module):
        return module[0] == self.name and len(module[1]) == len(self.parameters)


def contexts_of(head):
    """left < strict > right, where < and > in parentheses do not count."""
    parts, depth, marks = [""], 0, ""
    for c in head:
        depth += {"(": 1, ")": -1}.get(c, 0)
        if depth == 0 and c in "<>":
            parts.append("")
            marks += c
        else:
            parts[-1] += c
    return {"": ("", *parts, ""), "<": (*parts, ""), ">": ("", *parts), "<>": tuple(parts)}[marks]


def split_pattern(module):
    name, arguments = module
    parameters = [p.strip() for p in arguments.split(",")] if arguments else []
    if not all(p.isidentifier() for p in parameters):
        raise Disagreement(f"parameters {arguments!r} of {name}")
    return name, parameters


class Program:
    def __init__(self, text):
        self.names = Names()
        self.rules = {section: [] for section in SECTIONS}
        self.depths = {section: 1 for section in SECTIONS}
        self.length, self.ignored = 1, set()
        self.scope = {"__name__": "lpy"}
        self.parse(text)

    def parse(self, text):
        lines = text.split("\n")
        start = next(i for i, line in enumerate(lines) if line.startswith("Axiom:"))
        code = []
        for line in lines[:start]:
            declared = re.match(r"module (.*)", line)
            if declared:
                for name in declared[1].split(","):
                    name = name.strip()
                    if name in self.names.names or not name.isidentifier():
                        raise Disagreement(f"module {name} is taken or no name")
                    self.names.names.add(name)
            else:
                code.append(line)
        saved = {name: sys.modules.get(name) for name in plantgl()}
        sys.modules.update(plantgl())
        try:
            exec("\n".join(code), self.scope)
        finally:
            for name, module in saved.items():
                sys.modules.pop(name) if module is None else sys.modules.__setitem__(name, module)
        self.axiom = eval(self.names.code(lines[start][len("Axiom:"):]), self.scope)
        if lines[-2:] != ["endlsystem", ""]:
            raise Disagreement("does not end with endlsystem")
        self.parse_rules(lines[start + 1:-2])

    def parse_rules(self, lines):
        section, at = None, 0
        while at < len(lines):
            line = lines[at]
            at += 1
            if not line.strip() or line.startswith("#"):
                continue
            word, _, rest = line.partition(":")
            if word in SECTIONS and not rest.strip():
                section = word
            elif word == "derivation length":
                self.length = int(rest)
            elif word == "maximum depth":
                self.depths[section] = int(rest)
            elif word == "ignore":
                self.ignored = {name for name, _ in self.names.split(rest)}
            elif line.endswith(":") and section:
                body = []
                while at < len(lines) and (lines[at].startswith((" ", "\t")) or not lines[at].strip()):
                    body.append(lines[at])
                    at += 1
                self.rules[section].append(Rule(line[:-1], body, self.names, self.scope))
            else:
                raise Disagreement(f"line {line!r}")

    def apply(self, section, string, at):
        """What takes the module's place, or None."""
        module = string[at]
        for rule in self.rules[section]:
            if not rule.fits(module):
                continue
            values = list(module[1])
            if rule.left or rule.right:
                left, right = self.match_left(rule, string, at), self.match_right(rule, string, at)
                if left is None or right is None:
                    continue
                values += left + right
            made = rule.function(*values)
            if made is not None:
                return made
        return None

    def match_left(self, rule, string, at):
        values = []
        for name, parameters in reversed(rule.left):
            at -= 1
            while at >= 0 and (string[at][0] in self.ignored or string[at][0] in "[]"):
                if string[at][0] == "]":
                    depth = 1
                    while depth:
                        at -= 1
                        depth += {"]": 1, "[": -1}.get(string[at][0], 0)
                at -= 1
            if at < 0 or string[at][0] != name or len(string[at][1]) != len(parameters):
                return None
            values = list(string[at][1]) + values
        return values

    def match_right(self, rule, string, at):
        values = []
        for name, parameters in rule.right:
            at += 1
            while at < len(string) and (string[at][0] in self.ignored or string[at][0] == "["):
                if string[at][0] == "[":
                    depth = 1
                    while depth:
                        at += 1
                        depth += {"[": 1, "]": -1}.get(string[at][0], 0)
                at += 1
            if at >= len(string) or string[at][0] != name or len(string[at][1]) != len(parameters):
                return None
            values += list(string[at][1])
        return values

    def expanded(self, section, string):
        """Every module replaced as long as a rule of the section applies, depth first."""
        limit, result = self.depths[section], []
        stack = [(iter(range(len(string))), string, 0)]
        while stack:
            places, modules, depth = stack[-1]
            at = next(places, None)
            if at is None:
                stack.pop()
                continue
            made = self.apply(section, modules, at) if depth < limit else None
            if made is None:
                result.append(modules[at])
            else:
                stack.append((iter(range(len(made))), made, depth + 1))
        return result

    def derive(self):
        string = self.axiom
        if self.rules["decomposition"]:
            string = self.expanded("decomposition", string)
        for _ in range(self.length):
            made = [self.apply("production", string, at) for at in range(len(string))] if self.rules["production"] else None
            if made is not None:
                string = [m for at, new in enumerate(made) for m in (new if new is not None else [string[at]])]
            if self.rules["decomposition"]:
                string = self.expanded("decomposition", string)
        return string

    def interpreted(self):
        return self.expanded("interpretation", self.derive())


class Turtle:
    """Position and frame in space; what it draws in the plane Y-Z."""

    def __init__(self):
        self.position, self.heading = np.zeros(3), np.array([0.0, 0.0, 1.0])
        self.left, self.up = np.array([0.0, -1.0, 0.0]), np.array([1.0, 0.0, 0.0])
        self.scale, self.color, self.polygon = 1.0, None, None
        self.stack, self.drawn = [], []

    def turn(self, axis, angle):
        """Of the frame, right-handed about one of its own axes."""
        c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
        if axis == "up":
            self.heading, self.left = c * self.heading + s * self.left, c * self.left - s * self.heading
        elif axis == "heading":
            self.left, self.up = c * self.left + s * self.up, c * self.up - s * self.left
        else:
            raise Disagreement(f"turns out of the plane about {axis}")

    def walk(self, modules):
        for name, arguments in modules:
            command = COMMANDS.get(name)
            if command is None:
                if name in UNSUPPORTED:
                    raise Disagreement(f"module {name} has a meaning in L-Py")
                continue
            getattr(self, NAMES[command])(*arguments)
        if self.stack:
            raise Disagreement("a [ is not closed")

    def forward(self, length):
        self.position = self.position + length * self.scale * self.heading

    def draw_forward(self, *arguments):
        raise Disagreement("F draws a cylinder")

    def turn_left(self, angle):
        self.turn("up", angle)

    def turn_right(self, angle):
        self.turn("up", -angle)

    def roll_left(self, angle):
        self.turn("heading", angle)

    def roll_right(self, angle):
        self.turn("heading", -angle)

    def multiply_scale(self, factor):
        self.scale *= factor

    def divide_scale(self, factor):
        self.scale /= factor

    def set_scale(self, scale):
        self.scale = scale

    def push(self):
        self.stack.append((self.position, self.heading, self.left, self.up, self.scale, self.color, self.polygon))

    def pop(self):
        self.position, self.heading, self.left, self.up, self.scale, self.color, self.polygon = self.stack.pop()

    def set_color(self, red, green, blue):
        self.color = (red, green, blue)

    def begin_polygon(self):
        self.polygon = []

    def add_point(self):
        self.polygon.append(self.position)

    def end_polygon(self, concave=False):
        if len(self.polygon) > 2 and not concave:
            raise Disagreement("a polygon without the test for concave ones")
        self.drawn.append(Fill(self.flat(self.polygon), self.color))
        self.polygon = None

    def flat(self, points):
        points = np.array(points).reshape(-1, 3)
        if np.abs(points[:, 0]).max(initial=0) > 1e-6 * (1 + np.abs(points).max(initial=0)):
            raise Disagreement("draws outside the plane")
        return np.column_stack((points[:, 1], -points[:, 2]))  # y down, as the picture

    def draw(self, shape):
        frame = np.array([self.up, -self.left, self.heading]) * self.scale
        last = None
        for curve in shape.parts if isinstance(shape, Group) else [shape]:
            points = self.flat(np.array([p[:3] for p in curve.points]) @ frame + self.position)
            if last != curve.points[0][:3]:
                self.drawn.append(Line([], [], self.color, exact=True))
            line = self.drawn[-1]
            if isinstance(curve, BezierCurve):
                line.curved.append(len(line.pieces))
            line.pieces.append(points)
            last = curve.points[-1][:3]


NAMES = {"[": "push", "]": "pop", "F": "draw_forward", "f": "forward", "+": "turn_left", "-": "turn_right", "/": "roll_left",
         "\\": "roll_right", "@Di": "multiply_scale", "@Dd": "divide_scale", "@D": "set_scale", "SetColor": "set_color",
         "{": "begin_polygon", ".": "add_point", "}": "end_polygon", "@g": "draw"}


def pairs(exported, picture, folder):
    turtle = Turtle()
    turtle.walk(Program(exported.read_text()).interpreted())
    return Comparison(picture, LIMIT).pairs(turtle.drawn)
