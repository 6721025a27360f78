"""Draws a history: what drives cracks, the pressure in them, energies and, where cracks grow, their growth and speed."""

import re

import numpy as np

from rhegma.problem import Problem

from . import style
from .growth_panels import draw_growth, draw_speed, grown_in_equilibrium, growth
from .heat_panels import draw_energies, draw_temperatures, energy_parts, temperatures
from .panel_lines import FEW, draw_ends, ends, far_above, finite_maximum, legend, named_toughness, widen, width, without_ended
from .style import plt

METHODS = [("G_J", "J integral", "-"), ("G_closure", "crack closure", (0, (5, 1.5)))]


def references(summary):
    """[(crack's name, front, quantity, value, relative tolerance)] of the scene's references to G."""
    found = []
    if not summary:
        return found
    names = [crack.get("name", str(i)) for i, crack in enumerate(summary.get("cracks", []))]
    for entry in summary.get("references", []):
        match = re.fullmatch(r"cracks\.(.+)\.fronts\.(\d+)\.(G_J|G_closure)", str(entry.get("quantity", "")))
        value = entry.get("reference")
        if not match or not isinstance(value, (int, float)):
            continue
        crack = match[1]
        if crack not in names and crack.isdigit() and int(crack) < len(names):
            crack = names[int(crack)]
        found.append((crack, int(match[2]), match[3], float(value), float(entry.get("tolerance") or 0.0)))
    return found


def release_rates(history):
    """[(front, quantity, samples)] of all that the history holds with at least one number."""
    found = []
    for front in history.fronts:
        for quantity, _, _ in METHODS:
            samples = history.of_front(front, quantity)
            if samples is not None and np.isfinite(samples).any():
                found.append((front, quantity, samples))
    return found


def draw_references(axes, drawn, factor, unit):
    """One line for each value, with its tolerance as a band; several references may share a value."""
    for value, tolerance in sorted({(value, tolerance) for _, _, _, value, tolerance in drawn}):
        label = f"reference {value * factor:.4g} {unit}"
        if tolerance > 0.0:
            label += f" ± {100 * tolerance:.3g} %"
            spread = abs(value) * tolerance * factor
            axes.axhspan(value * factor - spread, value * factor + spread, color="#000000", alpha=0.10, lw=0)
        axes.axhline(value * factor, color=style.INK, lw=1.0, ls=":", label=label)


def initiation_toughness(summary):
    """What starts a front [J/m2] where the scene has a toughness, or None."""
    summary = summary or {}
    value = (summary.get("propagation") or {}).get("initiation_toughness", (summary.get("start_of_growth") or {}).get("toughness"))
    return float(value) if isinstance(value, (int, float)) else None


def error_estimate(summary, front, quantity):
    """The estimated error of the last value of a front, or None. front: (crack's name, number)"""
    for i, crack in enumerate((summary or {}).get("cracks", [])):
        if crack.get("name", str(i)) == front[0]:
            of = (crack.get("fronts") or [])[int(front[1]):]
            value = (of[0] or {}).get(quantity + "_error_estimate") if of else None
            return float(value) if isinstance(value, (int, float)) else None
    return None


def draw_error(axes, summary, front, quantity, time, samples, factor, colour):
    """A bar at the last sample, where its numerical error is estimated."""
    error = error_estimate(summary, front, quantity)
    if error is not None and np.isfinite(samples[-1]):
        axes.errorbar(time[-1:], samples[-1:] * factor, yerr=error * factor, color=colour, capsize=4, lw=1.2, clip_on=False)


def draw_extremes(axes, history, front, quantity, time, factor, colour):
    """The range along a front in 3D, where the history has it."""
    low, high = (history.of_front(front, f"{quantity}_{end}") for end in ("min", "max"))
    if low is not None and high is not None:
        label = "range along the front" if front == history.fronts[0] and quantity in ("G_J", "K_I") else None
        axes.fill_between(time, low * factor, high * factor, color=colour, alpha=0.15, lw=0, label=label)


def highest_along(history, rates):
    """Samples of the largest values along fronts in 3D. rates: as release_rates gives them"""
    found = [history.of_front(front, f"{quantity}_max") for front, quantity, _ in rates]
    return [samples for samples in found if samples is not None]


def draw_release(axes, history, summary, time, per_second=1.0):
    """`time` is drawn, in units of which there are so many in a second."""
    rates = release_rates(history)
    known = references(summary)
    toughness, title = initiation_toughness(summary), "Energy release rate"
    if far_above(toughness, [samples for _, _, samples in rates] + [np.array([value]) for _, _, _, value, _ in known] + highest_along(history, rates)):
        toughness, title = None, title + named_toughness(toughness)
    lines = [np.array([value]) for _, _, _, value, _ in known] + ([] if toughness is None else [np.array([toughness])])
    factor, unit = style.scale(finite_maximum([s for _, _, s in rates] + lines), "J/m²")
    fronts = list(dict.fromkeys(front for front, _, _ in rates))
    draw_references(axes, known, factor, unit)
    if toughness is not None:
        axes.axhline(toughness * factor, color=style.INK, lw=1.0, ls=(0, (6, 2, 1, 2)),
                     label=f"initiation toughness {toughness * factor:.4g} {unit}")
    if len(fronts) <= FEW:
        for front, quantity, samples in rates:
            _, method, dashes = next(m for m in METHODS if m[0] == quantity)
            name = "" if len(fronts) == 1 else f"{front[0]}, front {front[1]}: "
            # One front: a colour for each method, which prints better than dashes alone.
            colour = style.COLOURS[[m[0] for m in METHODS].index(quantity) if name == "" else fronts.index(front)]
            mean = "" if history.of_front(front, f"{quantity}_max") is None else ",\nmean along the front"
            axes.plot(time, samples * factor, color=colour, ls=dashes, label=name + method + mean,
                      lw=width(fronts.index(front), len(fronts)))
            draw_extremes(axes, history, front, quantity, time, factor, colour)
            draw_error(axes, summary, front, quantity, time, samples, factor, colour)
    else:
        for (quantity, method, dashes), colour in zip(METHODS, style.COLOURS):
            samples = [s for _, q, s in rates if q == quantity]
            if not samples:
                continue
            samples = np.ma.masked_invalid(np.vstack(samples)) * factor
            axes.fill_between(time, samples.min(axis=0), samples.max(axis=0), color=colour, alpha=0.2, lw=0)
            axes.plot(time, samples.mean(axis=0), color=colour, ls=dashes,
                      label=f"{method}: mean and\nrange of {len(samples)} fronts")
    draw_ends(axes, ends(summary), per_second)
    axes.set_title(title)
    axes.set_ylabel(f"G [{unit}]")
    widen(axes)
    axes.margins(x=0)
    legend(axes)


def intensities(history):
    """[(front, mode, samples [Pa m^0.5])] of the first fronts, without the modes that no eye can see."""
    found = []
    for front in history.fronts[:FEW]:
        for mode in ("I", "II", "III"):
            samples = history.of_front(front, f"K_{mode}")
            if samples is not None and np.isfinite(samples).any():
                found.append((front, mode, samples))
    largest = finite_maximum([samples for _, _, samples in found])
    return [entry for entry in found if finite_maximum([entry[2]]) > 1.0e-3 * largest]


def draw_intensities(axes, found, time, summary=None, history=None):
    factor, unit = style.scale(finite_maximum([samples for _, _, samples in found]), "Pa")
    fronts = list(dict.fromkeys(front for front, _, _ in found))
    for front, mode, samples in found:
        name = "" if len(fronts) == 1 else f"{front[0]}, front {front[1]}: "
        dashes = {"I": "-", "II": (0, (5, 1.5)), "III": ":"}[mode]
        colour = style.COLOURS[fronts.index(front)]
        axes.plot(time, samples * factor, color=colour, ls=dashes, label=rf"{name}$K_\mathrm{{{mode}}}$",
                  lw=width(fronts.index(front), len(fronts)))
        if history is not None:
            draw_extremes(axes, history, front, f"K_{mode}", time, factor, colour)
        draw_error(axes, summary, front, f"K_{mode}", time, samples, factor, colour)
    axes.set_title("Stress intensity")
    axes.set_ylabel(f"K [{unit} √m]")
    widen(axes)
    axes.margins(x=0)
    legend(axes)


def pressures(history):
    """[(crack's name, samples [Pa], None or (lowest, highest) along the crack)] of the cracks that have one."""
    found = []
    for name, samples in history.column.items():
        if not name.endswith(".pressure") or not np.isfinite(samples).any():
            continue
        along = [history.column.get(f"{name}_{end}") for end in ("lowest", "highest")]
        found.append((name[: -len(".pressure")], samples, None if along[0] is None or along[1] is None else along))
    return found


def draw_pressures(axes, cracks, time):
    factor, unit = style.scale(finite_maximum([samples for _, samples, _ in cracks]), "Pa")
    for i, (name, samples, along) in enumerate(cracks[: len(style.COLOURS)]):
        colour = style.COLOURS[i]
        if along:
            axes.fill_between(time, along[0] * factor, along[1] * factor, color=colour, alpha=0.2, lw=0,
                              label=f"{name}: range along it")
        axes.plot(time, samples * factor, color=colour, label=name + (": mean" if along else ""))
    axes.set_title("Pressure in cracks")
    axes.set_ylabel(f"pressure [{unit}]")
    widen(axes)
    axes.margins(x=0)
    legend(axes)


def panels_of(history, summary):
    """(functions that each draw a panel on axes, unit of time): a panel for each kind of quantity that the history has."""
    history = without_ended(history, summary)
    moved = growth(history) or ([] if "load_factor" in history.column else grown_in_equilibrium(history))
    stressed, inside, warm = intensities(history), pressures(history), temperatures(history)
    panels = []
    factor, unit = style.scale(finite_maximum([history.time]), "s")
    time = history.time * factor
    if release_rates(history):
        panels.append(lambda axes: draw_release(axes, history, summary, time, factor))
    if stressed:
        panels.append(lambda axes: draw_intensities(axes, stressed, time, summary, history))
    if inside:
        panels.append(lambda axes: draw_pressures(axes, inside, time))
    if warm:
        panels.append(lambda axes: draw_temperatures(axes, warm, time))
    for part in energy_parts(history):
        panels.append(lambda axes, part=part: draw_energies(axes, history, time, part))
    if moved:
        panels.append(lambda axes: draw_growth(axes, history, moved, time, summary, factor))
        if any(finite_maximum([history.of_front(front, "speed")]) > 0.0 for front, _ in moved if history.of_front(front, "speed") is not None):
            panels.append(lambda axes: draw_speed(axes, history, moved, summary, time, factor))
    return panels, unit


def draw_history(history, summary, title, path):
    """Writes the picture of a history."""
    panels, unit = panels_of(history, summary)
    if not panels:
        raise Problem("the history holds neither energies nor energy release rates; there is nothing to draw.")
    figure, axes = plt.subplots(len(panels), 1, sharex=True, squeeze=False, figsize=(7.2, 2.7 * len(panels) + 0.4),
                                layout="constrained")
    for panel, ax in zip(panels, axes[:, 0]):
        panel(ax)
    axes[-1, 0].set_xlabel(f"time [{unit}]")
    figure.suptitle(title, x=0.01, ha="left", fontsize=13, fontweight="bold")
    style.save(figure, path)
