"""The pictures of a page of a run. Each is a Shown: its bytes with what a reader who can't see it must know, and a caption."""

import io

import numpy as np

from rhegma.fields import read_fields
from rhegma.fronts import read_series
from rhegma.problem import Problem

from . import style
from .cell_picture import draw_cells
from .field_picture import choose_view, draw_fields
from .film_frames import draw_film
from .front_map import Maps, plain
from .front_picture import draw_surface, panels_along
from .history_picture import panels_of
from .path_picture import curves, draw_factor, draw_force, is_path
from .quantity import label_of, quantity_shown
from .spatial_picture import SpatialPictures
from .state_picture import draw_state
from .style import plt
from .vtk_window import INSTALL, Window
from .zoom_data import panel_data

LARGEST_DRAWING = 150_000  # bytes of a still panel as SVG; beyond it is a PNG
PANEL = (7.2, 3.0)  # inches
MAP = (7.2, 3.6)


class Shown:
    """kind: png or svg+xml; data: bytes; alt, caption: text; panel: numbers from which the script draws it again, or None."""

    def __init__(self, kind, data, alt, caption, panel=None):
        self.kind, self.data, self.alt, self.caption, self.panel = kind, data, alt, caption, panel


def seconds(time):
    factor, unit = style.scale(abs(time), "s")
    return f"{time * factor:.4g} {unit}"


def magnified(factor):
    return "true displacements" if factor == 1.0 else f"displacements {factor:,.7g} times as large as they are".replace(",", " ")


def section_of(view):
    """Where a 3D run is cut, in words; empty in 2D."""
    if view.normal is None:
        return ""
    factor, unit = style.scale(abs(view.where), "m")
    return f", section at {'xyz'[view.normal]} = {view.where * factor:.3g} {unit}"


def body_picture(fields, summary, title, quantity, view):
    """The body with its cracks at a time, coloured by a quantity. view: the section of a 3D run"""
    target = io.BytesIO()
    asked = None if view.normal is None else (view.normal, view.where)
    factor, unit = draw_fields(fields, summary, title, target, quantity, asked=asked)
    name = label_of(quantity_shown(fields, quantity))
    what = f"{name[0].upper()}{name[1:]}{f' [{unit}]' if unit else ''} at t = {seconds(fields.time)}{section_of(view)}; {magnified(factor)}."
    cracks = "" if fields.crack is None else " Lines are crack faces; a white dot is a crack front, a red one a front that stopped numerically."
    zero = not fields.values(quantity).any()
    scale = f" The {name} is zero everywhere." if zero else " Values beyond the scale have the colours at its ends; how many they are is beside it."
    return Shown("png", target.getvalue(), f"{title}: the body, coloured by the {name}{f' in {unit}' if unit else ''}, at t = "
                 f"{seconds(fields.time)}, {magnified(factor)}", what + cracks + (scale if name != "temperature" else ""))


def spatial_pictures(drawing, fields, title, view):
    """Of a run in 3D the body cut open and the cracks in its outline; without VTK the crack surface alone. drawing: SpatialPictures"""
    found, target = [], io.BytesIO()
    factor = drawing.body.write(drawing.window, target)
    if factor is not None:
        name = label_of(quantity_shown(fields, "principal"))
        found.append(Shown("png", target.getvalue(), f"{title}: the body in 3D, cut open, coloured by the {name}",
                           f"The body at t = {seconds(fields.time)} in 3D, cut open at {section_of(view)[len(', section at '):]}, coloured by the {name}; "
                           f"{magnified(factor)}." + ("" if fields.crack is None else " Cracks (grey) are not cut.")))
    if drawing.cracks is None:
        return found
    target = io.BytesIO()
    coloured = drawing.cracks.write(drawing.window, target)
    if coloured is not None:
        along = f" Colours along the fronts: {coloured}." if coloured else ""
        found.append(Shown("png", target.getvalue(), f"{title}: cracks in the outline of the body" + (f", fronts coloured by {coloured}" if coloured else ""),
                           f"Cracks in the outline of the body at t = {seconds(fields.time)}; true positions.{along}"))
    return found + [surface_picture(fields, title, "" if factor is not None else f" {INSTALL}")]


def surface_picture(fields, title, more):
    target = io.BytesIO()
    unit, overlap = draw_surface(fields.crack, title, fields.time, target)
    negative = " Where it is negative, the faces overlap, because the scene has no contact: G and K are wrong there." if overlap else ""
    return Shown("png", target.getvalue(), f"{title}: crack surface in 3D, coloured by its opening in {unit}",
                 f"Crack surface at t = {seconds(fields.time)}, coloured by the opening [{unit}]; true positions.{negative} The black line is its "
                 f"border: the front, and edges on surfaces or planes of symmetry.{more}")


def field_pictures(folder, summary, title):
    """Pictures of the last and the first fields; none where the run has no fields."""
    fields = read_fields(folder)
    if fields is None:
        return []
    view = choose_view(fields)
    if fields.dimension == 2:
        return flat_pictures(folder, fields, summary, title, view)
    with Window() as window:  # it draws while the other pictures are drawn
        drawing = SpatialPictures(window, fields, summary, title, asked=(view.normal, view.where))
        return flat_pictures(folder, fields, summary, title, view) + spatial_pictures(drawing, fields, title, view)


def differ(values):
    """Whether a picture of them shows something: not where all are zero, or a temperature that is the same everywhere."""
    known = values[np.isfinite(values)]
    return known.size > 0 and np.ptp(known) > 1e-9 * np.abs(known).max()


def flat_pictures(folder, fields, summary, title, view):
    """Pictures of the plane, or of a section, and of refined cells."""
    found = [body_picture(fields, summary, title, "principal", view)]
    if fields.temperature is not None and fields.stress is not None:
        found.append(body_picture(fields, summary, title, "temperature", view))
    if "damage" in fields.names:
        found.append(body_picture(read_fields(folder, None, "damage"), summary, title, "damage", view))
    first = read_fields(folder, fields.written[0]) if len(fields.written) > 1 else None
    if first is not None and differ(first.values("principal")):
        found.append(body_picture(first, summary, title, "principal", view))
    if fields.leaves is not None and fields.leaves.refined:
        target = io.BytesIO()
        count = draw_cells(fields, title, target)
        found.append(Shown("png", target.getvalue(), f"{title}: {count} cells, coloured by their level of refinement",
                           f"The {count} cells in use at t = {seconds(fields.time)}, by level of refinement, and the finest ones with their "
                           f"particles; true displacements."))
    return found


def still(figure):
    """(kind, bytes) of a figure: a drawing of lines where that is small, else a picture."""
    try:
        for kind, form in (("svg+xml", "svg"), ("png", "png")):
            target = io.BytesIO()
            figure.savefig(target, format=form, dpi=style.DOTS_PER_INCH, bbox_inches="tight", pad_inches=0.08,
                           metadata={"Date": None} if form == "svg" else None)
            if form == "png" or len(target.getvalue()) <= LARGEST_DRAWING:
                return kind, target.getvalue()
    finally:
        plt.close(figure)


def panel_picture(draw, across=None):
    """A panel as a still picture and as numbers. across: label of the horizontal axis, where the panel has none of its own"""
    with plt.rc_context({"svg.hashsalt": "rhegma"}):
        figure, axes = plt.subplots(figsize=PANEL, layout="constrained")
        draw(axes)
        if across:
            axes.set_xlabel(across)
        panel = panel_data(axes)
        names = [curve["name"] for curve in panel["curves"] if curve["name"]]
        shown = ", ".join(names[:6]) + (f" and {len(names) - 6} more" if len(names) > 6 else "")
        caption = f"{panel['title']}: {panel['y']} over {panel['x']}."
        if panel["title"].startswith("Energy") and "energy" in panel["y"]:
            caption += " The residual is what the balance can't account for."
        if panel["bars"]:
            caption += " Bars at the end are estimated numerical errors."
        if panel["marks"]:
            caption += " Vertical lines mark where a front ended; red ones, where it stopped numerically."
        kind, data = still(figure)
    return Shown(kind, data, f"{panel['title']}: {panel['y']} against {panel['x']}" + (f"; curves: {shown}" if shown else ""), caption, panel)


def history_pictures(history, summary, title):
    """Panels of the history; of a single sample, bars with values."""
    if len(history.time) == 1:
        target = io.BytesIO()
        draw_state(history, summary, title, target)
        return [Shown("png", target.getvalue(), f"{title}: values of the single sample, as bars",
                      f"The single sample of the history, at t = {seconds(history.time[0])}; units are at the bars.")]
    found = []
    if is_path(history):
        if curves(history):
            found.append(panel_picture(lambda axes: draw_force(axes, curves(history))))
        found.append(panel_picture(lambda axes: draw_factor(axes, history)))
    panels, unit = panels_of(history, summary)
    across = f"time of the load steps [{unit}]" if is_path(history) else f"time [{unit}]"
    return found + [panel_picture(draw, across) for draw in panels]


def front_pictures(summary):
    """G and K along the fronts of a run in 3D, at its end."""
    return [panel_picture(draw) for draw in panels_along(summary)]


def front_maps(folder, summary, title):
    """Maps of G, K and speed along the fronts of a run in 3D over time, one for each; none where they are known at less than two times."""
    maps, found = Maps(read_series(folder), summary), []
    for name, samples in maps.fronts:
        for quantity in maps.quantities:
            figure, axes = plt.subplots(figsize=MAP, layout="constrained")
            maps.draw_one(axes, name, samples, quantity)
            kind, data = still(figure)
            what, toughness = plain(quantity.label), " Gc is the initiation toughness." if quantity.label.startswith("G / Gc") else ""
            more = "" if found else (" A row of rectangles a sample: a front grows where its row gets longer; several lines of one front are drawn one after "
                                     "the other; grey has no value. Numbers are in fronts.csv.")
            found.append(Shown(kind, data, f"{title}: map of {what} along {maps.name_of(name)}, arc length against time",
                               f"{what} along {maps.name_of(name)}: arc length to the right, time upwards.{toughness}{more}",
                               maps.panel(name, samples, quantity)))
    return found


def film(folder, most_bytes, problems):
    """The frames of a run as a Film, or None. problems: a list to which what prevents it is added"""
    try:
        return draw_film(folder, most_bytes)
    except Problem as problem:
        problems.append(f"There is no film: {problem}")
        return None
