"""Draws the last fields: particles where they have gone, coloured by stress, and the cracks between them."""

import numpy as np
from matplotlib.collections import LineCollection, PolyCollection

from rhegma.problem import Problem
from rhegma.summary import stop_time, stopped_part

from . import boxes, style
from .colour_scales import add_bar, scale_of
from .crack_fronts import crossings, lengths_of_fronts
from .deformation import automatic_magnification, crack_normals, curved_at_fronts, magnified_faces
from .front_region import at_fronts
from .quantity import label_of, quantity_shown, unit_of
from .style import plt

MOST = 250_000  # particles drawn; of more, every second, third, ... is drawn larger


class View:
    """A plane to draw on. axes: the two space axes of the picture; normal: the third, in 3D; where: its coordinate."""

    def __init__(self, axes, normal=None, where=0.0):
        self.axes = axes
        self.normal = normal
        self.where = where

    def flat(self, points):
        return points[..., self.axes]


def read_slice(text):
    """Axis and position [m], or None in its stead, of what --slice asks for: "z=0.012" or "z"."""
    axis, equals, position = (text or "").partition("=")
    try:
        where = float(position) if equals else None
    except ValueError:
        where = float("nan")
    if axis.strip() not in ("x", "y", "z") or (where is not None and not abs(where) < float("inf")):
        raise Problem(f'--slice is "{text}"; write an axis and a position in metres such as z=0.012, or an axis alone.')
    return "xyz".index(axis.strip()), where


def given_view(fields, normal, where):
    """The slice that the user asks for, or the middle one along an axis."""
    if fields.dimension == 2:
        raise Problem("--slice is for runs in 3D; leave it out.")
    half = boxes.reach(fields.boxes(), normal)
    low = float((fields.position[:, normal] - half).min())
    high = float((fields.position[:, normal] + half).max())
    position = middle_layer(fields, normal, 0.5 * (low + high)) if where is None else where
    if not in_slice(fields, normal, position).any():
        raise Problem(f"--slice {'xyz'[normal]}={position:g} cuts no particle; they lie from {low:g} to {high:g} m there.")
    return View([axis for axis in range(3) if axis != normal], normal, position)


def choose_view(fields, asked=None):
    """2D: the plane. 3D: the slice that is asked for (axis and position), else one through the middle, or through the
    cracks, that shows the most and cuts the cracks, across their fronts where these run along an axis."""
    if asked is not None:
        return given_view(fields, *asked)
    if fields.dimension == 2:
        return View([0, 1])
    extent = np.ptp(fields.position, axis=0)
    candidates = [0, 1, 2]
    middle = 0.5 * (fields.position.min(axis=0) + fields.position.max(axis=0))
    if fields.crack is not None:
        facing = np.abs(crack_normals(fields.crack)).mean(axis=0)
        candidates.remove(int(np.argmax(facing)))  # seen from there a crack is no line
        middle = 0.5 * (fields.crack.points.min(axis=0) + fields.crack.points.max(axis=0))
        fronts = lengths_of_fronts(fields)[candidates]
        if fronts.max() > 2.0 * fronts.min():  # else they are round
            candidates = [candidates[int(np.argmax(fronts))]]
    # Of equally thin directions the last, so that x and y are drawn where nothing else decides.
    thinnest = extent[candidates].min()
    normal = [axis for axis in candidates if extent[axis] <= thinnest * (1.0 + 1.0e-6)][-1]
    return View([axis for axis in range(3) if axis != normal], normal, middle_layer(fields, normal, middle[normal]))


def middle_layer(fields, normal, where):
    """The middle of a layer of particles at a position: between two layers that part a little one would see through the
    body."""
    heights = fields.position[:, normal]
    layer = in_slice(fields, normal, where) & (heights >= where)
    if layer.any():
        return clear_of_faces(fields, normal, float(np.median(heights[layer])))
    return float(heights[np.argmin(np.abs(heights - where))])  # a gap between bodies


def clear_of_faces(fields, normal, where):
    """A position next to this one, in its layer of particles, that is on the faces of as few particles as possible: particles of split ones have
    faces in the middle of whole ones, and of those that have parted a little there one would see through the body."""
    half = boxes.reach(fields.boxes(), normal)
    near = np.abs(fields.position[:, normal] - where) <= half + half.max()
    if not near.any():
        return where
    faces = np.concatenate([fields.position[near, normal] - half[near], fields.position[near, normal] + half[near]])
    candidates = where + half[in_slice(fields, normal, where)].max(initial=0.0) * np.linspace(-0.75, 0.75, 13)
    on_faces = [int(np.sum(np.abs(faces - candidate) < 0.2 * half[near].min())) for candidate in candidates]
    best = min(range(len(candidates)), key=lambda k: (on_faces[k], abs(candidates[k] - where)))
    return float(candidates[best])


def in_slice(fields, normal, where):
    """Particles whose box the plane cuts; of two layers that touch it, the upper."""
    distance = fields.position[:, normal] - where
    half = boxes.reach(fields.boxes(), normal)
    return (distance > -half * (1.0 - 1.0e-6)) & (distance <= half * (1.0 + 1.0e-6))


def particle_outlines(fields, view, magnification):
    """Outlines [(k, 2)] of the particles' own boxes, as they are drawn, and the particles' indices."""
    everyone = np.arange(len(fields.position))
    drawn = everyone if view.normal is None else everyone[in_slice(fields, view.normal, view.where)]
    stride = -(-len(drawn) // MOST)
    drawn = drawn[::stride]
    position = fields.position[drawn] + (magnification - 1.0) * fields.displacement[drawn]
    edges = fields.boxes(drawn, magnification)
    # Boxes grow a little, so that no white shows where the strain of neighbours differs, the more when magnified.
    by = np.sqrt(stride) * (1.03 if magnification == 1.0 else 1.08)
    if view.normal is None:
        return list(boxes.grown(boxes.parallelograms(position[:, :2], edges[:, :2, :2]), by)), drawn
    outlines, cut = boxes.cut(fields.position[drawn], fields.boxes(drawn), position, edges, view.normal, view.where)
    return [boxes.grown(view.flat(outline)[None], by)[0] for outline in outlines], drawn[cut]


def crack_segments(fields, faces, view):
    """Segments (s, 2, 2) to draw of each face: the crack's own in 2D, its cuts with the plane in 3D.

    The cut is found on the crack as it is and drawn where the face has gone."""
    crack = fields.crack
    if not crack.is_surface:
        return [view.flat(face) for face in curved_at_fronts(crack, faces, fields.position, fields.displacement)]
    cuts = triangle_cuts(crack.points[:, view.normal] - view.where, crack.cells)
    return [np.array([[view.flat((1.0 - s) * face[i] + s * face[j]) for i, j, s in cut] for cut in cuts]).reshape(-1, 2, 2) for face in faces]


def triangle_cuts(height, cells):
    """Where triangles cross the height 0: of each that does two (point, other point, fraction of the way between them). height: of points"""
    height = np.where(height == 0.0, 1.0e-300, height)  # a vertex on the plane counts as above it
    result = []
    for cell in cells:
        cuts = []
        for a, b in ((0, 1), (1, 2), (2, 0)):
            i, j = cell[a], cell[b]
            if (height[i] > 0.0) != (height[j] > 0.0):
                cuts.append((i, j, height[i] / (height[i] - height[j])))
        if len(cuts) == 2:
            result.append(cuts)
    return result


def tool_segments(fields, view):
    """Segments (s, 2, 2) to draw of the rigid tools: their own in 2D, their cuts with the plane in 3D."""
    tools = fields.tools
    if tools is None:
        return np.zeros((0, 2, 2))
    if view.normal is None:
        return view.flat(tools.points[tools.cells])
    cuts = triangle_cuts(tools.points[:, view.normal] - view.where, tools.cells)
    ends = [[view.flat((1.0 - s) * tools.points[i] + s * tools.points[j]) for i, j, s in cut] for cut in cuts]
    return np.array(ends).reshape(-1, 2, 2)


class DrawnFront:
    """A front as drawn. name: crack and number; ended: it has reached a surface or another crack; position: (2); stopped:
    the cells have stopped it."""

    def __init__(self, name, ended, position, stopped=False):
        self.name = name
        self.ended = ended
        self.position = position
        self.stopped = stopped


def drawn_fronts(fields, faces, summary, view):
    """Fronts of the summary, each at the crack's nearest vertex; none in 3D, where a front is a line."""
    fronts = []
    if fields.crack is None or not summary or view.normal is not None:
        return fronts
    for crack in summary.get("cracks", []):
        for number, front in enumerate(crack.get("fronts", [])):
            position = np.zeros(3)
            given = front.get("position") or []
            position[: len(given)] = given[:3]
            nearest = int(np.argmin(np.linalg.norm(fields.crack.points - position, axis=1)))
            # The summary is of the run's end; before its last advance a front had not ended.
            ended = bool(front.get("ended")) and fields.time >= (front.get("last_advance") or 0.0)
            fronts.append(DrawnFront(f"{crack.get('name', '')}.{number}", ended,
                                     view.flat(0.5 * (faces[0][nearest] + faces[1][nearest])),
                                     bool(front.get("stopped")) and fields.time >= stop_time(front)))
    return fronts


def stopped_nodes(fields, faces, summary, view):
    """Of a run in 3D: where the stopped front nodes of the summary are drawn, seen along the slice's normal, each at the
    crack's nearest vertex; and how many they are, in words, of each front."""
    positions, parts = [], []
    if fields.crack is None or not summary or view.normal is None:
        return positions, parts
    for crack in summary.get("cracks", []):
        for number, front in enumerate(crack.get("fronts", [])):
            if not front.get("stopped") or fields.time < stop_time(front):
                continue
            parts.append(f"{crack.get('name', '')}.{number}: {stopped_part(front)}stopped numerically")
            for given in (front.get("stop") or {}).get("node_positions", []):
                nearest = int(np.argmin(np.linalg.norm(fields.crack.points - np.asarray(given), axis=1)))
                positions.append(view.flat(0.5 * (faces[0][nearest] + faces[1][nearest])))
    return positions, parts


def close_up(fronts):
    """The front to look at, the first that still is one, and what to call the picture of it."""
    shown = next((front for front in fronts if front.stopped), None)
    if shown is not None:
        return shown, f"numerical stop of the front {shown.name}"
    shown = next((front for front in fronts if not front.ended), fronts[0])
    if len(fronts) == 1:
        return shown, "where the crack ended" if shown.ended else "at the crack's front"
    return shown, f"where the front {shown.name} ended" if shown.ended else f"at the front {shown.name}"


def draw_particles(axes, outlines, values, colour_map, norm):
    particles = PolyCollection(outlines, array=values, cmap=colour_map, norm=norm, edgecolors="face", linewidths=0.15)
    particles.set_rasterized(True)
    axes.add_collection(particles)
    axes.set_aspect("equal")
    axes.set_anchor("W")
    axes.grid(False)
    return particles


def draw_crack(axes, segments, positions, width, stopped=()):
    for face in segments:
        axes.add_collection(LineCollection(face, colors=style.INK, linewidths=width, capstyle="round"))
    if len(stopped) > 0:
        axes.plot(*np.array(stopped).T, ls="none", marker="o", ms=5.0 * width, mfc=style.ALARM, mec=style.ALARM, zorder=4,
                  label="stopped numerically")
    if positions:
        axes.plot(*np.array(positions).T, ls="none", marker="o", ms=3.2 * width, mfc="white", mec=style.INK, mew=0.9 * width)


def draw_tools(axes, segments, width):
    axes.add_collection(LineCollection(segments, colors=style.INK, linewidths=width, capstyle="round"))


def limits(axes, low, high, margin):
    pad = margin * max(high - low)
    axes.set_xlim((low[0] - pad), (high[0] + pad))
    axes.set_ylim((low[1] - pad), (high[1] + pad))


def moved_inside(middle, half, low, high, most=np.inf, margin=0.08):
    """The middle (2) of a close-up of half widths half (2), moved so that it shows no more than a margin [half widths] beyond a body from low to high (2);
    by not more than most (2). A close-up that is larger than the body has it in its middle."""
    middle, half = np.asarray(middle, dtype=float), np.asarray(half, dtype=float)
    first, last = np.asarray(low) + (1.0 - margin) * half, np.asarray(high) - (1.0 - margin) * half
    wanted = np.where(first > last, 0.5 * (first + last), np.clip(middle, first, last))
    return middle + np.clip(wanted - middle, -np.asarray(most), np.asarray(most))


def picture_size(extent, zoom):
    """Width and height of the figure [inch] for a body of this extent, with a close-up below or next to it."""
    width, height = extent
    tall = height > 1.2 * width
    aspect = height / width
    whole = (4.5, min(4.5 * aspect, 8.0)) if tall else (8.0, 8.0 * aspect)
    if not tall and whole[1] > 6.5:
        whole = (6.5 / aspect, 6.5)
    return tall, (whole[0] + 1.0, max(whole[1], 1.2) + 1.2 + (3.4 if zoom and not tall else 0.0))


def stop_after(fields, summary):
    """What a picture of a run must say that stopped later than its fields; empty for any other."""
    time = (summary or {}).get("time")
    if not str((summary or {}).get("status")).startswith("the run stopped") or not time or time <= fields.time * (1 + 1e-9):
        return []
    factor, unit = style.scale(time, "s")
    return [f"before the run stopped at t = {time * factor:.4g} {unit}"]


def draw_fields(fields, summary, title, path, stress="principal", magnification=None, asked=None):
    """Writes the picture; returns the magnification it used and the unit of the colours. asked: a slice, as read_slice gives it."""
    if magnification is None:
        # Next to a tool, which does not deform, a magnified body would be drawn at a wrong position.
        magnification = automatic_magnification(fields.position, fields.displacement, fields.deformation) if fields.tools is None else 1.0
    view = choose_view(fields, asked)
    stress = quantity_shown(fields, stress)
    values = fields.values(stress)
    outlines, drawn = particle_outlines(fields, view, magnification)
    low = np.min([outline.min(axis=0) for outline in outlines], axis=0)
    high = np.max([outline.max(axis=0) for outline in outlines], axis=0)
    length_factor, length_unit = style.scale(float(np.max(high - low)), "m")
    low, high = low * length_factor, high * length_factor
    outlines = [outline * length_factor for outline in outlines]
    stress_factor, stress_unit = unit_of(stress, values[drawn])
    values = values[drawn] * stress_factor
    colour_map, norm = scale_of(stress, values, fields.counts, at_fronts(fields)[drawn])

    segments, fronts, nodes, parts = [], [], [], []
    if fields.crack is not None:
        faces = magnified_faces(fields.crack, fields.position, fields.displacement, magnification)
        segments = [face * length_factor for face in crack_segments(fields, faces, view)]
        fronts = drawn_fronts(fields, faces, summary, view)
        nodes, parts = stopped_nodes(fields, faces, summary, view)
    positions = [front.position * length_factor for front in fronts if not front.ended and not front.stopped]
    if fields.crack is not None and view.normal is not None:
        positions += [view.flat(point) * length_factor for point in crossings(fields, faces, view.normal, view.where)]
    stopped = [front.position * length_factor for front in fronts if front.stopped]
    stopped += [position * length_factor for position in nodes]

    names = ["xyz"[axis] for axis in view.axes]
    time_factor, time_unit = style.scale(fields.time, "s")
    heading = [f"t = {fields.time * time_factor:.4g} {time_unit}"] + stop_after(fields, summary)
    if view.normal is not None:
        slice_factor, slice_unit = style.scale(abs(view.where), "m")
        heading.append(f"slice at {'xyz'[view.normal]} = {view.where * slice_factor:.3g} {slice_unit}")
    if stress in ("principal", "mises") and not values.any():
        heading.append("no stress yet" if len(fields.written) > 1 and fields.time == fields.written[0] else "no stress")
    heading.append("true displacement" if magnification == 1.0 else f"displacement × {magnification:,.7g}")

    extent = high - low
    zoom = bool(fronts)
    tall, size = picture_size(extent, zoom)
    if zoom and tall:
        size = (size[0] + 4.0, size[1])
    rows, columns = (1, 2) if zoom and tall else (2 if zoom else 1, 1)
    ratios = {"height_ratios": [max(size[1] - 4.6, 1.2), 3.4]} if rows == 2 else {}
    figure, axes = plt.subplots(rows, columns, figsize=size, squeeze=False, layout="constrained", gridspec_kw=ratios)
    whole = axes.flat[0]
    particles = draw_particles(whole, outlines, values, colour_map, norm)
    draw_crack(whole, segments, positions, 0.9, stopped)
    tools = tool_segments(fields, view) * length_factor
    draw_tools(whole, tools, 1.6)
    limits(whole, low, high, 0.03 if len(tools) == 0 else 0.12)
    # A tall body without a close-up has a narrow panel: a line for each part, or they would run into the colour bar.
    narrow = tall and not zoom
    lines = (heading if narrow else [",   ".join(heading)]) + parts[:2]
    subtitle = "\n".join(lines)
    whole.set_title(title, fontsize=12, pad=22 + 14 * (len(lines) - 1))
    whole.annotate(subtitle, (0.0, 1.0), (0.0, 8.0), "axes fraction", "offset points", fontsize=10, linespacing=1.3)
    # Lengths read off a magnified picture are not those of the body.
    drawn_at = "" if magnification == 1.0 else ", magnified"
    whole.set_xlabel(f"{names[0]}{drawn_at} [{length_unit}]")
    whole.set_ylabel(f"{names[1]}{drawn_at} [{length_unit}]")
    if zoom:
        close = axes.flat[1]
        half = max(0.06 * max(extent), 6.0 * fields.size * length_factor)
        draw_particles(close, outlines, values, colour_map, norm)
        draw_crack(close, segments, positions, 1.3, stopped)
        draw_tools(close, tools, 2.0)
        wide = half if tall else 2.9 * half  # the shape of the panel
        front, caption = close_up(fronts)
        # The front stays well inside.
        middle = moved_inside(front.position * length_factor, (wide, half), low, high, most=0.8 * np.array([wide, half]))
        close.set_xlim(middle[0] - wide, middle[0] + wide)
        close.set_ylim(middle[1] - half, middle[1] + half)
        close.set_title(caption, fontweight="normal", fontsize=10)
        close.set_xlabel(f"{names[0]}{drawn_at} [{length_unit}]")
        close.set_ylabel(f"{names[1]}{drawn_at} [{length_unit}]")
    extend = {(False, False): "neither", (True, False): "min", (False, True): "max", (True, True): "both"}[
        (bool(values.min() < norm.vmin), bool(values.max() > norm.vmax))
    ]
    bar = add_bar(figure, particles, list(axes.flat), label_of(stress) + (f" [{stress_unit}]" if stress_unit else ""), extend, shrink=0.9, aspect=28, pad=0.02)
    bar.outline.set_linewidth(0.6)
    style.save(figure, path)
    return magnification, stress_unit
