#!/usr/bin/env python3
"""Cracks in bodies whose toughness depends on direction, in equilibrium and in motion.

Weak directions, strengths and angles of cracks are drawn; RHEGMA_SEED in the environment chooses them, and is printed."""

import math
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from drawn_scenes import DrawnScenes  # noqa: E402
from scenes import Scene  # noqa: E402

GC, HALF, WIDTH = 100.0, 6e-3, 0.03


def released(turn, k1=1.0, k2=0.0):
    """G of a short kink over that of the straight extension with K_I = 1 alone, from the stress of the crack on its plane (Cotterell and Rice,
    Int. J. Fract. 16 (1980) 155): good to 2 % at 40 degrees."""
    c, s = math.cos(0.5 * turn), math.sin(0.5 * turn)
    opening = c * c * c * k1 - 3.0 * s * c * c * k2
    sliding = s * c * c * k1 + c * (1.0 - 3.0 * s * s) * k2
    return opening**2 + sliding**2


class DirectionalToughness(DrawnScenes):
    def plate(self, ratio):
        """A plate under tension along y with a crack across it in its middle, anywhere in its cells."""
        at = [self.rng.uniform(-5e-4, 5e-4) for _ in range(2)]
        ends = [at[0] - HALF, at[1], at[0] + HALF, at[1]]
        sides = {"Top": 1.0, "Bottom": -1.0}
        return Scene({
            "Domain": {"Dimension": 2, "Plane": "Strain", "Lower Corner": [-WIDTH - 3e-3, -2.0 * WIDTH - 3e-3],
                       "Upper Corner": [WIDTH + 3e-3, 2.0 * WIDTH + 3e-3], "Cell Size": 7.5e-4},
            "Time": {"Analysis": "Quasi-Static", "Rigid Modes": "Remove", "Final Time": 1.0, "Load Steps": 2},
            "Materials": {"Polymer": {"Model": "Linear Elastic", "Density": 1200.0, "Young Modulus": 3e9, "Poisson Ratio": 0.3}},
            "Bodies": {"Plate": {"Material": "Polymer", "Shape": "Box", "Lower Corner": [-WIDTH, -2.0 * WIDTH], "Upper Corner": [WIDTH, 2.0 * WIDTH]}},
            "Boundaries": {name: {"Type": "Traction", "Surface": "Body", "Body": "Plate", "Facing": [0.0, sign], "Stress": [0.0, sign * 1e6]}
                           for name, sign in sides.items()},
            "Cracks": {"Slit": {"Points": ends}},
            "Energy Release": {},
            "Propagation": {"Toughness": GC, "Direction": "Maximum Energy Release", "Increment": 0.5,
                            **({"Toughness Ratio": ratio} if ratio else {})},
            "Output": {"Fields": False, "Checkpoints": False},
        })

    def start(self, scene):
        """(load factor at the start, angle of the first increment from the x axis of front 1 [degrees])"""
        summary, history = self.run_scene(scene)
        front = summary["cracks"][0]["fronts"][1]
        self.assertIsNotNone(front["first_turn"], front)
        return history["load_factor"][0], front["first_turn"]

    def test_the_first_increment_has_the_largest_release_over_its_toughness(self):
        """With cracks across the tension, against the largest of released(turn) / ratio(turn), and the load its root over that without a
        ratio."""
        plain, turn = self.start(self.plate(None))
        self.assertLess(abs(turn), 1.0)
        for _ in range(3):
            weak, strength = self.rng.uniform(-35.0, 35.0), self.rng.uniform(0.3, 2.0)
            text = f"1 + {strength:.4f}*sin(a - {weak:.4f}*pi/180)^2"

            def ratio(angle):
                return 1.0 + strength * math.sin(angle - math.radians(weak)) ** 2

            best = max((released(math.radians(0.01 * k)) / ratio(math.radians(0.01 * k)), 0.01 * k) for k in range(-8000, 8001))
            load, turn = self.start(self.plate(text))
            print(f"{text}: turns by {turn:.2f} (expected {best[1]:.2f}) degrees at {load / plain:.4f} (expected {best[0] ** -0.5:.4f}) of the load")
            with self.subTest(ratio=text):
                self.assertLess(abs(turn - best[1]), 2.0)
                self.assertLess(abs(load / plain * best[0] ** 0.5 - 1.0), 0.015)

    def test_a_ratio_of_one_changes_nothing_but_the_kink(self):
        """Across the tension a constant ratio multiplies the toughness."""
        factor = self.rng.uniform(1.5, 3.0)
        plain, _ = self.start(self.plate(None))
        load, turn = self.start(self.plate(f"{factor:.6f}"))
        self.assertLess(abs(turn), 1.5)
        # Both cracks are drawn at other positions in their cells.
        self.assertLess(abs(load / plain / math.sqrt(factor) - 1.0), 0.01)

    def test_a_crack_follows_a_weak_plane(self):
        """A steep minimum: the crack turns into the weak direction, and stays in it."""
        weak = self.rng.choice((-1.0, 1.0)) * self.rng.uniform(15.0, 35.0)
        scene = self.plate(f"1 + 3*(1 - exp(-(sin(a - {weak:.4f}*pi/180)/0.15)^2))").set("Time > Load Steps", 8)
        summary, _ = self.run_scene(scene)
        front = summary["cracks"][0]["fronts"][1]
        print(f"weak direction {weak:.2f} degrees, first turn {front['first_turn']:.2f}, turn at the end {front['turn']:.2f}")
        self.assertLess(abs(front["first_turn"] - weak), 2.0)
        self.assertLess(abs(front["turn"] - weak), 2.0)

    def test_in_motion(self):
        """Twice the toughness in all directions is a toughness of twice the number, and the energy of a crack that turns into a weak direction is
        that of its faces."""
        def strip(toughness, ratio):
            return Scene({
                "Domain": {"Dimension": 2, "Plane": "Stress", "Lower Corner": [-0.003, -0.023], "Upper Corner": [0.103, 0.023], "Cell Size": 1e-3},
                "Time": {"Final Time": 6e-5},
                "Materials": {"Acrylic": {"Model": "Linear Elastic", "Density": 1200.0, "Young Modulus": 3.2e9, "Poisson Ratio": 0.35}},
                "Bodies": {"Strip": {"Material": "Acrylic", "Shape": "Box", "Lower Corner": [0.0, -0.02], "Upper Corner": [0.1, 0.02]}},
                "Boundaries": {name: {"Type": "Traction", "Surface": "Body", "Body": "Strip", "Facing": [0.0, sign], "Stress": [0.0, 4e6 * sign]}
                               for name, sign in (("Top", 1.0), ("Bottom", -1.0))},
                "Cracks": {"Notch": {"Points": [-0.001, offset, 0.03, offset]}},
                "Energy Release": {},
                "Propagation": {"Toughness": f"{toughness}*(1 + v/1000)", "Direction": "Maximum Energy Release",
                                **({"Toughness Ratio": ratio} if ratio else {})},
                "Output": {"Fields": False, "Checkpoints": False}})

        offset, weak = self.rng.uniform(-4e-4, 4e-4), self.rng.choice((-1.0, 1.0)) * self.rng.uniform(10.0, 25.0)
        (one, _), (two, _) = self.run_scene(strip(400, None)), self.run_scene(strip(200, "2"))
        a, b = (summary["cracks"][0]["fronts"][0] for summary in (one, two))
        self.assertLess(abs(a["initiated"] / b["initiated"] - 1.0), 1e-3)
        self.assertLess(abs(a["length"] - b["length"]), 1.01e-3)  # an increment
        summary, _ = self.run_scene(strip(200, f"1 + 2*sin(a - {weak:.4f}*pi/180)^2"))
        front = summary["cracks"][0]["fronts"][0]
        print(f"weak direction {weak:.2f}: turned by {front['turn']:.2f} degrees, dissipated {summary['propagation']['dissipated_fraction']:.5f}")
        self.assertGreater(front["turn"] * math.copysign(1.0, weak), 0.4 * abs(weak))
        self.assertLess(front["turn"] * math.copysign(1.0, weak), 1.2 * abs(weak))
        self.assertLess(abs(summary["propagation"]["dissipated_fraction"] - 1.0), 0.005)

    def test_wrong_input(self):
        for text, words in (("1 + b", ["\"b\"", "the angle a"]), ("4 - a", ["one direction", "periodic"]), ("sin(a)", ["positive at all angles"]), ("2*(", ["not a valid expression"])):
            self.assert_refused([self.write("scene.xml", self.plate(text).text())], [("Propagation > Toughness Ratio", words)])
        scene = self.plate("2").set("Propagation > Direction", "Maximum Hoop Stress")
        self.assert_refused([self.write("scene.xml", scene.text())], [("Propagation > Toughness Ratio", ["Maximum Energy Release"])])


if __name__ == "__main__":
    unittest.main()
