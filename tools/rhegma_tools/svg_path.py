"""Curves of SVG paths and shapes, as pieces of lines, Bezier curves and arcs in the coordinates of the element.

A piece is an array of control points (k, 2) from its begin to its end: 2 of a line, 3 of a quadratic and 4 of a cubic Bezier curve;
or an Arc."""

import math
import re

import numpy as np

from rhegma.problem import Problem

NUMBER = re.compile(r"[\s,]*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)")
FLAG = re.compile(r"[\s,]*([01])")
COMMAND = re.compile(r"[\s,]*([MmLlHhVvCcSsQqTtAaZz])")
COUNT = {"M": 2, "L": 2, "H": 1, "V": 1, "C": 6, "S": 4, "Q": 4, "T": 2, "A": 7, "Z": 0}


class Arc:
    """centre + axes (cos t, sin t) for t from `first` to `last`. centre (2), axes (2, 2): one semi-axis a column"""

    def __init__(self, centre, axes, first, last):
        self.centre, self.axes, self.first, self.last = np.asarray(centre, dtype=float), np.asarray(axes, dtype=float), first, last

    def at(self, angles):
        """Points (n, 2) at angles (n)."""
        return self.centre + np.c_[np.cos(angles), np.sin(angles)] @ self.axes.T


class Curve:
    """Pieces of one subpath; closed: whether it ends with Z or is a shape such as a circle."""

    def __init__(self, pieces, closed):
        self.pieces, self.closed = pieces, closed


def line(begin, end):
    return np.array([begin, end], dtype=float)


def arc_between(begin, end, radii, rotation, large, sweep):
    """The piece of an elliptical arc between two points, as the appendix of SVG 1.1 on arcs defines it. rotation [degrees]"""
    begin, end = np.asarray(begin, dtype=float), np.asarray(end, dtype=float)
    rx, ry = abs(radii[0]), abs(radii[1])
    if rx == 0.0 or ry == 0.0 or np.all(begin == end):
        return line(begin, end)
    cosine, sine = math.cos(math.radians(rotation)), math.sin(math.radians(rotation))
    turn = np.array([[cosine, -sine], [sine, cosine]])
    x, y = turn.T @ (0.5 * (begin - end))
    excess = (x / rx) ** 2 + (y / ry) ** 2
    if excess > 1.0:  # radii that are too small are enlarged
        rx, ry, excess = rx * math.sqrt(excess), ry * math.sqrt(excess), 1.0
    factor = math.sqrt(max(0.0, 1.0 / excess - 1.0)) * (1.0 if large != sweep else -1.0)
    middle = factor * np.array([rx * y / ry, -ry * x / rx])
    first = math.atan2((y - middle[1]) / ry, (x - middle[0]) / rx)
    last = math.atan2((-y - middle[1]) / ry, (-x - middle[0]) / rx)
    if sweep and last < first:
        last += 2.0 * math.pi
    if not sweep and last > first:
        last -= 2.0 * math.pi
    return Arc(turn @ middle + 0.5 * (begin + end), turn @ np.diag([rx, ry]), first, last)


def read_path(text):
    """The Curves of the data of a path."""
    return PathReader(text).curves


class PathReader:
    """Follows the commands of a path. at: current point; start: of the subpath; control: last control point, with its kind (C or Q)."""

    def __init__(self, text):
        self.text, self.position = text, 0
        self.curves, self.pieces = [], []
        self.at = self.start = np.zeros(2)
        self.control = None
        command = None
        while self.text[self.position:].strip(" \t\r\n,"):
            found = COMMAND.match(self.text, self.position)
            if found:
                command, self.position = found.group(1), found.end()
            elif command in (None, "Z", "z"):
                raise self.wrong("a command")
            self.follow(command)
            command = {"M": "L", "m": "l"}.get(command, command)  # more pairs after a move are lines
        self.end_curve(False)

    def wrong(self, what):
        return Problem(f'the path has "{self.text[self.position:self.position + 20].strip()}" where {what} is expected.')

    def number(self, pattern=NUMBER):
        found = pattern.match(self.text, self.position)
        if found is None:
            raise self.wrong("a number")
        self.position = found.end()
        return float(found.group(1))

    def end_curve(self, closed):
        if self.pieces:
            self.curves.append(Curve(self.pieces, closed))
        self.pieces = []

    def add(self, piece, end):
        self.pieces.append(piece)
        self.at = np.asarray(end, dtype=float)

    def follow(self, command):
        """One command with its numbers."""
        kind, origin = command.upper(), self.at if command.islower() else np.zeros(2)
        if kind == "A":
            self.follow_arc(origin)
            return
        values = [self.number() for _ in range(COUNT[kind])]
        control, self.control = self.control, None
        if kind == "Z":
            self.close()
        elif kind in "HV":
            end = self.at.copy()
            axis = "HV".index(kind)
            end[axis] = values[0] + origin[axis]
            self.add(line(self.at, end), end)
        else:
            points = np.reshape(values, (-1, 2)) + origin
            if kind == "M":
                self.end_curve(False)
                self.at = self.start = points[0]
            elif kind == "L":
                self.add(line(self.at, points[0]), points[0])
            else:
                self.follow_bezier(kind, points, control)

    def follow_bezier(self, kind, points, control):
        """A Bezier curve; that of S and T begins in the direction in which the one before it ended."""
        order = "C" if kind in "CS" else "Q"
        if kind in "ST":
            mirrored = 2.0 * self.at - control[1] if control and control[0] == order else self.at
            points = np.vstack([mirrored, points])
        piece = np.vstack([self.at, points])
        self.control = (order, piece[-2])
        self.add(piece, piece[-1])

    def follow_arc(self, origin):
        radii = [self.number(), self.number()]
        rotation, large, sweep = self.number(), self.number(FLAG), self.number(FLAG)
        end = np.array([self.number(), self.number()]) + origin
        self.control = None
        self.add(arc_between(self.at, end, radii, rotation, large == 1.0, sweep == 1.0), end)

    def close(self):
        if self.pieces and np.any(self.at != self.start):
            self.pieces.append(line(self.at, self.start))
        self.end_curve(True)
        self.at = self.start


def ellipse(x, y, rx, ry):
    """An ellipse as a Curve."""
    return Curve([Arc([x, y], np.diag([rx, ry]), 0.0, 2.0 * math.pi)], True)


def rectangle(x, y, width, height, rx, ry):
    """A rectangle with rounded corners as a Curve."""
    if rx == 0.0 or ry == 0.0:
        corners = [(x, y), (x + width, y), (x + width, y + height), (x, y + height)]
        return Curve([line(corners[k], corners[(k + 1) % 4]) for k in range(4)], True)
    return read_path(f"M {x + rx!r} {y!r} h {width - 2 * rx!r} a {rx!r} {ry!r} 0 0 1 {rx!r} {ry!r} v {height - 2 * ry!r} "
                     f"a {rx!r} {ry!r} 0 0 1 {-rx!r} {ry!r} h {2 * rx - width!r} a {rx!r} {ry!r} 0 0 1 {-rx!r} {-ry!r} "
                     f"v {2 * ry - height!r} a {rx!r} {ry!r} 0 0 1 {rx!r} {-ry!r} z")[0]


def polygon(numbers, closed):
    """Points x, y, x, y ... as a Curve; None where there are less than two."""
    points = np.reshape(numbers[:len(numbers) // 2 * 2], (-1, 2))
    if len(points) < 2:
        return None
    ends = np.vstack([points[1:], points[:1]]) if closed else points[1:]
    return Curve([line(begin, end) for begin, end in zip(points, ends)], closed)


def piece_points(piece, matrix, tolerance):
    """Points (n, 2) of a transformed piece after its first one, on the curve and at most the tolerance away from it between them.
    matrix (2, 3)"""
    linear, shift = matrix[:, :2], matrix[:, 2]
    if isinstance(piece, Arc):
        return Arc(linear @ piece.centre + shift, linear @ piece.axes, piece.first, piece.last).at(arc_angles(piece, linear, tolerance))
    control = piece @ linear.T + shift
    if len(control) == 2:
        return control[1:]
    order, steps = len(control) - 1, math.ceil(steps_of(piece, linear, tolerance))
    t = np.arange(1, steps + 1)[:, None] / steps
    weights = [math.comb(order, k) * t**k * (1.0 - t) ** (order - k) for k in range(order + 1)]
    return sum(weight * point for weight, point in zip(weights, control))


def steps_of(piece, linear, tolerance):
    """Into how many edges a piece of a transformed curve is divided, before it is rounded up; a number, as it can be too large for a count. linear (2, 2)"""
    if isinstance(piece, Arc):
        largest = np.linalg.norm(linear @ piece.axes, 2)
        if largest == 0.0:
            return max(1.0, abs(piece.last - piece.first) / math.pi)
        # A chord over an angle a is r (1 - cos(a / 2)) = 2 r sin(a / 4)^2 away from the circle; for small angles the cosine would have no digits.
        step = min(4.0 * math.asin(min(1.0, math.sqrt(0.5 * tolerance / largest))), math.radians(60.0))
        return max(1.0, (1.0 - 1e-12) * abs(piece.last - piece.first) / step)  # rounding must not add an edge
    order = len(piece) - 1
    if order == 1:
        return 1.0
    bend = np.max(np.linalg.norm((piece[:-2] - 2.0 * piece[1:-1] + piece[2:]) @ linear.T, axis=1))
    # The chord of a step dt is at most dt^2 / 8 times the second derivative away, which is at most order (order - 1) bend.
    return max(1.0, math.sqrt(order * (order - 1) * bend / (8.0 * tolerance)))


def arc_angles(piece, linear, tolerance):
    """Angles (n) of the points of an arc after its first one."""
    steps = math.ceil(steps_of(piece, linear, tolerance))
    return piece.first + (piece.last - piece.first) * np.arange(1, steps + 1) / steps


def curve_points(curve, matrix, tolerance):
    """Points (n, 2) of a transformed curve, its first one too."""
    first = curve.pieces[0]
    begin = first.at(np.array([first.first])) if isinstance(first, Arc) else first[:1]
    return np.vstack([begin @ matrix[:, :2].T + matrix[:, 2], *(piece_points(piece, matrix, tolerance) for piece in curve.pieces)])
