"""Draws fronts in 3D: G and K along them, and the crack surfaces that they bound."""

import numpy as np
from mpl_toolkits.mplot3d.art3d import Line3DCollection, Poly3DCollection

from . import style
from .answers import is_number
from .deformation import crack_normals
from .history_picture import initiation_toughness
from .panel_lines import far_above, finite_maximum, legend, named_toughness, widen
from .report_facts import all_fronts
from .style import plt

MODES = ("K_I", "K_II", "K_III")
MOST = 4  # fronts drawn
SHORT_EDGE = 0.5  # of the longest edge: a shorter one has one number
OVERLAP = 0.01  # of the largest distance of faces: a smaller overlap is not drawn as one


def fronts_with_nodes(summary):
    """[(name, {quantity: array over the front nodes})] of the first fronts that have values at their nodes."""
    found = []
    for crack, number, front in all_fronts(summary or {}):
        nodes = front.get("front_nodes") or {}
        arc = nodes.get("arc_length")
        if not isinstance(arc, list) or len(arc) < 2 or not all(map(is_number, arc)):
            continue
        whole = {key: values for key, values in nodes.items() if isinstance(values, list) and len(values) == len(arc)}
        found.append((f"{crack}, front {number}", {key: np.array([v if is_number(v) else np.nan for v in values]) for key, values in whole.items()
                                                   if not any(isinstance(v, list) for v in values)}))
    return found[:MOST]


def lines_of(nodes):
    """Indices of the nodes of each line of a front, in the order of the arc length."""
    line = nodes.get("line", np.zeros(len(nodes["arc_length"])))
    return [np.flatnonzero(line == one)[np.argsort(nodes["arc_length"][line == one], kind="stable")] for one in np.unique(line)]


def draw_along(axes, fronts, quantities, unit, title, label, toughness=None):
    """Values over the arc length. quantities: a line style for each; unit: with room for a prefix"""
    across, metres = style.scale(finite_maximum([nodes["arc_length"] for _, nodes in fronts]), "m")
    values = [nodes[q] for _, nodes in fronts for q in quantities if q in nodes]
    heading = title
    if far_above(toughness, values):
        toughness, heading = None, title + named_toughness(toughness)
    factor, unit = style.scale(finite_maximum(values + ([] if toughness is None else [np.array([toughness])])), unit)
    root = " √m" if title.startswith("Stress") else ""
    for i, (name, nodes) in enumerate(fronts):
        for q, dashes in quantities.items():
            if q not in nodes or not np.isfinite(nodes[q]).any():
                continue
            mode = rf"$K_\mathrm{{{q[2:]}}}$" if q.startswith("K_") else "J integral"
            for k, line in enumerate(lines_of(nodes)):
                axes.plot(nodes["arc_length"][line] * across, nodes[q][line] * factor, color=style.COLOURS[i], ls=dashes, marker="o", ms=2.5,
                          label=None if k else mode if len(fronts) == 1 else f"{name}: {mode}")
    if toughness is not None:
        axes.axhline(toughness * factor, color=style.INK, lw=1.0, ls=(0, (6, 2, 1, 2)), label=f"initiation toughness {toughness * factor:.4g} {unit}")
    axes.set_title(heading)
    axes.set_xlabel(f"arc length along the front [{metres}]")
    axes.set_ylabel(f"{label} [{unit}{root}]")
    widen(axes)
    axes.margins(x=0)
    legend(axes)


def panels_along(summary):
    """Functions that each draw a panel on axes: G and K along the fronts at the end of a run in 3D."""
    fronts = fronts_with_nodes(summary)
    if not fronts:
        return []
    panels = []
    if any("G_J" in nodes for _, nodes in fronts):
        panels.append(lambda axes: draw_along(axes, fronts, {"G_J": "-"}, "J/m²", "Energy release rate along the front", "G",
                                              initiation_toughness(summary)))
    if any(mode in nodes for _, nodes in fronts for mode in MODES):
        styles = dict(zip(MODES, ("-", (0, (5, 1.5)), ":")))
        panels.append(lambda axes: draw_along(axes, fronts, styles, "Pa", "Stress intensity along the front", "K"))
    return panels


def border(cells):
    """Edges (k, 2) of triangles that belong to one triangle only."""
    edges = np.sort(np.concatenate([cells[:, [0, 1]], cells[:, [1, 2]], cells[:, [2, 0]]]), axis=1)
    each, count = np.unique(edges, axis=0, return_counts=True)
    return each[count == 1]


def shown_opening(crack):
    """(what is drawn at every vertex [m], whether faces overlap): the distance of the faces, or where some overlap its part along the normal,
    which is negative there."""
    distance = np.linalg.norm(crack.opening, axis=1)
    apart = np.einsum("ij,ij->i", crack.opening, crack_normals(crack))
    overlap = bool(apart.min() < -OVERLAP * distance.max())
    return apart if overlap else distance, overlap


def draw_surface(crack, title, time, path):
    """Writes the picture of crack surfaces, coloured by their opening, true positions. \\return unit of the opening, and whether faces overlap"""
    factor, metres = style.scale(float(np.abs(crack.points).max()), "m")
    points = crack.points * factor
    opening, overlap = shown_opening(crack)
    most = float(np.abs(opening).max())
    scale, unit = style.scale(most, "m")
    figure = plt.figure(figsize=(7.2, 4.6))
    axes = figure.add_subplot(projection="3d")
    surface = Poly3DCollection(points[crack.cells], cmap="RdBu_r" if overlap else "viridis", edgecolors=style.QUIET, linewidths=0.25)
    surface.set_array(opening[crack.cells].mean(axis=1) * scale)
    if overlap:
        surface.set_clim(-most * scale, most * scale)
    axes.add_collection3d(surface)
    axes.add_collection3d(Line3DCollection(points[border(crack.cells)], colors=style.INK, linewidths=1.4))
    low, high = points.min(axis=0), points.max(axis=0)
    middle, half = 0.5 * (low + high), 0.5 * np.maximum(high - low, 0.3 * np.max(high - low))  # so that a flat crack has a visible height
    for i, name in enumerate("xyz"):
        getattr(axes, f"set_{name}lim")(middle[i] - half[i], middle[i] + half[i])
        getattr(axes, f"set_{name}label")(f"{name} [{metres}]", labelpad=9)
    axes.set_box_aspect(half, zoom=1.05 * np.linalg.norm(half) / (np.sqrt(3.0) * half.max()))  # the longest edge fits as that of a cube
    for i, name in enumerate("xyz"):  # short edges have room for few numbers, the shortest for one
        if half[i] < SHORT_EDGE * half.max():
            getattr(axes, f"set_{name}ticks")([middle[i]], labels=[f"{middle[i] + 0.0:.4g}"])
        else:
            axes.locator_params(axis=name, nbins=max(2, round((3 if name == "z" else 5) * half[i] / half.max())))
    axes.tick_params(labelsize=8)
    factor, seconds = style.scale(time, "s")
    axes.set_title(f"{title}: crack surface at t = {time * factor:.4g} {seconds}", fontsize=12)
    bar = figure.colorbar(surface, ax=axes, shrink=0.6, aspect=22, pad=0.2)
    bar.set_label(f"opening [{unit}]" + (", negative: faces overlap" if overlap else ""))
    style.save(figure, path)
    return unit, overlap
