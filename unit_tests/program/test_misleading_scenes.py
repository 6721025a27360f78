#!/usr/bin/env python3
"""Scenes that run and mislead: each has a warning with its number and what to write, and what a message advises runs.

RHEGMA_SEED in the environment draws other numbers."""

import json
import math
import os
import random
import re
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import ProgramTest, rhegma  # noqa: E402
from scenes import plate  # noqa: E402

SEED = int(os.environ.get("RHEGMA_SEED", "7"))


def grip(value, low, high, **more):
    return {"Type": "Velocity", "Components": "xy", "Value": value, "Lower Corner": low, "Upper Corner": high, **more}


LOWER, UPPER = ([-0.1, -0.01], [1.1, 0.01]), ([-0.1, 0.99], [1.1, 1.01])
LEFT, RIGHT = ([-0.01, -0.1], [0.01, 1.1]), ([0.99, -0.1], [1.01, 1.1])


def bare():
    return plate().remove("Boundaries").remove("Cracks").remove("Energy Release")


class MisleadingTest(ProgramTest):
    def setUp(self):
        super().setUp()
        self.rng = random.Random(SEED)

    def said(self, scene, *options):
        """Messages of --check."""
        answer = rhegma(self.write("scene.xml", scene.text()), "--check", "--quiet", *options)
        return [line[len("rhegma: "):] for line in answer.messages.splitlines()]

    def ran(self, scene, name="out"):
        answer = rhegma(self.write(name + ".xml", scene.text()), "--quiet", "--output", self.path(name))
        with open(self.path(name, "summary.json"), encoding="utf-8") as file:
            return answer, json.load(file)

    def one(self, messages, pattern):
        found = [m for m in messages if re.search(pattern, m)]
        self.assertEqual(len(found), 1, f"{pattern} in\n" + "\n".join(messages))
        return found[0]

    def none(self, messages, pattern):
        self.assertFalse([m for m in messages if re.search(pattern, m)], messages)


def block(points, **crack):
    """A block of 0.6 x 1.2 x 0.3 m of 12 x 24 x 6 cells, pulled at both ends."""
    scene = bare().set("Domain", {"Dimension": 3, "Lower Corner": [-0.1, -0.1, -0.1], "Upper Corner": [0.7, 1.3, 0.4],
                                  "Cell Size": 0.05})
    scene.set("Bodies", {"Block": {"Material": "Polymer", "Shape": "Box", "Lower Corner": [0.0, 0.0, 0.0],
                                   "Upper Corner": [0.6, 1.2, 0.3]}})
    scene.set("Boundaries", {})
    for name, y, pull in (("Low", 0.0, -1e5), ("High", 1.2, 1e5)):
        scene.set("Boundaries > " + name, {"Type": "Traction", "Body": "Block", "Corner": [0.0, y, 0.0],
                                           "Edge 1": [0.0, 0.0, 0.3], "Edge 2": [0.6, 0.0, 0.0], "Stress": [0.0, pull, 0.0]})
    return scene.set("Cracks", {"Notch": {"Points": points, **crack}}).set("Time > Final Time", 1e-4)


def corner_points(low, high, tilt=0.0):
    """A rectangle in the plane y = 0.6 + tilt x."""
    corners = ((low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1]))
    return [value for x, z in corners for value in (x, 0.6 + tilt * x, z)]


class EdgesNearASurface(MisleadingTest):
    """Edges of a crack in 3D are fronts where a cell of material lies ahead of them."""

    LIGAMENT = r"^warning: Cracks > Notch > Points: less than a cell of material is left ahead of "

    def test_the_length_is_said(self):
        for _ in range(4):
            near = [self.rng.uniform(0.01, 0.045) for _ in range(3)]  # of cells of 0.05
            end = self.rng.uniform(0.2, 0.4)
            tilt = self.rng.uniform(-0.3, 0.3)
            with self.subTest(near=near, end=end, tilt=tilt):
                points = corner_points((near[0], near[1]), (end, 0.3 - near[2]), tilt)
                line = self.one(self.said(block(points)), self.LIGAMENT)
                slope = math.hypot(1.0, tilt)
                length = 0.3 - near[1] - near[2] + 2.0 * (end - near[0]) * slope
                said = float(re.search(r"ahead of ([0-9.]+) mm", line).group(1))
                self.assertAlmostEqual(said, 1e3 * length, delta=1e3 * 0.05)  # an edge at the corners may be a front
                self.assertIn("no energy release is found", line)

    def test_cracks_that_end_at_or_beyond_the_surface_are_right(self):
        for beyond in (0.0, self.rng.uniform(1e-3, 0.05)):
            for tilt in (0.0, self.rng.uniform(-0.4, 0.4)):
                with self.subTest(beyond=beyond, tilt=tilt):
                    points = corner_points((-beyond, -beyond), (0.29, 0.3 + beyond), tilt)
                    self.none(self.said(block(points)), "material is left ahead")

    def test_a_crack_with_room_around_it_is_right(self):
        low = [self.rng.uniform(0.06, 0.09) for _ in range(2)]
        self.none(self.said(block(corner_points(low, (0.4, 0.3 - low[1])))), "material is left ahead")

    def test_edges_that_the_scene_says_are_no_fronts(self):
        points = corner_points((0.02, 0.02), (0.29, 0.28))
        self.none(self.said(block(points, **{"Front Edges": [2]})), "material is left ahead")


class PlanesAndPieces(MisleadingTest):
    def test_a_plane_of_symmetry_that_is_given_twice(self):
        scene = bare().set("Boundaries", {"Left": {"Type": "Symmetry", "Axis": "x", "Position": 0.0},
                                          "Low": {"Type": "Symmetry", "Axis": "y", "Position": 0.0}})
        self.none(self.said(scene), "the same plane")
        line = self.one(self.said(scene.set("Boundaries > Low > Axis", "x")), "^warning: Boundaries > L[eo][fw].* is the same plane")
        self.assertIn("so it adds nothing; check Axis and Position", line)

    def test_a_piece_that_another_body_holds_is_not_free(self):
        """The crack divides the left body and ends in the right one."""
        end = self.rng.uniform(0.6, 0.7)  # the bodies meet at 0.5
        scene = bare().set("Cracks", {"Notch": {"Points": [0.0, 0.52, end, 0.52]}})
        scene.set("Bodies > Plate > Upper Corner", [0.5, 1.0])
        load = {"Type": "Traction", "From": [0.0, 1.0], "To": [0.5, 1.0], "Stress": [0.0, 1e5], "Body": "Plate"}
        low = {**load, "From": [0.0, 0.0], "To": [0.5, 0.0], "Stress": [0.0, -1e5]}
        scene.set("Boundaries", {"High": load, "Low": low})
        self.one(self.said(scene), "is cut in 2 pieces")
        scene.set("Bodies > Right", {"Material": "Polymer", "Shape": "Box", "Lower Corner": [0.5, 0.0], "Upper Corner": [1.0, 1.0],
                                     "Bonded To": "Plate"})
        self.none(self.said(scene), "is cut in 2 pieces")

    def test_drift_of_a_run_that_waits_for_rest(self):
        """Two tractions along the same direction: the body drifts by less than 3 % of its length."""
        scene = bare().set("Time > Final Time", 1e-2)
        load = {"Type": "Traction", "Body": "Plate", "From": [0.0, 1.0], "To": [1.0, 1.0], "Stress": [0.0, self.rng.uniform(50.0, 100.0)]}
        scene.set("Boundaries", {"High": load, "Low": {**load, "From": [0.0, 0.0], "To": [1.0, 0.0]}})
        self.none(self.said(scene), "no load balances it")
        scene.set("Damping", {"Mass Rate": 100.0, "Stop When Settled": True})
        self.one(self.said(scene), "no load balances it")


def bimaterial(modulus, border=0.7):
    """The notch of the plate runs to the right, where another material begins."""
    scene = bare().set("Cracks", {"Notch": {"Points": [0.0, 0.52, 0.32, 0.52]}}).set("Energy Release", {"Crack Closure": False})
    scene.set("Materials > Steel", {"Model": "Linear Elastic", "Density": 1200.0, "Young Modulus": modulus, "Poisson Ratio": 0.33})
    scene.set("Bodies > Plate > Upper Corner", [border, 1.0])
    scene.set("Bodies > Right", {"Material": "Steel", "Shape": "Box", "Lower Corner": [border, 0.0], "Upper Corner": [1.0, 1.0],
                                 "Bonded To": "Plate"})
    scene.set("Boundaries", {"Low": grip([0.0, -1.0], *LOWER), "High": grip([0.0, 1.0], *UPPER)})
    return scene.set("Propagation", {"Toughness": "10", "Direction": "Straight"}).set("Time > Final Time", 4e-3)


class CracksIntoAnotherMaterial(MisleadingTest):
    AHEAD = r"^warning: Propagation > Toughness, 10 J/m2 at rest, is that of all materials, and straight ahead of crack Notch, front 0 in "
    COMES = r"^crack Notch, front 0: it comes into Materials > Steel \(its Young's modulus is 2 times that of Materials > Polymer\) at t = "

    def test_it_is_said_before_the_run_and_at_the_border(self):
        border = self.rng.choice([0.6, 0.65, 0.7])
        scene = bimaterial(6e9, border)
        line = self.one(self.said(scene), self.AHEAD)
        self.assertIn("in Materials > Polymer begins, after about ", line)
        self.assertIn("Materials > Steel (its Young's modulus is 2 times that of Materials > Polymer)", line)
        self.assertIn("end the run before (Time > Final Time)", line)
        about = float(re.search(r"after about ([0-9.]+) mm", line).group(1))
        self.assertAlmostEqual(about, 1e3 * (border - 0.32), delta=50.0)  # a cell
        answer, summary = self.ran(scene)
        self.assertEqual(answer.status, 0, answer)
        line = self.one(summary["warnings"], self.COMES)
        x, y = map(float, re.search(r"at \(([-0-9.e]+), ([-0-9.e]+)\)", line).groups())
        self.assertAlmostEqual(x, border, delta=0.1)  # an increment is a cell, and the material that of the nearest particle
        self.assertAlmostEqual(y, 0.52, delta=0.05)
        self.assertGreater(summary["cracks"][0]["fronts"][0]["position"][0], border)

    def test_nothing_is_said_of_the_same_stiffness_or_of_a_gap(self):
        self.none(self.said(bimaterial(3e9)), "straight ahead")
        apart = bimaterial(6e9, 0.6).set("Bodies > Right > Lower Corner", [0.8, 0.0])
        apart.remove("Bodies > Right > Bonded To")
        self.none(self.said(apart), "straight ahead")
        cell = apart.set("Bodies > Right > Lower Corner", [0.68, 0.0])  # no particle between 0.6 and 0.65, a cell
        self.none(self.said(cell), "straight ahead")
        self.one(self.said(cell.set("Bodies > Right > Lower Corner", [0.62, 0.0])), "straight ahead")  # they share nodes

    def test_fronts_that_do_not_get_there(self):
        wave = 1000.0  # [m/s]; Rayleigh waves have 0.93 of sqrt(E / (2 (1 + nu) rho)) = 970 m/s
        ahead = 0.7 - 0.32
        self.none(self.said(bimaterial(6e9).set("Time > Final Time", 0.8 * ahead / wave)), "straight ahead")
        self.one(self.said(bimaterial(6e9).set("Time > Final Time", 1.25 * ahead / (0.9 * 970.0))), "straight ahead")
        slow = bimaterial(6e9).set("Propagation > Speed Limit", 50.0)  # 0.2 m in the 4 ms
        self.none(self.said(slow), "straight ahead")
        steps = bimaterial(6e9).set("Time", {"Analysis": "Quasi-Static", "Final Time": 1.0, "Load Steps": 6})
        self.none(self.said(steps.set("Propagation > Increment", 1.0)), "straight ahead")  # 0.3 m
        self.one(self.said(steps.set("Time > Load Steps", 9)), "straight ahead")

    def test_a_shear_modulus_is_named_where_it_alone_differs(self):
        scene = bimaterial(3e9).set("Materials > Steel > Poisson Ratio", 0.2)
        line = self.one(self.said(scene), "straight ahead")
        self.assertIn(f"(its shear modulus is {1.33 / 1.2:.4g} times that of Materials > Polymer)", line)

    def test_cracks_along_a_border(self):
        """Their toughness is that of the border, before the run and in it; also where the border is not along cells."""
        scene = bimaterial(6e9)
        scene.set("Bodies > Plate > Upper Corner", [1.0, 0.52]).set("Bodies > Right > Lower Corner", [0.0, 0.52])
        self.none(self.said(scene), "straight ahead")
        answer, summary = self.ran(scene)
        self.assertEqual(answer.status, 0, answer)
        self.assertGreater(summary["cracks"][0]["fronts"][0]["position"][0], 0.5)
        self.none(summary["warnings"], "it comes into|straight ahead")
        rise = math.tan(math.radians(self.rng.uniform(15.0, 25.0)))
        scene.set("Cracks > Notch > Points", [0.25, 0.5 - 0.25 * rise, 0.5, 0.5]).remove("Bodies").set("Bodies", {})
        ends = [0.0, 0.5 - 0.5 * rise], [1.0, 0.5 + 0.5 * rise]
        scene.set("Bodies > Plate", {"Material": "Polymer", "Shape": "Polygon", "Points": [0.0, 0.0, 1.0, 0.0, *ends[1], *ends[0]]})
        scene.set("Bodies > Other", {"Material": "Steel", "Shape": "Polygon", "Points": [*ends[0], *ends[1], 1.0, 1.0, 0.0, 1.0],
                                     "Bonded To": "Plate"})
        self.none(self.said(scene), "straight ahead")


class GripsThatMoveAlike(MisleadingTest):
    ALIKE = "so that (nothing|only its inertia) strains it"

    def grips(self, first, second, static=False):
        scene = bare().set("Boundaries", {"A": first, "B": second})
        if static:
            scene.set("Time > Analysis", "Static").set("Time > Final Time", 1.0)
        return self.said(scene)

    def test_at_right_angles_to_the_ends(self):
        v = self.rng.uniform(0.2, 2.0)
        line = self.one(self.grips(grip([v, 0.0], *LOWER), grip([v, 0.0], *UPPER)), self.ALIKE)
        self.assertIn("Boundaries > A: it and Boundaries > B move both ends of Bodies > Plate the same distance along x, ", line)
        self.assertIn(f"{v * 1e-3 * 1e3:.4g}"[:4], line)  # mm in 1 ms
        self.one(self.grips(grip([0.0, v], *LEFT), grip([0.0, v], *RIGHT)), self.ALIKE)
        self.none(self.grips(grip([v, 0.0], *LOWER), grip([-v, 0.0], *UPPER)), self.ALIKE)  # shear
        self.none(self.grips(grip([v, 0.0], *LOWER), grip([0.0, 0.0], *UPPER)), self.ALIKE)

    def test_by_histories(self):
        v = self.rng.uniform(0.2, 2.0)
        twice = grip([0.0, 2.0 * v], *UPPER, History="0.5 * t / 1e-3")
        self.one(self.grips(grip([0.0, v], *LOWER, History="0:0, 1e-3:1"), twice), self.ALIKE)
        self.one(self.grips(grip([0.0, -v], *LOWER, History="-1"), grip([0.0, v], *UPPER)), self.ALIKE)
        self.none(self.grips(grip([0.0, -v], *LOWER), twice), self.ALIKE)
        shaken = [grip([v, 0.0], *at, History="sin(2 * pi * 5000 * t)") for at in (LOWER, UPPER)]
        self.none(self.grips(*shaken), self.ALIKE)  # inertia is meant
        for blow in ("0:0, 2e-4:1, 4e-4:0", "0:0, 3e-6:1, 6e-6:0", "sin(pi * t / 1e-3)"):
            self.none(self.grips(*(grip([v, 0.0], *at, History=blow) for at in (LOWER, UPPER))), self.ALIKE)

    def test_by_fields(self):
        fields = []
        for at, text in ((LOWER, "0, 1e-4"), (UPPER, "0, 1e-4 * (1 + 0 * x)")):
            fields.append({k: x for k, x in grip([0.0, 0.0], *at, Field=text).items() if k != "Value"})
        self.one(self.grips(*fields, static=True), "so that nothing strains it")
        self.one(self.grips(fields[0], grip([0.0, 1e-4], *UPPER), static=True), "so that nothing strains it")
        self.none(self.grips(fields[0], dict(fields[1], Field="0, 1e-4 * y"), static=True)
                  + self.grips(dict(fields[0], Field="0, 1e-4 * x"), fields[1], static=True), self.ALIKE)
        for waves in (3, 6, 30):  # along the edges of the plate, from 0 to 1
            bent = [dict(f, Field=f"0, 1e-4 * (1 + sin({2 * waves} * pi * x))") for f in fields]
            self.none(self.grips(*bent, static=True), self.ALIKE)


def cut_static(stress, **more):
    scene = bare().set("Time > Analysis", "Static").set("Time > Final Time", 1.0)
    scene.set("Cracks", {"Cut": {"Points": [-0.01, 0.27, 1.01, 0.27]}})
    pull = {"Type": "Traction", "Body": "Plate", "From": [1.0, 1.0], "To": [0.0, 1.0], "Stress": [0.0, stress]}
    return scene.set("Boundaries", {"Base": grip([0.0, 0.0], *LOWER), "Top": pull, **more})


class CutBodiesInEquilibrium(MisleadingTest):
    def test_the_piece_is_named_and_the_advice_runs(self):
        scene = cut_static(-1e6)
        lines = self.said(scene)
        line = self.one(lines, "can move along y: support it")
        found = re.match(r"a part of Bodies > Plate \(([0-9.]+) kg around ([-0-9.e]+), ([-0-9.e]+) m\) can move along y", line)
        self.assertTrue(found, line)
        mass, x, y = map(float, found.groups())
        # Half of a cell next to the crack may count to either piece.
        self.assertAlmostEqual(mass, 1200.0 * 0.73, delta=1200.0 * 0.025)
        self.assertAlmostEqual(x, 0.5, delta=0.025)
        self.assertAlmostEqual(y, 0.635, delta=0.025)
        self.one(lines, "add a section Contact with Law = Stick, or Coulomb and a Friction Coefficient")
        for law in ({"Law": "Stick"}, {"Law": "Coulomb", "Friction Coefficient": 0.5}):
            answer, _ = self.ran(scene.set("Contact", law))
            self.assertEqual(answer.status, 0, answer)
        held = cut_static(1e6, Above=grip([0.0, 0.0], *UPPER))
        self.assertEqual(rhegma(self.write("held.xml", held.text()), "--check", "--quiet").status, 0)

    def test_a_whole_body_is_named_whole(self):
        scene = cut_static(-1e6).remove("Cracks").remove("Boundaries > Base")
        self.one(self.said(scene), "^Bodies > Plate can move along y: support it, or write Time > Rigid Modes = Remove$")

    def test_closed_cracks_by_load_factor(self):
        """No factor of a load that closes a crack makes it grow: the advice is a run that follows the loads."""
        scene = plate().set("Time", {"Analysis": "Quasi-Static", "Final Time": 1.0, "Load Steps": 2, "Rigid Modes": "Remove"})
        scene.set("Domain > Plane", "Stress").set("Energy Release", {})
        press = {"Type": "Traction", "Body": "Plate", "From": [1.0, 1.0], "To": [0.0, 1.0], "Stress": [0.0, -1e6]}
        scene.set("Boundaries", {"Top": press, "Bottom": dict(press, From=[0.0, 0.0], To=[1.0, 0.0], Stress=[0.0, 1e6])})
        scene.set("Propagation", {"Toughness": "400"})
        answer, summary = self.ran(scene)
        line = self.one(summary["warnings"], "its faces overlap")
        self.assertIn("add a section Contact (with Law = Stick, ", line)
        self.assertIn("write Propagation > Load Control = Functions of Time", line)
        scene.set("Contact", {}).set("Propagation > Load Control", "Functions of Time")
        answer, summary = self.ran(scene, "advised")
        self.assertEqual(answer.status, 0, answer)
        self.none(summary["warnings"], "its faces overlap")


class CutBodiesInMotion(MisleadingTest):
    def test_contact_as_advised_runs(self):
        scene = plate().remove("Energy Release").set("Cracks > Notch > Points", [-0.01, 0.52, 1.01, 0.52])
        scene.set("Boundaries > Pull", {"Type": "Traction", "Body": "Plate", "From": [1.0, 1.0], "To": [0.0, 1.0], "Stress": [0.0, -1e5]})
        line = self.one(self.said(scene), "at the start Bodies > Plate is cut in 2 pieces")
        self.assertIn("add a section Contact", line)
        answer, _ = self.ran(scene.set("Contact", {}))
        self.assertEqual(answer.status, 0, answer)


class CutsOfNothing(MisleadingTest):
    def test_one_that_names_the_wall_of_a_hole_is_meant(self):
        """A hole that is cut twice: the second cut has its wall, which a load chooses. Without such a load it does nothing."""
        hole = {"Operation": "Cut", "Shape": "Ball", "Centre": [0.5, 0.5], "Radius": self.rng.uniform(0.15, 0.3)}
        scene = bare().set("Bodies > Plate > Operations", {"Hole": hole, "Again": dict(hole)})
        load = {"Type": "Traction", "Body": "Plate", "Surface": "Body", "Pressure": 1e5}
        nothing = "Operations > Again: it cuts nothing"
        self.one(self.said(scene.set("Boundaries > Gas", dict(load))), nothing)
        for part in ("Again", "Base"):
            self.none(self.said(scene.set("Boundaries > Gas", dict(load, Part=part))), nothing)
        self.one(self.said(scene.set("Boundaries > Gas", dict(load, Part="Hole"))), nothing)


class ForcesWithoutThickness(MisleadingTest):
    def test_a_missing_thickness_is_said_where_forces_act(self):
        force = self.rng.uniform(100.0, 900.0)
        line = {"Type": "Line Load", "Body": "Plate", "From": [1.0, 0.0], "To": [1.0, 1.0], "Force": [force, 0.0]}
        point = {"Type": "Point Load", "Body": "Plate", "Point": [1.0, 0.5], "Force": [force, 0.0]}
        for plane in ("Stress", "Strain"):
            for load in (line, point):
                scene = plate().set("Domain > Plane", plane).set("Boundaries > Pull", load)
                said = self.one(self.said(scene), "Domain > Thickness is not given and is 1 m")
                self.assertIn(f"the force of Boundaries > Pull, {force:.4g} N at most, acts on a body 1 m thick", said)
                for thickness in (1.0, 0.5):
                    self.none(self.said(scene.set("Domain > Thickness", thickness)), "Thickness is not given")
        scene = plate().set("Domain > Plane", "Strain").set("Boundaries > Pull", dict(point, History="0:0, 3e-4:1000, 4e-4:0"))
        self.assertIn(f" {1e3 * force:.4g} N at most", self.one(self.said(scene), "Domain > Thickness is not given"))
        self.none(self.said(plate()), "Thickness")  # tractions are per area


class Heat(MisleadingTest):
    def test_one_particle_a_cell_next_to_extrapolating_cracks(self):
        words = "Bodies > Plate > Particles Per Cell is 1: with Cracks > Formulation = Corrected Broken Cell and heat"
        for formulation in ("Corrected Broken Cell", "Dual Field"):
            for particles in (1, 2):
                for heat in (True, False):
                    scene = plate().set("Cracks > Formulation", formulation).set("Bodies > Plate > Particles Per Cell", particles)
                    scene.set("Materials > Polymer > Conductivity", 0.2).set("Materials > Polymer > Specific Heat", 1500.0)
                    if heat:
                        scene.set("Thermal", {"Initial Temperature": 300.0})
                    wrong = heat and particles == 1 and formulation != "Dual Field"
                    self.assertEqual(len([m for m in self.said(scene) if words in m]), 1 if wrong else 0)

    def steady(self):
        scene = bare().set("Time > Analysis", "Static").set("Time > Final Time", 1.0).set("Domain > Upper Corner", [2.6, 1.2])
        scene.set("Time > Rigid Modes", "Remove").set("Thermal", {"Initial Temperature": 300.0, "Conduction": "Steady"})
        scene.set("Materials > Polymer > Conductivity", 0.2).set("Materials > Polymer > Specific Heat", 1500.0)
        scene.set("Bodies > Other", {"Material": "Polymer", "Shape": "Box", "Lower Corner": [1.4, 0.0], "Upper Corner": [2.4, 1.0]})
        return scene.set("Boundaries", {"Hot": {"Type": "Temperature", "Temperature": 350.0, "Lower Corner": [-0.01, -0.1],
                                                "Upper Corner": [0.01, 1.1]}})

    def test_steady_bodies_without_a_temperature(self):
        undetermined = "reaches Bodies > Other, so that its steady temperature is not determined"
        self.one(self.said(self.steady()), undetermined + ": it keeps that of the start")
        flux = self.rng.uniform(100.0, 900.0)
        heated = self.steady().set("Boundaries > Flux", {"Type": "Heat Flux", "Body": "Other", "From": [1.4, 0.0], "To": [1.9, 0.0],
                                                         "Flux": flux})
        line = self.one(self.said(heated), undetermined + r", and \S+ W flow into it that nothing takes away")
        self.assertAlmostEqual(float(re.search(r"and (\S+) W", line).group(1)), 0.5 * flux, delta=1e-3 * flux)
        cooled = heated.set("Boundaries > Air", {"Type": "Convection", "Body": "Other", "From": [2.4, 0.0], "To": [2.4, 1.0],
                                                 "Coefficient": 10.0, "Ambient Temperature": 300.0})
        self.none(self.said(cooled), "not determined")

    def test_heat_of_sources_is_that_of_the_particles(self):
        def heat(scene):
            line = self.one(self.said(scene), r"and \S+ W flow into it that nothing takes away")
            return float(re.search(r"and (\S+) W", line).group(1))

        disk = self.steady().set("Bodies > Other", {"Material": "Polymer", "Shape": "Ball", "Centre": [1.9, 0.5], "Radius": 0.4})
        disk.set("Thermal > Sources", {"S": {"Type": "Box", "Lower Corner": [1.3, 0.0], "Upper Corner": [2.5, 1.0],
                                             "Power Density": 100.0}})
        self.assertAlmostEqual(heat(disk), 100.0 * math.pi * 0.4**2, delta=0.01 * 50.3)  # areas are exact to 1e-3
        both = self.steady().set("Thermal > Sources", {"S": {"Type": "Ball", "Centre": [1.2, 0.5], "Radius": 0.5, "Power": 100.0}})
        self.assertAlmostEqual(heat(both), 50.0, delta=0.5)  # half of it in each of two bodies alike

    def test_a_part_that_a_crack_cuts_off(self):
        scene = self.steady().remove("Bodies > Other").set("Cracks", {"Cut": {"Points": [0.5, -0.01, 0.5, 1.01]}})
        scene.set("Boundaries > Flux", {"Type": "Heat Flux", "Body": "Plate", "From": [1.0, 0.0], "To": [1.0, 1.0], "Flux": 500.0})
        answer = rhegma(self.write("cut.xml", scene.text()), "--quiet", "--output", self.path("cut"))
        self.assertNotEqual(answer.status, 0)
        self.assertIn("into a part that insulating cracks cut off", answer.messages)

    def test_faces_that_are_hotter_than_their_ignition_temperature(self):
        hot = self.rng.uniform(450.0, 600.0)

        def burning(own):
            scene = plate().remove("Boundaries").remove("Energy Release").set("Bodies > Plate > Temperature", own)
            scene.set("Materials > Polymer > Conductivity", 0.2).set("Materials > Polymer > Specific Heat", 1500.0)
            scene.set("Thermal", {"Initial Temperature": 300.0})
            return scene.set("Combustion", {"Notch": {"Burn Law": "Vieille", "Burn Coefficient": 1e-8, "Burn Exponent": 0.9,
                                                      "Gas Constant": 320.0, "Flame Temperature": 2500.0, "Initial Pressure": 3e6,
                                                      "Initial Temperature": 300.0, "Initial Gap": 1e-5,
                                                      "Ignition Temperature": 420.0}})

        line = self.one(self.said(burning(hot)), "Combustion > Notch > Ignition Temperature is 420 K")
        self.assertIn(f"its faces have up to {hot:.4g} K at the start, so that they burn at once", line)
        self.none(self.said(burning(310.0)), "Ignition Temperature is")
        # A hot body in the corner of the bounds of an inclined crack, 0.28 m from it.
        corner = burning(310.0).set("Cracks > Notch > Points", [0.1, 0.1, 0.9, 0.9]).remove("Bodies").set("Bodies", {})
        corner.set("Bodies > Plate", {"Material": "Polymer", "Shape": "Polygon", "Points": [
            0.0, 0.0, 0.6, 0.0, 0.6, 0.2, 0.9, 0.2, 0.9, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0]})
        corner.set("Bodies > Plug", {"Material": "Polymer", "Shape": "Box", "Lower Corner": [0.6, 0.0], "Upper Corner": [0.9, 0.2],
                                     "Temperature": hot, "Bonded To": "Plate"})
        self.none(self.said(corner), "Ignition Temperature is")
        corner.set("Cracks > Notch > Points", [0.3, 0.08, 0.7, 0.08])
        self.assertIn(f"up to {hot:.4g} K", self.one(self.said(corner), "Ignition Temperature is"))


class HistoriesInStaticAnalysis(MisleadingTest):
    def with_history(self, history, **time):
        scene = cut_static(1e6).remove("Cracks").set("Boundaries > Top > History", history)
        for name, value in time.items():
            scene.set("Time > " + name.replace("_", " "), value)
        return self.said(scene)

    def test_the_value_at_the_end_is_said(self):
        line = self.one(self.with_history("t / 1000"), "Boundaries > Top > History: its factor is 0.001 at Time > Final Time = 1 s")
        self.assertIn("so this boundary acts with 0.001 of its value; leave History out", line)
        part = self.rng.uniform(0.1, 0.4)
        self.one(self.with_history(f"0:0, 0.5:1, 1:{part}"), "its factor reaches 1, and is .* the only time at which loads count")

    def test_ramps_to_the_end_and_constants_are_right(self):
        for history in ("t", "0:0, 1:1", "0.1", "sin(pi / 2 * t)"):
            self.none(self.with_history(history), "History")
        self.none(self.with_history("t / 10", Final_Time=10.0), "History")


if __name__ == "__main__":
    unittest.main()
