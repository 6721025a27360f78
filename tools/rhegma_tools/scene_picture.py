"""The picture of a scene before any run: in 2D one view and a close-up of a crack front, in 3D three views and one in perspective."""

import os

import numpy as np
from matplotlib.patches import Circle

from . import style
from .field_picture import View, limits, moved_inside
from .report_facts import readable
from .scene_outlines import outlines_of
from .scene_panel import ARROW, COLOUR, Panel, draw_bodies, draw_cells, draw_cracks, draw_fronts, draw_outlines, draw_symbols, front_positions, in_a_row
from .scene_panel import part_labels
from .scene_spatial import Perspective
from .scene_symbols import MOTION, Arrows, Mark, Nodes, Plane, Region, crack_loads, symbols_of
from .scene_values import array, lists
from .style import plt
from .vtk_window import Window

LONGEST_LINE = 150  # letters of the list below the picture
MOST_LINES = 24
ROUNDING = 1.0e-6  # of the largest extent of the bodies
LABEL = 0.3  # length of a label, of the largest extent of the bodies in a view


class Drawing:
    """All that a picture of a scene shows. scene: a Scene; state: its State; symbols, outlines: of the scene; fronts (k, 3) [m]"""

    def __init__(self, scene, state):
        self.scene, self.state, self.fields = scene, state, state.fields
        self.outlines = outlines_of(scene.values, state.fields.dimension)
        self.tools = {}
        for outline in self.outlines:
            if outline.tool:
                self.tools.setdefault(outline.tool, []).extend(outline.lines)
        self.symbols = symbols_of(scene.values, state.fields, state.summary.get("surfaces") or (), self.tools)
        self.fronts = front_positions(state.summary, state.fields.dimension)
        half = 0.5 * self.fields.size
        self.low, self.high = self.fields.position.min(axis=0) - half, self.fields.position.max(axis=0) + half
        if self.fields.dimension == 2:
            self.low[2] = self.high[2] = 0.0
        self.extent = float(np.max(self.high - self.low))
        self.seen_low, self.seen_high = self.low.copy(), self.high.copy()  # with tools, as far as they are in the domain or near the bodies
        for lines in self.tools.values():
            points = np.vstack(lines)
            self.seen_low = np.minimum(self.seen_low, np.maximum(points.min(axis=0), self.low - self.extent))
            self.seen_high = np.maximum(self.seen_high, np.minimum(points.max(axis=0), self.high + self.extent))
        self.length, self.unit = style.scale(self.extent, "m")
        self.title = os.path.splitext(os.path.basename(scene.path))[0]

    @property
    def focus(self):
        """The position [m], in the bodies, that slices of cells go through: the first crack front, else the middle of the cracks or of the bodies."""
        points = self.fronts[:1] if len(self.fronts) else None if self.fields.crack is None else self.fields.crack.points
        middle = 0.5 * (self.low + self.high) if points is None else 0.5 * (points.min(axis=0) + points.max(axis=0))
        return np.clip(middle, self.low + ROUNDING * self.extent, self.high - ROUNDING * self.extent)


def cells_text(drawing):
    """Cells and particles, in words."""
    cells, leaves = drawing.state.summary.get("cells") or {}, drawing.fields.leaves
    largest, smallest = cells.get("largest"), cells.get("smallest")
    count = 0 if leaves is None else len(leaves.level)
    text = f"{count} cells of {readable(largest, 'm')}"
    if smallest and largest and smallest < 0.999 * largest:
        text = f"{count} cells from {readable(largest, 'm')} to {readable(smallest, 'm')} (refined up to level {int(leaves.level.max())})"
    return f"{text}, {len(drawing.fields.position)} particles"


def list_lines(drawing):
    """Lines (text, colour) below the picture: cells, bodies, and all that acts, with total forces and histories."""
    values = drawing.scene.values
    lines = [(cells_text(drawing), style.INK)]
    for name, body in lists(values, "Bodies"):
        lines.append((f"{name}: {body.get('Material')}", style.INK))
    histories = {name: one.get("History") for name, one in lists(values, "Boundaries") + lists(values, "Thermal", "Sources")}
    seen = set()
    for symbol in drawing.symbols:
        if not symbol.label or (symbol.name, symbol.label) in seen:
            continue
        seen.add((symbol.name, symbol.label))
        parts = [f"{symbol.name}: {symbol.label}"]
        if isinstance(symbol, Arrows) and symbol.name in drawing.state.forces:
            parts.append(drawing.state.forces[symbol.name])
        if "f(t)" in symbol.label and histories.get(symbol.name):
            parts.append(f"f(t) = {' '.join(histories[symbol.name].split())}")
        lines.append((", ".join(parts), COLOUR[symbol.kind]))
    loads = crack_loads(values)
    for name, _ in lists(values, "Cracks"):
        lines.append((f"{name}: crack" + (f", {loads[name]}" if name in loads else ""), style.INK))
    lines = [(text if len(text) <= LONGEST_LINE else text[:LONGEST_LINE - 3] + "...", colour) for text, colour in lines]
    return lines if len(lines) <= MOST_LINES else lines[:MOST_LINES - 1] + [(f"and {len(lines) - MOST_LINES + 1} more", style.QUIET)]


def frame(panel, drawing):
    """Limits of the axes around the bodies with their arrows, and with the labels of those that point to a side."""
    low, high = drawing.seen_low.copy(), drawing.seen_high.copy()
    label = LABEL * float(np.max(np.ptp([panel.view.flat(low), panel.view.flat(high)], axis=0)))
    for symbol in drawing.symbols:
        if isinstance(symbol, Arrows):
            reach = symbol.direction * ARROW * drawing.extent * (-1.0 if symbol.into else 1.0)
            across, up = panel.view.flat(symbol.direction)
            if symbol.label and abs(across) > abs(up) and not in_a_row(symbol):
                reach = reach + label * np.sign(reach) * (np.arange(3) == panel.view.axes[0])
            low = np.minimum(low, np.min(symbol.points + np.minimum(reach, 0.0), axis=0))
            high = np.maximum(high, np.max(symbol.points + np.maximum(reach, 0.0), axis=0))
    limits(panel.axes, panel.flat(low), panel.flat(high), 0.06)


def draw_domain(panel, values):
    """The domain as a dotted rectangle."""
    corners = [array(values.get("Domain", {}), f"{side} Corner") for side in ("Lower", "Upper")]
    if None in corners:
        return
    low, high = (panel.flat((corner + [0.0])[:3]) for corner in corners)
    loop = np.array([low, [high[0], low[1]], high, [low[0], high[1]], low])
    panel.axes.plot(*loop.T, color=style.QUIET, lw=0.8, ls=":", scalex=False, scaley=False, zorder=0)


def axis_names(drawing):
    """Names of the axes: in an axisymmetric scene the first is the radius r."""
    return "ryz" if drawing.scene.values.get("Domain", {}).get("Plane") == "Axisymmetric" else "xyz"


def draw_view(axes, view, drawing):
    """A whole view of the scene. \\return its Panel"""
    panel = Panel(axes, view, drawing.length, drawing.extent)
    axes.set_aspect("equal")
    axes.grid(False)
    frame(panel, drawing)
    draw_bodies(panel, drawing.fields)
    if drawing.fields.leaves is not None:
        draw_cells(panel, drawing.fields.leaves)
    draw_outlines(panel, drawing.outlines)
    draw_domain(panel, drawing.scene.values)
    draw_cracks(panel, drawing.fields.crack)
    draw_fronts(panel, drawing.fronts)
    draw_symbols(panel, drawing.symbols)
    axes.set_xlabel(f"{axis_names(drawing)[view.axes[0]]} [{drawing.unit}]")
    axes.set_ylabel(f"{axis_names(drawing)[view.axes[1]]} [{drawing.unit}]")
    return panel


def first_front(drawing):
    """The entry of the first crack front of the summary."""
    return next((front for crack in drawing.state.summary.get("cracks") or [] for front in crack.get("fronts") or []), {})


def draw_close_up(axes, drawing):
    """Cells, particles and the domain of the J integral at the first crack front of a scene in 2D."""
    front = first_front(drawing)
    finest = float((drawing.state.summary.get("cells") or {}).get("smallest") or drawing.fields.size)
    outer = front.get("outer_radius") or 0.0
    half = max(1.3 * outer, 6.0 * finest)
    factor, unit = style.scale(half, "m")
    panel = Panel(axes, View([0, 1]), factor, 2.0 * half)
    front_at = panel.flat(drawing.focus)
    spare = max(half - max(1.05 * outer, 0.2 * half), 0.0) * factor  # the circles stay inside
    middle = moved_inside(front_at, 2 * [half * factor], panel.flat(drawing.low), panel.flat(drawing.high), spare)
    axes.set_aspect("equal")
    axes.grid(False)
    axes.set_xlim(middle[0] - half * factor, middle[0] + half * factor)
    axes.set_ylim(middle[1] - half * factor, middle[1] + half * factor)
    draw_bodies(panel, drawing.fields)
    if drawing.fields.leaves is not None:
        draw_cells(panel, drawing.fields.leaves, shade=False)
    draw_outlines(panel, drawing.outlines)
    draw_cracks(panel, drawing.fields.crack, 2.6)
    draw_fronts(panel, drawing.fronts)
    for name in ("inner_radius", "outer_radius"):
        if front.get(name):
            axes.add_patch(Circle(front_at, front[name] * factor, fill=False, ec=style.COLOURS[1], lw=1.1, ls="-" if name == "outer_radius" else "--", zorder=7))
    caption = f"at a crack front: cells of {readable(finest, 'm')}"
    axes.set_title(caption + ("\ncircles: inner and outer radius of the J integral" if outer else ""), fontweight="normal", fontsize=10)
    axes.set_xlabel(f"{axis_names(drawing)[0]} [{unit}]")
    axes.set_ylabel(f"y [{unit}]")


def draw_list(axes, drawing):
    axes.set_axis_off()
    lines = list_lines(drawing)
    for i, (text, colour) in enumerate(lines):
        axes.annotate(text, (0.0, 1.0), (0.0, -4.0 - 12.5 * i), "axes fraction", "offset points", fontsize=8.5, color=colour, va="top", annotation_clip=False,
                      parse_math=False)


def flat_figure(drawing):
    """Figure and panels of a scene in 2D: the whole, a close-up where there is a crack front, and the list below."""
    shape = drawing.high - drawing.low
    aspect = float(np.clip((shape[1] + 0.3 * drawing.extent) / (shape[0] + 0.3 * drawing.extent), 0.3, 2.5))
    close = len(drawing.fronts) > 0
    width = 6.4 if aspect < 1.2 else 5.0
    height, below = float(np.clip(width * aspect, 4.0 if close else 2.4, 8.0)), 0.18 * len(list_lines(drawing)) + 0.15
    figure, axes = plt.subplots(2, 2 if close else 1, figsize=(width + (4.2 if close else 0.6), height + below), squeeze=False, layout="constrained",
                                gridspec_kw={"height_ratios": [height, below], **({"width_ratios": [width, 3.8]} if close else {})})
    panel = draw_view(axes[0, 0], View([0, 1]), drawing)
    if close:
        draw_close_up(axes[0, 1], drawing)
        axes[1, 1].set_axis_off()
    draw_list(axes[1, 0], drawing)
    return figure, [panel]


def spatial_figure(drawing, found):
    """Figure and panels of a scene in 3D, seen along z, x and y. found: a Perspective, or None"""
    below = 0.18 * len(list_lines(drawing)) + 0.15
    figure, axes = plt.subplots(3, 2, figsize=(11.0, 9.4 + below), layout="constrained", gridspec_kw={"height_ratios": [4.7, 4.7, below]})
    panels = []
    for panel, axes_of, normal in ((axes[0, 0], [0, 1], 2), (axes[0, 1], [1, 2], 0), (axes[1, 0], [0, 2], 1)):
        view = View(axes_of, normal, float(drawing.focus[normal]))
        panels.append(draw_view(panel, view, drawing))
        where = "0" if abs(view.where) < 2.0 * ROUNDING * drawing.extent else readable(float(view.where), "m")
        panel.set_title(f"seen along {'xyz'[normal]}; cells at {'xyz'[normal]} = {where}", fontweight="normal", fontsize=10)
    axes[1, 1].set_axis_off()
    if found is not None:
        found.draw(axes[1, 1])
    draw_list(axes[2, 0], drawing)
    axes[2, 1].set_axis_off()
    return figure, panels


def draw_scene(drawing, path):
    """Writes the picture of a scene. \return whether a view in perspective is missing, for want of VTK"""
    if drawing.fields.dimension == 2:
        write_figure(drawing, path, *flat_figure(drawing))
        return False
    with Window() as window:
        perspective = Perspective(drawing, window)
        figure, panels = spatial_figure(drawing, perspective)
    write_figure(drawing, path, figure, panels)
    return not perspective.drawn


def write_figure(drawing, path, figure, panels):
    figure.suptitle(f"{drawing.title}: the scene before the run", x=0.01, ha="left", fontsize=12, fontweight="bold", parse_math=False)
    part_labels(panels, figure)
    style.save(figure, path)


def summary_line(drawing):
    """What the picture shows, in numbers."""
    boundaries = {name for name, _ in lists(drawing.scene.values, "Boundaries")}
    loads = len({symbol.name for symbol in drawing.symbols if isinstance(symbol, (Arrows, Mark)) and symbol.kind != MOTION and symbol.name in boundaries})
    sources = sum(isinstance(symbol, Region) for symbol in drawing.symbols)
    supports = len({symbol.name for symbol in drawing.symbols if isinstance(symbol, (Nodes, Plane))})
    cracks = len({crack.get("name") for crack in drawing.state.summary.get("cracks") or []})
    bodies, tools = len(set(drawing.fields.body.tolist())), len(drawing.tools)

    counts = ((bodies, "body", "bodies"), (cracks, "crack", "cracks"), (loads, "load", "loads"), (supports, "support", "supports"),
              (sources, "heat source", "heat sources"), (tools, "rigid tool", "rigid tools"))
    return ", ".join(f"{count} {one if count == 1 else more}" for count, one, more in counts if count) + f"; {cells_text(drawing)}."
