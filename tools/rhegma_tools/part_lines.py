"""Lines of a part from a file (STL, OBJ, or a text of polygons), for pictures: lines (k, 3) in the unit of the file."""

import re

import numpy as np

SHARP = np.cos(np.radians(20.0))  # edges that bend by more are drawn
MOST = 4000  # lines; of a larger number every n-th is drawn


def stl_triangles(path):
    """Triangles (n, 3, 3) of an STL file."""
    with open(path, "rb") as file:
        content = file.read()
    count = int.from_bytes(content[80:84], "little")
    if len(content) >= 84 + 50 * count and b"\0" in content[:84]:
        record = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("mark", "<u2")])
        return np.frombuffer(content, record, count, 84)["corners"].astype(float)
    vertices = re.findall(rb"vertex\s+(\S+)\s+(\S+)\s+(\S+)", content, re.IGNORECASE)
    return np.array(vertices, dtype=float).reshape(-1, 3, 3)


def obj_triangles(path):
    """Triangles (n, 3, 3) of an OBJ file; larger faces are cut as fans."""
    points, triangles = [], []
    with open(path, encoding="utf-8", errors="replace") as file:
        for line in file:
            words = line.split()
            if words[:1] == ["v"]:
                points.append([float(word) for word in words[1:4]])
            elif words[:1] == ["f"]:
                corners = [int(word.split("/")[0]) for word in words[1:]]
                corners = [k - 1 if k > 0 else len(points) + k for k in corners]
                triangles += [[corners[0], corners[k - 1], corners[k]] for k in range(2, len(corners))]
    return np.array(points)[np.array(triangles, dtype=int)]


def edge_lines(triangles):
    """Edges of triangles at which the surface bends; all of them where it bends nowhere. Not more than MOST."""
    _, number = np.unique(triangles.reshape(-1, 3), axis=0, return_inverse=True)
    number = number.reshape(-1, 3)
    normal = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    normal /= np.maximum(np.linalg.norm(normal, axis=1), 1e-300)[:, None]
    sides = np.sort(np.concatenate([number[:, [0, 1]], number[:, [1, 2]], number[:, [2, 0]]]), axis=1)
    ends = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    of = np.tile(np.arange(len(triangles)), 3)
    order = np.lexsort(sides.T)
    same = np.all(sides[order[1:]] == sides[order[:-1]], axis=1)
    first, second = order[:-1][same], order[1:][same]
    bends = np.einsum("ij,ij->i", normal[of[first]], normal[of[second]]) < SHARP
    lines = ends[first[bends]] if bends.any() else ends[first]
    return list(lines[::len(lines) // MOST + 1])


def polygon_loops(path):
    """Closed polygons of a text: two numbers a line, an empty line between polygons."""
    loops, points = [], []
    with open(path, encoding="utf-8-sig") as file:
        for line in [*file, ""]:
            values = line.split("#")[0].replace(",", " ").split()
            if values:
                points.append([float(values[0]), float(values[1]), 0.0])
            elif points and "#" not in line:
                loops.append(np.array([*points, points[0]]))
                points = []
    return loops


def part_lines(path, dimension):
    """Lines of the part; none where the file cannot be read, of which the program says why."""
    try:
        if dimension == 2:
            return polygon_loops(path)
        triangles = obj_triangles(path) if path.lower().endswith(".obj") else stl_triangles(path)
        return edge_lines(triangles) if len(triangles) else []
    except (OSError, ValueError, IndexError):
        return []
