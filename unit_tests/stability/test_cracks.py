#!/usr/bin/env python3
"""Hard cases of cracks: odd positions, odd shapes, faces that close, slide and open again, fronts that run."""

import math
import os
import random
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from hard_case import HardCase, Scene, box, elastic, sized, space, traction  # noqa: E402


def plate(points, cell=0.05, time=8.0, stress=(0.0, 1e-3), history="t < 4 ? t/4 : 1", **sections):
    """A plate of 1 m by 2 m with one crack or more, pulled at both ends; waves of about 1 m/s."""
    cracks = points if isinstance(points, dict) else {"Notch": points}
    return Scene(
        {
            "Domain": space([-1.0, -1.0], [2.0, 3.0], cell),
            "Time": {"Final Time": time},
            "Materials": {"Solid": elastic()},
            "Bodies": {"Plate": box([0.0, 0.0], [1.0, 2.0])},
            "Boundaries": {
                "Bottom": traction("Plate", [0.0, 0.0], [1.0, 0.0], [-s for s in stress], history),
                "Top": traction("Plate", [1.0, 2.0], [0.0, 2.0], list(stress), history),
            },
            "Cracks": {name: {"Points": list(p)} for name, p in cracks.items()},
            "Output": {"History Interval": time / 100.0},
            **sections,
        }
    )


class Geometry(HardCase):
    def test_along_an_edge_of_the_cells(self):
        self.survives(plate([0.0, 1.0, 0.4, 1.0]), energy=0.02, momentum=True)

    def test_through_a_corner_of_the_cells(self):
        self.survives(plate([0.2, 0.8, 0.6, 1.2]), energy=0.02, momentum=True)

    def test_shorter_than_a_cell(self):
        self.survives(plate([0.51, 1.02, 0.54, 1.02]), energy=0.02, momentum=True)

    def test_turns_sharply(self):
        self.survives(plate([0.0, 0.9, 0.45, 0.95, 0.3, 1.2, 0.6, 1.25]), energy=0.02, momentum=True)

    def test_cuts_the_plate_in_two(self):
        outcome = self.survives(plate([-0.1, 1.02, 1.1, 1.02], time=2.0), energy=0.02, momentum=True)
        self.assertGreater(outcome.history["kinetic"][-1], 0.0)

    def test_fronts_four_cells_apart(self):
        cracks = {"Left": [0.0, 1.01, 0.39, 1.01], "Right": [1.0, 1.01, 0.6, 1.01]}
        self.survives(plate(cracks), energy=0.02, momentum=True)

    def test_many_cracks(self):
        chance = random.Random(3)
        cracks = {}
        for k in range(9):
            x, y, angle = 0.2 + 0.3 * (k % 3), 0.4 + 0.6 * (k // 3), chance.uniform(0.0, math.pi)
            dx, dy = 0.07 * math.cos(angle), 0.07 * math.sin(angle)
            cracks[f"Crack {k}"] = [x - dx, y - dy, x + dx, y + dy]
        self.survives(plate(cracks, cell=0.025, time=sized(2.0, 20.0)), energy=0.02, momentum=True)

    def test_flies_through_the_cells(self):
        for velocity in ([-0.02, 0.0], [0.02, 0.015]):
            with self.subTest(velocity=velocity):
                scene = plate([0.0, 1.01, 0.35, 1.01]).set("Bodies > Plate > Velocity", velocity)
                self.survives(scene, energy=0.05, gain=0.01, momentum=True)

    def test_spins(self):
        scene = plate([0.0, 1.01, 0.35, 1.01], time=sized(10.0, 100.0)).remove("Boundaries")
        scene.set("Bodies > Plate > Angular Velocity", [0.05])
        self.survives(scene, energy=0.05, gain=0.01, momentum=True)

    def test_surface_3d(self):
        polygon = [0.25, 0.25, 0.51, 0.75, 0.25, 0.51, 0.75, 0.75, 0.51, 0.25, 0.75, 0.51]
        scene = Scene(
            {
                "Domain": space([-0.5, -0.5, -0.5], [1.5, 1.5, 1.5], 0.125),
                "Time": {"Final Time": sized(2.0, 20.0)},
                "Materials": {"Solid": elastic()},
                "Bodies": {"Cube": box([0.0, 0.0, 0.0], [1.0, 1.0, 1.0], **{"Angular Velocity": [0.1, 0.2, 0.05]})},
                "Cracks": {"Inside": {"Points": polygon}},
                "Contact": {},
                "Output": {"History Interval": 0.02},
            }
        )
        self.survives(scene, energy=0.05, gain=0.01, momentum=True)


class Faces(HardCase):
    """Pressed shut, sheared, let go and pulled open, at random angles to the cells."""

    HISTORY = "sin(2*pi*t/8)"

    def closes(self, angle, contact):
        dx, dy = 0.25 * math.cos(angle), 0.25 * math.sin(angle)
        time = sized(8.0, 80.0)
        scene = plate([0.5 - dx, 1.013 - dy, 0.5 + dx, 1.013 + dy], time=time, stress=(0.0, -1e-3), history=self.HISTORY)
        scene.set("Contact", contact)
        # Contact of explicit faces is dissipative by nature where it rattles; it must not make energy.
        return self.survives(scene, energy=0.1, gain=0.02, momentum=True)

    def test_frictionless_at_random_angles(self):
        chance = random.Random(1)
        for _ in range(sized(3, 12)):
            angle = chance.uniform(0.0, math.pi)
            with self.subTest(degrees=round(math.degrees(angle), 2)):
                self.closes(angle, {"Law": "Frictionless"})

    def test_friction_at_random_angles(self):
        chance = random.Random(2)
        for _ in range(sized(2, 12)):
            angle = chance.uniform(0.0, math.pi)
            with self.subTest(degrees=round(math.degrees(angle), 2)):
                outcome = self.closes(angle, {"Law": "Coulomb", "Friction Coefficient": 0.3})
                self.assertGreaterEqual(min(outcome.history["contact"]), -1e-12)

    def test_stick(self):
        self.closes(0.3, {"Law": "Stick"})

    def test_stiff_penalty(self):
        self.closes(0.3, {"Penalty": 10.0})


def running(points, toughness, **sections):
    """A pulled plate whose crack runs."""
    sections.update({"Propagation": {"Toughness": toughness}, "Energy Release": {"Crack Closure": False}})
    return plate(points, cell=0.025, time=sized(8.0, 20.0), stress=(0.0, 2e-3), **sections)


class Fronts(HardCase):
    # G of a crack of 0.35 m under 2e-3 Pa is about 1.5e-5 J/m2.

    def test_runs_through_the_plate(self):
        outcome = self.survives(running([0.0, 1.01, 0.35, 1.01], "5e-6"), energy=0.03, momentum=True)
        self.assertGreater(outcome.history["fracture"][-1], 0.0)

    def test_runs_towards_another(self):
        """Two cells apart: cells can't resolve faces as near as that, so the front stops there and the rest goes on."""
        cracks = {"Left": [0.0, 1.01, 0.3, 1.01], "Right": [1.0, 1.06, 0.7, 1.06]}
        scene = running(cracks, "5e-6").set("Propagation > On Stop", "Continue")
        outcome = self.survives(scene, energy=0.03, momentum=True)
        self.assertGreater(outcome.history["fracture"][-1], 0.0)

    def test_runs_along_the_surface(self):
        """A front that meets the surface at a grazing angle; what it cuts off moves on inside the domain."""
        scene = running([0.0, 1.7, 0.3, 1.9], "5e-6").set("Propagation > Direction", "Straight")
        scene.set("Domain > Lower Corner", [-5.0, -5.0]).set("Domain > Upper Corner", [6.0, 8.0])
        self.survives(scene, energy=0.03, momentum=True)

    def test_branches_of_toughness_that_fall_and_rise(self):
        self.survives(running([0.0, 1.01, 0.35, 1.01], "5e-6*(v < 0.2 ? 1 - 2*v : 0.6 + 4*(v - 0.2))"), energy=0.03)

    def test_spins_as_it_runs(self):
        scene = running([0.0, 1.01, 0.35, 1.01], "5e-6").set("Bodies > Plate > Angular Velocity", [0.02])
        self.survives(scene, energy=0.05, gain=0.02, momentum=True)


if __name__ == "__main__":
    unittest.main()
