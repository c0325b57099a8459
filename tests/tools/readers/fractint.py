"""Fractint: an independent reader of .l entries, written from the semantics of Fractint's and Iterated Dynamics' L-systems.

Case does not matter; a comment begins with a semicolon; lines of one symbol add up; numbers are digits and a point, read into 29
characters; rules are applied as often as the order says, and what has no rule is a command or nothing.
"""
import math
import re

import numpy as np

from .drawn import Comparison, Line
from .picture import Disagreement

FORMAT = "fractint"
ENDING = ".l"
LIMIT = 1e-9

RESERVED = "+-/\\@|!c<>]["
LONGEST_LINE = 160


def missing():
    return None


class Entry:
    def __init__(self, text):
        head, body = text.split("{", 1)
        if not re.fullmatch(r"\w+ ", head):
            raise Disagreement(f"the entry is called {head!r}")
        self.order = int(re.search(r"order (\d+)", text)[1])
        self.rules, self.axiom, self.angle = [], None, 0
        for line in body.split("\n"):
            if len(line) > LONGEST_LINE:
                raise Disagreement(f"a line of {len(line)} characters")
            line = line.split(";")[0].lower()
            if not line.strip():
                continue
            if line.strip() == "}":
                break
            words = [w for w in re.split(r"[ =\t]+", line) if w]
            if len(words) > 2:
                raise Disagreement(f"extra text after command: {line!r}")
            if words[0] == "axiom":
                self.axiom = words[1]
            elif words[0] == "angle":
                self.angle = int(words[1])
            elif len(words[0]) == 1:
                self.add_rule(words[0], words[1] if len(words) > 1 else "")
            else:
                raise Disagreement(f"syntax error: {line!r}")
        else:
            raise Disagreement("the entry is not closed")
        if self.axiom is None or not 3 <= self.angle <= 50:
            raise Disagreement("no axiom, or illegal or missing angle")

    def add_rule(self, symbol, text):
        if symbol in RESERVED or symbol in "dmfg" or symbol.isdigit():
            raise Disagreement(f"redefined reserved symbol {symbol}")
        known = [number for number, rule in enumerate(self.rules) if rule[0] == symbol]
        if known and known[0] == 0:
            raise Disagreement("the first rule goes on in another line, which Iterated Dynamics takes for another rule")
        if known:
            self.rules[known[0]] = (symbol, self.rules[known[0]][1] + text)
        else:
            self.rules.append((symbol, text))

    def compiled(self):
        """symbol -> [(character, number)]"""
        return {symbol: commands_of(text) for symbol, text in self.rules}, commands_of(self.axiom)


def commands_of(text):
    commands, at = [], 0
    while at < len(text):
        c = text[at]
        at += 1
        number = None
        if c in "/\\@c<>":
            root = inverse = False
            for _ in range(2):
                if text[at:at + 1] == "q":
                    root, at = True, at + 1
                elif text[at:at + 1] == "i":
                    inverse, at = True, at + 1
            digits = re.match(r"[0-9.]*", text[at:])[0]
            if len(digits) > 29 or digits.count(".") > 1 or not digits:
                raise Disagreement(f"the number {digits!r}")
            at += len(digits)
            number = float(digits)
            number = 0.0 if number <= 0 else number
            if number and root:
                number = math.sqrt(number)
            if number and inverse:
                number = 1 / number
        commands.append((c, number))
    return commands


class Turtle:
    def __init__(self, rules, colors):
        self.rules, self.colors = rules, colors
        self.x = self.y = self.angle = 0.0
        self.size, self.color, self.reverse = 1.0, 15, False
        self.line, self.drawn = None, []

    def end_line(self):
        if self.line:
            self.drawn.append(Line([np.array(self.line)], [], self.colors[self.color]))
        self.line = None

    def draw(self, commands, order):
        """Bracketed parts are drawn within the rule that they stand in."""
        stack = [[commands, 0, order, []]]
        while stack:
            frame = stack[-1]
            if frame[1] == len(frame[0]):
                if frame[3]:
                    raise Disagreement("a bracket is closed in another rule than it is opened in")
                stack.pop()
                continue
            c, number = frame[0][frame[1]]
            frame[1] += 1
            if frame[2] > 0 and c in self.rules:
                stack.append([self.rules[c], 0, frame[2] - 1, []])
            elif c in self.rules:
                raise Disagreement(f"{c} is left over: the order is too small")
            elif c == "[":
                frame[3].append((self.x, self.y, self.angle, self.size, self.color, self.reverse))
                self.end_line()
            elif c == "]":
                if not frame[3]:
                    raise Disagreement("a ] without [ in its rule")
                self.end_line()
                self.x, self.y, self.angle, self.size, self.color, self.reverse = frame[3].pop()
            else:
                self.command(c, number)
        self.end_line()

    def command(self, c, number):
        if c in "/\\":
            self.angle += number if (c == "/") != self.reverse else -number
        elif c == "@":
            self.size *= number
        elif c == "!":
            self.reverse = not self.reverse
        elif c == "c":
            self.end_line()
            self.color = int(number)
        elif c in "dm":
            start = (self.x, self.y)
            self.x += self.size * math.cos(math.radians(self.angle))
            self.y += self.size * math.sin(math.radians(self.angle))
            if c == "m":
                self.end_line()
            else:
                self.line = self.line or [start]
                self.line.append((self.x, self.y))
        else:
            raise Disagreement(f"{c} is no command that is expected here")


def pairs(exported, picture, folder):
    table = exported.with_suffix(".map").read_text().splitlines()
    if len(table) != 256:
        raise Disagreement(f"a colour map of {len(table)} lines")
    entry = Entry(exported.read_text())
    rules, axiom = entry.compiled()
    turtle = Turtle(rules, [tuple(int(v) for v in line.split()) for line in table])
    turtle.draw(axiom, entry.order)
    return Comparison(picture, LIMIT, fills=False).pairs(turtle.drawn)
