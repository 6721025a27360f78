"""Scenes of files, to be changed at random."""

import re

from scenes import Scene

from rhegma.scene import read_xml
from rhegma.values import typed

# Parameters that are lengths in every section that has them.
LENGTHS = {"Lower Corner", "Upper Corner", "Cell Size", "Points", "Centre", "Radius", "From", "To", "Point", "Position",
           "Corner", "Edge 1", "Edge 2", "Rotation Centre", "Bottom", "Top", "Inner Radius", "Outer Radius", "Radii",
           "Front Radius", "Initial Gap", "Ignition Point", "Ignition Lower Corner", "Ignition Upper Corner", "Semi-Axes"}

# Units of the scenes, in SI units.
UNITS = {"mm": 1e-3, "um": 1e-6, "um/s": 1e-6, "us": 1e-6, "ms": 1e-3, "g": 1e-3, "g/cm3": 1e3, "MPa": 1e6, "GPa": 1e9}


def value_of(element):
    kind, text = element.get("type"), element.get("value")
    if kind == "double":
        return float(text)
    if kind == "Array(double)":
        return [float(x) for x in re.findall(r"[-+.\deE]+", text)]
    return text


class FileScene(Scene):
    """A scene of a file, with its numbers in SI units, so that they can be compared with each other and replaced."""

    def __init__(self, path):
        super().__init__()
        self.path = path
        self.root = read_xml(path, "scene")
        for element in self.root.iter("Parameter"):
            unit = element.attrib.pop("unit", None)
            if unit is not None:
                value = value_of(element)
                self.put(element, [x * UNITS[unit] for x in value] if isinstance(value, list) else value * UNITS[unit])

    def has(self, place):
        return place in self

    def get(self, place, otherwise=None):
        return value_of(self.find(place)) if self.has(place) else otherwise

    def put(self, element, value):
        kind, text = typed(value)
        element.set("type", kind)
        element.set("value", text)

    def lists(self, section):
        """Names of the sublists of a section."""
        return [e.get("name") for e in self.find(section) if e.tag == "ParameterList"] if self.has(section) else []

    def boundaries(self, *types):
        return [n for n in self.lists("Boundaries") if self.get(f"Boundaries > {n} > Type") in types]

    def types(self):
        """Type of each boundary."""
        return [self.get(f"Boundaries > {n} > Type") for n in self.lists("Boundaries")]

    @property
    def dimension(self):
        return int(self.get("Domain > Dimension"))

    @property
    def cell(self):
        return self.get("Domain > Cell Size")

    def boxes(self):
        return [n for n in self.lists("Bodies")
                if self.get(f"Bodies > {n} > Shape") == "Box" and not self.has(f"Bodies > {n} > Rotation")]

    def moves(self):
        """Whether the run takes steps in time: not in equilibrium, nor with heat alone."""
        return self.get("Thermal > Mechanics") != "false" and self.get("Time > Analysis", "Dynamic") == "Dynamic"

    def corners(self, body):
        return self.get(f"Bodies > {body} > Lower Corner"), self.get(f"Bodies > {body} > Upper Corner")

    def enlarge(self, cells):
        """A domain with more room around it; nodes stay where they are."""
        for corner, sign in (("Lower Corner", -1), ("Upper Corner", 1)):
            old = self.get(f"Domain > {corner}")
            self.set(f"Domain > {corner}", [x + sign * cells * self.cell for x in old])
        for name in self.boundaries("Symmetry"):  # the side of the mirror is no longer that of the nearer end
            place = f"Boundaries > {name}"
            if self.has(place + " > Side"):
                continue
            axis = "xyz".index(self.get(place + " > Axis"))
            low, high = (self.get(f"Domain > {c} Corner")[axis] for c in ("Lower", "Upper"))
            at = self.get(place + " > Position")
            self.set(place + " > Side", "Lower" if at - low < high - at else "Upper")

    def scale(self, names, factor, under=""):
        """Multiplies parameters of these names in a section or the whole scene."""
        for element in (self.find(under) if under else self.root).iter("Parameter"):
            if element.get("name") in names and element.get("type") in ("double", "Array(double)"):
                old = value_of(element)
                self.put(element, [factor * x for x in old] if isinstance(old, list) else factor * old)


def where(*names):
    return re.escape(" > ".join(names))
