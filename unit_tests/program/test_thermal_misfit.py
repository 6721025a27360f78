#!/usr/bin/env python3
"""A strip in plane strain with an edge crack and one temperature, which is not that at which its material has no thermal strain. The
stress across the plane does no work on the crack."""

import json
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import ProgramTest, rhegma  # noqa: E402
from scenes import Scene  # noqa: E402

EXPANSION, POISSON, TEMPERATURE = 9e-6, 0.22, 293.0


def strip(reference):
    def pulled(y, stress):
        ends = ([0.04, y], [0.0, y]) if stress > 0.0 else ([0.0, y], [0.04, y])
        return {"Type": "Traction", "Body": "Strip", "From": ends[0], "To": ends[1], "Stress": [0.0, stress]}

    return Scene(
        {
            "Domain": {"Dimension": 2, "Plane": "Strain", "Lower Corner": [-0.02, -0.02], "Upper Corner": [0.06, 0.1],
                       "Cell Size": 1.25e-3},
            "Time": {"Analysis": "Static", "Rigid Modes": "Remove", "Final Time": 1.0},
            "Materials": {"Glass": {"Model": "Linear Elastic", "Density": 2500.0, "Young Modulus": 7e10, "Poisson Ratio": POISSON,
                                    "Specific Heat": 800.0, "Conductivity": 1.0, "Thermal Expansion": EXPANSION,
                                    "Reference Temperature": reference}},
            "Bodies": {"Strip": {"Material": "Glass", "Shape": "Box", "Lower Corner": [0.0, 0.0], "Upper Corner": [0.04, 0.08]}},
            "Boundaries": {
                "Top": pulled(0.08, 5e6),
                "Bottom": pulled(0.0, -5e6),
                "Edge": {"Type": "Temperature", "Lower Corner": [-1e-3, -1e-3], "Upper Corner": [1e-3, 0.081],
                         "Temperature": TEMPERATURE},
            },
            "Cracks": {"Notch": {"Points": [0.0, 0.04, 0.015, 0.04]}},
            "Energy Release": {"Crack Closure": False},
            "Thermal": {"Initial Temperature": TEMPERATURE, "Conduction": "Steady"},
        }
    )


class Misfit(ProgramTest):
    def release(self, reference):
        answer = rhegma(self.write("scene.xml", strip(reference).text()), "--output", self.path("out"), "--quiet")
        self.assertEqual(answer.status, 0, answer)
        with open(self.path("out", "summary.json"), encoding="utf-8") as file:
            return json.load(file)["cracks"][0]["fronts"][0]["G_J"]

    def test_g_does_not_depend_on_it(self):
        """Edges on lines of the grid, and a contour that ends at the edge of the strip. Shrinking by (1 + nu) alpha T changes G by that;
        what is left of the energy across the plane where the edge cuts the contour changes it by no more."""
        exact = self.release(TEMPERATURE)
        for reference in (600.0, 1300.0):
            with self.subTest(reference):
                change = (1.0 + POISSON) * EXPANSION * (reference - TEMPERATURE)
                release = self.release(reference)
                print(f"{reference} K: G = {release:.3f} J/m2, {exact:.3f} without a misfit")
                self.assertAlmostEqual(release / exact, 1.0, delta=2.0 * change)


if __name__ == "__main__":
    unittest.main()
