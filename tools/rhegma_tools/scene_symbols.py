"""What acts on the bodies of a scene, as symbols with labels: loads, supports, heat, motion at the start. All positions are in m, with three
coordinates; in 2D the third is zero."""

import numpy as np

from . import boxes
from .report_facts import readable
from .scene_values import array, lists, number

LOAD, SUPPORT, HEAT, MOTION, TOOL = "load", "support", "heat", "motion", "tool"
ALONG_LINE, ALONG_EDGE = 7, 3  # arrows of a traction: on a line, and along each edge of a parallelogram
ON_SURFACE = 16  # at most, on a choice of a body's surface


class Arrows:
    """Arrows of one length in a direction (3). points (k, 3); into: their heads are at the points, else their tails; kind: what they are."""

    def __init__(self, kind, name, label, points, direction, into=False):
        self.kind, self.name, self.label, self.into = kind, name, label, into
        self.points, self.direction = np.atleast_2d(points), np.asarray(direction) / np.linalg.norm(direction)


class Nodes:
    """Supported nodes of the grid (k, 3). axes: those of the prescribed components, such as "xy"; held: they are at rest."""

    def __init__(self, kind, name, label, points, axes, held=True):
        self.kind, self.name, self.label, self.points, self.axes, self.held = kind, name, label, points, axes, held


class Plane:
    """A plane of symmetry. axis: its normal; position [m]"""

    def __init__(self, name, label, axis, position):
        self.kind, self.name, self.label, self.axis, self.position = SUPPORT, name, label, axis, position


class Region:
    """A heated region: a ball where low is None (centre, radius), else a box (low, high)."""

    def __init__(self, name, label, centre, radius=None, low=None, high=None):
        self.kind, self.name, self.label = HEAT, name, label
        self.centre, self.radius, self.low, self.high = centre, radius, low, high


class Mark:
    """A single position with a label, such as a probe."""

    def __init__(self, kind, name, label, point):
        self.kind, self.name, self.label, self.point = kind, name, label, point


def spatial(values):
    """Coordinates with a third one of zero in 2D."""
    return None if values is None else np.array((list(values) + [0.0])[:3])


def peak(values, name="History"):
    """(factor, words) of a history: its value of largest magnitude where it is a constant or a table, else 1 and that it varies."""
    text = str(values.get(name, "1")).strip()
    try:
        return float(text), ""
    except ValueError:
        pass
    try:
        pairs = [tuple(float(number) for number in pair.split(":")) for pair in text.split(",")]
    except ValueError:
        pairs = []
    if not pairs or any(len(pair) != 2 for pair in pairs):
        return 1.0, " × f(t)"  # an expression
    return max((factor for _, factor in pairs), key=abs), " at most"


def with_value(vector, unit, values):
    """(direction, label) of a vector with its history."""
    factor, words = peak(values)
    vector = factor * spatial(vector)
    return vector, readable(float(np.linalg.norm(vector)), unit) + words


def has_material(fields, point):
    """Whether a position lies in a particle's box."""
    half = np.stack([boxes.reach(fields.boxes(), axis) for axis in range(3)], axis=1) * (1.0 + 1.0e-6)
    return bool((np.abs(fields.position - point)[:, :fields.dimension] <= half[:, :fields.dimension]).all(axis=1).any())


def arrows(kind, name, label, points, direction, fields, into=None):
    """Arrows at a surface: with their heads on it where they point into the body, else with their tails. direction: (3), or (k, 3) one for each
    point, along the normals; then a list, of which the first has the label. into: where it is known; else the particles say so"""
    points = np.atleast_2d(points)
    if not np.any(direction) or len(points) == 0:
        return Mark(kind, name, label, np.mean(points if len(points) else fields.position, axis=0))
    if np.ndim(direction) == 2:
        def points_into(point, one):
            return has_material(fields, point + 0.6 * fields.size * one / np.linalg.norm(one)) if into is None else into

        return [Arrows(kind, name, "" if k else label, point, one, points_into(point, one)) for k, (point, one) in enumerate(zip(points, direction))]
    unit = direction / np.linalg.norm(direction)
    return Arrows(kind, name, label, points, direction, has_material(fields, points[len(points) // 2] + 0.6 * fields.size * unit))


def spread(points, most):
    """Indices of at most so many points (k, 3) that are far from one another: each next one is the farthest from all that are chosen."""
    if len(points) <= most:
        return np.arange(len(points))
    chosen = [int(np.argmax(np.linalg.norm(points - points.mean(axis=0), axis=1)))]
    away = np.linalg.norm(points - points[chosen[0]], axis=1)
    while len(chosen) < most:
        chosen.append(int(np.argmax(away)))
        away = np.minimum(away, np.linalg.norm(points - points[chosen[-1]], axis=1))
    return np.array(sorted(chosen))


def surface_points(values, chosen=None, count_line=ALONG_LINE):
    """(points (k, 3), normal into the body (3)) of a part of a surface: a line in 2D, a parallelogram in 3D; of a choice of the body's whole
    surface, whose entry of the summary is chosen, the normals (k, 3)."""
    if chosen:
        points, normals = (np.array([spatial(point) for point in chosen[name]]) for name in ("points", "normals"))
        drawn = spread(points, ON_SURFACE)
        return points[drawn], -normals[drawn]
    if values.get("Surface") == "Body":
        return np.zeros((0, 3)), np.zeros(3)  # of a program that does not say where it is
    if "From" in values:
        start, end = spatial(array(values, "From")), spatial(array(values, "To"))
        fraction = (np.arange(count_line) + 0.5)[:, None] / count_line
        along = end - start
        return start + fraction * along, np.array([-along[1], along[0], 0.0])
    corner, one, two = (np.array(array(values, name)) for name in ("Corner", "Edge 1", "Edge 2"))
    fraction = (np.arange(ALONG_EDGE) + 0.5) / ALONG_EDGE
    points = [corner + a * one + b * two for a in fraction for b in fraction]
    return np.array(points), -np.cross(one, two)


def traction(name, values, fields, chosen=None):
    points, inward = surface_points(values, chosen)
    if "Pressure" in values:
        factor, words = peak(values)
        pressure = factor * number(values, "Pressure", 0.0)
        return arrows(LOAD, name, readable(abs(pressure), "Pa") + words, points, np.sign(pressure) * inward, fields,
                      into=bool(pressure > 0.0) if chosen else None)
    if "Force" in values:
        direction, label = with_value(array(values, "Force"), "N", values)
        return arrows(LOAD, name, f"{label} in all", points, direction, fields)
    direction, label = with_value(array(values, "Stress"), "Pa", values)
    return arrows(LOAD, name, label, points, direction, fields)


def line_load(name, values, fields):
    start, end = spatial(array(values, "From")), spatial(array(values, "To"))
    direction, label = with_value(array(values, "Force"), "N", values)
    points = start + (np.arange(ALONG_LINE) + 0.5)[:, None] / ALONG_LINE * (end - start)
    return arrows(LOAD, name, f"{label} in all", points, direction, fields)


def point_load(name, values, fields):
    direction, label = with_value(array(values, "Force"), "N", values)
    return arrows(LOAD, name, label, spatial(array(values, "Point")), direction, fields)


def heat_flux(name, values, fields, chosen=None):
    points, inward = surface_points(values, chosen)
    factor, words = peak(values)
    flux = factor * number(values, "Flux", 0.0)
    return arrows(HEAT, name, readable(abs(flux), "W/m²") + words, points, np.sign(flux) * inward, fields)


def convection(name, values, fields, chosen=None):
    points, inward = surface_points(values, chosen)
    factor, words = peak(values)
    label = f"{readable(number(values, 'Coefficient'), 'W/(m² K)')}, {factor * number(values, 'Ambient Temperature', 0.0):.4g} K around{words}"
    return arrows(HEAT, name, label, points, inward, fields)


def gravity(name, values, fields):
    direction, label = with_value(array(values, "Acceleration"), "m/s²", values)
    return arrows(LOAD, name, label, fields.position.mean(axis=0), direction, fields)


LOADS = {"Line Load": line_load, "Point Load": point_load, "Gravity": gravity}
SURFACE = {"Traction": traction, "Heat Flux": heat_flux, "Convection": convection}


def grid_nodes(fields):
    """Corners (k, 3) of the cells that hold particles."""
    return np.unique(np.round(fields.leaves.corners.reshape(-1, 3), 15), axis=0) if fields.leaves is not None else np.zeros((0, 3))


def nodes_in(fields, values):
    """Nodes in the box of a boundary, or outside of it; those on its edge belong to both."""
    nodes = grid_nodes(fields)
    low, high = array(values, "Lower Corner"), array(values, "Upper Corner")
    part = nodes[:, :len(low)]
    rounding = 1.0e-6 * fields.size
    if values.get("Nodes") == "Outside":
        return nodes[((part <= np.array(low) + rounding) | (part >= np.array(high) - rounding)).any(axis=1)]
    return nodes[((part >= np.array(low) - rounding) & (part <= np.array(high) + rounding)).all(axis=1)]


def velocity(name, values, fields):
    """Symbols of a prescribed velocity: its nodes, and an arrow where they move in one direction."""
    axes = values.get("Components", "xyz"[:fields.dimension])
    nodes = nodes_in(fields, values)
    if "Field" in values:
        return [Nodes(MOTION, name, f"{axes} moved by v({', '.join('xyz'[:fields.dimension])}){peak(values)[1]}", nodes, axes, held=False)]
    value, label = with_value([v if axis in axes else 0.0 for axis, v in zip("xyz", array(values, "Value", [0.0] * 3))], "m/s", values)
    if not value.any():
        return [Nodes(SUPPORT, name, f"{axes} held", nodes, axes)]
    found = [Nodes(MOTION, name, "", nodes, axes, held=False)]
    if len(nodes):
        outermost = nodes[np.argmax(nodes @ value)]
        middle = np.where(value != 0.0, outermost, nodes.mean(axis=0))
        found.append(Arrows(MOTION, name, label, middle, value))
    return found


def symmetry(name, values, fields):
    axis, position = "xyz".index(values["Axis"]), number(values, "Position", 0.0)
    return Plane(name, f"plane of symmetry, {values['Axis']} held", axis, position)


def prescribed_temperature(name, values, fields):
    factor, words = peak(values)
    return Nodes(HEAT, name, f"{factor * number(values, 'Temperature', 0.0):.4g} K{words}", nodes_in(fields, values), "")


def boundary_symbols(values, fields, surfaces):
    """Symbols of the section Boundaries, in its order. surfaces: as for symbols_of"""
    found = []
    chosen = {entry["name"]: entry for entry in surfaces}
    for name, one in lists(values, "Boundaries"):
        kind = one.get("Type")
        if kind in SURFACE:
            symbols = SURFACE[kind](name, one, fields, chosen.get(name))
            found += symbols if isinstance(symbols, list) else [symbols]
        elif kind in LOADS:
            found.append(LOADS[kind](name, one, fields))
        elif kind == "Velocity":
            found += velocity(name, one, fields)
        elif kind == "Symmetry":
            found.append(symmetry(name, one, fields))
        elif kind == "Temperature":
            found.append(prescribed_temperature(name, one, fields))
    return found


def source_symbols(values, fields):
    """Symbols of heat sources, with an arrow where they move, and of probes."""
    found = []
    for name, one in lists(values, "Thermal", "Sources"):
        factor, words = peak(one)
        if one.get("Type") == "Box":
            low, high = spatial(array(one, "Lower Corner")), spatial(array(one, "Upper Corner"))
            label = readable(factor * number(one, "Power Density", 0.0), "W/m³") + words
            found.append(Region(name, label, 0.5 * (low + high), low=low, high=high))
            continue
        centre = spatial(array(one, "Centre"))
        found.append(Region(name, readable(factor * number(one, "Power", 0.0), "W") + words, centre, number(one, "Radius")))
        speed = spatial(array(one, "Velocity", [0.0, 0.0, 0.0]))
        if speed.any():
            found.append(Arrows(HEAT, name, f"moves at {readable(float(np.linalg.norm(speed)), 'm/s')}", centre, speed))
    for name, one in lists(values, "Thermal", "Probes"):
        found.append(Mark(HEAT, name, "probe", spatial(array(one, "Point"))))
    return found


def motion_symbols(values, fields):
    """Symbols of the velocities with which bodies start."""
    found = []
    for i, (name, one) in enumerate(lists(values, "Bodies")):
        position = fields.position[fields.body == i]
        speed, turn = spatial(array(one, "Velocity", [0.0] * 3)), array(one, "Angular Velocity", [0.0])
        if not len(position):
            continue
        if speed.any():
            found.append(Arrows(MOTION, name, f"starts at {readable(float(np.linalg.norm(speed)), 'm/s')}", position.mean(axis=0), speed))
        if any(turn):
            found.append(Mark(MOTION, name, f"starts with {readable(float(np.linalg.norm(turn)), 'rad/s')}", position.mean(axis=0)))
    return found


def tool_symbols(values, outlines):
    """Symbols of rigid tools: how each moves, at the middle of its outlines. outlines: {tool: arrays of lines (k, 3)}"""
    found = []
    for name, one in lists(values, "Rigid Tools"):
        points = np.vstack(outlines[name]) if outlines.get(name) else np.zeros((1, 3))
        middle = 0.5 * (points.min(axis=0) + points.max(axis=0))
        speed, turn = spatial(array(one, "Velocity", [0.0] * 3)), array(one, "Angular Velocity", [0.0])
        factor, words = peak(one)
        mass = number(one, "Mass")
        push, force_words = peak(one, "Force History")
        force = push * spatial(array(one, "Force", [0.0] * 3))
        parts = [] if mass is None else [f"{mass * 1e3:.4g} g" if mass < 1.0 else f"{mass:.4g} kg"]
        if speed.any():
            parts.append(f"{'starts at ' if mass is not None else ''}{readable(abs(factor) * float(np.linalg.norm(speed)), 'm/s')}{words}")
        if any(turn):
            parts.append(f"turns at {readable(abs(factor) * float(np.linalg.norm(turn)), 'rad/s')}{words}")
        if force.any():
            parts.append(f"{readable(float(np.linalg.norm(force)), 'N')}{force_words}")
        label = "rigid tool, " + (", ".join(parts) or "at rest")
        found.append(Arrows(TOOL, name, label, middle, np.sign(factor) * speed) if speed.any() and factor else Mark(TOOL, name, label, middle))
    return found


def crack_loads(values):
    """{crack: text} of pressures and combustion in cracks."""
    found = {}
    for name, one in lists(values, "Face Pressure"):
        factor, words = peak(one, "Pressure")
        found[name] = "pressure p(t) in it" if words == " × f(t)" else f"{readable(abs(factor), 'Pa')}{words} in it"
    for name, _ in lists(values, "Combustion"):
        found[name] = "burning faces"
    return found


def symbols_of(values, fields, surfaces=(), tools=None):
    """All symbols of a scene. values: as scene_values.as_values gives them; surfaces: those of the summary, which boundaries choose; tools: {name:
    outlines of a rigid tool}"""
    return boundary_symbols(values, fields, surfaces) + source_symbols(values, fields) + motion_symbols(values, fields) + tool_symbols(values, tools or {})
