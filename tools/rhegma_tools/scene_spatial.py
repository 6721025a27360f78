"""The picture of a scene in 3D in perspective: outline of the bodies, cracks, and the arrows of what acts on them."""

import numpy as np

from .field_picture import choose_view
from .scene_panel import ARROW, COLOUR
from .scene_symbols import TOOL, Arrows, Nodes, Region
from .spatial_pieces import crack_pieces, outline_pieces, rgb
from .spatial_picture import camera_of, triad
from .vtk_window import Piece

NODE = 0.3  # edge of the cube at a supported node, of the largest cells
SIDES = 12  # of a cone
HEAD, WIDE, SHAFT = 0.35, 0.12, 0.035  # length and radius of an arrow's head, radius of its shaft, of the length of the arrow


def arrow_pieces(symbol, length):
    """Shafts and heads of arrows of a length [m]."""
    step = symbol.direction * length
    tails = symbol.points - step if symbol.into else symbol.points
    necks = tails + (1.0 - HEAD) * step
    shafts = np.stack([tails, necks], axis=1).reshape(-1, 3)
    one = np.cross(symbol.direction, np.eye(3)[np.argmin(np.abs(symbol.direction))])
    one /= np.linalg.norm(one)
    angle = np.linspace(0.0, 2.0 * np.pi, SIDES, endpoint=False)[:, None]
    ring = WIDE * length * (np.cos(angle) * one + np.sin(angle) * np.cross(symbol.direction, one))
    points, cells = [], []
    for neck, head in zip(necks, tails + step):
        first = len(points) * (SIDES + 2)
        points.append(np.vstack([head, neck, neck + ring]))
        around = first + 2 + np.arange(SIDES)
        following = np.roll(around, -1)
        cells += [np.c_[np.full(SIDES, tip), around, following] for tip in (first, first + 1)]
    colour = rgb(COLOUR[symbol.kind])
    return [Piece(shafts, np.arange(len(shafts)).reshape(-1, 2), colour, lines=True, tube=SHAFT * length),
            Piece(np.concatenate(points), np.concatenate(cells), colour)]


def cube_piece(points, size, colour, **look):
    """A cube around each point, such as a supported node."""
    unit = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], dtype=float)
    faces = np.array([[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]])
    corners = points[:, None, :] + 0.5 * size * unit
    return Piece(corners.reshape(-1, 3), (8 * np.arange(len(points))[:, None, None] + faces).reshape(-1, 4), rgb(colour), **look)


def tool_pieces(tools):
    """Outlines of rigid tools. tools: {name: arrays of lines (k, 3)}"""
    return [Piece(line, np.stack([np.arange(len(line) - 1), np.arange(1, len(line))], axis=1), rgb(COLOUR[TOOL]), lines=True, width=2.0, flat=True)
            for lines in tools.values() for line in lines]


def node_spacing(fields):
    """The edge [m] of the largest cells."""
    return fields.size if fields.leaves is None else float(np.ptp(fields.leaves.corners[:, :, 0], axis=1).max())


def scene_pieces(drawing):
    """All pieces of a scene in 3D."""
    fields = drawing.fields
    pieces = outline_pieces(fields) + crack_pieces(fields, None) + tool_pieces(drawing.tools)
    for symbol in drawing.symbols:
        if isinstance(symbol, Arrows):
            pieces += arrow_pieces(symbol, 1.4 * ARROW * drawing.extent)
        elif isinstance(symbol, Nodes) and len(symbol.points):
            pieces.append(cube_piece(symbol.points, NODE * node_spacing(fields), COLOUR[symbol.kind]))
        elif isinstance(symbol, Region) and symbol.radius is None:
            pieces.append(box_piece(symbol.low, symbol.high, COLOUR[symbol.kind]))
        elif isinstance(symbol, Region):
            pieces.append(ball_piece(symbol.centre, symbol.radius, COLOUR[symbol.kind]))
    return pieces


def box_piece(low, high, colour):
    corners = np.array([[(low, high)[i][0], (low, high)[j][1], (low, high)[k][2]] for i in (0, 1) for j in (0, 1) for k in (0, 1)])
    faces = np.array([[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]])
    return Piece(corners, faces, rgb(colour), opacity=0.4)


def ball_piece(centre, radius, colour, count=16):
    """A ball as squares between circles of latitude and longitude."""
    polar, around = np.meshgrid(np.linspace(0.0, np.pi, count + 1), np.linspace(0.0, 2.0 * np.pi, 2 * count, endpoint=False), indexing="ij")
    points = centre + radius * np.stack([np.sin(polar) * np.cos(around), np.sin(polar) * np.sin(around), np.cos(polar)], axis=-1)
    number = np.arange(points.shape[0] * points.shape[1]).reshape(points.shape[:2])
    right = np.roll(number, -1, axis=1)
    cells = np.stack([number[:-1], right[:-1], right[1:], number[1:]], axis=-1).reshape(-1, 4)
    return Piece(points.reshape(-1, 3), cells, rgb(colour), opacity=0.4)


class Perspective:
    """The picture of a scene in 3D in perspective, which a window draws while its user does other things. drawn: whether VTK has drawn it"""

    def __init__(self, drawing, window):
        self.window, self.drawn = window, False
        self.camera, _ = camera_of(drawing.fields, choose_view(drawing.fields), 1.0, onto=drawing.fields.crack is not None)
        self.camera.half_height *= 1.0 + 1.2 * ARROW * any(isinstance(symbol, Arrows) for symbol in drawing.symbols)
        window.send(scene_pieces(drawing), self.camera)

    def draw(self, axes):
        """Draws it with the directions of the axes; nothing where VTK draws nothing."""
        image = self.window.receive()
        self.drawn = image is not None
        if self.drawn:
            axes.imshow(image)
            triad(axes, self.camera)
