"""Tests of rhegma-plot --scene: what the picture of a scene shows before any run, by the program's own state of it."""

import json
import os
import random
import subprocess
import unittest
import xml.etree.ElementTree as ElementTree

from tool import ToolTest, picture_size, run  # first, as it finds the Python for all others

import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.colors import to_rgb
from matplotlib.quiver import Quiver

from rhegma.fields import read_times
from rhegma_tools import scene_panel, style
from rhegma_tools.field_picture import View
from rhegma_tools.interpreter import Problem
from rhegma_tools.scene_outlines import outlines_of
from rhegma_tools.scene_picture import Drawing, flat_figure, list_lines, spatial_figure, summary_line
from rhegma_tools.scene_state import state_in, state_of
from rhegma_tools.scene_symbols import Arrows, Nodes, Plane, peak, spread
from rhegma_tools.scene_values import Scene

PROGRAM = os.environ.get("RHEGMA_PROGRAM")
SEED = int(os.environ.get("RHEGMA_SEED", "20261128"))

MATERIAL = ("Materials", {"Glass": {"Model": "Linear Elastic", "Density": 2500.0, "Young Modulus": 7e10, "Poisson Ratio": 0.2}})


def xml(values, name="Rhegma"):
    """A parameter list from nested dictionaries of numbers, texts and lists of numbers."""
    kinds = {int: "int", float: "double", str: "string", bool: "bool"}
    parts = []
    for key, value in values.items():
        if isinstance(value, dict):
            parts.append(xml(value, key))
        elif isinstance(value, (list, tuple)):
            parts.append(f'<Parameter name="{key}" type="Array(double)" value="{{{", ".join(repr(float(v)) for v in value)}}}"/>')
        else:
            parts.append(f'<Parameter name="{key}" type="{kinds[type(value)]}" value="{str(value).lower() if isinstance(value, bool) else value}"/>')
    return f'<ParameterList name="{name}">{"".join(parts)}</ParameterList>'


def plate(width, height, cell, crack, boundaries, hole=None, **more):
    """A scene in 2D: a plate with a corner at the origin, an edge crack and perhaps a hole (x, y, radius)."""
    body = {"Material": "Glass", "Shape": "Box", "Lower Corner": [0, 0], "Upper Corner": [width, height]}
    if hole:
        body["Operations"] = {"Hole": {"Operation": "Cut", "Shape": "Ball", "Centre": hole[:2], "Radius": float(hole[2])}}
    margin = 4 * cell
    return {"Domain": {"Dimension": 2, "Lower Corner": [-margin, -margin], "Upper Corner": [width + margin, height + margin], "Cell Size": cell},
            "Time": {"Final Time": 1e-5}, **dict([MATERIAL]), "Bodies": {"Plate": body}, "Cracks": {"Notch": {"Points": crack}},
            "Boundaries": boundaries, **more}


def block(cell=1e-3, **more):
    """A scene in 3D: a block of 12 x 10 x 8 mm with a round crack, pulled along z, and a plane of symmetry at x = 0."""
    pull = {"Type": "Traction", "Body": "Block", "Corner": [0, 0, 0.008], "Edge 1": [0.012, 0, 0], "Edge 2": [0, 0.01, 0], "Stress": [0, 0, 3e6]}
    return {"Domain": {"Dimension": 3, "Lower Corner": [0, -0.002, -0.002], "Upper Corner": [0.014, 0.012, 0.01], "Cell Size": cell},
            "Time": {"Final Time": 1e-5}, **dict([MATERIAL]),
            "Bodies": {"Block": {"Material": "Glass", "Shape": "Box", "Lower Corner": [0, 0, 0], "Upper Corner": [0.012, 0.01, 0.008]}},
            "Cracks": {"Penny": {"Centre": [0.006, 0.005, 0.0043], "Normal": [0, 0, 1], "Radius": 0.0025}},
            "Boundaries": {"Middle": {"Type": "Symmetry", "Axis": "x", "Position": 0.0},
                           "Floor": {"Type": "Velocity", "Lower Corner": [0, 0, 0], "Upper Corner": [0.012, 0.01, 0], "Components": "z", "Value": [0, 0, 0]},
                           "Pull": pull}, **more}


class Spread(unittest.TestCase):
    def test_points_are_even(self):
        """No point is farther from a chosen one than the chosen ones are from one another; few points are all chosen."""
        seed = int(os.environ.get("RHEGMA_SEED", random.randrange(10**6)))
        print(f"RHEGMA_SEED = {seed}")
        points = np.random.default_rng(seed).uniform(size=(48, 3))
        chosen = spread(points, 16)
        self.assertEqual(len(set(chosen.tolist())), 16)
        apart = np.linalg.norm(points[chosen][:, None] - points[chosen], axis=2) + 9.0 * np.eye(16)
        self.assertLessEqual(np.linalg.norm(points[:, None] - points[chosen], axis=2).min(axis=1).max(), apart.min())
        self.assertEqual(spread(points[:3], 16).tolist(), [0, 1, 2])


@unittest.skipUnless(PROGRAM, "needs the program, RHEGMA_PROGRAM")
class SceneDrawn(ToolTest):
    def drawing(self, values):
        scene = Scene(self.write("scene.xml", xml(values)))
        return Drawing(scene, state_of(scene, PROGRAM))

    def arrows_of(self, axes):
        """{label: (points, directions)} in the unit of the picture, of the arrows in the order of the symbols."""
        return [(np.asarray(q.XY), np.stack([q.U, q.V], axis=1), q) for q in axes.collections if isinstance(q, Quiver)]

    def test_settings_that_the_scene_lacks(self):
        """Parameters of --set that the scene does not have get the types that the program knows: a number, a text, an array, a flag."""
        path = self.write("scene.xml", xml(plate(0.03, 0.02, 1e-3, [0.0, 0.01, 0.008, 0.01], {}, **{"Energy Release": {}})))
        scene = Scene(path, ["Energy Release:Toughness=5000", "Time:Retries=1", "Bodies:Plate:Velocity={0, 2}", "Output:Principal Stress=true",
                             "Domain:Shape Functions=Linear"])
        drawing = Drawing(scene, state_of(scene, PROGRAM))
        self.assertTrue(any(symbol.label == "starts at 2 m/s" for symbol in drawing.symbols))

    def test_rigid_tools(self):
        """Each tool has its outline, a line in the list and, if it moves, an arrow; all are in the picture."""
        tools = {"Punch": {"Shape": "Box", "Lower Corner": [0.004, 0.0201], "Upper Corner": [0.012, 0.026], "Velocity": [0.0, -2.0]},
                 "Roller": {"Shape": "Ball", "Centre": [0.004, -0.0051], "Radius": 0.005},
                 "Weight": {"Shape": "Ball", "Centre": [0.026, 0.0251], "Radius": 0.005, "Mass": 0.05, "Force": [0.0, -0.5]}}
        values = plate(0.03, 0.02, 1e-3, [0.0, 0.01, 0.008, 0.01], {}, **{"Rigid Tools": tools})
        values["Domain"].update({"Lower Corner": [-0.005, -0.012], "Upper Corner": [0.035, 0.034]})
        values.pop("Boundaries")
        drawing = self.drawing(values)
        self.assertEqual(sorted(drawing.tools), ["Punch", "Roller", "Weight"])
        low = np.min([np.vstack(lines).min(axis=0) for lines in drawing.tools.values()], axis=0)
        np.testing.assert_allclose(low[:2], [-0.001, -0.0101], atol=1e-12)
        labels = {symbol.name: symbol for symbol in drawing.symbols}
        self.assertEqual(labels["Roller"].label, "rigid tool, at rest")
        self.assertEqual(labels["Weight"].label, "rigid tool, 50 g, 500 mN")
        self.assertEqual(labels["Punch"].label, "rigid tool, 2 m/s")
        np.testing.assert_allclose(labels["Punch"].direction, [0.0, -1.0, 0.0])
        self.assertIn("3 rigid tools", summary_line(drawing))
        _, panels = flat_figure(drawing)
        across, up = panels[0].axes.get_xlim(), panels[0].axes.get_ylim()
        self.assertLess(up[0], -10.1)
        self.assertGreater(up[1], 30.1)
        self.assertLess(across[0], -1.0)

    def test_heat_through_all_of_a_surface(self):
        """Of a scene whose only boundary is Convection through the whole surface: arrows all around."""
        glass = dict(MATERIAL[1]["Glass"], **{"Specific Heat": 800.0, "Conductivity": 1.0, "Thermal Expansion": 9e-6})
        cool = {"Type": "Convection", "Body": "Plate", "Surface": "Body", "Coefficient": 2000.0, "Ambient Temperature": 300.0}
        values = plate(0.03, 0.02, 1e-3, [0.0, 0.01, 0.008, 0.01], {"Water": cool}, Thermal={"Initial Temperature": 400.0})
        values["Materials"] = {"Glass": glass}
        found = [symbol for symbol in self.drawing(values).symbols if isinstance(symbol, Arrows)]
        self.assertGreater(len(found), 8)
        directions = np.array([symbol.direction for symbol in found])
        self.assertEqual(len(np.unique(np.round(directions), axis=0)), 4)

    def random_plate(self, rng):
        cell = 1e-3 * rng.uniform(0.8, 1.2)
        width, height = (round(rng.uniform(24, 40)) * cell for _ in range(2))
        start, length, angle = rng.uniform(0.35, 0.65) * height, rng.uniform(0.25, 0.4) * width, rng.uniform(-0.5, 0.5)
        tip = [length * np.cos(angle), start + length * np.sin(angle)]
        hole = (0.8 * width, rng.uniform(0.3, 0.7) * height, 0.09 * width)
        stress, force = rng.uniform(1e6, 9e6), rng.uniform(10.0, 90.0)
        boundaries = {
            "Top": {"Type": "Traction", "Body": "Plate", "From": [width, height], "To": [0, height], "Stress": [0, stress]},
            "Push": {"Type": "Traction", "Body": "Plate", "From": [width, 0], "To": [width, height], "Pressure": 2e6},
            "Pin": {"Type": "Point Load", "Body": "Plate", "Point": [0.5 * width, height], "Force": [-force, 0], "History": "0:0, 1e-5:2"},
            "Foot": {"Type": "Velocity", "Lower Corner": [0, 0], "Upper Corner": [width, 0], "Components": "y", "Value": [0, 0]}}
        return plate(width, height, cell, [0, start, *tip], boundaries, hole), width, height, cell, start, tip, hole, stress, force

    def test_a_random_plate_has_all_its_symbols(self):
        print(f"seed {SEED}")
        rng = random.Random(SEED)
        for _ in range(3):
            values, width, height, cell, start, tip, hole, stress, force = self.random_plate(rng)
            drawing = self.drawing(values)
            figure, (panel,) = flat_figure(drawing)
            (top, up, _), (push, left, pushed), (pin, pinned, _) = self.arrows_of(panel.axes)
            self.assertEqual((len(top), len(push), len(pin)), (7, 7, 1))
            np.testing.assert_allclose(top[:, 1], height * drawing.length, rtol=1e-12)
            self.assertTrue((up[:, 1] > 0).all() and (up[:, 0] == 0).all())
            self.assertEqual(pushed.pivot, "tip")  # a pressure has its heads on the surface
            self.assertTrue((left[:, 0] < 0).all())
            np.testing.assert_allclose(pin, [[0.5 * width * drawing.length, height * drawing.length]], rtol=1e-12)
            self.assertTrue(pinned[0, 0] < 0)
            labels = {text.get_text() for text in panel.labels}
            self.assertIn(f"Top: {stress / 1e6:.4g} MPa", labels)
            self.assertIn("Push: 2 MPa", labels)
            self.assertIn(f"Pin: {2 * force:.4g} N at most", labels)
            self.assertIn("Foot: y held", labels)
            self.check_crack_and_nodes(drawing, panel, width, cell, start, tip)
            self.check_pixels(figure, panel, drawing, hole, tip, start)
            style.plt.close(figure)

    def check_crack_and_nodes(self, drawing, panel, width, cell, start, tip):
        """The crack as the program has it goes from the edge to the tip, its front is there, and the foot has a node in each column."""
        ends = drawing.fields.crack.points[:, :2]
        for end in ([0.0, start], tip):
            self.assertLess(np.linalg.norm(ends - end, axis=1).min(), 1e-9)
        np.testing.assert_allclose(drawing.fronts, [[*tip, 0.0]], atol=1e-9)
        drawn = [line for line in panel.axes.lines if line.get_label() == "crack front"]
        np.testing.assert_allclose(drawn[0].get_xydata(), np.array([tip]) * drawing.length, atol=1e-6)
        (foot,) = [symbol for symbol in drawing.symbols if isinstance(symbol, Nodes)]
        self.assertTrue(foot.held and foot.axes == "y")
        np.testing.assert_allclose(foot.points[:, 1], 0.0, atol=1e-12)
        self.assertEqual(len(foot.points), round(width / cell) + 1)

    def check_pixels(self, figure, panel, drawing, hole, tip, start):
        """The crack is dark, the hole white, and the body has its tint."""
        figure.canvas.draw()
        picture = np.asarray(figure.canvas.buffer_rgba())[:, :, :3] / 255.0

        def around(x, y, reach=2):
            column, row = panel.axes.transData.transform((x * drawing.length, y * drawing.length))
            row = picture.shape[0] - 1 - int(round(row))
            return picture[row - reach:row + reach + 1, int(round(column)) - reach:int(round(column)) + reach + 1].reshape(-1, 3)

        self.assertLess(around(0.5 * tip[0], 0.5 * (start + tip[1])).mean(axis=1).min(), 0.25)
        self.assertTrue((around(*hole[:2]) == 1.0).all())
        tint = np.array(to_rgb(scene_panel.TINTS[0]))
        self.assertLess(np.abs(around(0.3 * hole[0], 0.1 * hole[1] + 1e-4, 4) - tint).max(axis=1).min(), 0.01)

    def test_a_hole_is_dashed_and_cells_have_the_size_of_the_program(self):
        rng = random.Random(SEED + 1)
        values, *_ = self.random_plate(rng)
        values["Adaptivity"] = {"Maximum Level": 1, "Front Cells": 6}
        drawing = self.drawing(values)
        figure, (panel,) = flat_figure(drawing)
        dashed = [c for c in panel.axes.collections if isinstance(c, LineCollection) and c.get_linestyle()[0][1]]
        self.assertEqual(len(dashed), 1)
        radius = values["Bodies"]["Plate"]["Operations"]["Hole"]["Radius"]
        self.assertAlmostEqual(np.ptp(dashed[0].get_segments()[0][:, 0]), 2 * radius * drawing.length, places=6)
        cell = values["Domain"]["Cell Size"]
        self.assertIn(f"to {0.5e6 * cell:.4g} µm (refined up to level 1)", summary_line(drawing))
        finest = drawing.fields.leaves.corners[drawing.fields.leaves.level == 1]
        self.assertAlmostEqual(np.ptp(finest[0][:, 0]), 0.5 * cell, places=12)
        style.plt.close(figure)

    def test_a_pressure_on_the_wall_of_a_hole_pushes_from_inside(self):
        values, *_ = self.random_plate(random.Random(SEED + 2))
        x, y = values["Bodies"]["Plate"]["Operations"]["Hole"]["Centre"]
        radius = values["Bodies"]["Plate"]["Operations"]["Hole"]["Radius"]
        values["Boundaries"]["Gas"] = {"Type": "Traction", "Body": "Plate", "Surface": "Body", "Part": "Hole", "Pressure": 3e6}
        drawing = self.drawing(values)
        gas = [symbol for symbol in drawing.symbols if symbol.name == "Gas"]
        self.assertGreater(len(gas), 11)
        self.assertEqual([symbol.label for symbol in gas], ["3 MPa"] + [""] * (len(gas) - 1))
        turns = []
        for symbol in gas:
            outward = symbol.points[0, :2] - [x, y]
            self.assertAlmostEqual(np.linalg.norm(outward), radius, places=9)
            np.testing.assert_allclose(symbol.direction[:2], outward / radius, atol=1e-9)
            self.assertTrue(symbol.into)
            turns.append(np.arctan2(outward[1], outward[0]))
        gaps = np.diff(np.sort(turns + [min(turns) + 2.0 * np.pi]))
        self.assertLess(max(gaps), 4.0 * np.pi / len(gas) + 0.3)  # all around
        figure, (panel,) = flat_figure(drawing)
        self.assertEqual(sum(text.get_text() == "Gas: 3 MPa" for text in panel.labels), 1)
        style.plt.close(figure)

    def test_views_in_3d(self):
        self.assertEqual(len(self.drawing(block()).fronts), 0)
        drawing = self.drawing(block(**{"Energy Release": {}}))
        pull = next(symbol for symbol in drawing.symbols if isinstance(symbol, Arrows))
        self.assertEqual(len(pull.points), 9)
        self.assertFalse(pull.into)
        plane = next(symbol for symbol in drawing.symbols if isinstance(symbol, Plane))
        self.assertEqual((plane.axis, plane.position), (0, 0.0))
        self.assertGreater(len(drawing.fronts), 8)
        np.testing.assert_allclose(np.linalg.norm(drawing.fronts - [0.006, 0.005, 0.0043], axis=1), 0.0025, rtol=0.02)
        figure, panels = spatial_figure(drawing, None)
        counts = [sum(q.N for _, _, q in self.arrows_of(panel.axes)) for panel in panels]
        self.assertEqual(counts, [0, 9, 9])  # along z they are seen from their end
        rings = [line for line in panels[0].axes.lines if line.get_marker() == "o" and len(line.get_xdata()) == 9]
        self.assertEqual(len(rings), 1)
        self.assertIn("Pull: 3 MPa", {text.get_text() for text in panels[1].labels})
        style.plt.close(figure)

    def test_arrows_have_the_directions_of_the_programs_forces(self):
        """Loads of random directions on random faces of a block; the program prints the direction of each total force."""
        print(f"seed {SEED}")
        rng = random.Random(SEED)
        corner, edges = [0, 0, 0], np.diag([0.012, 0.01, 0.008])
        for _ in range(2):
            axis, side = rng.randrange(3), rng.randrange(2)
            one, two = (edges[(axis + k) % 3] for k in ((1, 2) if side else (2, 1)))  # their cross product points outwards
            start = corner + side * edges[axis]
            face = {"Type": "Traction", "Body": "Block", "Corner": list(start), "Edge 1": list(one), "Edge 2": list(two)}
            values = block()
            values["Boundaries"] = {"Press": dict(face, Pressure=rng.choice([-1, 1]) * 2e6),
                                    "Drag": dict(face, Stress=[rng.uniform(-1e6, 1e6) for _ in range(3)], History="0:0, 1e-5:-3"),
                                    "Pin": {"Type": "Point Load", "Body": "Block", "Point": [0.006, 0.005, 0.008], "Force": [rng.uniform(-9, 9) for _ in range(3)]}}
            drawing = self.drawing(values)
            for symbol in drawing.symbols:
                text = drawing.state.forces[symbol.name]
                given = np.array([float(number) for number in text[text.index("(") + 1:text.index(")")].split(",")])
                np.testing.assert_allclose(symbol.direction, given / np.linalg.norm(given), atol=0.01, err_msg=f"{symbol.name}: {text}")

    def test_the_command_writes_a_picture_and_no_other_file(self):
        scene = self.write("plate.xml", xml(self.random_plate(random.Random(SEED + 2))[0]))
        picture = self.path("before.png")
        status, output, _ = run("rhegma-plot", "--scene", scene, "--output", picture, "--rhegma", PROGRAM)
        self.assertEqual(status, 0)
        self.assertIn(f"Wrote {picture}: 1 body, 1 crack, 3 loads, 1 support;", output)
        self.assertGreater(min(picture_size(picture)), 500)
        self.assertEqual(sorted(os.listdir(self.folder)), ["before.png", "plate.xml"])

    def test_names_of_any_letters_on_a_plain_terminal(self):
        values = plate(0.03, 0.03, 4e-4, [0, 0.015, 0.01, 0.015],
                       {"Last $x$ größer": {"Type": "Traction", "Body": "Plate", "From": [0.03, 0.03], "To": [0, 0.03], "Stress": [0, 1e6]}})
        scene = self.write("odd.xml", xml(values))
        status, output, messages = run("rhegma-plot", "--scene", scene, "-o", self.path("odd.png"), "--rhegma", PROGRAM, PYTHONIOENCODING="ascii")
        self.assertEqual((status, messages), (0, ""))
        self.assertIn("cells of 400 ?m", output)
        figure, (panel,) = flat_figure(self.drawing(values))
        (label,) = panel.labels
        self.assertEqual(label.get_text(), "Last $x$ größer: 1 MPa")
        self.assertFalse(label.get_parse_math())
        style.plt.close(figure)

    def test_set_changes_what_is_drawn(self):
        values = plate(0.03, 0.03, 1e-3, [0, 0.015, 0.01, 0.015],
                       {"Top": {"Type": "Traction", "Body": "Plate", "From": [0.03, 0.03], "To": [0, 0.03], "Stress": [0, 1e6]}})
        scene = Scene(self.write("scene.xml", xml(values)), ["Cracks:Notch:Points={0, 0.015, 0.02, 0.015}", "Boundaries:Top:Stress={0, -4e6}"])
        drawing = Drawing(scene, state_of(scene, PROGRAM))
        np.testing.assert_allclose(drawing.fronts[0], [0.02, 0.015, 0.0], atol=1e-12)
        self.assertEqual(drawing.symbols[0].label, "4 MPa")
        self.assertTrue(drawing.symbols[0].into)
        self.assertTrue(any("120 kN along (0, -1)" in text for text, _ in list_lines(drawing)))  # 4 MPa on 30 mm by 1 m

    def test_an_equilibrium_is_drawn_too(self):
        """Its Reference asks for a result that only growth in equilibrium has."""
        values = plate(0.03, 0.03, 1e-3, [0, 0.015, 0.01, 0.015],
                       {"Top": {"Type": "Traction", "Body": "Plate", "From": [0.03, 0.03], "To": [0, 0.03], "Stress": [0, 1e6]},
                        "Foot": {"Type": "Velocity", "Lower Corner": [0, 0], "Upper Corner": [0.03, 0], "Value": [0, 0]}},
                       **{"Energy Release": {}, "Propagation": {"Toughness": 10.0, "Increment": 0.1}})
        values["Time"].update({"Analysis": "Quasi-Static", "Load Steps": 4})
        values["Reference"] = {"Load": {"Quantity": "propagation.initiation.load_factor", "Value": 1.0, "Tolerance": 0.1, "Source": "made up"}}
        drawing = self.drawing(values)
        np.testing.assert_allclose(drawing.fronts[0], [0.01, 0.015, 0.0], atol=1e-9)

    def test_cells_that_accuracy_chooses_are_those_of_the_analysis(self):
        """What is drawn has the cells of the scene's own analysis; that of motion may have others."""
        values = plate(0.06, 0.012, 1e-3, [0, 0.006, 0.03, 0.006],
                       {"Up": {"Type": "Traction", "Body": "Plate", "From": [0.005, 0.012], "To": [0, 0.012], "Stress": [0, 1e5]},
                        "Down": {"Type": "Traction", "Body": "Plate", "From": [0, 0], "To": [0.005, 0], "Stress": [0, -1e5]}}, **{"Energy Release": {}})
        values["Time"].update({"Analysis": "Static", "Rigid Modes": "Remove"})
        del values["Domain"]["Cell Size"]
        values["Domain"]["Accuracy"] = "3 %"
        scene = Scene(self.write("chosen.xml", xml(values)))
        subprocess.run([PROGRAM, scene.path, "--output", self.path("out"), "--quiet"], check=True)
        with open(self.path("out", "summary.json"), encoding="utf-8") as file:
            self.assertEqual(state_of(scene, PROGRAM).summary["cells"], json.load(file)["cells"])

    def test_a_check_hands_its_state_over(self):
        """The state that --check --state writes is that before any step, and rhegma-plot draws it without the program."""
        values, *_ = self.random_plate(np.random.default_rng(SEED))
        values["Output"] = {"Fields": True}  # of which the forecast says how large they will be
        print(f"seed {SEED}")
        path = self.write("scene.xml", xml(values))
        checked = subprocess.run([PROGRAM, path, "--check", "--state", self.path("state")], capture_output=True, text=True, check=True)
        self.assertIn("Boundaries > Top: ", checked.stdout)
        self.assertIn("of fields", checked.stdout)
        found = state_in(self.path("state"))
        self.assertEqual(read_times(self.path("state")), [0.0])
        asked = state_of(Scene(path), PROGRAM)
        np.testing.assert_array_equal(found.fields.position, asked.fields.position)
        self.assertEqual((found.forces, found.summary["cells"]), (asked.forces, asked.summary["cells"]))
        self.assertIn("Top", found.forces)
        status, said, messages = run("rhegma-plot", "--scene", path, "--state", self.path("state"), "--rhegma", "/no/program", "-o", self.path("drawn.png"))
        self.assertEqual(status, 0, messages)
        self.assertIn("Wrote ", said)
        self.assertGreater(min(picture_size(self.path("drawn.png"))), 300)
        # A folder with files, such as results of a run, is left as it is.
        again = subprocess.run([PROGRAM, path, "--check", "--quiet", "--state", self.path("state")], capture_output=True, text=True)
        self.assertEqual(again.returncode, 1)
        self.assertIn(f"rhegma: --state: {self.path('state')} is no empty folder; write the name of a new one\n", again.stderr)
        self.assertEqual(sorted(os.listdir(self.path("state"))), ["check.json", "fields.h5", "fields.xdmf"])

    def test_a_wrong_scene_gives_the_message_of_the_program(self):
        values = plate(0.03, 0.03, 1e-3, [0, 0.015, 0.01, 0.015], {"Top": {"Type": "Gravity", "Acceleration": [0, -9.81]}})
        values["Domain"]["Cell Size"] = -1e-3
        scene = self.write("wrong.xml", xml(values))
        self.assert_fails(run("rhegma-plot", "--scene", scene, "--rhegma", PROGRAM), "Domain > Cell Size: is -0.001 m; it must be above 0 m")


class SceneValues(ToolTest):
    def test_labels_leave_the_vertical_axis_and_one_another(self):
        figure, axes = style.plt.subplots(figsize=(6, 4))
        panel = scene_panel.Panel(axes, View([0, 1]), 1.0, 1.0)
        for _ in range(3):
            panel.label("Water: a long label left of an arrow", np.array([0.05, 0.5, 0.0]), style.INK, (-1.0, 0.0))
        scene_panel.part_labels([panel], figure)
        found = [text.get_window_extent() for text in panel.labels]
        self.assertGreater(min(box.x0 for box in found), axes.get_window_extent().x0)
        self.assertFalse(any(one.overlaps(other) for i, one in enumerate(found) for other in found[:i]))
        style.plt.close(figure)

    def test_labels_stay_out_of_the_next_axes(self):
        figure, (axes, after) = style.plt.subplots(1, 2, figsize=(8, 4))
        panel = scene_panel.Panel(axes, View([0, 1]), 1.0, 1.0)
        panel.label("End: 11.79 MPa, a label right of the last arrow", np.array([0.98, 0.5, 0.0]), style.INK, (1.0, 0.0))
        scene_panel.part_labels([panel], figure)
        box = panel.labels[0].get_window_extent()
        self.assertLess(box.x1, after.get_tightbbox().x0)
        self.assertGreater(box.x0, axes.get_window_extent().x0)
        style.plt.close(figure)

    def test_symbols_of_a_grid_leave_out_no_single_line(self):
        """Lines 2 apart, in squares of 2.17: all are drawn. Lines 0.5 apart: every fourth, at even distances. Two sizes of cells: one point in each square."""
        def lines(step, shift, edge):
            x = shift + step * np.arange(33)
            drawn = scene_panel.thinned(np.stack(np.meshgrid(x, x), -1).reshape(-1, 2), edge)
            return np.unique(np.round(drawn[:, 0], 9)), len(drawn)

        for shift in (0.0, -7.3, 1.0 / 3.0):
            found, count = lines(2.0, shift, 2.17)
            self.assertEqual((len(found), count), (33, 33 * 33))
            found, count = lines(0.5, shift, 2.17)
            np.testing.assert_allclose(np.diff(found), 2.0, atol=1e-8)
            self.assertEqual((len(found), count), (9, 81))

    def test_histories(self):
        self.assertEqual(peak({}), (1.0, ""))
        self.assertEqual(peak({"History": "0:0, 1:3, 2:-5"}), (-5.0, " at most"))
        self.assertEqual(peak({"History": "2.5"}), (2.5, ""))
        self.assertEqual(peak({"History": "t < 2 ? 1 : 0"}), (1.0, " × f(t)"))

    def test_files_of_bodies(self):
        """Their paths are those from the folder of the scene; the edges of a cube are drawn, not the diagonals of its sides, scaled and moved."""
        corners = [f"v {x} {y} {z}" for z in (0, 1) for y in (0, 1) for x in (0, 1)]
        faces = ["f 1 3 4 2", "f 5 6 8 7", "f 1 2 6 5", "f 3 7 8 4", "f 1 5 7 3", "f -7 -5 -1 -3"]
        self.write("cube.obj", "\n".join(corners + faces) + "\n")
        body = {"Shape": "File", "File": "cube.obj", "Scale": 2.0, "Origin": [1.0, 0.0, 0.0]}
        scene = Scene(self.write("scene.xml", xml({"Time": {"Final Time": 1.0}, "Bodies": {"A": body}})))
        self.assertEqual(scene.values["Bodies"]["A"]["File"], self.path("cube.obj"))
        outline = outlines_of(scene.values, 3)[0]
        self.assertEqual(len(outline.lines), 12)
        np.testing.assert_allclose([np.min(outline.lines, axis=(0, 1)), np.max(outline.lines, axis=(0, 1))], [[1, 0, 0], [3, 2, 2]])
        self.write("ring.txt", "0 0\n4 0\n4 4\n# a hole\n\n1, 1\n2, 1\n2, 2\n")
        flat = Scene(self.write("flat.xml", xml({"Bodies": {"A": {"Shape": "File", "File": "ring.txt"}}})))
        self.assertEqual([len(line) for line in outlines_of(flat.values, 2)[0].lines], [4, 4])
        flat.values["Bodies"]["A"]["File"] = self.path("none.txt")
        self.assertEqual(outlines_of(flat.values, 2)[0].lines, [])  # the program says why

    def test_units(self):
        """Numbers with a unit are drawn where the program puts them; a value of --set without one is in SI units."""
        def body(name, kind, value, unit=""):
            more = f' unit="{unit}"' if unit else ""
            return f'<Parameter name="{name}" type="{kind}" value="{value}"{more}/>'

        text = "".join((body("Lower Corner", "Array(double)", "{-1, 2.5}", "mm"), body("Temperature", "double", "20", "degC"), body("Angle", "double", "3e-3"),
                        body("Rotation", "double", "1.5", "rad"), body("Stress", "Array(double)", "{0, 5} MPa"), body("History", "string", "0:0, 2:1"),
                        body("Speed", "double", "-36", "km/hour"), body("Material", "string", "Steel 3")))
        path = self.write("units.xml", f'<ParameterList name="Rhegma"><ParameterList name="Domain">{text}</ParameterList></ParameterList>')
        found = Scene(path).values["Domain"]
        self.assertEqual({name: found[name] for name in ("Lower Corner", "Temperature", "Angle", "Stress", "History", "Speed", "Material")}, {
            "Lower Corner": "{-0.001, 0.0025}", "Temperature": "293.15", "Angle": "3e-3", "Stress": "{0.0, 5000000.0}", "History": "0:0, 2:1",
            "Speed": "-10.0", "Material": "Steel 3"})
        self.assertAlmostEqual(float(found["Rotation"]), np.degrees(1.5), places=9)
        changed = Scene(path, ["Domain:Lower Corner={-0.002, 0}", "Domain:Temperature=30 degC"])
        self.assertEqual((changed.values["Domain"]["Lower Corner"], changed.values["Domain"]["Temperature"]), ("{-0.002, 0}", "303.15"))
        self.assertNotIn('unit="mm"', ElementTree.tostring(changed.root, encoding="unicode"))

    def test_outlines_of_voxels(self):
        """Edges between voxels of a value and others, runs of them as one line; in 3D the bounds."""
        image = np.zeros((5, 4), dtype="uint8")
        image[1:4, 1:3] = 7
        image[2, 1] = 3
        np.save(self.path("image.npy"), image)
        body = {"Shape": "Voxels", "File": "image.npy", "Value": 7, "Voxel Size": 2.0, "Corner": [10.0, 20.0]}
        lines = np.array(outlines_of(Scene(self.write("scene.xml", xml({"Bodies": {"A": body}}))).values, 2)[0].lines)
        self.assertAlmostEqual(np.linalg.norm(lines[:, 1] - lines[:, 0], axis=1).sum(), 2.0 * 12)
        self.assertEqual(len(lines), 8)
        np.testing.assert_allclose([lines.min(axis=(0, 1)), lines.max(axis=(0, 1))], [[12, 22, 0], [18, 26, 0]])
        turned = {**body, "Rotation": 90.0}  # about the middle of the image (15, 24)
        lines = np.array(outlines_of(Scene(self.write("turned.xml", xml({"Bodies": {"A": turned}}))).values, 2)[0].lines)
        np.testing.assert_allclose([lines.min(axis=(0, 1)), lines.max(axis=(0, 1))], [[13, 21, 0], [17, 27, 0]], atol=1e-12)
        np.save(self.path("deep.npy"), image[:, :, None].repeat(3, axis=2))
        deep = {**body, "File": "deep.npy", "Corner": [10.0, 20.0, 30.0]}
        lines = np.array(outlines_of(Scene(self.write("deep.xml", xml({"Domain": {"Dimension": 3}, "Bodies": {"A": deep}}))).values, 3)[0].lines)
        self.assertEqual(len(lines), 12)
        np.testing.assert_allclose([lines.min(axis=(0, 1)), lines.max(axis=(0, 1))], [[12, 22, 30], [18, 26, 36]])

    def test_refuses_wrong_arguments(self):
        self.assert_fails(run("rhegma-plot"), "either the DIR of a run or --scene")
        self.assert_fails(run("rhegma-plot", self.folder, "--scene", "a.xml"), "either the DIR of a run or --scene")
        self.assert_fails(run("rhegma-plot", "--scene", self.path("none.xml")), "there is no file")
        scene = self.write("scene.xml", xml({"Domain": {"Dimension": 2}}))
        self.assert_fails(run("rhegma-plot", "--scene", scene, "--set", "Cell Size"), "--set", "Section:Parameter=value")
        self.assert_fails(run("rhegma-plot", "--scene", scene, "--rhegma", self.path("rhegma")), "there is no program")
        with self.assertRaises(Problem):
            Scene(self.write("text.xml", "no scene"))
