"""Panels of temperatures and of energies over time."""

import numpy as np

from . import style
from .panel_lines import finite_maximum, legend, widen

ENERGIES = [
    # Order of the energy balance; external work first, as the sum of the others.
    ("external_work", "external work", "#000000"),
    ("strain", "strain", "#0072B2"),
    ("kinetic", "kinetic", "#D55E00"),
    ("tools", "rigid tools", "#332288"),
    ("damped", "damped", "#009E73"),
    ("fracture", "fracture", "#CC79A7"),
    ("contact", "contact", "#E69F00"),
    ("plastic", "plastic", "#117733"),
    ("heat", "heat supplied", "#CC3311"),
    ("thermal", "thermal", "#882255"),
    ("combustion", "combustion", "#56B4E9"),
    ("merged", "merged", "#999933"),
    ("stabilised", "stabilised", "#AA7755"),
    ("filtered", "filtered", "#44AA99"),
    ("residual", "residual", "#888888"),
]
HEAT = ("heat", "thermal")
MUCH = 100.0  # times the others: heat that hides them in one panel
SMALLEST_WARMING = 1.0e-4  # the same for temperatures, which are absolute: rises of a tenth of a kelvin are results


def temperatures(history):
    """[(what it is called, samples [K])] of the highest and lowest of all particles, of probes and of fronts."""
    found = [(f"{which} of all", history.column[f"temperature_{which}"]) for which in ("highest", "lowest")
             if f"temperature_{which}" in history.column and np.isfinite(history.column[f"temperature_{which}"]).any()]
    for name, samples in history.column.items():
        if name.endswith(".temperature") and np.isfinite(samples).any():
            column = name[: -len(".temperature")]
            crack, _, number = column.rpartition(".")
            found.append((f"{crack}, front {number}" if (crack, number) in
                          [(front[0], str(front[1])) for front in history.fronts] else column, samples))
    return found


def draw_temperatures(axes, columns, time):
    for (name, samples), colour in zip(columns, style.COLOURS):
        axes.plot(time, samples, color=colour, label=name)
    axes.set_title("Temperature")
    axes.set_ylabel("temperature [K]")
    axes.ticklabel_format(axis="y", useOffset=False)
    widen(axes, SMALLEST_WARMING)
    axes.margins(x=0)
    legend(axes)


def energy_parts(history):
    """[(title, names of columns)] of the panels of energies: heat has one of its own where it is so much more than all others that these would not
    be seen next to it."""
    present = [name for name, _, _ in ENERGIES if name in history.column]
    others = [name for name in present if name not in HEAT]
    heat, rest = (finite_maximum([history.column[name] for name in names]) for names in ([name for name in HEAT if name in present],
                                                                                         [name for name in others if name != "residual"]))
    if 0.0 < rest < heat / MUCH:
        return [("Energy without heat", others), ("Heat", [name for name in present if name in HEAT])]
    return [("Energy", present)] if present else []


def draw_energies(axes, history, time, part=None):
    """Energies over time. part: as energy_parts gives it, else all"""
    title, names = part or ("Energy", [name for name, _, _ in ENERGIES])
    present = [(name, label, colour) for name, label, colour in ENERGIES if name in names and name in history.column]
    largest = finite_maximum([history.column[name] for name, _, _ in present])
    factor, unit = style.scale(largest, "J")
    for name, label, colour in present:
        samples = history.column[name]
        if finite_maximum([samples]) > 1.0e-6 * largest or name == "residual":  # what no eye can see is left out
            axes.plot(time, samples * factor, color=colour, label=label,
                      ls="-" if name != "residual" else ":", lw=1.6 if name != "residual" else 1.2)
    axes.set_title(title)
    axes.set_ylabel(f"energy [{unit}]")
    widen(axes)
    axes.margins(x=0)
    legend(axes)
