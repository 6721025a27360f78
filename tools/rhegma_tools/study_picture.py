"""Draws error against wall time."""

import math

from . import style
from .style import plt

MARKERS = ["o", "s", "^", "D", "v", "P", "X"]
SMALLEST = 1.0e-12  # an error of exactly zero has no place on a logarithmic axis


def frontier(points):
    """Indices of the points (time, error) that no other beats in both, by rising time."""
    best, found = math.inf, []
    for i in sorted(range(len(points)), key=lambda k: points[k]):
        if points[i][1] < best:
            best = points[i][1]
            found.append(i)
    return found


def short(run, swept):
    """The run's swept values, for a label beside its point."""
    names = [path for path in swept if path in run.settings]
    if len(names) == 1:
        return run.settings[names[0]]
    return ", ".join(f"{path.split(':')[-1]} {run.settings[path]}" for path in names)


def frontier_label(good, best, swept):
    """Says what the numbers beside the frontier's points are, where they are all of one parameter."""
    names = {tuple(path for path in swept if path in good[i].run.settings) for i in best}
    only = next(iter(names)) if len(names) == 1 else ()
    return "efficient frontier" + (f"\n(numbers: {only[0].split(':')[-1]})" if len(only) == 1 else "")


def percent(value, _=None):
    return f"{100 * value:.3g} %"


def seconds(value, _=None):
    return f"{value:g}"


def sparse_ticks(axis, low, high, form):
    """Decades are few: where the axis spans less than two, also label 2 and 5."""
    subs = (1.0,) if high / low > 300.0 else ((1.0, 3.0) if high / low > 30.0 else (1.0, 2.0, 5.0))
    axis.set_major_locator(plt.matplotlib.ticker.LogLocator(subs=subs))
    axis.set_major_formatter(plt.matplotlib.ticker.FuncFormatter(form))
    axis.set_minor_formatter(plt.matplotlib.ticker.NullFormatter())


def draw_study(study, outcomes, path):
    """Writes study.png from the runs that finished; there must be one."""
    good = [o for o in outcomes if o.good]
    points = [(o.wall_seconds, max(o.error, SMALLEST)) for o in good]
    families = list(dict.fromkeys(o.run.family for o in good))
    figure, axes = plt.subplots(figsize=(7.2, 4.6), layout="constrained")
    best = frontier(points)
    axes.plot([points[i][0] for i in best], [points[i][1] for i in best], color="#BBBBBB", lw=7, alpha=0.6,
              solid_capstyle="round", solid_joinstyle="round", zorder=1, label=frontier_label(good, best, study.swept),
              marker="o", ms=13, mew=0)
    for i, family in enumerate(families):
        own = [p for p, o in zip(points, good) if o.run.family == family]
        axes.plot([p[0] for p in own], [p[1] for p in own], color=style.COLOURS[i % len(style.COLOURS)],
                  marker=MARKERS[i % len(MARKERS)], ms=5.5, mec="white", mew=0.7, label=family, zorder=3)
    for i in best:
        axes.annotate(short(good[i].run, study.swept), points[i], (-7, -7), textcoords="offset points", ha="right",
                      va="top", fontsize=8, color=style.QUIET, zorder=4)
    axes.set_xscale("log")
    axes.set_yscale("log")
    low, high = [[f(p[axis] for p in points) for axis in (0, 1)] for f in (min, max)]
    for axis, set_limits in ((0, axes.set_xlim), (1, axes.set_ylim)):
        span = max(high[axis] / low[axis], 2.0) ** 0.12 if low[axis] > 0.0 else 2.0
        low[axis], high[axis] = low[axis] / (span if axis == 1 else span**2), high[axis] * span  # room for labels
        set_limits(low[axis], high[axis])
    sparse_ticks(axes.xaxis, low[0], high[0], seconds)
    relative = all(o.run.reference != 0.0 for o in good)
    sparse_ticks(axes.yaxis, low[1], high[1], percent if relative else seconds)
    axes.set_xlabel("wall time [s]")
    quantities = list(dict.fromkeys(o.run.quantity for o in good))
    axes.set_ylabel(f"{'relative ' if relative else ''}error of {quantities[0] if len(quantities) == 1 else 'the result'}")
    axes.set_title(study.title, fontsize=12)
    handles, labels = axes.get_legend_handles_labels()
    axes.legend(handles[1:] + handles[:1], labels[1:] + labels[:1], loc="upper left", bbox_to_anchor=(1.01, 1.0))
    style.save(figure, path)
    return [good[i] for i in best]
