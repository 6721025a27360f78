#!/usr/bin/env python3
"""Fronts of insulating cracks: a section Thermal that has no effect leaves G as it is, and cracks anywhere in a flux of heat have the K_II
of the infinite plate.

RHEGMA_CRACKS=10 test_thermal_fronts.py    that many cracks with 8, 16 and 32 cells in half the length, and the rms of their errors"""

import json
import math
import os
import random
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import ProgramTest, rhegma  # noqa: E402

INPUTS = os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", "..", "xml_inputs")
CRACKS = int(os.environ.get("RHEGMA_CRACKS", "0"))
SEED = int(os.environ.get("RHEGMA_SEED", random.randrange(10**6)))

# xml_inputs/verification/thermal_crack_steady.xml: half length, flux of heat across the plate, and the value of its reference
HALF, COARSE = 1e-3, 2e-3
STRAIGHT = 482.091 / math.cos(math.radians(35.0))


class ThermalFronts(ProgramTest):
    def run_scene(self, scene, *settings):
        sets = [word for setting in settings for word in ("--set", setting)]
        answer = rhegma(os.path.join(INPUTS, scene), "--output", self.path("out"), "--quiet", *sets)
        self.assertIn(answer.status, (0, 4), answer)
        with open(self.path("out", "summary.json"), encoding="utf-8") as file:
            return json.load(file)["cracks"][0]["fronts"]

    def test_heat_without_effect(self):
        """All particles have one temperature, at which there is no thermal strain. Heat of strain has no effect on stress without
        expansion. G differs by rounding alone."""
        with open(os.path.join(INPUTS, "examples/edge_crack.xml"), encoding="utf-8") as file:
            text = file.read()
        text = text.replace('<ParameterList name="Cracks">', '<ParameterList name="Thermal"><Parameter name="Initial Temperature" '
                            'type="double" value="293"/></ParameterList>\n<ParameterList name="Cracks">', 1)
        density = '<Parameter name="Density"'
        self.assertEqual(text.count(density), 1)
        text = text.replace(density, '<Parameter name="Specific Heat" type="double" value="800"/>\n' + density)
        cold = self.run_scene("examples/edge_crack.xml", "Time:Final Time=4e-5")[0]
        warm = self.run_scene(self.write("warm.xml", text), "Time:Final Time=4e-5")[0]
        self.assertGreater(cold["G_J"], 1.0)
        for name in ("G_J", "K_I"):
            self.assertAlmostEqual(warm[name] / cold[name], 1.0, delta=1e-9)

    def jump_errors(self, *replacements):
        """Of the temperatures of both faces in heat_insulated_crack.xml, after changes of its text."""
        with open(os.path.join(INPUTS, "verification/heat_insulated_crack.xml"), encoding="utf-8") as file:
            text = file.read()
        for old, new in replacements:
            self.assertEqual(text.count(old), 1, old)
            text = text.replace(old, new)
        answer = rhegma(self.write("strip.xml", text), "--output", self.path("out"), "--quiet")
        self.assertIn(answer.status, (0, 4), answer)
        with open(self.path("out", "summary.json"), encoding="utf-8") as file:
            return [reference["relative_error"] for reference in json.load(file)["references"]]

    def test_a_poor_conductor_elsewhere(self):
        """What conducts at a front is what lies there: neither a pad that touches nothing nor the end of a table that no temperature
        reaches makes the jump wrong by more than the tolerance of the scene (with the least conductivity of all it was 6 to 13 %)."""
        plain = self.jump_errors()
        foam = ('<ParameterList name="Foam"><Parameter name="Model" type="string" value="Rigid"/><Parameter name="Density" type="double" '
                'value="1000.0"/><Parameter name="Specific Heat" type="double" value="1000.0"/><Parameter name="Conductivity" '
                'type="double" value="0.02"/></ParameterList>')
        pad = ('<ParameterList name="Pad"><Parameter name="Material" type="string" value="Foam"/><Parameter name="Shape" type="string" '
               'value="Box"/><Parameter name="Lower Corner" type="Array(double)" value="{0, -0.00875}"/><Parameter name="Upper Corner" '
               'type="Array(double)" value="{0.001, -0.0085}"/></ParameterList>')
        stone, half = '<ParameterList name="Stone">', '<ParameterList name="Half">'
        conductivity = '<Parameter name="Conductivity" type="double" value="1.0"/>'
        table = '<Parameter name="Conductivity" type="string" value="100:0.02, 150:1.0, 500:1.0"/>'
        for name, changed in (("pad", self.jump_errors((stone, foam + stone), (half, pad + half))),
                              ("table", self.jump_errors((conductivity, table)))):
            with self.subTest(name):
                for one, other in zip(plain, changed):
                    self.assertLess(abs(other), 0.01, f"{one} without")

    def errors(self, level, count, numbers):
        """Of K_II of both fronts, over that of a crack right across the flux."""
        all_errors = []
        for _ in range(count):
            angle, x, y = numbers.uniform(0.0, math.pi / 2), numbers.uniform(-1e-3, 1e-3), numbers.uniform(-1e-3, 1e-3)
            dx, dy = HALF * math.cos(angle), HALF * math.sin(angle)
            fronts = self.run_scene("verification/thermal_crack_steady.xml", f"Adaptivity:Maximum Level={level}",
                                    f"Cracks:Notch:Points={{{x - dx!r}, {y - dy!r}, {x + dx!r}, {y + dy!r}}}")
            all_errors += [abs(front["K_II"]) / STRAIGHT - math.cos(angle) for front in fronts]
        rms = math.sqrt(sum(error**2 for error in all_errors) / len(all_errors))
        print(f"{HALF / COARSE * 2**level:.0f} cells in half the length, {count} cracks: K_II rms {100 * rms:.2f} %, "
              f"worst {100 * max(map(abs, all_errors)):.2f} %")
        return rms

    def test_cracks_anywhere(self):
        """The bound is twice the rms of 0.7 % over 30 cracks, which eight values exceed once in ten thousand times. Without the conductance
        of the front's cell and the fit around the front they have 1.8 to 2.3 %."""
        print(f"seed {SEED}")
        numbers = random.Random(SEED)
        self.assertLess(self.errors(5, CRACKS or 4, numbers), 0.015)
        if CRACKS:
            for level in (4, 6):
                self.errors(level, CRACKS, numbers)


if __name__ == "__main__":
    unittest.main()
