"""Axisymmetric scenes and their closed solutions: tubes under pressure, penny-shaped cracks, notched round bars."""

import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", "..", "tools"))

from rhegma.scene import Scene  # noqa: E402

YOUNG, POISSON = 200e9, 0.3


def round_scene(lower, upper, cell, bodies):
    """A scene at rest whose y axis is the axis of its bodies."""
    return Scene({
        "Domain": {"Dimension": 2, "Plane": "Axisymmetric", "Lower Corner": list(lower), "Upper Corner": list(upper),
                   "Cell Size": cell},
        "Time": {"Analysis": "Static", "Final Time": 1e-3},
        "Materials": {"Steel": {"Model": "Linear Elastic", "Density": 7800.0, "Young Modulus": YOUNG,
                                "Poisson Ratio": POISSON}},
        "Bodies": {name: {"Material": "Steel", "Shape": "Box", "Lower Corner": list(body[0]), "Upper Corner": list(body[1])}
                   for name, body in bodies.items()},
        "Output": {"Fields": False},
    })


def tube(inner, outer, pressure, cell, shift=0.0):
    """A tube in plane strain, four cells long. \\param shift of its nodes along the radius, as a fraction of a cell"""
    low = max(0.0, inner - 4.0 * cell + shift * cell)
    scene = round_scene([low, -2.0 * cell], [outer + 4.0 * cell, 6.0 * cell], cell,
                        {"Tube": ([inner, 0.0], [outer, 4.0 * cell])})
    far = outer + 8.0 * cell
    return scene.set("Boundaries", {
        "Inside": {"Type": "Traction", "Body": "Tube", "From": [inner, 4.0 * cell], "To": [inner, 0.0], "Pressure": pressure},
        "Below": {"Type": "Velocity", "Lower Corner": [0.0, -cell], "Upper Corner": [far, 0.01 * cell], "Value": [0.0, 0.0],
                  "Components": "y"},
        "Above": {"Type": "Velocity", "Lower Corner": [0.0, 3.99 * cell], "Upper Corner": [far, 9.0 * cell],
                  "Value": [0.0, 0.0], "Components": "y"}})


def lame(inner, outer, pressure, r):
    """Radial and hoop stress, and radial displacement, of a tube in plane strain."""
    a = pressure * inner**2 / (outer**2 - inner**2)
    b = a * outer**2
    return a - b / r**2, a + b / r**2, (1 + POISSON) / YOUNG * ((1 - 2 * POISSON) * a * r + b / r)


def penny(radius, outer, stress, cell, above=0.0, pressed=False, half=None):
    """A penny-shaped crack in the middle of a round bar, under tension or under pressure on its faces. \\param above height of
    the crack above a row of nodes, as a fraction of a cell \\param half of the length of the bar; None: its radius"""
    half = half or outer
    scene = round_scene([0.0, -half - 3.0 * cell], [outer + 3.0 * cell, half + 3.0 * cell], cell,
                        {"Bar": ([0.0, -half], [outer, half])})
    scene.set("Time > Rigid Modes", "Remove")
    scene.set("Cracks", {"Penny": {"Points": [0.0, above * cell, radius, above * cell]}}).set("Energy Release", {})
    if pressed:
        return scene.set("Face Pressure", {"Penny": {"Pressure": str(stress)}})
    return scene.set("Boundaries", pull(outer, half, stress))


def pull(outer, half, stress):
    return {
        "Top": {"Type": "Traction", "Body": "Bar", "From": [outer, half], "To": [0.0, half], "Stress": [0.0, stress]},
        "Bottom": {"Type": "Traction", "Body": "Bar", "From": [0.0, -half], "To": [outer, -half], "Stress": [0.0, -stress]}}


def penny_intensity(radius, outer, stress):
    """K_I of a penny-shaped crack in a long round bar under tension. Source: Benthem and Koiter (1973), in Tada, Paris and
    Irwin, The Stress Analysis of Cracks Handbook; good to 1 %."""
    x = radius / outer
    net = stress / (1 - x * x)
    return net * math.sqrt(math.pi * radius) * math.sqrt(1 - x) * (2 / math.pi * (1 + x / 2 - 5 / 8 * x * x) + 0.268 * x**3)


def ring_crack(ligament, outer, stress, cell, above=0.0):
    """A round bar with a circumferential edge crack."""
    half = 2.5 * outer
    scene = round_scene([0.0, -half - 3.0 * cell], [outer + 3.0 * cell, half + 3.0 * cell], cell,
                        {"Bar": ([0.0, -half], [outer, half])})
    scene.set("Time > Rigid Modes", "Remove")
    scene.set("Cracks", {"Ring": {"Points": [outer, above * cell, ligament, above * cell]}}).set("Energy Release", {})
    return scene.set("Boundaries", pull(outer, half, stress))


def ring_intensity(ligament, outer, stress):
    """K_I of that crack. Source: Benthem and Koiter (1973), in Tada, Paris and Irwin. Plain finite elements give 0.6 to 1.3 % more for
    ligaments of 0.3 to 0.4 of the radius, and 2 % at half of it (unit_tests/studies/round_bars.py)."""
    x = ligament / outer
    net = stress / (x * x)
    shape = 0.5 * (1 + x / 2 + 3 / 8 * x**2 - 0.363 * x**3 + 0.731 * x**4) * math.sqrt(1 - x)
    return net * math.sqrt(math.pi * ligament) * shape
