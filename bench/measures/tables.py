"""Markdown tables, numbers as a person reads them, and growth."""

import math


def number(value):
    """Three digits; whole numbers in full, with commas."""
    if value is None:
        return "–"
    if isinstance(value, str):
        return value
    if value == 0 or (abs(value) >= 100 or float(value).is_integer()):
        return f"{value:,.0f}"
    digits = max(0, 2 - math.floor(math.log10(abs(value))))
    return f"{value:.{min(digits, 6)}f}"


def table(head, rows, text=(0,)):
    """The columns numbered in `text` stand left, from the end if negative; all others right. Rows may end early."""
    left = {column % len(head) for column in text}
    lines = ["| " + " | ".join(head) + " |",
             "|" + "".join("---|" if column in left else "--:|" for column in range(len(head)))]
    for row in rows:
        cells = [number(cell).replace("|", "\\|") for cell in row] + [""] * (len(head) - len(row))
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines)


def exponent(points):
    """The p of seconds = c * size^p by least squares of the logarithms; None of fewer than two different sizes."""
    usable = [(math.log(size), math.log(seconds)) for size, seconds in points if size > 0 and seconds > 0]
    if len({x for x, _ in usable}) < 2:
        return None
    mean_x = sum(x for x, _ in usable) / len(usable)
    mean_y = sum(y for _, y in usable) / len(usable)
    return (sum((x - mean_x) * (y - mean_y) for x, y in usable) / sum((x - mean_x) ** 2 for x, _ in usable))
