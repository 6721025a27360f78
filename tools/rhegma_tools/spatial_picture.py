"""Pictures of a run in 3D: the body cut open, coloured by stress, and the crack surfaces in the body's outline with G or K at their fronts."""

import numpy as np
from matplotlib.colors import Normalize
from matplotlib.patches import Rectangle

from . import style
from .answers import is_number
from .deformation import automatic_magnification
from .colour_scales import add_bar, scale_of
from .field_picture import choose_view, stop_after
from .front_region import at_fronts
from .history_picture import initiation_toughness
from .quantity import label_of, quantity_shown, unit_of
from .report_facts import all_fronts, readable
from .spatial_pieces import body_piece, cell_piece, crack_pieces, cut_open, front_segments, outline_pieces
from .style import plt
from .vtk_window import Camera, Piece

SIZE = (1500, 1150)  # pixels
TUBE = 0.006  # radius of a front, of the largest extent of the picture
MARGIN = 1.12
LEAST_SPAN = 0.2  # of the largest value along a front: the least that its colours span
SMALL = 0.2  # of the picture: cracks that are smaller in it are drawn in a close-up, too
AROUND = 1.35  # extent of a close-up, of the cracks in it
STEEP = 0.6  # sine of the least angle at which the cracks are seen


class Front:
    """The fronts of a run at its end. label: what is drawn, with its unit; segments (k, 2, 3) [m]; values (k), NaN where there is none"""

    def __init__(self, label, segments, values):
        self.label, self.segments, self.values = label, segments, values


def node_arrays(front):
    """{quantity: array over the front nodes} of a front of the summary, with their positions; None where it has none."""
    nodes = front.get("front_nodes") or {}
    position = nodes.get("position")
    if not position or len(position) < 2 or len(position[0]) != 3:
        return None
    found = {"position": np.array(position, dtype=float)}
    for name, values in nodes.items():
        if isinstance(values, list) and len(values) == len(position) and not isinstance(values[0], list):
            found[name] = np.array([value if is_number(value) else np.nan for value in values])
    found.setdefault("arc_length", np.arange(len(position), dtype=float))
    return found


def fronts_at_end(summary, time):
    """The fronts of a run in 3D with G / Gc where there is a toughness, else K_I, else G; None where the fields are of another time."""
    end = (summary or {}).get("time")
    if not is_number(end) or abs(end - time) > 1.0e-6 * abs(end):
        return None
    fronts = [nodes for nodes in (node_arrays(front) for _, _, front in all_fronts(summary)) if nodes]
    toughness = initiation_toughness(summary)
    if toughness and all("G_J" in nodes for nodes in fronts):
        quantity, factor, label = "G_J", 1.0 / toughness, "G / Gc"
    else:
        quantity = next((name for name in ("K_I", "G_J") if fronts and all(name in nodes and np.isfinite(nodes[name]).any()
                                                                                 for nodes in fronts)), None)
        if quantity is None:
            return None
        largest = max(float(np.nanmax(np.abs(nodes[quantity]), initial=0.0)) for nodes in fronts)
        factor, unit = style.scale(largest, "Pa" if quantity == "K_I" else "J/m²")
        label = f"K_I [{unit} √m]" if quantity == "K_I" else f"G [{unit}]"
    parts = [front_segments(nodes, quantity) for nodes in fronts]
    if not parts:
        return None
    return Front(label, np.concatenate([points for points, _ in parts]), factor * np.concatenate([values for _, values in parts]))


def sides(fields, view):
    """Signs (3) of the directions from which the body is seen: so that the slice, and planes of symmetry at the cracks, face the reader."""
    low, high = fields.position.min(axis=0), fields.position.max(axis=0)
    middle = 0.5 * (low + high) if fields.crack is None else 0.5 * (fields.crack.points.min(axis=0) + fields.crack.points.max(axis=0))
    signs = np.array([1.0, -1.0, 1.0])
    near = np.abs(middle - 0.5 * (low + high)) > 0.05 * (high - low)
    signs[near] = np.where(middle - low < high - middle, -1.0, 1.0)[near]
    if not near[2]:
        signs[2] = 1.0  # from above
    signs[view.normal] = -1.0 if view.where - low[view.normal] < high[view.normal] - view.where - 1e-9 else signs[view.normal]
    return signs


def onto_cracks(toward, crack):
    """A direction of view turned towards the normal of the cracks where they would be seen nearly edge-on."""
    corner = crack.points[crack.cells]
    normals = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    normal = np.linalg.eigh(normals.T @ normals)[1][:, -1]  # of most of the area, whichever side triangles are seen from
    toward = toward / np.linalg.norm(toward)
    seen = float(toward @ normal)
    normal = -normal if seen < 0.0 else normal
    return toward if abs(seen) >= STEEP else toward + (STEEP - abs(seen)) * 1.5 * normal


def camera_of(fields, view, magnification, onto=False, bounds=None):
    """The camera, towards the slice and obliquely to the other axes, and the side (+1 or -1) of the slice that it is on. onto: towards the
    faces of the cracks, too; bounds: lowest and highest corner [m] that it shows, where these are not those of the fields"""
    signs = sides(fields, view)
    vertical = 2 if view.normal != 2 else 1
    other = 3 - view.normal - vertical
    toward = np.zeros(3)
    toward[view.normal], toward[other], toward[vertical] = 1.0, 0.62, 0.55
    toward *= signs
    toward[vertical] = abs(toward[vertical])  # from above
    if onto:
        toward = onto_cracks(toward, fields.crack)
    if bounds is None:
        drawn, margin = fields.position + (magnification - 1.0) * fields.displacement, fields.size
    else:
        drawn, margin = np.array([[bounds[i][0], bounds[j][1], bounds[k][2]] for i in (0, 1) for j in (0, 1) for k in (0, 1)]), 0.0
    return aimed_at(drawn, margin, toward, np.eye(3)[vertical]), signs[view.normal]


def aimed_at(points, margin, toward, up, around=MARGIN, size=SIZE):
    """A camera in whose middle points (k, 3) are, and that shows all of them with a margin [m] around each. around: the larger extent of the picture
    over theirs; size: pixels"""
    camera = Camera(np.zeros(3), toward, up, 1.0, size)
    across, along = points @ camera.right, points @ camera.up
    camera.focus = 0.5 * sum(side * (values.min() + values.max()) for side, values in ((camera.right, across), (camera.up, along)))
    depth = points @ camera.toward
    camera.focus = camera.focus + 0.5 * (depth.min() + depth.max()) * camera.toward
    camera.half_height = around * float(margin + 0.5 * max(np.ptp(along), np.ptp(across) * size[1] / size[0]))
    return camera


def front_piece(front, norm, camera):
    colours = np.round(255 * plt.get_cmap("plasma")(norm(np.nan_to_num(front.values)))[:, :3])
    colours[~np.isfinite(front.values)] = 119
    points = front.segments.reshape(-1, 3)
    return Piece(points, np.arange(len(points)).reshape(-1, 2), colours, lines=True, tube=TUBE * 2.0 * camera.half_height)


def front_norm(values):
    """Limits of colours: from the lowest to the highest value, but at least a fraction of the largest, or scatter would look like a pattern."""
    finite = values[np.isfinite(values)]
    if not finite.any():
        return Normalize(0.0, 1.0)
    low, high = float(finite.min()), float(finite.max())
    missing = max(LEAST_SPAN * max(abs(high), abs(low)) - (high - low), 0.0)
    return Normalize(low - 0.5 * missing, high + 0.5 * missing)


def triad(axes, camera):
    """Directions of the axes in the lower left corner."""
    length = 0.07 * camera.size[1]
    origin = np.array([1.9 * length, camera.size[1] - 1.9 * length])
    for name, direction in zip("xyz", np.eye(3)):
        step = length * np.array([direction @ camera.right, -direction @ camera.up])
        axes.annotate("", origin + step, origin, arrowprops={"arrowstyle": "-|>", "color": style.INK, "lw": 1.2, "shrinkA": 0, "shrinkB": 0})
        axes.annotate(name, origin + 1.35 * step, ha="center", va="center", fontsize=9, color=style.INK)


def scale_bar(axes, camera):
    """A length of 1, 2 or 5 times a power of ten, of about a fifth of the picture."""
    metres = 2.0 * camera.half_height / camera.size[1]
    wanted = 0.2 * camera.size[0] * metres
    power = 10.0 ** np.floor(np.log10(wanted))
    length = max(step * power for step in (1.0, 2.0, 5.0) if step * power <= wanted)
    right, bottom = 0.97 * camera.size[0], 0.96 * camera.size[1]
    axes.plot([right - length / metres, right], [bottom, bottom], color=style.INK, lw=2.0, solid_capstyle="butt")
    axes.annotate(readable(length, "m"), (right - 0.5 * length / metres, bottom), (0, 4), "data", "offset points", ha="center", fontsize=9)
    return length


def close_up_of(points, camera):
    """A camera that shows points (k, 3) large and in its middle, where they are small in the picture of another one; else None."""
    extent = np.ptp(camera.pixels(points), axis=0)
    return None if (extent / camera.size).max() >= SMALL else aimed_at(points, 0.0, camera.toward, camera.up, AROUND, camera.size)


def draw_close_up(whole, axes, camera, close):
    """A close-up, and where it is in the picture of the whole. close: (image, camera)"""
    axes.imshow(close[0])
    axes.set_xticks([])
    axes.set_yticks([])
    axes.grid(False)
    for spine in axes.spines.values():
        spine.set(visible=True, color=style.QUIET, linewidth=0.8)
    axes.set_title("close-up", fontsize=10, fontweight="normal")
    scale_bar(axes, close[1])
    half = np.array(close[1].size) * 0.5 * close[1].half_height / camera.half_height
    middle = camera.pixels(close[1].focus)[0]
    whole.add_patch(Rectangle(middle - half, *(2.0 * half), fill=False, edgecolor=style.QUIET, linewidth=0.8))


def compose(image, camera, title, lines, bars, path, close=None):
    """Writes a picture with its heading, colour bars [(colour map, norm, label, extend)], directions and scale. close: a close-up (image, camera)
    next to it, or None"""
    figure, panels = plt.subplots(1, 1 if close is None else 2, figsize=(8.2 if close is None else 13.2, 6.2 if close is None else 5.4), squeeze=False,
                                  layout="constrained")
    axes = panels[0, 0]
    axes.imshow(image)
    axes.set_axis_off()
    if close is not None:
        draw_close_up(axes, panels[0, 1], camera, close)
    axes.set_title(title + "\n" * len(lines), fontsize=12, parse_math=False)
    axes.annotate("\n".join(lines), (0.0, 1.0), (0.0, 5.0), "axes fraction", "offset points", fontsize=9.5, linespacing=1.3)
    triad(axes, camera)
    scale_bar(axes, camera)
    for colours, norm, label, extend in bars:
        bar = add_bar(figure, plt.cm.ScalarMappable(norm, colours), list(panels[0]), label, extend, shrink=0.7, aspect=26, pad=0.02)
        bar.outline.set_linewidth(0.6)
    style.save(figure, path)


def heading(fields, summary, magnification, more):
    factor, unit = style.scale(fields.time, "s")
    size = "true displacement" if magnification == 1.0 else f"displacement × {magnification:,.7g}"
    return [",   ".join([f"t = {fields.time * factor:.4g} {unit}", *stop_after(fields, summary), size, *more])]


def body_colours_at(values, colours, norm):
    """Colours (n, 3), from 0 to 255, of values."""
    return np.round(255 * plt.get_cmap(colours)(norm(values))[:, :3])


def cut_text(view, side):
    """Where the body is cut open, in words."""
    factor, unit = style.scale(abs(view.where), "m")
    return f"cut open: {'xyz'[view.normal]} {'<' if side > 0 else '>'} {view.where * factor:.3g} {unit} is shown"


class CutBody:
    """The picture of the body cut open, coloured by a quantity; cells: also those in the cut. It is sent to a window, and written later."""

    def __init__(self, fields, summary, title, stress="principal", magnification=None, asked=None, cells=False):
        view, quantity = choose_view(fields, asked), quantity_shown(fields, stress)
        if magnification is None:  # cells do not follow displacements that are drawn larger
            magnification = 1.0 if cells else automatic_magnification(fields.position, fields.displacement, fields.deformation)
        self.title, self.magnification = title, magnification
        self.camera, side = camera_of(fields, view, magnification)
        kept = cut_open(fields, view.normal, view.where, side)
        if len(kept) == 0:
            kept = np.arange(len(fields.position))
        values = fields.values(quantity)
        factor, unit = unit_of(quantity, values)
        colour_map, norm = scale_of(quantity, values * factor, fields.counts, at_fronts(fields))
        self.pieces = [body_piece(fields, kept, magnification, body_colours_at(values * factor, colour_map, norm))] + crack_pieces(fields, magnification)
        if cells and fields.leaves is not None:
            self.pieces.append(cell_piece(fields, view, side))
        self.lines = heading(fields, summary, magnification, [cut_text(view, side)])
        self.bars = [(colour_map, norm, label_of(quantity) + (f" [{unit}]" if unit else ""), "both" if quantity != "temperature" else "neither")]

    def send(self, window):
        window.send(self.pieces, self.camera)

    def write(self, window, path):
        """\return the magnification, or None where VTK draws nothing"""
        image = window.receive()
        if image is None:
            return None
        compose(image, self.camera, self.title, self.lines, self.bars, path)
        return self.magnification


class CracksInBody:
    """The picture of the cracks in the outline of the body, at true positions, with a close-up of small ones."""

    def __init__(self, fields, summary, title):
        self.title, self.lines = title, heading(fields, summary, 1.0, [])
        self.camera, _ = camera_of(fields, choose_view(fields), 1.0, onto=True)
        self.close = close_up_of(fields.crack.points, self.camera)
        self.pieces = outline_pieces(fields) + crack_pieces(fields, None)
        self.front, self.bars, self.norm = fronts_at_end(summary, fields.time), [], None
        if self.front is not None:
            self.norm = front_norm(self.front.values)
            self.bars.append(("plasma", self.norm, f"{self.front.label} along the front", "neither"))

    def send(self, window):
        for camera in [self.camera] + ([] if self.close is None else [self.close]):
            window.send(self.pieces + ([] if self.front is None else [front_piece(self.front, self.norm, camera)]), camera)

    def write(self, window, path):
        """\return what the fronts are coloured by, "" for nothing, or None where VTK draws nothing"""
        image = window.receive()
        close = None if self.close is None else (window.receive(), self.close)
        if image is None:
            return None
        compose(image, self.camera, f"{self.title}: cracks", self.lines, self.bars, path, close if close and close[0] is not None else None)
        return "" if self.front is None else self.front.label


class SpatialPictures:
    """The pictures of a run in 3D, being drawn: the body cut open (body), and its cracks (cracks), or None. window: a Window, in use; more: as for
    CutBody"""

    def __init__(self, window, fields, summary, title, **more):
        self.window = window
        self.body = CutBody(fields, summary, title, **more)
        self.body.send(window)
        self.cracks = None if fields.crack is None else CracksInBody(fields, summary, title)
        if self.cracks is not None:
            self.cracks.send(window)
