"""The Markdown pages of a source tree: their lines, fenced blocks, headings with anchors, and links."""
import os
import re
from dataclasses import dataclass, field
from pathlib import Path

LEFT_OUT = re.compile(r"^(build.*|out|node_modules|\..*|__pycache__)$")
FENCE = re.compile(r"^\s*(```+|~~~+)\s*(\S*)")
HEADING = re.compile(r"^#{1,6}\s+(.*?)\s*#*$")
CODE_SPAN = re.compile(r"(`+)(.+?)\1")
LINK = re.compile(r"!?\[(?:[^\[\]]|\[[^\[\]]*\](?:\([^()\s]*\))?)*\]\(\s*<?([^()\s>]+)>?(?:\s+\"[^\"]*\")?\s*\)")
HTML_LINK = re.compile(r"<(?:img|a)\b[^>]*?\b(?:src|href)=\"([^\"]+)\"")
DEFINITION = re.compile(r"^\[[^\]]+\]:\s+(\S+)")


@dataclass
class Block:
    """A fenced block: the line of its fence, counted from 1, and its text."""
    line: int
    kind: str
    text: str = ""


@dataclass
class Page:
    path: Path
    lines: list[tuple[int, str]] = field(default_factory=list)  # outside of blocks, counted from 1
    blocks: list[Block] = field(default_factory=list)


def tree_paths(root):
    """All files of the tree but what was built, in order of their paths."""
    found = []
    for folder, folders, files in os.walk(root):
        folders[:] = [name for name in folders if not LEFT_OUT.match(name)]
        found += [Path(folder) / name for name in files]
    return sorted(found)


def page_paths(root):
    return [path for path in tree_paths(root) if path.suffix == ".md"]


def read_page(path):
    page, fence = Page(path), None
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        found = FENCE.match(line)
        if fence:
            if found and found[1].startswith(fence) and not found[2]:
                fence = None
            else:
                page.blocks[-1].text += line + "\n"
        elif found:
            fence = found[1]
            page.blocks.append(Block(number, found[2]))
        else:
            page.lines.append((number, line))
    return page


def anchor_of(heading):
    """What a heading is called in links, as GitHub and the site make it."""
    text = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", heading)
    text = re.sub(r"<[^>]+>", "", text).replace("`", "")
    return re.sub(r"[^\w\- ]", "", text.lower().strip()).replace(" ", "-")


def anchors(page):
    found, times = set(), {}
    for _, line in page.lines:
        heading = HEADING.match(line)
        if not heading:
            continue
        name = anchor_of(heading[1])
        count = times.get(name, 0)
        times[name] = count + 1
        found.add(name if count == 0 else f"{name}-{count}")
    return found


def links(page):
    """(line, target) of all links and pictures."""
    for number, line in page.lines:
        text = CODE_SPAN.sub(lambda span: " " * len(span[0]) if "](" in span[2] else span[0], line)
        for pattern in (LINK, HTML_LINK, DEFINITION):
            for found in pattern.finditer(text):
                yield number, found[1]


def code_spans(line):
    return [span[2].strip() for span in CODE_SPAN.finditer(line)]
