"""Outlines of the filled parts of a drawing: closed polygons of which one inside another is a hole, or a part inside a hole."""

import numpy as np

from rhegma.problem import Problem

from .svg_path import curve_points, steps_of

AT_ONCE = 2_000_000  # pairs of edges that are compared together
MOST_POINTS = 100_000  # of polygons; more make the program slow and the part no better


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
    """(Loops, how many lines are open and bound nothing, {number of a shape: whether by the even-odd rule}, how many outlines are lines or points). Outlines
    that are not filled are one shape, of which each second outline is a hole."""
    loops, open_lines, rules, outlines, flat = [], 0, {}, len(shapes), 0
    for number, shape in enumerate(shapes):
        rules[number] = shape.even_odd
        for curve in shape.curves:
            points = curve_points(curve, shape.matrix, tolerance)
            if not shape.filled and not curve.closed and np.linalg.norm(points[-1] - points[0]) > tolerance:
                open_lines += 1
                continue
            points = without_repetitions(points, 1e-9 * float(np.max(np.ptp(points, axis=0))))
            if is_line(points):
                flat += 1
            else:
                loops.append(Loop(points, number if shape.filled else outlines))
    rules[outlines] = True
    return loops, open_lines, rules, flat


def is_line(points):
    """Whether points are on one line but for rounding. An outline that crosses itself can have no area, too, but its points are not."""
    if len(points) < 3:
        return True
    arms = points - points[0]
    longest = arms[np.argmax(np.linalg.norm(arms, axis=1))]
    return bool(np.max(np.abs(arms[:, 0] * longest[1] - arms[:, 1] * longest[0])) <= 1e-12 * float(longest @ longest))


def loops_around(polygons):
    """For each polygon (n, 2), the numbers of the others that contain the middle of its first edge."""
    low, high = np.array([points.min(axis=0) for points in polygons]), np.array([points.max(axis=0) for points in polygons])
    for number, points in enumerate(polygons):
        middle = 0.5 * (points[0] + points[1])
        near = np.flatnonzero(np.all((low <= middle) & (middle <= high), axis=1))
        yield [other for other in near if other != number and is_inside(middle, polygons[other])]


def boundaries(loops, rules):
    """The loops that bound what is filled, by the fill rules of their shapes. Loops must not cross."""
    kept = []
    for loop, outer in zip(loops, loops_around([loop.points for loop in loops])):
        around = {}
        for other in (loops[number] for number in outer):
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


def near_pairs(low, high):
    """Pairs of edges (i, j), each once, whose boxes overlap, as arrays of at most about AT_ONCE. low, high (n, 2): corners of the boxes. Edges are sorted
    along the axis on which fewer of them overlap."""
    count, choices = len(low), []
    for axis in (0, 1):
        order = np.argsort(low[:, axis], kind="stable")
        last = np.searchsorted(low[order, axis], high[order, axis], side="right")  # of those that begin before one ends
        later = last - np.arange(1, count + 1)
        choices.append((int(later.sum()), order, later, 1 - axis))
    _, order, later, across = min(choices, key=lambda choice: choice[0])
    ends, first = np.cumsum(later), 0
    while first < count:
        done = ends[first - 1] if first else 0
        last = max(first + 1, int(np.searchsorted(ends, done + AT_ONCE, side="right")))
        own = np.repeat(np.arange(first, last), later[first:last])
        other = own + 1 + np.arange(len(own)) - np.repeat(ends[first:last] - later[first:last] - done, later[first:last])
        i, j = order[own], order[other]
        near = (low[i, across] <= high[j, across]) & (low[j, across] <= high[i, across])
        yield i[near], j[near]
        first = last


def first_crossing(loops):
    """A position (2) where edges of loops cross or touch, or None."""
    begins = np.vstack([loop.points for loop in loops])
    ends = np.vstack([np.roll(loop.points, -1, axis=0) for loop in loops])
    successors = np.concatenate([np.roll(np.arange(len(loop.points)), -1) for loop in loops])
    start = np.concatenate([[0], np.cumsum([len(loop.points) for loop in loops])])
    successors = successors + np.repeat(start[:-1], np.diff(start))
    for i, j in near_pairs(np.minimum(begins, ends), np.maximum(begins, ends)):
        apart = (successors[i] != j) & (successors[j] != i)
        i, j = i[apart], j[apart]
        found = np.flatnonzero(crosses(begins[i], ends[i], begins[j], ends[j]))
        if len(found):
            return 0.5 * (begins[i[found[0]]] + ends[i[found[0]]])
    return None


def side(a, b, c):
    """Twice the area of the triangle a, b, c."""
    return (b[..., 0] - a[..., 0]) * (c[..., 1] - a[..., 1]) - (b[..., 1] - a[..., 1]) * (c[..., 0] - a[..., 0])


def crosses(a, b, c, d):
    """(n): whether an edge a b (n, 2) crosses or touches an edge c d (n, 2), where their boxes overlap."""
    return (side(a, b, c) * side(a, b, d) <= 0.0) & (side(c, d, a) * side(c, d, b) <= 0.0)


def limit_points(shapes, tolerance):
    """A Problem where polygons within the tolerance of the curves would have far too many points; it says which tolerance can be."""
    pieces = [(piece, shape.matrix[:, :2]) for shape in shapes for curve in shape.curves for piece in curve.pieces]
    most = MOST_POINTS + 12 * len(pieces)  # 12: edges that a curve has at any tolerance, and as many again

    def count(within):
        return sum(steps_of(piece, linear, within) for piece, linear in pieces)

    wanted = count(tolerance)
    if wanted <= most:
        return
    least = tolerance
    while count(least) > most:
        least *= 1.5
    raise Problem(f"a tolerance of {tolerance:.3g} m needs {wanted:.2g} points, which is too many; it can be {1.06 * least:.2g} m or larger.")  # rounded up


def outlines_of(shapes, tolerance):
    """(polygons (n, 2) [m], number of open lines that were left out) of the shapes of a drawing. tolerance: largest distance of curves from
    the polygons [m]. A Problem where nothing is closed or outlines cross."""
    limit_points(shapes, tolerance)
    loops, open_lines, rules, flat = loops_of(shapes, tolerance)
    if not loops:
        found = [f"{flat} whose points are on one line"] if flat else []
        found += [f"{open_lines} open lines; join them to closed paths"] if open_lines else []
        raise Problem("the drawing has no closed outline" + (f", but {' and '.join(found)}." if found else "."))
    at = first_crossing(loops)
    if at is not None:
        raise Problem(f"outlines cross or touch near x = {at[0]:.6g} m, y = {at[1]:.6g} m, or one crosses itself there; unite the shapes in the drawing "
                      "program.")
    return [loop.points for loop in boundaries(loops, rules)], open_lines


def extent_of(shapes):
    """The larger side of the box around the shapes of a drawing [m], from a few points of each curve."""
    points = [curve_points(curve, shape.matrix, 1.0) for shape in shapes for curve in shape.curves]
    if not points:
        raise Problem("the drawing has no closed outline: its shapes have no size.")
    extent = float(np.max(np.ptp(np.vstack(points), axis=0)))
    if not 0.0 < extent < np.inf:
        raise Problem("the drawing has no closed outline: all of its shapes are in one point; is a scale in a transform zero?" if extent == 0.0 else
                      "the drawing has coordinates that are no numbers or too large.")
    return extent


def net_area(polygons):
    """Area of polygons without their holes [m2]."""
    return sum((-1) ** len(around) * abs(area(points)) for points, around in zip(polygons, loops_around(polygons)))
