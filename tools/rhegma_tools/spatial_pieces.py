"""The pieces of a picture in 3D: the surface of bodies, whole or cut open, crack faces and fronts, and cells."""

import numpy as np
from matplotlib.colors import to_rgb

from . import style
from .deformation import magnified_faces
from .field_picture import in_slice
from .front_picture import border, lines_of
from .occupancy import Occupancy
from .vtk_window import Level, Piece

# Corners of the six faces of a box in half edge vectors, seen from outside, and the direction of each.
FACES = np.array([[[-1, -1, -1], [-1, -1, 1], [-1, 1, 1], [-1, 1, -1]], [[1, -1, -1], [1, 1, -1], [1, 1, 1], [1, -1, 1]],
                  [[-1, -1, -1], [1, -1, -1], [1, -1, 1], [-1, -1, 1]], [[-1, 1, -1], [-1, 1, 1], [1, 1, 1], [1, 1, -1]],
                  [[-1, -1, -1], [-1, 1, -1], [1, 1, -1], [1, -1, -1]], [[-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1]]], dtype=float)
OUTWARD = FACES.mean(axis=1)
MOST_NODES = 4.0e6  # of the lattice on which the surface of curved bodies is found
FINE = 10.0  # per cent of the particles that are smaller than the spacing of that lattice
HALF_FULL = 0.5  # fraction of material at a surface: a plane one that lies anywhere between nodes
SHORT = 3.5  # particles: edges of fewer in a row are steps of curved or oblique surfaces
MOST_SHORT, FEW_EDGES = 0.5, 24  # fraction of edges that may be short, as those of a thin plate are; number of edges that may be


def rgb(colour):
    return np.round(255 * np.array(to_rgb(colour)))


def outer_faces(fields, kept, seamless=False):
    """(indices of particles, numbers of faces) of the faces of the particles kept that are at their surface, in the undeformed body.
    seamless: also those next to gaps between boxes"""
    lattice = Occupancy(fields.position[kept] - fields.displacement[kept], np.abs(fields.edges[kept]).sum(axis=1), fields.body[kept], seamless)
    owners, faces = [], []
    for number, outward in enumerate(OUTWARD):
        free = kept[lattice.free(outward)]
        owners.append(free)
        faces.append(np.full(len(free), number))
    return np.concatenate(owners), np.concatenate(faces)


def box_faces(fields, owners, faces, magnification):
    """Corners (k, 4, 3) of faces of particles' boxes as drawn."""
    position = fields.position[owners] + (magnification - 1.0) * fields.displacement[owners]
    return position[:, None, :] + 0.5 * np.einsum("kce,kei->kci", FACES[faces], fields.boxes(owners, magnification))


def body_piece(fields, kept, magnification, colours, **look):
    """The surface of the particles kept. colours: (n, 3) of all particles, or one"""
    owners, faces = outer_faces(fields, kept, seamless=look.get("opacity", 1.0) == 1.0)
    corners = box_faces(fields, owners, faces, magnification)
    chosen = colours[owners] if np.ndim(colours) == 2 else colours
    return Piece(corners.reshape(-1, 3), np.arange(4 * len(corners)).reshape(-1, 4), chosen, **look)


def edge_segments(fields):
    """(particles (k), ends (k, 2, 3) in half edge vectors) of the edges of bodies, where two outer faces of a particle meet."""
    free = np.zeros((len(fields.position), 6), dtype=bool)
    free[outer_faces(fields, np.arange(len(fields.position)))] = True
    owners, ends = [], []
    for one in range(6):
        for other in range(one + 1 - one % 2 + 1, 6):  # faces of other axes
            found = np.flatnonzero(free[:, one] & free[:, other])
            along = np.cross(OUTWARD[one], OUTWARD[other])
            owners.append(found)
            ends.append(np.broadcast_to([OUTWARD[one] + OUTWARD[other] - along, OUTWARD[one] + OUTWARD[other] + along], (len(found), 2, 3)))
    return np.concatenate(owners), np.concatenate(ends)


def row_lengths(middle, extent, kind):
    """How many particles are in each row of segments that follow one another along their axis. middle (k, 3), extent (k): length along the axis; kind
    (k): number of the axis and of the side of its particle that a segment is on"""
    axis = kind % 3
    along = middle[np.arange(len(middle)), axis]
    across = np.round(np.delete(middle.ravel(), 3 * np.arange(len(middle)) + axis).reshape(-1, 2) / (0.05 * extent.min())).astype(np.int64)
    order = np.lexsort((along, across[:, 1], across[:, 0], kind))
    begin, end = (along - 0.5 * extent)[order], (along + 0.5 * extent)[order]
    row = np.c_[kind, across][order]
    first = np.r_[True, (row[1:] != row[:-1]).any(axis=1) | (begin[1:] > end[:-1] + 0.05 * extent.min())]
    number = np.cumsum(first) - 1
    length, largest = np.zeros(number[-1] + 1), np.zeros(number[-1] + 1)
    np.add.at(length, number, extent[order])
    np.maximum.at(largest, number, extent[order])
    return length / largest


def is_curved(fields, owners, ends):
    """Whether bodies have curved or oblique surfaces: most of their edges are steps of a few particles. owners, ends: as edge_segments gives them"""
    if len(owners) == 0:
        return False
    extent = np.abs(fields.edges[owners]).sum(axis=1)
    side = ends.mean(axis=1)
    axis = np.argmax(np.abs(ends[:, 1] - ends[:, 0]), axis=1)
    kind = 3 * np.round((side + 1.0) @ [9.0, 3.0, 1.0]).astype(np.int64) + axis
    middle = fields.position[owners] - fields.displacement[owners] + 0.5 * side * extent
    rows = row_lengths(middle, extent[np.arange(len(owners)), axis], kind)
    short = np.count_nonzero(rows < SHORT)
    return short > max(MOST_SHORT * len(rows), FEW_EDGES)


def edge_piece(fields, magnification, colour, **look):
    """Edges of the bodies. Of bodies with curved or oblique surfaces, whose steps have them everywhere, none."""
    owners, ends = edge_segments(fields)
    position = fields.position[owners] + (magnification - 1.0) * fields.displacement[owners]
    points = (position[:, None, :] + 0.5 * np.einsum("kce,kei->kci", ends, fields.boxes(owners, magnification))).reshape(-1, 3)
    if is_curved(fields, owners, ends):
        points = points[:0]
    return Piece(points, np.arange(len(points)).reshape(-1, 2), rgb(colour), lines=True, flat=True, **look)


def filling(fields):
    """(fractions (nx, ny, nz), origin (3), spacing) of material around the nodes of a lattice, by weights that are linear between them: their sum
    is the volume of the bodies."""
    boxes = fields.boxes()
    sizes = np.linalg.norm(boxes, axis=2).max(axis=1)
    spacing = float(np.percentile(sizes, FINE))
    low, high = fields.position.min(axis=0), fields.position.max(axis=0)
    while np.prod((high - low) / spacing + 5.0) > MOST_NODES:
        spacing *= 1.25
    origin = low - 2.0 * spacing
    shape = np.ceil((high - origin) / spacing).astype(int) + 3
    volume = np.abs(np.linalg.det(boxes)) / spacing**3
    parts = np.maximum(np.ceil(sizes / spacing - 0.1), 1.0).astype(int)  # along an edge of larger boxes: nodes in them would be empty
    values = np.zeros(shape)
    for count in np.unique(parts):
        of = parts == count
        for piece in np.ndindex(count, count, count):
            away = np.einsum("e,pei->pi", (np.array(piece) + 0.5) / count - 0.5, boxes[of])
            spread_over_nodes(values, (fields.position[of] + away - origin) / spacing, volume[of] / count**3)
    return smoothed(values), origin, spacing


def spread_over_nodes(values, at, volume):
    """Adds volumes at positions, in spacings of the lattice, to the eight nodes around each."""
    first = np.floor(at).astype(int)
    part = at - first
    for corner in np.ndindex(2, 2, 2):
        weight = np.prod(np.where(np.array(corner) == 1, part, 1.0 - part), axis=1)
        np.add.at(values, tuple((first + corner).T), weight * volume)


def smoothed(values):
    """Values on a lattice by a quarter, a half and a quarter along each axis: steps of oblique surfaces vanish, and plane ones stay."""
    for axis in range(3):
        padded = np.pad(values, [(int(axis == k),) * 2 for k in range(3)])
        low, high = (np.take(padded, np.arange(start, start + values.shape[axis]), axis) for start in (0, 2))
        values = 0.25 * low + 0.5 * values + 0.25 * high
    return values


def outline_pieces(fields):
    """What shows where the bodies are: their edges; of bodies with curved surfaces, which have none, a translucent surface."""
    edges = edge_piece(fields, 1.0, "#8A949C", width=1.5)
    if len(edges.cells):
        return [edges]
    values, origin, spacing = filling(fields)
    return [Level(values, origin, spacing, HALF_FULL, np.array([165, 180, 195]), opacity=0.16)]


def cut_open(fields, normal, where, side):
    """Particles that are left where those on one side (+1 or -1) of a plane are taken out; those that it cuts stay."""
    distance = side * (fields.position[:, normal] - where)
    return np.flatnonzero((distance <= 0.0) | in_slice(fields, normal, where))


def crack_pieces(fields, magnification, colour="#B8BCC0"):
    """Both faces of the cracks as they have opened, with their borders; without a magnification (None) the surface midway between them."""
    crack = fields.crack
    if crack is None or not crack.is_surface:
        return []
    pieces = []
    for face in [crack.points] if magnification is None else magnified_faces(crack, fields.position, fields.displacement, magnification):
        pieces.append(Piece(face, crack.cells, rgb(colour)))
        pieces.append(Piece(face, border(crack.cells), rgb(style.INK), lines=True, width=2.0, flat=True))
    return pieces


def is_closed(points):
    """Whether a line of front nodes goes all around: its ends are as near as its nodes are."""
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    return len(points) > 3 and np.linalg.norm(points[0] - points[-1]) < 1.6 * steps.max()


def front_segments(nodes, quantity):
    """(points (k, 2, 3), values (k)) along the lines of a front: from each node to the next, and back to the first where it is closed."""
    points, values = [], []
    for line in lines_of(nodes):
        if len(line) < 2:
            continue
        if is_closed(nodes["position"][line]):
            line = np.append(line, line[0])
        position, value = nodes["position"][line], nodes[quantity][line]
        middle = 0.5 * (position[:-1] + position[1:])
        points += list(np.stack([position[:-1], middle], axis=1)) + list(np.stack([middle, position[1:]], axis=1))
        values += [value[:-1], value[1:]]
    return np.array(points).reshape(-1, 2, 3), np.concatenate(values) if values else np.zeros(0)


def cell_piece(fields, view, side):
    """Edges of the cells that a slice cuts, just before the particles that it cuts. side: +1 or -1, of the reader"""
    low, high = fields.leaves.corners.min(axis=1), fields.leaves.corners.max(axis=1)
    cut = (low[:, view.normal] <= view.where) & (view.where < high[:, view.normal])
    corners = np.empty((int(cut.sum()), 4, 3))
    corners[:, :, view.normal] = view.where + side * 0.6 * fields.size
    for i, (one, two) in enumerate(((0, 0), (1, 0), (1, 1), (0, 1))):
        corners[:, i, view.axes[0]] = (low, high)[one][cut, view.axes[0]]
        corners[:, i, view.axes[1]] = (low, high)[two][cut, view.axes[1]]
    loops = np.arange(4 * len(corners)).reshape(-1, 4)
    return Piece(corners.reshape(-1, 3), np.hstack([loops, loops[:, :1]]), rgb("#5A6570"), lines=True, width=1.0, flat=True)
