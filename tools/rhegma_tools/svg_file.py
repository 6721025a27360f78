"""Reads the shapes of an SVG drawing: curves, how they are filled, and where they are on the page."""

import math
import re

import numpy as np

from rhegma.problem import Problem
from rhegma.scene import read_xml

from .svg_path import ellipse, polygon, read_path, rectangle

PIXEL = 0.0254 / 96.0  # [m], as CSS defines it
METRES = {"": PIXEL, "px": PIXEL, "pt": 0.0254 / 72.0, "pc": 0.0254 / 6.0, "in": 0.0254, "mm": 1e-3, "cm": 1e-2, "Q": 0.25e-3, "m": 1.0}
LENGTH = re.compile(r"\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*([A-Za-z%]*)\s*")
CALL = re.compile(r"(\w+)\s*\(([^)]*)\)")
NOT_DRAWN = {"defs", "symbol", "clipPath", "mask", "pattern", "marker", "metadata", "title", "desc", "style", "script", "linearGradient",
             "radialGradient", "filter", "namedview", "view"}
GROUPS = {"g", "a", "svg", "switch"}
SHAPES = {"path", "rect", "circle", "ellipse", "polygon", "polyline", "line"}
IDENTITY = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])


class Shape:
    """curves: of one element; matrix (2, 3): to the page; even_odd: its fill rule; filled: whether it is filled, not only an outline"""

    def __init__(self, curves, matrix, even_odd, filled):
        self.curves, self.matrix, self.even_odd, self.filled = curves, matrix, even_odd, filled


class Drawing:
    """shapes, with matrices to metres from the lower left corner of the page, y upwards; skipped: {name of an element: how many of them
    were left out}; sized: whether the drawing has its size in a unit of length."""

    def __init__(self, shapes, skipped, sized):
        self.shapes, self.skipped, self.sized = shapes, skipped, sized


def name_of(element):
    """The name of an element without its namespace; empty for comments."""
    return element.tag.rpartition("}")[2] if isinstance(element.tag, str) else ""


def length(text, where):
    """(number, unit) of a length."""
    found = LENGTH.fullmatch(text)
    if found is None or found.group(2) not in (*METRES, "%"):
        raise Problem(f'{where} is "{text}"; only numbers in px, pt, pc, in, mm, cm, m or without a unit are read.')
    return float(found.group(1)), found.group(2)


def in_units(element, name, default=0.0):
    """A length of an element in units of its coordinates."""
    text = element.get(name)
    if text is None or text.strip() == "auto":
        return default
    number, unit = length(text, f"{name} of a {name_of(element)}")
    if unit == "%":
        raise Problem(f'{name} of a {name_of(element)} is "{text}"; a fraction of the page is not read.')
    return number if unit == "" else number * METRES[unit] / PIXEL


def product(outer, inner):
    """The matrix (2, 3) of the inner transform followed by the outer one."""
    return np.column_stack([outer[:, :2] @ inner[:, :2], outer[:, :2] @ inner[:, 2] + outer[:, 2]])


def transform_of(text):
    """The matrix (2, 3) of an attribute transform."""
    matrix = IDENTITY
    for name, arguments in CALL.findall(text or ""):
        try:
            matrix = product(matrix, one_transform(name, [float(one) for one in arguments.replace(",", " ").split()]))
        except (ValueError, IndexError):
            raise Problem(f'the transform "{text}" can\'t be read.')
    return matrix


def one_transform(name, v):
    """The matrix of one function of a transform; a ValueError or IndexError where it is none."""
    if name == "matrix" and len(v) == 6:
        return np.array([[v[0], v[2], v[4]], [v[1], v[3], v[5]]])
    if name == "translate":
        return np.array([[1.0, 0.0, v[0]], [0.0, 1.0, v[1] if len(v) > 1 else 0.0]])
    if name == "scale":
        return np.array([[v[0], 0.0, 0.0], [0.0, v[1] if len(v) > 1 else v[0], 0.0]])
    if name == "rotate":
        cosine, sine = math.cos(math.radians(v[0])), math.sin(math.radians(v[0]))
        x, y = v[1:3] if len(v) == 3 else (0.0, 0.0)
        return np.array([[cosine, -sine, x - cosine * x + sine * y], [sine, cosine, y - sine * x - cosine * y]])
    if name == "skewX":
        return np.array([[1.0, math.tan(math.radians(v[0])), 0.0], [0.0, 1.0, 0.0]])
    if name == "skewY":
        return np.array([[1.0, 0.0, 0.0], [math.tan(math.radians(v[0])), 1.0, 0.0]])
    raise ValueError(name)


def page_matrix(root, unit=None):
    """(matrix (2, 3) from the coordinates of the drawing to metres with y upwards, whether the drawing has its size in a unit of length).
    unit: metres of one unit of the coordinates, instead of what the drawing says"""
    sizes = [length(root.get(name) or "100%", f"{name} of the drawing") for name in ("width", "height")]
    known = all(u != "%" for _, u in sizes)
    sized = all(u not in ("", "px", "%") for _, u in sizes)
    box = [float(one) for one in (root.get("viewBox") or "").replace(",", " ").split()]
    if box and (len(box) != 4 or min(box[2:]) <= 0.0):
        raise Problem(f'the viewBox "{root.get("viewBox")}" of the drawing is not four numbers with a width and a height above zero.')
    metres = [number * METRES.get(u, PIXEL) for number, u in sizes]
    if not box:  # coordinates are pixels
        x, y, factors = 0.0, metres[1] / PIXEL if known else 0.0, [PIXEL, PIXEL]
    else:
        x, y = box[0], box[1] + box[3]
        factors = [metres[0] / box[2], metres[1] / box[3]] if known else [PIXEL, PIXEL]
        if not (root.get("preserveAspectRatio") or "").strip().startswith("none"):
            factors = 2 * [min(factors)]
    if unit is not None:
        factors, sized = [unit, unit], True
    return np.array([[factors[0], 0.0, -factors[0] * x], [0.0, -factors[1], factors[1] * y]]), sized


def properties_of(element, inherited):
    """{property: value} of an element: attributes, the attribute style, and what it inherits."""
    own = {name: element.get(name).strip() for name in ("fill", "fill-rule", "display", "visibility") if element.get(name)}
    for part in (element.get("style") or "").split(";"):
        name, colon, value = part.partition(":")
        if colon:
            own[name.strip()] = value.strip()
    passed_on = {name: value for name, value in inherited.items() if name != "display"}
    return {**passed_on, **{name: value for name, value in own.items() if value != "inherit"}}


def curves_of(element):
    """The curves of an element that is a shape."""
    name = name_of(element)
    if name == "path":
        return read_path(element.get("d") or "")
    if name in ("polygon", "polyline"):
        try:
            numbers = [float(one) for one in (element.get("points") or "").replace(",", " ").split()]
        except ValueError:
            raise Problem(f"points of a {name} are no numbers.")
        return [curve for curve in [polygon(numbers, name == "polygon")] if curve]
    if name == "line":
        return [polygon([in_units(element, one) for one in ("x1", "y1", "x2", "y2")], False)]
    if name == "rect":
        width, height = in_units(element, "width"), in_units(element, "height")
        rx, ry = in_units(element, "rx", None), in_units(element, "ry", None)
        rx, ry = ry if rx is None else rx, rx if ry is None else ry
        radii = [min(rx or 0.0, 0.5 * width), min(ry or 0.0, 0.5 * height)]
        return [rectangle(in_units(element, "x"), in_units(element, "y"), width, height, *radii)] if width > 0.0 < height else []
    rx, ry = (in_units(element, one) for one in (("r", "r") if name == "circle" else ("rx", "ry")))
    return [ellipse(in_units(element, "cx"), in_units(element, "cy"), rx, ry)] if rx > 0.0 < ry else []


class Reader:
    """Collects shapes from an element and those in it."""

    def __init__(self, root):
        self.shapes, self.skipped, self.root = [], {}, root
        self.known = {element.get("id"): element for element in root.iter() if element.get("id")}

    def skip(self, name):
        self.skipped[name] = self.skipped.get(name, 0) + 1

    def read(self, element, matrix, inherited, depth=0):
        """depth: of elements within each other, which ends those that refer to themselves"""
        name = name_of(element)
        properties = properties_of(element, inherited)
        if not name or name in NOT_DRAWN or properties.get("display") == "none":
            return
        if depth > 100:
            raise Problem("elements of the drawing are nested more than 100 times.")
        if element is not self.root:
            matrix = product(matrix, transform_of(element.get("transform")))
        if name in SHAPES:
            if properties.get("visibility") not in ("hidden", "collapse"):
                filled = properties.get("fill") not in ("none", "transparent") and name != "line"
                self.shapes.append(Shape(curves_of(element), matrix, properties.get("fill-rule") == "evenodd", filled))
        elif name == "use":
            self.read_use(element, matrix, properties, depth)
        elif name == "svg" and element is not self.root:
            self.skip("svg in another svg")
        elif name in GROUPS:
            for child in element:
                self.read(child, matrix, properties, depth + 1)
        else:
            self.skip(name)

    def read_use(self, element, matrix, properties, depth):
        """A copy of another element."""
        target = element.get("href") or element.get("{http://www.w3.org/1999/xlink}href") or ""
        other = self.known.get(target.lstrip("#"))
        if other is None:
            raise Problem(f'the drawing uses "{target}", which is not in it.')
        shift = np.array([[1.0, 0.0, in_units(element, "x")], [0.0, 1.0, in_units(element, "y")]])
        self.read(other, product(matrix, shift), properties, depth + 1)


def read_drawing(path, unit=None):
    """The Drawing of an SVG file. unit: metres of one unit of its coordinates, instead of what it says. A Problem where it can't be read."""
    root = read_xml(path, "drawing")
    if name_of(root) != "svg":
        raise Problem(f"{path} is no SVG drawing: its top is {root.tag}.")
    try:
        matrix, sized = page_matrix(root, unit)
        reader = Reader(root)
        reader.read(root, matrix, {})
    except Problem as problem:
        raise Problem(f"{path}: {problem}")
    if any(name_of(element) == "style" and "fill" in (element.text or "") for element in root.iter()):
        reader.skip("style sheet")
    return Drawing(reader.shapes, reader.skipped, sized)
