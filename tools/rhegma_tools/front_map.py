"""Draws values along fronts in 3D over time as maps: arc length against time."""

import re

import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.colors import Normalize, to_hex

from . import style
from .history_picture import initiation_toughness
from .style import plt

MOST = 4  # fronts drawn
ROWS = 600  # samples drawn of a front
ROWS_OF_PAGE = 200  # of a map that a page draws again at any zoom
TIME_DIGITS = 12  # a part of a run may be much shorter than the time before it
SHADES = 33  # colours of its scale
SMALL = 0.1  # K_II and K_III are drawn where they exceed this fraction of the largest K
GREY = "#CCCCCC"  # nodes without a value
PANEL = (3.3, 3.1)  # inches


class Quantity:
    """What a map shows. name: of the values in the file; label: with its unit; factor: on the values; signed: whether zero has the colour in the
    middle"""

    def __init__(self, name, label, factor, signed=False):
        self.name, self.label, self.factor, self.signed = name, label, factor, signed


def largest(series, name):
    """Largest magnitude of a value in all samples; 0 where there is none."""
    values = [np.abs(getattr(sample, name)) for samples in series for sample in samples]
    finite = [v[np.isfinite(v)] for v in values]
    return max((float(v.max()) for v in finite if v.size), default=0.0)


def quantities_of(series, toughness):
    """The maps that are worth drawing: G / Gc, or G without a toughness; K_I; K_II and K_III where they are not small; the speed of fronts that
    move."""
    most = {name: largest(series, name) for name in ("G", "K_I", "K_II", "K_III", "speed")}
    found = []
    if most["G"] > 0.0:
        factor, unit = (1.0 / toughness, "") if toughness else style.scale(most["G"], "J/m²")
        found.append(Quantity("G", "G / Gc" if toughness else f"G [{unit}]", factor))
    greatest = max(most["K_I"], most["K_II"], most["K_III"])
    for mode in ("K_I", "K_II", "K_III"):
        if most[mode] > SMALL * greatest:
            factor, unit = style.scale(greatest, "Pa")
            found.append(Quantity(mode, rf"$K_\mathrm{{{mode[2:]}}}$ [{unit} √m]", factor, signed=mode != "K_I"))
    if most["speed"] > 0.0:
        factor, unit = style.scale(most["speed"], "m/s")
        found.append(Quantity("speed", f"speed [{unit}]", factor))
    return found


def edges_between(places):
    """Ends of the strips around places (n) in ascending order: the middles between them, the first and the last place."""
    return np.r_[places[0], 0.5 * (places[1:] + places[:-1]), places[-1]]


def strips_of(sample):
    """(edges (k + 1), nodes (k)) of each line of a front, one line after the other along the axis [m]."""
    start, found = 0.0, []
    for line in np.unique(sample.line):
        nodes = np.flatnonzero(sample.line == line)
        found.append((start + edges_between(sample.s[nodes]), nodes))
        start += float(sample.s[nodes][-1])
    return found


def rows_of(samples, most):
    """(first and last time [s], sample) of each row of a map, at most so many."""
    every = np.unique(np.round(np.linspace(0, len(samples) - 1, min(len(samples), most))).astype(int))
    shown = [samples[i] for i in every]
    times = edges_between(np.array([sample.time for sample in shown]))
    return list(zip(times, times[1:], shown))


def map_of(samples, name):
    """(rectangles (k, 4, 2): arc length [m] and time [s], values (k)) of a front."""
    rectangles, values = [], []
    for early, late, sample in rows_of(samples, ROWS):
        for edges, nodes in strips_of(sample):
            left, right = edges[:-1], edges[1:]
            rectangles.append(np.stack([np.c_[left, 0 * left + early], np.c_[right, 0 * left + early],
                                        np.c_[right, 0 * left + late], np.c_[left, 0 * left + late]], axis=1))
            values.append(getattr(sample, name)[nodes])
    return np.concatenate(rectangles), np.concatenate(values)


def colours_of(quantity):
    """The colour scale of a quantity."""
    return plt.get_cmap("RdBu_r" if quantity.signed else "viridis").copy()


def numbers(values, digits=4):
    """A list with so many digits; None where a value is not finite."""
    return [float(f"{value:.{digits}g}") if np.isfinite(value) else None for value in values]


def draw_map(axes, samples, quantity, norm, lengths, times):
    """One front and quantity on axes. lengths, times: factors on arc length and time"""
    rectangles, values = map_of(samples, quantity.name)
    colours = colours_of(quantity)
    colours.set_bad(GREY)
    drawn = PolyCollection(rectangles * (lengths, times), array=np.ma.masked_invalid(values * quantity.factor), cmap=colours, norm=norm,
                           edgecolors="face", linewidths=0.2)
    drawn.set_rasterized(True)
    axes.add_collection(drawn)
    axes.set_xlim(0.0, rectangles[:, :, 0].max() * lengths)
    axes.set_ylim(rectangles[0, 0, 1] * times, rectangles[-1, 2, 1] * times)
    axes.grid(False)
    return drawn


def norm_of(chosen, quantity):
    """The colour scale of a quantity, the same for all fronts."""
    values = np.concatenate([getattr(sample, quantity.name) for samples in chosen for sample in samples]) * quantity.factor
    values = values[np.isfinite(values)]
    low, high = (float(values.min()), float(values.max())) if values.size else (0.0, 1.0)
    if quantity.signed:
        low, high = -max(abs(low), abs(high)), max(abs(low), abs(high))
    return Normalize(min(low, 0.0), high if high > min(low, 0.0) else min(low, 0.0) + 1.0)


def drawable(series):
    """[(name, samples)] of the fronts that a map can be drawn of: those with two samples or more."""
    return [(name, samples) for name, samples in series.items() if len(samples) > 1 and all(len(sample.s) > 1 for sample in samples)][:MOST]


def plain(label):
    """A label without the marks of mathematics."""
    return re.sub(r"\$|\\mathrm|[{}]", "", label)


class Maps:
    """The maps of a run: its fronts, quantities and units. series: as read_series gives it"""

    def __init__(self, series, summary):
        self.fronts = drawable(series)
        self.chosen = [samples for _, samples in self.fronts]
        self.quantities = quantities_of(self.chosen, initiation_toughness(summary)) if self.fronts else []
        if self.quantities:
            self.lengths, self.metres = style.scale(max(float(sample.s.max()) for samples in self.chosen for sample in samples), "m")
            self.times, self.seconds = style.scale(max(samples[-1].time for samples in self.chosen), "s")

    @staticmethod
    def name_of(name):
        """A front in words."""
        crack, _, number = name.rpartition(".")
        return f"{crack}, front {number}"

    def draw_one(self, axes, name, samples, quantity):
        """One front and quantity with a colour bar."""
        drawn = draw_map(axes, samples, quantity, norm_of(self.chosen, quantity), self.lengths, self.times)
        axes.set_xlabel(f"arc length [{self.metres}]")
        axes.set_ylabel(f"time [{self.seconds}]")
        axes.set_title(self.name_of(name), loc="left")
        axes.figure.colorbar(drawn, ax=axes).set_label(quantity.label)

    def panel(self, name, samples, quantity):
        """The same as numbers, of which the script of a page draws it. Strips are {t: its two times, s: edges, v: values between them}."""
        norm, colours = norm_of(self.chosen, quantity), colours_of(quantity)
        strips = [{"t": numbers([early * self.times, late * self.times], TIME_DIGITS), "s": numbers(edges * self.lengths, 6),
                   "v": numbers(getattr(sample, quantity.name)[nodes] * quantity.factor)}
                  for early, late, sample in rows_of(samples, ROWS_OF_PAGE) for edges, nodes in strips_of(sample)]
        return {
            "title": f"{self.name_of(name)}: {plain(quantity.label)}", "x": f"arc length [{self.metres}]", "y": f"time [{self.seconds}]",
            "range": [0.0, max(strip["s"][-1] for strip in strips), strips[0]["t"][0], strips[-1]["t"][1]],
            "curves": [], "across": [], "marks": [], "bands": [], "areas": [], "bars": [],
            "map": {"name": plain(quantity.label), "strips": strips, "low": float(norm.vmin), "high": float(norm.vmax), "without": GREY,
                    "colours": [to_hex(colours(i / (SHADES - 1))) for i in range(SHADES)]},
        }


def draw_maps(series, summary, title, path):
    """Writes the maps of a run. series: as read_series gives it. \\return labels of what is drawn; empty where there is nothing to draw"""
    maps = Maps(series, summary)
    if not maps.quantities:
        return []
    rows, columns = len(maps.fronts), len(maps.quantities)
    figure, all_axes = plt.subplots(rows, columns, figsize=(PANEL[0] * columns + 0.6, PANEL[1] * rows + 0.8), squeeze=False, layout="constrained")
    for j, quantity in enumerate(maps.quantities):
        norm = norm_of(maps.chosen, quantity)
        for i, (name, samples) in enumerate(maps.fronts):
            axes = all_axes[i][j]
            drawn = draw_map(axes, samples, quantity, norm, maps.lengths, maps.times)
            axes.set_xlabel(f"arc length [{maps.metres}]")
            if j == 0:
                axes.set_ylabel(f"time [{maps.seconds}]")
            axes.set_title(maps.name_of(name) if j == 0 else "", fontsize=10)
        bar = figure.colorbar(drawn, ax=[axes[j] for axes in all_axes], location="top", shrink=0.9, aspect=24, pad=0.02)
        bar.set_label(quantity.label)
    figure.suptitle(f"{title}: values along the crack front{'' if rows == 1 else 's'}", fontsize=12, fontweight="bold", x=0.01, ha="left")
    style.save(figure, path)
    return [quantity.label for quantity in maps.quantities]
