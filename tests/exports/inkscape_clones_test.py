#!/usr/bin/env python3
"""inkscape_clones_test.py RINCEAU PROJECT: in Inkscape clones follow their original, and layers are layers."""
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as tree
from pathlib import Path

rinceau, project = sys.argv[1], Path(sys.argv[2])
sys.path.insert(0, str(project / "tests/tools"))
from readers import inkscape  # noqa: E402
from readers.svg import SVG, elements_of_file  # noqa: E402

LABEL = "{http://www.inkscape.org/namespaces/inkscape}label"
MODE = "{http://www.inkscape.org/namespaces/inkscape}groupmode"


def export(grammar, output):
    subprocess.run([rinceau, "export", str(grammar), "--to", "svg", "-o", str(output)], check=True, timeout=60)


def an_edit_of_the_original_shows_everywhere(folder):
    source, edited = folder / "facade.svg", folder / "edited.svg"
    export(project / "samples/facade.lsys", source)
    nodes = list(tree.parse(source).getroot().iter())
    assert sum(node.get("id") == "Pane" for node in nodes) == 1
    assert {"Storeys", "Windows", "Window"} <= {node.get(LABEL) for node in nodes}
    clones = [node for node in nodes if node.tag == SVG + "use"]
    assert len(clones) < 60, "windows are clones of one window, not of its panes"
    inkscape.run(source, ["select-by-id:Pane", "object-set-attribute:d,M 0,0 H 1 V 1 Z", "object-set-attribute:fill,#00ff00",
                          "select-clear", "select-all:all", "clone-unlink-recursively", f"export-filename:{edited}",
                          "export-plain-svg", "export-do"], folder)
    before, after = elements_of_file(source), elements_of_file(edited)
    assert len(before) == len(after) == 113
    panes = [node for node in tree.parse(edited).getroot().iter(SVG + "path") if "#00ff00" in str(node.attrib)]
    windows_and_panes = 15 + 4
    assert len(panes) == windows_and_panes, len(panes)
    assert sum(len(element.points) == 3 for element in after) == windows_and_panes


def layers_are_layers(folder):
    grammar, output = folder / "layers.lsys", folder / "layers.svg"
    grammar.write_text("lsystem 1\ncanvas -20 -20 40 40\naxiom: P(3)\nP(m) : m > 0 -> [z(1) A] [Q] f(4) P(m-1)\nQ -> A [z(-1) A]\n"
                       "terminal A: path \"M0 0H3V3Z\"\n")
    export(grammar, output)
    root = tree.parse(output).getroot()
    layers = [node.get(LABEL) for node in root if node.get(MODE) == "layer"]
    assert layers == ["Layer -1", "Layer 0", "Layer 1"], layers
    assert len(elements_of_file(output)) == 9


with tempfile.TemporaryDirectory() as scratch:
    layers_are_layers(Path(scratch))
    an_edit_of_the_original_shows_everywhere(Path(scratch))
