"""Outlines of the filled parts of a drawing: closed polygons of which one inside another is a hole, or a part inside a hole."""

import numpy as np

from rhegma.problem import Problem

from .svg_path import curve_points

AT_ONCE = 2_000_000  # pairs of edges that are compared together


class Loop:
    """points (n, 2) [m] of a closed polygon without repetition of the first; shape: its number; turns: 1 counter-clockwise, -1 clockwise"""

    def __init__(self, points, shape):
        self.points, self.shape = points, shape
        self.turns = 1 if area(points) > 0.0 else -1


def area(points):
    """Area of a polygon, negative if it is clockwise."""
    x, y = (points - points[0]).T
    return 0.5 * float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y))


def without_repetitions(points, least):
    """Points that are more than `least` from the one before, the first one as the last one's successor."""
    kept = [points[0]]
    for point in points[1:]:
        if np.linalg.norm(point - kept[-1]) > least:
            kept.append(point)
    while len(kept) > 1 and np.linalg.norm(kept[-1] - kept[0]) <= least:
        kept.pop()
    return np.array(kept)


def is_inside(point, points):
    """Whether a point is in a polygon."""
    x, y = points.T
    following_x, following_y = np.roll(x, -1), np.roll(y, -1)
    crossed = (y > point[1]) != (following_y > point[1])
    with np.errstate(divide="ignore", invalid="ignore"):
        at = x + (point[1] - y) / (following_y - y) * (following_x - x)
    return bool(np.count_nonzero(crossed & (at > point[0])) % 2)


def loops_of(shapes, tolerance):
    """(Loops, how many lines are open and bound nothing, {number of a shape: whether by the even-odd rule}). Outlines that are not filled
    are one shape, of which each second outline is a hole."""
    loops, open_lines, rules, outlines = [], 0, {}, len(shapes)
    for number, shape in enumerate(shapes):
        rules[number] = shape.even_odd
        for curve in shape.curves:
            points = curve_points(curve, shape.matrix, tolerance)
            if not shape.filled and not curve.closed and np.linalg.norm(points[-1] - points[0]) > tolerance:
                open_lines += 1
                continue
            points = without_repetitions(points, 1e-9 * float(np.max(np.ptp(points, axis=0))))
            if len(points) > 2 and area(points) != 0.0:
                loops.append(Loop(points, number if shape.filled else outlines))
    rules[outlines] = True
    return loops, open_lines, rules


def boundaries(loops, rules):
    """The loops that bound what is filled, by the fill rules of their shapes. Loops must not cross."""
    kept = []
    for loop in loops:
        around = {}
        for other in loops:
            if other is not loop and is_inside(0.5 * (loop.points[0] + loop.points[1]), other.points):
                crossings, turns = around.get(other.shape, (0, 0))
                around[other.shape] = crossings + 1, turns + other.turns
        outside = {shape for shape, numbers in around.items() if is_filled(numbers, rules[shape])}
        crossings, turns = around.get(loop.shape, (0, 0))
        own = is_filled((crossings + 1, turns + loop.turns), rules[loop.shape])
        inside = outside - {loop.shape} | ({loop.shape} if own else set())
        if bool(outside) != bool(inside):
            kept.append(loop)
    return kept


def is_filled(numbers, even_odd):
    """numbers: (loops around a point, sum of their turns)"""
    crossings, turns = numbers
    return crossings % 2 == 1 if even_odd else turns != 0


def first_crossing(loops):
    """A position (2) where edges of loops cross or touch, or None."""
    begins = np.vstack([loop.points for loop in loops])
    ends = np.vstack([np.roll(loop.points, -1, axis=0) for loop in loops])
    successors = np.concatenate([np.roll(np.arange(len(loop.points)), -1) for loop in loops])
    start = np.concatenate([[0], np.cumsum([len(loop.points) for loop in loops])])
    successors = successors + np.repeat(start[:-1], np.diff(start))
    numbers = np.arange(len(begins))
    rows = max(1, AT_ONCE // len(begins))
    for first in range(0, len(begins), rows):
        mine = numbers[first:first + rows]
        crosses = crossings(begins[mine], ends[mine], begins, ends)
        neighbours = (mine[:, None] == numbers) | (successors[mine][:, None] == numbers) | (mine[:, None] == successors)
        found = np.argwhere(crosses & ~neighbours)
        if len(found):
            return 0.5 * (begins[mine[found[0][0]]] + ends[mine[found[0][0]]])
    return None


def side(a, b, c):
    """Twice the area of the triangle a, b, c."""
    return (b[..., 0] - a[..., 0]) * (c[..., 1] - a[..., 1]) - (b[..., 1] - a[..., 1]) * (c[..., 0] - a[..., 0])


def crossings(a, b, c, d):
    """(n, m): whether an edge a b (n, 2) crosses or touches an edge c d (m, 2)."""
    a, b = a[:, None], b[:, None]
    apart = np.zeros(np.broadcast_shapes(a.shape, c.shape)[:-1], dtype=bool)
    for axis in (0, 1):
        apart |= np.maximum(a[..., axis], b[..., axis]) < np.minimum(c[..., axis], d[..., axis])
        apart |= np.maximum(c[..., axis], d[..., axis]) < np.minimum(a[..., axis], b[..., axis])
    one = side(a, b, c) * side(a, b, d) <= 0.0
    other = side(c, d, a) * side(c, d, b) <= 0.0
    return one & other & ~apart


def outlines_of(shapes, tolerance):
    """(polygons (n, 2) [m], number of open lines that were left out) of the shapes of a drawing. tolerance: largest distance of curves from
    the polygons [m]. A Problem where nothing is closed or outlines cross."""
    loops, open_lines, rules = loops_of(shapes, tolerance)
    if not loops:
        raise Problem("the drawing has no closed outline" + (f", but {open_lines} open lines; join them to closed paths." if open_lines else "."))
    at = first_crossing(loops)
    if at is not None:
        raise Problem(f"outlines cross or touch near x = {at[0]:.6g} m, y = {at[1]:.6g} m; unite the shapes in the drawing program.")
    return [loop.points for loop in boundaries(loops, rules)], open_lines


def extent_of(shapes):
    """The larger side of the box around the shapes of a drawing [m], from a few points of each curve."""
    points = [curve_points(curve, shape.matrix, 1.0) for shape in shapes for curve in shape.curves]
    if not points:
        raise Problem("the drawing has no shapes.")
    return float(np.max(np.ptp(np.vstack(points), axis=0)))


def net_area(polygons):
    """Area of polygons without their holes [m2]."""
    total = 0.0
    for points in polygons:
        around = sum(is_inside(0.5 * (points[0] + points[1]), other) for other in polygons if other is not points)
        total += (-1) ** around * abs(area(points))
    return total
