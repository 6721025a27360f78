#!/usr/bin/env python3
"""Domain > Formulation = Total Lagrangian: cracks in bodies that are deflected, stretched, moved and turned far.

RHEGMA_SEED in the environment chooses positions, loads and motions; it is printed."""

import csv
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

SEED = int(os.environ.get("RHEGMA_SEED", "61"))

# G of the strip below over that of small loads, by xml_inputs/references/edge_crack.py with 1e3, 2e7 and 6e7 Pa: finite elements with the
# same law and finite deflection.
SMALL = 2.35129e-5 / 1e3**2
DEFLECTED = {2e7: 8673.69 / (SMALL * 2e7**2), 6e7: 68450.4 / (SMALL * 6e7**2)}


def strip(stress, cell=0.0025, at=0.04, **more):
    """The strip of xml_inputs/examples/edge_crack.xml."""

    def end(y, x, sign):
        return {"Type": "Traction", "Body": "Strip", "From": [x, y], "To": [0.04 - x, y], "Stress": [0.0, sign * stress]}

    return Scene(
        {
            "Domain": {"Dimension": 2, "Plane": "Stress", "Thickness": 0.003, "Cell Size": cell, "Formulation": "Total Lagrangian",
                       "Lower Corner": [-0.01, -0.01], "Upper Corner": [0.05, 0.09]},
            "Time": {"Final Time": 1.0, "Analysis": "Static", "Rigid Modes": "Remove"},
            "Materials": {"Acrylic": {"Model": "Linear Elastic", "Density": 1190.0, "Young Modulus": 3e9, "Poisson Ratio": 0.35}},
            "Bodies": {"Strip": {"Material": "Acrylic", "Shape": "Box", "Lower Corner": [0.0, 0.0], "Upper Corner": [0.04, 0.08]}},
            "Boundaries": {"Top": end(0.08, 0.04, 1.0), "Bottom": end(0.0, 0.0, -1.0)},
            "Cracks": {"Notch": {"Points": [0.0, at, 0.01, at]}},
            "Energy Release": {},
            "Output": {"Fields": False, "History Interval": 1e-6},
            **more,
        }
    )


class TotalLagrangian(ProgramTest):
    def setUp(self):
        super().setUp()
        print(f"seed {SEED}", flush=True)
        self.rng = random.Random(SEED)

    def run_scene(self, scene, name="scene"):
        """The summary, and the rows of the history by name."""
        answer = rhegma(self.write(name + ".xml", scene.text()), "--quiet")
        self.assertEqual(answer.status, 0, answer)
        with open(self.path(name + ".out", "summary.json")) as file:
            summary = json.load(file)
        with open(self.path(name + ".out", "history.csv"), newline="") as file:
            return summary, [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]

    def release(self, scene, name="scene"):
        return self.run_scene(scene, name)[0]["cracks"][0]["fronts"][0]

    def test_finite_deflection_changes_G_as_finite_elements_say(self):
        """The strain in the cell of the front is large: what the cells miss of the effect falls with the root of their size, as that strain grows.
        Four cells along the crack miss a fifth of it at most; 16 cells half as much, but for crack closure, whose forces are those of that cell."""
        for cell, part in ((0.0025, 0.2), (0.000625, 0.1)):
            small = self.release(strip(1e3, cell), "small")
            for stress, ratio in DEFLECTED.items():
                deflected = self.release(strip(stress, cell), "deflected")
                for key in ("G_J", "G_closure"):
                    found = deflected[key] / small[key] / (stress / 1e3) ** 2
                    least = 0.2 if key == "G_closure" else part
                    self.assertAlmostEqual(found, ratio, delta=least * (1.0 - ratio), msg=f"{key} {stress:g} {cell:g}")

    def test_load_steps_do_not_change_equilibrium(self):
        """The law has a potential, so that equilibrium does not depend on the way to it; Newton's method ends at 1e-8 of the forces."""
        stress = self.rng.uniform(1e7, 4e7)
        at = [self.release(strip(stress).set("Time > Load Steps", steps), f"steps_{steps}")["G_J"] for steps in (1, 5)]
        self.assertAlmostEqual(at[1] / at[0], 1.0, delta=1e-6)

    def test_a_stretched_sheet_releases_what_is_stored_ahead(self):
        """A clamped sheet, long against its height H: behind the front nothing is stored, far ahead W of the stretch, so that G = H W (Rivlin and
        Thomas, J. Polymer Sci. 10 (1953) 291). Here W is that of plane strain, F = diag(1, stretch, 1)."""
        stretch, height = self.rng.uniform(1.3, 1.8), 0.01
        mu, nu = 1e6, 0.3
        bulk = 2.0 * mu * nu / (1.0 - 2.0 * nu)
        stored = 0.5 * mu * (stretch**2 - 1.0) - mu * math.log(stretch) + 0.5 * bulk * math.log(stretch) ** 2
        cell = height / 16

        def grip(y, sign):
            return {"Type": "Velocity", "Lower Corner": [-1.0, y - 0.6 * cell], "Upper Corner": [1.0, y + 0.6 * cell],
                    "Components": "xy", "Value": [0.0, 0.5 * sign * height * (stretch - 1.0)]}

        scene = strip(1.0, cell)
        scene.set("Materials", {"Rubber": {"Model": "Neo-Hookean", "Density": 1000.0, "Young Modulus": 2.0 * mu * (1.0 + nu), "Poisson Ratio": nu}})
        scene.set("Bodies", {"Sheet": {"Material": "Rubber", "Shape": "Box", "Lower Corner": [0.0, 0.0], "Upper Corner": [8 * height, height]}})
        scene.set("Boundaries", {"Top": grip(height, 1.0), "Bottom": grip(0.0, -1.0)})
        scene.set("Cracks", {"Notch": {"Points": [0.0, 0.5 * height, 4 * height, 0.5 * height]}})
        scene.set("Domain > Plane", "Strain").remove("Domain > Thickness")
        scene.set("Domain > Lower Corner", [-0.005, -0.005]).set("Domain > Upper Corner", [0.085, 0.015])
        scene.set("Time", {"Final Time": 1.0, "Analysis": "Static", "Load Steps": 4})
        sheet = self.release(scene)
        self.assertAlmostEqual(sheet["G_J"] / (height * stored), 1.0, delta=0.01)

    def test_a_body_that_flies_keeps_its_G(self):
        """Nothing depends on where the body is: it may leave the domain. What is left is rounding of positions that grow by the way."""
        rows = []
        for speed in (0.0, self.rng.uniform(100.0, 300.0)):
            angle = self.rng.uniform(0.0, 2.0 * math.pi)
            scene = strip(5e6)
            scene.set("Time", {"Final Time": 2e-4})
            scene.set("Bodies > Strip > Velocity", [speed * math.cos(angle), speed * math.sin(angle)])
            scene.set("Output > History Interval", 2e-5)
            rows.append(self.run_scene(scene, f"speed_{speed:.0f}")[1])
        self.assertEqual(len(rows[0]), len(rows[1]))
        largest = max(row["Notch.0.G_J"] for row in rows[0])
        self.assertGreater(largest, 100.0)
        for still, flying in zip(*rows):
            self.assertAlmostEqual(flying["Notch.0.G_J"], still["Notch.0.G_J"], delta=1e-7 * largest)
            self.assertAlmostEqual(flying["strain"], still["strain"], delta=1e-7 * max(row["strain"] for row in rows[0]))

    def test_a_crack_in_a_body_that_turns(self):
        """A strip that is set spinning, over one turn: kinetic and strain energy add up to the same, and the mean of G is that of other cells."""
        spin = self.rng.uniform(1500.0, 3000.0)
        results = []
        for cell in (0.0025, 0.002):
            scene = strip(0.0, cell)
            scene.remove("Boundaries")
            scene.set("Time", {"Final Time": 2.0 * math.pi / spin})
            scene.set("Bodies > Strip > Angular Velocity", [spin])
            scene.set("Output > History Interval", 0.02 * math.pi / spin)
            summary, rows = self.run_scene(scene, f"cell_{cell:g}")
            whole = rows[0]["kinetic"] + rows[0]["strain"]
            self.assertGreater(max(row["strain"] for row in rows), 1e-7 * whole)
            for row in rows:
                self.assertAlmostEqual((row["kinetic"] + row["strain"]) / whole, 1.0, delta=1e-3)
            results.append(sum(row["Notch.0.G_J"] for row in rows) / len(rows))
        self.assertAlmostEqual(results[0] / results[1], 1.0, delta=0.05)


if __name__ == "__main__":
    unittest.main()
