"""Nodes of a front in 3D that are two cells or more from the ends of its lines. G of those nearer to a surface depends on the cells there, and
the program compares it with the toughness apart."""

import numpy as np

from .answers import is_number

CELLS = 2.0  # along the front, as the program counts them
SAME = 1.0e-3  # of values that are one, but for digits of the summary


def leaves_out(front):
    """Whether the program has left nodes at a surface out of its comparison with the toughness."""
    return is_number(front.get("closest_at_surface")) and front["closest_at_surface"] > 0.0


def inner(arc, line, cell, whole):
    """True (n) for nodes at least two cells from the ends of their line. arc [m], line: (n); cell [m]; whole: the front is closed, and has no ends"""
    kept = np.ones(len(arc), dtype=bool)
    for one in () if whole else np.unique(line):
        of = line == one
        kept[of] = np.minimum(arc[of] - arc[of].min(), arc[of].max() - arc[of]) >= CELLS * cell * (1.0 - 1.0e-9)
    return kept


def mean_along(arc, line, values):
    """The mean of values (n) along the arc, each line by the trapezoidal rule; of single nodes their plain mean."""
    length = total = 0.0
    for one in np.unique(line):
        order = np.argsort(arc[line == one], kind="stable")
        s, v = arc[line == one][order], values[line == one][order]
        length += float(s[-1] - s[0])
        total += float(np.sum(0.5 * (v[1:] + v[:-1]) * np.diff(s)))
    return total / length if length > 0.0 else float(np.mean(values))


def inner_mean(front, cell, toughness):
    """The mean of G [J/m2] at the end of a run over the inner nodes, those whose largest G is `closest_to_initiation` of the toughness; without nodes
    near a plane of symmetry at which the front ends. None where they are not known, such as of a front whose G was larger before the end. front: an
    entry of the summary; cell: edge of the cells at the front [m]"""
    nodes = front.get("front_nodes") or {}
    release, arc = nodes.get("G_J"), nodes.get("arc_length")
    if not (isinstance(release, list) and isinstance(arc, list) and len(release) == len(arc) > 0 and all(map(is_number, release + arc)) and is_number(cell)):
        return None
    release, arc = np.array(release, dtype=float), np.array(arc, dtype=float)
    line = np.array(nodes.get("line") or [0] * len(arc))
    kept = inner(arc, line, cell, bool(front.get("closed")))
    if not kept.any() or not is_number(toughness) or toughness <= 0.0:
        return None
    found = (release[kept].max(), release[~kept].max() if (~kept).any() else 0.0)
    said = (toughness * front.get("closest_to_initiation", 0.0), toughness * front.get("closest_at_surface", 0.0))
    if any(abs(one - other) > SAME * max(said) for one, other in zip(found, said)):
        return None
    return mean_along(arc[kept], line[kept], release[kept])
