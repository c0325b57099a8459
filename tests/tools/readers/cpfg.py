"""cpfg: an independent reader of .l, .v and .map files, written from the description of the language and of the turtle.

The scanner keeps cpfg's peculiarities: symbols are single characters, an exponent needs a point before it, parameters are
single-precision numbers, comments hold no slash. What is not known is a fault, never skipped.
"""
import math
import re

import numpy as np

from .drawn import Comparison, Fill, Line
from .picture import Disagreement

FORMAT = "cpfg"
ENDING = ".l"
LIMIT = 5e-6  # numbers are single-precision ones, and errors of a long walk add up

MOST_CONSTANTS = 3500
FUNCTIONS = {"sin": math.sin, "cos": math.cos, "tan": math.tan, "asin": math.asin, "acos": math.acos, "atan": math.atan,
             "atan2": math.atan2, "sqrt": math.sqrt, "exp": math.exp, "log": math.log, "floor": math.floor,
             "ceil": math.ceil, "trunc": math.trunc, "fabs": abs}
DEGREES = {"sin": lambda x: math.sin(math.radians(x)), "cos": lambda x: math.cos(math.radians(x)),
           "tan": lambda x: math.tan(math.radians(x)), "asin": lambda x: math.degrees(math.asin(x)),
           "acos": lambda x: math.degrees(math.acos(x)), "atan": lambda x: math.degrees(math.atan(x)),
           "atan2": lambda y, x: math.degrees(math.atan2(y, x))}
RESERVED_NAMES = set(FUNCTIONS) | {"ran", "nran", "bran", "biran", "srand", "if", "while", "do", "else", "array", "sign"}
TURTLE = set("FfGg+-&^\\/|[]{}.;,_!#@~%$?'\"<>*:()")
LEVELS = [("||",), ("&&",), ("==", "!="), ("<=", ">=", "<", ">"), ("+", "-"), ("*", "/", "%"), ("^",)]


def missing():
    return None


def preprocessed(text):
    """Without comments, macros replaced, lines that begin with a tab joined to those before them."""
    for comment in re.findall(r"/\*(.*?)\*/", text, re.S):
        if "/" in comment or not comment.isascii():
            raise Disagreement(f"a comment that the scanner does not end: {comment[:60]!r}")
    text = re.sub(r"/\*.*?\*/", "", text, flags=re.S)
    macros, lines = {}, []
    for line in text.split("\n"):
        define = re.match(r"#define ([A-Za-z_]\w*) (.*)", line)
        if define:
            macros[define[1]] = define[2]
        elif line.startswith("\t"):
            lines[-1] += line[1:]
        else:
            lines.append(line)
    whole = "\n".join(lines)
    for _ in range(20):
        replaced = re.sub(r"[A-Za-z_]\w*", lambda m: macros.get(m[0], m[0]), whole)
        if replaced == whole:
            return whole
        whole = replaced
    raise Disagreement("macros without end")


class Scanner:
    def __init__(self, text, functions):
        self.text, self.at, self.constants, self.functions = text, 0, 0, functions

    def blanks(self):
        while self.at < len(self.text) and self.text[self.at] == " ":
            self.at += 1

    def take(self, token):
        self.blanks()
        if self.text.startswith(token, self.at):
            self.at += len(token)
            return True
        return False

    def expect(self, token):
        if not self.take(token):
            raise Disagreement(f"expected {token!r} at {self.text[self.at:self.at + 30]!r}")

    # expressions: each gives a function of the parameters

    def expression(self):
        condition = self.binary(0)
        if not self.take("?"):
            return condition
        then = self.expression()
        self.expect(":")
        otherwise = self.expression()
        return lambda p: then(p) if condition(p) else otherwise(p)

    def binary(self, level):
        if level == len(LEVELS):
            return self.unary()
        left = self.binary(level + 1)
        while True:
            self.blanks()
            if self.text.startswith("-->", self.at):
                return left
            sign = next((s for s in LEVELS[level] if self.text.startswith(s, self.at)), None)
            if sign is None:
                return left
            self.at += len(sign)
            left = operation(sign, left, self.binary(level + 1))

    def unary(self):
        if self.take("-"):
            operand = self.unary()
            return lambda p: -operand(p)
        if self.take("!"):
            operand = self.unary()
            return lambda p: float(operand(p) == 0)
        return self.atom()

    def atom(self):
        self.blanks()
        rest = self.text[self.at:]
        number = re.match(r"(\d+\.\d*|\.\d+)([Ee][-+]?\d+)?|\d+", rest)
        if number:
            self.at += number.end()
            self.constants += 1
            if re.match(r"[A-Za-z_.]", self.text[self.at:self.at + 1]):
                raise Disagreement(f"the scanner ends the number in {rest[:20]!r} early")
            value = float(number[0])
            return lambda p: value
        if self.take("("):
            inner = self.expression()
            self.expect(")")
            return inner
        name = re.match(r"[A-Za-z]\w*", rest)
        if not name:
            raise Disagreement(f"expected a value at {rest[:30]!r}")
        self.at += name.end()
        if name[0] in self.functions:
            arguments = self.arguments()
            function = self.functions[name[0]]
            return lambda p: float(function(*(a(p) for a in arguments)))
        if name[0] in RESERVED_NAMES:
            raise Disagreement(f"{name[0]} is not a variable")
        return lambda p: p[name[0]]

    def arguments(self):
        self.expect("(")
        arguments = [self.expression()]
        while self.take(","):
            arguments.append(self.expression())
        self.expect(")")
        return arguments

    # strings of modules

    def modules(self, stop):
        """[(character, arguments)] up to one of the tokens or the end."""
        modules = []
        while True:
            self.blanks()
            if self.at == len(self.text) or any(self.text.startswith(s, self.at) for s in stop):
                return modules
            c = self.text[self.at]
            if c in "<>:*()":
                raise Disagreement(f"{c} is no symbol: {self.text[self.at:self.at + 30]!r}")
            self.at += 1
            bracket = self.text.startswith("(", self.at)  # a blank before it would begin another symbol
            modules.append((c, self.arguments() if bracket else []))

    def pattern(self, stop):
        """[(character, parameters)]"""
        result = []
        while True:
            self.blanks()
            if any(self.text.startswith(s, self.at) for s in stop):
                return result
            c = self.text[self.at]
            self.at += 1
            names = []
            if self.text.startswith("(", self.at):
                end = self.text.index(")", self.at)
                names = [n.strip() for n in self.text[self.at + 1:end].split(",")]
                self.at = end + 1
            for name in names:
                if not re.fullmatch(r"[A-Za-z]\w*", name) or name in RESERVED_NAMES:
                    raise Disagreement(f"{name!r} is no parameter")
            result.append((c, names))


def operation(sign, a, b):
    return {
        "||": lambda p: float(a(p) != 0 or b(p) != 0), "&&": lambda p: float(a(p) != 0 and b(p) != 0),
        "==": lambda p: float(a(p) == b(p)), "!=": lambda p: float(a(p) != b(p)),
        "<": lambda p: float(a(p) < b(p)), "<=": lambda p: float(a(p) <= b(p)),
        ">": lambda p: float(a(p) > b(p)), ">=": lambda p: float(a(p) >= b(p)),
        "+": lambda p: a(p) + b(p), "-": lambda p: a(p) - b(p), "*": lambda p: a(p) * b(p), "/": lambda p: a(p) / b(p),
        "%": lambda p: math.fmod(a(p), b(p)), "^": lambda p: math.pow(a(p), b(p)),
    }[sign]


class Production:
    def __init__(self, line, functions):
        scanner = Scanner(line, functions)
        first = scanner.pattern(["<", ">", ":", "-->"])
        self.left, self.right, self.condition = [], [], lambda p: 1.0
        if scanner.take("<"):
            self.left, first = first, scanner.pattern([">", ":", "-->"])
        (self.character, self.parameters), = first
        if scanner.take(">"):
            self.right = scanner.pattern([":", "-->"])
        if self.character in TURTLE or self.character in "Di":
            raise Disagreement(f"{self.character} has a meaning for the turtle")
        names = self.parameters + [n for _, ns in self.left + self.right for n in ns]
        if len(set(names)) != len(names):
            raise Disagreement(f"parameters named twice: {line[:60]}")
        if scanner.take(":"):
            scanner.blanks()
            self.condition = scanner.expression()
        scanner.expect("-->")
        self.successor = [] if scanner.take("*") else scanner.modules([])
        scanner.blanks()
        if scanner.at != len(line):
            raise Disagreement(f"text behind the successor: {line[scanner.at:]!r}")
        self.constants = scanner.constants


class Program:
    def __init__(self, text, functions):
        self.sections = {"lsystem": [], "decomposition": [], "homomorphism": []}
        self.depths = {"decomposition": 1, "homomorphism": 1}
        self.ignored, self.length = set(), 0
        section, constants, ended = None, 0, False
        for line in preprocessed(text).split("\n"):
            if not line.strip():
                continue
            if ended:
                raise Disagreement("text behind endlsystem")
            if section is None:
                if line != "lsystem: 1":
                    raise Disagreement(f"begins with {line!r}")
                section = "header"
            elif line.startswith("derivation length: "):
                self.length = int(line.split(":")[1])
            elif line.startswith("maximum depth: "):
                self.depths[section] = int(line.split(":")[1])
            elif line.startswith("ignore: "):
                self.ignored = set(line[len("ignore: "):])
            elif line.startswith("axiom: "):
                scanner = Scanner(line[len("axiom: "):], functions)
                self.axiom = self.evaluated(scanner.modules([]), {})
                constants += scanner.constants
                section = "lsystem"
            elif line in ("decomposition", "homomorphism"):
                section = line
            elif line == "endlsystem":
                ended = True
            else:
                self.sections[section].append(Production(line, functions))
                constants += self.sections[section][-1].constants
        if not ended:
            raise Disagreement("endlsystem is missing")
        self.too_many = constants > MOST_CONSTANTS

    @staticmethod
    def evaluated(modules, values):
        return [(c, [float(np.float32(a(values))) for a in arguments]) for c, arguments in modules]

    def apply(self, section, string, at):
        character, values = string[at]
        for production in self.sections[section]:
            if production.character != character or len(production.parameters) != len(values):
                continue
            known = dict(zip(production.parameters, values))
            if not self.match(production.left, string, at, -1, known) or not self.match(production.right, string, at, 1, known):
                continue
            if production.condition(known):
                return self.evaluated(production.successor, known)
        return None

    def match(self, context, string, at, way, known):
        """Left contexts follow the path to the root, right ones skip branches."""
        opening, closing = ("[", "]") if way > 0 else ("]", "[")
        for character, parameters in context if way > 0 else reversed(context):
            at += way
            while 0 <= at < len(string):
                c = string[at][0]
                if c == opening:
                    depth = 1
                    while depth:
                        at += way
                        depth += {opening: 1, closing: -1}.get(string[at][0], 0)
                elif c == closing and way > 0:
                    return False
                elif c not in self.ignored and c != closing:
                    break
                at += way
            if not 0 <= at < len(string) or string[at][0] != character or len(string[at][1]) != len(parameters):
                return False
            known.update(zip(parameters, string[at][1]))
        return True

    def expanded(self, section, string):
        result, stack = [], [(string, 0, 0)]
        while stack:
            modules, at, depth = stack.pop()
            if at == len(modules):
                continue
            stack.append((modules, at + 1, depth))
            made = self.apply(section, modules, at)
            if made is None:
                result.append(modules[at])
            elif depth >= self.depths[section]:
                raise Disagreement(f"the {section} does not end at its maximum depth")
            else:
                stack.append((made, 0, depth + 1))
        return result

    def derive(self):
        string = self.expanded("decomposition", self.axiom)
        for _ in range(self.length):
            made = [self.apply("lsystem", string, at) for at in range(len(string))]
            string = [m for at, new in enumerate(made) for m in ([string[at]] if new is None else new)]
            string = self.expanded("decomposition", string)
        return string

    def interpreted(self):
        return self.expanded("homomorphism", self.derive())


class Turtle:
    def __init__(self, view, colors):
        self.colors = colors
        self.position = np.zeros(3)
        self.frame = np.array([[0.0, 1, 0], [-1, 0, 0], [0, 0, -1]])  # heading, left, up
        self.scale = float(view["initial scale"])
        self.color, self.width = int(view["initial color"]), float(view["initial line width"].split()[0])
        self.stack, self.polygon, self.line, self.drawn = [], None, None, []

    def rotate(self, a, b, degrees):
        c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
        first, second = self.frame[a].copy(), self.frame[b].copy()
        self.frame[a], self.frame[b] = c * first + s * second, c * second - s * first

    def move(self, length):
        self.position = self.position + float(np.float32(length * self.scale)) * self.frame[0]

    def flat(self, points):
        points = np.array(points)
        if np.abs(points[:, 2]).max() > 1e-5 * (1 + np.abs(points).max()):
            raise Disagreement("draws outside the plane")
        return points[:, :2] * [1, -1]

    def end_line(self):
        if self.line:
            self.drawn.append(Line([self.flat(self.line)], [], self.colors[self.color], self.width))
        self.line = None

    def walk(self, modules):
        at = 0
        while at < len(modules):
            c, arguments = modules[at]
            if c == "@":
                letters = "".join(m[0] for m in modules[at + 1:at + 3])
                if letters != "Di":
                    raise Disagreement(f"@{letters} is not known")
                arguments, at = modules[at + 2][1], at + 2
                self.scale = float(np.float32(self.scale * arguments[0]))
            elif c in "DiF" and c != "F":
                raise Disagreement(f"{c} stands alone")
            else:
                self.interpret(c, arguments)
            at += 1
        self.end_line()
        if self.stack or self.polygon is not None:
            raise Disagreement("a bracket is not closed")

    def interpret(self, c, arguments):
        if c == "F":
            if self.polygon is not None:
                raise Disagreement("a line in a polygon")
            self.line = self.line or [self.position]
            self.move(*arguments)
            self.line.append(self.position)
            return
        if c not in "+-":
            self.end_line()
        if c in "+-":
            self.rotate(0, 1, arguments[0] if c == "+" else -arguments[0])
        elif c == "/":
            self.rotate(1, 2, arguments[0])
        elif c == "f":
            self.move(*arguments)
            if self.polygon is not None:
                self.polygon.append(self.position)
        elif c == "[":
            self.stack.append((self.position, self.frame.copy(), self.scale, self.color, self.width))
        elif c == "]":
            self.position, self.frame, self.scale, self.color, self.width = self.stack.pop()
        elif c == "{":
            self.polygon = []
        elif c == ".":
            self.polygon.append(self.position)
        elif c == "}":
            self.drawn.append(Fill(self.flat(self.polygon), self.colors[self.color]))
            self.polygon = None
        elif c == ";":
            self.color = int(arguments[0])
        elif c == "#":
            self.width = float(np.float32(arguments[0] * self.scale))
        elif c in TURTLE:
            raise Disagreement(f"{c} is not known")


def pairs(exported, picture, folder, functions=FUNCTIONS):
    view = dict(line.split(": ", 1) for line in exported.with_suffix(".v").read_text().splitlines())
    if view["line style"] != "polygon" or view["z buffer"] != "off":
        raise Disagreement("the view draws lines otherwise")
    table = exported.with_suffix(".map").read_bytes()
    if len(table) != 768:
        raise Disagreement(f"a colour map of {len(table)} bytes")
    turtle = Turtle(view, [tuple(table[k:k + 3]) for k in range(0, 768, 3)])
    turtle.walk(Program(exported.read_text(), functions).interpreted())
    every = dict.fromkeys(p["style"] for p in picture.placements)
    fixed = any(picture.styles.get(number, {}).get("fixed") for number in every)
    return Comparison(picture, LIMIT, width_of=None if fixed else lambda width, scale: width * scale).pairs(turtle.drawn)
