#!/usr/bin/env python3
"""Writes grammars drawn at random, for properties that hold for all of them.  random_rules.py FOLDER COUNT [SEED]

Rules call each other with counts that fall, so that each ends; what stands behind a rule may or may not be moved by it; angles,
lengths and scales follow parameters, constants and styles; some grammars have exceptions, layers and mirror images.
"""
import random
import sys
from pathlib import Path

TERMINALS = """
style 1: fill none; stroke #305080; stroke-width 0.6
style 2: fill #d04020
style 3: fill #20a060; stroke #103020; stroke-width 0.3; stroke-linejoin round
terminal Leaf: style 2; path "M0 0C2 -1 2 -4 0 -6C-2 -4 -1.5 -1 0 0Z"
terminal Twig: style 1; path "M0 0L0.5 -5"
terminal Box: style 3; path "M-1 -1H2V1.5H-1ZM0 0H1V0.5Z"
"""


def number(dice, low, high):
    return f"{dice.uniform(low, high):.{dice.choice([0, 1, 3])}f}"


def angle(dice, names):
    kind = dice.randrange(4)
    if kind == 0 and names:
        return f"{dice.randint(2, 9)}*{dice.choice(names)} - {dice.randint(1, 20)}"
    if kind == 1 and names:
        return f"lean*sin({dice.randint(20, 70)}*{dice.choice(names)})"
    return number(dice, 1, 120)


def move(dice, names, features):
    kind = dice.randrange(7)
    if kind < 3:
        return f"{dice.choice('+-')}({angle(dice, names)})"
    if kind < 5:
        return f"f({number(dice, 1, 9)})" if not names or dice.random() < 0.6 else f"f(2 + {dice.choice(names)}/3)"
    if kind == 5:
        return f"*({number(dice, 0.6, 0.99)})" if dice.random() < 0.7 else "*(shrink)"
    if "mirror" in features and dice.random() < 0.5:
        return "|"
    if "styles" in features and dice.random() < 0.6:
        return f";({names[0]} % 3 + 1)" if names and dice.random() < 0.5 else f";({dice.randint(0, 3)})"
    if "layers" in features:
        return f"z({dice.choice([-1, 1, 2])})"
    return f"f({number(dice, -3, 3)})"


def call(dice, rules, count, extra):
    name = dice.choice(rules)
    return f"{name}({count}, {extra})" if name in "QS" else f"{name}({count})"


def string(dice, rules, names, count, extra, features, calls):
    parts = []
    for _ in range(dice.randint(1, 3)):
        parts.append(dice.choice(["Leaf", "Twig", "Box"]))
        parts += [move(dice, names, features) for _ in range(dice.randint(0, 3))]
    for _ in range(calls):
        inner = [move(dice, names, features) for _ in range(dice.randint(0, 3))] + [call(dice, rules, count, extra)]
        if dice.random() < features["closed"]:
            inner = ["["] + inner + ["]"]
        at = dice.choice([len(parts), dice.randint(0, len(parts))])
        parts[at:at] = inner
    return " ".join(parts)


def grammar(dice):
    features = {"closed": dice.choice([0.3, 0.8, 1.0])}
    for name in ("mirror", "styles", "layers", "exceptions", "plain"):
        if dice.random() < 0.4:
            features[name] = True
    lines = ["lsystem 1", f"canvas -100 -100 {dice.randint(180, 220)} 200", f"define lean = {number(dice, 5, 40)}",
             "define shrink = 0.9", ""]
    rules = ["P", "Q", "R", "S"]
    lines.append(f"axiom: {string(dice, rules, [], dice.randint(2, 4), '1.5', features, 2)} Step(3) Box")
    lines.append("Step(d) -> -(90) f(d) +(90)")
    for rule in rules:
        two = rule in "QS"
        names = ["m", "w"] if two else ["m"]
        head = f"{rule}({', '.join(names)})"
        extra = dice.choice(["w*0.9 + 0.1", "w"]) if two else dice.choice(["2.5", "m/2"])
        body = string(dice, rules, names, "m-1", extra, features, dice.choice([1, 1, 2]))
        lines.append(f"{head} : m > {dice.choice([0, 1])} -> {body}")
        if dice.random() < 0.5:
            lines.append(f"{head} : m == 0 -> {string(dice, rules, names, 'm', extra, features, 0)}")
    if "exceptions" in features:
        for _ in range(2):
            address = ".".join(str(dice.randint(1, 4)) for _ in range(dice.randint(1, 4)))
            lines.append(f"except {address} -> {string(dice, rules, [], 1, '0.5', features, dice.randint(0, 1))}")
    return "\n".join(lines) + "\n" + TERMINALS


def main():
    folder, count = Path(sys.argv[1]), int(sys.argv[2])
    seed = int(sys.argv[3]) if len(sys.argv) > 3 else 1
    folder.mkdir(parents=True, exist_ok=True)
    for index in range(count):
        (folder / f"random{seed + index}.lsys").write_text(grammar(random.Random(seed + index)))


if __name__ == "__main__":
    main()
