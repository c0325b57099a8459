#!/usr/bin/env python3
"""docs/site/check_site.py finds links, pictures and anchors that lead to nothing, and nothing else."""
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "docs" / "site"))

from check_site import faults  # noqa: E402

GOOD = {
    "index.html": '<a href="docs/page.html#two">x</a> <img src="docs/a%20b.png"> <a href="https://example.org/y">y</a> <a href="docs/">z</a>',
    "docs/index.html": "",
    "docs/page.html": '<h2 id="two">2</h2> <a href="#two">x</a> <a href="../api/a.html#b">a</a>',
    "docs/a b.png": "",
    "api/a.html": '<a id="b"></a> <a href="a.html#unmarked">of Doxygen</a>',
}
FAULTS = [
    ("index.html", "page.html#two", "page.html#three", "no such anchor"),
    ("index.html", "a%20b.png", "c.png", "leads to nothing"),
    ("docs/page.html", '"#two"', '"#three"', "no such anchor"),
    ("docs/page.html", "a.html#b", "a.html#c", "no such anchor"),
    ("api/a.html", "a.html#unmarked", "c.html", "leads to nothing"),
]


def said(files):
    with tempfile.TemporaryDirectory() as folder:
        site = Path(folder).resolve()
        for name, text in files.items():
            (site / name).parent.mkdir(parents=True, exist_ok=True)
            (site / name).write_text(text, encoding="utf-8")
        return list(faults(site))


def main():
    assert said(GOOD) == [], said(GOOD)
    for file, good, bad, expected in FAULTS:
        found = said({**GOOD, file: GOOD[file].replace(good, bad)})
        assert len(found) == 1 and expected in found[0], (file, bad, found)


if __name__ == "__main__":
    sys.exit(main())
