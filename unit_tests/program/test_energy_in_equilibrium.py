#!/usr/bin/env python3
"""The energy balance of analyses of equilibrium closes where work and energies are known, and a warning says where cracks took an energy
that was not released."""

import json
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import ProgramTest, rhegma  # noqa: E402
from scenes import Scene  # noqa: E402

MODULUS, POISSON = 3e9, 0.35
ACRYLIC = {"Model": "Linear Elastic", "Density": 1190.0, "Young Modulus": MODULUS, "Poisson Ratio": POISSON}
STEEL = {"Model": "Linear Elastic", "Density": 7850.0, "Young Modulus": 2.1e11, "Poisson Ratio": 0.3}


def moved(low, high, width, velocity):
    return {"Type": "Velocity", "Lower Corner": [-1e-3, low], "Upper Corner": [width + 1e-3, high], "Value": [0.0, velocity]}


def box(material, lower, upper, **more):
    return {"Material": material, "Shape": "Box", "Lower Corner": lower, "Upper Corner": upper, **more}


def gripped(speed, stress, steps):
    """A strip between grips that a traction pulls at the edge within one of them."""
    return Scene(
        {
            "Domain": {"Dimension": 2, "Plane": "Stress", "Thickness": 3e-3, "Lower Corner": [-0.01, -0.01], "Upper Corner": [0.05, 0.09],
                       "Cell Size": 4e-3},
            "Time": {"Analysis": "Static", "Final Time": 1.0, "Load Steps": steps},
            "Materials": {"Acrylic": ACRYLIC},
            "Bodies": {"Strip": box("Acrylic", [0.0, 0.0], [0.04, 0.08])},
            "Boundaries": {
                "Up": moved(0.07, 0.081, 0.04, speed),
                "Down": moved(-1e-3, 0.01, 0.04, -speed),
                "Pull": {"Type": "Traction", "Body": "Strip", "From": [0.04, 0.08], "To": [0.0, 0.08], "Stress": [0.0, stress]},
            },
        }
    )


def bimetal(expansion, slender):
    """Two bonded layers of 8 mm, of which one has cooled by 30 K."""
    length = 0.008 * slender
    heat = {"Specific Heat": 1500.0, "Conductivity": 0.2, "Reference Temperature": 330.0}
    return Scene(
        {
            "Domain": {"Dimension": 2, "Plane": "Stress", "Thickness": 3e-3, "Lower Corner": [-0.01, -0.01],
                       "Upper Corner": [length + 0.01, 0.03], "Cell Size": 2e-3},
            "Time": {"Analysis": "Quasi-Static", "Final Time": 1.0, "Load Steps": 2, "Rigid Modes": "Remove"},
            "Materials": {"A": {**ACRYLIC, **heat, "Thermal Expansion": expansion}, "B": {**ACRYLIC, **heat, "Thermal Expansion": 0.0}},
            "Bodies": {"Low": box("A", [0.0, 0.0], [length, 0.008]),
                       "High": box("B", [0.0, 0.008], [length, 0.016], **{"Bonded To": "Low"})},
            "Thermal": {"Initial Temperature": 300.0, "Conduction": "Implicit"},
        }
    )


def growing(right, contour):
    """A strip with an edge crack, bonded to another one, between grips; an increment of a cell a load step."""
    return Scene(
        {
            "Domain": {"Dimension": 2, "Plane": "Stress", "Thickness": 3e-3, "Lower Corner": [-0.01, -0.01], "Upper Corner": [0.05, 0.05],
                       "Cell Size": 1e-3},
            "Time": {"Analysis": "Quasi-Static", "Final Time": 1.0, "Load Steps": 3},
            "Materials": {"Acrylic": ACRYLIC, "Steel": STEEL},
            "Bodies": {"Strip": box("Acrylic", [0.0, 0.0], [0.02, 0.04]),
                       "Plate": box(right, [0.02, 0.0], [0.04, 0.04], **{"Bonded To": "Strip"})},
            "Boundaries": {"Up": moved(0.0399, 0.0401, 0.04, 1e-4), "Down": moved(-1e-4, 1e-4, 0.04, 0.0)},
            "Cracks": {"Notch": {"Points": [0.0, 0.02, 0.012, 0.02]}},
            "Energy Release": {},
            "Propagation": {"Toughness": "400", "Increment": 1.0, "Release Contour": contour},
        }
    )


class Balance(ProgramTest):
    def summary(self, scene):
        answer = rhegma(self.write("scene.xml", scene.text()), "--output", self.path("out"), "--quiet")
        self.assertEqual(answer.status, 0, answer)
        with open(self.path("out", "summary.json"), encoding="utf-8") as file:
            return json.load(file)

    def of_energy(self, summary):
        return [w for w in summary["warnings"] if "energy.residual" in w]

    def test_load_on_a_moving_support(self):
        """The trapezoidal rule is exact up to the strain in one load step, and for each of several. Half of the work of the load, 7.5 to
        30 mJ, was missing."""
        for speed, stress in ((1e-4, 5e6), (1e-5, 5e6), (1e-4, -5e6)):
            for steps in (1, 4):
                with self.subTest(speed=speed, stress=stress, steps=steps):
                    summary = self.summary(gripped(speed, stress, steps))
                    energy = summary["energy"]
                    strain = 2.0 * speed / 0.06 + abs(stress) / MODULUS
                    print(f"{speed} m, {stress} Pa, {steps} steps: residual {energy['residual']:.3g} J of {energy['strain']:.3g} J")
                    self.assertLess(abs(energy["residual"]), strain * energy["strain"])
                    self.assertEqual(self.of_energy(summary), [])

    def test_misfit_of_temperatures(self):
        """What the bar stores at the start is the energy of its equilibrium, not that of the misfit, which is some 25 times as large: the
        balance closes to a part of that energy of the order of the misfit, whether the bar bends much or little."""
        for expansion in (1e-4, 1e-5):
            for slender in (4, 12):
                with self.subTest(expansion=expansion, slender=slender):
                    summary = self.summary(bimetal(expansion, slender))
                    energy = summary["energy"]
                    misfit = 30.0 * expansion
                    released = MODULUS * misfit**2 / (1.0 - POISSON) * 0.008**2 * slender * 3e-3
                    print(f"{misfit}, 1:{slender}: residual {energy['residual']:.3g} J, strain {energy['strain']:.3g} J, "
                          f"start {energy['start']:.3g} J, misfit {released:.3g} J")
                    self.assertLess(abs(energy["residual"]), misfit * released)
                    self.assertEqual(self.of_energy(summary), [])

    def test_misfit_of_temperatures_and_load(self):
        """What is stored at the start does not depend on a load of the first load step, and the work of the load is that over the
        displacement that it causes, sigma^2 V / 2 E of a straight bar, both to the order of the misfit as the sum of both. Half of the load's
        work over the displacement of the misfit was counted as energy of the start, two thirds more, and the work was negative."""
        slender, misfit, stress = 12, 30.0 * 1e-4, 1e6
        length, alone = 0.008 * slender, self.summary(bimetal(1e-4, slender))["energy"]
        released = MODULUS * misfit**2 / (1.0 - POISSON) * 0.008**2 * slender * 3e-3
        for steps in (1, 4):
            with self.subTest(steps=steps):
                scene = bimetal(1e-4, slender).set("Time > Load Steps", steps).set("Boundaries", {
                    f"{name} {body}": {"Type": "Traction", "Body": body, "From": [x, low], "To": [x, low + 0.008],
                                       "Stress": [sign * stress, 0.0]}
                    for name, x, sign in (("Left", 0.0, -1.0), ("Right", length, 1.0)) for body, low in (("Low", 0.0), ("High", 0.008))})
                energy = self.summary(scene)["energy"]
                pull = stress**2 / (2.0 * MODULUS) * 0.016 * length * 3e-3
                print(f"{steps} steps: residual {energy['residual']:.3g} J, start {energy['start']:.4g} J (alone {alone['start']:.4g} J), "
                      f"external work {energy['external_work']:.4g} J (of a straight bar {pull:.4g} J)")
                self.assertLess(abs(energy["residual"]), misfit * released)
                self.assertLess(abs(energy["start"] - alone["start"]), misfit * released)
                self.assertLess(abs(energy["external_work"] - pull), 2.0 * misfit * released)
                self.assertGreater(energy["external_work"], 0.0)

    def test_growth_by_a_contour_that_contains_another_material(self):
        """The domain of 5 to 10 cells holds steel 8 cells ahead; with one material the balance closes."""
        for right, wrong in (("Steel", True), ("Acrylic", False)):
            with self.subTest(right=right):
                summary = self.summary(growing(right, [5.0, 10.0]))
                of_energy = self.of_energy(summary)
                print(f"{right}: residual {summary['propagation']['residual_fraction']:.3f} of the fracture energy")
                self.assertEqual(len(of_energy), 1 if wrong else 0, of_energy)
                contains = [w for w in summary["warnings"] if w.startswith("Propagation > Release Contour: ") and "Steel" in w]
                self.assertEqual(len(contains), 1 if wrong else 0, summary["warnings"])
                if wrong:
                    self.assertIn("G at which they grew is not the energy release rate", of_energy[0])

    def test_growth_under_displacements_of_time(self):
        """Load steps end at the start of growth. What is released above the toughness is at most the 1 % of G/Gc to which they lead, and
        half of the change of G in an increment of a quarter of a cell, 2 delta / a; 12 % were missing with steps of a tenth of the loads."""
        path = os.path.join(os.path.dirname(os.path.realpath(__file__)), "../../xml_inputs/verification/dcb_grips_static.xml")
        answer = rhegma(path, "--output", self.path("out"), "--quiet")
        self.assertEqual(answer.status, 0, answer)
        with open(self.path("out", "summary.json"), encoding="utf-8") as file:
            growth = json.load(file)["propagation"]
        print(f"residual {growth['residual_fraction']:.4f} of the fracture energy")
        self.assertLess(abs(growth["residual_fraction"]), 0.01 + 0.25 * 0.00125 / 0.04 * 2.0)
        start = growth["initiation"]
        self.assertLess(start["to"] - start["time"], 0.005 * start["time"])  # G/Gc is 1.01 there, and goes with the square of time

    def test_a_strip_that_breaks_through(self):
        """The jump at the end is no matter of G, nor of load steps: what bodies release there is named, in one warning."""
        scene = growing("Acrylic", [5.0, 10.0]).set("Time > Load Steps", 15).set("Propagation > Increment", 2.0)
        summary = self.summary(scene.remove("Propagation > Release Contour"))
        of_energy = self.of_energy(summary)
        self.assertTrue(summary["cracks"][0]["fronts"][0]["ended"])
        self.assertEqual(len(of_energy), 1, of_energy)
        self.assertIn("a front has reached a surface", of_energy[0])

    def test_supports_alone_have_no_displacement_of_loads(self):
        """The fall of the displacement of loads, which would be rounding, is not reported where there are no loads."""
        summary = self.summary(growing("Acrylic", [5.0, 10.0]))
        self.assertIsNotNone(summary["propagation"]["unstable_from"]["load_factor"])
        self.assertEqual(set(summary["propagation"]["snap_back_from"].values()), {None})


if __name__ == "__main__":
    unittest.main()
