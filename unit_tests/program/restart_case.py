"""Runs that stop and go on, and the comparison with the unbroken run."""

import json
import os
import signal
import subprocess
import time

import h5py
import numpy
from program import PATIENCE, PROGRAM, ProgramTest, environment, rhegma
from scenes import plate

END = 4e-3  # [s], about 400 steps of the plate


def scene(**output):
    content = {"History Interval": 2e-5, "Field Interval": 3e-4, **output}
    return plate().set("Time > Final Time", END).set("Output", content)


def damped():
    return scene(**{"Checkpoint Interval": 1e-4}).set("Damping", {"Mass Rate": 100.0})


class RestartTest(ProgramTest):
    def run_to_its_end(self, path, folder, *more):
        answer = rhegma(path, "--output", folder, "--quiet", *more)
        self.assertEqual((answer.status, answer.messages), (0, ""), answer)

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

    def wait_for(self, run, path, seconds=PATIENCE):
        end = time.monotonic() + seconds
        while time.monotonic() < end and run.poll() is None:
            if os.path.exists(path):
                return
            time.sleep(0.005)

    def checkpoint_of(self, folder):
        """A run of the scene that a signal stopped early; its checkpoint."""
        path = self.write("scene.xml", damped().text())
        run = self.start(path, "--output", folder, "--quiet")
        self.wait_for(run, os.path.join(folder, "checkpoint.h5"))
        run.send_signal(signal.SIGTERM)
        run.wait(PATIENCE)
        self.assertEqual(run.returncode, 2)
        return os.path.join(folder, "checkpoint.h5")
