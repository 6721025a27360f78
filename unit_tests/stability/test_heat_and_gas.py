#!/usr/bin/env python3
"""Hard cases of heat and of burning cracks."""

import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from hard_case import HardCase, Scene, box, sized, space, traction  # noqa: E402

STEEL = {
    "Model": "Linear Elastic",
    "Density": 7800.0,
    "Young Modulus": 2.1e11,
    "Poisson Ratio": 0.3,
    "Specific Heat": 460.0,
    "Conductivity": 50.0,
    "Thermal Expansion": 1.2e-5,
}
PROPELLANT = {"Model": "Linear Elastic", "Density": 1200.0, "Young Modulus": 3e9, "Poisson Ratio": 0.3}


def shocked(cold, time, **thermal):
    """A hot plate of 10 mm whose left edge is suddenly cold; conduction is made fast, so that stress follows."""
    hot = {**STEEL, "Conductivity": 5e7}
    return Scene(
        {
            "Domain": space([-0.002, -0.002], [0.014, 0.014], 0.001),
            "Time": {"Final Time": time},
            "Materials": {"Solid": hot},
            "Bodies": {"Plate": box([0.0, 0.0], [0.01, 0.01])},
            "Boundaries": {
                "Cold": {
                    "Type": "Temperature",
                    "Lower Corner": [-0.002, -0.002],
                    "Upper Corner": [1e-6, 0.014],
                    "Temperature": cold,
                }
            },
            "Thermal": {"Initial Temperature": 900.0, **thermal},
            "Output": {"History Interval": time / 100.0},
        }
    )


def burning(time, **more):
    gas = {
        "Burn Law": "Vieille",
        "Burn Coefficient": 1e-8,
        "Burn Exponent": 0.9,
        "Gas Constant": 320.0,
        "Flame Temperature": 2500.0,
        "Initial Pressure": 1e6,
        "Initial Temperature": 2500.0,
        "Initial Gap": 1e-5,
        **more,
    }
    return Scene(
        {
            "Domain": space([-0.01, -0.01], [0.11, 0.11], 0.0025, Plane="Strain"),
            "Time": {"Final Time": time},
            "Materials": {"Propellant": PROPELLANT},
            "Bodies": {"Block": box([0.0, 0.0], [0.1, 0.1], material="Propellant")},
            "Cracks": {"Slit": {"Points": [0.03, 0.0501, 0.07, 0.0501]}},
            "Combustion": {"Slit": gas},
            "Output": {"History Interval": time / 100.0},
        }
    )


class Heat(HardCase):
    def test_thermal_shock(self):
        outcome = self.survives(shocked(300.0, sized(1e-4, 1e-3)), energy=0.02)
        self.assertGreaterEqual(outcome.particles["temperature"].min(), 250.0)

    def test_shock_close_to_absolute_zero(self):
        scene = shocked(1.0, sized(3e-5, 1e-3)).set("Time > CFL", sized(0.4, 0.1))
        self.survives(scene, energy=0.02)

    def test_conduction_at_the_limit_of_its_step(self):
        self.survives(shocked(300.0, 3e-5, **{"Diffusion Number": 0.5}), energy=0.02)

    def test_plastic_heat_of_a_fast_impact(self):
        metal = {**STEEL, "Model": "J2 Plastic", "Yield Stress": 4e8, "Hardening Modulus": 1e9}
        scene = Scene(
            {
                "Domain": space([0.0, -0.02], [0.05, 0.02], 0.001),
                "Time": {"Final Time": sized(1e-5, 4e-5), "CFL": 0.3},
                "Materials": {"Solid": metal},
                "Bodies": {"Rod": box([0.001, -0.004], [0.025, 0.004], Velocity=[-300.0, 0.0])},
                "Boundaries": {"Wall": {"Type": "Symmetry", "Axis": "x", "Position": 0.0}},
                "Thermal": {"Initial Temperature": 300.0},
                "Output": {"History Interval": 2e-7},
            }
        )
        outcome = self.survives(scene, energy=0.1, gain=0.01)
        self.assertGreater(outcome.particles["temperature"].max(), 310.0)


class Gas(HardCase):
    def test_ignition_in_a_closed_crack(self):
        scene = burning(sized(4e-5, 2e-4), **{"Ignition Point": [0.05, 0.0501], "Flame Speed": 500.0})
        self.survives(scene.set("Contact", {}), energy=0.02)

    def test_pressed_shut_and_lit(self):
        scene = burning(sized(4e-5, 2e-4)).set("Contact", {})
        scene.set(
            "Boundaries",
            {
                "Bottom": traction("Block", [0.0, 0.0], [0.1, 0.0], [0.0, 5e6], "t < 1e-5 ? t/1e-5 : 1"),
                "Top": traction("Block", [0.1, 0.1], [0.0, 0.1], [0.0, -5e6], "t < 1e-5 ? t/1e-5 : 1"),
            },
        )
        self.survives(scene, energy=0.02)

    def test_runaway(self):
        """An exponent above 1 in a closed crack: numbers to the end."""
        scene = burning(4e-5, **{"Burn Exponent": 1.3, "Burn Coefficient": 1e-10})
        self.survives(scene, energy=0.05)

    def test_gas_drives_a_crack_through_its_block(self):
        scene = burning(sized(6e-5, 2e-4), **{"Initial Pressure": 2e7}).set("Propagation", {"Toughness": "100.0"})
        scene.set("Energy Release", {"Crack Closure": False})
        self.survives(scene, energy=0.03)


if __name__ == "__main__":
    unittest.main()
