"""Which cracks have grown in a history, and panels of their growth and speed."""

import numpy as np

from . import style
from .panel_lines import draw_ends, ends, finite_maximum, legend, width

STRETCHED = 0.01  # of its size: more than the strain of a body enlarges a crack that doesn't grow



def growth(history, running=True):
    """[(front, growth since the start [m])] of the fronts that have run, or, not running, of those that have grown in
    equilibrium. A crack that is only stretched has no speed."""
    moved = []
    for front in history.fronts:
        speed = history.of_front(front, "speed")
        if running and speed is not None and finite_maximum([speed]) == 0.0:
            continue
        length = history.of_front(front, "length")
        if length is not None and np.isfinite(length).any():
            start = length[np.isfinite(length)][0]
            if finite_maximum([length - start]) > 1.0e-9 * max(abs(start), 1.0e-12):
                moved.append((front, length - start))
    return moved


def grown_in_equilibrium(history):
    """[(front, growth [m])] of the cracks that have grown where no front has a speed: new faces have taken fracture energy, and the crack's area
    (3D) or its length (2D) has risen by more than a stretched crack's; of cracks that rose less, the one that rose the most."""
    fracture = history.column.get("fracture")
    if fracture is None or finite_maximum([fracture]) <= 0.0 or growth(history):
        return []
    rises = {}
    for front in history.fronts:
        size = history.column.get(f"{front[0]}.area", history.of_front(front, "length"))
        known = np.zeros(0) if size is None else size[np.isfinite(size)]
        if known.size and known[0] > 0.0 and known.max() > known[0]:
            rises[front] = known.max() / known[0] - 1.0
    chosen = [front for front, rise in rises.items() if rise > STRETCHED] or sorted(rises, key=rises.get)[-1:]
    lengths = [(front, history.of_front(front, "length")) for front in chosen]
    return [(front, np.full(len(history.time), np.nan) if length is None else length - length[np.isfinite(length)][:1].sum()) for front, length in lengths]


def first_growth(history):
    """(last time without, first time with) fracture energy of new faces [s] among the samples; None where there is none."""
    fracture = history.column.get("fracture", np.zeros(len(history.time)))
    found = np.flatnonzero(fracture > 0.0)
    if not found.size:
        return None
    return (float(history.time[found[0] - 1]) if found[0] else None), float(history.time[found[0]])


def areas(history, moved):
    """[(crack's name, growth of its area since the start [m2])] of the cracks in 3D whose fronts have run."""
    names = dict.fromkeys(front[0] for front, _ in moved)
    columns = [(name, history.column.get(f"{name}.area")) for name in names]
    return [(name, area - area[0]) for name, area in columns if area is not None]


def draw_growth(axes, history, moved, time, summary=None, per_second=1.0):
    """How much longer a crack is in 2D, how much larger in 3D: there a front's `length` is that of the border."""
    larger = areas(history, moved)
    if larger:
        factor, unit = style.scale(np.sqrt(finite_maximum([samples for _, samples in larger])), "m")
        factor, what = factor**2, f"new crack area [{unit}²]"
        grown = larger
    else:
        factor, unit = style.scale(finite_maximum([samples for _, samples in moved]), "m")
        what = f"crack extension [{unit}]"
        grown = [(f"{front[0]}, front {front[1]}", samples) for front, samples in moved]
        for crack in dict.fromkeys(front[0] for front, _ in moved):  # a front's `length` is that of its whole crack
            own = [samples for front, samples in moved if front[0] == crack]
            if len(own) > 1:
                grown = [(name, samples) for name, samples in grown if not name.startswith(f"{crack}, front ")]
                grown.append((f"{crack}, all fronts", own[0]))
    for i, (name, samples) in enumerate(grown[: len(style.COLOURS)]):
        axes.plot(time, samples * factor, color=style.COLOURS[i], label=name, lw=width(i, len(grown)))
    draw_ends(axes, ends(summary), per_second)
    axes.set_title("Crack growth")
    axes.set_ylabel(what)
    axes.margins(x=0)
    legend(axes)


def speed_limits(summary):
    """The speeds [m/s] that no front passes, as the summary has them."""
    fronts = [front for crack in (summary or {}).get("cracks", []) for front in crack.get("fronts", [])]
    limits = {round(front["speed_limit"], 3) for front in fronts if isinstance(front.get("speed_limit"), (int, float))}
    return sorted(limit for limit in limits if limit > 0.0)


FAR = 2.0  # times the largest speed: a higher limit is not drawn, as it would press the curves into the lower half


def draw_speed(axes, history, moved, summary, time, per_second=1.0):
    largest = 0.0
    for i, (front, _) in enumerate(moved[: len(style.COLOURS)]):
        speed = history.of_front(front, "speed")
        if speed is not None:
            axes.plot(time, speed, color=style.COLOURS[i], lw=width(i, len(moved), 1.2), label=f"{front[0]}, front {front[1]}")
            largest = max(largest, float(np.max(speed[np.isfinite(speed)], initial=0.0)))
    for limit in speed_limits(summary):
        if limit <= FAR * largest:
            reached = ", which was reached" if largest >= 0.999 * limit else ""
            axes.axhline(limit, color=style.INK, lw=1.0, ls=":", label=f"limit of the speed, {limit:.0f} m/s{reached}")
    draw_ends(axes, ends(summary), per_second)
    axes.set_title("Crack speed")
    axes.set_ylabel("speed [m/s]")
    axes.margins(x=0)
    axes.set_ylim(bottom=0.0)
    legend(axes)
