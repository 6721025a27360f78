#!/usr/bin/env python3
"""Cracks in large plates whose stiffness depends on direction: K_I, K_II and G against the closed form of the infinite plate.

Constants, the directions of fibres and cracks and positions are drawn; RHEGMA_SEED in the environment chooses them, and is printed."""

import json
import math
import os
import random
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from anisotropic_crack import CARBON, central_crack, in_plane, own_stiffness, release_matrix  # noqa: E402
from orthotropic_plates import HALF_LENGTH, STRESS, cracked_plate  # noqa: E402
from program import ProgramTest, rhegma  # noqa: E402
from scenes import ball, plate  # noqa: E402

SEED = int(os.environ.get("RHEGMA_SEED", random.randrange(10**6)))

# Required of cracks of 64 cells in a plate 40 times as wide as the crack is long. Stress is channelled along stiff fibres, so that a plate
# of half this width has up to 1 % more K than an infinite one.
PART = 0.02


def drawn_material(draw):
    """Fibres up to 15 times as stiff as across, in GPa those of wood and composites."""
    across = draw.uniform(3e9, 12e9)
    young = (across * draw.uniform(1.0, 15.0), across, across * draw.uniform(0.8, 1.2))
    shear = across * draw.uniform(0.3, 0.8)
    return {"young": young, "poisson": (draw.uniform(0.1, 0.35), draw.uniform(0.2, 0.4), draw.uniform(0.1, 0.35)),
            "shear": (shear, 0.35 * across, shear)}


class OrthotropicPlates(ProgramTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        print(f"seed {SEED} (RHEGMA_SEED)", flush=True)

    def fronts(self, scene):
        out = self.path("out")
        answer = rhegma(self.write("scene.xml", scene.text()), "--output", out, "--quiet")
        self.assertEqual(answer.status, 0, answer)
        with open(os.path.join(out, "summary.json")) as file:
            return json.load(file)["cracks"][0]["fronts"]

    def compare(self, fronts, expected):
        """Parts of the total, sqrt(K_I^2 + K_II^2) and G. Side +1 of the crack lies right of its first front."""
        K1, K2, G = expected
        total = math.hypot(K1, K2)
        for front, side in zip(fronts, (-1.0, 1.0)):
            print(f"  K_I {front['K_I'] / total:.4f} for {K1 / total:.4f}, K_II {side * front['K_II'] / total:.4f} for {K2 / total:.4f}, "
                  f"G {front['G_J'] / G:.4f}", flush=True)
            self.assertAlmostEqual(front["K_I"] / total, K1 / total, delta=PART)
            self.assertAlmostEqual(side * front["K_II"] / total, K2 / total, delta=PART)
            self.assertAlmostEqual(front["G_J"] / G, 1.0, delta=PART)
            self.assertIsNone(front["kink_angle"])
            self.assertIn("Composite is anisotropic", front["no_error_estimate"])

    def test_cracks_of_any_direction(self):
        for number in range(3):
            draw = random.Random(SEED + number)
            material, plane = drawn_material(draw), draw.choice(["Stress", "Strain"])
            fibres, crack = draw.uniform(-math.pi / 2, math.pi / 2), draw.uniform(-math.radians(60), math.radians(60))
            middle = (draw.uniform(-5e-4, 5e-4), draw.uniform(-5e-4, 5e-4))
            with self.subTest(number, material=material, fibres=math.degrees(fibres), crack=math.degrees(crack), plane=plane):
                scene = cracked_plate(material, fibres, crack, plane, middle=middle)
                self.compare(self.fronts(scene), central_crack(**material, fibres=fibres, crack=crack, half_length=HALF_LENGTH,
                                                               stress=STRESS, plane_stress=plane == "Stress"))

    def test_a_body_turned_with_its_fibres(self):
        draw = random.Random(SEED)
        material, turn, fibres, crack = drawn_material(draw), draw.uniform(0.2, 1.3), draw.uniform(-1.5, 1.5), 0.4
        with self.subTest(material=material, turn=math.degrees(turn), fibres=math.degrees(fibres)):
            self.compare(self.fronts(cracked_plate(material, fibres, crack, turn=turn)),
                         central_crack(**material, fibres=fibres, crack=crack, half_length=HALF_LENGTH, stress=STRESS,
                                       plane_stress=False))

    def test_isotropic_constants_are_the_isotropic_law(self):
        """K and G of both laws, to what the solution of the equations leaves."""
        young, poisson = 3e9, 0.33
        material = {"young": [young] * 3, "poisson": [poisson] * 3, "shear": [young / 2 / (1 + poisson)] * 3}
        scene = cracked_plate(material, 0.7, 0.5, level=4)
        fronts = self.fronts(scene)
        for name in ("Young Moduli", "Poisson Ratios", "Shear Moduli", "Fibre Direction"):
            scene.remove(f"Materials > Composite > {name}")
        scene.set("Materials > Composite > Model", "Linear Elastic")
        scene.set("Materials > Composite > Young Modulus", young).set("Materials > Composite > Poisson Ratio", poisson)
        for one, other in zip(fronts, self.fronts(scene)):
            for name in ("K_I", "K_II"):
                self.assertAlmostEqual(one[name] / other["K_I"], other[name] / other["K_I"], delta=1e-5)
            self.assertAlmostEqual(one["G_J"] / other["G_J"], 1.0, delta=1e-5)

    def test_closed_form(self):
        """Of the references themselves: of a crack along fibres in plane stress Sih, Paris and Irwin have H in closed form."""
        E1, E2, _ = CARBON["young"]
        nu, shear = CARBON["poisson"][0], CARBON["shear"][0]
        H = release_matrix(in_plane(own_stiffness(**CARBON), True))
        root = math.sqrt(math.sqrt(E1 / E2) + (E1 / shear - 2 * nu) / 2)
        self.assertAlmostEqual(H[0, 0] * math.sqrt(2 * E1 * E2) / root, 1.0, delta=1e-9)
        self.assertAlmostEqual(H[1, 1] * math.sqrt(2) * E1 / root, 1.0, delta=1e-9)
        self.assertAlmostEqual(H[0, 1] / H[0, 0], 0.0, delta=1e-9)


class RefusedScenes(ProgramTest):
    def refused(self, scene, where, *words):
        self.assert_refused([self.write("scene.xml", scene.text())], [(where, words)])

    def orthotropic(self, scene, name, dimension=2):
        for parameter in ("Young Modulus", "Poisson Ratio"):
            scene.remove(f"Materials > {name} > {parameter}")
        scene.set(f"Materials > {name} > Model", "Orthotropic").set(f"Materials > {name} > Young Moduli", [40e9, 10e9, 10e9])
        scene.set(f"Materials > {name} > Poisson Ratios", [0.3, 0.4, 0.3]).set(f"Materials > {name} > Shear Moduli", [5e9, 3.5e9, 5e9])
        return scene

    def test_constants(self):
        scene = self.orthotropic(plate(), "Polymer").set("Materials > Polymer > Poisson Ratios", [2.1, 0.4, 0.3])
        self.refused(scene, "Materials > Polymer > Poisson Ratios", "nu12^2 < E1/E2 fails: 4.41 > 4")
        scene = self.orthotropic(ball(), "Rubber").set("Materials > Rubber > Fibre Direction", [0.0, 1.0, 0.0])
        self.refused(scene, "Materials > Rubber > Second Direction", "is parallel to Fibre Direction")

    def test_growth(self):
        scene = self.orthotropic(plate(), "Polymer").set("Propagation", {"Toughness": "100"})
        self.refused(scene, "Materials > Polymer > Model", "isotropic bodies", "Propagation > Direction = Straight")
        scene.set("Propagation > Direction", "Straight")
        self.refused(scene, "Propagation > Speed Limit", "is missing", "Rayleigh waves depends on direction")
        scene.set("Propagation > Speed Limit", 1000.0)
        answer = rhegma(self.write("scene.xml", scene.text()), "--check", "--quiet")
        self.assertEqual(answer.status, 0, answer)

    def test_heat(self):
        scene = self.orthotropic(plate(), "Polymer").remove("Energy Release").set("Thermal", {"Initial Temperature": 300.0})
        for name, value in (("Specific Heat", 1000.0), ("Conductivity", 0.2), ("Thermal Expansion", 1e-5)):
            scene.set(f"Materials > Polymer > {name}", value)
        answer = rhegma(self.write("scene.xml", scene.text()), "--check", "--quiet")
        self.assertEqual(answer.status, 1, answer)
        self.assertIn("the law Orthotropic has no thermal expansion, which differs from axis to axis", answer.messages)


if __name__ == "__main__":
    unittest.main()
