#!/usr/bin/env python3
"""Runs that are killed, and go on.

In the environment:
RHEGMA_KILLS  runs that are killed (12)
RHEGMA_SEED   seed of the moments of the kills (the number of kills)
as in RHEGMA_KILLS=100 python3 test_killed_runs.py.
"""

import os
import random
import shutil
import signal
import sys
import time
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import PATIENCE, SOURCE, rhegma  # noqa: E402
from restart_case import RestartTest, scene  # noqa: E402

sys.path.insert(0, os.path.join(SOURCE, "tools"))
from rhegma_tools.whole_folder import check_folder  # noqa: E402

KILLS = int(os.environ.get("RHEGMA_KILLS", "12"))


class Killed(RestartTest):
    def test_kill_at_any_moment(self):
        """Each time it goes on from the checkpoint that is there, and the end is that of the unbroken run."""
        path = self.write("scene.xml", scene(**{"Checkpoint Interval": 1e-5}).text())
        whole, folder = self.path("whole"), self.path("out")
        begin = time.monotonic()
        self.run_to_its_end(path, whole)
        duration = time.monotonic() - begin
        checkpoint = os.path.join(folder, "checkpoint.h5")
        random.seed(int(os.environ.get("RHEGMA_SEED", KILLS)))
        resumed, kills = 0, 0
        while kills < KILLS:
            restart = ("--restart", checkpoint) if os.path.exists(checkpoint) else ()
            run = self.start(path, "--output", folder, "--quiet", *restart)
            # So that some kills hit its start and some its end.
            time.sleep(random.uniform(0.0, 0.5) * duration)
            run.kill()
            run.wait(PATIENCE)
            if run.returncode == 0:  # it was through: from the start again
                shutil.rmtree(folder)
                continue
            self.assertEqual(run.returncode, -signal.SIGKILL, run.stderr.read().decode())
            kills += 1
            resumed += 1 if restart else 0
            if os.path.exists(os.path.join(folder, "manifest.json")):
                self.assertEqual(check_folder(folder).faults, [])
            if os.path.exists(checkpoint):
                copy = self.path("copy")
                answer = rhegma(path, "--output", copy, "--check", "--restart", checkpoint)
                self.assertEqual(answer.status, 0, answer)
        self.assertGreaterEqual(resumed, KILLS // 2)
        restart = ("--restart", checkpoint) if os.path.exists(checkpoint) else ()
        answer = rhegma(path, "--output", folder, "--quiet", *restart)
        self.assertEqual(answer.status, 0, answer)
        self.assertEqual(self.file(folder, "history.csv"), self.file(whole, "history.csv"))
        self.assertEqual(check_folder(folder).faults, [])
        self.assertEqual(self.summary(folder)["steps"], self.summary(whole)["steps"])


if __name__ == "__main__":
    unittest.main()
