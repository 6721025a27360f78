#!/usr/bin/env python3
"""A run that is stopped again and again, and goes on each time on another number of ranks."""

import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from hard_case import HardCase, sized  # noqa: E402
from ranks import LAUNCHER, ROOT  # noqa: E402
from test_cracks import plate  # noqa: E402

os.environ.update(ROOT)


class ChangingRanks(HardCase):
    def test_another_number_of_ranks_at_every_restart(self):
        """The crack closes, slides and opens meanwhile."""
        parts, counts = sized(4, 20), (1, 3, 2, 4)
        time = 2.0 * parts

        def scene():
            turned = plate([0.3, 0.9, 0.7, 1.1], time=time, stress=(0.0, -1e-3), history="sin(2*pi*t/8)")
            return turned.set("Contact", {"Law": "Coulomb", "Friction Coefficient": 0.3})

        whole = self.survives(scene(), energy=0.1, gain=0.02)
        for part in range(parts):
            count = counts[part % len(counts)]
            launcher = (*LAUNCHER, "-np", str(count)) if count > 1 else ()
            # The last part ends where the whole run did.
            end = time * (part + 1) / parts
            options = ["--set", f"Time:Final Time={end!r}", "--set", "Output:Checkpoint Interval=1e3"]
            if part > 0:
                options += ["--restart", self.path("scene.out", "checkpoint.h5")]
            broken = self.survives(scene(), *options, energy=0.1, gain=0.02, launcher=launcher)
            self.assertEqual(broken.summary["ranks"], count)
        scale = whole.energy().max()
        self.assertAlmostEqual(broken.history["time"][-1], whole.history["time"][-1], delta=1e-12 * time)
        # Steps end where a part does, so that the two runs do not take the same ones: what is compared is physics.
        self.assertAlmostEqual(broken.energy()[-1], whole.energy()[-1], delta=0.02 * scale)


if __name__ == "__main__":
    unittest.main()
