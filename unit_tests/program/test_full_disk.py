#!/usr/bin/env python3
"""Checkpoints and histories that can't be written."""

import os
import resource
import shutil
import signal
import subprocess
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

import h5py  # noqa: E402
from program import SOURCE, rhegma  # noqa: E402
from restart_case import END, RestartTest  # noqa: E402
from scenes import plate  # noqa: E402

sys.path.insert(0, os.path.join(SOURCE, "tools"))
from rhegma_tools.whole_folder import check_folder  # noqa: E402


OFTEN = {"History Interval": 1e-6, "Fields": False}  # a row a step


def files_up_to(size):
    def limit():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))

    return limit


class FullDisk(RestartTest):
    """Exit status 2 where a checkpoint can't be written, and the older one is as it was."""

    def goes_on_with_a_full_disk(self, folder, checkpoint, preexec=None):
        before = self.file(folder, "checkpoint.h5")
        arguments = (self.path("scene.xml"), "--output", folder, "--quiet", "--restart", checkpoint)
        answer = rhegma(*arguments, "--set", "Output:Fields=false", preexec=preexec)
        self.assertEqual(answer.status, 2, answer)
        self.assert_messages(answer.messages, [("", ["can't be written", "at t =", "step"])])
        self.assertEqual(self.file(folder, "checkpoint.h5"), before)
        self.assertEqual([name for name in os.listdir(folder) if name.endswith(".part")], [])
        faults = check_folder(folder).faults
        self.assertEqual(len(faults), 1, faults)  # what there is, is undamaged
        self.assertIn(f"{folder}: not all could be written: the run stopped at t = ", faults[0])

    def test_file_that_may_not_grow(self):
        checkpoint = self.checkpoint_of(self.path("out"))
        self.assertGreater(os.path.getsize(checkpoint), 120_000)
        self.goes_on_with_a_full_disk(self.path("out"), checkpoint, preexec=files_up_to(120_000))
        self.run_to_its_end(self.path("scene.xml"), self.path("out"), "--restart", checkpoint)

    def test_full_disk(self):
        disk = self.path("disk")
        os.mkdir(disk)
        mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=4m", "rhegma-test", disk], capture_output=True)
        if mounted.returncode != 0:
            self.skipTest("only root can mount a small disk here: " + mounted.stderr.decode().strip())
        self.addCleanup(subprocess.run, ["umount", disk], check=True)
        folder = os.path.join(disk, "out")
        checkpoint = self.checkpoint_of(folder)
        with open(os.path.join(disk, "filler"), "wb") as file:
            free = os.statvfs(disk)
            file.write(b"\0" * (free.f_bavail * free.f_frsize - 100_000))
        self.goes_on_with_a_full_disk(folder, checkpoint)
        os.remove(os.path.join(disk, "filler"))
        shutil.rmtree(self.path("whole"), ignore_errors=True)
        answer = rhegma(self.path("scene.xml"), "--output", self.path("whole"), "--quiet", "--restart", checkpoint)
        self.assertEqual(answer.status, 0, answer)


class LostRows(RestartTest):
    """A history that can't be written: the run continues from its last state whose history is in the file."""

    def scene(self):
        """Sixteen cells, so that the history is soon larger than a checkpoint, with a row a step."""
        coarse = plate().remove("Cracks").remove("Energy Release").set("Domain > Cell Size", 0.25)
        coarse.set("Domain > Lower Corner", [-0.5, -0.5]).set("Domain > Upper Corner", [1.5, 1.5])
        coarse.set("Boundaries > Wall", {"Type": "Symmetry", "Axis": "x", "Position": 0.0})
        coarse.set("Time > Final Time", 4.0).set("Output", OFTEN)
        return self.write("scene.xml", coarse.text())

    def stopped(self, scene, limit, *more):
        arguments = (scene, "--output", self.path("out"), "--quiet", *more)
        answer = rhegma(*arguments, preexec=files_up_to(limit))
        self.assertEqual(answer.status, 2, answer)
        *warnings, message = answer.messages.splitlines()
        self.assertTrue(all(line.startswith("rhegma: warning: ") for line in warnings), answer)  # what the scene is like
        self.assert_messages(message, [("", ["at t =", "step", "history.csv can't be written: File too large"])])
        faults = check_folder(self.path("out")).faults
        self.assertIn(f"{self.path('out')}: not all could be written: {message[8:]}.", faults)
        self.assertEqual([fault for fault in faults if "checksum" in fault or "bytes" in fault], [])
        return message

    def test_the_run_continues_from_the_rows_that_are_there(self):
        scene, checkpoint = self.scene(), self.path("out", "checkpoint.h5")
        limit, message = 300_000, ""
        while not os.path.exists(checkpoint):  # a fast run has no copy after the start
            limit *= 3
            self.assertLess(limit, 10_000_000, message)
            message = self.stopped(scene, limit)
        self.assertIn(f"--restart {checkpoint} continues from t = ", message)
        self.assertNotIn("could be written", message)
        with h5py.File(checkpoint, "r") as file:
            self.assertGreater(float(file["run"].attrs["time"]), 0.0)
        self.run_to_its_end(scene, self.path("out"), "--restart", checkpoint)
        self.run_to_its_end(scene, self.path("whole"))
        self.assertGreater(len(self.file(self.path("whole"), "history.csv")), limit)
        self.assertEqual(self.file(self.path("out"), "history.csv"), self.file(self.path("whole"), "history.csv"))
        self.assertEqual(check_folder(self.path("out")).faults, [])

    def test_nothing_is_continued_from_the_start(self):
        message = self.stopped(self.scene(), 10_000)
        self.assertNotIn("continues from", message)
        self.assertNotIn("checkpoint", message)
        self.assertFalse(os.path.exists(self.path("out", "checkpoint.h5")))

    def test_the_message_says_that_there_is_no_checkpoint(self):
        scene = self.write("scene.xml", plate().set("Time > Final Time", END).set("Output", OFTEN).text())
        until = ("--set", "Time:Final Time=1e-3", "--set", "Output:Checkpoint Interval=1e-3")
        self.run_to_its_end(scene, self.path("earlier"), *until)
        checkpoint = self.path("earlier", "checkpoint.h5")
        limit = len(self.file(self.path("earlier"), "history.csv")) + 10_000
        self.assertGreater(os.path.getsize(checkpoint), limit)
        message = self.stopped(scene, limit, "--restart", checkpoint)
        self.assertIn(f"; no checkpoint could be written: {self.path('out', 'checkpoint.h5')}.part can't be written: "
                      "File too large", message)
        self.assertFalse(os.path.exists(self.path("out", "checkpoint.h5")))


if __name__ == "__main__":
    unittest.main()
