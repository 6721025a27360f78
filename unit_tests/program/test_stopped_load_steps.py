#!/usr/bin/env python3
"""Runs of equilibrium that a signal stops within a load step.

RHEGMA_SEED in the environment chooses the moments of the signals; each failure names it.
"""

import csv
import json
import math
import os
import random
import re
import signal
import subprocess
import sys
import time
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import PATIENCE, PROGRAM, SOURCE, ProgramTest, environment, rhegma  # noqa: E402
from scenes import Scene  # noqa: E402

SEED = int(os.environ.get("RHEGMA_SEED", random.randrange(10**6)))
VERIFICATION = os.path.join(SOURCE, "xml_inputs", "verification")
PENNY = os.path.join(VERIFICATION, "penny_tension_static.xml")
BEND = os.path.join(VERIFICATION, "bend_growth_static.xml")
STATIC = ("--set", "Domain:Cell Size=0.0006")  # some 10 s, and hundreds of MB
SEVERAL = ("--set", "Time:Analysis=Quasi-Static", "--set", "Time:Load Steps=5", "--set", "Time:Final Time=2e-5")

# A step gives up within an iteration of its linear solution [s]; a busy machine takes several times as long.
SOON = 20.0


class LimitLoad(ProgramTest):
    def test_short_load_steps_are_warned_of(self):
        """A bar in plane strain without hardening, pulled beyond 2 / sqrt(3) times its yield stress: load steps become shorter and shorter up to
        the limit load, and the run stops there. The last step that is tried is 1/4096 of a load step; the bar is held at one end, which
        makes it a little stronger."""
        chance = random.Random(f"{SEED} {self.id()}")
        stress, over = 10.0 ** chance.uniform(7.5, 9.0), chance.uniform(1.2, 2.5)
        limit = 2.0 / math.sqrt(3.0) * stress
        scene = Scene({
            "Domain": {"Dimension": 2, "Plane": "Strain", "Lower Corner": [-0.003, -0.003], "Upper Corner": [0.025, 0.013], "Cell Size": 1e-3},
            "Time": {"Analysis": "Quasi-Static", "Final Time": 1.0, "Load Steps": 10},
            "Materials": {"Metal": {"Model": "J2 Plastic", "Density": 7800.0, "Young Modulus": 700.0 * stress, "Poisson Ratio": 0.3,
                                    "Yield Stress": stress}},
            "Bodies": {"Bar": {"Material": "Metal", "Shape": "Box", "Lower Corner": [0.0, 0.0], "Upper Corner": [0.02, 0.01]}},
            "Boundaries": {"Foot": {"Type": "Velocity", "Value": [0.0, 0.0], "Lower Corner": [-1.0, -1.0], "Upper Corner": [1e-4, 1.0]},
                           "Pull": {"Type": "Traction", "Surface": "Body", "Body": "Bar", "Facing": [1.0, 0.0], "Stress": [over * limit, 0.0],
                                    "History": "t"}},
            "Output": {"Fields": False, "Checkpoints": False},
        })
        answer = rhegma(self.write("scene.xml", scene.text()), "--output", self.path("out"))
        self.assertEqual(answer.status, 2, answer)
        with open(self.path("out", "summary.json"), encoding="utf-8") as file:
            summary = json.load(file)
        self.assertTrue(any("load steps have become as short as 1/" in warning for warning in summary["warnings"]), (SEED, summary["warnings"]))
        self.assertLess(abs(summary["time"] * over - 1.0), 0.02, SEED)


class StoppedLoadSteps(ProgramTest):
    def setUp(self):
        super().setUp()
        self.random = random.Random(f"{SEED} {self.id()}")

    def start(self, *arguments):
        run = subprocess.Popen(
            [PROGRAM, *arguments],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            env=environment(),
        )
        self.addCleanup(run.stderr.close)
        return run

    def wait_for(self, run, path):
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end and run.poll() is None and not os.path.exists(path):
            time.sleep(0.005)

    def rows(self, folder):
        with open(os.path.join(folder, "history.csv"), newline="") as file:
            head, *rows = csv.reader(file)
        times = [float(row[0]) for row in rows]
        self.assertEqual(times, sorted(set(times)), f"seed {SEED}")
        return [dict(zip(head, map(float, row))) for row in rows]

    def summary(self, folder):
        with open(os.path.join(folder, "summary.json")) as file:
            return json.load(file)

    def assert_same(self, folder, whole):
        mine, theirs = self.rows(folder), self.rows(whole)
        self.assertEqual(len(mine), len(theirs), f"seed {SEED}")
        largest = {name: max(abs(row[name]) for row in theirs) for name in theirs[0]}
        for one, other in zip(mine, theirs):
            for name, value in other.items():
                if value == value:  # a number
                    self.assertAlmostEqual(one[name], value, delta=1e-9 * largest[name], msg=f"{name}, seed {SEED}")

    def broken(self, folder, run, begun):
        """What a run that a signal stopped says. \\return the checkpoint from which it continues, or none"""
        messages = run.stderr.read().decode()
        self.assertEqual(run.returncode, 2, messages)
        self.assertLess(time.monotonic() - begun, SOON, f"seed {SEED}")
        last = messages.strip().splitlines()[-1]
        self.assertRegex(last, r"^rhegma: the run was stopped by SIG\w+ (within the load step from|at) t = ", f"seed {SEED}")
        self.assertEqual(self.summary(folder)["end"], "stopped by a signal")
        found = re.search(r"--restart (\S+) continues from t = ", last)
        if found:
            return found[1]
        self.assertIn("no load step is complete, so there is no checkpoint", last)
        self.assertFalse(self.summary(folder)["equilibrium"]["last_step_complete"])
        return None

    def test_a_signal_within_a_long_load_step(self):
        folder = self.path("out")
        number = self.random.choice((signal.SIGTERM, signal.SIGINT, signal.SIGHUP))
        run = self.start(PENNY, *STATIC, "--output", folder, "--quiet")
        self.wait_for(run, os.path.join(folder, "history.csv"))
        time.sleep(self.random.uniform(0.0, 1.0))  # of a step of some seconds
        begun = time.monotonic()
        run.send_signal(number)
        run.wait(PATIENCE)
        self.assertIsNone(self.broken(folder, run, begun))
        self.assertIn("stopped by " + number.name, self.summary(folder)["status"])

    def go_on_to_the_end(self, scene, *settings):
        """Stops a run again and again, until it has ended."""
        whole, folder = self.path("whole"), self.path("out")
        begun = time.monotonic()
        answer = rhegma(scene, *settings, "--output", whole, "--quiet")
        self.assertIn(answer.status, (0, 4), answer)
        length = time.monotonic() - begun
        restart, stops = (), 0
        while True:
            started = time.time_ns()
            run = self.start(scene, *settings, "--output", folder, "--quiet", *restart)
            manifest = os.path.join(folder, "manifest.json")
            while run.poll() is None and not (os.path.exists(manifest) and os.stat(manifest).st_mtime_ns > started):
                time.sleep(0.005)
            time.sleep(self.random.uniform(0.1, 0.8) * length)
            begun = time.monotonic()
            if stops < 4:  # a run that never gets beyond a load step does not end
                run.send_signal(signal.SIGTERM)
            run.wait(PATIENCE)
            if run.returncode != 2:
                break
            stops += 1
            checkpoint = self.broken(folder, run, begun)
            restart = ("--restart", checkpoint) if checkpoint else restart
        self.assertIn(run.returncode, (0, 4), run.stderr.read().decode())
        self.assert_same(folder, whole)

    def test_load_steps_that_go_on(self):
        self.go_on_to_the_end(PENNY, *SEVERAL)

    def test_growth_that_goes_on(self):
        """Steps whose loads have a factor advance cracks before they are solved."""
        self.go_on_to_the_end(BEND)

    def test_a_second_signal_ends_the_program(self):
        folder = self.path("out")
        run = self.start(PENNY, *STATIC, "--output", folder, "--quiet")
        self.wait_for(run, os.path.join(folder, "history.csv"))
        run.send_signal(signal.SIGTERM)
        run.send_signal(signal.SIGTERM)
        run.wait(PATIENCE)
        self.assertIn(run.returncode, (2, -signal.SIGTERM))

    def test_a_check_is_ended_at_once(self):
        run = self.start(PENNY, *STATIC, "--check")
        time.sleep(self.random.uniform(1.0, 3.0))
        run.send_signal(signal.SIGTERM)
        run.wait(PATIENCE)
        self.assertIn(run.returncode, (0, -signal.SIGTERM))


if __name__ == "__main__":
    print("RHEGMA_SEED =", SEED)
    unittest.main()
