#!/usr/bin/env python3
"""check_docs.py finds every kind of fault, and none in pages without."""
import sys
import tempfile
from pathlib import Path

from check_docs import CHECKS

CODE = "int answer() {\n    return 42;\n}\nint other();\n"
GOOD = {
    "README.md": "# Title\n[a](docs/how_to/page.md#the-answer-1) ![p](picture.png) <img src=\"picture.png\">\n"
                 "[far](https://example.org/x#y) `[no](link)` [here](#title)\n```\n[in](code)\n```\n",
    "picture.png": "",
    "lib/thing.h": "int answer();\nint other();\n",
    "lib/thing.cpp": CODE,
    "cli/main.cpp": "\"--depth\"\n",
    "docs/how_to/page.md": "# The answer\n# The `answer`\n`lib/thing`: `answer()`, `other`, `lib/`, `--depth 3`, `f(13) A`\n"
                           "From [thing](../../lib/thing.cpp):\n```cpp\n    return 42;\n}\n```\n",
}
# What is exchanged in which file, and what is then said.
FAULTS = [
    ("README.md", "picture.png)", "drawing.png)", "drawing.png leads to nothing"),
    ("README.md", 'src="picture', 'src="drawing', "drawing.png leads to nothing"),
    ("README.md", "answer-1", "answer-2", "has the anchor the-answer-2"),
    ("README.md", "(#title)", "(#titel)", "has the anchor titel"),
    ("README.md", "![p](picture.png)", "![p](picture.png#x)", "is no page"),
    ("docs/how_to/page.md", "`lib/thing`", "`lib/thong`", "there is no lib/thong"),
    ("docs/how_to/page.md", "`answer()`", "`question()`", "nothing is called question"),
    ("cli/main.cpp", "\"--depth\"", "int question(); \"--depth\"", None),
    ("docs/how_to/page.md", "`other`", "`another`", "nothing is called another"),
    ("docs/how_to/page.md", "--depth", "--dept", "no program has the option --dept"),
    ("docs/how_to/page.md", "return 42", "return 43", "does not say this"),
    ("docs/how_to/page.md", "From [thing](../../lib/thing.cpp):", "Thus:", "no file is named before the code"),
]


INDEX = {
    **GOOD,
    "docs/README.md": "[r](../README.md) [page](how_to/page.md)\n",
    "docs/site/index.md": "```{toctree}\n:caption: All\n\n../../README\n../README\n../how_to/page\n```\n",
}


def said(files):
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder).resolve()
        for name, text in files.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text, encoding="utf-8")
        return [fault for check in CHECKS.values() for fault in check(root)]


def main():
    assert said(GOOD) == [], said(GOOD)
    for file, good, bad, expected in FAULTS:
        assert good in GOOD[file], (file, good)
        found = said({**GOOD, file: GOOD[file].replace(good, bad, 1)})
        right = not found if expected is None else len(found) == 1 and expected in found[0]
        assert right, (file, bad, found)
    assert said(INDEX) == [], said(INDEX)
    for file, line in [("docs/README.md", "[page](how_to/page.md)"), ("docs/site/index.md", "../how_to/page\n")]:
        found = said({**INDEX, file: INDEX[file].replace(line, "")})
        assert len(found) == 1 and "docs/how_to/page.md is not" in found[0], (file, found)
    # A function of another file than the one that is named before it.
    elsewhere = {**GOOD, "cli/main.cpp": "\"--depth\" int question();"}
    elsewhere["docs/how_to/page.md"] = GOOD["docs/how_to/page.md"].replace("answer()", "question()")
    assert any("does not occur in" in fault for fault in said(elsewhere)), said(elsewhere)


if __name__ == "__main__":
    sys.exit(main())
