#!/usr/bin/env python3
"""Runs on several ranks that go on from a checkpoint, on as many ranks or on others."""

import os
import shutil
import signal
import subprocess
import sys
import time
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

import h5py  # noqa: E402
import numpy  # noqa: E402
from program import PATIENCE, PROGRAM, SOURCE, environment, rhegma  # noqa: E402
from ranks import LAUNCHER, ROOT, OnRanks, kind_of  # noqa: E402
from scenes import plate, too_long_a_step  # noqa: E402
from test_ranks_of_effects import block, burning, turned_plate  # noqa: E402

# What is asked for: sums in another order differ by round-off, which some hundred steps make no more of.
SAME = 1e-9

# Steps after which the first part ends.
BROKEN_AT = 40

OTHER_RANKS = ((1, 3), (4, 2), (3, 1))


class GoesOnOnRanks(OnRanks):
    def broken_and_whole(self, scene, *arguments, pairs=OTHER_RANKS, within=SAME):
        path = self.write(scene.set("Output", {"History Interval": 1e-4}))
        whole = self.run_on(1, path, *arguments)
        times = whole[1]["time"]
        self.assertGreater(whole[0]["steps"], BROKEN_AT + 5)
        for first, second in pairs:
            with self.subTest(first=first, second=second):
                name = f"from{first}to{second}"
                stop = ("--set", f"Time:Maximum Steps={BROKEN_AT}", "--set", "Output:Checkpoint Interval=1.0")
                self.run_on(first, path, *stop, *arguments, into=name)
                checkpoint = os.path.join(self.folder, name, "checkpoint.h5")
                summary, history, fields = self.run_on(second, path, *arguments, "--restart", checkpoint, into=name)
                self.assertEqual(summary["ranks"], second)
                # The end of the first part is a row of its own.
                apart = numpy.abs(history["time"][:, None] - times[None, :]).min(axis=1)
                known = apart < 1e-9 * times[-1]
                self.assertEqual(numpy.count_nonzero(known), len(times))
                self.assertLessEqual(len(known) - len(times), 1)
                history = {column: values[known] for column, values in history.items()}
                self.compare(whole, (summary, history, fields), within=within)

    def test_a_notch_its_springs_and_its_damping(self):
        scene = plate().set("Damping", {"Mass Rate": 100.0})
        self.broken_and_whole(scene)

    def test_cracks_that_cross_ranks_as_they_move(self):
        """With divisions that are not those of the start any more."""
        scene = turned_plate().set("Load Balance", {"Threshold": 1.05, "Interval": 20})
        self.broken_and_whole(scene, pairs=((3, 4), (2, 2)))

    def test_contact(self):
        scene = plate().remove("Energy Release").set("Contact", {"Law": "Coulomb", "Friction Coefficient": 0.3})
        scene.set("Cracks > Notch > Points", [0.5, -0.1, 0.5, 0.7]).set("Boundaries > Pull > Stress", [-1e6, 3e5])
        self.broken_and_whole(scene, "--set", "Time:Final Time=1e-3", pairs=((4, 2),), within=1e-8)

    def test_a_burning_crack(self):
        self.broken_and_whole(burning(turned_plate(), **{"Ignition Point": [0.1, 0.43]}), pairs=((1, 3), (4, 2)))

    def test_full_mass(self):
        scene = plate().remove("Energy Release").set("Mass Matrix", {"Type": "Full", "Solver Tolerance": 1e-12})
        self.broken_and_whole(scene, pairs=((1, 3), (3, 1)))

    def test_three_dimensions(self):
        self.broken_and_whole(block(), pairs=((4, 2),))

    def test_the_same_ranks_write_the_same(self):
        """A checkpoint changes nothing in a run, and holds what all ranks have once."""
        path = self.write(plate().set("Output", {"History Interval": 1e-4}))
        histories = []
        for interval in ("1e-4", "1.0"):
            name = "every" + interval
            self.run_on(2, path, "--set", "Output:Checkpoint Interval=" + interval, into=name)
            with open(os.path.join(self.folder, name, "history.csv"), "rb") as file:
                histories.append(file.read())
        self.assertEqual(*histories)
        self.run_on(1, path, "--set", "Output:Checkpoint Interval=1.0")
        files = [h5py.File(os.path.join(self.folder, name, "checkpoint.h5"), "r") for name in (name, "on1")]
        for file in files:
            self.addCleanup(file.close)
        ours, theirs = (file["particles"] for file in files)
        self.assertEqual(sorted(ours), sorted(theirs))
        for field in theirs:
            scale = numpy.max(numpy.abs(theirs[field][()])) or 1.0
            self.assertLess(numpy.max(numpy.abs(ours[field][()] - theirs[field][()])) / scale, SAME, field)
        ours, theirs = (dict(file["energy"].attrs) for file in files)
        for entry, value in theirs.items():
            self.assertLess(abs(ours[entry] - value), SAME * abs(theirs["strain"]), entry)


class Stopped(OnRanks):
    def children(self, of):
        found = []
        for pid in filter(str.isdigit, os.listdir("/proc")):
            try:
                with open(f"/proc/{pid}/stat", encoding="utf-8") as file:
                    if int(file.read().rpartition(")")[2].split()[1]) == of:
                        found.append(int(pid))
            except OSError:
                pass
        return found

    @staticmethod
    def catches(pid, number):
        """On a busy machine the first rank writes before the others have come to what they do at a signal."""
        with open(f"/proc/{pid}/status", encoding="utf-8") as file:
            caught = next(line.split()[1] for line in file if line.startswith("SigCgt"))
        return int(caught, 16) >> (number - 1) & 1 == 1

    def signalled(self, path, ranks, seconds, *settings):
        """Its messages, after a signal to the last rank some seconds after it catches signals."""
        out = os.path.join(self.folder, "out")
        command = (*LAUNCHER, "-np", str(ranks), PROGRAM, path, *settings, "--output", out, "--quiet")
        run = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, env=environment(ROOT))
        self.addCleanup(run.stderr.close)
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end and not os.path.exists(os.path.join(out, "history.csv")):
            time.sleep(0.05)
        rank = sorted(self.children(run.pid))[-1]
        while time.monotonic() < end and not self.catches(rank, signal.SIGTERM):
            time.sleep(0.05)
        time.sleep(seconds)
        os.kill(rank, signal.SIGTERM)
        messages = run.communicate(timeout=PATIENCE)[1].decode()
        self.assertEqual(run.returncode, 2, messages)
        self.assertEqual(messages.count("rhegma: the run was stopped by SIGTERM"), 1, messages)
        return messages

    def test_a_signal_to_one_rank_within_a_load_step(self):
        scene = os.path.join(SOURCE, "xml_inputs", "verification", "penny_tension_static.xml")
        messages = self.signalled(scene, 2, 1.0, "--set", "Domain:Cell Size=0.0006")
        self.assertIn("within the load step from t = 0 s; no load step is complete, so there is no checkpoint", messages)

    def test_a_signal_to_one_rank(self):
        path = self.write(plate().set("Output", {"History Interval": 1e-4}).set("Time > Final Time", 2e-2))
        messages = self.signalled(path, 3, 0.0)
        checkpoint = os.path.join(self.folder, "out", "checkpoint.h5")
        self.assertIn("--restart " + checkpoint + " continues from t =", messages)
        with h5py.File(checkpoint, "r") as file:
            stopped = float(file["run"].attrs["time"])
        more = ("--set", f"Time:Final Time={stopped + 1e-4!r}")
        summary, history, _ = self.run_on(2, path, "--restart", checkpoint, *more, into="out")
        self.assertGreater(summary["time"], stopped)
        self.assertEqual(list(history["time"]), sorted(set(history["time"])))

    def test_failure(self):
        """The last sound state is on the disk when a run on ranks fails."""
        late = plate().set("Output", {"History Interval": 2e-5}).set("Time > Retries", 0)
        late.set("Boundaries > Blow", {
            "Type": "Velocity", "Lower Corner": [-0.2, -0.2], "Upper Corner": [0.5, 1.2], "Components": "x",
            "Value": [1.0, 0.0], "History": "t > 5e-4 ? 1e5 : 0",
        })
        out = os.path.join(self.folder, "out")
        answer = rhegma(self.write(late), "--output", out, "--quiet", launcher=(*LAUNCHER, "-np", "2"), **ROOT)
        self.assertEqual(answer.status, 2, answer)
        self.assertIn("--restart " + os.path.join(out, "checkpoint.h5") + " continues from t =", answer.messages)
        with h5py.File(os.path.join(out, "checkpoint.h5"), "r") as file:
            self.assertLess(float(file["run"].attrs["time"]), 6e-4)
            for name, table in file["particles"].items():
                self.assertTrue(numpy.isfinite(table[()]).all(), name)

    def test_failure_that_smaller_steps_cure(self):
        """The copy in memory is the first rank's; all go back to it. The body flies free of loads and supports."""
        summary, history, _ = self.run_on(3, self.write(too_long_a_step()))
        self.assertEqual(summary["status"], "finished")
        self.assertTrue(any("the run returned to t =" in warning for warning in summary["warnings"]), summary["warnings"])
        self.assertTrue((history["time"][1:] > history["time"][:-1]).all())
        momentum, mass = history["momentum_x"], summary["bodies"][0]["mass"]
        # The largest that the energy could be times a unit in the last place and step.
        most = (2.0 * mass * numpy.max(history["kinetic"])) ** 0.5
        self.assertLess(numpy.max(numpy.abs(momentum - 5.0 * mass)), 2.3e-16 * summary["steps"] * most)

    def test_a_damaged_one_is_refused_once(self):
        path = self.write(plate())
        self.run_on(2, path, "--set", "Time:Maximum Steps=5", "--set", "Output:Checkpoint Interval=1.0")
        checkpoint = os.path.join(self.folder, "on2", "checkpoint.h5")
        with open(checkpoint, "r+b") as file:
            file.seek(2000)
            file.write(b"no")
        before = sorted(os.listdir(self.folder))
        answer = rhegma(path, "--restart", checkpoint, launcher=(*LAUNCHER, "-np", "3"), **ROOT)
        self.assertEqual(answer.status, 1, answer)
        ours = [line for line in answer.messages.splitlines() if line.startswith("rhegma:")]
        self.assertEqual(len(ours), 1, answer)
        self.assertIn("is damaged", ours[0])
        self.assertEqual(sorted(os.listdir(self.folder)), before)
        self.assertTrue(shutil.which("mpirun"))


if __name__ == "__main__":
    unittest.main()
