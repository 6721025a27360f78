"""Draws error against cost."""

import math

from rhegma.problem import Problem

from . import style
from .lengths import metres
from .style import plt

MARKERS = ["o", "s", "^", "D", "v", "P", "X"]
DASHES = ["-", (0, (5, 1.5)), (0, (1.2, 1.2)), (0, (6, 1.5, 1.2, 1.5))]
GAIN = 0.02  # an error that is lower by less than this fraction is not worth a higher cost
SMALLEST = 1.0e-12  # an error of exactly zero has no position on a logarithmic axis


def frontier(points):
    """Indices of the points (cost, error) that no cheaper one beats or equals to GAIN, by rising cost."""
    best, found = math.inf, []
    for i in sorted(range(len(points)), key=lambda k: points[k]):
        if points[i][1] < (1.0 - GAIN) * best:
            best = points[i][1]
            found.append(i)
    return found


def by_chance(outcome, others, cell="Domain:Cell Size"):
    """Whether a run of the same family on smaller cells is worse, so that this one is better than its cells."""
    def size(o):
        return metres(o.run.settings[cell])

    return cell in outcome.run.settings and any(
        o.run.family == outcome.run.family and size(o) < size(outcome) and o.error > (1.0 + GAIN) * outcome.error
        for o in others)


def overlaps(one, other):
    """Whether two points of a logarithmic picture are so near that labels next to them overlap."""
    return all(max(a, b) < factor * min(a, b) for a, b, factor in zip(one, other, (2.3, 1.6)))  # labels are wide


def short(run, swept):
    """The run's swept values, for a label next to its point."""
    names = [path for path in swept if path in run.settings]
    if len(names) == 1:
        value = run.settings[names[0]]
        try:
            if names[0] == "Domain:Cell Size":
                return f"{1000.0 * metres(value):.4g} mm"
            return value if len(value) < 9 else f"{float(value):.3g}"
        except ValueError:
            return value
    return ", ".join(f"{path.split(':')[-1]} {run.settings[path]}" for path in names)


def frontier_label(good, best, swept):
    """Says what the numbers next to the frontier's points are, where they are all of one parameter."""
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


def group_style(runs):
    """{family: (colour, line style, marker)}: a colour for each group, lines and markers within it."""
    groups = list(dict.fromkeys(run.group for run in runs))
    members = {group: list(dict.fromkeys(run.family for run in runs if run.group == group)) for group in groups}
    alone = all(len(families) == 1 for families in members.values())
    found = {}
    for i, group in enumerate(groups):
        for k, family in enumerate(members[group]):
            marker = MARKERS[(i + i // len(style.COLOURS) if alone else k) % len(MARKERS)]  # colours come again with others
            found[family] = (style.COLOURS[i % len(style.COLOURS)], DASHES[k % len(DASHES)], marker)
    return found


def draw_cost(axes, study, good, costs, styles, name_axis):
    """Error against one measure of cost. Returns the indices of the runs on the efficient frontier."""
    points = [(cost, max(o.error, SMALLEST)) for cost, o in zip(costs, good)]
    sound = [i for i, o in enumerate(good) if not by_chance(o, good)]
    best = [sound[i] for i in frontier([points[i] for i in sound])]
    axes.plot([points[i][0] for i in best], [points[i][1] for i in best], color="#BBBBBB", lw=7, alpha=0.6,
              solid_capstyle="round", solid_joinstyle="round", zorder=1, label=frontier_label(good, best, study.swept),
              marker="o", ms=13, mew=0)
    for family, (colour, dashes, marker) in styles.items():
        own = [p for p, o in zip(points, good) if o.run.family == family]
        axes.plot([p[0] for p in own], [p[1] for p in own], color=colour, ls=dashes, marker=marker, ms=5.5, mec="white",
                  mew=0.7, label=family, zorder=3)
    for before, i in zip([None, *best], best):
        text = short(good[i].run, study.swept)
        if before is not None and text == short(good[before].run, study.swept) and overlaps(points[before], points[i]):
            continue  # would lie on the label before it
        axes.annotate(text, points[i], (-7, -7), textcoords="offset points", ha="right",
                      va="top", fontsize=8, color=style.QUIET, zorder=4)
    axes.set_xscale("log")
    axes.set_yscale("log")
    low, high = [[f(p[axis] for p in points) for axis in (0, 1)] for f in (min, max)]
    for axis, set_limits in ((0, axes.set_xlim), (1, axes.set_ylim)):
        span = max(high[axis] / low[axis], 2.0) ** 0.12 if low[axis] > 0.0 else 2.0
        low[axis], high[axis] = low[axis] / (span if axis == 1 else span**2), high[axis] * span  # space for labels
        set_limits(low[axis], high[axis])
    sparse_ticks(axes.xaxis, low[0], high[0], seconds)
    relative = all(o.run.reference != 0.0 for o in good)
    sparse_ticks(axes.yaxis, low[1], high[1], percent if relative else seconds)
    axes.set_xlabel(name_axis)
    return best


def draw_study(study, outcomes, path, processor=False):
    """Writes study.png from the runs that finished; there must be one. Returns those on the frontier of wall time, or of
    processor time if that shall be drawn instead."""
    good = [o for o in outcomes if o.good]
    if processor and any(o.processor_seconds is None for o in good):
        raise Problem("--processor-time: it is not known of every run; run the study --again and without --launcher.")
    spent = [o.processor_seconds if processor else o.wall_seconds for o in good]
    styles = group_style([o.run for o in good])
    figure, (left, right) = plt.subplots(1, 2, sharey=True, figsize=(10.4, 4.6), layout="constrained")
    # A run of no step or no measurable time still has a position on a logarithmic axis.
    best = draw_cost(left, study, good, [max(t, 1.0e-3) for t in spent], styles,
                     "processor time [s]" if processor else "wall time [s]")
    draw_cost(right, study, good, [max(o.particle_steps, 1) * 1.0e-6 for o in good], styles, "particle-steps [million]")
    relative = all(o.run.reference != 0.0 for o in good)
    quantities = list(dict.fromkeys(o.run.quantity for o in good))
    measured = quantities[0] if len(quantities) == 1 else "the result"
    left.set_ylabel(f"{'relative ' if relative else ''}error of {study.error_label or measured}")
    figure.suptitle(study.title, x=0.01, ha="left", fontsize=12, fontweight="bold")
    handles, labels = right.get_legend_handles_labels()
    right.legend(handles[1:] + handles[:1], labels[1:] + labels[:1], loc="upper left", bbox_to_anchor=(1.01, 1.0))
    style.save(figure, path)
    return [good[i] for i in best]
