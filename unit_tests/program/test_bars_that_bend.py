#!/usr/bin/env python3
"""A slender bar that bends by a part of its length in equilibrium: its energy against the elastica, in few load steps and iterations.

RHEGMA_SEED in the environment draws other bars.
"""

import json
import os
import random
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

import numpy  # noqa: E402
from program import ProgramTest, rhegma  # noqa: E402
from scenes import Scene  # noqa: E402

SEED = int(os.environ.get("RHEGMA_SEED", "20261129"))
MODULUS, THICKNESS = 2e9, 1e-3


def elastica(load):
    """Strain energy of a clamped bar under a force at its end that keeps its direction, over EI / (2 L). load: force times L^2 / (E I). theta'' = -load
    cos(theta) along the bar of length 1, theta = 0 at the clamp and theta' = 0 at the end, by shooting with steps of Runge and Kutta."""
    def end(curvature, steps=400):
        state, energy, h = numpy.array([0.0, curvature]), 0.0, 1.0 / steps

        def rate(s):
            return numpy.array([s[1], -load * numpy.cos(s[0])])
        for _ in range(steps):
            a = rate(state)
            b = rate(state + 0.5 * h * a)
            c = rate(state + 0.5 * h * b)
            d = rate(state + h * c)
            middle = state + 0.5 * h * b
            after = state + h / 6.0 * (a + 2.0 * b + 2.0 * c + d)
            energy += h / 6.0 * (state[1] ** 2 + 4.0 * middle[1] ** 2 + after[1] ** 2)
            state = after
        return state[1], energy
    low, high = 0.0, 2.0 * load
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if end(middle)[0] < 0.0 else (low, middle)
    return end(low)[1]


class BarsThatBend(ProgramTest):
    def test_against_the_elastica(self):
        draw = random.Random(SEED)
        length, width = draw.uniform(0.08, 0.12), draw.uniform(3.6e-3, 4.4e-3)
        inertia = THICKNESS * width**3 / 12.0
        print(f"seed {SEED}: bar of {1e3 * length:.1f} x {1e3 * width:.2f} mm")

        def energy(bend, analysis="Static"):
            """Of a bar whose end a linear theory would move by this part of its length; and the summary."""
            force = 3.0 * MODULUS * inertia * bend / length**2
            scene = Scene({
                "Domain": {"Dimension": 2, "Plane": "Stress", "Thickness": THICKNESS, "Lower Corner": [-0.005, -0.06], "Upper Corner": [0.13, 0.06],
                           "Cell Size": 1e-3},
                "Time": {"Analysis": analysis, "Final Time": 1.0},
                "Materials": {"Polymer": {"Model": "Linear Elastic", "Density": 1200.0, "Young Modulus": MODULUS, "Poisson Ratio": 0.3}},
                "Bodies": {"Bar": {"Material": "Polymer", "Shape": "Box", "Lower Corner": [0.0, -0.5 * width], "Upper Corner": [length, 0.5 * width]}},
                "Boundaries": {"Clamp": {"Type": "Velocity", "Lower Corner": [-1.0, -1.0], "Upper Corner": [1e-6, 1.0], "Value": [0.0, 0.0]},
                               "Load": {"Type": "Traction", "Body": "Bar", "From": [length, -0.5 * width], "To": [length, 0.5 * width],
                                        "Stress": [0.0, force / (THICKNESS * width)]}},
                "Output": {"Fields": False}})
            answer = rhegma(self.write("scene.xml", scene.text()), "--quiet", "--output", self.path("out"))
            self.assertEqual(answer.status, 0, answer)
            with open(self.path("out", "summary.json"), encoding="utf-8") as file:
                summary = json.load(file)
            return summary["energy"]["strain"], summary

        small = 1e-3
        linear = energy(small)[0]
        # The cells bend too stiffly, by some percent with four across: that is a smaller load on the elastica.
        softness = linear / (0.5 * MODULUS * inertia / length * elastica(3.0 * small))
        for bend, most, iterations in ((0.02, 3, 40), (0.1, 10, 150), (0.25, 25, 400)):
            found, summary = energy(bend)
            load = 3.0 * bend
            exact = elastica(softness * load) / elastica(softness * 3.0 * small)
            steps = summary["equilibrium"]
            print(f"bend {bend}: energy {found / linear / exact - 1.0:+.2e} of the elastica, {steps['load_steps']} load steps, {steps['iterations']} iterations, "
                  f"residual {summary['energy']['residual'] / found:+.1e}")
            self.assertAlmostEqual(found / linear / exact, 1.0, delta=0.02)  # the stiffness of four cells changes by a percent as the bar turns in them
            self.assertLess(abs(summary["energy"]["residual"]), 3e-3 * found)
            self.assertLessEqual(steps["load_steps"], most)
            self.assertLessEqual(steps["iterations"], iterations)
        # A load that is there at once bends the bar as far in any step: one step is accepted, with the energy that it misses.
        found, summary = energy(0.1, "Quasi-Static")
        exact = elastica(softness * 0.3) / elastica(softness * 3.0 * small)
        print(f"at once: energy {found / linear / exact - 1.0:+.2e} of the elastica, {summary['equilibrium']['iterations']} iterations")
        self.assertAlmostEqual(found / linear / exact, 1.0, delta=0.03)
        self.assertLessEqual(summary["equilibrium"]["iterations"], 150)


if __name__ == "__main__":
    unittest.main()
