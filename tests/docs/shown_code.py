"""Code that docs/how_to shows: it stands in the source that the line before it names, word for word.

Before each block of C++, CMake or Python stands a line that ends with a link to a file and a colon; the lines of the block must stand
in that file, one below the other.
"""
import re

from pages import page_paths, read_page

PAGES = re.compile(r"^docs/how_to/.*")
CHECKED = {"cpp", "cmake", "python"}
NAMED = re.compile(r"\]\(([^()\s#]+)\):$")


def line_before(page, number):
    before = [line for line_number, line in page.lines if line_number < number and line.strip()]
    return before[-1].strip() if before else ""


def faults(root):
    for path in page_paths(root):
        name = path.relative_to(root).as_posix()
        if not PAGES.match(name):
            continue
        page = read_page(path)
        for block in page.blocks:
            if block.kind not in CHECKED:
                continue
            named = NAMED.search(line_before(page, block.line))
            source = path.parent / named[1] if named else None
            if source is None or not source.is_file():
                yield f"{name}:{block.line}: no file is named before the code"
            elif "\n" + block.text not in "\n" + source.read_text(encoding="utf-8"):
                yield f"{name}:{block.line}: {named[1]} does not say this"
