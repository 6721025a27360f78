#!/usr/bin/env python3
"""Total Lagrangian: a cracked body that is stretched and then turned has the same G, K and opening as one that is stretched only.

Laws do not depend on rotation, and the cells are those of the undeformed body, so that nothing but rounding and the end of Newton's iterations
may differ where cracks lie along the cells. RHEGMA_SEED in the environment chooses angles and cracks; it is printed."""

import json
import math
import os
import random
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import ProgramTest, rhegma  # noqa: E402
from scenes import Scene  # noqa: E402

SEED = int(os.environ.get("RHEGMA_SEED", "62"))
HEIGHT, WIDTH, CELL = 0.08, 0.04, 0.0025
# Newton's method ends at 1e-8 of the forces; openings of faces are turned back with the rotation of the crack, whose slope changes by about the
# strain, 1e-3, and by its square in the opening.
SAME = 1e-5


def field(angle, stretch, dimension):
    """Displacement of the ends: stretched along y about the middle, then turned about the middle in the plane of x and y."""
    c, s = math.cos(angle), math.sin(angle)
    x, y = "x - 0.02", "(y - 0.04)"
    along = f"({1.0 + stretch!r} * {y})"
    parts = [f"({c!r} * ({x}) - {s!r} * {along}) - ({x})", f"({s!r} * ({x}) + {c!r} * {along}) - {y}"]
    return ", ".join(parts + ["0"] * (dimension - 2))


def held(angle, stretch, crack, dimension=2, **more):
    """A strip or a bar whose ends are held."""
    far = [1.0] * (dimension - 2)
    depth = [0.015] * (dimension - 2)

    def end(low, high):
        return {"Type": "Velocity", "Lower Corner": [-1.0, low] + [-1.0] * (dimension - 2), "Upper Corner": [1.0, high] + far,
                "Components": "xyz"[:dimension], "Field": field(angle, stretch, dimension)}

    return Scene(
        {
            "Domain": {"Dimension": dimension, "Cell Size": CELL, "Formulation": "Total Lagrangian",
                       "Lower Corner": [-0.01, -0.01] + [-0.01] * (dimension - 2),
                       "Upper Corner": [0.05, 0.09] + [0.025] * (dimension - 2)},
            "Time": {"Final Time": 1.0, "Analysis": "Static", "Load Steps": 6},
            "Materials": {"Acrylic": {"Model": "Linear Elastic", "Density": 1190.0, "Young Modulus": 3e9, "Poisson Ratio": 0.35}},
            "Bodies": {"Bar": {"Material": "Acrylic", "Shape": "Box", "Lower Corner": [0.0, 0.0] + [0.0] * (dimension - 2),
                               "Upper Corner": [WIDTH, HEIGHT] + depth}},
            "Boundaries": {"Bottom": end(-1.0, 0.1 * CELL), "Top": end(HEIGHT - 0.1 * CELL, 1.0)},
            "Cracks": {"Notch": {"Points": crack}},
            "Energy Release": {},
            "Output": {"Fields": False, "History Interval": 1e-6},
            **more,
        }
    )


class TurnedBodies(ProgramTest):
    def setUp(self):
        super().setUp()
        self.rng = random.Random(SEED)
        print(f"seed {SEED}", flush=True)

    def front(self, scene, name):
        answer = rhegma(self.write(name + ".xml", scene.text()), "--quiet")
        self.assertEqual(answer.status, 0, answer)  # with warnings of large displacements of supports
        with open(self.path(name + ".out", "summary.json")) as file:
            crack = json.load(file)["cracks"][0]
        return {**crack["fronts"][0], "opening": crack["opening"]}

    def compare(self, make, keys, same=SAME):
        """Intensities relative to K_I, all others to themselves."""
        still = self.front(make(0.0), "still")
        for angle in (self.rng.uniform(0.1, 0.5), self.rng.uniform(-0.9, -0.6)):
            turned = self.front(make(angle), "turned")
            for key in keys:
                scale = abs(still["K_I"]) if key.startswith("K_") else abs(still[key])
                self.assertGreater(scale, 0.0, key)
                self.assertLess(abs(turned[key] - still[key]) / scale, same, f"{key}: {turned[key]} for {still[key]}, turned by {angle}")

    def test_a_strip_with_a_crack_at_an_angle(self):
        """The ghost penalty of cells that a crack cuts takes turning for strain: it holds back what turns by 0.15 a load step, by 1 to 2 %."""
        end = [self.rng.uniform(0.012, 0.018), 0.04 + self.rng.uniform(-4e-3, 4e-3)]
        self.compare(lambda angle: held(angle, 2e-3, [0.0, 0.04, *end]), ("G_J", "K_I", "K_II", "opening"), 0.04)

    def test_a_strip_with_a_crack_along_the_cells(self):
        x = self.rng.uniform(0.012, 0.018)
        self.compare(lambda angle: held(angle, 2e-3, [0.0, 0.04, x, 0.04]), ("G_J", "K_I", "K_II", "opening"))

    def test_a_strip_with_pressure_in_its_crack(self):
        """The pressure is applied where faces are at the start of a load step; the last one is repeated, which leaves the square of what a step
        turns by, 0.15, times the part of the pressure in the load."""
        pressure = {"Face Pressure": {"Notch": {"Pressure": "2e6"}}}
        self.compare(lambda angle: held(angle, 1e-3, [0.0, 0.04, 0.015, 0.04], **pressure), ("G_J", "K_I", "K_II", "opening"), 2e-3)

    def test_a_bar_with_a_front_across_it(self):
        x = self.rng.uniform(0.012, 0.018)
        crack = [0.0, 0.04, -0.01, x, 0.04, -0.01, x, 0.04, 0.025, 0.0, 0.04, 0.025]
        self.compare(lambda angle: held(angle, 2e-3, crack, 3), ("G_J", "K_I", "K_II", "opening"), 1e-3)


if __name__ == "__main__":
    unittest.main()
