"""Transforms of elements of SVG drawings: the attribute transform, or the property of the attribute style, which comes first."""

import math
import re

import numpy as np

from rhegma.problem import Problem

PIXEL = 0.0254 / 96.0  # [m], as CSS defines it
METRES = {"": PIXEL, "px": PIXEL, "pt": 0.0254 / 72.0, "pc": 0.0254 / 6.0, "in": 0.0254, "mm": 1e-3, "cm": 1e-2, "Q": 0.25e-3, "m": 1.0}
DEGREES = {"": 1.0, "deg": 1.0, "grad": 0.9, "rad": math.degrees(1.0), "turn": 360.0}
PURE = {"": 1.0}
PIXELS = {unit: factor / PIXEL for unit, factor in METRES.items()}
CALL = re.compile(r"[\s,]*(\w+)\s*\(([^)]*)\)[\s,]*")
NUMBER = re.compile(r"([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)([A-Za-z]*)")
IDENTITY = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
NOT_READ = ("translate", "rotate", "scale", "offset-path")  # properties that move an element, too


def style_of(element):
    """{property: value} of the attribute style of an element."""
    parts = (part.partition(":") for part in (element.get("style") or "").split(";"))
    return {name.strip(): value.replace("!important", "").strip() for name, colon, value in parts if colon}


def product(outer, inner):
    """The matrix (2, 3) of the inner transform followed by the outer one."""
    return np.column_stack([outer[:, :2] @ inner[:, :2], outer[:, :2] @ inner[:, 2] + outer[:, 2]])


def shift(x, y):
    """The matrix (2, 3) of a translation."""
    return np.array([[1.0, 0.0, x], [0.0, 1.0, y]])


def numbers_of(text, *units):
    """The numbers of a list; each has one of its own units {unit: factor}, the last of which are those of all further ones. A ValueError where it is
    none."""
    numbers = []
    for word in text.replace(",", " ").split():
        found, known = NUMBER.fullmatch(word), units[min(len(numbers), len(units) - 1)]
        if found is None or found.group(2) not in known:
            raise ValueError(word)
        numbers.append(float(found.group(1)) * known[found.group(2)])
    return numbers


def transform_of(text):
    """The matrix (2, 3) of the text of a transform."""
    matrix, position = IDENTITY, 0
    if text is None or text.strip() in ("", "none"):
        return matrix
    while position < len(text):
        found = CALL.match(text, position)
        try:
            matrix = product(matrix, one_transform(*found.groups()))
        except (AttributeError, ValueError, IndexError):
            raise Problem(f'the transform "{text}" can\'t be read.')
        position = found.end()
    return matrix


def one_transform(name, text):
    """The matrix of one function of a transform; a ValueError or IndexError where it is none."""
    if name == "matrix":
        a, b, c, d, e, f = numbers_of(text, *4 * [PURE], PIXELS)
        return np.array([[a, c, e], [b, d, f]])
    if name in ("translate", "translateX", "translateY"):
        v = numbers_of(text, PIXELS)
        return shift(0.0, v[0]) if name.endswith("Y") else shift(v[0], v[1] if len(v) > 1 else 0.0)
    if name in ("scale", "scaleX", "scaleY"):
        v = numbers_of(text, PURE)
        x, y = {"scale": (v[0], v[-1]), "scaleX": (v[0], 1.0), "scaleY": (1.0, v[0])}[name]
        return np.array([[x, 0.0, 0.0], [0.0, y, 0.0]])
    if name == "rotate":
        v = numbers_of(text, DEGREES, PIXELS)
        cosine, sine = math.cos(math.radians(v[0])), math.sin(math.radians(v[0]))
        x, y = v[1:3] if len(v) == 3 else (0.0, 0.0)
        return np.array([[cosine, -sine, x - cosine * x + sine * y], [sine, cosine, y - sine * x - cosine * y]])
    if name in ("skew", "skewX", "skewY"):
        v = numbers_of(text, DEGREES)
        x, y = {"skew": (v[0], v[1] if len(v) > 1 else 0.0), "skewX": (v[0], 0.0), "skewY": (0.0, v[0])}[name]
        return np.array([[1.0, math.tan(math.radians(x)), 0.0], [math.tan(math.radians(y)), 1.0, 0.0]])
    raise ValueError(name)


def transform_of_element(element):
    """The matrix (2, 3) of an element. A Problem where it is moved in a way that is not read."""
    style = style_of(element)
    own = {name: style.get(name, element.get(name)) for name in ("transform", "transform-origin", "transform-box")}
    for name in NOT_READ:
        if style.get(name, "none") != "none":
            raise Problem(f'the style "{name}: {style[name]}" is not read; write it as transform.')
    matrix = transform_of(own["transform"])
    if np.array_equal(matrix, IDENTITY):
        return matrix
    if own["transform-box"] not in (None, "view-box"):
        raise Problem(f'transform-box "{own["transform-box"]}" is not read; give the transform without it.')
    try:
        origin = numbers_of(own["transform-origin"] or "0 0", PIXELS)
        x, y = origin[:2]
    except ValueError:
        raise Problem(f'transform-origin "{own["transform-origin"]}" is not read; write it as two numbers.')
    return product(product(shift(x, y), matrix), shift(-x, -y))
