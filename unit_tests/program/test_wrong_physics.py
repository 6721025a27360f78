#!/usr/bin/env python3
"""Scenes of wrong physics, at random: errors of wrong_physics.py in the scenes of xml_inputs are all said, in the right place, and
right scenes are not warned of, or say in a comment which warning they deserve.

RHEGMA_SEED and RHEGMA_SCENES in the environment choose other ones and how many."""

import glob
import os
import random
import re
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from file_scene import FileScene  # noqa: E402
from program import NOISE, SOURCE, ProgramTest, rhegma  # noqa: E402
from scenes import plate  # noqa: E402
from wrong_physics import TEMPLATES  # noqa: E402

SEED = int(os.environ.get("RHEGMA_SEED", "2"))
COUNT = int(os.environ.get("RHEGMA_SCENES", "60"))
FILES = sorted(glob.glob(os.path.join(SOURCE, "xml_inputs", "examples", "*.xml"))
               + glob.glob(os.path.join(SOURCE, "xml_inputs", "verification", "*.xml")))


def messages_of(answer):
    return [line[len("rhegma: "):] for line in answer.messages.splitlines()]


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
        self.assertTrue(any("Damping > Mass Rate is 1e+12 1/s, " in line and "stable step" in line for line in warnings), answer)

    def test_speed_limit_below_a_cell_in_all_time(self):
        growth = plate().remove("Energy Release").set("Energy Release", {})
        growth.set("Propagation", {"Toughness": "100", "Speed Limit": 1e-9}).set("Time > Maximum Steps", 3)
        answer, warnings = self.warnings_of(growth)
        self.assertEqual(answer.status, 0, answer)
        self.assertTrue(any("Propagation > Speed Limit is 1e-09 m/s" in line and "no crack grows" in line for line in warnings), answer)


class WrongPhysics(ProgramTest):
    def make(self, rng, number):
        """A wrong scene: its file, what was done, and the places that may be named."""
        template = TEMPLATES[number % len(TEMPLATES)]
        for _ in range(200):
            scene = FileScene(rng.choice(FILES))
            place = template(scene, rng)
            if place is not None:
                name = f"{number:03d}_{template.__name__}_{os.path.basename(scene.path)}"
                return self.write(name, scene.text()), name, place
        raise AssertionError(f"no scene for {template.__name__}")

    def test_wrong_physics_is_said(self):
        print(f"seed {SEED}, {COUNT} scenes", flush=True)
        rng = random.Random(SEED)
        for number in range(COUNT):
            path, name, place = self.make(rng, number)
            answer = rhegma(path, "--check", "--quiet")
            with self.subTest(name, seed=SEED):
                self.assertIn(answer.status, (0, 1), answer)
                for noise in NOISE:
                    self.assertNotIn(noise, answer.messages)
                fitting = [m for m in messages_of(answer) if re.search(place, m)]
                self.assertTrue(fitting, f"no message on {place}:\n{answer}")
                if answer.status == 0:  # a warning: an error where the user asks for that
                    self.assertEqual(rhegma(path, "--check", "--quiet", "--strict").status, 1)


if __name__ == "__main__":
    unittest.main()
