"""What panels of curves share: widths, limits, legends and marks where fronts ended."""

import numpy as np

from rhegma.history import History
from rhegma.summary import stopped_part

from . import style

SMALLEST_RANGE = 0.02  # of an axis of values, over their size
FEW = 4  # fronts that can be distinguished in one panel; of more, the range and the mean are drawn


def finite_maximum(arrays):
    values = np.concatenate([np.abs(np.asarray(a, dtype=float)).ravel() for a in arrays]) if arrays else np.zeros(1)
    values = values[np.isfinite(values)]
    return float(values.max()) if values.size else 0.0


def width(i, count, thinnest=1.6):
    """Of the i-th of some lines: the later the thinner, so that of lines on each other all can be seen."""
    return thinnest + 1.6 * (count - 1 - i) / max(count - 1, 1)


def legend(axes):
    if axes.get_legend_handles_labels()[0]:  # of values that are all zero no line is drawn
        axes.legend(loc="upper left", bbox_to_anchor=(1.01, 1.02), borderaxespad=0.0, handlelength=2.6)


def widen(axes, fraction=SMALLEST_RANGE):
    """Gives the axis of values a range of at least this fraction of their size, so that rounding is not drawn as a change."""
    low, high = axes.get_ylim()
    least = fraction * max(abs(low), abs(high))
    if high - low < least:
        axes.set_ylim(0.5 * (low + high - least), 0.5 * (low + high + least))


def ends(summary):
    """[(crack's name, front, time [s], what became of it)] of the fronts that have run and run no more."""
    found = []
    for i, crack in enumerate((summary or {}).get("cracks", [])):
        for j, front in enumerate(crack.get("fronts", [])):
            time, how = front.get("last_advance"), [name for name in ("ended", "stopped") if front.get(name)]
            if how[-1:] == ["stopped"]:
                time, how = (front.get("stop") or {}).get("time", time), [stopped_part(front) + "stopped"]
            if how and isinstance(time, (int, float)):
                found.append((crack.get("name", str(i)), j, float(time), how[-1]))
    return found


def draw_ends(axes, found, factor):
    """A line across the panel where a front met its end, red where it stopped numerically; of many fronts that ended the lines
    have one name."""
    for k, (crack, front, time, how) in enumerate(found):
        stopped = how.endswith("stopped")
        between = ":\n" if " nodes " in how else " "
        name = f"{crack}, front {front}{between}{how}" + (" numerically" if stopped else "")
        if len(found) > FEW and not stopped:
            name = None if k else f"{len(found)} fronts ended"
        colour, width_, dashes = (style.ALARM, 1.6, "-") if stopped else (style.INK, 1.0, (0, (1, 3)))
        axes.axvline(time * factor, color=colour, lw=width_, ls=dashes, label=name)


def gone(history, front, ended):
    """Samples (n) at the end of a history at which a front no longer exists: its energy release rates and stress intensities are exactly zero. ended:
    whether the summary says that it has ended; None, where there is no summary: then its length must be zero, too"""
    names = [name for name in ("G_J", "G_closure", "K_I", "K_II", "K_III", *([] if ended else ["length"])) if history.of_front(front, name) is not None]
    if ended is False or not {"G_J", "G_closure"}.intersection(names) or (ended is None and "length" not in names):
        return np.zeros(len(history.time), dtype=bool)
    zero = np.all([history.of_front(front, name) == 0.0 for name in names], axis=0)
    return np.logical_and.accumulate(zero[::-1])[::-1]


def without_ended(history, summary):
    """A history in which fronts that no longer exist have no values, so that their curves end where the fronts did."""
    known = {(str(crack.get("name", i)), j): bool(front.get("ended")) for i, crack in enumerate((summary or {}).get("cracks", []))
             for j, front in enumerate(crack.get("fronts", []))}
    column = dict(history.column)
    for front in history.fronts:
        missing = gone(history, front, known.get(front, None if not summary else False))
        if missing.any():
            start = f"{front[0]}.{front[1]}."
            column.update({name: np.where(missing, np.nan, values) for name, values in column.items()
                           if name.startswith((start + "G_", start + "K_")) or name == start + "temperature"})
            length = column.get(start + "length")
            if length is not None:  # in 2D it is that of the whole crack, which stays
                column[start + "length"] = np.where(missing & (length == 0.0), np.nan, length)
    return History(column)


FAR_ABOVE = 3.0  # times the largest value: a line so far above would flatten the curves


def far_above(value, samples):
    """Whether a value to compare with, such as a toughness, is so far above all samples (arrays) that it is named and not drawn."""
    largest = finite_maximum(samples)
    return value is not None and 0.0 < FAR_ABOVE * largest < value


def named_toughness(toughness):
    """What the title of a panel says of a toughness [J/m2] that is not drawn."""
    factor, unit = style.scale(toughness, "J/m²")
    return f" (the initiation toughness, {toughness * factor:.4g} {unit}, is far above)"
