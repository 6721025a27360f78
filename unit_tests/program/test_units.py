#!/usr/bin/env python3
"""Scenes in units: the same runs as in SI units, and units that are refused."""

import os
import random
import sys
import unittest
from decimal import Decimal

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import ProgramTest, rhegma  # noqa: E402
from scenes import plate  # noqa: E402

# Units and their powers of ten in SI units.
LENGTHS = {"m": 0, "mm": -3, "um": -6, "cm": -2, "km": 3}
TIMES = {"s": 0, "ms": -3, "us": -6}
PRESSURES = {"Pa": 0, "MPa": 6, "GPa": 9, "N/mm2": 6, "kPa": 3, "bar": 5}
DENSITIES = {"kg/m3": 0, "g/cm3": 3, "t/m3": 3, "kg m-3": 0}
UNITS = {"Final Time": TIMES, "Density": DENSITIES, "Young Modulus": PRESSURES, "Stress": PRESSURES,
         **{name: LENGTHS for name in ("Lower Corner", "Upper Corner", "Cell Size", "From", "To", "Points", "Inner Radius", "Outer Radius")}}


def in_unit(text, power):
    """A number, or numbers in braces, in a unit of this power of ten."""
    numbers = [str(Decimal(number.strip()).scaleb(-power)) for number in text.strip("{}").split(",")]
    return "{" + ", ".join(numbers) + "}" if text.startswith("{") else numbers[0]


def write_in_units(scene, chance):
    """Every parameter with a unit in another one: with the attribute, or within its text."""
    for element in scene.root.iter("Parameter"):
        if element.get("name") in UNITS:
            unit, power = chance.choice(sorted(UNITS[element.get("name")].items()))
            text = in_unit(element.get("value"), power)
            if chance.random() < 0.5:
                element.set("unit", unit)
            else:
                element.set("type", "string")
                text += chance.choice((" ", "")) + unit
            element.set("value", text)
    return scene


class Units(ProgramTest):
    def history(self, scene, *more, status=0):
        out = self.path(f"out{len(os.listdir(self.folder))}")
        answer = rhegma(scene, "--output", out, "--quiet", "--set", "Time:Maximum Steps=40", *more)
        self.assertEqual(answer.status, status, answer)
        with open(os.path.join(out, "history.csv"), "rb") as file:
            return file.read(), out

    def test_random_units_give_the_same_run(self):
        seed = random.randrange(10**9)
        print("seed", seed)
        chance = random.Random(seed)
        expected, _ = self.history(self.write("si.xml", plate().text()))
        self.assertGreater(expected.count(b"\n"), 2)
        for trial in range(5):
            scene = write_in_units(plate(), chance).text()
            self.assertEqual(self.history(self.write(f"units{trial}.xml", scene))[0], expected, scene)

    def test_a_run_continues_in_other_units(self):
        seed = random.randrange(10**9)
        print("seed", seed)
        chance = random.Random(seed)
        with_output = [plate().set("Output", {"Checkpoint Interval": 1.0}) for _ in range(2)]
        one, other = (self.write(f"scene{n}.xml", write_in_units(scene, chance).text()) for n, scene in enumerate(with_output))
        whole, _ = self.history(one, "--set", "Time:Maximum Steps=60")
        _, out = self.history(one)
        checkpoint = os.path.join(out, "checkpoint.h5")
        continued = rhegma(other, "--output", out, "--quiet", "--restart", checkpoint, "--set", "Time:Maximum Steps=60")
        self.assertEqual(continued.status, 0, continued)
        with open(os.path.join(out, "history.csv"), "rb") as file:
            self.assertEqual(file.read(), whole)
        changed = rhegma(other, "--output", out, "--quiet", "--restart", checkpoint, "--set", "Materials:Polymer:Density=1.201 g/cm3")
        self.assertEqual(changed.status, 1, changed)
        self.assertIn('Materials > Polymer > Density is "1201" in the scene and "1200" in the checkpoint', changed.messages)

    def test_units_of_the_command_line(self):
        scene = self.write("scene.xml", plate().text())
        plain, _ = self.history(scene, "--set", "Materials:Polymer:Young Modulus=2.5e9", "--set", "Boundaries:Pull:Stress={2e5, 0}")
        units, _ = self.history(scene, "--set", "Materials:Polymer:Young Modulus=2.5 GPa", "--set", "Boundaries:Pull:Stress={0.2, 0} MPa")
        self.assertEqual(units, plain)

    def test_wrong_units_are_refused(self):
        scene = plate().set("Propagation", {"Toughness": "2.5 MPa"}).raw("Bodies > Plate > Rotation", "double", "3")
        scene.find("Bodies > Plate > Rotation").set("unit", "kg")
        scene.find("Time > Final Time").set("unit", "sec onds")
        scene.find("Materials > Polymer > Poisson Ratio").set("unit", "Pa")
        self.write("scene.xml", scene.text())
        self.assert_refused(["scene.xml", "--set", "Domain:Cell Size=50 mm m^0.5"], [
            ("Propagation > Toughness", ["is given in MPa, a pressure", "an energy per area", "J/m2"]),
            ("Bodies > Plate > Rotation", ["is given in kg, a mass", "an angle", "deg"]),
            ("Time > Final Time", ['"sec onds"', "no known unit"]),
            ("Materials > Polymer > Poisson Ratio", ["is given in Pa", "a number without a unit", "leave the unit out"]),
            ("Domain > Cell Size", ['"mm m^0.5"', "a unit with a root"]),
        ])

    def test_without_the_table_of_units(self):
        """Scenes without units need none."""
        scene = self.write("scene.xml", plate().text())
        nowhere = {"UDUNITS2_XML_PATH": self.path("nowhere.xml")}
        self.assertEqual(rhegma(scene, "--check", "--quiet", **nowhere).status, 0)
        answer = rhegma(scene, "--check", "--set", "Domain:Cell Size=50 mm", **nowhere)
        self.assertEqual(answer.status, 1, answer)
        self.assert_messages(answer.messages, [("Domain > Cell Size", ["libudunits2", "UDUNITS2_XML_PATH", "SI units"])])


del ProgramTest
if __name__ == "__main__":
    unittest.main()
