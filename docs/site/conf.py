"""The pages as a site: sphinx-build -c docs/site ROOT FOLDER, by scripts/make_docs.sh, which makes the interfaces (FOLDER/api) first.

The pages stay as they are read in the tree: Markdown with links between files. Here code that stands between backquotes gets a link to its interface,
and what pages link to besides pages, pictures and downloads – folders and sources – is listed or copied below FOLDER/tree.
"""
import os
import re
import shutil
import xml.etree.ElementTree as ElementTree
from html import escape
from pathlib import Path

from docutils import nodes
from pygments.lexer import RegexLexer
from pygments.token import Comment, Keyword, Name, Number, String, Text

ROOT = Path(__file__).resolve().parents[2]

project = "Rinceau"
version = release = re.search(r"project\(rinceau VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())[1]
extensions = ["myst_parser"]
myst_enable_extensions = ["html_image"]
myst_heading_anchors = 6
root_doc = "docs/site/index"
source_suffix = {".md": "markdown"}
include_patterns = ["*.md", "docs/**", "scene/*.md", "growth/*.md", "editor/*.md", "samples/*.md"]
exclude_patterns = ["build*", "out"]
html_theme = "furo"
html_title = "Rinceau"
html_copy_source = False
html_show_sphinx = False
html_static_path = ["site.css"]
html_css_files = ["site.css"]
pygments_style = "friendly"


class RulesLexer(RegexLexer):
    """Grammars, shape grammars, and what commands say of them."""

    tokens = {"root": [
        (r"(?<![\w#])#(?!\w{3,8}\b).*$", Comment), (r'"[^"\n]*"', String), (r"#\w+", String),
        (r"^(lsystem|title|canvas|seed|use|define|ignore|axiom|decomposition|homomorphism|except|style|terminal|param|shape|field|option)\b",
         Keyword),
        (r"\d+(\.\d+)?", Number), (r"[A-Za-z_]\w*", Name), (r"\s+", Text), (r".", Text),
    ]}


class Interfaces:
    """Where headers, types and functions stand in what Doxygen made."""

    def __init__(self, tags):
        self.headers, self.functions, self.types = {}, {}, {}
        if not tags.is_file():
            return
        for compound in ElementTree.parse(tags).getroot().iter("compound"):
            if compound.get("kind") in ("struct", "class"):
                self.types[compound.findtext("name")] = compound.findtext("filename")
            if compound.get("kind") != "file":
                continue
            header = (Path(compound.findtext("path")) / compound.findtext("name")).relative_to(ROOT).as_posix()
            self.headers[header] = compound.findtext("filename")
            for member in compound.iter("member"):
                if member.get("kind") == "function":
                    address = f"{member.findtext('anchorfile')}#{member.findtext('anchor')}"
                    self.functions.setdefault(member.findtext("name"), {}).setdefault(header, address)

    def header(self, text):
        """The header that a path means, with or without its ending; None if it means none."""
        header = re.sub(r"\.(h|cpp)$", "", text) + ".h"
        return header if header in self.headers else None

    def type(self, text):
        return self.types.get(text)

    def function(self, text, header):
        """The address of a call: in the header that was named before it, or in the only one that has it."""
        found = self.functions.get(text[:-2].split("::")[-1], {}) if text.endswith("()") else {}
        return found.get(header) or (next(iter(found.values())) if len(found) == 1 else None)


def link_code(app, doctree, docname):
    up = "../" * docname.count("/") + "api/"
    last = None
    for literal in list(doctree.findall(nodes.literal)):
        if isinstance(literal.parent, nodes.reference):
            continue
        text = literal.astext()
        header = app.interfaces.header(text)
        last = header or last
        address = app.interfaces.headers.get(header) or app.interfaces.type(text) or app.interfaces.function(text, last)
        if address:
            link = nodes.reference("", "", refuri=up + address, internal=True)
            literal.replace_self(link)
            link += literal


def link_tree(app, env, node, contnode):
    """Links to folders and to files that are no pages."""
    target = (ROOT / Path(node.get("refdoc", "")).parent / node.get("reftarget", "")).resolve()
    if not target.exists() or ROOT not in target.parents:
        return None
    name = target.relative_to(ROOT).as_posix()
    app.linked_tree.add(name)
    up = "../" * node["refdoc"].count("/")
    address = f"{up}tree/{name}/index.html" if target.is_dir() else f"{up}tree/{name}"
    link = nodes.reference("", "", refuri=address, internal=True)
    link += contnode
    return link


def copy_tree(app, exception):
    if exception or app.builder.name != "html":
        return
    out = Path(app.outdir)
    for name in sorted(app.linked_tree):
        source, goal = ROOT / name, out / "tree" / name
        if source.is_dir():
            goal.mkdir(parents=True, exist_ok=True)
            files = sorted(file for file in source.iterdir() if file.is_file())
            for file in files:
                shutil.copy(file, goal / file.name)
            lines = "".join(f'<li><a href="{escape(file.name)}">{escape(file.name)}</a></li>\n' for file in files)
            (goal / "index.html").write_text(
                f'<!doctype html><meta charset="utf-8"><title>{escape(name)}</title><h1>{escape(name)}</h1>\n<ul>\n{lines}</ul>\n',
                encoding="utf-8")
        else:
            goal.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(source, goal)
    (out / "index.html").write_text('<!doctype html><meta charset="utf-8"><title>Rinceau</title>'
                                    '<meta http-equiv="refresh" content="0; url=docs/site/index.html">'
                                    '<a href="docs/site/index.html">Rinceau</a>\n', encoding="utf-8")


def setup(app):
    app.interfaces = Interfaces(Path(os.environ.get("RINCEAU_TAGS", "")))
    app.linked_tree = set()
    for language in ("lsys", "fgsg", "derived", "checked"):
        app.add_lexer(language, RulesLexer)
    app.connect("doctree-resolved", link_code)
    app.connect("missing-reference", link_tree)
    app.connect("build-finished", copy_tree)
    return {"parallel_read_safe": False, "parallel_write_safe": False}
