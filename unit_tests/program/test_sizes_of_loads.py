#!/usr/bin/env python3
"""Equilibria do not depend on the size of the loads: unit loads with a load factor, bodies that supports move without stress, and
free bodies of large strain.

RHEGMA_SEED in the environment chooses other positions and loads."""

import json
import os
import random
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import ProgramTest, rhegma  # noqa: E402
from scenes import Scene  # noqa: E402

SEED = int(os.environ.get("RHEGMA_SEED", "3"))
SIDE, CELL = 0.2, 0.01


def plate(rng, material, boundaries, analysis="Static", **more):
    """A square plate anywhere in its cells, pulled at two sides if it has a stress."""
    low = [rng.uniform(-0.5, 0.5) * CELL for _ in range(2)]
    high = [x + SIDE for x in low]
    corners = [-SIDE, -SIDE], [3 * SIDE, 3 * SIDE]
    content = {
        "Domain": {"Dimension": 2, "Plane": "Stress", "Thickness": 0.01, "Lower Corner": corners[0], "Upper Corner": corners[1],
                   "Cell Size": CELL},
        "Time": {"Final Time": 1.0, "Analysis": analysis},
        "Materials": {"Solid": material},
        "Bodies": {"Plate": {"Material": "Solid", "Shape": "Box", "Lower Corner": low, "Upper Corner": high}},
        "Boundaries": boundaries(low, high),
        "Output": {"Fields": False},
    }
    for section, entries in more.items():
        content.setdefault(section.replace("_", " "), {}).update(entries(low) if callable(entries) else entries)
    return Scene(content)


def pulled(stress):
    """Tractions on the lower and the upper side."""
    def boundaries(low, high):
        return {name: {"Type": "Traction", "Body": "Plate", "From": [low[0], y], "To": [high[0], y], "Stress": [0.0, sign * stress]}
                for name, y, sign in (("Top", high[1], 1.0), ("Bottom", low[1], -1.0))}
    return boundaries


STEEL = {"Model": "Linear Elastic", "Density": 7800.0, "Young Modulus": 2.1e11, "Poisson Ratio": 0.3}


class SizesOfLoads(ProgramTest):
    def run_scene(self, scene, name):
        answer = rhegma(self.write(name + ".xml", scene.text()), "--quiet")
        self.assertEqual(answer.status, 0, answer)
        with open(self.path(name + ".out", "summary.json")) as file:
            return json.load(file), answer

    def test_unit_loads_with_a_load_factor(self):
        """The factor times the loads is the same from 1 Pa on; small loads are no reason to warn, as a factor multiplies them."""
        print(f"seed {SEED}", flush=True)
        loads = []
        for stress in (1.0, 3e2, 1e5, 2e7):
            rng = random.Random(SEED)
            scene = plate(rng, STEEL, pulled(stress), "Quasi-Static",
                          Cracks=lambda low: {"Notch": {"Points": [low[0], low[1] + 0.47 * SIDE, low[0] + 0.3 * SIDE, low[1] + 0.47 * SIDE]}},
                          Energy_Release={}, Time={"Rigid Modes": "Remove", "Load Steps": 1},
                          Propagation={"Toughness": 5000.0, "Load Control": "Load Factor"})
            summary, answer = self.run_scene(scene, f"unit_{stress:g}")
            loads.append(summary["propagation"]["initiation"]["load_factor"] * stress)
            self.assertNotIn("only (", answer.messages)
            self.assertNotIn("own weight", answer.messages)
        for load in loads[1:]:
            self.assertAlmostEqual(load / loads[0], 1.0, delta=1e-3)  # LoadFactorSearch::loosest, and rounding of the strain by 1 Pa

    def test_resultants_in_check(self):
        """Each load has a line with its force where it is largest, with the sign of its history; in Static at the end."""
        rng = random.Random(SEED + 2)
        stress, factor = rng.uniform(1e6, 5e6), rng.uniform(0.5, 2.0)
        for analysis, history, sign, part in (("Static", "1", 1, 1.0), ("Static", f"0:9, 1:-{factor}", -1, factor),
                                              ("Quasi-Static", f"0:0, 0.5:-{factor}, 1:0.1", -1, factor)):
            scene = plate(random.Random(SEED), STEEL, pulled(stress), analysis, Time={"Rigid Modes": "Remove"})
            scene.set("Boundaries > Top > History", history)
            answer = rhegma(self.write("check.xml", scene.text()), "--check", XDG_CACHE_HOME=self.path("cache"))
            self.assertEqual(answer.status, 0, answer)
            line = next(x for x in answer.output.splitlines() if "Boundaries > Top: " in x)
            self.assertIn(f"{part * stress * SIDE * 0.01 / 1e3:.4g} kN along (0, {sign})", line)

    def test_reference_loads_beyond_the_start_of_growth(self):
        """The first trial strains the body more than at the start of growth, and that is said."""
        scene = plate(random.Random(SEED), STEEL, pulled(3e10), "Quasi-Static",
                      Cracks=lambda low: {"Notch": {"Points": [low[0], low[1] + 0.47 * SIDE, low[0] + 0.3 * SIDE, low[1] + 0.47 * SIDE]}},
                      Energy_Release={}, Time={"Rigid Modes": "Remove", "Load Steps": 1},
                      Propagation={"Toughness": 5000.0, "Load Control": "Load Factor"})
        self.assertIn("the first factor that is tried", self.run_scene(scene, "large")[1].messages)

    def test_bodies_that_move_without_stress(self):
        """A body that one support moves has no forces but rounding, and that is an equilibrium."""
        rng = random.Random(SEED + 1)
        move = [rng.uniform(-1.0, 1.0) * 1e-3 for _ in range(2)]
        scene = plate(rng, STEEL, lambda low, high: {"Grip": {"Type": "Velocity", "Lower Corner": [-SIDE, -SIDE],
                                                            "Upper Corner": [2 * SIDE, low[1] + 2 * CELL], "Value": move}})
        summary, answer = self.run_scene(scene, "moved")
        self.assertIn("hardly larger than rounding of the stress", answer.messages)
        force = summary["boundaries"][0]["force"]
        # Rounding of the stress: that of 1, times Young's modulus, over the section.
        self.assertLess(max(abs(x) for x in force), 100 * 2.2e-16 * 2.1e11 * SIDE * 0.01)
        for component in summary["bodies"][0]["stress"].values():
            self.assertLess(abs(component), 100 * 2.2e-16 * 2.1e11)

    def test_free_bodies_of_large_strain(self):
        """Without supports, and wherever they lie, they are strained as those that supports hold."""
        for number in range(4):
            rng = random.Random(100 * SEED + number)
            modulus, stress = 1e6, rng.uniform(1e5, 2e5) if number % 2 else -rng.uniform(3e4, 8e4)
            rubber = {"Model": "Neo-Hookean", "Density": 1000.0, "Young Modulus": modulus, "Poisson Ratio": 0.4}
            free = plate(rng, rubber, pulled(stress), Time={"Rigid Modes": "Remove"})
            summary, _ = self.run_scene(free, f"free_{number}")
            with self.subTest(number=number, seed=SEED):
                self.assertLess(len(summary["equilibrium"]["residuals"]), 14)
                stretch = summary["bodies"][0]["deformation"]["yy"]
                # A plate of plane stress: P = E' strain at first, stiffer by half of the strain; loads are forces on the body at rest.
                self.assertGreater((stretch - 1.0) / stress, 0.7 / modulus)
                self.assertLess((stretch - 1.0) / stress, 1.5 / modulus)


if __name__ == "__main__":
    unittest.main()
