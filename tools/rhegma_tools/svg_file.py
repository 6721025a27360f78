"""Reads the shapes of an SVG drawing: curves, how they are filled, and where they are on the page."""

import re

import numpy as np

from rhegma.problem import Problem
from rhegma.scene import read_xml

from .svg_path import ellipse, polygon, read_path, rectangle
from .svg_transform import METRES, PIXEL, product, shift, style_of, transform_of_element

LENGTH = re.compile(r"\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*([A-Za-z%]*)\s*")
PATH_DATA = re.compile(r"path\(\s*(['\"])(.*)\1\s*\)", re.DOTALL)
# Properties that change what is drawn.
IN_A_SHEET = re.compile(r"(?<![\w-])(fill|fill-rule|display|visibility|transform|transform-origin|clip-path|mask|translate|rotate|scale|x|y|width|height|"
                        r"cx|cy|r|rx|ry|d)\s*:")
NOT_DRAWN = {"defs", "symbol", "clipPath", "mask", "pattern", "marker", "metadata", "title", "desc", "style", "script", "linearGradient",
             "radialGradient", "filter", "namedview", "view"}
GROUPS = {"g", "a", "svg", "switch"}
SHAPES = {"path", "rect", "circle", "ellipse", "polygon", "polyline", "line"}


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
    """A length of an element in units of its coordinates, from its style or, without one, its attribute."""
    text = style_of(element).get(name, element.get(name))
    if text is None or text.strip() == "auto":
        return default
    number, unit = length(text, f"{name} of a {name_of(element)}")
    if unit == "%":
        raise Problem(f'{name} of a {name_of(element)} is "{text}"; a fraction of the page is not read.')
    return number if unit == "" else number * METRES[unit] / PIXEL


def page_matrix(root, unit=None):
    """(matrix (2, 3) from the coordinates of the drawing to metres with y upwards, whether the drawing has its size in a unit of length).
    unit: metres of one unit of the coordinates, instead of what the drawing says"""
    sizes = [length(root.get(name) or "100%", f"{name} of the drawing") for name in ("width", "height")]
    known = all(u != "%" for _, u in sizes)
    sized = all(u not in ("", "px", "%") for _, u in sizes)
    box = view_box(root, "the drawing")
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


def symbol_matrix(symbol, use):
    """The matrix (2, 3) from the coordinates of a symbol to those of the element that uses it: into the middle of its width and height, if the symbol has
    a viewBox."""
    if symbol.get("viewBox") is None:
        return shift(0.0, 0.0)
    x, y, *size = view_box(symbol, "a symbol")
    sides = [in_units(use, name, in_units(symbol, name)) for name in ("width", "height")]
    aspect = (symbol.get("preserveAspectRatio") or "xMidYMid meet").split()
    if min(sides) <= 0.0 or aspect not in (["none"], ["xMidYMid"], ["xMidYMid", "meet"]):
        raise Problem(f'the symbol "{symbol.get("id")}" has a viewBox; it is read if the element use has a width and a height above zero, and without '
                      "preserveAspectRatio.")
    factors = [side / own for side, own in zip(sides, size)]
    if aspect != ["none"]:
        factors = 2 * [min(factors)]
    return np.array([[factors[0], 0.0, 0.5 * (sides[0] - factors[0] * size[0]) - factors[0] * x],
                     [0.0, factors[1], 0.5 * (sides[1] - factors[1] * size[1]) - factors[1] * y]])


def view_box(element, what):
    """The four numbers of the viewBox of an element; none where it has none. what: its name in the message of the Problem"""
    text = element.get("viewBox") or ""
    try:
        box = [float(one) for one in text.replace(",", " ").split()]
    except ValueError:
        box = [0.0]
    if box and (len(box) != 4 or not min(box[2:]) > 0.0):
        raise Problem(f'the viewBox "{text}" of {what} is not four numbers with a width and a height above zero.')
    return box


def properties_of(element, inherited):
    """{property: value} of an element: attributes, the attribute style, and what it inherits."""
    own = {name: element.get(name).strip() for name in ("fill", "fill-rule", "display", "visibility") if element.get(name)}
    own.update(style_of(element))
    passed_on = {name: value for name, value in inherited.items() if name != "display"}
    return {**passed_on, **{name: value for name, value in own.items() if value != "inherit"}}


def curves_of(element):
    """The curves of an element that is a shape."""
    name = name_of(element)
    if name == "path":
        own = style_of(element).get("d")
        data = None if own is None else PATH_DATA.fullmatch(own)
        if own is not None and data is None:
            raise Problem(f'the style "d: {own}" of a path can\'t be read.')
        return read_path(data.group(2) if data else element.get("d") or "")
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
            matrix = product(matrix, transform_of_element(element))
        self.name_what_cuts(element)
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
        matrix = product(matrix, shift(in_units(element, "x"), in_units(element, "y")))
        if name_of(other) != "symbol":
            self.read(other, matrix, properties, depth + 1)
            return
        properties = properties_of(other, properties)
        if properties.get("display") == "none":
            return
        self.name_what_cuts(other)
        matrix = product(product(matrix, transform_of_element(other)), symbol_matrix(other, element))
        for child in other:
            self.read(child, matrix, properties, depth + 2)

    def name_what_cuts(self, element):
        """Counts what would draw an element only in part."""
        style = style_of(element)
        for name in ("clip-path", "mask"):
            if style.get(name, element.get(name) or "none") != "none":
                self.skip(name)


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
    if any(name_of(element) == "style" and IN_A_SHEET.search(element.text or "") for element in root.iter()):
        reader.skip("style sheet")
    if not reader.shapes:
        left_out = ", ".join(f"{name} ({count})" for name, count in sorted(reader.skipped.items()))
        raise Problem(f"{path}: the drawing has no shapes" + (f" that are read; it has {left_out}." if left_out else "."))
    return Drawing(reader.shapes, reader.skipped, sized)
