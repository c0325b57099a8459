"""Every page can be found: docs/README.md lists it, and docs/site/index.md has it in the contents of the site."""
import re

from pages import links, page_paths, read_page

# Pages of the tree that are no part of the documentation.
APART = re.compile(r"^(docs/site/.*|tests/.*)$")
INDEXES = ("docs/README.md", "docs/site/index.md")


def faults(root):
    if not all((root / name).is_file() for name in INDEXES):
        return
    index, contents = ((root / name).resolve() for name in INDEXES)
    listed = {(index.parent / target.partition("#")[0]).resolve() for _, target in links(read_page(index))}
    # What the index of a folder of docs/ lists is found by that.
    for folder_index in [path for path in listed if path.name == "README.md" and path.is_file() and path.parent.parent == index.parent]:
        listed |= {(folder_index.parent / target.partition("#")[0]).resolve() for _, target in links(read_page(folder_index))}
    in_contents = {(contents.parent / (line.strip() + ".md")).resolve()
                   for block in read_page(contents).blocks for line in block.text.splitlines()}
    for path in page_paths(root):
        name = path.relative_to(root).as_posix()
        if APART.match(name) or path.resolve() == index:
            continue
        if path.resolve() not in listed:
            yield f"{name} is not listed in {INDEXES[0]}"
        if path.resolve() not in in_contents:
            yield f"{name} is not in the contents of the site, {INDEXES[1]}"
