#!/usr/bin/env python3
"""Heat through the faces of bodies that press on each other, and heat by friction.

Materials, positions relative to the cells and conductances are drawn; RHEGMA_SEED in the environment chooses them, and is printed."""

import math
import os
import sys
import unittest

import h5py
import numpy as np

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from drawn_scenes import DrawnScenes  # noqa: E402
from scenes import Scene  # noqa: E402

WARM, COLD = 400.0, 300.0


class Slabs:
    """Two slabs that touch, insulated outside, by finite volumes and implicit steps: lengths and conductivities and heat capacities of
    each, and the conductance between them."""

    def __init__(self, lengths, conductivities, capacities, conductance, volumes=200):
        self.widths = np.repeat([length / volumes for length in lengths], volumes)
        k = np.repeat(conductivities, volumes)
        self.heat = self.widths * np.repeat(capacities, volumes)
        resistance = 0.5 * (self.widths[1:] / k[1:] + self.widths[:-1] / k[:-1])
        resistance[volumes - 1] += 1.0 / conductance
        through = 1.0 / resistance
        self.matrix = np.zeros((2 * volumes, 2 * volumes))
        for i, flow in enumerate(through):
            self.matrix[i : i + 2, i : i + 2] += flow * np.array([[1.0, -1.0], [-1.0, 1.0]])
        self.volumes = volumes

    def passed(self, time, steps=400):
        """Heat [J/m2] that the first slab has lost: it begins at WARM, the other at COLD."""
        temperature = np.repeat([WARM, COLD], self.volumes)
        dt = time / steps
        inverse = np.linalg.inv(np.diag(self.heat) + dt * self.matrix)
        for _ in range(steps):
            temperature = inverse @ (self.heat * temperature)
        return float((self.heat * (WARM - temperature))[: self.volumes].sum())


class HeatOfContact(DrawnScenes):
    def material(self, diffusivity):
        capacity = self.rng.uniform(400.0, 1000.0)
        return {"Model": "Linear Elastic", "Density": 2000.0, "Young Modulus": 1e10, "Poisson Ratio": 0.0, "Specific Heat": capacity,
                "Conductivity": diffusivity * 2000.0 * capacity}

    def temperatures(self):
        """(body, temperature, mass) of all particles at the end."""
        with h5py.File(self.path("scene", "fields.h5"), "r") as file:
            found = {}
            file.visititems(lambda name, item: found.setdefault(name.rsplit("/", 1)[-1], []).append(item))
            return [np.asarray(found[name][-1]) for name in ("body", "temperature", "mass")]

    def slabs(self, cells, conductance, time, dimension=2, gap=0.0, pressure=1e6, angle=0.0):
        """Two slabs of 5 mm in a row, pressed on each other; in 2D the row is turned by an angle."""
        length = 5e-3
        cell, side = length / cells, dimension - 1
        at = [self.rng.uniform(0.0, cell) for _ in range(dimension)]
        low, high = at[1:], [x + 2.0 * cell for x in at[1:]]
        face = at[0] + length
        materials = {"One": self.material(0.5 * length**2 / time), "Two": self.material(self.rng.uniform(0.3, 1.0) * length**2 / time)}
        bodies = {"Warm": {"Material": "One", "Shape": "Box", "Lower Corner": at, "Upper Corner": [face, *high], "Temperature": WARM},
                  "Cold": {"Material": "Two", "Shape": "Box", "Lower Corner": [face + gap * cell, *low],
                           "Upper Corner": [face + gap * cell + length, *high], "Temperature": COLD}}
        if angle != 0.0:
            turn, middle = math.radians(angle), [face, 0.5 * (low[0] + high[0])]
            for body in bodies.values():  # about the middle of the two, each about its own middle by Rotation
                corners = body["Lower Corner"], body["Upper Corner"]
                away = 0.5 * (corners[0][0] + corners[1][0]) - middle[0]
                shift = [away * (math.cos(turn) - 1.0), away * math.sin(turn)]
                body.update({"Rotation": angle, "Lower Corner": [x + s for x, s in zip(corners[0], shift)],
                             "Upper Corner": [x + s for x, s in zip(corners[1], shift)]})
        reach = -length if angle != 0.0 else 0.0
        scene = Scene({
            "Domain": {"Dimension": dimension, "Cell Size": cell, "Lower Corner": [-2.0 * cell] + [reach - 2.0 * cell] * side,
                       "Upper Corner": [2.0 * length + 6.0 * cell] + [6.0 * cell - reach] * side},
            "Time": {"Final Time": time},
            "Materials": materials,
            "Bodies": bodies,
            "Body Contact": {"Conductance": conductance},
            "Thermal": {"Initial Temperature": COLD},
            "Output": {"Checkpoints": False, "History Interval": time / 20.0},
        })
        if pressure > 0.0:
            row = [math.cos(math.radians(angle)), math.sin(math.radians(angle)), 0.0][:dimension]
            scene.set("Boundaries", {
                name: {"Type": "Traction", "Surface": "Body", "Body": name, "Facing": [sign * x for x in row],
                       "Stress": [-sign * pressure * x for x in row], "History": f"min(1, t / {0.02 * time:g})"}
                for name, sign in (("Warm", -1.0), ("Cold", 1.0))})
            scene.set("Damping", {"Mass Rate": 0.5 * 2236.0 / length})
        areas = 2.0 * cell if dimension == 2 else 4.0 * cell**2
        return scene, materials, areas

    def test_heat_through_pressed_faces(self):
        time = 2e-4
        for dimension, cells, biot, turned in ((2, 8, 0.3, False), (2, 8, 3.0, False), (2, 8, 1e6, False), (3, 6, 1.0, False), (2, 8, 3.0, True),
                                               (2, 8, 1e6, True)):
            angle = self.rng.uniform(10.0, 80.0) if turned else 0.0
            scene, materials, area = self.slabs(cells, 1.0, time, dimension, angle=angle)
            k = [m["Conductivity"] for m in materials.values()]
            conductance = biot * min(k) / 5e-3
            scene.set("Body Contact > Conductance", conductance)
            summary, history = self.run_scene(scene)
            exact = area * Slabs([5e-3] * 2, k, [m["Density"] * m["Specific Heat"] for m in materials.values()], conductance).passed(time)
            pair = summary["body_contact"][0]
            body, temperature, mass = self.temperatures()
            print(f"{dimension}D, {cells} cells, turned by {angle:.1f} degrees, h L / k = {biot:g}: heat passed {pair['heat_passed'] / exact - 1.0:+.2%}, "
                  f"temperatures {temperature.min():.2f} to {temperature.max():.2f} K, touch at {pair['first_touch']:.2g} s")
            with self.subTest(dimension=dimension, biot=biot, angle=angle):
                # Turned faces end between nodes, and the slabs are two cells wide.
                self.assertLess(abs(pair["heat_passed"] / exact - 1.0), 0.03 if turned else 0.005)
                capacity = np.array([materials[n]["Specific Heat"] for n in ("One", "Two")])[body]
                lost = (mass * capacity * (np.where(body == 0, WARM, COLD) - temperature))
                for index, sign in ((0, 1.0), (1, -1.0)):
                    self.assertLess(abs(sign * lost[body == index].sum() / pair["heat_passed"] - 1.0), 1e-9)
                self.assertGreater(temperature.min(), COLD - 0.01 * (WARM - COLD))
                self.assertLess(temperature.max(), WARM + 0.01 * (WARM - COLD))

    def test_no_heat_passes_a_gap(self):
        """Though the bodies have nodes in common. Without a conductance none passes closed faces, and a warning says so."""
        for dimension in (2, 3):
            gap = self.rng.uniform(0.01, 0.9)
            scene, *_ = self.slabs(4, 1e9, 2e-5, dimension, gap, 0.0)
            self.run_scene(scene)
            body, temperature, _ = self.temperatures()
            with self.subTest(dimension=dimension, gap=gap):
                self.assertLess(np.abs(temperature - np.where(body == 0, WARM, COLD)).max(), 1e-9)
        scene, *_ = self.slabs(4, 0.0, 2e-5)
        summary, _ = self.run_scene(scene.remove("Body Contact > Conductance"))
        body, temperature, _ = self.temperatures()
        self.assertGreater(summary["body_contact"][0]["closed_nodes"], 0)
        self.assertLess(np.abs(temperature - np.where(body == 0, WARM, COLD)).max(), 1e-9)
        self.assertTrue(any("no heat passes" in warning for warning in summary["warnings"]), summary["warnings"])

    def test_friction_heats_both_bodies(self):
        """A block that slides on a plate until it rests: the energy that friction takes becomes heat, in proportion to effusivities. The
        plate is deeper than heat gets, the block slides over it with Coulomb friction."""
        for dimension in (2, 3):
            cell, side = 1e-3, dimension - 1
            at = [self.rng.uniform(0.0, cell) for _ in range(dimension)]
            last = [at[2], at[2] + 2.0 * cell] if dimension == 3 else []
            top = at[1] + 4.0 * cell
            materials = {"One": self.material(1e-3), "Two": self.material(self.rng.uniform(0.3, 3.0) * 1e-3)}
            plate = {"Material": "One", "Shape": "Box", "Lower Corner": [at[0], at[1], *last[:1]], "Upper Corner": [at[0] + 0.02, top, *last[1:]]}
            block = {"Material": "Two", "Shape": "Box", "Lower Corner": [at[0] + 2.3 * cell, top, *last[:1]],
                     "Upper Corner": [at[0] + 8.3 * cell, top + 4.0 * cell, *last[1:]], "Velocity": [20.0] + [0.0] * side}
            scene = Scene({
                "Domain": {"Dimension": dimension, "Cell Size": cell, "Lower Corner": [-3e-3] * dimension,
                           "Upper Corner": [0.026, 0.015] + [6e-3] * (dimension - 2)},
                "Time": {"Final Time": 2e-4},
                "Materials": materials,
                "Bodies": {"Plate": plate, "Block": block},
                "Body Contact": {"Law": "Coulomb", "Friction Coefficient": 0.3},
                "Thermal": {"Initial Temperature": COLD},
                "Boundaries": {"Base": {"Type": "Velocity", "Value": [0.0] * dimension, "Lower Corner": [-1.0] * dimension,
                                        "Upper Corner": [1.0, at[1] + 0.01 * cell] + [1.0] * (dimension - 2)},
                               "Down": {"Type": "Gravity", "Acceleration": [0.0, -1e6] + [0.0] * (dimension - 2)}},
                "Output": {"Checkpoints": False, "History Interval": 1e-5},
            })
            summary, history = self.run_scene(scene)
            pair, energy = summary["body_contact"][0], summary["energy"]
            body, temperature, mass = self.temperatures()
            capacity = np.array([materials[n]["Specific Heat"] for n in ("One", "Two")])[body]
            gained = [(mass * capacity * (temperature - COLD))[body == k].sum() for k in (0, 1)]
            effusivity = [math.sqrt(m["Conductivity"] * m["Density"] * m["Specific Heat"]) for m in materials.values()]
            print(f"{dimension}D: friction {pair['friction']:.4g} J, heat {pair['friction_heat']:.4g} J, gained {sum(gained):.4g} J, of which the block "
                  f"{gained[1] / sum(gained):.4f}, by effusivities {effusivity[1] / sum(effusivity):.4f}; residual "
                  f"{energy['residual'] / pair['friction']:.2%}")
            with self.subTest(dimension=dimension):
                self.assertGreater(pair["friction"], 0.0)
                self.assertLess(abs(pair["friction_heat"] / pair["friction"] - 1.0), 1e-12)
                self.assertLess(abs(sum(gained) / pair["friction"] - 1.0), 1e-9)
                self.assertLess(abs(gained[1] / sum(gained) - effusivity[1] / sum(effusivity)), 1e-9)
                self.assertLess(abs(history["Plate - Block.friction_heat"][-1] / pair["friction"] - 1.0), 1e-9)

    def test_friction_on_tools_heats_bodies(self):
        """A block that slides on a wall without particles: of the energy of friction the given fraction becomes its heat, and the balance closes."""
        for dimension in (2, 3):
            cell, side = 1e-3, dimension - 1
            at = [self.rng.uniform(0.0, cell) for _ in range(dimension)]
            fraction = self.rng.choice((None, self.rng.uniform(0.1, 0.9)))
            upper = [at[0] + 6.0 * cell, at[1] + 4.0 * cell, *[x + 3.0 * cell for x in at[2:]]]
            scene = Scene({
                "Domain": {"Dimension": dimension, "Cell Size": cell, "Lower Corner": [-3e-3] * dimension, "Upper Corner": [0.02, 0.012] + [8e-3] * (dimension - 2)},
                "Time": {"Final Time": 2e-4},
                "Materials": {"One": self.material(1e-3)},
                "Bodies": {"Block": {"Material": "One", "Shape": "Box", "Lower Corner": at, "Upper Corner": upper, "Velocity": [20.0] + [0.0] * side}},
                "Rigid Tools": {"Wall": {"Shape": "Box", "Lower Corner": [-0.1] * dimension, "Upper Corner": [0.1, at[1]] + [0.1] * (dimension - 2), "Law": "Coulomb",
                                         "Friction Coefficient": 0.3, **({} if fraction is None else {"Friction Heat Fraction": fraction})}},
                "Thermal": {"Initial Temperature": COLD},
                "Boundaries": {"Down": {"Type": "Gravity", "Acceleration": [0.0, -1e6] + [0.0] * (dimension - 2)}},
                "Output": {"Checkpoints": False, "History Interval": 1e-5},
            })
            summary, _ = self.run_scene(scene)
            tool = summary["rigid_tools"][0]
            _, temperature, mass = self.temperatures()
            gained = (mass * scene["Materials > One > Specific Heat"] * (temperature - COLD)).sum()
            print(f"{dimension}D: friction {tool['friction']:.4g} J, heat {tool['friction_heat']:.4g} J, gained {gained:.4g} J, residual "
                  f"{summary['energy']['residual'] / tool['friction']:.2%}")
            with self.subTest(dimension=dimension):
                self.assertGreater(tool["friction"], 0.0)
                self.assertLess(abs(tool["friction_heat"] / tool["friction"] - (1.0 if fraction is None else fraction)), 1e-9)
                self.assertLess(abs(gained / tool["friction_heat"] - 1.0), 1e-9)
                self.assertLess(abs(summary["energy"]["residual"]), 0.03 * tool["friction"])

    def test_wrong_input(self):
        scene, *_ = self.slabs(4, 1e3, 1e-6)
        scene.remove("Thermal").remove("Bodies > Warm > Temperature").remove("Bodies > Cold > Temperature")
        self.assert_refused([self.write("scene.xml", scene.text())], [("Body Contact", ["Conductance", "Thermal"])])
        scene, *_ = self.slabs(4, -1.0, 1e-6)
        self.assert_refused([self.write("scene.xml", scene.text())], [("Body Contact > Conductance", ["0"])])
        scene, *_ = self.slabs(4, 1.0, 1e-6, pressure=0.0)
        scene.set("Thermal > Mechanics", False)
        self.assert_refused([self.write("scene.xml", scene.text())], [("Body Contact", ["Mechanics = true"])])


if __name__ == "__main__":
    unittest.main()
