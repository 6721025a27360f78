"""Draws the path of a crack that grows in equilibrium: force against displacement, and the load against the crack's growth."""

import re

import numpy as np

from . import style
from .growth_panels import growth
from .panel_lines import finite_maximum, legend, width
from .style import plt


def is_path(history):
    """Whether the loads have a factor that was found."""
    return "load_factor" in history.column


def curves(history):
    """[(name, displacement [m], force [N])] of the loads, along their directions, and of the supports that move, by axis."""
    found = []
    for column, displacement in history.column.items():
        match = re.fullmatch(r"(.+)\.displacement(?:_([xyz]))?", column)
        if not match:
            continue
        name, axis = match[1], match[2]
        parts = [history.column.get(f"{name}.force_{a}") for a in (axis or "xyz")]
        parts = [part for part in parts if part is not None]
        if parts:
            force = np.abs(parts[0]) if axis else np.sqrt(sum(part**2 for part in parts))
            found.append((name if not axis else f"{name}, {axis}", np.abs(displacement) if axis else displacement, force))
    return found


def draw_force(axes, found):
    across, metres = style.scale(finite_maximum([x for _, x, _ in found]), "m")
    up, newtons = style.scale(finite_maximum([f for _, _, f in found]), "N")
    for i, (name, x, force) in enumerate(found[: len(style.COLOURS)]):
        axes.plot(np.append(0.0, x) * across, np.append(0.0, force) * up, color=style.COLOURS[i], marker="o", ms=2.5, label=name,
                  lw=width(i, len(found)))
    axes.set_title("Force against displacement of each load")
    axes.set_xlabel(f"displacement [{metres}]")
    axes.set_ylabel(f"force [{newtons}]")
    axes.set_ylim(bottom=0.0)
    legend(axes)


def draw_factor(axes, history):
    moved = growth(history, running=False)
    across, metres = style.scale(finite_maximum([samples for _, samples in moved]), "m")
    for i, ((crack, front), samples) in enumerate(moved[: len(style.COLOURS)]):
        axes.plot(samples * across, history.column["load_factor"], color=style.COLOURS[i], marker="o", ms=2.5,
                  label=f"{crack}, front {front}", lw=width(i, len(moved)))
    axes.set_title("Load at which the crack is about to grow")
    axes.set_xlabel(f"crack extension [{metres}]")
    axes.set_ylabel("load factor")
    axes.set_ylim(bottom=0.0)
    if moved:
        legend(axes)


def draw_path(history, title, path):
    """Writes the picture. \\return number of the loads that it has"""
    found = curves(history)
    figure, axes = plt.subplots(2 if found else 1, 1, squeeze=False, figsize=(7.2, (3.2 if found else 0) + 3.4),
                                layout="constrained")
    if found:
        draw_force(axes[0, 0], found)
    draw_factor(axes[-1, 0], history)
    figure.suptitle(title, x=0.01, ha="left", fontsize=13, fontweight="bold")
    style.save(figure, path)
    return len(found)
