"""Outlines of the bodies' shapes as the scene gives them: lines (k, 3) in m, those of shapes that are cut away apart."""

import numpy as np

from .part_lines import part_lines
from .scene_symbols import spatial
from .scene_values import array, lists, number
from .voxel_file import voxel_lines

ROUND = np.linspace(0.0, 2.0 * np.pi, 97)


class Outline:
    """lines: arrays (k, 3); cut: of a shape that is cut away; tool: name of the rigid tool that it is of, "" of a body"""

    def __init__(self, lines, cut, tool=""):
        self.lines, self.cut, self.tool = lines, cut, tool


def closed(points):
    return np.vstack([points, points[:1]])


def circle(centre, one, two):
    """A circle from two perpendicular vectors as long as its radius."""
    return centre + np.outer(np.cos(ROUND), one) + np.outer(np.sin(ROUND), two)


def prism(low, high):
    """Edges of a prism between two polygons (k, 3) with as many corners."""
    return [closed(low), closed(high)] + [np.stack([a, b]) for a, b in zip(low, high)]


def box_lines(values, dimension):
    low, high = spatial(array(values, "Lower Corner")), spatial(array(values, "Upper Corner"))
    flat = np.array([[low[0], low[1]], [high[0], low[1]], [high[0], high[1]], [low[0], high[1]]])
    if dimension == 2:
        return [closed(np.c_[flat, np.zeros(4)])]
    return prism(np.c_[flat, np.full(4, low[2])], np.c_[flat, np.full(4, high[2])])


def ball_lines(values, dimension):
    centre, radius = spatial(array(values, "Centre")), number(values, "Radius")
    x, y, z = radius * np.eye(3)
    return [circle(centre, x, y)] if dimension == 2 else [circle(centre, x, y), circle(centre, y, z), circle(centre, z, x)]


def cylinder_lines(values, dimension):
    start, end, radius = spatial(array(values, "From")), spatial(array(values, "To")), number(values, "Radius")
    along = (end - start) / np.linalg.norm(end - start)
    one = np.cross(along, np.eye(3)[np.argmin(np.abs(along))])
    one *= radius / np.linalg.norm(one)
    two = np.cross(along, one)
    sides = [np.stack([start + arm, end + arm]) for arm in (one, -one, two, -two)]
    return [circle(start, one, two), circle(end, one, two), *sides]


def polygon_lines(values, dimension):
    flat = np.array(array(values, "Points")).reshape(-1, 2)
    if dimension == 2:
        return [closed(np.c_[flat, np.zeros(len(flat))])]
    return prism(*(np.c_[flat, np.full(len(flat), number(values, name))] for name in ("Bottom", "Top")))


def file_lines(values, dimension):
    """values: with the whole path of the file, as those of a Scene"""
    scale, origin = number(values, "Scale", 1.0), spatial(array(values, "Origin", [0.0] * dimension))
    return [origin + scale * line for line in part_lines(values.get("File", ""), dimension)]


def voxels_lines(values, dimension):
    """values: with the whole path of the file, as those of a Scene"""
    size, corner = number(values, "Voxel Size"), spatial(array(values, "Corner", [0.0] * dimension))
    lines, count = voxel_lines(values.get("File", ""), number(values, "Value"))
    values.setdefault("Rotation Centre", list((corner + 0.5 * size * count)[:dimension]))  # of the image, for all of its values
    return [corner + size * line for line in lines]


SHAPES = {"Box": box_lines, "Ball": ball_lines, "Cylinder": cylinder_lines, "Polygon": polygon_lines, "File": file_lines, "Voxels": voxels_lines}


def rotated(lines, values, dimension):
    """Lines of a shape after its rotation."""
    angle = np.radians(number(values, "Rotation", 0.0))
    if not angle or not lines:
        return lines
    everything = np.vstack(lines)
    centre = spatial(array(values, "Rotation Centre", 0.5 * (everything.min(axis=0) + everything.max(axis=0))))
    axis = np.array(array(values, "Rotation Axis", [0.0, 0.0, 1.0]) if dimension == 3 else [0.0, 0.0, 1.0])
    axis = axis / np.linalg.norm(axis)
    turned = []
    for line in lines:
        arm = line - centre
        across = np.cross(axis, arm)
        turned.append(centre + arm * np.cos(angle) + across * np.sin(angle) + np.outer(arm @ axis, axis) * (1.0 - np.cos(angle)))
    return turned


def outlines_of(values, dimension):
    """Outlines of all shapes of bodies and rigid tools."""
    found = []
    for section in ("Bodies", "Rigid Tools"):
        for name, one in lists(values, section):
            shapes = [(one, False)] + [(shape, shape.get("Operation") == "Cut") for _, shape in lists(one, "Operations")]
            for shape, cut in shapes:
                if shape.get("Shape") in SHAPES:
                    shape = dict(shape)
                    lines = rotated(SHAPES[shape["Shape"]](shape, dimension), shape, dimension)
                    found.append(Outline(lines, cut, name if section == "Rigid Tools" else ""))
    return found
