"""Tests that draw their scenes at random and read what runs of them recorded."""

import csv
import json
import os
import random

from program import ProgramTest, rhegma

SEED = int(os.environ.get("RHEGMA_SEED", random.randrange(10**6)))


class DrawnScenes(ProgramTest):
    """Each test has random numbers of its own, by the seed RHEGMA_SEED, which is printed."""

    def setUp(self):
        super().setUp()
        self.rng = random.Random(f"{SEED} {self.id()}")
        print(f"seed {SEED} (RHEGMA_SEED)", flush=True)

    def run_scene(self, scene, *arguments, name="scene"):
        """Summary, and columns of the history."""
        answer = rhegma(self.write(name + ".xml", scene.text()), "--quiet", "--output", self.path(name), *arguments)
        self.assertEqual(answer.status, 0, answer)
        with open(self.path(name, "summary.json"), encoding="utf-8") as file:
            summary = json.load(file)
        with open(self.path(name, "history.csv"), encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        return summary, {column: [float(row[column]) for row in rows] for column in rows[0]}
