#!/usr/bin/env python3
"""Checkpoints that can't be written."""

import os
import resource
import shutil
import signal
import subprocess
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import SOURCE, rhegma  # noqa: E402
from restart_case import RestartTest  # noqa: E402

sys.path.insert(0, os.path.join(SOURCE, "tools"))
from rhegma_tools.whole_folder import check_folder  # noqa: E402


def small_files():
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (120_000, 120_000))


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
        self.assertEqual(check_folder(folder).faults, [])

    def test_file_that_may_not_grow(self):
        checkpoint = self.checkpoint_of(self.path("out"))
        self.assertGreater(os.path.getsize(checkpoint), 120_000)
        self.goes_on_with_a_full_disk(self.path("out"), checkpoint, preexec=small_files)
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


if __name__ == "__main__":
    unittest.main()
