"""What a panel of matplotlib shows, as numbers from which the script of a page draws it again at any zoom."""

import re

import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import to_hex
from matplotlib.container import ErrorbarContainer

POINTS = 40_000  # of all curves of a panel together
FEWEST = 300  # of a curve, however many there are
DASHES = {"-": "", "--": "7 3", "-.": "8 3 2 3", ":": "2 3"}


def rounded(values):
    """A list of numbers with six digits; None where a value is not finite."""
    return [float(f"{value:.6g}") if np.isfinite(value) else None for value in np.asarray(values, dtype=float)]


def plain(label):
    """A label without mathematical typesetting and line breaks; empty where matplotlib made it up."""
    text = re.sub(r"\$K_\\mathrm\{(I+)\}\$", r"K_\1", str(label)).replace("\n", " ")
    return "" if text.startswith("_") else text


def thinned(values, most):
    """Indices of at most so many values: all, or of each of equal parts the first, the lowest, the highest and the last, so that
    no peak is lost."""
    count = len(values)
    if count <= most:
        return np.arange(count)
    kept = set()
    for part in np.array_split(np.arange(count), max(most // 4, 1)):
        kept |= {part[0], part[-1]}
        finite = part[np.isfinite(values[part])]
        if finite.size:
            kept |= {finite[np.argmin(values[finite])], finite[np.argmax(values[finite])]}
    return np.array(sorted(kept))


def curve_of(line, most):
    """A curve. line: of matplotlib, in the units of its axes; most: number of its points"""
    x, y = (np.ma.filled(np.ma.asarray(v, dtype=float), np.nan) for v in (line.get_xdata(), line.get_ydata()))
    kept = thinned(y, most)
    return {"name": plain(line.get_label()), "colour": to_hex(line.get_color()), "dashes": DASHES.get(line.get_linestyle(), ""),
            "width": line.get_linewidth(), "x": rounded(x[kept]), "y": rounded(y[kept])}


def line_across(line, value, dashed):
    """A straight line through the whole panel at a value. dashed: its dashes, where matplotlib only knows that it has some"""
    dashes = dashed if line.get_linestyle() == "--" else DASHES.get(line.get_linestyle(), "")
    return {"name": plain(line.get_label()), "colour": to_hex(line.get_color()), "dashes": dashes,
            "width": line.get_linewidth(), "at": float(value)}


def area_of(polygon, path, most):
    """A filled area between two curves. path: its corners (n, 2)"""
    red, green, blue, alpha = polygon.get_facecolor()[0]
    return {"name": plain(polygon.get_label()), "colour": to_hex((red, green, blue)), "opacity": float(alpha),
            "x": rounded(path[::max(len(path) // most, 1), 0]), "y": rounded(path[::max(len(path) // most, 1), 1])}


def bars_of(collection):
    """Error bars: {x, low, high} each."""
    colour = to_hex(collection.get_color()[0])
    return [{"colour": colour, "x": float(part[0, 0]), "low": float(part[0, 1]), "high": float(part[-1, 1])}
            for part in collection.get_segments() if np.isfinite(part).all()]


def band_of(patch):
    """A horizontal band of tolerance."""
    corners = patch.get_path().transformed(patch.get_patch_transform()).vertices
    return {"low": float(corners[:, 1].min()), "high": float(corners[:, 1].max())}


def panel_data(axes):
    """{title, x, y: labels; range: of all: [left, right, bottom, top]; curves, across, marks, bands, areas, bars} of axes on which
    one of the panels of history_picture or path_picture was drawn."""
    ends = [container.lines[0] for container in axes.containers if isinstance(container, ErrorbarContainer)]
    drawn = [line for line in axes.get_lines() if line.get_linestyle() not in ("None", "none", "") and line not in ends]
    upright = [line for line in drawn if line.get_transform() is axes.get_xaxis_transform(which="grid")]
    level = [line for line in drawn if line.get_transform() is axes.get_yaxis_transform(which="grid")]
    curves = [line for line in drawn if line not in upright and line not in level]
    most = max(POINTS // max(len(curves), 1), FEWEST)
    areas = [area_of(c, path.vertices, most) for c in axes.collections if isinstance(c, PolyCollection) for path in c.get_paths()]
    bars = [bar for c in axes.collections if isinstance(c, LineCollection) for bar in bars_of(c)]
    return {
        "title": axes.get_title(loc="left"), "x": axes.get_xlabel(), "y": axes.get_ylabel(),
        "range": [float(end) for end in (*axes.get_xlim(), *axes.get_ylim())],
        "curves": [curve_of(line, most) for line in curves],
        "across": [line_across(line, line.get_ydata()[0], "8 3 2 3") for line in level],
        "marks": [line_across(line, line.get_xdata()[0], "1 3") for line in upright],
        "bands": [band_of(patch) for patch in axes.patches], "areas": areas, "bars": bars,
    }
