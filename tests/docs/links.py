"""Links between pages, to files and to pictures: does what they lead to exist?"""
import re
from urllib.parse import unquote

from pages import anchors, links, page_paths, read_page

ELSEWHERE = re.compile(r"^[a-z][a-z0-9+.-]*:")


def faults(root):
    pages = {path.resolve(): read_page(path) for path in page_paths(root)}
    known = {path: anchors(page) for path, page in pages.items()}
    for path, page in pages.items():
        for line, target in links(page):
            if ELSEWHERE.match(target):
                continue
            where = f"{path.relative_to(root.resolve())}:{line}"
            name, _, anchor = unquote(target).partition("#")
            goal = (path.parent / name).resolve() if name else path
            if not goal.exists():
                yield f"{where}: {target} leads to nothing"
            elif anchor and goal not in known:
                yield f"{where}: {target} has an anchor, but is no page"
            elif anchor and anchor not in known[goal]:
                yield f"{where}: {target}: no heading of {name or 'this page'} has the anchor {anchor}"
