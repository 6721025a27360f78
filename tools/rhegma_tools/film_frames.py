"""Draws the frames of a run as small pictures of one size, with one colour scale, one magnification and one range of positions."""

import io

import numpy as np
from PIL import Image

from rhegma.fields import read_fields
from rhegma.problem import Problem

from . import style
from .deformation import automatic_magnification, magnified_faces
from .colour_scales import add_bar, scale_of
from .field_picture import choose_view, crack_segments, draw_crack, draw_particles, draw_tools, in_slice, limits
from .field_picture import particle_outlines, picture_size, tool_segments
from .front_region import at_fronts
from .quantity import label_of, quantity_shown, unit_of
from .style import plt

MOST = 40  # frames
PARTICLES = 2_000_000  # drawn in all frames together; of larger runs fewer frames are drawn
SAMPLE = 20_000  # particles of a frame from which the scales are found
DOTS = 100  # per inch


class Film:
    """frames: [(time [s], PNG)]; written: number of frames of the run; magnification; quantity, unit: of the colours; slice: axis and
    position of a 3D run as text, or empty."""

    def __init__(self, frames, written, magnification, quantity, unit, where):
        self.frames, self.written, self.magnification = frames, written, magnification
        self.quantity, self.unit, self.slice = quantity, unit, where


def spread(values, most):
    """At most so many of the values, evenly spread, the first and the last among them."""
    if len(values) <= most:
        return list(values)
    return [values[i] for i in np.unique(np.round(np.linspace(0, len(values) - 1, max(most, 2))).astype(int))]


class Sample:
    """What a frame contributes to the scales: position, displacement (n, 3) [m] and values of some of its particles in the view."""

    def __init__(self, fields, view, quantity):
        every = np.arange(len(fields.position))
        if view.normal is not None:
            every = every[in_slice(fields, view.normal, view.where)]
        every = every[:: max(len(every) // SAMPLE, 1)]
        self.position, self.displacement, self.values = fields.position[every], fields.displacement[every], fields.values(quantity)[every]
        self.near = at_fronts(fields)[every]
        self.deformation = fields.deformation[every]
        self.size, self.counts = fields.size, fields.counts
        self.tools = None if fields.tools is None else points_of(tool_segments(fields, view))


def points_of(segments):
    """The ends (k, 2 or 3) of segments or the corners of triangles."""
    return segments.reshape(-1, segments.shape[-1])


def common_magnification(samples):
    """The least of all frames, so that the body grows in none beyond what is wanted; 1 with rigid tools, which are drawn where they are."""
    if any(s.tools is not None for s in samples):
        return 1.0
    def largest(s):
        return float(np.max(np.linalg.norm(s.displacement, axis=1)))

    # Frames in which hardly anything has moved, such as the first one, do not count.
    least = 0.01 * max(map(largest, samples))
    return min((automatic_magnification(s.position, s.displacement, s.deformation) for s in samples if largest(s) > least), default=1.0)


def bounds(samples, view, magnification):
    """Lowest and highest corner [m] of all frames as drawn."""
    drawn = [view.flat(s.position + (magnification - 1.0) * s.displacement) for s in samples]
    drawn += [s.tools for s in samples if s.tools is not None and len(s.tools)]
    pad = max(s.size for s in samples)
    return np.min([d.min(axis=0) for d in drawn], axis=0) - pad, np.max([d.max(axis=0) for d in drawn], axis=0) + pad


class Stage:
    """A figure in which one frame after the other is drawn."""

    def __init__(self, samples, view, quantity, magnification):
        self.view, self.quantity, self.magnification = view, quantity, magnification
        low, high = bounds(samples, view, magnification)
        self.length, metres = style.scale(float(np.max(high - low)), "m")
        values = np.concatenate([s.values for s in samples])
        self.factor, self.unit = unit_of(quantity, values)
        self.colours, self.norm = scale_of(quantity, values * self.factor, any(s.counts for s in samples), np.concatenate([s.near for s in samples]))
        self.palette = palette_of(self.colours)
        _, size = picture_size((high - low) * self.length, False)
        self.figure, self.axes = plt.subplots(figsize=size, layout="constrained")
        label = label_of(quantity) + (f" [{self.unit}]" if self.unit else "")
        add_bar(self.figure, plt.cm.ScalarMappable(self.norm, self.colours), self.axes, label, shrink=0.9, aspect=28, pad=0.02)
        limits(self.axes, low * self.length, high * self.length, 0.03)
        self.axes.set_aspect("equal")
        drawn_at = "" if magnification == 1.0 else ", magnified"
        self.axes.set_xlabel(f"{'xyz'[view.axes[0]]}{drawn_at} [{metres}]")
        self.axes.set_ylabel(f"{'xyz'[view.axes[1]]}{drawn_at} [{metres}]")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        plt.close(self.figure)

    def draw(self, fields, clock, more="", dots=DOTS):
        """A frame as a PNG of any colours. clock: factor and unit of times; more: what follows the time; dots: per inch"""
        outlines, drawn = particle_outlines(fields, self.view, self.magnification)
        added = [draw_particles(self.axes, [o * self.length for o in outlines], fields.values(self.quantity)[drawn] * self.factor,
                                self.colours, self.norm)] if len(outlines) else []
        before = set(self.axes.collections)
        if fields.crack is not None:
            faces = magnified_faces(fields.crack, fields.position, fields.displacement, self.magnification)
            draw_crack(self.axes, [face * self.length for face in crack_segments(fields, faces, self.view)], [], 0.9)
        if fields.tools is not None:
            draw_tools(self.axes, tool_segments(fields, self.view) * self.length, 1.6)
        added += [c for c in self.axes.collections if c not in before]
        self.axes.set_title(f"t = {fields.time * clock[0]:.4g} {clock[1]}{more}", fontsize=10, fontweight="normal")
        png = as_png(self.figure, dots)
        for artist in added:
            artist.remove()
        return png


def as_png(figure, dots):
    """A figure as a PNG. The first one finds where its parts go, and they stay there: all frames have a title of one line."""
    target = io.BytesIO()
    figure.savefig(target, dpi=dots)
    figure.set_layout_engine("none")
    return target.getvalue()


def palette_of(colours):
    """256 colours: those of a colour map, and greys for lines and text."""
    shades = np.round(255 * plt.get_cmap(colours)(np.linspace(0.0, 1.0, 232))[:, :3]).astype(np.uint8)
    greys = np.repeat(np.linspace(0, 255, 24).astype(np.uint8)[:, None], 3, axis=1)
    image = Image.new("P", (1, 1))
    image.putpalette(np.concatenate([shades, greys]).ravel().tolist())
    return image


def few_colours(png, palette):
    """A picture with the colours of a palette, a third of the size."""
    target = io.BytesIO()
    image = Image.open(io.BytesIO(png)).convert("RGB")
    image.quantize(palette=palette, dither=Image.Dither.NONE).save(target, "png", optimize=True)
    return target.getvalue()


def within(frames, most_bytes):
    """At most so many bytes of frames, evenly spread."""
    kept = list(frames)
    while len(kept) > 2 and sum(len(png) for _, png in kept) > most_bytes:
        kept = spread(kept, int(len(kept) * 0.9))
    return kept


def draw_film(folder, most_bytes, quantity="principal"):
    """The frames of a run as a Film of at most so many bytes; None where the run has less than three frames."""
    last = read_fields(folder)
    if last is None or len(last.written) < 3:
        return None
    view, quantity = choose_view(last), quantity_shown(last, quantity)
    each = len(last.position) if view.normal is None else int(in_slice(last, view.normal, view.where).sum())
    times = spread(last.written, min(MOST, max(PARTICLES // max(each, 1), 3)))
    samples = [Sample(read_fields(folder, time), view, quantity) for time in times]
    samples = [sample for sample in samples if len(sample.position)]
    if not samples:
        raise Problem("no frame has particles in the section that is drawn.")
    magnification = common_magnification(samples)
    stage = Stage(samples, view, quantity, magnification)
    clock = style.scale(max(abs(time) for time in times), "s")
    with stage:
        frames = [(time, few_colours(stage.draw(read_fields(folder, time), clock), stage.palette)) for time in times]
    where = ""
    if view.normal is not None:
        factor, unit = style.scale(abs(view.where), "m")
        where = f"{'xyz'[view.normal]} = {view.where * factor:.3g} {unit}"
    return Film(within(frames, most_bytes), len(last.written), magnification, label_of(quantity), stage.unit, where)
