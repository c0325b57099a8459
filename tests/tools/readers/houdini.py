"""Houdini's L-System SOP: an independent reader of premise and rules, written from the node's documentation.

Symbols and parameters are single letters; + turns right; f and F go as far as their argument says, whatever the scale; of the
letters for variables only those are taken that the documentation leaves free. Two rules that both apply are a fault, since the
documentation does not say which is taken.
"""
import math
import re

import numpy as np

from .drawn import Comparison, Fill, Line
from .picture import Disagreement

FORMAT = "houdini"
ENDING = ".txt"
LIMIT = 5e-6  # arguments are single-precision numbers, and the scale is one that is multiplied again and again

TURTLE = set("FHGfhJKMTga+-&^\\/|*~\"!;_?@'#%$[]{}.")
VARIABLES = set("ALTUVWtxyzgiabcd")
LEVELS = [("|",), ("&",), ("<", ">"), ("+", "-"), ("*", "/", "%"), ("^",)]
MOST_PARAMETERS = 5
FUNCTIONS = {"min": min, "max": max}


def missing():
    return None


class Scanner:
    def __init__(self, text):
        self.text, self.at = text, 0

    def take(self, token):
        if self.text.startswith(token, self.at):
            self.at += len(token)
            return True
        return False

    def expect(self, token):
        if not self.take(token):
            raise Disagreement(f"expected {token!r} at {self.text[self.at:self.at + 30]!r}")

    def expression(self, level=0):
        if level == len(LEVELS):
            return self.unary()
        left, chained = self.expression(level + 1), 0
        while self.text[self.at:self.at + 1] in LEVELS[level] and self.at < len(self.text):
            sign = self.text[self.at]
            self.at += 1
            chained += 1
            if chained > 1 and sign in "^<>%":
                raise Disagreement(f"{sign} twice without parentheses: {self.text[:60]}")
            left = operation(sign, left, self.expression(level + 1))
        return left

    def unary(self):
        if self.take("-"):
            operand = self.unary()
            return lambda p: -operand(p)
        if self.take("!"):
            operand = self.unary()
            return lambda p: float(operand(p) == 0)
        return self.atom()

    def atom(self):
        if self.take("("):
            inner = self.expression()
            self.expect(")")
            return inner
        rest = self.text[self.at:]
        number = re.match(r"\d+(\.\d+)?", rest)
        if number:
            self.at += number.end()
            value = float(number[0])
            return lambda p: value
        word = re.match(r"[A-Za-z]+", rest)
        if not word:
            raise Disagreement(f"expected a value at {rest[:30]!r}")
        self.at += word.end()
        if word[0] in FUNCTIONS:
            self.expect("(")
            first = self.expression()
            self.expect(",")
            second = self.expression()
            self.expect(")")
            function = FUNCTIONS[word[0]]
            return lambda p: function(first(p), second(p))
        if len(word[0]) != 1 or word[0] in VARIABLES:
            raise Disagreement(f"{word[0]} is no parameter")
        return lambda p: p[word[0]]

    def modules(self):
        modules = []
        while self.at < len(self.text):
            c = self.text[self.at]
            self.at += 1
            if c.isspace():
                raise Disagreement("a blank in a string")
            arguments = []
            if self.take("("):
                while True:
                    quoted = re.match(r'"(\w+)"', self.text[self.at:])
                    if quoted:
                        self.at += quoted.end()
                        arguments.append(quoted[1])
                    else:
                        arguments.append(self.expression())
                    if not self.take(","):
                        break
                self.expect(")")
            if not (c.isalpha() or c in TURTLE):
                raise Disagreement(f"{c} is no symbol")
            modules.append((c, arguments))
        return modules


def operation(sign, a, b):
    return {
        "|": lambda p: float(a(p) != 0 or b(p) != 0), "&": lambda p: float(a(p) != 0 and b(p) != 0),
        "<": lambda p: float(a(p) < b(p)), ">": lambda p: float(a(p) > b(p)),
        "+": lambda p: a(p) + b(p), "-": lambda p: a(p) - b(p), "*": lambda p: a(p) * b(p), "/": lambda p: a(p) / b(p),
        "^": lambda p: math.pow(a(p), b(p)),
    }[sign]


class Rule:
    def __init__(self, text):
        head, _, successor = text.partition("=")
        predecessor, _, condition = head.partition(":")
        found = re.fullmatch(r"(\S)(?:\(([^()]*)\))?", predecessor)
        if not found:
            raise Disagreement(f"predecessor {predecessor!r}")
        self.symbol, self.parameters = found[1], found[2].split(",") if found[2] else []
        if self.symbol in TURTLE or len(self.parameters) > MOST_PARAMETERS:
            raise Disagreement(f"{predecessor} is the turtle's, or has too many parameters")
        if any(len(p) != 1 or p in VARIABLES for p in self.parameters) or len(set(self.parameters)) < len(self.parameters):
            raise Disagreement(f"parameters of {predecessor}")
        self.condition = None
        if condition:
            scanner = Scanner(condition)
            self.condition = scanner.expression()
            if scanner.at != len(condition):
                raise Disagreement(f"the condition {condition!r} ends at {condition[scanner.at:]!r}")
        self.successor = Scanner(successor).modules()

    def applies(self, symbol, values):
        if symbol != self.symbol or len(values) != len(self.parameters):
            return False
        return self.condition is None or self.condition(dict(zip(self.parameters, values))) != 0


def evaluated(modules, known):
    return [(c, [a if isinstance(a, str) else float(np.float32(a(known))) for a in arguments]) for c, arguments in modules]


class Program:
    def __init__(self, text):
        lines = [line for line in text.splitlines() if line and not line.startswith("#")]
        named = dict(line.split(": ", 1) for line in lines)
        self.generations = int(named.pop("Generations"))
        self.premise = evaluated(Scanner(named.pop("Premise")).modules(), {})
        if list(named) != [f"Rule {k + 1}" for k in range(len(named))]:
            raise Disagreement(f"lines {list(named)[:5]}")
        self.rules = {}
        for text in named.values():
            rule = Rule(text)
            self.rules.setdefault(rule.symbol, []).append(rule)

    def derived(self):
        """Without contexts, rewriting all at once and one after the other is the same."""
        result, stack = [], [(self.premise, 0, 0)]
        while stack:
            modules, at, generation = stack.pop()
            if at == len(modules):
                continue
            stack.append((modules, at + 1, generation))
            symbol, values = modules[at]
            fitting = [rule for rule in self.rules.get(symbol, []) if rule.applies(symbol, values)]
            if len(fitting) > 1:
                raise Disagreement(f"{len(fitting)} rules apply to {symbol}{values}")
            if not fitting:
                result.append(modules[at])
            elif generation == self.generations:
                raise Disagreement(f"{symbol} is left over after {generation} generations")
            else:
                stack.append((evaluated(fitting[0].successor, dict(zip(fitting[0].parameters, values))), 0, generation + 1))
        return result


class Turtle:
    def __init__(self):
        self.position = np.zeros(3)
        self.heading, self.right, self.out = np.array([0.0, 1, 0]), np.array([1.0, 0, 0]), np.array([0.0, 0, 1])
        self.color, self.polygon, self.line, self.width = (255, 255, 255), None, None, None
        self.stack, self.drawn = [], []

    def flat(self, points):
        points = np.array(points)
        if np.abs(points[:, 2]).max() > 1e-5 * (1 + np.abs(points).max()):
            raise Disagreement("draws outside the plane")
        return points[:, :2] * [1, -1]

    def end_line(self):
        if self.line:
            self.drawn.append(Line([self.flat(self.line)], [], self.color, self.width))
        self.line = None

    def walk(self, modules):
        for c, arguments in modules:
            if c == "F":
                length, width = arguments
                if self.line and width != self.width:
                    self.end_line()
                self.line, self.width = self.line or [self.position], width
                self.position = self.position + length * self.heading
                self.line.append(self.position)
            elif c in "+-":
                angle = math.radians(arguments[0] if c == "+" else -arguments[0])
                self.heading, self.right = (math.cos(angle) * self.heading + math.sin(angle) * self.right,
                                            math.cos(angle) * self.right - math.sin(angle) * self.heading)
            else:
                self.end_line()
                self.other(c, arguments)
        self.end_line()
        if self.stack:
            raise Disagreement("a [ is not closed")

    def other(self, c, arguments):
        if c == "f":
            self.position = self.position + arguments[0] * self.heading
        elif c == "/":
            angle = math.radians(arguments[0])
            self.right, self.out = (math.cos(angle) * self.right + math.sin(angle) * self.out,
                                    math.cos(angle) * self.out - math.sin(angle) * self.right)
        elif c == "[":
            self.stack.append((self.position, self.heading, self.right, self.out, self.color))
        elif c == "]":
            self.position, self.heading, self.right, self.out, self.color = self.stack.pop()
        elif c == "{":
            self.polygon = []
        elif c == ".":
            self.polygon.append(self.position)
        elif c == "}":
            self.drawn.append(Fill(self.flat(self.polygon), self.color))
            self.polygon = None
        elif c == "a":
            if arguments[0] != "Cd":
                raise Disagreement(f"attribute {arguments[0]}")
            self.color = tuple(255 * v for v in arguments[1:])
        elif c in TURTLE:
            raise Disagreement(f"{c} is not expected")


def pairs(exported, picture, folder):
    turtle = Turtle()
    turtle.walk(Program(exported.read_text()).derived())
    return Comparison(picture, LIMIT, width_of=lambda width, scale: width * scale).pairs(turtle.drawn)
