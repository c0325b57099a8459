"""Documents as Inkscape users have them: millimetres, layers, groups with transforms, gradients, clones."""

HEAD = '''<?xml version="1.0" encoding="UTF-8" standalone="no"?>
<svg width="100mm" height="80mm" viewBox="0 0 100 80" id="svg1" xmlns="http://www.w3.org/2000/svg"
  xmlns:xlink="http://www.w3.org/1999/xlink" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"
  xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd">
  <defs id="defs1">
    <linearGradient id="lin" gradientUnits="userSpaceOnUse" x1="-3" y1="0" x2="3" y2="0">
      <stop id="s1" offset="0" stop-color="#f00"/><stop id="s2" offset="1" stop-color="#00f"/></linearGradient>
  </defs>
  <g id="ground" inkscape:groupmode="layer" inkscape:label="Ground" style="fill:#eeddaa" sodipodi:insensitive="true">
    <rect id="paper" width="100" height="80"/>
  </g>
'''


def flower(turns=range(0, 360, 45)):
    """A ring of petals in a turned and stretched group of a turned layer, over a stem and under a text."""
    petals = '\n'.join(f'<path id="petal{i}" transform="rotate({turn})" style="fill:url(#lin)" '
                       'd="m 0,-5 c 3,-3 3,-8 0,-12 -3,4 -3,9 0,12 z"/>' for i, turn in enumerate(turns))
    return HEAD + f'''
  <g id="layer" inkscape:groupmode="layer" inkscape:label="Ornament" transform="rotate(10) translate(5,-3)"
     style="fill:#cc0000;stroke:#222222;stroke-width:0.3">
    <path id="stem" d="M 39,30 H 41 V 78 H 39 Z" style="fill:green"/>
    <g id="ring" transform="translate(40,30) scale(1.2,0.8)">{petals}</g>
    <text id="text" x="60" y="60" style="font-size:6px;font-family:sans-serif;fill:#000;stroke:none">Hello</text>
    <rect id="hidden" style="display:none" width="9" height="9"/>
  </g>
  <use id="clone" xlink:href="#text" x="5" y="-30"/>
</svg>
'''
