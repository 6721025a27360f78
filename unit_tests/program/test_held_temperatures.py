#!/usr/bin/env python3
"""Bodies with an edge at a prescribed temperature: what the steps of conduction add up to as thermal strain."""

import json
import os
import sys
import unittest

import h5py
import numpy as np

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import ProgramTest, rhegma  # noqa: E402
from scenes import Scene  # noqa: E402

YOUNG, EXPANSION, WARM, COLD = 7e10, 9e-6, 350.0, 300.0


def strip(analysis, conduction, conductivity=1.0, final=400.0):
    boundaries = {"Cold": {"Type": "Temperature", "Lower Corner": [-1e-3, -1e-3], "Upper Corner": [1e-4, 0.081], "Temperature": COLD}}
    if analysis == "Static":
        boundaries["Warm"] = {"Type": "Temperature", "Lower Corner": [0.0399, -1e-3], "Upper Corner": [0.041, 0.081], "Temperature": WARM}
    return Scene(
        {
            "Domain": {"Dimension": 2, "Plane": "Stress", "Thickness": 3e-3, "Lower Corner": [-0.01, -0.01], "Upper Corner": [0.05, 0.09],
                       "Cell Size": 2e-3},
            "Time": {"Analysis": analysis, "Final Time": final, "Rigid Modes": "Remove", "Load Steps": 10},
            "Materials": {"Glass": {"Model": "Linear Elastic", "Density": 2500.0, "Young Modulus": YOUNG, "Poisson Ratio": 0.22,
                                    "Specific Heat": 800.0, "Conductivity": conductivity, "Thermal Expansion": EXPANSION}},
            "Bodies": {"Strip": {"Material": "Glass", "Shape": "Box", "Lower Corner": [0.0, 0.0], "Upper Corner": [0.04, 0.08]}},
            "Boundaries": boundaries,
            "Thermal": {"Initial Temperature": WARM, "Conduction": conduction},
        }
    )


class HeldTemperatures(ProgramTest):
    def largest_stress(self, scene):
        answer = rhegma(self.write("scene.xml", scene.text()), "--output", self.path("out"), "--quiet")
        self.assertEqual(answer.status, 0, answer)
        with h5py.File(self.path("out", "fields.h5"), "r") as file:
            names = []
            file.visit(lambda name: names.append(name) if name.endswith("von_mises") else None)
            stress = np.asarray(file[sorted(names)[-1]])
        with open(self.path("out", "summary.json"), encoding="utf-8") as file:
            return stress.max(), json.load(file)["energy"]["strain"]

    def test_many_steps_add_up(self):
        """One row of nodes is held, and the particles next to it have two. Hundreds of explicit steps give what ten implicit ones
        do, but for the error in time of these. No stress exceeds E alpha dT, that of a body held in one direction whose temperature
        changes by all of dT; it did by a factor of five when the changes of the nodes were added up step by step."""
        explicit, energy = self.largest_stress(strip("Quasi-Static", "Explicit"))
        implicit, other = self.largest_stress(strip("Quasi-Static", "Implicit"))
        print(f"largest von Mises stress {explicit / 1e6:.2f} and {implicit / 1e6:.2f} MPa, strain energy {energy:.3e} and {other:.3e} J")
        self.assertLess(explicit, YOUNG * EXPANSION * (WARM - COLD))
        self.assertAlmostEqual(explicit / implicit, 1.0, delta=0.2)
        self.assertAlmostEqual(energy / other, 1.0, delta=0.2)

    def test_steady_conductivity_of_temperature(self):
        """The passes of a steady step converge for a body that expands. A free body would have no stress in a linear temperature; with k
        growing by a factor f = 1.25 across it, T departs from the chord by (f - 1) / (f + 1) / 4 of dT at most (Kirchhoff), and stress stays
        below E alpha times that, in cells that are fine enough by twice as much."""
        stress, _ = self.largest_stress(strip("Static", "Steady", "300:2, 350:2.5", 1.0))
        bound = YOUNG * EXPANSION * (WARM - COLD) * 0.25 / 2.25 / 4.0
        print(f"largest von Mises stress {stress / 1e6:.3f} MPa, bound {bound / 1e6:.3f} MPa")
        self.assertLess(stress, 2.0 * bound)
        self.assertGreater(stress, 0.1 * bound)


if __name__ == "__main__":
    unittest.main()
