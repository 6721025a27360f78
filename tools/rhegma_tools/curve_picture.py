"""Draws a column of the histories of a study's runs over time."""

import numpy as np

from rhegma.history import read_history
from rhegma.problem import Problem

from . import style
from .study_picture import group_style, short
from .style import plt


def read_curve(outcome):
    """(time [s], values) of a run."""
    history = read_history(outcome.folder)
    if history is None:
        raise Problem(f"{outcome.folder} has no history.csv for Curve Of; the scene needs a section Output.")
    values = history.column.get(outcome.run.column)
    if values is None:
        raise Problem(f"Curve Of {outcome.run.column}: history.csv has no such column; it has "
                      f"{', '.join(history.column)}.")
    return history.time, values


def name_of(outcome, study, families):
    """The family, the swept values where it has several runs, and the final error in per cent."""
    run = outcome.run
    name = run.family
    if families.count(run.family) > 1:
        name += f" ({short(run, study.swept)})"
    if run.reference != 0.0:
        name += f": {100.0 * (outcome.value / run.reference - 1.0):+.1f} %"
    return name


def draw_curves(study, outcomes, path):
    """Writes curves.png of the runs that finished and have a curve. Returns how many there are."""
    drawn = [o for o in outcomes if o.good and o.run.column]
    if not drawn:
        return 0
    curves = [read_curve(o) for o in drawn]
    styles = group_style([o.run for o in drawn])
    factor, unit = style.scale(max(float(time[-1]) for time, _ in curves), "s")
    families = [o.run.family for o in drawn]
    figure, axes = plt.subplots(figsize=(7.2, 4.6), layout="constrained")
    for value in sorted({o.run.reference for o in drawn}):
        label = f"{study.source or 'reference'}: {value / study.curve.unit:.4g}"
        axes.axhline(value / study.curve.unit, color=style.INK, lw=1.0, ls=":", label=label)
    for outcome, (time, values) in zip(drawn, curves):
        colour, dashes, _ = styles[outcome.run.family]
        axes.plot(time * factor, values / study.curve.unit, color=colour, ls=dashes, lw=1.5,
                  label=name_of(outcome, study, families))
    low = min(float(np.nanmin(values)) for _, values in curves) / study.curve.unit
    if low >= 0.0:
        axes.set_ylim(bottom=0.0)
    axes.margins(x=0)
    axes.set_xlabel(f"time [{unit}]")
    columns = list(dict.fromkeys(o.run.column for o in drawn))
    axes.set_ylabel(study.curve.label or (columns[0] if len(columns) == 1 else "the curve"))
    axes.set_title(study.title, fontsize=12)
    handles, labels = axes.get_legend_handles_labels()
    lines = len(handles) - len(drawn)
    axes.legend(handles[lines:] + handles[:lines], labels[lines:] + labels[:lines], loc="lower right")
    style.save(figure, path)
    return len(drawn)
