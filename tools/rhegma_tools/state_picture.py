"""Draws a history of one sample, such as that of a static run: a bar for each value, with the value next to it."""

import numpy as np

from . import style
from .heat_panels import ENERGIES, energy_parts, temperatures
from .history_picture import METHODS, error_estimate, initiation_toughness, intensities, pressures
from .history_picture import references, release_rates
from .panel_lines import FEW, finite_maximum, without_ended
from .style import plt

MOST = 40  # rows of the table, so that the picture stays readable


class Group:
    """Values of one kind. bars: [(name, value, colour, estimated error or None)], marks: [(name, value)] of lines to compare with;
    unit: of the values, with room for a prefix."""

    def __init__(self, title, label, unit, bars, marks=()):
        self.title, self.label, self.bars, self.marks = title, label, bars, list(marks)
        numbers = [np.array([value]) for _, value, _, _ in bars] + [np.array([value]) for _, value in self.marks]
        self.factor, self.unit = (1.0, unit) if unit == "K" else style.scale(finite_maximum(numbers), unit)


def named(front, several, name):
    return f"{front[0]}, front {front[1]}: {name}" if several else name


def release_group(history, summary):
    """G of each front by each method, of more than FEW fronts their mean and range; None where there is none."""
    rates = [(front, quantity, float(samples[-1])) for front, quantity, samples in release_rates(history)]
    if not rates:
        return None
    fronts = list(dict.fromkeys(front for front, _, _ in rates))
    bars = []
    for (quantity, method, _), colour in zip(METHODS, style.COLOURS):
        own = [(front, value) for front, q, value in rates if q == quantity and np.isfinite(value)]
        if len(fronts) > FEW and own:
            values = np.array([value for _, value in own])
            for name, value in (("mean", values.mean()), ("lowest", values.min()), ("highest", values.max())):
                bars.append((f"{method}, {name} of {len(own)} fronts", float(value), colour, None))
        else:
            for front, value in own:
                most = history.of_front(front, f"{quantity}_max")
                along = "" if most is None else ", mean along the front"
                bars.append((named(front, len(fronts) > 1, method + along), value, colour, error_estimate(summary, front, quantity)))
                if most is not None and np.isfinite(most[-1]):  # a front starts there, and it is compared with the toughness
                    bars.append((named(front, len(fronts) > 1, f"{method}, largest front node"), float(most[-1]), style.COLOURS[1],
                                 error_estimate(summary, front, f"{quantity}_extremes")))
    marks = [("reference", value) for value in sorted({value for _, _, _, value, _ in references(summary)})]
    toughness = initiation_toughness(summary)
    marks += [] if toughness is None else [("initiation toughness", toughness)]
    return Group("Energy release rate", "G", "J/m²", bars, marks)


def along(history, front, mode):
    """What a K of a front is, where it differs along the front."""
    return "" if history.of_front(front, f"K_{mode}_max") is None else ", mean along the front"


def intensity_group(history, summary):
    found = intensities(history)
    fronts = list(dict.fromkeys(front for front, _, _ in found))
    bars = [(named(front, len(fronts) > 1, rf"$K_\mathrm{{{mode}}}$" + along(history, front, mode)), float(samples[-1]),
             style.COLOURS[("I", "II", "III").index(mode)], error_estimate(summary, front, f"K_{mode}"))
            for front, mode, samples in found]
    # The prefix belongs to the pascals; the root of the length follows it.
    group = Group("Stress intensity", "K", "Pa", bars) if bars else None
    if group:
        group.unit += " √m"
    return group


def energy_group(history, part):
    """Bars of energies. part: as energy_parts gives it"""
    present = [(name, label, colour) for name, label, colour in ENERGIES if name in part[1]]
    largest = finite_maximum([history.column[name] for name, _, _ in present])
    bars = [(label, float(history.column[name][-1]), colour, None) for name, label, colour in present
            if finite_maximum([history.column[name]]) > 1.0e-6 * largest or name == "residual"]
    return Group(part[0], "energy", "J", bars) if bars else None


def groups_of(history, summary):
    """All Groups that the sample has values of."""
    history = without_ended(history, summary)
    inside = [(name, float(samples[-1]), style.COLOURS[0], None) for name, samples, _ in pressures(history)]
    warm = [(name, float(samples[-1]), style.COLOURS[1], None) for name, samples in temperatures(history)]
    found = [release_group(history, summary), intensity_group(history, summary),
             Group("Pressure in cracks", "pressure", "Pa", inside) if inside else None,
             Group("Temperature", "temperature", "K", warm) if warm else None,
             *(energy_group(history, part) for part in energy_parts(history))]
    return [group for group in found if group and group.bars]


def draw_group(axes, group):
    """Bars from top to bottom, hollow ones for what to compare with; their values at the right edge, where no bar covers them."""
    rows = group.bars + [(name, value, None, None) for name, value in group.marks]
    for row, (_, value, colour, error) in enumerate(rows):
        drawn = value * group.factor if np.isfinite(value) else 0.0
        axes.barh(row, drawn, height=0.6, color=colour or "none", edgecolor=colour or style.INK, ls="-" if colour else ":",
                  xerr=None if error is None else error * group.factor, capsize=4)
        if colour is None:
            axes.axvline(drawn, color=style.INK, lw=1.0, ls=":")
        text = f"{value * group.factor:.4g} {group.unit}" if np.isfinite(value) else "no number"
        axes.text(1.02, row, text, transform=axes.get_yaxis_transform(), va="center")
    axes.axvline(0.0, color="#555555", lw=0.8)
    axes.set_yticks(range(len(rows)), [row[0] for row in rows])
    axes.set_ylim(len(rows) - 0.4, -0.6)
    axes.grid(axis="y", visible=False)
    axes.set_title(group.title)
    axes.set_xlabel(f"{group.label} [{group.unit}]")


def draw_table(axes, history):
    """The columns of the sample and their values, as text."""
    rows = [(name, f"{float(samples[-1]):.6g}") for name, samples in history.column.items()]
    if len(rows) > MOST:
        rows = rows[: MOST - 1] + [("...", f"and {len(rows) - MOST + 1} more columns in history.csv")]
    axes.axis("off")
    axes.table(cellText=rows, colLabels=("column of history.csv", "value (SI)"), cellLoc="left", colLoc="left", loc="upper left",
               edges="horizontal")
    return rows


def draw_state(history, summary, title, path):
    """Writes the picture: bars or, where no column is drawn as one, a table of all columns. \\return number of groups of bars"""
    groups = groups_of(history, summary)
    lengths = [len(group.bars) + len(group.marks) + 2.5 for group in groups] or [0.6 * min(len(history.column), MOST) + 1.0]
    figure, axes = plt.subplots(len(lengths), 1, squeeze=False, figsize=(7.2, 0.3 * sum(lengths) + 0.6),
                                height_ratios=lengths, layout="constrained")
    for group, ax in zip(groups, axes[:, 0]):
        draw_group(ax, group)
    if not groups:
        draw_table(axes[0, 0], history)
    factor, unit = style.scale(finite_maximum([history.time]), "s")
    figure.suptitle(f"{title}, one sample at {history.time[-1] * factor:.6g} {unit}", x=0.01, ha="left", fontsize=13,
                    fontweight="bold")
    style.save(figure, path)
    return len(groups)
