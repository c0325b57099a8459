#!/usr/bin/env python3
"""Every link and picture of a site of HTML leads to a file of it, every anchor to an element: check_site.py FOLDER.

Anchors in links from one page of api/ to another are not looked at: Doxygen 1.9.4 leads to headings and lines that it does not mark.
"""
import html
import re
import sys
from pathlib import Path
from urllib.parse import unquote

LINK = re.compile(r"<(?:a|img|link|script|iframe|source)\b[^>]*?\b(?:href|src)=\"([^\"]*)\"", re.IGNORECASE)
ANCHOR = re.compile(r"\b(?:id|name)=\"([^\"]*)\"")
ELSEWHERE = re.compile(r"^([a-z][a-z0-9+.-]*:|//)")


def made_by_hand(page, site):
    return page.relative_to(site).parts[0] != "api"


def faults(site):
    pages = {path.resolve(): path.read_text(encoding="utf-8", errors="replace") for path in sorted(site.rglob("*.html"))}
    anchors = {}
    for path, text in pages.items():
        said = set()
        for target in LINK.findall(text):
            target = html.unescape(target)
            if ELSEWHERE.match(target) or target in said:
                continue
            said.add(target)
            name, _, anchor = unquote(target).partition("#")
            goal = (path.parent / name.partition("?")[0]).resolve() if name else path
            if goal.is_dir():
                goal = goal / "index.html"
            if not goal.exists():
                yield f"{path.relative_to(site)}: {target} leads to nothing"
            elif anchor and goal in pages and made_by_hand(path, site):
                if goal not in anchors:
                    anchors[goal] = set(map(html.unescape, ANCHOR.findall(pages[goal])))
                if anchor not in anchors[goal]:
                    yield f"{path.relative_to(site)}: {target}: no such anchor"


def main():
    site = Path(sys.argv[1]).resolve()
    if not any(site.rglob("*.html")):
        print(f"{site}: no pages")
        return 1
    found = list(faults(site))
    print("\n".join(found[:50] + [f"{len(found)} links lead to nothing"] if found else ["all links lead somewhere"]))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
