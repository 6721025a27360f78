"""Nodes of a front in 3D that are two cells or more from a surface. G of those nearer to it depends on the cells there, and the program compares it
with the toughness apart and marks them."""

import numpy as np

from .answers import is_number

SAME = 1.0e-3  # of values that are one, but for digits of the summary


def leaves_out(front):
    """Whether the program has left nodes at a surface out of its comparison with the toughness."""
    return is_number(front.get("closest_at_surface")) and front["closest_at_surface"] > 0.0


def mean_along(arc, line, values):
    """The mean of values (n) along the arc, each line by the trapezoidal rule; of single nodes their plain mean."""
    length = total = 0.0
    for one in np.unique(line):
        order = np.argsort(arc[line == one], kind="stable")
        s, v = arc[line == one][order], values[line == one][order]
        length += float(s[-1] - s[0])
        total += float(np.sum(0.5 * (v[1:] + v[:-1]) * np.diff(s)))
    return total / length if length > 0.0 else float(np.mean(values))


def inner_mean(front, toughness):
    """The mean of G [J/m2] at the end of a run over the inner nodes, those whose largest G is `closest_to_initiation` of the toughness. None where they
    are not known, such as of a front whose G was larger before the end. front: an entry of the summary"""
    nodes = front.get("front_nodes") or {}
    release, arc, marked = nodes.get("G_J"), nodes.get("arc_length"), nodes.get("at_surface")
    if not all(isinstance(values, list) for values in (release, arc, marked)) or not len(release) == len(arc) == len(marked) > 0:
        return None
    if not all(map(is_number, release + arc)):
        return None
    release, arc = np.array(release, dtype=float), np.array(arc, dtype=float)
    line = np.array(nodes.get("line") or [0] * len(arc))
    kept = ~np.array(marked, dtype=bool)
    if not kept.any() or not is_number(toughness) or toughness <= 0.0:
        return None
    found = (release[kept].max(), release[~kept].max() if (~kept).any() else 0.0)
    said = (toughness * front.get("closest_to_initiation", 0.0), toughness * front.get("closest_at_surface", 0.0))
    if any(abs(one - other) > SAME * max(said) for one, other in zip(found, said)):
        return None
    return mean_along(arc[kept], line[kept], release[kept])
