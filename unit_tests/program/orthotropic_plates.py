"""Scenes of cracks in large orthotropic plates under uniform tension, whose cells shrink towards the fronts."""

import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", "..", "tools"))

from rhegma.scene import Scene  # noqa: E402

HALF_LENGTH = 1e-3  # of the crack [m]
HALF_WIDTH = 40e-3  # of the plate: its effect on K is 0.04 % in isotropic plates, more along stiff fibres
CELL = 2e-3  # far from the crack [m]
STRESS = 1e5  # along the y axis of the plate [Pa]


def turned(point, angle):
    c, s = math.cos(angle), math.sin(angle)
    return [c * point[0] - s * point[1], s * point[0] + c * point[1]]


def cracked_plate(material, fibres, crack=0.0, plane="Strain", turn=0.0, middle=(0.137e-3, 0.291e-3), level=6):
    """A plate with a crack, turned as a whole. \\param fibres, crack angles from the x axis of the plate [rad] \\param middle of the crack
    [m] \\param level of the cells at the fronts: CELL halved so many times"""
    half, room = HALF_WIDTH, HALF_WIDTH * (1.0 if turn == 0.0 else math.sqrt(2.0)) + 2 * CELL
    corners = [[-half, -half], [half, -half], [half, half], [-half, half]]
    lower_left, lower_right, upper_right, upper_left = [turned(c, turn) for c in corners]
    along = [HALF_LENGTH * math.cos(crack), HALF_LENGTH * math.sin(crack)]
    ends = [turned([middle[d] + sign * along[d] for d in (0, 1)], turn) for sign in (-1, 1)]
    room = math.ceil(room / CELL) * CELL
    body = {"Material": "Composite", "Shape": "Box", "Lower Corner": [-half, -half], "Upper Corner": [half, half]}
    if turn != 0.0:
        body["Rotation"] = math.degrees(turn)
    pull = turned([0.0, STRESS], turn)
    return Scene({
        "Domain": {"Dimension": 2, "Plane": plane, "Lower Corner": [-room, -room], "Upper Corner": [room, room], "Cell Size": CELL,
                   "Shape Functions": "Linear"},
        "Time": {"Analysis": "Static", "Rigid Modes": "Remove", "Final Time": 1e-3},
        "Materials": {"Composite": {
            "Model": "Orthotropic", "Density": 1600.0, "Young Moduli": list(material["young"]),
            "Poisson Ratios": list(material["poisson"]), "Shear Moduli": list(material["shear"]),
            "Fibre Direction": [math.cos(fibres + turn), math.sin(fibres + turn)]}},
        "Bodies": {"Plate": body},
        "Boundaries": {
            "Top": {"Type": "Traction", "Body": "Plate", "From": upper_right, "To": upper_left, "Stress": pull},
            "Bottom": {"Type": "Traction", "Body": "Plate", "From": lower_left, "To": lower_right, "Stress": [-p for p in pull]}},
        "Cracks": {"Slit": {"Points": ends[0] + ends[1]}},
        "Adaptivity": {"Maximum Level": level, "Front Cells": 10.0},
        "Energy Release": {"Crack Closure": False},
        "Output": {"Fields": False},
    })
