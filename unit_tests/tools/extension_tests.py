"""Tests of G by the change of energy, with a script in place of rhegma whose compliance is known."""

import csv
import os
import unittest

from tool import HERE, ToolTest, run

PROGRAM = os.path.join(HERE, "made_up_cracks.py")
SCENE = """<ParameterList name="Rhegma">
  <ParameterList name="Domain">
    <Parameter name="Dimension" type="int" value="%(dimension)d"/>
    <Parameter name="Thickness" type="double" value="0.5"/>
  </ParameterList>
  <ParameterList name="Time"><Parameter name="Analysis" type="string" value="Static"/></ParameterList>
  <ParameterList name="Boundaries">
    <ParameterList name="Grip">
      <Parameter name="Type" type="string" value="Velocity"/>
      <Parameter name="Value" type="Array(double)" value="{0, %(speed)g}"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Cracks">
    <ParameterList name="Notch"><Parameter name="Points" type="Array(double)" value="%(points)s"/></ParameterList>
    <ParameterList name="Disk"><Parameter name="Radius" type="double" value="%(radius)g"/></ParameterList>
  </ParameterList>
%(more)s</ParameterList>
"""
PRESSURE = '  <ParameterList name="Face Pressure"/>\n'
EXACT = 0.5 * 10.0**2 * 3e-3 * 2.0**2 / 0.5


def central(step):
    """The central difference of a^3 at a = 2 m adds step^2 to 3 a^2."""
    return EXACT * (1.0 + step**2 / (3 * 2.0**2))


class Extension(ToolTest):
    def start(self, case, *more, front="Notch.1", **changes):
        values = dict({"dimension": 2, "speed": 0.0, "points": "{0, 0, 0, 1, 0, 2}", "more": "", "radius": 2.0}, **changes)
        self.write(case + ".xml", SCENE % values)
        return run("rhegma-study", self.path(case + ".xml"), "--rhegma", PROGRAM, "--crack-extension", front, *more)

    def releases(self, case, answer):
        status, output, messages = answer
        self.assertEqual((status, messages), (0, ""), output)
        with open(self.path(case + ".extension", "release.csv"), newline="") as file:
            return output, {row["method"]: float(row["G"]) for row in csv.DictReader(file)}

    def test_loads(self):
        """The last segment, at an angle, becomes longer and shorter in its direction, by four cells."""
        points = "{0, 0, 0, 1, 0.6, 1.8}"
        output, found = self.releases("load", self.start("load", points=points))
        self.assertAlmostEqual(found["change of energy"], central(0.4), 6)
        self.assertAlmostEqual(found["to the shorter crack"], 0.5 * 100.0 * 1e-3 * (2.0**3 - 1.6**3) / 0.2, 6)
        self.assertAlmostEqual(found["to the longer crack"], 0.5 * 100.0 * 1e-3 * (2.4**3 - 2.0**3) / 0.2, 6)
        self.assertIn(f"domain integral, G_J               1.212  {100 * (1.01 * EXACT / central(0.4) - 1):+.2f} %", output)
        self.assertIn("Cracks:Notch:Points = {0.0, 0.0, 0.0, 1.0, 0.36, 1.48", output)
        self.assertIn("(done before)", self.start("load", points=points)[1])
        status, _, messages = self.start("load", points="{0, 0, 0.3, 1.4, 0.6, 1.8}")
        self.assertEqual(status, 1)
        self.assertIn("its last segment is 0.5 m long, and must be 0.8 m or longer", messages)

    def test_grips(self):
        """U = u^2 / (2 C): with the compliances at both ends."""
        found = self.releases("grips", self.start("grips", speed=2.0))[1]
        self.assertAlmostEqual(found["change of energy"], 0.5 * 4e-6 / 1e-3 * (1.9**-3 - 2.1**-3) / 0.1, 9)

    def test_pressure(self):
        found = self.releases("pressure", self.start("pressure", more=PRESSURE))[1]
        self.assertAlmostEqual(found["change of energy"], central(0.1), 6)
        self.assert_fails(self.start("pressure", speed=1.0, more=PRESSURE), "Face Pressure and a support that moves both do work")

    def test_disk(self):
        found = self.releases("disk", self.start("disk", front="Disk.0", dimension=3))[1]
        area = 3.141592653589793 / 4 * (2.1**2 - 1.9**2)
        self.assertAlmostEqual(found["change of energy"], 0.5 * 100.0 * 1e-3 * (2.1**3 - 1.9**3) / area, 6)

    def test_lengths_in_units(self):
        """The same crack in millimetres, and a disk with its radius in centimetres, also within its text."""
        inside = self.releases("load", self.start("load", points='{0, 0, 0, 1000, 600, 1800}" unit="mm'))[1]
        self.assertAlmostEqual(inside["change of energy"], central(0.4), 6)
        area = 3.141592653589793 / 4 * (2.1**2 - 1.9**2)
        for radius in ('"200" unit="cm"', '"200 cm"'):
            self.write("disk.xml", SCENE.replace('"%(radius)g"', radius) % {"dimension": 3, "speed": 0.0, "points": "{0, 0}", "more": ""})
            found = self.releases("disk", run("rhegma-study", self.path("disk.xml"), "--rhegma", PROGRAM, "--crack-extension", "Disk.0"))[1]
            self.assertAlmostEqual(found["change of energy"], 0.5 * 100.0 * 1e-3 * (2.1**3 - 1.9**3) / area, 6)
        status, _, messages = self.start("load", points='{0, 0, 0, 1, 0, 2}" unit="inch')
        self.assertEqual((status, messages.count("\n")), (1, 1), messages)
        self.assertIn("is in inch; write it in m, cm, mm or um", messages)

    def test_a_run_that_fails(self):
        status, output, messages = self.start("disk", front="Disk.0", dimension=3, radius=2.45)
        self.assertEqual((status, messages), (2, "rhegma-study: 1 of 3 runs failed; see rhegma.log in the folder of each.\n"))
        self.assertIn("failed with status 2: There is no material so far away.", output)
        self.assertFalse(os.path.exists(self.path("disk.extension", "release.csv")))

    def test_a_front_that_is_at_no_end(self):
        status, _, messages = self.start("load", points="{0, 0, 0, 1, 0, 2.45}")
        self.assertEqual((status, messages.count("\n")), (1, 1), messages)
        self.assertIn("no end of its Points is near", messages)

    def test_refuses_what_has_no_such_energy(self):
        for changes, words in (({"front": "Notch.2"}, "has no such front"), ({"front": "Notch"}, "has no such front"),
                               ({"front": "Slit.0"}, "has no such front"), ({"front": "Disk.0"}, "has no such front"),
                               ({"more": '<ParameterList name="Thermal"/>'}, "is not defined with the section Thermal"),
                               ({"more": '<ParameterList name="Contact"/>'}, "is not defined with the section Contact")):
            status, _, messages = self.start("load", **changes)
            self.assertEqual((status, messages.count("\n")), (1, 1), messages)
            self.assertIn(words, messages)
        self.assert_fails(self.start("load", "--cell-sizes", "1", "2", "3"), "goes without --cell-sizes")
        self.write("load.xml", (SCENE % {"dimension": 2, "speed": 0.0, "points": "{0, 0}", "more": "", "radius": 2.0}).replace("Static", "Dynamic"))
        self.assert_fails(run("rhegma-study", self.path("load.xml"), "--rhegma", PROGRAM, "--crack-extension", "Notch.0"),
                          "set Time > Analysis to Static")


del ToolTest
if __name__ == "__main__":
    unittest.main()
