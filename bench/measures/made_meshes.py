"""Our meshes with finer faces."""

from pathlib import Path


def read(file):
    """(positions, triangles) of an OBJ file of triangles, positions as text."""
    positions, triangles = [], []
    for line in Path(file).read_text().splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            positions.append(tuple(float(word) for word in words[1:4]))
        elif words[:1] == ["f"]:
            triangles.append(tuple(int(word.split("/")[0]) - 1 for word in words[1:]))
    return positions, triangles


def cut(positions, triangles):
    """Each triangle in four at the middles of its edges."""
    positions, middles, cut_triangles = list(positions), {}, []

    def middle(a, b):
        edge = (min(a, b), max(a, b))
        if edge not in middles:
            middles[edge] = len(positions)
            positions.append(tuple((x + y) / 2 for x, y in zip(positions[a], positions[b])))
        return middles[edge]

    for a, b, c in triangles:
        ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
        cut_triangles += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    return positions, cut_triangles


def cut_in_four(file, times, folder):
    """The file itself, or one in the folder whose faces are cut so often."""
    if times == 0:
        return file
    made = Path(folder) / f"{Path(file).stem}_cut_{times}.obj"
    if not made.exists():
        positions, triangles = read(file)
        for _ in range(times):
            positions, triangles = cut(positions, triangles)
        lines = ["v " + " ".join(f"{x:.9g}" for x in p) for p in positions]
        lines += ["f " + " ".join(str(corner + 1) for corner in t) for t in triangles]
        made.write_text("\n".join(lines) + "\n")
    return made
