#!/usr/bin/env python3
"""What PIC, XPIC and FMPM take from the particles is an entry of the energy balance: python3 test_filtered_energy.py.

A notched plate that is pulled suddenly, with velocity updates drawn at random (RHEGMA_SEED draws the same ones again).
"""

import json
import os
import random
import unittest

from program import ProgramTest, rhegma
from scenes import plate

SEED = int(os.environ.get("RHEGMA_SEED", random.randrange(10**6)))

# The entry is what changes the particles' velocity. Motion that is filtered oscillates otherwise, so that the residual of half a step
# (docs/explanation/energy-balance.md) is not that of the same run without PIC: up to a tenth of the entry with a small fraction of PIC,
# and half of it with all of PIC, which takes most of the motion within a few steps.
SMALL, ALL = 0.1, 0.5


class FilteredEnergy(ProgramTest):
    @classmethod
    def setUpClass(cls):
        print(f"seed {SEED} (RHEGMA_SEED)", flush=True)
        cls.random = random.Random(SEED)

    def energies(self, scene, *arguments):
        path = self.write("scene.xml", scene.text())
        answer = rhegma(path, "--output", self.path("out"), "--quiet", *arguments)
        self.assertEqual(answer.status, 0, answer)
        with open(self.path("out", "summary.json"), encoding="utf-8") as file:
            return json.load(file)["energy"]

    def scene(self):
        scene = plate().remove("Energy Release")
        scene.set("Domain > Shape Functions", self.random.choice(("Linear", "GIMP")))
        scene.set("Time > Update Scheme", self.random.choice(("MUSL", "USAVG")))
        return scene.set("Output", {"Fields": False})

    def test_a_fraction_of_pic(self):
        for _ in range(3):
            scene, fraction = self.scene(), self.random.uniform(0.03, 0.1)
            plain = self.energies(scene)
            self.assertNotIn("filtered", plain)
            energy = self.energies(scene.set("Time > PIC Fraction", fraction))
            self.assertGreater(energy["filtered"], abs(plain["residual"]))
            apart = abs(energy["residual"] - plain["residual"])
            self.assertLess(apart, SMALL * energy["filtered"], (fraction, energy, plain))

    def test_series_take_less_than_pic(self):
        scene = self.scene()
        plain = abs(self.energies(scene)["residual"])
        taken = {}
        for update in ("PIC", "XPIC", "FMPM"):
            scene.set("Mass Matrix", {"Type": "Lumped", "Velocity Update": update})
            energy = self.energies(scene)
            taken[update] = energy["filtered"]
            # FMPM filters the acceleration, too, so that forces work on another motion than that of the particles.
            share = 1.0 if update == "FMPM" else ALL
            self.assertLess(abs(energy["residual"]), share * energy["filtered"] + plain, (update, energy))
        for update in ("XPIC", "FMPM"):
            self.assertTrue(0.0 < taken[update] < taken["PIC"], taken)


if __name__ == "__main__":
    unittest.main()
