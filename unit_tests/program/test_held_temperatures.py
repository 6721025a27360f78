#!/usr/bin/env python3
"""Bodies with an edge at a prescribed temperature: what the steps of conduction add up to as thermal strain."""

import json
import os
import random
import re
import sys
import time
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


def pulled_plate(stretch):
    """An edge crack in a plate of acrylic whose ends are held at 283 and 303 K and pulled apart [m]."""
    foot = {"Lower Corner": [-1.0, -1.0], "Upper Corner": [1.0, 1e-6]}
    head = {"Lower Corner": [-1.0, 0.079999], "Upper Corner": [1.0, 1.0]}
    return Scene(
        {
            "Domain": {"Dimension": 2, "Plane": "Stress", "Lower Corner": [-0.01, -0.01], "Upper Corner": [0.05, 0.09], "Cell Size": 2e-3},
            "Time": {"Analysis": "Quasi-Static", "Final Time": 1.0, "Load Steps": 2},
            "Materials": {"Acrylic": {"Model": "Linear Elastic", "Density": 1190.0, "Young Modulus": 3e9, "Poisson Ratio": 0.35,
                                      "Specific Heat": 1400.0, "Conductivity": 0.2, "Thermal Expansion": 7e-5}},
            "Bodies": {"Plate": {"Material": "Acrylic", "Shape": "Box", "Lower Corner": [0.0, 0.0], "Upper Corner": [0.04, 0.08]}},
            "Boundaries": {"Foot": {"Type": "Velocity", "Value": [0.0, 0.0], **foot}, "Cold": {"Type": "Temperature", "Temperature": 283.0, **foot},
                           "Grip": {"Type": "Velocity", "Value": [0.0, stretch], **head},
                           "Hot": {"Type": "Temperature", "Temperature": 303.0, **head}},
            "Thermal": {"Initial Temperature": 293.0, "Conduction": "Steady"},
            "Cracks": {"Notch": {"Points": [-0.001, 0.04, 0.008235073347973939, 0.04]}},
            "Energy Release": {"Crack Closure": False},
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

    def test_steady_where_an_edge_comes_just_over_its_nodes(self):
        """In the second step the plate reaches over its row of nodes by any fraction of a cell, and nodes beyond it have next to no
        weight: what they have is no temperature of the plate. That lies between those of its ends (maximum principle)."""
        seed = int(os.environ.get("RHEGMA_SEED", time.time_ns() % 10**6))
        print(f"seed {seed}")
        for stretch in [3e-5, *np.random.default_rng(seed).uniform(1e-5, 1.5e-4, 7)]:
            with self.subTest(stretch=stretch):
                answer = rhegma(self.write("scene.xml", pulled_plate(stretch).text()), "--output", self.path("out"), "--quiet")
                self.assertEqual(answer.status, 0, answer)
                with h5py.File(self.path("out", "fields.h5"), "r") as file:
                    names = []
                    file.visit(lambda name: names.append(name) if name.endswith("particles/temperature") else None)
                    temperature = np.asarray(file[sorted(names)[-1]])
                self.assertGreater(temperature.min(), 283.0)
                self.assertLess(temperature.max(), 303.0)


class MaterialsOfTheLibrary(ProgramTest):
    """4340 Steel of the library is valid from 250 to 500 K."""

    def said(self, initial, held):
        steel = {"Material From Library": "4340 Steel", "Model": "Linear Elastic"}
        scene = strip("Dynamic", "Implicit", final=1.0).set("Materials", {"Glass": steel}).set("Thermal > Initial Temperature", initial)
        scene.set("Thermal > Mechanics", False).remove("Time").set("Time > Final Time", 5.0).set("Boundaries > Cold > Temperature", held)
        answer = rhegma(self.write("scene.xml", scene.text()), "--quiet")
        self.assertEqual(answer.status, 0, answer)
        return [line for line in answer.messages.splitlines() if "in the library are valid from 250 to 500 K" in line]

    def test_warn_outside_of_their_range(self):
        seed = int(os.environ.get("RHEGMA_SEED", random.randrange(10**6)))
        print(f"RHEGMA_SEED = {seed}")
        rng = random.Random(seed)
        self.assertEqual(self.said(rng.uniform(251.0, 499.0), rng.uniform(251.0, 499.0)), [])
        hot = rng.uniform(700.0, 1200.0)
        (line,) = self.said(300.0, hot)
        found = re.search(r"Materials > Glass: the constants of 4340 Steel .* its bodies came to ([\d.]+) K at t = 5 s", line)
        self.assertIsNotNone(found, line)
        self.assertTrue(500.0 < float(found.group(1)) <= hot, line)
        cold = round(rng.uniform(100.0, 240.0))
        (line,) = self.said(cold, cold)
        self.assertIn(f"its bodies start at {cold} K;", line)


if __name__ == "__main__":
    unittest.main()
