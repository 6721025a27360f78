#!/usr/bin/env python3
"""Runs that go on from a checkpoint."""

import csv
import json
import os
import signal
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

import h5py  # noqa: E402
import numpy  # noqa: E402
from program import PATIENCE, rhegma  # noqa: E402
from restart_case import END, RestartTest, damped, scene  # noqa: E402


class GoesOn(RestartTest):
    def stopped_and_gone_on(self, number, name):
        path = self.write("scene.xml", damped().text())
        whole, broken = self.path("whole"), self.path("broken")
        self.run_to_its_end(path, whole)
        run = self.start(path, "--output", broken, "--quiet")
        self.wait_for(run, os.path.join(broken, "fields.xdmf"))
        run.send_signal(number)
        run.wait(PATIENCE)
        messages = run.stderr.read().decode()
        self.assertEqual(run.returncode, 2, messages)
        checkpoint = os.path.join(broken, "checkpoint.h5")
        self.assert_messages(messages, [("", ["stopped by " + name, "--restart " + checkpoint, "continues from t ="])])
        with h5py.File(checkpoint, "r") as file:
            stopped = float(file["run"].attrs["time"])
        with open(os.path.join(broken, "summary.json")) as file:
            summary = json.load(file)
        # A step without a sample is followed by one more, for the last row of the history; the run that continues has not made it.
        # Steps differ a little, with the speed of waves in strained particles.
        self.assertIn(round((summary["time"] - stopped) / (summary["time"] / summary["steps"]), 2), (0.0, 1.0))
        self.assertLess(stopped, END)
        # Into a folder of its own, then in place.
        self.run_to_its_end(path, self.path("elsewhere"), "--restart", checkpoint)
        self.assert_same_run(self.path("elsewhere"), whole)
        self.run_to_its_end(path, broken, "--restart", checkpoint)
        self.assert_same_run(broken, whole)

    def test_after_terminate(self):
        self.stopped_and_gone_on(signal.SIGTERM, "SIGTERM")

    def test_after_interrupt(self):
        self.stopped_and_gone_on(signal.SIGINT, "SIGINT")

    def test_checkpoints_change_nothing(self):
        often = self.write("often.xml", scene(**{"Checkpoint Interval": 1e-5}).text())
        none = self.write("none.xml", scene(Checkpoints=False).text())
        self.run_to_its_end(often, self.path("often"))
        self.run_to_its_end(none, self.path("none"))
        self.assertTrue(os.path.exists(self.path("often", "checkpoint.h5")))
        self.assertFalse(os.path.exists(self.path("none", "checkpoint.h5")))
        self.assertEqual(self.file(self.path("often"), "history.csv"), self.file(self.path("none"), "history.csv"))

    def test_longer_than_planned(self):
        path = self.write("scene.xml", scene(**{"Checkpoint Interval": 1e-3}).text())
        folder = self.path("out")
        self.run_to_its_end(path, folder, "--set", "Time:Final Time=1e-3")
        self.run_to_its_end(path, folder, "--restart", os.path.join(folder, "checkpoint.h5"))
        self.assertEqual(self.summary(folder)["time"], END)
        times = [float(row["time"]) for row in csv.DictReader(self.file(folder, "history.csv").decode().splitlines())]
        self.assertEqual(times, sorted(set(times)))
        self.assertEqual(times[-1], END)

    def test_at_its_end_nothing_changes(self):
        path = self.write("scene.xml", scene(**{"Checkpoint Interval": 1e-3}).text())
        self.run_to_its_end(path, self.path("out"))
        self.run_to_its_end(path, self.path("again"), "--restart", self.path("out", "checkpoint.h5"))
        self.assert_same_run(self.path("again"), self.path("out"))

    def test_another_step_and_output(self):
        checkpoint = self.checkpoint_of(self.path("out"))
        more = ("--set", "Time:CFL=0.3", "--set", "Output:History Interval=1e-4", "--set", "Output:Fields=false")
        self.run_to_its_end(self.path("scene.xml"), self.path("out"), "--restart", checkpoint, *more)
        self.assertEqual(self.summary(self.path("out"))["time"], END)

    def test_a_history_that_is_gone(self):
        checkpoint = self.checkpoint_of(self.path("out"))
        os.remove(self.path("out", "history.csv"))
        answer = rhegma(self.path("scene.xml"), "--output", self.path("out"), "--quiet", "--restart", checkpoint)
        self.assertEqual(answer.status, 0, answer)
        self.assertIn("there is no history.csv next to the checkpoint", answer.messages)

    def test_fields_that_cannot_be_read(self):
        checkpoint = self.checkpoint_of(self.path("out"))
        self.write(os.path.join("out", "fields.h5"), "half a file")
        answer = rhegma(self.path("scene.xml"), "--output", self.path("out"), "--quiet", "--restart", checkpoint)
        self.assertEqual(answer.status, 0, answer)
        self.assertIn("fields.unread.h5", answer.messages)
        self.assertEqual(self.file(self.path("out"), "fields.unread.h5"), b"half a file")
        self.assertGreater(len(self.fields(self.path("out"))), 0)

    def test_check(self):
        checkpoint = self.checkpoint_of(self.path("out"))
        answer = rhegma(self.path("scene.xml"), "--check", "--restart", checkpoint)
        self.assertEqual((answer.status, answer.messages), (0, ""), answer)
        self.assertIn(checkpoint, answer.output)


class Failure(RestartTest):
    def test_the_last_sound_state_is_kept(self):
        """Two walls that shut at once, after a quiet time."""
        late = damped().remove("Damping")
        late.set("Boundaries > Blow", {
            "Type": "Velocity", "Lower Corner": [-0.2, -0.2], "Upper Corner": [0.5, 1.2], "Components": "x",
            "Value": [1.0, 0.0], "History": "t > 1e-3 ? 1e5 : 0",
        })
        late.set("Output", {"History Interval": 2e-5}).set("Time > Retries", 0)
        path = self.write("late.xml", late.text())
        answer = rhegma(path, "--output", self.path("out"), "--quiet")
        self.assertEqual(answer.status, 2, answer)
        checkpoint = self.path("out", "checkpoint.h5")
        self.assertIn("--restart " + checkpoint + " continues from t =", answer.messages)
        with h5py.File(checkpoint, "r") as file:
            kept = float(file["run"].attrs["time"])
            for name, table in file["particles"].items():
                self.assertTrue(numpy.isfinite(table[()]).all(), name)
        self.assertLessEqual(kept, 1.1e-3)
        # It ends in the same way, with the same history.
        again = rhegma(path, "--output", self.path("again"), "--quiet", "--restart", checkpoint)
        self.assertEqual(again.status, 2, again)
        self.assertEqual(self.file(self.path("again"), "history.csv"), self.file(self.path("out"), "history.csv"))


if __name__ == "__main__":
    unittest.main()
