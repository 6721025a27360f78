#!/usr/bin/env python3
"""Runs that go on from a checkpoint, and checkpoints that no run goes on from.

RHEGMA_KILLS in the environment is how many runs are killed (12 where it is not set).
"""

import csv
import json
import os
import random
import resource
import shutil
import signal
import struct
import subprocess
import sys
import time
import unittest
import zlib

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

import h5py  # noqa: E402
import numpy  # noqa: E402
from program import PROGRAM, ProgramTest, environment, fingerprint, rhegma  # noqa: E402
from scenes import plate  # noqa: E402

KILLS = int(os.environ.get("RHEGMA_KILLS", "12"))
END = 4e-3  # [s], about 400 steps of the plate
BLOCK = 512  # bytes ahead of HDF5's


def scene(**output):
    content = {"History Interval": 2e-5, "Field Interval": 3e-4, **output}
    return plate().set("Time > Final Time", END).set("Output", content)


def damped():
    return scene(**{"Checkpoint Interval": 1e-4}).set("Damping", {"Mass Rate": 100.0})


class RestartTest(ProgramTest):
    def run_to_its_end(self, path, folder, *more):
        answer = rhegma(path, "--output", folder, "--quiet", *more)
        self.assertEqual((answer.status, answer.complaint), (0, ""), answer)

    def file(self, folder, name):
        with open(os.path.join(folder, name), "rb") as file:
            return file.read()

    def summary(self, folder):
        """What does not depend on the clock or the machine."""
        summary = json.loads(self.file(folder, "summary.json"))
        clock = ("wall_seconds", "ns_per_particle_step", "stages", "checkpoints")
        for name in (*clock, "peak_memory_bytes", "peak_memory_bytes_of_ranks", "bytes_per_particle"):
            self.assertIn(name, summary)
            del summary[name]
        return summary

    def fields(self, folder):
        """Every table by its path, with the times."""
        found = {}
        with h5py.File(os.path.join(folder, "fields.h5"), "r") as file:

            def keep(path, item):
                for name, value in item.attrs.items():
                    found[path + "@" + name] = value
                if isinstance(item, h5py.Dataset):
                    found[path] = item[()]

            file.visititems(keep)
        return found

    def assert_same_run(self, folder, other):
        """History and guide byte for byte, fields and summary value for value."""
        self.assertEqual(self.file(folder, "history.csv"), self.file(other, "history.csv"))
        self.assertEqual(self.file(folder, "fields.xdmf"), self.file(other, "fields.xdmf"))
        self.assertEqual(self.summary(folder), self.summary(other))
        mine, theirs = self.fields(folder), self.fields(other)
        self.assertEqual(sorted(mine), sorted(theirs))
        for path, table in mine.items():
            numpy.testing.assert_array_equal(table, theirs[path], err_msg=path)

    def start(self, *arguments):
        run = subprocess.Popen(
            [PROGRAM, *arguments], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, env=environment()
        )
        self.addCleanup(run.stderr.close)
        return run

    def wait_for(self, run, path, seconds=60):
        end = time.monotonic() + seconds
        while time.monotonic() < end and run.poll() is None:
            if os.path.exists(path):
                return
            time.sleep(0.005)

    def checkpoint_of(self, folder, *steps):
        """A run of the scene that a signal stopped early; its checkpoint."""
        path = self.write("scene.xml", damped().text())
        run = self.start(path, "--output", folder, "--quiet")
        self.wait_for(run, os.path.join(folder, "checkpoint.h5"))
        run.send_signal(signal.SIGTERM)
        run.wait(60)
        self.assertEqual(run.returncode, 2)
        return os.path.join(folder, "checkpoint.h5")


class GoesOn(RestartTest):
    def stopped_and_gone_on(self, number, name):
        path = self.write("scene.xml", damped().text())
        whole, broken = self.path("whole"), self.path("broken")
        self.run_to_its_end(path, whole)
        run = self.start(path, "--output", broken, "--quiet")
        self.wait_for(run, os.path.join(broken, "fields.xdmf"))
        run.send_signal(number)
        run.wait(60)
        complaint = run.stderr.read().decode()
        self.assertEqual(run.returncode, 2, complaint)
        checkpoint = os.path.join(broken, "checkpoint.h5")
        self.assert_sentences(complaint, [("", ["stopped by " + name, "--restart " + checkpoint, "goes on from time"])])
        with h5py.File(checkpoint, "r") as file:
            stopped = float(file["run"].attrs["time"])
        with open(os.path.join(broken, "summary.json")) as file:
            self.assertEqual(stopped, json.load(file)["time"])
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
        self.assertIn("there is no history.csv beside the checkpoint", answer.complaint)

    def test_fields_that_cannot_be_read(self):
        checkpoint = self.checkpoint_of(self.path("out"))
        self.write(os.path.join("out", "fields.h5"), "half a file")
        answer = rhegma(self.path("scene.xml"), "--output", self.path("out"), "--quiet", "--restart", checkpoint)
        self.assertEqual(answer.status, 0, answer)
        self.assertIn("fields.unread.h5", answer.complaint)
        self.assertEqual(self.file(self.path("out"), "fields.unread.h5"), b"half a file")
        self.assertGreater(len(self.fields(self.path("out"))), 0)

    def test_check(self):
        checkpoint = self.checkpoint_of(self.path("out"))
        answer = rhegma(self.path("scene.xml"), "--check", "--restart", checkpoint)
        self.assertEqual((answer.status, answer.complaint), (0, ""), answer)
        self.assertIn(checkpoint, answer.output)


class Refused(RestartTest):
    """Exit status 1, one sentence that says what is wrong, and no trace in the file system."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.maker = cls("make")
        cls.maker.setUp()
        cls.addClassCleanup(cls.maker.doCleanups)
        cls.good = cls.maker.checkpoint_of(cls.maker.path("out"))

    def make(self):
        pass

    def setUp(self):
        super().setUp()
        if self._testMethodName != "make":
            os.makedirs(self.path("out"))
            for name in os.listdir(os.path.dirname(self.good)):
                shutil.copy2(os.path.join(os.path.dirname(self.good), name), self.path("out", name))
            self.write("scene.xml", damped().text())
        self.checkpoint = self.path("out", "checkpoint.h5")

    def change(self, function):
        data = bytearray(self.file(self.path("out"), "checkpoint.h5"))
        data = function(data) or data
        with open(self.checkpoint, "wb") as file:
            file.write(data)

    def refused(self, *words, scene_file="scene.xml", more=()):
        arguments = (self.path(scene_file), "--output", self.path("out"), "--restart", self.checkpoint, *more)
        return self.assert_refused(arguments, [("", words)])

    def test_cut_short_anywhere(self):
        size = os.path.getsize(self.checkpoint)
        whole = self.file(self.path("out"), "checkpoint.h5")
        for length in (BLOCK - 1, BLOCK, BLOCK + 1, size // 2, size - 1):
            with self.subTest(length=length):
                self.change(lambda data: whole[:length])
                self.refused("checkpoint.h5", "is cut short")

    def test_empty(self):
        self.change(lambda data: b"")
        with open(self.checkpoint, "wb"):
            pass
        self.refused("checkpoint.h5", "is not one")

    def test_bit_flipped_anywhere(self):
        """In the block, in HDF5's own structures and in the numbers."""
        whole = self.file(self.path("out"), "checkpoint.h5")
        random.seed(5)
        places = [3, 16, 20, 24, 100, BLOCK - 1, BLOCK, BLOCK + 30, len(whole) - 1]
        places += [random.randrange(len(whole)) for _ in range(12)]
        for place in places:
            with self.subTest(place=place):
                changed = bytearray(whole)
                changed[place] ^= 1 << random.randrange(8)
                self.change(lambda data: changed)
                self.refused("checkpoint.h5", "is not one" if place < 16 else "is damaged")

    def test_longer_than_written(self):
        self.change(lambda data: data + b"\0")
        self.refused("checkpoint.h5", "is damaged")

    def test_other_schema(self):
        def older(data):
            data[16:20] = struct.pack("<I", 7)
            data[BLOCK - 4 : BLOCK] = struct.pack("<I", zlib.crc32(bytes(data[: BLOCK - 4])))

        self.change(older)
        self.refused("checkpoint.h5", "is of schema 7", "reads schema 1")

    def test_another_file(self):
        shutil.copy(self.path("out", "fields.h5"), self.checkpoint)
        self.refused("checkpoint.h5", "is not one", "--restart")

    def test_folder(self):
        self.checkpoint = self.path("out")
        self.refused("is a folder")

    def test_missing(self):
        os.remove(self.checkpoint)
        self.refused("checkpoint.h5", "No such file")

    def test_another_scene(self):
        self.refused("Materials > Polymer > Density", '"1200"', '"1250"',
                     more=("--set", "Materials:Polymer:Density=1250"))

    def test_scene_with_another_section(self):
        self.write("other.xml", damped().set("Contact", {}).text())
        self.refused("Contact is in the scene and not in the checkpoint", scene_file="other.xml")

    def test_scene_without_a_section(self):
        self.write("other.xml", damped().remove("Damping").text())
        self.refused("Damping is in the checkpoint and not in the scene", scene_file="other.xml")

    def test_wrong_scene(self):
        self.refused_scene = self.write("other.xml", damped().set("Time > CFL", 2.0).text())
        self.assert_refused(
            (self.refused_scene, "--output", self.path("out"), "--restart", self.checkpoint),
            [("Time > CFL", ["at most 1"])],
        )

    def test_end_that_is_past(self):
        answer = self.assert_refused(
            (self.path("scene.xml"), "--restart", self.checkpoint, "--set", "Time:Final Time=1e-5"),
            [("Time > Final Time", ["is of time", "later"])],
        )
        self.assertIn("checkpoint.h5", answer.complaint)

    def test_another_history_beside_it(self):
        with open(self.path("out", "history.csv"), "r+b") as file:
            file.seek(200)
            file.write(b"9")
        self.refused("history.csv is not the history", "take this one away")


def small_files():
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (120_000, 120_000))


class NoRoom(RestartTest):
    """Exit status 2 where a checkpoint can't be written, and the older one is as it was."""

    def goes_on_without_room(self, folder, checkpoint, preexec=None):
        before = self.file(folder, "checkpoint.h5")
        arguments = (self.path("scene.xml"), "--output", folder, "--quiet", "--restart", checkpoint)
        answer = rhegma(*arguments, "--set", "Output:Fields=false", preexec=preexec)
        self.assertEqual(answer.status, 2, answer)
        self.assert_sentences(answer.complaint, [("", ["can't be written", "at time", "step"])])
        self.assertEqual(self.file(folder, "checkpoint.h5"), before)
        self.assertEqual([name for name in os.listdir(folder) if name.endswith(".part")], [])

    def test_file_that_may_not_grow(self):
        checkpoint = self.checkpoint_of(self.path("out"))
        self.assertGreater(os.path.getsize(checkpoint), 120_000)
        self.goes_on_without_room(self.path("out"), checkpoint, preexec=small_files)
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
        self.goes_on_without_room(folder, checkpoint)
        os.remove(os.path.join(disk, "filler"))
        shutil.rmtree(self.path("whole"), ignore_errors=True)
        answer = rhegma(self.path("scene.xml"), "--output", self.path("whole"), "--quiet", "--restart", checkpoint)
        self.assertEqual(answer.status, 0, answer)


class Trouble(RestartTest):
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
        self.assertIn("--restart " + checkpoint + " goes on from time", answer.complaint)
        with h5py.File(checkpoint, "r") as file:
            kept = float(file["run"].attrs["time"])
            for name, table in file["particles"].items():
                self.assertTrue(numpy.isfinite(table[()]).all(), name)
        self.assertLessEqual(kept, 1.1e-3)
        # It ends in the same way, with the same history.
        again = rhegma(path, "--output", self.path("again"), "--quiet", "--restart", checkpoint)
        self.assertEqual(again.status, 2, again)
        self.assertEqual(self.file(self.path("again"), "history.csv"), self.file(self.path("out"), "history.csv"))


class Killed(RestartTest):
    def test_kill_at_any_moment(self):
        """Each time it goes on from the checkpoint that is there, and the end is that of the unbroken run."""
        path = self.write("scene.xml", scene(**{"Checkpoint Interval": 1e-5}).text())
        whole, folder = self.path("whole"), self.path("out")
        begin = time.monotonic()
        self.run_to_its_end(path, whole)
        duration = time.monotonic() - begin
        checkpoint = os.path.join(folder, "checkpoint.h5")
        random.seed(KILLS)
        resumed, kills = 0, 0
        while kills < KILLS:
            restart = ("--restart", checkpoint) if os.path.exists(checkpoint) else ()
            run = self.start(path, "--output", folder, "--quiet", *restart)
            # So that some kills hit its start and some its end.
            time.sleep(random.uniform(0.0, 0.5) * duration)
            run.kill()
            run.wait(60)
            if run.returncode == 0:  # it was through: from the start again
                shutil.rmtree(folder)
                continue
            self.assertEqual(run.returncode, -signal.SIGKILL, run.stderr.read().decode())
            kills += 1
            resumed += 1 if restart else 0
            if os.path.exists(checkpoint):
                copy = self.path("copy")
                answer = rhegma(path, "--output", copy, "--check", "--restart", checkpoint)
                self.assertEqual((answer.status, answer.complaint), (0, ""), answer)
        self.assertGreater(resumed, KILLS // 2)
        restart = ("--restart", checkpoint) if os.path.exists(checkpoint) else ()
        answer = rhegma(path, "--output", folder, "--quiet", *restart)
        self.assertEqual(answer.status, 0, answer)
        self.assertEqual(self.file(folder, "history.csv"), self.file(whole, "history.csv"))
        self.assertEqual(self.summary(folder)["steps"], self.summary(whole)["steps"])


if __name__ == "__main__":
    unittest.main()
