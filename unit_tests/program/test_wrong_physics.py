#!/usr/bin/env python3
"""Scenes of wrong physics, at random: errors of wrong_physics.py in the scenes of xml_inputs are all said, in the right place, and
right scenes are not warned of, or say in a comment which warning they deserve.

RHEGMA_SEED and RHEGMA_SCENES in the environment choose other ones and how many. With --table it prints them as the table of
docs/explanation/verification/warnings.md."""

import glob
import os
import random
import re
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from file_scene import FileScene  # noqa: E402
from program import NOISE, SOURCE, ProgramTest, rhegma  # noqa: E402
from scenes import plate  # noqa: E402
from wrong_physics import REASONS, TEMPLATES  # noqa: E402

SEED = int(os.environ.get("RHEGMA_SEED", "2"))
COUNT = int(os.environ.get("RHEGMA_SCENES", "68"))
FILES = sorted(glob.glob(os.path.join(SOURCE, "xml_inputs", "examples", "*.xml"))
               + glob.glob(os.path.join(SOURCE, "xml_inputs", "verification", "*.xml")))
# Those in which mistakes are made: the shape of a part from a file is not in the scene, and its path is relative to the scene.
DRAWN = [path for path in FILES if not path.endswith(("bracket_static.xml", "two_phase.xml"))]

# What is no number and should not be printed as one; a name after ">" may be anything.
NON_NUMBER = re.compile(r"(?<!> )(?<![\w.])-?(?:nan|inf)(?![\w.])")


def messages_of(answer):
    return [line[len("rhegma: "):] for line in answer.messages.splitlines()]


def draw(rng, number):
    """A wrong scene, its name and error, and the places that may be named."""
    template = TEMPLATES[number % len(TEMPLATES)]
    for _ in range(2000):  # few scenes fit some templates
        scene = FileScene(rng.choice(DRAWN))
        place = template(scene, rng)
        if place is not None:
            return scene, template, place
    raise AssertionError(f"no scene for {template.__name__}")


def shortened(message, length=150):
    """The beginning of a message, up to a word."""
    return message if len(message) <= length else message[:message.rindex(" ", 0, length)] + " ..."


def print_table():
    """A row for each wrong scene: the scene, the error that was made, and the beginning of what is said of it."""
    rng = random.Random(SEED)
    print("| | scene | error | message |\n|--:|:--|:--|:--|")
    with tempfile.TemporaryDirectory() as folder:
        for number in range(COUNT):
            scene, template, place = draw(rng, number)
            path = os.path.join(folder, "scene.xml")
            with open(path, "w") as text:
                text.write(scene.text())
            answer = rhegma(path, "--check", "--quiet")
            said = next((m for m in messages_of(answer) if re.search(place, m) and re.search(REASONS[template], m)), "nothing")
            said = shortened(said).replace("|", "\\|")
            print(f"| {number + 1} | {os.path.relpath(scene.path, os.path.join(SOURCE, 'xml_inputs'))[:-4]} | {template.__doc__} "
                  f"| {said} |")


class RightScenes(ProgramTest):
    def test_every_warning_of_a_right_scene_is_deserved(self):
        for path in FILES + sorted(glob.glob(os.path.join(SOURCE, "xml_inputs", "studies", "scenes", "*.xml"))):
            with open(path) as text:
                deserved = re.findall(r'Deserved warning: "([^"]+)"', text.read())
            answer = rhegma(path, "--check", "--quiet")
            with self.subTest(path):
                self.assertEqual(answer.status, 0, answer)
                said = messages_of(answer)
                for message in said:
                    self.assertTrue(any("warning: " + start in message for start in deserved), message)
                for start in deserved:
                    self.assertTrue(any("warning: " + start in message for message in said), f"{start} is not said")


class Extremes(ProgramTest):
    def warnings_of(self, scene):
        answer = rhegma(self.write("scene.xml", scene.text()), "--output", self.path("out"))
        return answer, [line for line in messages_of(answer) if line.startswith("warning: ")]

    def test_damping_that_leaves_no_velocity_does_not_overflow(self):
        """The exponential of rate times step is beyond any number."""
        damping = plate().remove("Cracks").remove("Energy Release").set("Damping", {"Mass Rate": 1e12})
        answer, warnings = self.warnings_of(damping.set("Time > Maximum Steps", 20))
        self.assertEqual(answer.status, 0, answer)
        self.assertTrue(any("Damping > Mass Rate is 1e+12 1/s, " in line and "stable time step" in line for line in warnings), answer)

    def test_speed_limit_below_a_cell_in_all_time(self):
        growth = plate().remove("Energy Release").set("Energy Release", {})
        growth.set("Propagation", {"Toughness": "100", "Speed Limit": 1e-9}).set("Time > Maximum Steps", 3)
        answer, warnings = self.warnings_of(growth)
        self.assertEqual(answer.status, 0, answer)
        self.assertTrue(any("Propagation > Speed Limit is 1e-09 m/s" in line and "no crack grows" in line for line in warnings), answer)


    def changed(self, file, **changes):
        """Warnings and errors of an example with changes: parameters by path, None removes."""
        scene = FileScene(os.path.join(SOURCE, "xml_inputs", file + ".xml"))
        for place, value in changes.items():
            if value is None:
                scene.remove(place)
            else:
                scene.set(place, value)
        answer = rhegma(self.write("changed.xml", scene.text()), "--check")
        self.assertIsNone(NON_NUMBER.search(answer.messages + answer.output), answer)
        return messages_of(answer)

    def assert_said(self, messages, pattern):
        self.assertTrue(any(re.search(pattern, m) for m in messages), f"{pattern} in\n" + "\n".join(messages))

    def test_thickness_beyond_sense(self):
        for value in (1e308, 1e300, 1e150, 1e-300):
            with self.subTest(value):
                said = self.changed("examples/dcb", **{"Domain > Thickness": value})
                self.assert_said(said, r"warning: Domain > Thickness is \S+, an implausible number")
        answer = rhegma(os.path.join(SOURCE, "xml_inputs", "examples", "kalthoff.xml"), "--set", "Domain:Thickness=1e300",
                        "--set", "Time:Maximum Steps=3", "--output", self.path("thick"))
        self.assertIsNone(NON_NUMBER.search(answer.messages + answer.output), answer)

    def test_warnings_and_errors_are_both_said(self):
        """A hole in the contour is an error of the contour, and thin."""
        bore = {"Operation": "Cut", "Shape": "Ball", "Centre": [0.01875, 0.04], "Radius": 1e-3}
        said = self.changed("examples/edge_crack", **{"Bodies > Strip > Operations": {"Bore": bore},
                                                      "Damping > Mass Rate": 4.0})
        self.assert_said(said, "^Energy Release > Outer Radius: ")
        self.assert_said(said, "^warning: Bodies > Strip > Operations > Bore: the hole is 2 mm thin")
        self.assert_said(said, "^warning: Damping > Mass Rate is 4 1/s: when damping ends, 99")

    def test_warnings_of_bodies_that_overlap(self):
        twin = {"Material": "Acrylic", "Shape": "Box", "Lower Corner": [0.02, 0.02], "Upper Corner": [0.021, 0.06]}
        said = self.changed("examples/edge_crack", **{"Bodies > Twin": twin})
        self.assert_said(said, "^Bodies > Twin: overlaps")
        self.assert_said(said, "^warning: Bodies > Twin: the body is 1 mm thin")

    def test_what_is_thrown_or_hits_something_is_meant(self):
        """The lower traction alone accelerates the strip: by more than its length, if it is not thrown on purpose."""
        alone = {"Boundaries > Top": None}
        flies = "warning: Boundaries > Bottom: no load balances it, and nothing supports Bodies > Strip along x, y, so it moves by 105"
        self.assert_said(self.changed("examples/edge_crack", **alone), flies)
        wall = {"Type": "Velocity", "Components": "xy", "Value": [0.0, 0.0], "Lower Corner": [-0.01, -0.2],
                "Upper Corner": [0.05, -0.1]}
        target = {"Material": "Acrylic", "Shape": "Box", "Lower Corner": [0.0, -0.1], "Upper Corner": [0.04, -0.05]}
        meant = {
            "thrown": {"Bodies > Strip > Velocity": [0.0, -1.0]},
            "at a wall": {"Domain > Lower Corner": [-0.01, -0.2], "Boundaries > Wall": wall},
            "at a target": {"Domain > Lower Corner": [-0.01, -0.2], "Bodies > Target": target},
            "with room": {"Domain > Lower Corner": [-0.01, -0.2]},
            "held": {"Boundaries > Wall": dict(wall, **{"Lower Corner": [-0.01, 0.078], "Upper Corner": [0.05, 0.09]})},
            "shortly": {"Time > Final Time": 3e-4},
        }
        for name, changes in meant.items():
            with self.subTest(name):
                said = self.changed("examples/edge_crack", **alone, **changes)
                self.assertFalse(any("so it moves by" in m for m in said), said)

    def test_first_steps_that_fail(self):
        """A forecast takes first steps; where they fail, the scene is valid by its words alone."""
        loads = {f"Boundaries > {side} > Stress": [0.0, sign * 5e9] for side, sign in (("Top", 1), ("Bottom", -1))}
        self.assert_said(self.changed("examples/edge_crack", **loads), "^warning: in its first steps the run stopped at t = ")
        self.assertFalse(any("first steps" in m for m in self.changed("examples/edge_crack")))

    def test_a_shock_is_no_gravity_in_millimetres(self):
        weight = {"Type": "Gravity", "Acceleration": [0.0, -9810.0]}
        self.assert_said(self.changed("examples/dcb", **{"Boundaries > Weight": weight}),
                         r"Boundaries > Weight > Acceleration is 9810 m/s2 up to the end, 1000 times")
        for right in (dict(weight, History="0:1, 1e-3:0"), dict(weight, Acceleration=[0.0, -1962.0])):
            said = self.changed("examples/dcb", **{"Boundaries > Weight": right})
            self.assertFalse(any("Weight" in m for m in said), said)

    def test_plastic_zone(self):
        """Below the stress of the loads, with a zone that is large, and with a small one."""
        law = {"Materials > Acrylic > Model": "J2 Plastic"}
        for stress, pattern in ((2e6, "so that it yields as a whole"), (8e6, "more than a fifth of the crack"), (2.5e8, None)):
            with self.subTest(stress):
                said = self.changed("examples/edge_crack", **law, **{"Materials > Acrylic > Yield Stress": stress})
                if pattern:
                    self.assert_said(said, "Materials > Acrylic > Yield Stress is .*" + pattern)
                self.assertEqual(any("Yield Stress" in m for m in said), pattern is not None, said)
        law = {"Materials > Polymer > Model": "J2 Plastic", "Materials > Polymer > Yield Stress": 1e6}
        self.assert_said(self.changed("examples/strip_running", **law),
                         "Propagation > Toughness is .* yield .* at Materials > Polymer > Yield Stress = 1000000 Pa")


# Numbers and functions of time that are none somewhere, and those of which other numbers are none.
NON_NUMBERS = ["nan", "inf", "-inf", "1e309", "1e308", "-1e308", "1e300", "1e200", "-1e150", "1e80", "1e-310", "1e-300", "1e-200",
               "-1e-300", "0", "-0"]
NON_FUNCTIONS = ["1/0", "sqrt(-t)", "1/(t - t)", "log(t)", "1e308*exp(1e9*t)", "1e400", "0:0, 1e-300:1e308", "nan", "inf"]
QUOTED = re.compile('"[^"]*"')  # what the user wrote


class NonNumbers(ProgramTest):
    def draw(self, rng):
        """A scene with one parameter that is beyond sense, and its name and value."""
        scene = FileScene(rng.choice(DRAWN))
        parameters = [e for e in scene.root.iter("Parameter") if e.get("type") in ("double", "Array(double)")
                      or e.get("name") in ("History", "Pressure", "Toughness", "Field", "Temperature Field")]
        element = rng.choice(parameters)
        if element.get("type") == "string":
            element.set("value", rng.choice(NON_FUNCTIONS))
        elif element.get("type") == "double":
            element.set("value", rng.choice(NON_NUMBERS))
        else:
            values = re.findall(r"[-+.\deE]+", element.get("value"))
            values[rng.randrange(len(values))] = rng.choice(NON_NUMBERS)
            element.set("value", "{" + ", ".join(values) + "}")
        return scene, f"{element.get('name')} = {element.get('value')}"

    def test_no_message_prints_nan_or_inf(self):
        rng = random.Random(SEED)
        for number in range(COUNT // 2):
            scene, what = self.draw(rng)
            path = self.write(f"{number:03d}_{os.path.basename(scene.path)}", scene.text())
            with self.subTest(what, scene=scene.path, seed=SEED):
                answer = rhegma(path, "--check", "--quiet")
                self.assertIn(answer.status, (0, 1), answer)
                said = QUOTED.sub("", answer.messages + answer.output)
                self.assertIsNone(NON_NUMBER.search(said), answer)


class WrongPhysics(ProgramTest):
    def test_each_error_has_a_reason(self):
        self.assertEqual({t.__name__ for t in TEMPLATES}, {t.__name__ for t in REASONS})

    def test_wrong_physics_is_said(self):
        print(f"seed {SEED}, {COUNT} scenes", flush=True)
        rng = random.Random(SEED)
        for number in range(COUNT):
            scene, template, place = draw(rng, number)
            name = f"{number:03d}_{template.__name__}_{os.path.basename(scene.path)}"
            path = self.write(name, scene.text())
            answer = rhegma(path, "--check", "--quiet")
            with self.subTest(name, seed=SEED):
                self.assertIn(answer.status, (0, 1), answer)
                for noise in NOISE:
                    self.assertNotIn(noise, answer.messages)
                self.assertIsNone(NON_NUMBER.search(answer.messages), answer)
                fitting = [m for m in messages_of(answer) if re.search(place, m) and re.search(REASONS[template], m)]
                self.assertTrue(fitting, f"no message on {place} that says {REASONS[template]}:\n{answer}")
                if answer.status == 0:  # a warning: an error where the user asks for that
                    self.assertEqual(rhegma(path, "--check", "--quiet", "--strict").status, 1)


if __name__ == "__main__":
    if sys.argv[1:] == ["--table"]:
        print_table()
    else:
        unittest.main()
