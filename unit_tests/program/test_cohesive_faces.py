#!/usr/bin/env python3
"""Blocks with a cohesive interface anywhere in the cells, at any angle and in any mode: force against opening is the law, and all that is taken
is the toughness. Wrong scenes are refused.

RHEGMA_SEED in the environment draws other blocks."""

import csv
import json
import math
import os
import random
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from file_scene import FileScene  # noqa: E402
from program import SOURCE, ProgramTest, rhegma  # noqa: E402
from scenes import Scene  # noqa: E402

SEED = int(os.environ.get("RHEGMA_SEED", str(random.randrange(10**6))))
NUMBER = 4
WIDTH, HEIGHT, CELL = 8e-3, 12e-3, 1e-3
JOINT = "Cohesive Faces > Joint"


class Law:
    """The laws of docs/explanation/cohesive-faces.md, written again."""

    def __init__(self, draw, name):
        self.name, self.exponent, self.plateau = name, draw.uniform(1.0, 3.0), draw.uniform(0.1, 0.8)
        self.energy = [draw.uniform(50.0, 200.0), draw.uniform(100.0, 400.0)]
        self.strength = [draw.uniform(0.5e6, 2e6), draw.uniform(0.5e6, 3e6)]
        # From 5 to 50 times the least stiffness with which the strength is reached.
        self.stiffness = draw.uniform(5.0, 50.0) * self.strength[0] ** 2 / (2.0 * self.energy[0])
        if name == "Exponential":
            self.stiffness = (math.e * self.strength[0]) ** 2 / self.energy[0]
        ratio = (self.strength[1] / self.strength[0]) ** 2 * self.energy[0] / self.energy[1]
        self.shear = ratio * self.stiffness

    def scene(self):
        parameters = {"Law": self.name, "Toughness": self.energy[0], "Toughness II": self.energy[1], "Strength": self.strength[0],
                      "Shear Strength": self.strength[1], "Exponent": self.exponent}
        if self.name != "Exponential":
            parameters["Initial Stiffness"] = self.stiffness
        if self.name == "Trapezoidal":
            parameters["Plateau"] = self.plateau
        return parameters

    def mode(self, opening, slip):
        both = self.stiffness * opening**2 + self.shear * slip**2
        return self.shear * slip**2 / both if both > 0.0 else 0.0

    def toughness(self, mode):
        return self.energy[0] + (self.energy[1] - self.energy[0]) * mode**self.exponent

    def secant(self, opening, slip):
        """The part of both stiffnesses that is left, on a proportional path."""
        mode = self.mode(opening, slip)
        size = math.sqrt(opening**2 + self.shear / self.stiffness * slip**2)
        energy = self.toughness(mode)
        if self.name == "Exponential":
            return math.exp(-size / math.sqrt(energy / self.stiffness))
        starts = [self.strength[0] ** 2 / self.stiffness, self.strength[1] ** 2 / self.shear]  # twice the elastic energies
        onset = math.sqrt((starts[0] + (starts[1] - starts[0]) * mode**self.exponent) / self.stiffness)
        plateau = self.plateau if self.name == "Trapezoidal" else 0.0
        rest = 2.0 * (energy / (self.stiffness * onset) - 0.5 * onset) / (1.0 + plateau)
        flat, end = onset + plateau * rest, onset + rest
        if size <= onset:
            return 1.0
        if size <= flat:
            return onset / size
        return max(0.0, onset * (end - size) / ((end - flat) * size))

    def end(self, opening, slip):
        """Length of the jump in a direction at which nothing is left."""
        length = 1e-9
        while self.secant(length * opening, length * slip) > 1e-4:
            length *= 1.1
        return length


def block(draw, law, analysis="Quasi-Static", history=None):
    """A block with a joint, whose halves move apart; the angle of the motion from the normal, and the length of the joint."""
    x, y = draw.uniform(0.0, CELL), draw.uniform(0.0, CELL)
    angle, turn = draw.uniform(-0.5, 0.5), draw.uniform(-1.4, 1.4)
    middle = y + 0.5 * HEIGHT + draw.uniform(-0.5, 0.5) * CELL
    rise = math.tan(angle) * (0.5 * WIDTH + CELL)
    length = WIDTH / math.cos(angle)
    largest = 1.2 * law.end(math.cos(turn), math.sin(turn))
    # Side +1 lies to the left of the line from left to right, above it; its slip is counted along (normal y, -normal x).
    motion = [largest * (-math.sin(angle) * math.cos(turn) + math.cos(angle) * math.sin(turn)),
              largest * (math.cos(angle) * math.cos(turn) + math.sin(angle) * math.sin(turn))]
    grip = {"Type": "Velocity", "Value": motion}
    if history:
        grip["History"] = history
    scene = Scene({
        "Domain": {"Dimension": 2, "Plane": "Strain", "Lower Corner": [-4 * CELL] * 2, "Upper Corner": [14 * CELL, 18 * CELL], "Cell Size": CELL},
        "Time": {"Final Time": 1.0, "Analysis": analysis, "Load Steps": 20},
        "Materials": {"Metal": {"Model": "Linear Elastic", "Density": 2700.0, "Young Modulus": 70e9, "Poisson Ratio": 0.0}},
        "Bodies": {"Block": {"Material": "Metal", "Shape": "Box", "Lower Corner": [x, y], "Upper Corner": [x + WIDTH, y + HEIGHT]}},
        "Boundaries": {"Lower": {"Type": "Velocity", "Lower Corner": [-4 * CELL] * 2, "Upper Corner": [14 * CELL, y + 2 * CELL], "Value": [0.0, 0.0]},
                       "Upper": dict(grip, **{"Lower Corner": [-4 * CELL, y + HEIGHT - 2 * CELL], "Upper Corner": [14 * CELL, y + HEIGHT + 2 * CELL]})},
        "Cracks": {"Joint": {"Points": [x - CELL, middle - rise, x + WIDTH + CELL, middle + rise]}},
        "Cohesive Faces": {"Joint": law.scene()},
        "Output": {"Fields": False, "History Interval": 0.05},
    })
    return scene, turn, length


class CohesiveFaces(ProgramTest):
    def run_scene(self, scene, name, seed):
        answer = rhegma(self.write(name + ".xml", scene.text()), "--quiet")
        self.assertEqual(answer.status, 0, f"seed {seed}: {answer}")
        with open(self.path(name + ".out", "history.csv")) as file:
            rows = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]
        with open(self.path(name + ".out", "summary.json")) as file:
            return rows, json.load(file)

    def test_force_is_the_law_anywhere(self):
        print(f"RHEGMA_SEED = {SEED}", flush=True)
        for k, name in enumerate(("Linear", "Bilinear", "Trapezoidal", "Exponential")):
            seed = SEED + k
            draw = random.Random(seed)
            law = Law(draw, "Bilinear" if name == "Linear" else name)
            scene, turn, length = block(draw, law)
            if name == "Linear":  # the stiffest start that cells allow, here as much: 20 E / cell
                law.stiffness = max(20.0 * 70e9 / CELL, 5.0 * law.strength[0] ** 2 / law.energy[0])
                law.shear = (law.strength[1] / law.strength[0]) ** 2 * law.energy[0] / law.energy[1] * law.stiffness
                scene.set(JOINT + " > Law", "Linear").remove(JOINT + " > Initial Stiffness")
            rows, summary = self.run_scene(scene, f"anywhere{k}", seed)
            # The halves strain by strength / E, a displacement of strength H / E that is not opening and varies along the joint: that
            # over the length of the fall of the traction is the part by which a point's traction may differ, and the mode of one by as much.
            strain = max(law.strength) * HEIGHT / 70e9
            fall = min(law.energy[i] / law.strength[i] for i in (0, 1))
            part = 4.0 * strain / fall + 2e-3  # of the strength; rounding of the columns and turning normals
            for row in rows:
                opening, slip = max(row["Joint.cohesive_opening"], 0.0), row["Joint.cohesive_slip"]
                left = law.secant(opening, slip)
                expected = length * left * math.hypot(law.stiffness * opening, law.shear * slip)
                found = math.hypot(row["Upper.force_x"], row["Upper.force_y"])
                self.assertLess(abs(found - expected), part * length * max(law.strength), f"seed {seed}, {name}, {law.scene()}: {row}")
            cohesive = summary["cracks"][0]["cohesive"]
            mode = law.mode(math.cos(turn), math.sin(turn))
            taken = cohesive["dissipated_I"] + cohesive["dissipated_II"]
            # The last part of an exponential law is (1 + x) exp(-x), less than 1 % at 1e-4 of the stiffness.
            self.assertLess(abs(taken - length * law.toughness(mode)), (part + 0.01) * length * max(law.energy), f"seed {seed}, {name}: {cohesive}")
            # 1e-9: bisection of the ends.
            self.assertLess(abs(cohesive["bonded"] - length), 1e-9 * length, f"seed {seed}, {name}")
            self.assertLess(abs(rows[-1]["residual"]), 2e-3 * rows[-1]["external_work"], f"seed {seed}, {name}")

    def test_unloading_returns_to_the_origin(self):
        print(f"RHEGMA_SEED = {SEED}", flush=True)
        draw = random.Random(SEED)
        law = Law(draw, "Bilinear")
        # A third of the way, back to the start, and on.
        scene, _, length = block(draw, law, history="0.8 - 2.4*(t > 0.4) + 4.1*(t > 0.6)")
        rows, _ = self.run_scene(scene, "unloads", SEED)
        at = {round(row["time"], 6): row for row in rows}
        stored = [at[t]["Joint.cohesive_stored"] for t in (0.4, 0.5, 0.6)]
        taken = [at[t]["Joint.cohesive_dissipated_I"] + at[t]["Joint.cohesive_dissipated_II"] for t in (0.4, 0.5, 0.6)]
        force = [math.hypot(at[t]["Upper.force_x"], at[t]["Upper.force_y"]) for t in (0.4, 0.5, 0.6)]
        self.assertEqual(taken[0], taken[1])
        self.assertEqual(taken[0], taken[2])
        # Half of the displacement: half of the force and a quarter of the energy, to the strain of the bodies, which is small.
        small = max(law.strength) * length
        self.assertLess(abs(force[1] - 0.5 * force[0]), 1e-3 * small, f"seed {SEED}: {force}")
        self.assertLess(abs(force[2]), 1e-3 * small, f"seed {SEED}: {force}")
        self.assertLess(abs(stored[1] - 0.25 * stored[0]), 1e-3 * stored[0], f"seed {SEED}: {stored}")

    def test_split_beams_anywhere_in_their_cells(self):
        """The verification scenes, whose references are those of finite elements, with the interface anywhere in its cells."""
        print(f"RHEGMA_SEED = {SEED}", flush=True)
        draw = random.Random(SEED)
        for name in ("dcb", "enf", "mmb"):
            scene = FileScene(os.path.join(SOURCE, "xml_inputs", "verification", f"cohesive_{name}_static.xml"))
            low = -4e-3 - draw.uniform(0.0, CELL)
            node = low + CELL * round((2e-3 - low) / CELL)  # the one that keeps the beam from moving along x
            scene.set("Domain > Lower Corner", [-2e-3, low])
            scene.set("Boundaries > End > Lower Corner", [0.0998, node - 2e-4])
            scene.set("Boundaries > End > Upper Corner", [0.1002, node + 2e-4])
            answer = rhegma(self.write(name + ".xml", scene.text()), "--quiet")
            self.assertEqual(answer.status, 0, f"seed {SEED}: {answer}")  # 4 where a reference is missed

    def test_warns_of_short_process_zones(self):
        law = Law(random.Random(1), "Bilinear")
        scene, _, _ = block(random.Random(1), law)
        effective = 70e9
        # Half a cell in mode I, more in mode II.
        scene.set(JOINT, {"Toughness": 100.0, "Strength": math.sqrt(effective * 100.0 / (0.5 * CELL)), "Shear Strength": 1e6})
        answer = rhegma(self.write("zone.xml", scene.text()), "--check")
        self.assertEqual(answer.status, 0, answer)
        self.assertIn("has 0.5 cells, and needs 3", answer.messages + answer.output)

    def test_refuses_wrong_scenes(self):
        law = Law(random.Random(2), "Bilinear")
        cases = [
            ("stiffness", lambda s: s.set(JOINT + " > Initial Stiffness", 1e3), JOINT + " > Initial Stiffness", "is too small"),
            ("linear", lambda s: s.set(JOINT + " > Law", "Linear"), JOINT + " > Initial Stiffness", "leave it out"),
            ("exponential", lambda s: s.set(JOINT + " > Law", "Exponential"), JOINT + " > Initial Stiffness", "leave it out"),
            ("plateau", lambda s: s.set(JOINT + " > Plateau", 0.5), JOINT + " > Plateau", "Trapezoidal"),
            ("box", lambda s: s.set(JOINT + " > Free Lower Corner", [1.0, 1.0]).set(JOINT + " > Free Upper Corner", [0.0, 2.0]),
             JOINT + " > Free Upper Corner", "exchange"),
            ("corner", lambda s: s.set(JOINT + " > Free Lower Corner", [1.0, 1.0]), JOINT, "Free Upper Corner"),
            ("name", lambda s: s.set("Cohesive Faces", {"Jiont": {"Toughness": 1.0, "Strength": 1.0}}), "Cohesive Faces > Jiont", "Joint"),
            ("none", lambda s: s.set("Cohesive Faces", {}), "Cohesive Faces", "names no crack"),
            ("cracks", lambda s: s.remove("Cracks"), "Cohesive Faces", "there are no cracks"),
            ("inside", lambda s: s.set("Cracks > Joint > Points", [-1e-3, 6e-3, 4e-3, 6e-3]), JOINT, "ends inside the body"),
            ("friction", lambda s: s.set("Contact", {"Law": "Coulomb", "Friction Coefficient": 0.3}), "Cohesive Faces", "Frictionless"),
            ("contact", lambda s: s.set("Contact", {}), "Cohesive Faces", "in equilibrium"),
            ("cells", lambda s: s.set("Cracks > Formulation", "Broken Cell"), "Cohesive Faces", "Dual Field"),
            ("heat", lambda s: s.set("Thermal", {"Initial Temperature": 300.0}), "Cohesive Faces", "no heat"),
        ]
        for name, change, where, words in cases:
            scene, _, _ = block(random.Random(2), law)
            change(scene)
            answer = rhegma(self.write(name + ".xml", scene.text()), "--quiet")
            self.assertEqual(answer.status, 1, f"{name}: {answer}")
            self.assertIn(where, answer.messages, name)
            self.assertIn(words, answer.messages, name)
            self.assertFalse(os.path.exists(self.path(name + ".out")), name)


if __name__ == "__main__":
    unittest.main()
