#!/usr/bin/env python3
"""Bodies that a crack cuts in two in equilibrium, and the energy balance of equilibria in few load steps.

RHEGMA_SEED in the environment draws other loads, cracks and temperatures.
"""

import json
import math
import os
import random
import re
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import ProgramTest, rhegma  # noqa: E402
from scenes import plate  # noqa: E402

SEED = int(os.environ.get("RHEGMA_SEED", "5"))
HELD = {"Type": "Velocity", "Components": "xy", "Value": [0.0, 0.0], "Lower Corner": [-0.1, -0.01], "Upper Corner": [1.1, 0.01]}
LIFTED = {"Type": "Velocity", "Components": "y", "Value": [0.0, 2e-3], "Lower Corner": [-0.1, 0.99], "Upper Corner": [1.1, 1.01]}
PULLED = {"Type": "Traction", "Body": "Plate", "From": [1.0, 1.0], "To": [0.0, 1.0], "Stress": [0.0, 2e7]}


def held_plate(analysis, steps, **boundaries):
    """The plate of 1 m and 1200 kg, held at its lower edge."""
    scene = plate().remove("Boundaries").remove("Cracks").remove("Energy Release")
    scene.set("Time", {"Analysis": analysis, "Final Time": 1.0, "Load Steps": steps}).set("Domain > Plane", "Strain")
    return scene.set("Boundaries", {"Held": HELD, **boundaries})


def cut_plate(height, **boundaries):
    """A crack at this height runs through the plate, whose upper edge is lifted and free to move along it. Another crack
    keeps the run going after the first has ended."""
    scene = held_plate("Quasi-Static", 10, Lifted=LIFTED, **boundaries)
    scene.set("Cracks", {"Notch": {"Points": [0.0, height, 0.4, height]}, "Flaw": {"Points": [0.4, 0.25, 0.6, 0.25]}})
    return scene.set("Energy Release", {}).set("Propagation", {"Toughness": "100", "Load Control": "Functions of Time"})


class EquilibriumTest(ProgramTest):
    def run_scene(self, scene):
        answer = rhegma(self.write("scene.xml", scene.text()), "--quiet", "--output", self.path("out"))
        with open(self.path("out", "summary.json"), encoding="utf-8") as file:
            return answer, json.load(file)


class CutInTwo(EquilibriumTest):
    def test_a_part_whose_weight_nothing_bears_ends_the_run(self):
        """The message has the weight of the part that can slide away, along the edge at which it is lifted."""
        draw = random.Random(SEED)
        gravity = draw.uniform(5.0, 20.0)
        weight = {"Type": "Gravity", "Acceleration": [gravity, 0.0]}
        answer, summary = self.run_scene(cut_plate(draw.uniform(0.515, 0.535), Weight=weight))
        self.assertEqual(answer.status, 2, answer)
        message = answer.messages.splitlines()[-1]
        for words in ("the run stopped at t = ", "a part of Bodies > Plate (", "has come off its supports and can move along x",
                      "its loads do not balance: a force of ", "support this part (Boundaries)", "Analysis = Dynamic"):
            self.assertIn(words, message)
        before = re.search(r" continues from t = ([\d.]+) ms", message)  # the load step before, which may be one of growth
        self.assertIsNotNone(before, message)
        self.assertTrue(100.0 <= float(before.group(1)) < 200.0, message)
        mass = float(message.split("Plate (")[1].split(" kg")[0])
        force = float(message.split("a force of ")[1].split(" N")[0])
        self.assertAlmostEqual(force / (mass * gravity), 1.0, delta=1e-3)  # printed in four digits
        self.assertGreater(mass, 480.0)  # of 1200 kg, cut in about half
        self.assertLess(mass, 720.0)
        self.assertLess(abs(summary["cracks"][0]["fronts"][0]["position"][0]), 1.1)  # nothing has flown away
        self.assertIn("energy balance: not given", "\n".join(summary["answers"]))

    def test_a_part_without_loads_is_reported(self):
        answer, summary = self.run_scene(cut_plate(0.52))
        self.assertEqual(answer.status, 0, answer)
        said = [warning for warning in summary["warnings"] if "has come off its supports" in warning]
        self.assertEqual(len(said), 1, summary["warnings"])
        self.assertIn("can move along x; its loads balance", said[0])
        # Unstable growth at given displacements: the energy released above the toughness is lost, which is said.
        self.assertLess(summary["energy"]["residual"], -0.3 * summary["energy"]["external_work"])
        self.assertTrue(any(warning.startswith("energy.residual") for warning in summary["warnings"]), summary["warnings"])
        self.assertTrue(any("unstable growth of cracks under given loads" in line for line in summary["answers"]))

    def test_heat_without_expansion_changes_nothing(self):
        """Many increments of growth within one load step: each continues from the one before, with heat as without."""
        draw = random.Random(SEED)
        height, toughness = draw.uniform(0.505, 0.545), draw.uniform(80.0, 150.0)
        summaries = []
        for heats in (False, True):
            scene = cut_plate(height).set("Propagation > Toughness", str(toughness))
            if heats:
                for name, value in (("Specific Heat", 800.0), ("Conductivity", 1.0), ("Thermal Expansion", 0.0)):
                    scene.set("Materials > Polymer > " + name, value)
                scene.set("Thermal", {"Initial Temperature": draw.uniform(250.0, 400.0), "Conduction": "Implicit"})
            answer, summary = self.run_scene(scene)
            self.assertEqual(answer.status, 0, answer)
            summaries.append(summary)
        plain, heated = summaries
        self.assertGreater(plain["energy"]["fracture"], 0.3 * toughness)  # grown by more than 0.3 m of a thickness of 1 m
        work = plain["energy"]["external_work"]
        for name, value in plain["energy"].items():
            self.assertAlmostEqual(heated["energy"][name] / work, value / work, delta=1e-9, msg=name)
        for one, other in zip(plain["cracks"], heated["cracks"]):
            for front, again in zip(one["fronts"], other["fronts"]):
                for x, y in zip(front["position"], again["position"]):
                    self.assertAlmostEqual(x, y, delta=1e-9)


class EnergyOfFewLoadSteps(EquilibriumTest):
    def residual(self, scene):
        """\\return residual over the work and the energy at the start, and the warnings of it"""
        answer, summary = self.run_scene(scene)
        self.assertEqual(answer.status, 0, answer)
        energy = summary["energy"]
        self.assertTrue(all(math.isfinite(value) for value in energy.values() if value is not None))
        return energy, [warning for warning in summary["warnings"] if warning.startswith("energy.residual")]

    def test_a_misfit_of_temperature(self):
        """A body that begins hotter or colder than without stress begins with the energy of its equilibrium: what it stores
        at the end, but for terms of the order of the thermal strain. Without, half of its energy was missing."""
        draw = random.Random(SEED)
        for steps in (1, 4):
            expansion, misfit = draw.uniform(2e-5, 5e-5), draw.choice((-1.0, 1.0)) * draw.uniform(100.0, 250.0)
            scene = held_plate("Static", steps)
            for name, value in (("Specific Heat", 800.0), ("Conductivity", 1.0), ("Thermal Expansion", expansion),
                                ("Reference Temperature", 300.0 + misfit)):
                scene.set("Materials > Polymer > " + name, value)
            scene.set("Thermal", {"Initial Temperature": 300.0, "Conduction": "Steady"})
            scene.set("Boundaries > Edge", {"Type": "Temperature", "Lower Corner": [-0.01, -0.01], "Upper Corner": [0.01, 1.1],
                                            "Temperature": 300.0})
            energy, said = self.residual(scene)
            # Energy of the clamped body, which it would begin with: 1/2 (alpha dT)^2 9 K for a volume of 1 m3.
            whole = 4.5 * (expansion * misfit) ** 2 * 3e9 / (3.0 * (1.0 - 2.0 * 0.33))
            strain = abs(expansion * misfit)
            print(f"misfit {misfit:.0f} K, {steps} steps: residual {energy['residual'] / whole:.4f} of the clamped body's energy, "
                  f"thermal strain {strain:.4f}")
            self.assertLess(abs(energy["residual"]), 4.0 * strain * whole)
            self.assertEqual(said, [])

    def test_plastic_flow_in_one_load_step_is_warned_of(self):
        """One step to twice the yield stress has the work of a straight line; in 16 the line is good to 1/16 squared of that."""
        def yielding(steps):
            scene = held_plate("Static", steps, Top=PULLED)
            scene.set("Materials > Polymer > Model", "J2 Plastic").set("Materials > Polymer > Yield Stress", 1e7)
            return scene.set("Materials > Polymer > Hardening Modulus", 1e9)

        one, said = self.residual(yielding(1))
        fraction = abs(one["residual"]) / one["external_work"]
        self.assertGreater(fraction, 0.1)
        self.assertEqual(len(said), 1)
        self.assertIn(f"{100.0 * fraction:.3g}", said[0])
        self.assertIn("more Time > Load Steps", said[0])
        many, said = self.residual(yielding(16))
        self.assertLess(abs(many["residual"]) / many["external_work"], fraction / 64.0)
        self.assertEqual(said, [])


if __name__ == "__main__":
    unittest.main()
