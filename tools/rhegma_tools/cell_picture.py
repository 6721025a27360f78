"""Draws the cells of a run that refined some: leaves by their level, and a close-up of the smallest with particles."""

import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.patches import Patch

from . import style
from .deformation import magnified_faces
from .colour_scales import add_bar, scale_of
from .field_picture import choose_view, crack_segments, draw_crack, draw_particles, moved_inside, particle_outlines
from .front_region import at_fronts
from .quantity import label_of, quantity_shown, unit_of
from .style import plt

SHADES = ["#F2F2F2", "#CFE3F2", "#8FC1E3", "#4492C6", "#1B669E", "#0B4271", "#062746"]  # of levels 0, 1, ...
MOST_ACROSS = 14.0  # fine cells across a close-up


def leaf_rectangles(leaves, view):
    """Lower and upper corners (k, 2) of the leaves that the view shows, and their levels."""
    low, high = leaves.corners.min(axis=1), leaves.corners.max(axis=1)
    shown = np.ones(len(low), dtype=bool)
    if view.normal is not None:
        shown = (low[:, view.normal] <= view.where) & (view.where < high[:, view.normal])
    return view.flat(low[shown]), view.flat(high[shown]), leaves.level[shown]


def rectangle_outlines(low, high):
    return np.stack([low, np.stack([high[:, 0], low[:, 1]], -1), high, np.stack([low[:, 0], high[:, 1]], -1)], axis=1)


def close_up(low, high, level):
    """Corners of a window with the shape 5:2 where most of the finest cells are."""
    finest = level == level.max()
    edge = float((high[finest] - low[finest]).max())
    centres = 0.5 * (low[finest] + high[finest])
    # On a cell, as the median of two far regions may lie where nothing is small.
    middle = centres[np.argmin(np.linalg.norm(centres - np.median(centres, axis=0), axis=1))]
    extent = np.ptp(centres, axis=0) + 3.0 * edge
    across = min(max(extent[1], extent[0] / 2.5), MOST_ACROSS * edge)
    half = 0.5 * np.array([2.5 * across, across])
    middle = moved_inside(middle, half, low.min(axis=0), high.max(axis=0))
    return middle - half, middle + half


def draw_cells(fields, title, path, stress="principal", asked=None):
    """Writes the picture; returns how many leaves there are. Positions are true ones: cells do not follow displacements
    that are drawn larger."""
    view = choose_view(fields, asked)
    low, high, level = leaf_rectangles(fields.leaves, view)
    stress = quantity_shown(fields, stress)
    values = fields.values(stress)
    outlines, drawn = particle_outlines(fields, view, 1.0)
    body = low.min(axis=0), high.max(axis=0)
    length_factor, length_unit = style.scale(float(np.max(body[1] - body[0])), "m")
    corner, opposite = close_up(low, high, level)
    position = view.flat(fields.position[drawn])
    shown = np.all((position >= corner) & (position <= opposite), axis=1)
    seen = values[drawn][shown]
    stress_factor, stress_unit = unit_of(stress, seen)
    colour_map, norm = scale_of(stress, seen * stress_factor, near=at_fronts(fields)[drawn][shown])
    rectangles = rectangle_outlines(low, high) * length_factor
    segments = []
    if fields.crack is not None:
        faces = magnified_faces(fields.crack, fields.position, fields.displacement, 1.0)
        segments = [face * length_factor for face in crack_segments(fields, faces, view)]

    extent = (body[1] - body[0]) * length_factor
    width = 9.0
    tall = min(max(width * extent[1] / extent[0], 0.35), 4.5)
    figure, (whole, close) = plt.subplots(2, 1, figsize=(width, tall + 5.4), layout="constrained",
                                          gridspec_kw={"height_ratios": [tall, 3.7]})
    order = np.argsort(level, kind="stable")
    shades = np.array(SHADES, dtype=object)[np.minimum(level, len(SHADES) - 1)]
    lines = min(0.4, 200.0 / np.sqrt(len(level)) / 40.0)
    cells = PolyCollection(rectangles[order], facecolors=list(shades[order]), edgecolors=style.QUIET, linewidths=lines)
    cells.set_rasterized(True)
    whole.add_collection(cells)
    draw_crack(whole, segments, [], 0.9)
    pad = 0.02 * max(extent)
    whole.set_xlim(body[0][0] * length_factor - pad, body[1][0] * length_factor + pad)
    whole.set_ylim(body[0][1] * length_factor - pad, body[1][1] * length_factor + pad)
    edges = {int(l): float((high - low)[level == l].max()) for l in np.unique(level)}
    edge_factor, edge_unit = style.scale(max(edges.values()), "m")
    patches = [Patch(facecolor=SHADES[min(l, len(SHADES) - 1)], edgecolor=style.QUIET,
                     label=f"level {l}: {edge * edge_factor:.4g} {edge_unit}") for l, edge in sorted(edges.items())]
    # Above a wide body there is space for a few, next to the time alone.
    if extent[1] > 0.6 * extent[0] or len(patches) > (4 if view.normal is None else 2):
        whole.legend(handles=patches, loc="upper left", bbox_to_anchor=(1.03, 1.0), borderaxespad=0.0)
    else:
        whole.legend(handles=patches, loc="lower right", bbox_to_anchor=(1.0, 1.02), ncols=len(patches),
                     borderaxespad=0.0)
    time_factor, time_unit = style.scale(fields.time, "s")
    heading = [f"cells at t = {fields.time * time_factor:.4g} {time_unit}"]
    if view.normal is not None:
        slice_factor, slice_unit = style.scale(abs(view.where), "m")
        heading.append(f"slice at {'xyz'[view.normal]} = {view.where * slice_factor:.3g} {slice_unit}")
    whole.set_title(f"{title}\n", fontsize=12)
    whole.annotate(",   ".join(heading), (0.0, 1.0), (0.0, 6.0), "axes fraction", "offset points", fontsize=10)

    near = np.all((high >= corner) & (low <= opposite), axis=1)
    close_factor, close_unit = style.scale(float(np.max(opposite - corner)), "m")
    ratio = close_factor / length_factor
    particles = draw_particles(close, [outline * close_factor for outline in outlines], values[drawn] * stress_factor,
                               colour_map, norm)
    loops = [ratio * np.vstack([rectangle, rectangle[:1]]) for rectangle in rectangles[near]]
    close.add_collection(LineCollection(loops, colors=style.INK, linewidths=0.8))
    draw_crack(close, [ratio * face for face in segments], [], 1.5)
    close.set_xlim(corner[0] * close_factor, opposite[0] * close_factor)
    close.set_ylim(corner[1] * close_factor, opposite[1] * close_factor)
    close.set_title("the finest cells and the particles in them", fontweight="normal", fontsize=10)
    names = ["xyz"[axis] for axis in view.axes]
    for axes, unit in ((whole, length_unit), (close, close_unit)):
        axes.set_aspect("equal")
        axes.set_anchor("W")
        axes.grid(False)
        axes.set_ylabel(f"{names[1]} [{unit}]")
        axes.set_xlabel(f"{names[0]} [{unit}]")
    bar = add_bar(figure, particles, close, f"{label_of(stress)} [{stress_unit}]", shrink=0.95, aspect=22, pad=0.02)
    bar.outline.set_linewidth(0.6)
    style.save(figure, path)
    return len(fields.leaves.level)
