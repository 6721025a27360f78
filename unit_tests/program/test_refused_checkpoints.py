#!/usr/bin/env python3
"""Checkpoints that no run goes on from.

RHEGMA_FLIPS in the environment is how many bits are flipped at random, one at a time (12 where it is not set).
"""

import os
import random
import shutil
import struct
import sys
import unittest
import zlib

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from restart_case import RestartTest, damped  # noqa: E402

FLIPS = int(os.environ.get("RHEGMA_FLIPS", "12"))
BLOCK = 512  # bytes ahead of HDF5's


class Refused(RestartTest):
    """Exit status 1, one message that says what is wrong, and no trace in the file system."""

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
                self.refused("checkpoint.h5", "is truncated")

    def test_empty(self):
        self.change(lambda data: b"")
        with open(self.checkpoint, "wb"):
            pass
        self.refused("checkpoint.h5", "is not a checkpoint")

    def test_pipe_and_device(self):
        """To open a pipe waits for a program that writes into it."""
        os.remove(self.checkpoint)
        os.mkfifo(self.checkpoint)
        self.refused("checkpoint.h5", "is a pipe", "write the path of a checkpoint.h5")
        os.remove(self.checkpoint)
        self.checkpoint = "/dev/zero"
        self.refused("/dev/zero", "is a device")

    def test_bit_flipped_anywhere(self):
        """In the block, in HDF5's own structures and in the numbers."""
        whole = self.file(self.path("out"), "checkpoint.h5")
        random.seed(5)
        offsets = [3, 16, 20, 24, 100, BLOCK - 1, BLOCK, BLOCK + 30, len(whole) - 1]
        offsets += [random.randrange(len(whole)) for _ in range(FLIPS)]
        for offset in offsets:
            with self.subTest(offset=offset):
                changed = bytearray(whole)
                changed[offset] ^= 1 << random.randrange(8)
                self.change(lambda data: changed)
                self.refused("checkpoint.h5", "is not a checkpoint" if offset < 16 else "is damaged")

    def test_longer_than_written(self):
        self.change(lambda data: data + b"\0")
        self.refused("checkpoint.h5", "is damaged")

    def test_other_schema(self):
        with open(self.checkpoint, "rb") as file:
            (schema,) = struct.unpack("<I", file.read(20)[16:])

        def newer(data):
            data[16:20] = struct.pack("<I", schema + 1)
            data[BLOCK - 4 : BLOCK] = struct.pack("<I", zlib.crc32(bytes(data[: BLOCK - 4])))

        self.change(newer)
        self.refused("checkpoint.h5", f"is of schema {schema + 1}", f"reads schema {schema}")

    def test_another_file(self):
        shutil.copy(self.path("out", "fields.h5"), self.checkpoint)
        self.refused("checkpoint.h5", "is not a checkpoint", "--restart")

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
        self.assertIn("checkpoint.h5", answer.messages)

    def test_another_history_next_to_it(self):
        with open(self.path("out", "history.csv"), "r+b") as file:
            file.seek(200)
            file.write(b"9")
        self.refused("history.csv is not the history", "remove this one")


if __name__ == "__main__":
    unittest.main()
