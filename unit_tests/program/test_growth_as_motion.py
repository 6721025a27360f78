#!/usr/bin/env python3
"""Unstable growth of cracks in equilibrium goes on as motion: from when, with which energy, from a checkpoint and on several ranks."""

import csv
import json
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import SOURCE, ProgramTest, rhegma  # noqa: E402
from ranks import LAUNCHER, ROOT  # noqa: E402

BEAM = os.path.join(SOURCE, "xml_inputs", "verification", "dcb_unstable.xml")
SHORT = ("--set", "Time:Dynamic Time=1e-4", "--set", "Output:History Interval=1e-6")
STABLE = ("--set", "Propagation:Initiation Toughness=10")  # that is the toughness

# The beam of the scene as one on an elastic foundation: G = (3/16) E h^3 D^2 / (a + 0.669 h)^4 at an opening D.
MODULUS, ARM, NOTCH, FOUNDATION = 3e9, 0.01, 0.03, 0.669
RATE = 4e-4  # of the opening [m/s]

FORCE = """
    <ParameterList name="{name}">
      <Parameter name="Type" type="string" value="Line Load"/>
      <Parameter name="Body" type="string" value="Beam"/>
      <Parameter name="From" type="Array(double)" value="{{0, {y}}}"/>
      <Parameter name="To" type="Array(double)" value="{{0, {top}}}"/>
      <Parameter name="Profile" type="string" value="Parabolic"/>
      <Parameter name="Force" type="Array(double)" value="{{0, {force}}}"/>
      <Parameter name="History" type="string" value="t"/>
    </ParameterList>"""


def time_of_toughness(toughness, length=NOTCH):
    opening = (length + FOUNDATION * ARM) ** 2 * (16.0 / 3.0 * toughness / (MODULUS * ARM**3)) ** 0.5
    return opening / RATE


class GrowthAsMotion(ProgramTest):
    def summary(self, out):
        with open(self.path(out, "summary.json"), encoding="utf-8") as file:
            return json.load(file)

    def rows(self, out):
        with open(self.path(out, "history.csv"), encoding="utf-8") as file:
            return [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]

    def beam(self):
        """The scene without its references, which are those of the whole run."""
        with open(BEAM, encoding="utf-8") as file:
            text = file.read()
        return text[: text.index('  <ParameterList name="Reference">')] + "</ParameterList>\n"

    def run_beam(self, out, *more, text=None, **options):
        scene = self.write(out + ".xml", text or self.beam())
        answer = rhegma(scene, "--output", self.path(out), "--quiet", *more, **options)
        self.assertEqual(answer.status, 0, answer)

    def test_it_begins_at_rest_and_the_energy_balance_goes_on(self):
        self.run_beam("out", *SHORT)
        summary, rows = self.summary("out"), self.rows("out")
        begin = summary["propagation"]["motion_from"]
        # The springs of growing fronts make G of 8 cells an arm 2.5 % too high (40.99 for 40 J/m2 before the crack of dcb_arrest starts), and the
        # time is its square root; the closed form is good to half a per cent.
        self.assertAlmostEqual(begin["time"] / time_of_toughness(20.0), 1.0, delta=0.015)
        self.assertEqual(begin["new_area"], 0.0)
        self.assertEqual(summary["propagation"]["unstable_from"], {"new_area": 0.0, "time": begin["time"]})
        self.assertAlmostEqual(summary["time"], begin["time"] + 1e-4, delta=1e-9)
        self.assertTrue(any("From there on the run is dynamic" in line for line in summary["answers"]), summary["answers"])
        before = [row for row in rows if row["time"] <= begin["time"]]
        after = [row for row in rows if row["time"] > begin["time"]]
        self.assertEqual(before[-1]["time"], begin["time"])
        self.assertTrue(all(row["kinetic"] == 0.0 for row in before))
        # Faces are longer by what the body is strained, less than a thousandth.
        self.assertTrue(all(abs(row["Notch.0.length"] / NOTCH - 1.0) < 1e-3 for row in before))
        self.assertAlmostEqual(before[-1]["Notch.0.G_J"] / 20.0, 1.001, delta=1.1e-3)
        # Nothing jumps: the energy of a linear beam is what its grips have given, and the first microsecond changes it by little. What springs at the
        # front store counts as energy of new faces from there on.
        stored = after[0]["strain"] + after[0]["fracture"] + after[0]["kinetic"]
        self.assertAlmostEqual(stored / before[-1]["strain"], 1.0, delta=2e-3)
        self.assertGreater(after[-1]["kinetic"], 0.01 * before[-1]["strain"])
        self.assertGreater(after[-1]["fracture"], 0.0)
        for row in after:
            self.assertLess(abs(row["residual"]), 0.003 * before[-1]["strain"], row["time"])
        # The grips go on moving at their rate.
        self.assertAlmostEqual(after[-1]["Upper Grip.displacement_y"] / (0.5 * RATE * after[-1]["time"]), 1.0, delta=1e-6)

    def test_forces_that_a_crack_can_no_longer_bear(self):
        """Under forces G rises with the length, so that growth is unstable from its start, with one toughness."""
        text = self.beam()
        first, last = text.index('  <ParameterList name="Boundaries">'), text.index('  <ParameterList name="Cracks">')
        expected = (10.0 * MODULUS * ARM**3 / 12.0) ** 0.5 / (NOTCH + FOUNDATION * ARM)  # force per thickness: G = 12 P^2 L^2 / (E h^3)
        forces = ""
        for name, y, sign in (("Upper Force", 0.01, 1.0), ("Lower Force", 0.0, -1.0)):
            forces += FORCE.format(name=name, y=y, top=y + 0.01, force=sign * expected / 0.7)
        settings = (*STABLE, "--set", "Propagation:Toughness=10", "--set", "Time:Dynamic Time=4e-4")
        self.run_beam("forces", *settings, text=text[:first] + '<ParameterList name="Boundaries">' + forces + "</ParameterList>" + text[last:])
        summary = self.summary("forces")
        begin = summary["propagation"]["motion_from"]
        # The force rises in proportion to time; as above, G is 2.5 % too high, and time goes with its square root. The closed form
        # is good to half a per cent.
        self.assertAlmostEqual(begin["time"] / 0.7, 1.0, delta=0.03)
        self.assertEqual(begin["new_area"], 0.0)
        self.assertGreater(summary["cracks"][0]["fronts"][0]["length"], NOTCH + 5e-3)
        self.assertLess(abs(summary["propagation"]["accounted_for"] - 1.0), 0.003)

    def test_stable_growth_stays_in_equilibrium(self):
        settings = (*STABLE, "--set", "Time:Final Time=0.8", "--set", "Propagation:Increment=0.5")
        self.run_beam("asked", *settings)
        asked = self.summary("asked")
        self.assertEqual(asked["propagation"]["motion_from"], {"new_area": None, "time": None})
        self.assertEqual(asked["propagation"]["unstable_from"], {"new_area": None, "time": None})
        self.assertEqual(asked["energy"]["kinetic"], 0.0)
        # The length at which G is the toughness under the last opening; within the increment that is due next, 0.5 cells.
        opening = RATE * 0.8
        length = (3.0 / 16.0 * MODULUS * ARM**3 * opening**2 / 10.0) ** 0.25 - FOUNDATION * ARM
        self.assertAlmostEqual(asked["cracks"][0]["fronts"][0]["length"], length, delta=1.25e-3)

    def test_a_run_from_a_checkpoint_of_the_motion_has_the_same_digits(self):
        self.run_beam("whole", *SHORT)
        steps = self.summary("whole")["steps"]
        checkpoint = ("--set", "Output:Checkpoint Interval=1")
        self.run_beam("part", *SHORT, *checkpoint, "--set", f"Time:Maximum Steps={steps - 100}")
        part = self.summary("part")
        self.assertGreater(part["time"], part["propagation"]["motion_from"]["time"])
        self.run_beam("part", *SHORT, *checkpoint, "--restart", self.path("part", "checkpoint.h5"))
        for name in ("energy", "propagation", "cracks"):
            self.assertEqual(self.summary("part")[name], self.summary("whole")[name], name)
        self.assertEqual(self.rows("part")[-1], self.rows("whole")[-1])

    def test_two_ranks_find_the_same(self):
        self.run_beam("one", *SHORT)
        self.run_beam("two", *SHORT, launcher=[*LAUNCHER, "-np", "2"], **ROOT)
        one, two = self.summary("one"), self.summary("two")
        times = [summary["propagation"]["motion_from"]["time"] for summary in (one, two)]
        # The search ends with G known to the tolerance of equilibrium, 1e-9 of the forces times the condition of cut cells (1e5).
        self.assertAlmostEqual(times[1] / times[0], 1.0, delta=1e-4)
        lengths = [summary["cracks"][0]["fronts"][0]["length"] for summary in (one, two)]
        self.assertAlmostEqual(lengths[1], lengths[0], delta=1e-9)
        self.assertAlmostEqual(two["energy"]["kinetic"] / one["energy"]["kinetic"], 1.0, delta=1e-3)

    def test_what_has_no_meaning_is_refused(self):
        wrong = {
            ("Time:Analysis=Dynamic",): "Time > Unstable Growth: only a quasi-static analysis finds where growth becomes unstable",
            ("Time:Analysis=Static",): "Time > Unstable Growth: only a quasi-static analysis",
            ("Propagation:Load Control=Load Factor",): "loads are no functions of time, in which motion could go on",
            ("Propagation:Increment=0.25",): "increments below half a cell are for equilibrium only, and motion follows",
            ("Time:Unstable Growth=Equilibrium",): "Time > Dynamic Time: motion follows only with Unstable Growth = Dynamic",
            ("Contact:Law=Frictionless",): "closed faces can't be taken over from equilibrium to motion",
            ("Time:Unstable Growth=Motion",): "Time > Unstable Growth",
        }
        for settings, words in wrong.items():
            answer = rhegma(BEAM, "--check", *[part for setting in settings for part in ("--set", setting)])
            self.assertEqual(answer.status, 1, answer)
            self.assertIn(words, answer.messages)


if __name__ == "__main__":
    unittest.main()
