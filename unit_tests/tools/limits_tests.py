"""Tests of the limits for vanishing cell size that rhegma-study prints."""

import csv
import json
import os
import random
import unittest

from tool import HERE, ToolTest, run

from rhegma_tools.answers import answers_of
from rhegma_tools.limits import measure_mesh, meshes_in
from rhegma_tools.richardson import find_limit
from rhegma_tools.study_file import Run
from rhegma_tools.study_runs import Outcome

PROGRAM = os.path.join(HERE, "made_up_rhegma.py")


class Richardson(unittest.TestCase):
    def setUp(self):
        self.seed = random.randrange(10**6)
        self.pick = random.Random(self.seed)

    def sizes(self, count):
        """Falling, with ratios of 1.3 to 3."""
        found = [self.pick.uniform(1e-6, 1e3)]
        while len(found) < count:
            found.append(found[-1] / self.pick.uniform(1.3, 3.0))
        return found

    def test_finds_order_and_limit_of_a_power(self):
        for _ in range(200):
            order, exact, sizes = self.pick.uniform(0.6, 2.9), self.pick.uniform(-9.0, 9.0), self.sizes(self.pick.choice((3, 4, 5)))
            # The two finest values may not differ by more than a quarter.
            factor = 0.1 * abs(exact) * self.pick.choice((-1.0, 1.0))
            limit = find_limit(sizes, [exact + factor * (size / sizes[0]) ** order for size in sizes])
            self.assertIsNone(limit.why, f"seed {self.seed}")
            self.assertAlmostEqual(limit.order, order, 6, f"seed {self.seed}")
            self.assertAlmostEqual(limit.value, exact, 7)
            self.assertLessEqual(limit.low, exact + 1e-7)
            self.assertGreaterEqual(limit.high, exact - 1e-7)

    def test_encloses_the_limit_of_errors_of_both_orders(self):
        """a + b h + c h^2, b and c of one sign: the limits of orders 1 and 2 lie on both sides of a."""
        for _ in range(200):
            exact, sizes, sign = self.pick.uniform(0.5, 2.0), self.sizes(3), self.pick.choice((-1.0, 1.0))
            b, c = sign * self.pick.uniform(0.0, 0.05), sign * self.pick.uniform(0.001, 0.05)
            values = [exact + b * size / sizes[0] + c * (size / sizes[0]) ** 2 for size in sizes]
            limit = find_limit(sizes, values)
            self.assertIsNone(limit.why, f"seed {self.seed}")
            self.assertTrue(0.999 < limit.order < 2.001, f"seed {self.seed}: {limit.order}")
            self.assertTrue(limit.low - 1e-9 <= exact <= limit.high + 1e-9, f"seed {self.seed}: {limit.low} {exact} {limit.high}")

    def test_an_earlier_limit_widens_the_band(self):
        """1 + h^2, whose last value is 0.001 low: the limit of the cells before is the exact one."""
        sizes, values = [0.4, 0.2, 0.1, 0.05], [1.16, 1.04, 1.01, 1.0015]
        self.assertLess(find_limit(sizes[1:], values[1:]).high, 0.999)
        self.assertAlmostEqual(find_limit(sizes, values).high, 1.0)

    def test_says_why_there_is_no_order(self):
        for sizes, values, words in (
            ([1.0], [1.0], "at least three"),
            ([1.0, 0.5], [1.0, 1.1], "three cell sizes, and there are 2"),
            ([1.0, 0.5, 0.25], [1.0, 1.1, 1.05], "do not move in one direction"),
            ([1.0, 0.5, 0.25], [1.0, 1.1, 1.1], "do not move in one direction"),
            ([1.0, 0.5, 0.25], [1.0, 1.1, 1.2], "by as much from size to size"),
            ([1.0, 0.5, 0.25], [1.0, 1.1, 1.19], "the observed order, 0.15, is not between 0.5 and 3"),
            ([1.0, 0.5, 0.25], [2.0, 1.1, 1.09], "the observed order, 6.5, is not between 0.5 and 3"),
            ([1.0, 0.5, 0.25], [3.0, 2.0, 1.4], "moves by 30 % between the two finest cells: not resolved"),
            ([1.0, 0.5, 0.25], [1.0, 1.0 + 1e-9, 1.0], "agree"),
        ):
            limit = find_limit(sizes, values)
            self.assertIsNone(limit.order, words)
            self.assertIn(words, limit.why)
        limit = find_limit([1.0, 0.5, 0.25], [1.0, 1.1, 1.05])  # as --twice: limits of orders 2 and 1 of the last two
        self.assertAlmostEqual(limit.low, 1.0)
        self.assertAlmostEqual(limit.high, 1.05 - 0.05 / 3.0)
        self.assertIsNone(limit.value)


class Answers(unittest.TestCase):
    def test_takes_what_does_not_grow_and_is_not_zero(self):
        rest = {"G_J": 3.0, "G_closure": None, "K_I": 100.0, "K_II": -1.0, "K_III": 0.0}
        summary = {"cracks": [{"name": "A", "fronts": [rest, dict(rest, initiated=1e-5), dict(rest, stopped=True)]}, {"name": "B"}],
                   "propagation": {"initiation": {"load_factor": 3.4}},
                   "references": [{"name": "One", "value": 3.0, "reference": 3.1}, {"name": "Nothing", "value": 1e-3, "reference": 0.0},
                                  {"name": "Two", "value": 0.5, "reference": 0.6}],
                   "energy": {"strain": 7.0}}
        found = answers_of(summary, ["energy.strain", "energy.none"], [8.0, 9.0])
        self.assertEqual({name: (a.unit, a.value, a.reference) for name, a in found.items()}, {
            "G_J of A.0": ("J/m2", 3.0, 3.1), "K_I of A.0": ("Pa sqrt(m)", 100.0, None), "load factor at initiation": ("", 3.4, None),
            "Reference > Two": ("", 0.5, 0.6), "energy.strain": ("", 7.0, 8.0)})


class Limits(ToolTest):
    def outcome(self, family, values, cells=None, **settings):
        """A run in a folder of its own with a G and cells."""
        size = settings["cell"]
        settings = dict({k: str(v) for k, v in settings.items() if k != "cell"}, **{"Domain:Cell Size": str(size)})
        folder = self.path(f"{family}_{len(os.listdir(self.path('.')))}")
        os.mkdir(folder)
        with open(os.path.join(folder, "summary.json"), "w") as file:
            json.dump({"cells": cells or {"largest": size, "smallest": size}, "cracks": [
                {"name": "A", "fronts": [{"G_J": values(size)}]}]}, file)
        found = Outcome(Run(family, "", settings, [], []), folder, 0)
        found.good = True
        return found

    def test_each_combination_of_other_settings_is_a_mesh(self):
        runs = [self.outcome("a", abs, cell=size, cfl=cfl) for cfl in (0.2, 0.4) for size in (1.0, 4.0, 2.0)]
        runs += [self.outcome("b", abs, cell=size, corner=-size) for size in (4.0, 2.0)]
        runs += [self.outcome("c", abs, cell=1.0)]
        self.assertEqual([[float(o.run.settings["Domain:Cell Size"]) for o in group] for group in meshes_in(runs)],
                         [[4.0, 2.0, 1.0], [4.0, 2.0, 1.0], [4.0, 2.0]])

    def test_refinement_must_stay(self):
        def runs(smallest):
            return [self.outcome("a", lambda h: 1.0 + 0.1 * h, {"largest": h, "smallest": smallest(h)}, cell=h) for h in (1.0, 0.5, 0.25)]

        mesh = measure_mesh(runs(lambda h: h / 4))
        self.assertAlmostEqual(mesh.rows[0].limit.order, 1.0, 6)
        self.assertIn("refinement of the cells changes", measure_mesh(runs(lambda h: 0.25)).why)

    def start(self, *more):
        self.write("scene.xml", '<ParameterList name="Rhegma"/>\n')
        return run("rhegma-study", self.path("scene.xml"), "--rhegma", PROGRAM, *more)

    def test_a_scene_at_several_cell_sizes(self):
        """The made-up program gives G = 0.5 (1 + cell / 10 mm)."""
        status, output, messages = self.start("--cell-sizes", "1.25e-3", "5e-3", "2.5e-3")
        self.assertEqual((status, messages), (0, ""))
        line = next(line for line in output.splitlines() if line.startswith("G_J of Notch.0 [J/m2]"))
        self.assertEqual(line.split()[4:], "0.75 0.625 0.5625 1.00 0.5 between 0.5 and 0.54167".split())
        with open(self.path("scene.cells", "limits.csv"), newline="") as file:
            row = next(csv.DictReader(file))
        for name, value in (("finest", 0.5625), ("order", 1.0), ("extrapolated", 0.5), ("from", 0.5), ("to", 0.5625 - 0.0625 / 3)):
            self.assertAlmostEqual(float(row[name]), value, 9)
        self.assertEqual((row["family"], row["answer"], row["why not"]), ("scene", "G_J of Notch.0", ""))
        self.assertFalse(os.path.exists(self.path("scene.cells", "study.png")))  # there is no reference
        self.assertEqual(self.start("--cell-sizes", "1.25e-3", "5e-3", "2.5e-3")[1].count("(done before)"), 3)

    def test_refuses_what_gives_no_limit(self):
        for sizes, words in ((["5e-3", "2.5e-3"], "need three sizes, and there are 2; for two, use rhegma --twice"),
                             (["5e-3", "2.5e-3", "5e-3"], "there are 2"), (["1", "2", "fine"], "must be numbers"),
                             (["1", "2", "-1"], "must be above zero"), (["1", "2", "3", "--family", "a"], "has no families")):
            self.assert_fails(self.start("--cell-sizes", *sizes), words)
        self.write("study.xml", '<ParameterList name="Study"/>\n')
        self.assert_fails(run("rhegma-study", self.path("study.xml"), "--rhegma", PROGRAM, "--cell-sizes", "1", "2", "3"),
                          "is no scene; a study has the cell sizes of its families in its Sweep")

    def test_a_run_that_fails_leaves_too_few(self):
        status, output, _ = self.start("--cell-sizes", "1.25e-3", "9.5e-3", "2.5e-3")
        self.assertEqual(status, 2)
        self.assertIn("scene: no limits for vanishing cells: a limit needs three cell sizes, and 2 runs finished", output)


del ToolTest
if __name__ == "__main__":
    unittest.main()
