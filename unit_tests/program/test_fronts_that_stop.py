#!/usr/bin/env python3
"""Fronts that the cells stop are not arrested: the run ends with status 2 and says what to change, or marks them."""

import csv
import json
import os
import re
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import ProgramTest, rhegma  # noqa: E402
from scenes import Scene, plate  # noqa: E402
from test_running_cracks import pulled_apart  # noqa: E402

CELL = 0.05


def passing(**more):
    """A crack that passes two cells below another, too near for its cells, with G above its toughness."""
    scene = pulled_apart([0.0, 0.52, 0.4, 0.52]).set("Propagation > Direction", "Straight")
    scene.set("Cracks > Other", {"Points": [0.6, 0.52 + 2.0 * CELL, 0.9, 0.52 + 2.0 * CELL], "Fronts": "None"})
    for name, value in more.items():
        scene.set("Propagation > " + name.replace("_", " "), value)
    return scene.set("Output", {"History Interval": 2e-5})


def penny_beside_a_crack(**more):
    """A quarter of a penny crack in a block under tension. A sheet next to the x axis stops the nodes that run towards it,
    three cells before it; the nodes at the y axis run on."""
    millimetres = lambda *values: [1e-3 * value for value in values]  # noqa: E731
    block = {"Material": "Polymer", "Shape": "Box", "Lower Corner": millimetres(0, 0, -5), "Upper Corner": millimetres(12, 12, 5)}
    scene = Scene(
        {
            "Domain": {"Dimension": 3, "Lower Corner": millimetres(-2, -2, -7), "Upper Corner": millimetres(14, 14, 7),
                       "Cell Size": 1e-3},
            "Time": {"Final Time": 2e-5},
            "Materials": {"Polymer": {"Model": "Linear Elastic", "Density": 1200.0, "Young Modulus": 3e9, "Poisson Ratio": 0.3}},
            "Bodies": {"Block": block},
            "Boundaries": {},
            "Cracks": {
                "Penny": {"Centre": millimetres(0, 0, 0.3), "Normal": [0.0, 0.0, 1.0], "Radius": 3e-3},
                "Sheet": {"Points": millimetres(7.2, -1, -1.7, 7.2, 2.5, -1.7, 7.2, 2.5, 2.3, 7.2, -1, 2.3)},
            },
            "Energy Release": {},
            "Propagation": {"Toughness": "8*(1 + v/200)", "Direction": "Straight"},
            "Output": {"History Interval": 1e-6},
        }
    )
    for axis in "xy":
        scene.set("Boundaries > Middle " + axis, {"Type": "Symmetry", "Axis": axis, "Position": 0.0})
    for name, z, stress in (("Top", 5, 5e6), ("Bottom", -5, -5e6)):
        scene.set("Boundaries > " + name, {"Type": "Traction", "Body": "Block", "Corner": millimetres(0, 0, z),
                                          "Edge 1": millimetres(12, 0, 0), "Edge 2": millimetres(0, 12, 0),
                                          "Stress": [0.0, 0.0, stress]})
    for name, value in more.items():
        scene.set("Propagation > " + name.replace("_", " "), value)
    return scene


def glass_with_a_flaw():
    """A plate of glass whose edge crack runs past the front of a longer one, 4.5 mm off its path."""
    def pulled(y, sign):
        ends = [[0.1, y], [0.0, y]] if sign > 0.0 else [[0.0, y], [0.1, y]]
        return {"Type": "Traction", "Body": "Plate", "From": ends[0], "To": ends[1], "Stress": [0.0, sign * 4e6],
                "History": "0:0, 4e-4:1"}

    return Scene({
        "Domain": {"Dimension": 2, "Plane": "Stress", "Thickness": 5e-3, "Lower Corner": [-0.01, -0.01], "Upper Corner": [0.11, 0.07],
                   "Cell Size": 2.5e-3},
        "Time": {"Final Time": 2.4e-4},
        "Materials": {"Glass": {"Model": "Linear Elastic", "Density": 2500.0, "Young Modulus": 7e10, "Poisson Ratio": 0.22}},
        "Bodies": {"Plate": {"Material": "Glass", "Shape": "Box", "Lower Corner": [0.0, 0.0], "Upper Corner": [0.1, 0.06]}},
        "Boundaries": {"Top": pulled(0.06, 1.0), "Bottom": pulled(0.0, -1.0)},
        "Cracks": {"Edge": {"Points": [0.0, 0.03, 0.02, 0.03]}, "Flaw": {"Points": [0.05, 0.0345, 0.08, 0.0345]}},
        "Energy Release": {},
        "Propagation": {"Toughness": "8.04*(1 + v/1500)", "On Stop": "Continue"},
        "Output": {"Fields": False},
    })


class FrontsThatStop(ProgramTest):
    def run_scene(self, scene, *options):
        """\\return the answer, the summary as text and read, and the rows of the history"""
        answer = rhegma(self.write("scene.xml", scene.text()), *options)
        with open(self.path("scene.out", "summary.json")) as file:
            text = file.read()
        with open(self.path("scene.out", "history.csv"), newline="") as file:
            rows = list(csv.DictReader(file))
        return answer, text, json.loads(text), rows

    def test_a_front_that_the_cells_stop_ends_the_run(self):
        answer, text, summary, rows = self.run_scene(passing())
        self.assertEqual(answer.status, 2, answer)
        front = summary["cracks"][0]["fronts"][0]
        self.assertEqual(front["status"], "stopped: less than three cells from crack Other")
        self.assertTrue(front["stopped"])
        self.assertFalse(front["ended"])
        self.assertGreaterEqual(front["stop"]["G"], 0.99 * front["stop"]["toughness"])
        self.assertNotIn("halted", text)
        last = answer.messages.splitlines()[-1]
        for words in ("the run stopped at t = ", "crack Notch, front 0", "less than three cells from crack Other", "not arrest)",
                      "G = ", "Gc = ", "Domain > Cell Size", "On Stop = Continue", "--restart"):
            self.assertIn(words, last)
        self.assertNotIn(": arrested", answer.output)
        # It ends with the sample that has the flag.
        self.assertEqual([float(row["Notch.0.stopped"]) for row in rows], [0.0] * (len(rows) - 1) + [1.0])
        self.assertAlmostEqual(float(rows[-1]["time"]), summary["time"], delta=1e-12)
        self.assertLess(summary["time"], 4e-3)
        # The answer comes first.
        self.assertEqual(list(summary)[:3], ["status", "answers", "warnings"])
        self.assertIn("less than three cells", summary["status"])
        self.assertEqual(summary["answers"][0], summary["status"])
        self.assertIn("numerical stop of crack Notch, front 0", summary["answers"][1])

    def test_the_rest_may_go_on_from_there(self):
        """The checkpoint keeps the status; a run that continues from it comes to its end with the flag on."""
        answer, _, _, before = self.run_scene(passing())
        self.assertEqual(answer.status, 2, answer)
        checkpoint = self.path("scene.out", "checkpoint.h5")
        again, _, summary, _ = self.run_scene(passing(), "--restart", checkpoint)
        self.assertEqual(again.status, 2, again)
        answer, _, summary, rows = self.run_scene(passing(On_Stop="Continue"), "--restart", checkpoint)
        self.assertEqual(answer.status, 0, answer)
        self.assertGreater(len(rows), len(before))
        self.assertAlmostEqual(summary["time"], 4e-3)
        front = summary["cracks"][0]["fronts"][0]
        self.assertEqual(front["status"], "stopped: less than three cells from crack Other")
        self.assertEqual({row["Notch.0.stopped"] for row in rows[len(before):]}, {"1"})

    def test_a_scene_may_allow_it(self):
        answer, _, summary, rows = self.run_scene(passing(On_Stop="Continue"))
        self.assertEqual(answer.status, 0, answer)
        self.assertIn("numerical stop of crack Notch, front 0", answer.output)
        self.assertIn("not arrest): G = ", answer.output)
        self.assertEqual(summary["status"], "finished")
        self.assertIn("numerical stop of crack Notch, front 0", summary["answers"][1])
        self.assertEqual(float(rows[-1]["Notch.0.stopped"]), 1.0)

    def test_a_part_of_a_3d_front_that_the_cells_stop_ends_the_run(self):
        answer, text, summary, rows = self.run_scene(penny_beside_a_crack())
        self.assertEqual(answer.status, 2, answer)
        front = summary["cracks"][0]["fronts"][0]
        stop = front["stop"]
        self.assertGreater(stop["nodes"], 0)
        self.assertLess(stop["nodes"], stop["of_nodes"])
        self.assertEqual(len(stop["node_positions"]), stop["nodes"])
        self.assertGreaterEqual(stop["G"], 0.99 * stop["toughness"])
        part = f"{stop['nodes']} of {stop['of_nodes']} front nodes"
        self.assertEqual(front["status"], f"stopped in part, {part}: less than three cells from crack Sheet")
        self.assertTrue(front["stopped"])
        last = answer.messages.splitlines()[-1]
        for words in ("the run stopped at t = ", f"crack Penny, front 0: {part} stopped less than three cells from crack Sheet",
                      "not arrest): G = ", "Gc = ", "Domain > Cell Size", "On Stop = Continue", "--restart"):
            self.assertIn(words, last)
        self.assertEqual(summary["answers"][0], summary["status"])
        self.assertIn(f"numerical stop of {part} of crack Penny, front 0", summary["answers"][1])
        flags = [float(row["Penny.0.stopped"]) for row in rows]
        self.assertEqual(flags[:-1], [0.0] * (len(rows) - 1))
        self.assertAlmostEqual(flags[-1], stop["nodes"] / stop["of_nodes"])
        self.assertLess(summary["time"], 2e-5)

    def test_the_rest_of_a_3d_front_may_go_on(self):
        """It says how far the front went; the part that is stopped is told in all answers, and it is not arrested."""
        answer, _, summary, rows = self.run_scene(penny_beside_a_crack(On_Stop="Continue"))
        self.assertEqual(answer.status, 0, answer)
        front = summary["cracks"][0]["fronts"][0]
        self.assertRegex(front["status"], r"^stopped in part, \d+ of \d+ front nodes: less than three cells from crack Sheet$")
        self.assertGreater(float(rows[-1]["Penny.0.stopped"]), 0.0)
        self.assertLess(float(rows[-1]["Penny.0.stopped"]), 1.0)
        line = next(line for line in answer.output.splitlines() if line.startswith("crack Penny, front 0"))
        self.assertRegex(line, r"extension .* at most, .* on average, new area .* m2, \d+ of \d+ front nodes stopped")
        self.assertNotIn(" arrested at", line)
        self.assertRegex(summary["answers"][1], r"^numerical stop of \d+ of \d+ front nodes of crack Penny, front 0")
        area = float(rows[-1]["Penny.area"]) - float(rows[0]["Penny.area"])
        self.assertGreater(front["largest_advance"], 1e-3)
        self.assertGreater(front["largest_advance"], front["mean_advance"])
        self.assertGreaterEqual(front["new_area"], area * (1.0 - 1e-9))

    def test_a_crack_that_comes_near_is_not_in_the_contour_of_a_front_at_rest(self):
        """G of the front that it passes rises above its toughness, and what drives it is the G that is reported."""
        answer, _, summary, rows = self.run_scene(glass_with_a_flaw())
        self.assertEqual(answer.status, 0, answer)
        front = summary["cracks"][1]["fronts"][0]
        first = next(float(row["time"]) for row in rows if float(row["Flaw.0.G_J"]) > 8.04)
        self.assertLess(abs(front["initiated"] - first), 1e-5, (front, first))

    def test_arrest_has_both_numbers_and_one_line(self):
        """A load that comes and goes: the front starts and stops, and has one line for it."""
        scene = pulled_apart([0.0, 0.52, 0.4, 0.52], toughness="20")
        for name in ("Top", "Bottom"):
            scene.set("Boundaries > " + name + " > History", "0:0, 1e-3:1, 1.4e-3:0, 2e-3:1, 2.4e-3:0")
        answer, _, summary, rows = self.run_scene(scene)
        self.assertEqual(answer.status, 0, answer)
        front = summary["cracks"][0]["fronts"][0]
        self.assertGreater(front["increments"], 0)
        lines = [line for line in answer.output.splitlines() if line.startswith("crack Notch, front 0")]
        self.assertEqual(len(lines), 1, answer.output)
        self.assertIn("extension ", lines[0])
        if not front["ended"]:
            self.assertEqual(front["status"], "arrested", lines)
            self.assertRegex(lines[0], r"arrested at t = .*, G = \S+ J/m2 below Gc = 20 J/m2")
        self.assertEqual({float(row["Notch.0.stopped"]) for row in rows}, {0.0})

    def test_the_answer_is_last(self):
        answer, _, summary, _ = self.run_scene(pulled_apart([0.0, 0.52, 0.4, 0.52]))
        self.assertEqual(answer.status, 0, answer)
        self.assertEqual(answer.output.splitlines()[-len(summary["answers"]):], summary["answers"])
        self.assertRegex(summary["answers"][0], r"the run finished at t = 4 ms after \d+ steps")
        self.assertRegex(summary["answers"][1], r"extension .* to .* m, mean speed .* m/s, reached the surface of its body at")
        arrival = next(text for text in summary["warnings"] if "reached the surface" in text)
        for number in re.search(r"body at t = \S+ \w+, at (\S+), (\S+) m", arrival).groups():
            self.assertEqual(number, f"{float(number):.4g}")
        self.assertRegex(summary["answers"][2], r"energy balance: .*residual")
        warnings = summary["warnings"]
        self.assertEqual(len(summary["answers"]), 4)
        self.assertRegex(summary["answers"][-1], rf"^{len(warnings)} warnings? \(.*, in full above and in summary.json$")
        self.assertEqual(sorted(answer.messages.splitlines()), sorted("rhegma: warning: " + warning for warning in warnings))

    def test_a_warning_is_printed_once(self):
        """At the start, or where the run finds it; the last line names what it is about."""
        scene = pulled_apart([0.0, 0.52, 0.4, 0.52], toughness="1e7")
        scene.set("Boundaries > Nowhere", {"Type": "Velocity", "Components": "x", "Value": [0.0, 0.0],
                                          "Lower Corner": [-0.2, -0.2], "Upper Corner": [-0.15, -0.15]})
        answer, _, summary, _ = self.run_scene(scene)
        self.assertEqual(answer.status, 0, answer)
        printed = answer.messages.splitlines()
        self.assertEqual(sorted(printed), sorted("rhegma: warning: " + warning for warning in summary["warnings"]))
        self.assertRegex(printed[0], "Boundaries > Nowhere")  # of the scene, at the start
        self.assertRegex(printed[-1], "crack Notch, front 0: not initiated")  # of the run, at its end
        last = answer.output.splitlines()[-1]
        self.assertRegex(last, rf"^{len(printed)} warnings \(.*Boundaries > Nowhere.*, in full above and in summary.json$")
        quiet, _, _, _ = self.run_scene(scene, "--quiet")
        self.assertEqual(sorted(quiet.messages.splitlines()), sorted(printed))
        self.assertEqual(quiet.output, "")

    def test_a_start_time_that_the_run_does_not_reach_is_said(self):
        scene = pulled_apart([0.0, 0.52, 0.4, 0.52])
        scene.set("Propagation > Start Time", 5e-3)
        answer, _, summary, _ = self.run_scene(scene)
        self.assertEqual(answer.status, 0, answer)
        self.assertEqual(summary["cracks"][0]["fronts"][0]["increments"], 0)
        self.assertRegex(answer.messages, r"crack Notch, front 0: no crack may advance before 5 ms "
                                          r"\(Propagation > Start Time\), and the run ended at 4 ms")

    def test_held_cracks_have_g_and_k_with_the_time(self):
        answer, _, summary, rows = self.run_scene(plate())
        self.assertEqual(answer.status, 0, answer)
        line = next(line for line in summary["answers"] if line.startswith("crack Notch, front 0"))
        self.assertIn(line, answer.output.splitlines())
        self.assertRegex(line, r"^crack Notch, front 0: G = \S+ J/m2, K_I = \S+ [kM]?Pa m\^0.5, K_II = \S+ [kM]?Pa m\^0.5 at t = 1 ms(; the largest G of all samples was .* at t = \S+ us)?(; the crack is closed .*)?$")
        self.assertAlmostEqual(float(line.split("G = ")[1].split()[0]), float(rows[-1]["Notch.0.G_J"]),
                               delta=1e-3 * abs(float(rows[-1]["Notch.0.G_J"])))

    def test_heat_has_its_peak_with_position_and_time(self):
        """A source that heats the plate for the first tenth of the run; then its heat spreads, and the peak falls."""
        scene = plate().remove("Cracks").remove("Energy Release").remove("Boundaries")
        for name, value in (("Conductivity", 1000.0), ("Specific Heat", 1000.0)):
            scene.set("Materials > Polymer > " + name, value)
        scene.set("Thermal", {"Mechanics": False, "Initial Temperature": 300.0, "Sources": {"Spot": {
            "Type": "Ball", "Centre": [0.7, 0.3], "Radius": 0.06, "Power": 1e9, "History": "0:1, 0.99:1, 1:0, 10:0"}}})
        scene.set("Time > Final Time", 10.0).set("Output", {"History Interval": 0.1})
        answer, _, summary, rows = self.run_scene(scene)
        self.assertEqual(answer.status, 0, answer)
        highest = summary["temperature"]["highest"]
        self.assertAlmostEqual(highest["value"], max(float(row["temperature_highest"]) for row in rows), delta=1e-6 * highest["value"])
        self.assertLess(highest["time"], 2.0)
        self.assertGreater(highest["value"], summary["temperature"]["peak"])
        line = next(line for line in summary["answers"] if line.startswith("peak temperature"))
        self.assertIn(line, answer.output.splitlines())
        self.assertRegex(line, r"^peak temperature \S+ K \(rise \S+ K\) at 0\.\d+, 0\.\d+ m, t = .* s; \S+ K at the end$")

    def test_a_quench_has_its_coldest_point_and_the_difference_within_a_body(self):
        """A plate that is cooled at its right side, and a colder body that stands alone: no body gets warmer than it was."""
        scene = plate().remove("Cracks").remove("Energy Release").remove("Boundaries")
        for name, value in (("Conductivity", 1000.0), ("Specific Heat", 1000.0)):
            scene.set("Materials > Polymer > " + name, value)
        scene.set("Domain > Lower Corner", [-0.8, -0.2]).set("Bodies > Block", {
            "Material": "Polymer", "Shape": "Box", "Lower Corner": [-0.6, 0.0], "Upper Corner": [-0.3, 1.0], "Temperature": 350.0})
        scene.set("Thermal", {"Mechanics": False, "Initial Temperature": 400.0})
        scene.set("Boundaries", {"Water": {"Type": "Convection", "Body": "Plate", "From": [1.0, 0.0], "To": [1.0, 1.0], "Coefficient": 2e4,
                                           "Ambient Temperature": 300.0}})
        scene.set("Time > Final Time", 20.0).set("Output", {"History Interval": 0.5})
        answer, _, summary, rows = self.run_scene(scene)
        self.assertEqual(answer.status, 0, answer)
        found = summary["temperature"]
        lowest = min(float(row["temperature_lowest"]) for row in rows)
        self.assertAlmostEqual(found["coldest"]["value"], lowest, delta=1e-6 * lowest)
        self.assertAlmostEqual(found["largest_fall"], 400.0 - float(rows[-1]["temperature_lowest"]), delta=1e-6 * lowest)
        self.assertAlmostEqual(found["peak_rise"], 0.0, delta=1e-6 * lowest)
        self.assertGreater(found["coldest"]["where"][0], 0.95)  # in the last row of cells
        # The block differs by 50 K from the plate, and not at all in itself.
        self.assertEqual(found["largest_difference"]["body"], "Plate")
        plate_alone = max(float(row["temperature_highest"]) - float(row["temperature_lowest"]) for row in rows)
        self.assertAlmostEqual(found["largest_difference"]["value"], plate_alone, delta=1e-6 * lowest)
        said = "\n".join(summary["answers"])
        self.assertNotIn("peak temperature", said)
        self.assertRegex(said, r"lowest temperature \S+ K \(fall \S+ K\) at \S+, \S+ m, t = \S+ s")
        self.assertRegex(said, r"largest difference of temperature within a body \S+ K \(Plate\) at t = \S+ s")


class BodiesOutside(ProgramTest):
    def test_a_body_that_does_not_fit_is_told_where_and_what_helps(self):
        scene = plate().set("Domain > Upper Corner", [0.9, 1.2])
        answer = rhegma(self.write("scene.xml", scene.text()), "--check")
        self.assertEqual(answer.status, 1, answer)
        for words in ("Bodies > Plate: lies from 0 to 1 m along x", "domain's", "0.9 m", "Domain > Lower Corner, Upper Corner",
                      "Operation = Cut", "Side (Type = Symmetry)"):
            self.assertIn(words, answer.messages)
        cut = {"Operation": "Cut", "Shape": "Box", "Lower Corner": [0.85, -0.1], "Upper Corner": [1.1, 1.1]}
        scene.set("Bodies > Plate > Operations", {"Rest": cut}).remove("Boundaries").remove("Cracks").remove("Energy Release")
        answer = rhegma(self.write("scene.xml", scene.text()), "--check")
        self.assertEqual(answer.status, 0, answer)
        cut["Lower Corner"] = [0.85, 0.5]
        answer = rhegma(self.write("scene.xml", scene.set("Bodies > Plate > Operations", {"Rest": cut}).text()), "--check")
        self.assertEqual(answer.status, 1, answer)
        self.assertRegex(answer.messages, r"Bodies > Plate: part of the body lies outside the domain, such as at \(0\.9")

    def test_a_body_that_leaves_says_where(self):
        scene = plate().remove("Boundaries").remove("Cracks").remove("Energy Release")
        scene.set("Bodies > Plate > Velocity", [300.0, 0.0]).set("Time > Final Time", 0.1).set("Time > Retries", 0)
        answer = rhegma(self.write("scene.xml", scene.text()), "--quiet")
        self.assertEqual(answer.status, 2, answer)
        for words in ("the body Plate left the domain, to (", "the domain reaches from (", "Domain > Lower Corner, Upper Corner",
                      "Side (Type = Symmetry)", "Final Time"):
            self.assertIn(words, answer.messages)


if __name__ == "__main__":
    unittest.main()
