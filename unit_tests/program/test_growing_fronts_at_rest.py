#!/usr/bin/env python3
"""A crack that may grow and a crack that can't have the same G at rest, wherever the front lies in its cell: else the crack would start at other loads.

RHEGMA_SEED in the environment draws other positions."""

import json
import os
import random
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import SOURCE, ProgramTest, rhegma  # noqa: E402
from file_scene import FileScene  # noqa: E402

SEED = int(os.environ.get("RHEGMA_SEED", random.randrange(10**6)))
CELL = 1.25e-3
# By how much the front of the cells may lag behind that of the crack [cells]: twice the standard deviation over positions, 0.03, of the cell problem from
# which the springs follow (unit_tests/studies/front_cell.py). With the springs that growing cracks had before it was 0.2 cells, next to nodes.
LAG = 0.06


class GrowingFrontsAtRest(ProgramTest):
    def release(self, name, length, height, grows):
        """G of the edge crack of examples/edge_crack, damped to rest with a toughness that it does not reach, or in equilibrium [J/m2]."""
        scene = FileScene(os.path.join(SOURCE, "xml_inputs", "examples", "edge_crack.xml")).remove("Reference")
        scene.set("Cracks > Notch > Points", [-CELL, height, length, height])
        if grows:
            scene.set("Propagation", {"Toughness": "3000"}).set("Damping > Mass Rate", 1e5).set("Time > Final Time", 6e-3)
        else:
            scene.remove("Damping").set("Time", {"Analysis": "Static", "Final Time": 1.0, "Rigid Modes": "Remove"})
        answer = rhegma(self.write(name + ".xml", scene.text()), "--output", self.path(name), "--quiet")
        self.assertEqual(answer.status, 0, answer)
        with open(self.path(name, "summary.json"), encoding="utf-8") as file:
            summary = json.load(file)
        self.assertTrue(summary["settled"] if grows else "equilibrium" in summary)
        return summary["cracks"][0]["fronts"][0]["G_J"]

    def test_positions_in_a_cell(self):
        draw = random.Random(SEED)
        print(f"seed {SEED}")
        for k, within in enumerate((0.0, draw.uniform(-0.05, 0.05), draw.uniform(0.1, 0.5), draw.uniform(0.5, 0.9))):
            length, height = 0.01 + within * CELL, 0.04 + draw.choice([0.0, draw.uniform(0.0, 0.5)]) * CELL
            with self.subTest(within=within, height=height, seed=SEED):
                grows = self.release(f"grows{k}", length, height, True)
                held = [self.release(f"held{k}{more}", length + more * CELL, height, False) for more in (0, 1)]
                slope = held[1] - held[0]  # of G, per cell
                self.assertGreater(slope, 0.2 * held[0])
                self.assertLess(abs(grows - held[0]), LAG * slope)


if __name__ == "__main__":
    unittest.main(verbosity=2)
