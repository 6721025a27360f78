#!/usr/bin/env python3
"""Hard cases of bodies: vibration, flight, impact, large strain, odd positions in the cells."""

import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

import numpy as np  # noqa: E402
from hard_case import HardCase, Scene, box, elastic, sized, space, traction, walls  # noqa: E402


# Runs at full size are long enough to show that MUSL gains energy in proportion to the step (docs/explanation/stability.md). USAVG, which
# strains half before and half after the forces, needs no shorter steps.
LONG = sized(0.4, 0.1)
TWICE = "USAVG"


def free_bar(steps, cfl=0.4, **time):
    """A bar of 8 by 2 cells of 1 m, stretched for a moment and then left alone."""
    return Scene(
        {
            "Domain": space([-4.0, -4.0], [12.0, 6.0], 1.0),
            "Time": {"Final Time": 0.9 * steps * cfl, "CFL": cfl, **time},
            "Materials": {"Solid": elastic()},
            "Bodies": {"Bar": box([0.0, 0.0], [8.0, 2.0])},
            "Boundaries": {
                "Left": traction("Bar", [0.0, 2.0], [0.0, 0.0], [-1e-3, 0.0], "t < 8 ? sin(pi*t/8)^2 : 0"),
                "Right": traction("Bar", [8.0, 0.0], [8.0, 2.0], [1e-3, 0.0], "t < 8 ? sin(pi*t/8)^2 : 0"),
            },
            "Output": {"History Interval": 0.9 * steps * cfl / 400.0},
        }
    )


def flying(lower, upper, cell=0.1, velocity=(0.3, 0.2), model="Neo-Hookean", time=5.0, **body):
    """A body in flight, with waves of 1 m/s."""
    reach = 0.5 + time * max(abs(v) for v in velocity)
    return Scene(
        {
            "Domain": space([x - reach for x in lower], [x + reach for x in upper], cell),
            "Time": {"Final Time": time},
            "Materials": {"Solid": elastic(model=model)},
            "Bodies": {"Body": box(list(lower), list(upper), Velocity=list(velocity), **body)},
            "Output": {"History Interval": time / 100.0},
        }
    )


def towards_each_other(speed, time, model="Neo-Hookean", gap=0.05, **more):
    """Two blocks of 1 m in cells of 0.1 m, which meet with twice the speed."""
    scene = Scene(
        {
            "Domain": space([-2.5, -2.0], [3.5, 3.0], 0.1),
            "Time": {"Final Time": time, "CFL": 0.3},
            "Materials": {"Solid": {**elastic(model=model), **more}},
            "Bodies": {
                "Left": box([-1.0 - gap, 0.0], [0.0 - gap, 1.0], Velocity=[speed, 0.0]),
                "Right": box([0.0 + gap, 0.0], [1.0 + gap, 1.0], Velocity=[-speed, 0.0]),
            },
            "Output": {"History Interval": time / 100.0},
        }
    )
    return scene


class Bodies(HardCase):
    def test_vibration_of_many_steps(self):
        """A million steps at full size. In two cells of thickness the swing of the sum is a tenth of it."""
        self.survives(free_bar(sized(20000, 1000000), cfl=LONG), energy=0.1, momentum=True)

    def test_vibration_strained_twice_a_step(self):
        """Samples of USAVG have strain and velocity of one time, so that nothing swings."""
        self.survives(free_bar(sized(20000, 1000000), **{"Update Scheme": TWICE}), energy=0.005, momentum=True)

    def test_step_at_nine_tenths_of_the_limit(self):
        """At full size not with MUSL: it gains at such steps, and the watch halves them after 33,000."""
        for scheme, energy in sized((("MUSL", 0.2), (TWICE, 0.02)), (("USF", 0.2), (TWICE, 0.02))):
            with self.subTest(scheme=scheme):
                scene = free_bar(sized(4000, 100000), cfl=0.9, **{"Update Scheme": scheme})
                self.survives(scene, energy=energy, momentum=True)

    def test_stresses_updated_first(self):
        self.survives(free_bar(sized(4000, 100000), **{"Update Scheme": "USF"}), energy=0.1, momentum=True)

    def test_particles_on_faces_and_corners_of_cells(self):
        for shift in ((0.025, 0.025), (0.05, 0.0), (1e-12, -1e-12)):
            with self.subTest(shift=shift):
                lower = [1.0 + s for s in shift]
                scene = flying(lower, [x + 0.4 for x in lower], velocity=(0.1, 0.1), time=sized(4.0, 100.0))
                self.survives(scene, momentum=True)

    def test_nodes_that_matter_barely_reaches(self):
        """The body reaches a millionth of a cell into the next one, on two sides, and moves on slowly."""
        for kind in ("GIMP", "Linear"):
            with self.subTest(shape_functions=kind):
                scene = flying([0.0999999, 0.0999999], [0.5000001, 0.5000001], velocity=(1e-6, 1e-6), time=20.0)
                scene.set("Domain > Shape Functions", kind)
                self.survives(scene, momentum=True)

    def test_body_smaller_than_a_cell(self):
        self.survives(flying([0.02, 0.02], [0.07, 0.06], time=2.0), momentum=True)

    def test_body_that_crosses_many_cells(self):
        """With GIMP the energy balance loses a little at each crossing of a spinning body; nothing may be gained."""
        scene = flying([0.0, 0.0], [0.4, 0.3], velocity=(0.5, 0.35), time=sized(10.0, 100.0))
        scene.set("Bodies > Body > Angular Velocity", [1.0])
        self.survives(scene.set("Time > Update Scheme", TWICE), energy=0.01, momentum=True)
        scene.set("Time > Update Scheme", "MUSL").set("Time > CFL", LONG)
        self.survives(scene, energy=0.05, gain=0.01, momentum=True)

    def test_many_turns(self):
        scene = flying([0.0, 0.0], [0.6, 0.2], velocity=(0.0, 0.0), time=sized(30.0, 300.0))
        scene.set("Bodies > Body > Angular Velocity", [0.5])
        self.survives(scene.set("Time > Update Scheme", TWICE), energy=0.05, gain=0.02, momentum=True)
        scene.set("Time > Update Scheme", "MUSL").set("Time > CFL", LONG)
        self.survives(scene, energy=0.05, gain=0.02, momentum=True)

    def test_supersonic_impact(self):
        """Half again as fast as waves; the dissipation of the shock is a loss of the energy balance, never a gain."""
        outcome = self.survives(towards_each_other(0.8, sized(1.5, 3.0)), energy=1.0, gain=0.02, momentum=True)
        self.assertGreater(outcome.history["strain"].max(), 0.05 * outcome.history["kinetic"][0])

    def test_impact_of_a_metal(self):
        more = {"Yield Stress": 0.02, "Hardening Modulus": 0.05}
        self.survives(towards_each_other(0.1, 4.0, "J2 Plastic", **more), energy=0.1, gain=0.01, momentum=True)

    def test_rubber_stretched_tenfold(self):
        """By nodes that all move as in uniform stretch. Eight particles along a cell stay closer than a cell."""
        rubber = {"Model": "Mooney-Rivlin", "Density": 1.0, "C10": 0.14, "C01": 0.03, "Bulk Modulus": 3.3}
        scene = Scene(
            {
                "Domain": space([-1.0, -1.0], [12.0, 2.0], 0.125),
                "Time": {"Final Time": 46.5},
                "Materials": {"Solid": rubber},
                "Bodies": {"Bar": box([0.0, 0.0], [1.0, 0.5], **{"Particles Per Cell": 8})},
                "Boundaries": {
                    "Stretch": {
                        "Type": "Velocity",
                        "Lower Corner": [-1.0, -1.0],
                        "Upper Corner": [12.0, 2.0],
                        "Components": "x",
                        "Field": "0.05*x, 0",
                    },
                },
                "Output": {"History Interval": 0.5},
            }
        )
        outcome = self.survives(scene, energy=0.02)
        self.assertGreater(outcome.particles["deformation"].reshape(-1, 3, 3)[:, 0, 0].max(), 10.0)

    def test_nearly_incompressible(self):
        """A cantilever of Poisson's ratio 0.4999 that swings."""
        scene = Scene(
            {
                "Domain": space([-0.2, -0.6], [1.4, 0.8], 0.05),
                "Time": {"Final Time": sized(4.0, 40.0)},
                "Materials": {"Solid": elastic(poisson=0.4999)},
                "Bodies": {"Arm": box([0.0, 0.0], [1.0, 0.2])},
                "Boundaries": {
                    "Clamp": walls([-0.2, -0.6], [0.001, 0.8], "xy", [0.0, 0.0]),
                    "Weight": {"Type": "Gravity", "Acceleration": [0.0, -1e-3], "History": "t < 2 ? t/2 : 1"},
                },
                "Output": {"History Interval": 0.05},
            }
        )
        self.survives(scene, energy=0.02)

    def test_stiff_next_to_soft(self):
        """Two halves of a bar, one a million times as stiff as the other, pulled."""
        scene = Scene(
            {
                "Domain": space([-1.0, -0.5], [3.0, 1.0], 0.1),
                "Time": {"Final Time": sized(0.05, 5.0)},
                "Materials": {"Soft": elastic(), "Stiff": elastic(young=1e6)},
                "Bodies": {
                    "Soft": box([0.0, 0.0], [1.0, 0.5], material="Soft"),
                    "Stiff": box([1.0, 0.0], [2.0, 0.5], material="Stiff"),
                },
                "Boundaries": {
                    "Held": walls([-1.0, -0.5], [0.01, 1.0], "x", [0.0, 0.0]),
                    "Pull": traction("Stiff", [2.0, 0.0], [2.0, 0.5], [1e-3, 0.0]),
                },
                "Output": {"History Interval": sized(0.0005, 0.05)},
            }
        )
        self.survives(scene, energy=0.02)

    def test_thin_ligament(self):
        """Two blocks joined by a bridge of half a cell, pulled apart."""
        scene = Scene(
            {
                "Domain": space([-1.0, -1.0], [4.0, 2.0], 0.1),
                "Time": {"Final Time": sized(4.0, 40.0)},
                "Materials": {"Solid": elastic(model="Neo-Hookean")},
                "Bodies": {
                    "Body": {
                        **box([0.0, 0.0], [2.0, 1.0]),
                        "Operations": {
                            "Below": {"Operation": "Cut", "Shape": "Box", "Lower Corner": [0.9, -0.1], "Upper Corner": [1.1, 0.475]},
                            "Above": {"Operation": "Cut", "Shape": "Box", "Lower Corner": [0.9, 0.525], "Upper Corner": [1.1, 1.1]},
                        },
                    }
                },
                "Boundaries": {
                    "Left": traction("Body", [0.0, 1.0], [0.0, 0.0], [-1e-3, 0.0], "t < 2 ? sin(pi*t/2)^2 : 0"),
                    "Right": traction("Body", [2.0, 0.0], [2.0, 1.0], [1e-3, 0.0], "t < 2 ? sin(pi*t/2)^2 : 0"),
                },
                "Output": {"History Interval": sized(0.04, 0.4)},
            }
        )
        self.survives(scene, energy=0.02, momentum=True)

    def test_ball_against_a_wall_3d(self):
        """The work of the wall is known to the mean of the velocities that particles bring and take, here to 4 %."""
        scene = Scene(
            {
                "Domain": space([0.0, -1.0, -1.0], [3.0, 1.0, 1.0], 0.125),
                "Time": {"Final Time": sized(2.0, 6.0)},
                "Materials": {"Solid": elastic(model="Neo-Hookean")},
                "Bodies": {
                    "Ball": {
                        "Material": "Solid",
                        "Shape": "Ball",
                        "Centre": [0.7, 0.0, 0.0],
                        "Radius": 0.45,
                        "Velocity": [-0.3, 0.0, 0.0],
                    }
                },
                "Boundaries": {"Wall": {"Type": "Symmetry", "Axis": "x", "Position": 0.0}},
                "Output": {"History Interval": 0.02},
            }
        )
        self.survives(scene, energy=0.1, gain=0.05)

    def test_supports_that_hold_the_same_nodes(self):
        """A bar pulled under damping; the same support three times is one support, and one in the energy balance."""
        balance = []
        for copies in (1, 3):
            scene = Scene(
                {
                    "Domain": space([-1.0, -1.0], [11.0, 4.0], 0.5),
                    "Time": {"Final Time": 20.0},
                    "Materials": {"Solid": elastic()},
                    "Bodies": {"Bar": box([0.0, 0.0], [10.0, 3.0])},
                    "Boundaries": {"Held": walls([-1.0, -1.0], [0.5, 4.0], "x", [0.0, 0.0])},
                    "Damping": {"Mass Rate": 0.5},
                    "Output": {"History Interval": 0.1},
                }
            )
            for k in range(copies):
                scene.set(f"Boundaries > Pulled {k}", walls([9.5, -1.0], [11.0, 4.0], "x", [1e-3, 0.0]))
            outcome = self.survives(scene)
            balance.append([outcome.history[name] for name in ("damped", "external_work", "residual")])
        for one, three in zip(*balance):
            self.assertLess(np.abs(one - three).max(), 1e-12 * np.abs(balance[0][1]).max())


if __name__ == "__main__":
    unittest.main()
