#!/usr/bin/env python3
"""Loads and heat on round faces, walls of holes and whole surfaces (Surface = Body), against closed forms, at random positions and sizes."""

import math
import os
import re
import shutil
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

import h5py  # noqa: E402
import numpy  # noqa: E402
from drawn_scenes import DrawnScenes  # noqa: E402
from part_files import binary_stl, bracket  # noqa: E402
from program import rhegma  # noqa: E402
from ranks import LAUNCHER, ROOT  # noqa: E402
from scenes import Scene  # noqa: E402

YOUNG, POISSON = 3e9, 0.3
PRESSURE = 1e6


def scene_of(body, reach, cell, dimension=2, analysis="Static"):
    """A body in the middle of a domain of half width reach, without supports."""
    return Scene({
        "Domain": {"Dimension": dimension, "Lower Corner": [-reach] * dimension, "Upper Corner": [reach] * dimension, "Cell Size": cell},
        "Time": {"Analysis": analysis, "Final Time": 1e-4, **({"Rigid Modes": "Remove"} if analysis == "Static" else {})},
        "Materials": {"Polymer": {"Model": "Linear Elastic", "Density": 1200.0, "Young Modulus": YOUNG, "Poisson Ratio": POISSON}},
        "Bodies": {"Part": {"Material": "Polymer", **body}},
        "Boundaries": {"Load": {"Type": "Traction", "Body": "Part", "Surface": "Body", "Pressure": PRESSURE}},
    })


class SurfaceScenes(DrawnScenes):
    def middle(self, cell, dimension):
        return [cell * self.rng.uniform(-0.5, 0.5) for _ in range(dimension)]

    def ring(self, cell, dimension, cells, hole):
        """A disk or a ball with a hole in its middle, anywhere in its cell: (body, outer radius, inner radius)."""
        outer = cell * self.rng.uniform(*cells)
        inner = outer * self.rng.uniform(*hole)
        middle = self.middle(cell, dimension)
        return {"Shape": "Ball", "Centre": middle, "Radius": outer,
                "Operations": {"Bore": {"Operation": "Cut", "Shape": "Ball", "Centre": middle, "Radius": inner}}}, outer, inner

    def particles(self, dimension, name="scene"):
        """The last positions, displacements and masses of a run."""
        with h5py.File(self.path(name, "fields.h5"), "r") as file:
            last = file[sorted(group for group in file if "particles" in file[group])[-1]]["particles"]
            fields = {field: last[field][()] for field in ("position", "displacement", "mass")}
        return {field: values[:, :dimension] if values.ndim > 1 else values for field, values in fields.items()}

    def assert_pressed_evenly(self, body, reach, cell, dimension, within):
        """With a pressure on all of its surface, the mean stress of any body is that pressure: integral of x t over the surface."""
        summary, _ = self.run_scene(scene_of(body, reach, cell, dimension))
        for axis in "xyz"[:dimension]:
            self.assertAlmostEqual(summary["bodies"][0]["stress"][2 * axis] / -PRESSURE, 1.0, delta=within)
        return summary


class SurfaceLoads(SurfaceScenes):
    def test_pressure_on_all_of_a_plane_body(self):
        """A box with a round hole, turned: pieces a quarter of a cell long are exact but for corners of the cut."""
        cell = 1e-3
        body = {"Shape": "Box", "Lower Corner": [-0.0092, -0.0053], "Upper Corner": [0.0091, 0.0057], "Rotation": self.rng.uniform(0, 90),
                "Operations": {"Hole": {"Operation": "Cut", "Shape": "Ball", "Centre": self.middle(cell, 2), "Radius": cell * self.rng.uniform(2, 4)}}}
        summary = self.assert_pressed_evenly(body, 0.016, cell, 2, 2e-3)
        radius = body["Operations"]["Hole"]["Radius"]
        self.assertAlmostEqual(summary["surfaces"][0]["area"], 2 * (0.0183 + 0.011) + 2 * math.pi * radius, delta=1e-12)

    def area(self, scene, name="Load"):
        """The area [m2] of a boundary that --check prints, and all of its messages."""
        answer = rhegma("--check", self.write("checked.xml", scene.text()))
        self.assertEqual(answer.status, 0, answer)
        match = re.search(rf"Boundaries > {name}: on ([\d.e+-]+) (cm2|mm2|m2)", answer.output)
        self.assertIsNotNone(match, answer.output)
        return float(match.group(1)) * {"m2": 1.0, "cm2": 1e-4, "mm2": 1e-6}[match.group(2)], answer.messages

    def test_all_sides_of_voxels(self):
        """Voxels of a fifth of a cell and of two cells: each side of a box has its area, and a pressure all around it no resultant."""
        for size, shape in ((2e-4, (40, 20)), (2e-4, (21, 13, 9)), (2e-3, (4, 3))):
            numpy.save(self.path("box.npy"), numpy.ones(shape, dtype="uint8"))
            dimension = len(shape)
            body = {"Shape": "Voxels", "File": "box.npy", "Value": 1, "Voxel Size": size, "Corner": self.middle(1e-3, dimension)}
            scene = scene_of(body, 0.02, 1e-3, dimension)
            edges = [size * count for count in shape]
            for axis in range(dimension):
                for side in (-1.0, 1.0):
                    scene.set("Boundaries > Load > Facing", [side * float(axis == other) for other in range(dimension)])
                    right = math.prod(edge for other, edge in enumerate(edges) if other != axis)
                    self.assertAlmostEqual(self.area(scene)[0] / right, 1.0, delta=1e-3)  # --check prints four digits
            scene = scene_of(body, 0.02, 1e-3, dimension)
            summary, _ = self.run_scene(scene)
            self.assertAlmostEqual(summary["surfaces"][0]["area"], 2 * sum(math.prod(edges) / edge for edge in edges), delta=1e-12)
            for axis in "xyz"[:dimension]:
                # The area is that of the undeformed body: off by the strain.
                self.assertAlmostEqual(summary["bodies"][0]["stress"][2 * axis] / -PRESSURE, 1.0, delta=PRESSURE / YOUNG)

    def test_steps_of_voxels_are_warned_of(self):
        """The area of a disk of voxels is that of its steps, 4/pi of that of the disk: a flux through it is too large, a pressure is not."""
        across = numpy.arange(40) - 19.5
        numpy.save(self.path("disk.npy"), (numpy.hypot(*numpy.meshgrid(across, across)) < 20).astype("uint8"))
        body = {"Shape": "Voxels", "File": "disk.npy", "Value": 1, "Voxel Size": 2e-4}
        scene = scene_of(body, 0.012, 1e-3)
        area, messages = self.area(scene)
        self.assertNotIn("steps of its voxels", messages)
        self.assertAlmostEqual(area / (4 * 8e-3), 1.0, delta=0.05)
        scene.remove("Boundaries > Load > Pressure").set("Boundaries > Load > Stress", [0.0, 1e5])
        self.assertIn("steps of its voxels", self.area(scene)[1])

    def test_flat_faces_of_voxels_are_as_large_as_they_are(self):
        """Of a box and of one with a step of ten voxels, in 2D and 3D, in cells of five voxels and of half of one; no face is a staircase."""
        for size, shape in ((2e-4, (40, 30)), (2e-3, (12, 10)), (2e-4, (21, 13, 12))):
            for stepped in (False, True):
                box = numpy.ones(shape, dtype="uint8")
                if stepped:
                    box[tuple(slice(length // 2, None) for length in shape)] = 0
                numpy.save(self.path("box.npy"), box)
                body = {"Shape": "Voxels", "File": "box.npy", "Value": 1, "Voxel Size": size, "Corner": self.middle(1e-3, len(shape))}
                scene = scene_of(body, 0.03, 1e-3, len(shape)).remove("Boundaries > Load > Pressure")
                scene.set("Boundaries > Load > Stress", [0.0, 1e5, 0.0][:len(shape)])
                with self.subTest(size=size, shape=shape, stepped=stepped):
                    self.assertNotIn("steps of its voxels", self.area(scene)[1])

    def test_choices_that_say_nothing(self):
        body = {"Shape": "Box", "Lower Corner": [0.0, 0.0], "Upper Corner": [0.01, 0.01],
                "Operations": {"Base": {"Operation": "Cut", "Shape": "Ball", "Centre": [0.005, 0.005], "Radius": 0.002}}}
        for name, value, words in (("Part", "Base", "rename the operation"), ("Largest Angle", 20.0, "there is neither")):
            scene = scene_of(body, 0.015, 1e-3).set(f"Boundaries > Load > {name}", value)
            answer = rhegma("--check", self.write("checked.xml", scene.text()))
            self.assertEqual(answer.status, 1, answer)
            self.assertIn(words, answer.messages)

    def test_what_is_not_free_is_left_out(self):
        """A quarter of a plate: its planes of symmetry are no surface. Two bonded bodies: nor is the face between them."""
        body = {"Shape": "Box", "Lower Corner": [0.0, 0.0], "Upper Corner": [0.01, 0.01]}
        scene = scene_of(body, 0.015, 1e-3)
        self.assertAlmostEqual(self.area(scene)[0], 0.04, delta=1e-5)
        for axis in "xy":
            scene.set(f"Boundaries > Half {axis}", {"Type": "Symmetry", "Axis": axis, "Position": 0.0})
        self.assertAlmostEqual(self.area(scene)[0], 0.02, delta=1e-5)
        scene.set("Boundaries > Load > Facing", [-1.0, 0.0])
        answer = rhegma("--check", self.write("checked.xml", scene.text()))
        self.assertEqual(answer.status, 1, answer)
        self.assertIn("planes of symmetry or on other bodies", answer.messages)
        scene = scene_of(body, 0.015, 1e-3)
        scene.set("Bodies > Other", {"Material": "Polymer", "Shape": "Box", "Lower Corner": [0.01, 0.002], "Upper Corner": [0.014, 0.008]})
        self.assertAlmostEqual(self.area(scene)[0], 0.034, delta=1e-5)

    def test_pressure_on_all_of_a_part_from_a_file(self):
        cell = 1e-3
        with open(self.path("part.stl"), "wb") as file:
            file.write(binary_stl(bracket(12.0, 3.5, 8.0)))
        body = {"Shape": "File", "File": "part.stl", "Scale": 1e-3, "Origin": [low + x for low, x in zip((-0.012, -0.012, -0.004), self.middle(cell, 3))],
                "Rotation": self.rng.uniform(0, 360), "Rotation Axis": [1.0, 2.0, self.rng.uniform(0, 3)]}
        self.assert_pressed_evenly(body, 0.022, cell, 3, 2e-2)

    def test_a_ring_under_pressure_inside(self):
        """Lamé: the radial displacement of a ring of four cells or more in thickness, in plane strain, to 1.5 % of the largest."""
        cell = 1e-3
        body, outer, inner = self.ring(cell, 2, (11, 13), (0.4, 0.6))
        scene = scene_of(body, 0.016, cell).set("Boundaries > Load > Part", "Bore").set("Output", {"Fields": True})
        summary, _ = self.run_scene(scene)
        self.assertAlmostEqual(summary["surfaces"][0]["area"], 2 * math.pi * inner, delta=1e-12)
        fields = self.particles(2)
        start = fields["position"] - fields["displacement"] - numpy.array(body["Centre"])
        r = numpy.linalg.norm(start, axis=1)
        found = (fields["displacement"] * start).sum(axis=1) / r
        factor = (1 + POISSON) / YOUNG * PRESSURE * inner**2 / (outer**2 - inner**2)
        exact = factor * ((1 - 2 * POISSON) * r + outer**2 / r)
        self.assertLess(numpy.abs(found - exact).max(), 0.015 * exact.max(), (outer, inner))

    def test_a_shell_under_pressure_inside(self):
        """Lamé: the mean radial displacement of a hollow ball to 2 %."""
        cell = 1e-3
        body, outer, inner = self.ring(cell, 3, (7, 8), (0.4, 0.5))
        scene = scene_of(body, 0.011, cell, 3).set("Boundaries > Load > Part", "Bore").set("Output", {"Fields": True})
        self.run_scene(scene)
        fields = self.particles(3)
        start = fields["position"] - fields["displacement"] - numpy.array(body["Centre"])
        r = numpy.linalg.norm(start, axis=1)
        found = (fields["displacement"] * start).sum(axis=1) / r
        factor = PRESSURE * inner**3 / (YOUNG * (outer**3 - inner**3))
        exact = factor * ((1 - 2 * POISSON) * r + (1 + POISSON) * outer**3 / (2 * r**2))
        weights = fields["mass"]
        self.assertAlmostEqual((weights * found).sum() / (weights * exact).sum(), 1.0, delta=0.02, msg=(outer, inner))

    def test_round_ends_of_a_shaft(self):
        """Pulled at both ends along its axis, in any direction: force and extension."""
        cell, length, radius = 1e-3, 0.016, 1e-3 * self.rng.uniform(3, 4)
        axis = numpy.array([self.rng.gauss(0, 1) for _ in range(3)])
        axis /= numpy.linalg.norm(axis)
        middle = numpy.array(self.middle(cell, 3))
        body = {"Shape": "Cylinder", "From": list(middle - 0.5 * length * axis), "To": list(middle + 0.5 * length * axis), "Radius": radius}
        scene = scene_of(body, 0.013, cell, 3).set("Output", {"Fields": True}).remove("Boundaries > Load")
        area = math.pi * radius**2
        for name, side in (("Upper", 1.0), ("Lower", -1.0)):
            load = {"Stress": list(side * PRESSURE * axis)} if self.rng.random() < 0.5 else {"Force": list(side * area * PRESSURE * axis)}
            scene.set(f"Boundaries > {name}", {"Type": "Traction", "Body": "Part", "Surface": "Body", "Facing": list(side * axis), "Largest Angle": 5.0, **load})
        summary, history = self.run_scene(scene)
        for surface in summary["surfaces"]:
            self.assertAlmostEqual(surface["area"] / area, 1.0, delta=1e-12)
        for d in range(3):
            self.assertAlmostEqual(history[f"Upper.force_{'xyz'[d]}"][-1], area * PRESSURE * axis[d], delta=1e-9 * area * PRESSURE)
        fields = self.particles(3)
        start = (fields["position"] - fields["displacement"] - middle) @ axis
        slope = numpy.polyfit(start, fields["displacement"] @ axis, 1)[0]
        self.assertAlmostEqual(slope / (PRESSURE / YOUNG), 1.0, delta=0.01)

    def test_heat_into_the_wall_of_a_hole(self):
        """The heat is flux times area times time, whatever the cells."""
        cell, flux, duration = 1e-3, 2e4, 0.5
        body, _, inner = self.ring(cell, 2, (8, 10), (0.4, 0.6))
        scene = scene_of(body, 0.014, cell, analysis="Dynamic").set("Thermal", {"Mechanics": False, "Initial Temperature": 300.0})
        scene.set("Time > Final Time", duration)
        scene.set("Materials > Polymer > Conductivity", 0.4).set("Materials > Polymer > Specific Heat", 1500.0)
        scene.set("Boundaries > Load", {"Type": "Heat Flux", "Body": "Part", "Surface": "Body", "Part": "Bore", "Flux": flux})
        _, history = self.run_scene(scene)
        self.assertAlmostEqual(history["heat"][-1] / (flux * 2 * math.pi * inner * duration), 1.0, delta=1e-9)

    def test_convection_all_around(self):
        """A disk of copper that cools evenly: T - T_air falls as exp(-h P t / (rho c A))."""
        cell, coefficient = 1e-3, 200.0
        radius = cell * self.rng.uniform(5, 6)
        body = {"Shape": "Ball", "Centre": self.middle(cell, 2), "Radius": radius}
        scene = scene_of(body, 0.008, cell, analysis="Dynamic").set("Thermal", {"Mechanics": False, "Initial Temperature": 400.0})
        scene.set("Materials > Polymer > Conductivity", 400.0).set("Materials > Polymer > Specific Heat", 400.0)
        scene.set("Materials > Polymer > Density", 9000.0)
        rate = coefficient * 2 / radius / (9000.0 * 400.0)
        scene.set("Time > Final Time", 0.5 / rate).set("Thermal > Conduction", "Implicit").set("Thermal > Step Ratio", 1000)
        scene.set("Boundaries > Load", {"Type": "Convection", "Body": "Part", "Surface": "Body", "Coefficient": coefficient, "Ambient Temperature": 300.0})
        summary, history = self.run_scene(scene)
        lost = 1.0 - math.exp(-0.5)
        whole = 9000.0 * 400.0 * math.pi * radius**2 * 100.0
        # Backward Euler of n steps is off by half a step; the Biot number h R / k is 0.003.
        self.assertAlmostEqual(-history["heat"][-1] / whole, lost, delta=0.005)


class GoesTogether(SurfaceScenes):
    def pressed_ring(self):
        """In motion, with smaller cells around the bore."""
        body, outer, inner = self.ring(1e-3, 2, (8, 10), (0.4, 0.6))
        scene = scene_of(body, 0.016, 1e-3, analysis="Dynamic").set("Boundaries > Load > Part", "Bore")
        scene.set("Boundaries > Load > History", "0:0, 4e-5:1, 1:1").set("Time > Final Time", 1e-4)
        return scene.set("Output", {"Checkpoint Interval": 5e-5}), outer, inner

    def test_the_energy_balance_closes(self):
        """In short steps: what the steps leave open falls with their length."""
        scene, _, _ = self.pressed_ring()
        _, history = self.run_scene(scene.set("Time > CFL", 0.15))
        self.assertGreater(history["external_work"][-1], 0.0)
        residual = history["kinetic"][-1] + history["strain"][-1] - history["external_work"][-1]
        self.assertLess(abs(residual), 0.01 * history["external_work"][-1])
        # The pressure on a closed wall has no resultant, and so the body no momentum.
        scale = math.sqrt(2 * history["kinetic"][-1] * 1200.0 * 3e-4)
        for axis in "xy":
            self.assertLess(abs(history[f"Load.force_{axis}"][-1]), 1e-9 * PRESSURE * 0.01)
            self.assertLess(abs(history[f"momentum_{axis}"][-1]), 1e-9 * scale)

    def test_smaller_cells_get_the_same_force(self):
        scene, _, _ = self.pressed_ring()
        scene.remove("Boundaries > Load").set("Boundaries > Half", {"Type": "Traction", "Body": "Part", "Surface": "Body", "Facing": [1.0, 0.5],
                                                                   "Stress": [3e5, 1e5]})
        whole, coarse = self.run_scene(scene, name="coarse")
        scene.set("Adaptivity", {"Maximum Level": 1, "Refinement": {"Level": 1, "Lower Corner": [0.0, -0.015], "Upper Corner": [0.015, 0.015]}})
        fine_summary, fine = self.run_scene(scene, name="fine")
        self.assertGreater(fine_summary["particles"], whole["particles"])
        for axis in "xy":
            self.assertAlmostEqual(fine[f"Half.force_{axis}"][-1] / coarse[f"Half.force_{axis}"][-1], 1.0, delta=1e-12)
            self.assertAlmostEqual(fine[f"momentum_{axis}"][-1] / coarse[f"momentum_{axis}"][-1], 1.0, delta=1e-3)

    def test_a_run_goes_on_from_its_checkpoint(self):
        scene, _, _ = self.pressed_ring()
        self.run_scene(scene, name="whole")
        self.run_scene(scene, "--set", "Time:Maximum Steps=40", name="part")
        self.run_scene(scene, "--restart", self.path("part", "checkpoint.h5"), name="rest")
        with open(self.path("whole", "history.csv"), encoding="utf-8") as whole, open(self.path("rest", "history.csv"), encoding="utf-8") as rest:
            self.assertEqual(whole.read().splitlines()[-1], rest.read().splitlines()[-1])

    @unittest.skipUnless(shutil.which("mpirun"), "without mpirun")
    def test_on_two_ranks(self):
        scene, _, _ = self.pressed_ring()
        _, one = self.run_scene(scene, name="one")
        answer = rhegma(self.write("two.xml", scene.text()), "--quiet", "--output", self.path("two"), launcher=(*LAUNCHER, "-np", "2"), **ROOT)
        self.assertEqual(answer.status, 0, answer)
        with open(self.path("two", "history.csv"), encoding="utf-8") as file:
            names, *_, last = file.read().splitlines()
        two = dict(zip(names.split(","), map(float, last.split(","))))
        for column in ("kinetic", "strain", "external_work"):
            self.assertAlmostEqual(two[column], one[column][-1], delta=1e-10 * one["external_work"][-1])


class WrongSurfaces(SurfaceScenes):
    def refused(self, change, where, *words):
        body, _, _ = self.ring(1e-3, 2, (8, 10), (0.4, 0.6))
        scene = scene_of(body, 0.016, 1e-3)
        for name, value in change.items():
            if value is None:
                scene.remove(f"Boundaries > Load > {name}")
            else:
                scene.set(f"Boundaries > Load > {name}", value)
        answer = rhegma(self.write("scene.xml", scene.text()), "--check")
        self.assertEqual(answer.status, 1, answer)
        self.assert_messages(answer.messages, [(where, words)])

    def test_each_has_its_message(self):
        load = "Boundaries > Load"
        self.refused({"Part": "Bores"}, f"{load} > Part", "no part of Bodies > Part", "Base, Bore")
        self.refused({"From": [0.0, 0.0]}, f"{load} > From", "Surface = Body")
        self.refused({"Facing": [0.0, 0.0]}, f"{load} > Facing", "is zero")
        self.refused({"Lower Corner": [0.1, 0.1], "Upper Corner": [0.2, 0.2]}, load, "nothing of the surface", "Lower Corner")
        self.refused({"Lower Corner": [0.0, 0.0]}, load, "Upper Corner")
        self.refused({"Part": "Bore", "Facing": [1.0, 0.0], "Largest Angle": -1.0}, f"{load} > Largest Angle")
        self.refused({"Surface": "Round"}, f"{load} > Surface", "Flat", "Body")
        self.refused({"Force": [1.0, 0.0]}, load, "Pressure", "Force")

    def test_a_flat_surface_needs_its_line(self):
        body, _, _ = self.ring(1e-3, 2, (8, 10), (0.4, 0.6))
        scene = scene_of(body, 0.016, 1e-3).remove("Boundaries > Load > Surface")
        answer = rhegma(self.write("scene.xml", scene.text()), "--check")
        self.assertEqual(answer.status, 1, answer)
        self.assert_messages(answer.messages, [("Boundaries > Load > From", ["is missing", "Surface = Body"]), ("Boundaries > Load > To", ["is missing"])])

    def test_the_check_says_the_area(self):
        body, _, inner = self.ring(1e-3, 2, (8, 10), (0.4, 0.6))
        scene = scene_of(body, 0.016, 1e-3).set("Boundaries > Load > Part", "Bore")
        answer = rhegma(self.write("scene.xml", scene.text()), "--check")
        self.assertEqual(answer.status, 0, answer)
        self.assertIn(f"Boundaries > Load: on {2e4 * math.pi * inner:.4g} cm2 of the surface of Bodies > Part", answer.output)


if __name__ == "__main__":
    unittest.main()
