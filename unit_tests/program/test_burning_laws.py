#!/usr/bin/env python3
"""Burn rates of Ward, Son and Brewster in a closed bomb, flames that spread with the pressure, and faces too close to burn.

Pressures and constants are drawn; RHEGMA_SEED in the environment chooses them, and is printed."""

import math
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from drawn_scenes import DrawnScenes  # noqa: E402
from scenes import Scene  # noqa: E402

GAS, FLAME, DENSITY, LENGTH, THICKNESS, CAVITY = 243.0, 2700.0, 1840.0, 5e-3, 0.01, 1e-6
EXPLOSIVE = {"Burn Law": "Ward-Son-Brewster", "Solid Prefactor": 1.637e15, "Solid Activation Energy": 1.76e5, "Gas Prefactor": 1.6e-3,
             "Solid Heat Release": 4e5, "Gas Heat Release": 3.018e6, "Solid Conductivity": 0.2, "Gas Conductivity": 0.07, "Specific Heat": 1400.0,
             "Molar Mass": 0.0342, "Solid Temperature": 298.0}


def rate(pressure, s=EXPLOSIVE):
    """Ward, Son and Brewster by bisection of the surface temperature."""
    R, c, rest = 8.314462618, s["Specific Heat"], s["Solid Temperature"]
    C = 4.0 * s["Gas Conductivity"] * s["Gas Prefactor"] * (s["Molar Mass"] * pressure / R) ** 2 / c

    def flux(T):
        return math.sqrt(s["Solid Prefactor"] * R * T * T * s["Solid Conductivity"] * DENSITY * math.exp(-s["Solid Activation Energy"] / (R * T))
                         / (s["Solid Activation Energy"] * (c * (T - rest) - 0.5 * s["Solid Heat Release"])))

    low, high = rest + s["Solid Heat Release"] / c, rest + (s["Solid Heat Release"] + s["Gas Heat Release"]) / c
    start = low
    for _ in range(60):
        T = 0.5 * (low + high)
        m = flux(T)
        low, high = (T, high) if T < start + s["Gas Heat Release"] / c * C / (m + math.sqrt(m * m + C)) ** 2 else (low, T)
    return flux(low) / DENSITY


class BurningLaws(DrawnScenes):
    def bomb(self, pressure, time, **more):
        """A crack whose faces burn into a rigid cavity much larger than its opening."""
        return Scene({
            "Domain": {"Dimension": 2, "Plane": "Strain", "Thickness": THICKNESS, "Lower Corner": [-0.002] * 2, "Upper Corner": [0.032, 0.013],
                       "Cell Size": 1e-3},
            "Time": {"Final Time": time},
            "Materials": {"Explosive": {"Model": "Linear Elastic", "Density": DENSITY, "Young Modulus": 3e11, "Poisson Ratio": 0.3}},
            "Bodies": {"Block": {"Material": "Explosive", "Shape": "Box", "Lower Corner": [0.0, 0.0], "Upper Corner": [0.03, 0.011]}},
            "Cracks": {"Slit": {"Points": [0.0125, 0.0055, 0.0125 + LENGTH, 0.0055]}},
            "Combustion": {"Slit": {**EXPLOSIVE, "Gas Constant": GAS, "Flame Temperature": FLAME, "Initial Temperature": FLAME,
                                    "Initial Pressure": pressure, "Outside Pressure": pressure, "Cavity Volume": CAVITY, **more}},
            "Damping": {"Mass Rate": 2e4},
            "Output": {"History Interval": time / 50.0, "Fields": False, "Checkpoints": False},
        })

    def test_closed_bomb(self):
        for pressure in (self.rng.uniform(1e5, 5e5), self.rng.uniform(2e6, 1e7)):
            time = 3e-4
            area = 2.0 * LENGTH * THICKNESS
            p, dt = pressure, time / 2000.0

            def slope(p):
                """Energy of an ideal gas with the heat capacity ratio 1.25: burnt mass adds to it, and the burnt volume grows against p."""
                return (DENSITY * GAS * FLAME - 1.25 * p) * area * rate(p) / CAVITY

            for _ in range(2000):
                p += dt * slope(p + 0.5 * dt * slope(p))
            summary, _ = self.run_scene(self.bomb(pressure, time))
            found = summary["cracks"][0]["pressure"]
            print(f"from {pressure / 1e6:.3g} MPa: rise {found - pressure:.5g} Pa, equations {p - pressure:.5g} Pa")
            with self.subTest(pressure=pressure):
                self.assertLess(abs((found - pressure) / (p - pressure) - 1.0), 0.002)

    def test_flame_spreads_with_the_pressure(self):
        """From one end at a pressure that hardly rises, at 16 m/s. The mass that burns is in proportion to the square of the time; the last
        of ten face points makes an error of 5 %."""
        pressure, exponent, speed = self.rng.uniform(1e6, 1e7), self.rng.uniform(0.3, 1.0), self.rng.uniform(3.0, 8.0)
        base = pressure * (16.0 / speed) ** (-1.0 / exponent)
        time = 0.95 * LENGTH / 16.0
        scene = self.bomb(pressure, time, **{"Ignition Point": [0.0125, 0.0055], "Flame Speed": speed, "Flame Speed Pressure": base,
                                             "Flame Speed Exponent": exponent, "Cavity Volume": 1.0})
        summary, _ = self.run_scene(scene)
        expected, found = DENSITY * rate(pressure) * THICKNESS * 16.0 * time**2, summary["cracks"][0]["burnt_mass"]
        print(f"burnt {found:.4g} kg, expected {expected:.4g} kg")
        self.assertLess(abs(found / expected - 1.0), 0.1)

    def test_faces_too_close_do_not_burn(self):
        """Faces a gap apart burn at a pressure above that of the least opening, and not below it."""
        gap = 10.0 ** self.rng.uniform(-6.0, -5.0)
        limit = (8e8 / gap**2) ** (1.0 / 2.84)
        for factor, burns in ((0.9, False), (1.1, True)):
            scene = self.bomb(factor * limit, 2e-5, **{"Initial Gap": gap, "Quenching Coefficient": 8e8, "Quenching Exponent": 2.84})
            scene.set("Bodies > Block > Material", "Explosive").set("Materials > Explosive > Young Modulus", 3e13)
            summary, _ = self.run_scene(scene)
            with self.subTest(factor=factor, gap=gap):
                (self.assertGreater if burns else self.assertEqual)(summary["cracks"][0]["burnt_mass"], 0.0)

    def test_wrong_input(self):
        scene = self.bomb(1e6, 1e-6)
        scene.remove("Combustion > Slit > Molar Mass")
        self.assert_refused([self.write("scene.xml", scene.text())], [("Combustion > Slit > Molar Mass", ["missing"])])
        scene = self.bomb(1e6, 1e-6, **{"Flame Speed Exponent": 0.5})
        self.assert_refused([self.write("scene.xml", scene.text())], [("Combustion > Slit > Flame Speed Exponent", ["Flame Speed"])])
        scene = self.bomb(1e6, 1e-6, **{"Quenching Coefficient": 8e8})
        self.assert_refused([self.write("scene.xml", scene.text())], [("Combustion > Slit", ["Quenching Exponent"])])


if __name__ == "__main__":
    unittest.main()
