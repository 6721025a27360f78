#!/usr/bin/env python3
"""Cracks that run into something: each ends with a clear word, and nothing of the body is lost."""

import csv
import json
import math
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import SOURCE, ProgramTest, rhegma  # noqa: E402
from scenes import plate  # noqa: E402


def pulled_apart(points, toughness="1*(1 + v/300)", time=4e-3):
    """The plate, of 20 x 20 cells, pulled apart across the crack at two of its edges."""
    scene = plate().set("Energy Release", {}).set("Cracks > Notch > Points", points).set("Time > Final Time", time)
    scene.set("Propagation", {"Toughness": toughness}).remove("Boundaries > Pull")
    for name, y, sign in (("Top", 1.0, 1.0), ("Bottom", 0.0, -1.0)):
        scene.set("Boundaries > " + name, {"Type": "Traction", "Body": "Plate", "From": [0.0, y], "To": [1.0, y],
                                          "Stress": [0.0, sign * 2e5], "History": "0:0, 1e-3:1"})
    return scene


class RunningCracks(ProgramTest):
    def run_to_the_end(self, scene):
        """Finishes with finite numbers and all of the mass. Returns the summary and the lines of warning."""
        answer = rhegma(self.write("scene.xml", scene.text()), "--quiet")
        self.assertEqual(answer.status, 0, answer)
        with open(self.path("scene.out", "history.csv"), newline="") as file:
            rows = [[float(value) for value in row] for row in list(csv.reader(file))[1:]]
        self.assertGreater(len(rows), 10)
        self.assertTrue(all(math.isfinite(value) for row in rows for value in row))
        with open(self.path("scene.out", "summary.json")) as file:
            summary = json.load(file)
        self.assertAlmostEqual(summary["bodies"][0]["mass"], 1200.0, delta=1e-9 * 1200.0)
        # The energy of springs that soften is deducted from the first new faces: 5 % where there are few.
        fraction = summary["propagation"]["dissipated_fraction"]
        if summary["cracks"][0]["fronts"][0]["increments"] > 0 or fraction is not None:
            self.assertAlmostEqual(fraction, 1.0, delta=0.05)
        return summary, answer.messages

    def test_energy_balance_of_a_crack_at_the_rayleigh_speed(self):
        """Most of what its strip gives rings in the cells. Its held edges take some of that; all of it is known."""
        scene = os.path.join(SOURCE, "xml_inputs", "verification", "strip_running_constant.xml")
        out = self.path("strip")
        answer = rhegma(scene, "--quiet", "--output", out, "--set", "Propagation:Toughness=22.45",
                        "--set", "Domain:Cell Size=0.00125")
        self.assertIn(answer.status, (0, 4), answer)  # 4: the scene's own reference is for its own toughness
        with open(os.path.join(out, "summary.json")) as file:
            summary = json.load(file)
        self.assertAlmostEqual(summary["propagation"]["accounted_for"], 1.0, delta=0.003)
        self.assertGreater(summary["boundaries"][0]["energy_absorbed_from_short_waves"], 0.0)

    def test_crack_that_cuts_the_body_in_two(self):
        summary, said = self.run_to_the_end(pulled_apart([0.0, 0.52, 0.4, 0.52]))
        front = summary["cracks"][0]["fronts"][0]
        self.assertTrue(front["ended"])
        self.assertFalse(front["running"])
        self.assertAlmostEqual(front["position"][0], 1.0, delta=0.05)
        self.assertAlmostEqual(summary["cracks"][0]["length"], 1.0, delta=0.06)
        self.assertIn("reached the surface of its body", said)
        # The halves fly apart: the faces open everywhere.
        self.assertGreater(summary["cracks"][0]["opening"], 0.0)
        self.assertAlmostEqual(front["G_J"], 0.0)

    def test_crack_in_small_steps(self):
        """The cohesive traction follows its law in substeps: as a spring it dissipated 13 % more than the energy of new
        faces, which was in no balance, and the crack crossed the plate 2.5 % later."""
        scene = pulled_apart([0.0, 0.52, 0.4, 0.52]).set("Adaptivity", {"Maximum Level": 1, "Front Cells": 6.0})
        long_steps, _ = self.run_to_the_end(scene)
        short_steps, _ = self.run_to_the_end(scene.set("Sub-Cycling", {}))
        through = [run["cracks"][0]["fronts"][0]["last_advance"] for run in (long_steps, short_steps)]
        self.assertLess(abs(through[1] / through[0] - 1.0), 0.01)
        self.assertLess(abs(short_steps["propagation"]["residual_fraction"]), 0.05)

    def test_crack_that_grazes_the_surface(self):
        """Straight on, a crack at 10 degrees to an edge reaches it."""
        scene = pulled_apart([0.0, 0.25, 0.5, 0.16], toughness="0.1*(1 + v/300)")
        scene.set("Propagation > Direction", "Straight")
        summary, said = self.run_to_the_end(scene)
        front = summary["cracks"][0]["fronts"][0]
        self.assertTrue(front["ended"], summary["cracks"])
        self.assertIn("reached the surface of its body", said)

    def test_fronts_that_meet_another_crack(self):
        """Two cracks in one line run towards each other and become one, which cuts the body in two."""
        scene = pulled_apart([0.0, 0.52, 0.3, 0.52]).set("Cracks > Other", {"Points": [0.7, 0.52, 1.0, 0.52]})
        summary, said = self.run_to_the_end(scene)
        self.assertTrue(all(front["ended"] for crack in summary["cracks"] for front in crack["fronts"]), summary["cracks"])
        self.assertIn("met crack", said)
        self.assertIn("was met by", said)
        one, other = [crack["fronts"][0]["position"] for crack in summary["cracks"]]
        self.assertLess(math.hypot(one[0] - other[0], one[1] - other[1]), 0.5 * 0.05)
        # The halves fly apart: the faces open everywhere.
        self.assertGreater(min(crack["opening"] for crack in summary["cracks"]), 0.0)

    def test_front_that_has_too_little_to_run(self):
        summary, said = self.run_to_the_end(pulled_apart([0.0, 0.52, 0.4, 0.52], toughness="1e9"))
        front = summary["cracks"][0]["fronts"][0]
        self.assertEqual(front["increments"], 0)
        self.assertIsNone(front["initiated"])
        self.assertEqual(summary["energy"]["fracture"], 0.0)

    def test_contact_behind_a_front_that_runs(self):
        """Faces that opened are pressed together again: contact knows the new ones."""
        scene = pulled_apart([0.0, 0.52, 0.4, 0.52], toughness="10").set("Contact", {"Law": "Frictionless"})
        for name in ("Top", "Bottom"):
            scene.set("Boundaries > " + name + " > History", "0:0, 1e-3:1, 1.5e-3:1, 2e-3:-3")
        summary, said = self.run_to_the_end(scene)
        self.assertGreater(summary["cracks"][0]["fronts"][0]["increments"], 3)
        self.assertGreater(summary["cracks"][0]["contact"]["largest_pressure"], 0.0)

    def test_over_dissipated_faces(self):
        """Faces that come apart within a few steps or one take their toughness too, not 30 times as much."""
        scene = os.path.join(SOURCE, "xml_inputs", "verification", "strip_running_constant.xml")  # G is 134.7 J/m2
        for toughness in (22.45, 5.0, 1.0, 0.1):
            with self.subTest(toughness=toughness):
                out = self.path("strip")
                answer = rhegma(scene, "--quiet", "--output", out, "--set", f"Propagation:Toughness={toughness}",
                                "--set", "Domain:Cell Size=0.00125")
                self.assertIn(answer.status, (0, 4), answer)  # as above
                with open(os.path.join(out, "summary.json")) as file:
                    summary = json.load(file)
                self.assertGreater(summary["cracks"][0]["fronts"][0]["increments"], 50)
                self.assertAlmostEqual(summary["propagation"]["dissipated_fraction"], 1.0, delta=0.02)
                self.assertNotIn("Propagation: new faces dissipated", answer.messages)

    def test_faces_that_a_moving_body_opens(self):
        """A body that moves along its crack, with sixty times the G that this needs: nodes that the front passes as
        they go by take its toughness too, and no more than a cell of it each."""
        scene = pulled_apart([0.0, 0.52, 0.4, 0.52], toughness="1", time=8e-4)
        for name, sign in (("Top", 1.0), ("Bottom", -1.0)):
            scene.set("Boundaries > " + name + " > Stress", [0.0, sign * 2e6])
        scene.set("Domain > Upper Corner", [1.5, 1.2]).set("Bodies > Plate > Velocity", [300.0, 0.0])
        # How many nodes go by depends on the time of initiation, which is known to a step only with G in every step.
        scene.set("Propagation > Sampling Interval", 0.0)
        answer = rhegma(self.write("scene.xml", scene.text()), "--quiet")
        self.assertEqual(answer.status, 0, answer)
        with open(self.path("scene.out", "summary.json")) as file:
            summary = json.load(file)
        balance, front = summary["propagation"], summary["cracks"][0]["fronts"][0]
        gone_by = 300.0 * (front["last_advance"] - front["initiated"])
        self.assertGreater(gone_by, 2 * 0.05)
        self.assertLess(balance["dissipated"], 1.02 * (balance["energy_of_new_faces"] + 1.0 * (gone_by + 0.05)))
        self.assertGreater(balance["dissipated"], 1.1 * balance["energy_of_new_faces"])
        self.assertIn("Propagation: new faces dissipated", answer.messages)

    def test_energy_fractions_include_gas_faces_and_heat(self):
        """What gas gives is put in, what new faces and heat take is none of the motion any more."""
        scene = pulled_apart([0.0, 0.52, 0.4, 0.52], toughness="100*(1 + v/300)", time=7e-4).set("Contact", {"Law": "Frictionless"})
        for name in ("Top", "Bottom"):
            scene.set("Boundaries > " + name + " > Stress", [0.0, 2e6 if name == "Top" else -2e6])
        scene.set("Combustion", {"Notch": {
            "Burn Law": "Vieille", "Burn Coefficient": 3e-7, "Burn Exponent": 0.7, "Gas Constant": 320.0,
            "Flame Temperature": 2500.0, "Initial Temperature": 300.0, "Initial Pressure": 1e6, "Initial Gap": 1e-3}})
        for name, value in (("Specific Heat", 1400.0), ("Conductivity", 0.2), ("Thermal Expansion", 7e-5)):
            scene.set("Materials > Polymer > " + name, value)
        scene.set("Thermal", {"Initial Temperature": 300.0, "Front Heat Fraction": 0.9, "Front Radius": 0.1})
        answer = rhegma(self.write("scene.xml", scene.text()), "--quiet")
        self.assertEqual(answer.status, 0, answer)
        with open(self.path("scene.out", "summary.json")) as file:
            energy = json.load(file)["energy"]
        given = energy["external_work"] + energy["combustion"]
        for part in ("combustion", "fracture"):
            self.assertGreater(energy[part], 0.02 * given, f"{part} of {given}")  # what each would be seen by if it were forgotten
        # As far as the energy balance of the run is open itself.
        for fraction in ("smallest_fraction", "largest_fraction", "last_fraction"):
            self.assertAlmostEqual(energy[fraction], 1.0, delta=0.01, msg=fraction)

    def test_gases_of_cracks_that_have_met_come_to_one_pressure(self):
        """Apart by less than the pressure falls while sound goes from where they met to the ends of the other crack:
        nearer to each other no gas has one pressure."""
        out = self.path("joined")
        answer = rhegma(os.path.join(SOURCE, "xml_inputs", "verification", "joined_gases.xml"), "--quiet", "--output", out)
        self.assertEqual(answer.status, 0, answer)
        self.assertIn("crack Wall, front 0: joined crack Roof", answer.messages)
        with open(os.path.join(out, "history.csv"), newline="") as file:
            rows = [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]
        met = next(k for k, row in enumerate(rows) if row["time"] > 8e-5)
        self.assertGreater(rows[met]["Wall.pressure"], 50.0 * rows[met]["Roof.pressure"])
        half, ratio, constant = 0.012, 1.25, 320.0  # of Roof [m], and of the gas
        sound = math.sqrt(ratio * constant * rows[-1]["Roof.gas_temperature"])
        before = next(row for row in rows if row["time"] > rows[-1]["time"] - half / sound)
        falls = before["Wall.pressure"] - rows[-1]["Wall.pressure"]
        self.assertLess(falls, 0.15 * rows[-1]["Wall.pressure"])
        self.assertLess(abs(rows[-1]["Wall.pressure"] - rows[-1]["Roof.pressure"]), falls)


if __name__ == "__main__":
    unittest.main()
