"""Draws a scene before any motion on axes: bodies, cells, cracks, and the symbols of what acts on them."""

import numpy as np
from matplotlib.collections import LineCollection, PolyCollection

from . import boxes, style
from .cell_picture import SHADES, leaf_rectangles, rectangle_outlines
from .field_picture import particle_outlines
from .front_picture import border
from .scene_symbols import HEAT, LOAD, MOTION, SUPPORT, TOOL, Arrows, Mark, Nodes, Plane, Region

TINTS = ["#DCE8F2", "#F7E2D3", "#DCEFE6", "#F1E1EC", "#E8E8E8", "#FBEFD2"]  # of bodies, in turn
COLOUR = {LOAD: "#0072B2", SUPPORT: "#00795A", HEAT: "#D55E00", MOTION: "#8E4585", TOOL: "#7A4B1E"}
ARROW = 0.09  # length of an arrow, of the largest extent of the bodies
FINEST = 2.5  # points on paper: cells that are drawn smaller than this have no lines
ROUNDING = 1.0e-3  # of a spacing: coordinates that differ by less are the same
MOST_NODES = 60  # symbols of supports along each direction of a picture
MARKERS = {"x": ">", "y": "^", "z": "D"}


class Panel:
    """Axes with a view of a scene. length: factor from m to the unit drawn; extent: largest of the bodies [m]; labels: [Text]"""

    def __init__(self, axes, view, length, extent):
        self.axes, self.view, self.length, self.extent, self.labels = axes, view, length, extent, []

    def flat(self, points):
        return self.view.flat(np.asarray(points)) * self.length

    def middle(self):
        """The middle of the axes, as drawn."""
        return np.array([np.mean(self.axes.get_xlim()), np.mean(self.axes.get_ylim())])

    def label(self, text, point, colour, toward=(0.0, 1.0)):
        """A label next to a point, in a direction of the picture."""
        across, up = np.asarray(toward) / max(float(np.linalg.norm(toward)), 1.0e-300)
        sideways = abs(across) > abs(up)
        alignment = {"ha": ("left" if across > 0 else "right") if sideways else "center", "va": "center" if sideways else ("bottom" if up >= 0 else "top")}
        text = self.axes.annotate(text, self.flat(point), (4.0 * across, 4.0 * up), "data", "offset points", color=colour, fontsize=8.5, parse_math=False,
                                  bbox={"facecolor": "white", "alpha": 0.8, "edgecolor": "none", "pad": 0.6}, zorder=9, **alignment)
        text.set_in_layout(False)  # a label that protrudes does not make the axes smaller
        self.labels.append(text)


def body_outlines(fields, view):
    """Outlines [(k, 2)] [m] of the particles as seen in a view, and the particles' indices: in 3D of one in each position of the picture."""
    if view.normal is None:
        return particle_outlines(fields, view, 1.0)
    centre = view.flat(fields.position)
    half = np.stack([boxes.reach(fields.boxes(), axis) for axis in view.axes], axis=1)
    order = np.argsort(-half.sum(axis=1), kind="stable")  # of those in one position, the whole ones first
    squares = np.round(np.c_[centre, fields.body] / np.r_[[0.25 * fields.size] * 2, 1.0]).astype(np.int64)
    drawn = order[np.unique(squares[order], axis=0, return_index=True)[1]]
    return list(rectangle_outlines(centre[drawn] - half[drawn], centre[drawn] + half[drawn])), drawn


def draw_bodies(panel, fields):
    outlines, drawn = body_outlines(fields, panel.view)
    colours = np.array(TINTS, dtype=object)[fields.body[drawn] % len(TINTS)]
    filled = PolyCollection([outline * panel.length for outline in outlines], facecolors=list(colours), edgecolors="face", linewidths=0.2, zorder=1)
    filled.set_rasterized(True)
    panel.axes.add_collection(filled)
    return filled


def draw_outlines(panel, outlines):
    """The shapes of the scene: thin lines, thicker ones of rigid tools, dashed where a shape is cut away."""
    for outline in outlines:
        colour, width = (COLOUR[TOOL], 1.6) if outline.tool else ("#666666", 0.8)
        lines = LineCollection([panel.flat(line) for line in outline.lines], colors=colour, linewidths=width,
                               linestyles="--" if outline.cut else "-", zorder=3)
        panel.axes.add_collection(lines)


def points_per_metre(axes, length):
    """How many points on paper a metre of the body is. length: factor from m to the unit drawn"""
    low, high = axes.transData.transform([(0.0, 0.0), (length, 0.0)])
    return float(high[0] - low[0]) * 72.0 / axes.figure.dpi


def draw_cells(panel, leaves, shade=True):
    """Cells as light lines where they are wide enough on paper, and shaded by level where some are refined. \\return how many have lines"""
    low, high, level = leaf_rectangles(leaves, panel.view)
    rectangles = rectangle_outlines(low, high) * panel.length
    refined = level > 0
    if shade and refined.any():
        shades = np.array(SHADES, dtype=object)[np.minimum(level[refined], len(SHADES) - 1)]
        panel.axes.add_collection(PolyCollection(rectangles[refined], facecolors=list(shades), edgecolors="none", alpha=0.55, zorder=2))
    wide = (high - low)[:, 0] * points_per_metre(panel.axes, panel.length) >= FINEST
    loops = [np.vstack([rectangle, rectangle[:1]]) for rectangle in rectangles[wide]]
    panel.axes.add_collection(LineCollection(loops, colors="#9AA5AE", linewidths=0.3, zorder=2.5))
    return len(loops)


def draw_cracks(panel, crack, width=2.2):
    """Cracks: lines in 2D; in 3D surfaces that one sees through, with their borders."""
    if crack is None:
        return
    if not crack.is_surface:
        panel.axes.add_collection(LineCollection(panel.flat(crack.points[crack.cells]), colors=style.INK, linewidths=width, zorder=5, capstyle="round"))
        return
    panel.axes.add_collection(PolyCollection(panel.flat(crack.points[crack.cells]), facecolors="#444444", alpha=0.35, edgecolors="none", zorder=4))
    panel.axes.add_collection(LineCollection(panel.flat(crack.points[border(crack.cells)]), colors=style.INK, linewidths=0.7 * width, zorder=5))


def front_positions(summary, dimension):
    """Positions (k, 3) of all points of crack fronts that the program has found. In 3D a scene without the section Energy Release has none."""
    found = []
    for crack in summary.get("cracks") or []:
        for front in crack.get("fronts") or []:
            nodes = (front.get("front_nodes") or {}).get("position") or []
            for position in nodes if dimension == 3 else [front.get("position") or []]:
                if len(position) >= dimension:
                    found.append((list(position) + [0.0])[:3])
    return np.array(found).reshape(-1, 3)


def draw_fronts(panel, positions):
    if len(positions):
        panel.axes.plot(*panel.flat(positions).T, ls="none", marker="o", ms=4.5, mfc="white", mec=style.INK, mew=1.2, zorder=6, label="crack front")


def in_a_row(symbol):
    """Whether arrows are one behind the other, so that a label at the head of one would be on another."""
    away = symbol.points - symbol.points.mean(axis=0)
    return bool(np.linalg.norm(away @ symbol.direction) > 0.5 * np.linalg.norm(away) > 0.0)


def draw_arrows(panel, symbol):
    """Arrows, or where they point at the reader or away from him, rings with a dot or a cross."""
    direction = panel.view.flat(symbol.direction)
    colour, points = COLOUR[symbol.kind], panel.flat(symbol.points)
    seen = float(np.linalg.norm(direction))
    if seen < 0.05:
        toward = viewer_side(panel.view) @ symbol.direction > 0.0
        panel.axes.plot(*points.T, ls="none", marker="o", ms=6, mfc="white", mec=colour, zorder=7)
        panel.axes.plot(*points.T, ls="none", marker="." if toward else "x", ms=4, color=colour, zorder=7)
        return  # other views have its label
    step = direction * ARROW * panel.extent * panel.length
    panel.axes.quiver(*points.T, *np.broadcast_to(step, points.shape).T, angles="xy", scale_units="xy", scale=1.0, units="inches", width=0.018,
                      headwidth=5, headlength=6, headaxislength=5.2, pivot="tip" if symbol.into else "tail", color=colour, zorder=7)
    if not symbol.label:
        return
    middle = symbol.points.mean(axis=0)
    if in_a_row(symbol):
        panel.label(f"{symbol.name}: {symbol.label}", middle, colour, panel.flat(middle) - panel.middle())
        return
    end = middle + symbol.direction * ARROW * panel.extent * (-1.0 if symbol.into else 1.0)
    panel.label(f"{symbol.name}: {symbol.label}", end, colour, -direction if symbol.into else direction)


def viewer_side(view):
    """The direction (3) from the picture to its reader."""
    return np.zeros(3) if view.normal is None else np.cross(*np.eye(3)[view.axes])


def thinned(points, spacing):
    """Points (k, 2) of a grid, at most one in each square of about this edge. The edge is a multiple of the smallest distance of grid lines, and
    squares begin at them, so that no line of a grid is left out while its neighbours are drawn."""
    if not len(points):
        return points
    gaps = np.concatenate([np.diff(np.unique(points[:, axis])) for axis in range(2)])
    gaps = gaps[gaps > ROUNDING * spacing]
    step = gaps.min() if len(gaps) else spacing
    edge = step * max(round(spacing / step), 1)
    _, kept = np.unique(np.floor((points - points.min(axis=0) + 0.25 * step) / edge).astype(np.int64), axis=0, return_index=True)
    return points[kept]


def draw_nodes(panel, symbol):
    """Symbols of supported nodes: a triangle that points along the axis that is held, a square where more than one is."""
    colour = COLOUR[symbol.kind]
    points = thinned(panel.flat(symbol.points), panel.extent * panel.length / MOST_NODES)
    marker = "s" if len(symbol.axes) != 1 else MARKERS[symbol.axes]
    if marker != "s" and panel.view.normal is not None:
        seen = panel.view.axes
        held = "xyz".index(symbol.axes)
        marker = (">", "^")[seen.index(held)] if held in seen else "o"
    if symbol.axes == "":
        marker = "o"
    panel.axes.plot(*points.T, ls="none", marker=marker, ms=3.6 if len(points) > 5 else 7.0, mfc=colour if symbol.held else "white", mec=colour, mew=0.8, zorder=6,
                    label=f"{symbol.name}: {symbol.label or 'moved'}")
    if symbol.label and len(symbol.points):
        middle = symbol.points.mean(axis=0)
        outermost = symbol.points[np.argmin(np.linalg.norm(symbol.points - middle, axis=1))]
        panel.label(f"{symbol.name}: {symbol.label}", outermost, colour)


def draw_plane(panel, symbol):
    """A plane of symmetry: a dash-dotted line where it is seen edge-on."""
    if symbol.axis not in panel.view.axes:
        return
    where, colour = symbol.position * panel.length, COLOUR[SUPPORT]
    text, look = f"{symbol.name}: {symbol.label}", {"color": colour, "fontsize": 8.5, "zorder": 9, "parse_math": False}
    if panel.view.axes.index(symbol.axis) == 0:
        panel.axes.axvline(where, color=colour, lw=1.3, ls="-.", zorder=6)
        panel.axes.annotate(text, (where, 0.5), (-3.0, 0.0), panel.axes.get_xaxis_transform(), "offset points", rotation=90, ha="right", va="center", **look)
    else:
        panel.axes.axhline(where, color=colour, lw=1.3, ls="-.", zorder=6)
        panel.axes.annotate(text, (0.5, where), (0.0, -3.0), panel.axes.get_yaxis_transform(), "offset points", ha="center", va="top", **look)


def draw_region(panel, symbol):
    colour = COLOUR[HEAT]
    if symbol.low is None:
        angle = np.linspace(0.0, 2.0 * np.pi, 73)
        corners = panel.flat(symbol.centre) + symbol.radius * panel.length * np.c_[np.cos(angle), np.sin(angle)]
    else:
        corners = rectangle_outlines(panel.flat(symbol.low)[None], panel.flat(symbol.high)[None])[0]
    panel.axes.add_collection(PolyCollection([corners], facecolors=colour, edgecolors=colour, alpha=0.4, zorder=6))
    panel.label(f"{symbol.name}: {symbol.label}", symbol.centre, colour, (0.0, -1.0))


def draw_mark(panel, symbol):
    colour = COLOUR[symbol.kind]
    panel.axes.plot(*panel.flat(symbol.point)[:, None], ls="none", marker="x", ms=6, mew=1.4, color=colour, zorder=7)
    panel.label(f"{symbol.name}: {symbol.label}", symbol.point, colour, (1.0, 0.0))


DRAWN = {Arrows: draw_arrows, Nodes: draw_nodes, Plane: draw_plane, Region: draw_region, Mark: draw_mark}


def draw_symbols(panel, symbols):
    for symbol in symbols:
        DRAWN[type(symbol)](panel, symbol)


def part_labels(panels, figure):
    """Moves labels that would cover the vertical axis with its numbers to the right, those that would reach into the next axes or beyond the figure to
    the left, and those that would cover one another, up or down."""
    figure.canvas.draw()
    figure.set_layout_engine("none")
    renderer = figure.canvas.get_renderer()
    for panel in panels:
        done = []
        own = panel.axes.get_window_extent(renderer)
        left = own.x0
        beside = [box.x0 for box in (axes.get_tightbbox(renderer) for axes in figure.axes if axes is not panel.axes) if box is not None
                  and box.x0 > 0.5 * (own.x0 + own.x1) and box.y0 < own.y1 and box.y1 > own.y0]
        right = min([figure.bbox.x1, *beside])
        for text in panel.labels:
            x, y = text.get_position()
            extent = text.get_window_extent(renderer)
            x -= max(extent.x1 - (right - 2.0), 0.0) * 72.0 / figure.dpi
            x += max(left + 2.0 - (extent.x0 - max(extent.x1 - (right - 2.0), 0.0)), 0.0) * 72.0 / figure.dpi
            text.set_position((x, y))
            box = text.get_window_extent(renderer)
            points = box.height * 72.0 / figure.dpi
            for attempt in range(1, 16):
                if not any(box.overlaps(other) for other in done):
                    break
                text.set_position((x, y + (1 if attempt % 2 else -1) * ((attempt + 1) // 2) * 1.05 * points))
                box = text.get_window_extent(renderer)
            text.set_in_layout(True)
            done.append(box)
