"""Files, functions, types and options that pages about the code name: do they exist?

Looked at is what stands between backquotes in the pages below. A path, from the root or from the page's folder, must be a file or a
folder, or be one with .h, .cpp or .py behind it. A word must be the name of a source or occur in the code. An option must occur in the
code. A call, `fitted()`, must occur in a file that is named in the same cell of a table, or on the same line, if there is any. What is
none of these is not looked at.
"""
import re

from pages import code_spans, page_paths, read_page, tree_paths

PAGES = re.compile(r"^docs/((architecture|analysis|growth|fields|shape_grammars|exports|editor)\.md|papers/.*|how_to/.*)$"
                   r"|^(growth|editor)/README\.md$|^scene/NORMAL_FORM\.md$")
SOURCE = re.compile(r"^.*(\.(h|cpp|py|sh|cmake|json|in)|CMakeLists\.txt)$")
ENDINGS = ("", ".h", ".cpp", ".py")
PATH = re.compile(r"^[A-Za-z0-9_.\-]+(/[A-Za-z0-9_.\-]+)+/?$|^[a-z_]+/$|^[A-Za-z0-9_\-]+\.(h|cpp|py|sh|md|txt|json|cmake)$")
WORD = re.compile(r"^[A-Za-z_]\w*(::[A-Za-z_]\w*)*$")
CALL = re.compile(r"^([A-Za-z_]\w*)(::[A-Za-z_]\w*)*\(\)$")
OPTION = re.compile(r"^(--[a-z][a-z\-]+)\b")


class Tree:
    """What the code of a source tree holds."""

    def __init__(self, root):
        self.root = root
        self.text = {}
        for path in tree_paths(root):
            name = path.relative_to(root).as_posix()
            if SOURCE.match(name) and not name.startswith("tests/docs/"):
                self.text[name] = path.read_text(encoding="utf-8", errors="replace")
        self.words = set()
        for text in self.text.values():
            self.words.update(re.findall(r"[A-Za-z_]\w*", text))
        self.stems = {name.rsplit("/", 1)[-1].rsplit(".", 1)[0] for name in self.text}

    def files(self, name):
        """The sources that a path means, .h and .cpp together."""
        stem = re.sub(r"\.(h|cpp)$", "", name)
        return [file for file in self.text if file in (name, stem + ".h", stem + ".cpp", name + ".py")]

    def has_path(self, name, folder):
        """Seen from the root or from the folder of the page."""
        if "/" not in name.rstrip("/") and not name.endswith("/"):
            return any(file.rsplit("/", 1)[-1] == name for file in self.text) or (self.root / name).exists()
        return any((place / (name + ending)).exists() for place in (self.root, folder) for ending in ENDINGS)

    def has_option(self, option):
        quoted = re.compile(re.escape(option) + r"(?![a-z\-])")
        return any(quoted.search(text) for text in self.text.values())


def cells(line):
    return re.split(r"(?<!\\)\|", line) if line.startswith("|") else [line]


def faults_of_cell(tree, cell, folder):
    files = [file for span in code_spans(cell) if PATH.match(span) for file in tree.files(span)]
    for span in code_spans(cell):
        call = CALL.match(span)
        option = OPTION.match(span)
        if PATH.match(span):
            if not tree.has_path(span, folder):
                yield f"there is no {span}"
        elif call:
            name = span[:-2].split("::")[-1]
            if name not in tree.words:
                yield f"nothing is called {name}"
            elif files and not any(re.search(rf"\b{name}\b", tree.text[file]) for file in files):
                yield f"{name} does not occur in {' '.join(files)}"
        elif WORD.match(span):
            if any(word not in tree.words and word not in tree.stems for word in span.split("::")):
                yield f"nothing is called {span}"
        elif option and not tree.has_option(option[1]):
            yield f"no program has the option {option[1]}"


def faults(root):
    tree = Tree(root)
    for path in page_paths(root):
        name = path.relative_to(root).as_posix()
        if not PAGES.match(name):
            continue
        for number, line in read_page(path).lines:
            for cell in cells(line):
                for fault in faults_of_cell(tree, cell, path.parent):
                    yield f"{name}:{number}: {fault}"
