#!/usr/bin/env python3
"""Hard cases of cells that refine, and of substeps."""

import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from hard_case import HardCase, box, elastic, sized, Scene, space, traction  # noqa: E402
from test_cracks import plate  # noqa: E402


def struck(adaptivity, time=4.0, **sections):
    """A block hit at one side by a short pulse, in coarse cells."""
    return Scene(
        {
            "Domain": space([-1.0, -1.0], [3.0, 3.0], 0.25),
            "Time": {"Final Time": time, "CFL": 0.3},
            "Materials": {"Solid": elastic()},
            "Bodies": {"Block": box([0.0, 0.0], [2.0, 2.0])},
            "Boundaries": {"Hit": traction("Block", [0.0, 2.0], [0.0, 0.0], [1e-3, 0.0], "t < 1 ? sin(pi*t)^2 : 0")},
            "Adaptivity": adaptivity,
            "Output": {"History Interval": time / 100.0},
            **sections,
        }
    )


class Cells(HardCase):
    def test_six_levels(self):
        scene = plate([0.0, 1.01, 0.35, 1.01], cell=0.25, time=sized(0.1, 4.0))
        scene.set("Adaptivity", {"Maximum Level": 6, "Front Cells": 3.0})
        outcome = self.survives(scene, energy=0.05, momentum=True)
        self.assertEqual(outcome.particles["level"].max(), 6)

    def test_six_levels_in_substeps(self):
        scene = plate([0.0, 1.01, 0.35, 1.01], cell=0.25, time=sized(1.0, 8.0))
        scene.set("Adaptivity", {"Maximum Level": 6, "Front Cells": 3.0}).set("Sub-Cycling", {})
        scene.set("Time > CFL", 0.3)
        self.survives(scene, energy=0.05, momentum=True)

    def test_levels_that_switch_each_step(self):
        """A threshold right where the pulse is, hardly any hysteresis, and a look at the cells in each step.

        Merging takes a third of the energy; splitting at once returns a tenth of that, which is in no balance."""
        adaptivity = {"Maximum Level": 2, "Velocity Change": 3e-4, "Coarsening": 0.99, "Interval": 1, "Buffer Cells": 0}
        outcome = self.survives(struck(adaptivity), energy=0.2, gain=0.06)
        self.assertGreater(outcome.history["merged"][-1], 0.0)
        self.assertLessEqual(outcome.energy()[-1], outcome.energy().max())

    def test_levels_that_switch_in_small_steps(self):
        adaptivity = {"Maximum Level": 3, "Velocity Change": 3e-4, "Coarsening": 0.9, "Interval": 1, "Buffer Cells": 0}
        scene = struck(adaptivity).set("Sub-Cycling", {})
        self.survives(scene, energy=0.2, gain=0.06)

    def test_refined_corner_of_a_body(self):
        corner = {"Lower Corner": [-0.1, -0.1], "Upper Corner": [0.1, 0.1], "Level": 5}
        scene = struck({"Maximum Level": 5, "Corner": corner}, time=sized(1.0, 8.0))
        self.survives(scene, energy=0.02)

    def test_flight_through_refined_cells(self):
        """A body with velocities at random flies into and out of three levels of cells."""
        region = {"Lower Corner": [2.5, -1.0], "Upper Corner": [3.5, 3.0], "Level": 3}
        scene = struck({"Maximum Level": 3, "Region": region}, time=sized(6.0, 12.0)).remove("Boundaries")
        scene.set("Domain > Upper Corner", [8.0, 3.0]).set("Bodies > Block > Velocity", [0.3, 0.05])
        self.survives(scene, energy=0.02, momentum=True)

    def test_crack_that_flies_through_refined_cells(self):
        scene = plate([0.0, 1.01, 0.35, 1.01], cell=0.1).set("Bodies > Plate > Velocity", [0.05, 0.02])
        scene.set("Adaptivity", {"Maximum Level": 2}).set("Sub-Cycling", {}).set("Time > CFL", 0.3)
        self.survives(scene, energy=0.05, gain=0.02, momentum=True)

    def test_crack_that_runs_with_its_cells(self):
        scene = plate([0.0, 1.01, 0.35, 1.01], cell=0.1, time=sized(8.0, 20.0), stress=(0.0, 2e-3))
        scene.set("Energy Release", {"Crack Closure": False}).set("Propagation", {"Toughness": "5e-6"}).set("Adaptivity", {"Maximum Level": 2, "Front Cells": 6.0})
        self.survives(scene, energy=0.05, gain=0.02, momentum=True)

    def test_two_fronts_that_approach(self):
        cracks = {"Left": [0.0, 1.01, 0.3, 1.01], "Right": [1.0, 1.03, 0.7, 1.03]}
        scene = plate(cracks, cell=0.1, time=sized(8.0, 20.0), stress=(0.0, 2e-3))
        scene.set("Energy Release", {"Crack Closure": False}).set("Propagation", {"Toughness": "5e-6"}).set("Adaptivity", {"Maximum Level": 2, "Front Cells": 6.0})
        self.survives(scene, energy=0.05, gain=0.02, momentum=True)


if __name__ == "__main__":
    unittest.main()
