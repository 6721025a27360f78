#!/usr/bin/env python3
"""The library of materials: its constants, ranges and sources, and its use by name in scenes."""

import glob
import json
import math
import os
import random
import re
import sys
import unittest
import xml.etree.ElementTree as ElementTree

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import SOURCE, ProgramTest, rhegma  # noqa: E402
from scenes import plate  # noqa: E402

SI = {None: 1.0, "g/cm3": 1e3, "kg/m3": 1.0, "GPa": 1e9, "MPa": 1e6, "J/m2": 1.0, "J/(kg K)": 1.0, "W/(m K)": 1.0, "1/K": 1.0, "K": 1.0, "m/s": 1.0, "m": 1.0, "s": 1.0, "Pa m^0.5": 1.0}
HEAT = ("Specific Heat", "Conductivity", "Thermal Expansion")
SPEEDS = ("Longitudinal Wave Speed", "Shear Wave Speed", "Rayleigh Wave Speed")
# Those whose moduli are of slow tests have no ultrasonic speeds.
SLOW = ("PMMA Slow", "Homalite-100 Slow")
# Parameters that a law needs in a scene without heat, besides the density.
NEEDS = {
    "Linear Elastic": ("Young Modulus", "Poisson Ratio"),
    "Neo-Hookean": ("Young Modulus", "Poisson Ratio"),
    "J2 Plastic": ("Young Modulus", "Poisson Ratio", "Yield Stress"),
    "Mooney-Rivlin": ("C10", "C01", "Bulk Modulus"),
    "High-Rate Solid": ("Young Modulus", "Poisson Ratio", "Specific Heat", "Johnson-Cook A", "Johnson-Cook B", "Johnson-Cook n",
                        "Johnson-Cook C", "Johnson-Cook m", "Melting Temperature", "Hugoniot Speed", "Hugoniot Slope",
                        "Grueneisen Coefficient"),
    "ViscoSCRAM": ("Young Modulus", "Poisson Ratio", "Relaxation Times", "Shear Fractions", "Time Shift", "WLF C1", "WLF C2", "Shift Temperature",
                   "Initial Crack Radius", "Crack Length Scale", "Crack Toughness", "Crack Friction", "Crack Growth Exponent",
                   "Maximum Crack Speed"),
}


def read_files():
    """Elements of materials, and citations by key, of xml_inputs/materials."""
    materials, sources = {}, {}
    for path in sorted(glob.glob(os.path.join(SOURCE, "xml_inputs", "materials", "*.xml"))):
        for element in ElementTree.parse(path).getroot():
            if element.get("name") == "Sources":
                sources.update({one.get("name"): one.get("value") for one in element})
            else:
                materials[element.get("name")] = element
    return materials, sources


MATERIALS, SOURCES = read_files()


def bounds(element):
    low, high = element.get("range").split(" to ")
    return float(low), float(high)


def at_rest(value):
    """A number, or that of a table at its first speed."""
    return float(value.split(",")[0].split(":")[-1])


def constants(name):
    """Constants of a material in SI units; of a toughness that at rest; a list of numbers; a text."""
    def value(one):
        text = one.get("value")
        if one.get("type") == "Array(double)":
            return [float(number) * SI[one.get("unit")] for number in text.strip("{}").split(",")]
        return text if text[0].isalpha() else at_rest(text) * SI[one.get("unit")]
    return {one.get("name"): value(one) for one in MATERIALS[name].iter("Parameter")}


def rayleigh(shear, longitudinal):
    """Root of (2 - x)^2 = 4 sqrt((1 - x) (1 - x q)), x the squared speed over the shear wave's, by bisection."""
    q, low, high = (shear / longitudinal) ** 2, 0.1, 1.0
    for _ in range(80):
        x = 0.5 * (low + high)
        low, high = (x, high) if (2 - x) ** 2 < 4 * math.sqrt((1 - q * x) * (1 - x)) else (low, x)
    return shear * math.sqrt(low)


def derived(name):
    """Speeds [m/s] and K_Ic [MPa m^0.5] in plane strain that follow from the constants of the usual law."""
    c = constants(name)
    if "C10" in c:
        shear, bulk = 2 * (c["C10"] + c["C01"]), c["Bulk Modulus"]
        young, poisson = 9 * bulk * shear / (3 * bulk + shear), (3 * bulk - 2 * shear) / (6 * bulk + 2 * shear)
    else:
        young, poisson = c["Young Modulus"], c["Poisson Ratio"]
        shear = young / (2 * (1 + poisson))
        bulk = young / (3 * (1 - 2 * poisson))
    longitudinal, slow = (math.sqrt(m / c["Density"]) for m in (bulk + 4 / 3 * shear, shear))
    found = dict(zip(SPEEDS, (longitudinal, slow, rayleigh(slow, longitudinal))))
    found["K_Ic"] = 1e-6 * math.sqrt(young / (1 - poisson**2) * c["Toughness"])
    return found


def laws(name):
    return MATERIALS[name].get("laws").split(", ")


def scene_of(content):
    """A small plate without crack and load, which a velocity moves."""
    scene = plate().remove("Cracks").remove("Energy Release").remove("Boundaries")
    scene.set("Bodies > Plate > Velocity", [1.0, 0.0])
    return scene.set("Materials", {"Polymer": content})


def cracked(propagation, material):
    scene = plate().set("Materials", {"Polymer": material}).set("Propagation", propagation)
    return scene.set("Energy Release", {})


class Files(unittest.TestCase):
    def test_at_least_twenty(self):
        self.assertGreaterEqual(len(MATERIALS), 20)

    def test_every_constant_has_a_source_and_is_in_its_range(self):
        used = set()
        for name, material in MATERIALS.items():
            for one in material:
                with self.subTest(name, constant=one.get("name")):
                    keys = one.get("source").split("; ")
                    used.update(keys)
                    self.assertEqual([key for key in keys if key not in SOURCES], [])
                    if one.get("range") is None:  # of a fit that says to what
                        self.assertIn(keys[0], ("Fit", "ViscoSCRAM"))
                        self.assertGreater(len(keys), 1)
                        continue
                    low, high = bounds(one)
                    self.assertLess(low, high)
                    if one.tag == "Parameter":
                        self.assertTrue(low <= at_rest(one.get("value")) <= high, (one.get("value"), low, high))
        self.assertEqual(sorted(set(SOURCES) - used), [])
        for key, citation in SOURCES.items():
            if key not in ("Typical", "Fit", "ViscoSCRAM", "CRC", "ASTM E494", "Ultrasonic tables"):
                self.assertRegex(citation, r"\b(19|20)\d\d\b", key)

    def test_have_validity_and_heat(self):
        for name, material in MATERIALS.items():
            with self.subTest(name):
                self.assertRegex(material.get("temperature"), r"^\d+ to \d+ K$")
                self.assertTrue(material.get("rate") and material.get("title"))
                self.assertLessEqual(set(HEAT) | {"Density", "Toughness"}, set(constants(name)))

    def test_speeds_and_intensity_are_in_measured_ranges(self):
        for name, material in MATERIALS.items():
            measured = {one.get("name"): bounds(one) for one in material.iter("Measured")}
            self.assertIn("K_Ic", measured, name)
            if name not in SLOW:
                self.assertLessEqual(set(SPEEDS), set(measured), name)
            for quantity, value in derived(name).items():
                if quantity in measured:
                    with self.subTest(name, quantity=quantity):
                        low, high = measured[quantity]
                        self.assertTrue(low <= value <= high, (value, low, high))

    def test_tables_of_toughness_rise(self):
        for name in MATERIALS:
            value = next(one.get("value") for one in MATERIALS[name] if one.get("name") == "Toughness")
            pairs = [tuple(map(float, pair.split(":"))) for pair in value.split(",") if ":" in pair]
            for (slow, less), (fast, more) in zip(pairs, pairs[1:]):
                self.assertTrue(slow < fast and less < more, (name, value))
                self.assertLess(fast, derived(name)["Rayleigh Wave Speed"], name)

    def test_rubber_has_one_shear_modulus(self):
        """Both laws of a rubber have the same moduli; the file has three digits."""
        c = constants("Natural Rubber")
        self.assertAlmostEqual(c["Young Modulus"] / (6 * (c["C10"] + c["C01"])), 1.0, delta=1e-3)

    def test_hardening_is_that_of_the_law_it_was_fitted_to(self):
        """Johnson-Cook constants A, B [MPa] and n of the sources; the notes state the errors in percent."""
        curves = {"4340 Steel": (792, 510, 0.26), "Mild Steel": (350, 275, 0.36), "Aluminium 6061-T6": (324, 114, 0.42),
                  "Aluminium 7075-T6": (546, 678, 0.71), "OFHC Copper": (90, 292, 0.31), "Ti-6Al-4V": (862, 331, 0.34),
                  "Tungsten Alloy": (1506, 177, 0.12)}
        fitted = {name for name in MATERIALS if "Saturation Stress" in constants(name)}
        self.assertEqual(set(curves), fitted)
        for name, (a, b, n) in curves.items():
            c = constants(name)
            yields, limit = c["Yield Stress"], c["Saturation Stress"]
            stated = float(re.search(r"within ([\d.]+) %", MATERIALS[name].get("note")).group(1))
            worst = 0.0
            for k in range(200):
                strain = 0.002 * 150 ** (k / 199)
                stress = (yields + (limit - yields) * (1 - math.exp(-c["Saturation Rate"] * strain))
                          + c["Hardening Modulus"] * strain)
                worst = max(worst, abs(stress / (1e6 * (a + b * strain**n)) - 1))
            self.assertLess(100 * worst, stated + 0.05, name)


class Use(ProgramTest):
    def library_of(self, scene, *options):
        """What summary.json has of the library."""
        answer = rhegma(self.write("scene.xml", scene.text()), "--quiet", "--output", self.path("out"), *options)
        self.assertEqual(answer.status, 0, answer)
        with open(self.path("out", "summary.json"), encoding="utf-8") as file:
            return json.load(file).get("library")

    def assert_values(self, values, expected):
        self.assertEqual(set(values), set(expected))
        for name, value in values.items():
            if isinstance(expected[name], float):
                self.assertAlmostEqual(value / expected[name], 1.0, delta=1e-14, msg=name)
            else:
                self.assertEqual(value, expected[name])

    def test_all_are_valid_with_all_of_their_laws(self):
        for name in MATERIALS:
            for law in laws(name):
                with self.subTest(name, law=law):
                    scene = scene_of({"Material From Library": name, "Model": law})
                    answer = rhegma(self.write("scene.xml", scene.text()), "--check")
                    self.assertEqual(answer.status, 0, answer)
                    self.assertIn("is a valid scene", answer.output)
                    for parameter in ("Density",) + NEEDS[law]:
                        self.assertIn(f"{parameter} = ", answer.output)
                    self.assertIn(f"({name} of the library); the scene's own: Model\n", answer.output)
                    warnings = [line for line in answer.messages.splitlines() if "bend by" not in line]
                    self.assertEqual(warnings, [])

    def test_toughness_of_all(self):
        for name in MATERIALS:
            with self.subTest(name):
                scene = cracked({"Toughness From Library": name}, {"Material From Library": name})
                answer = rhegma(self.write("scene.xml", scene.text()), "--check")
                self.assertEqual(answer.status, 0, answer)
                value = next(one.get("value") for one in MATERIALS[name] if one.get("name") == "Toughness")
                self.assertIn(f"  Propagation: Toughness = {value} J/m2 ({name} of the library)\n", answer.output)
                for words in ("any solid", "any stiff solid", "atom's distance", "Poisson ratio is"):
                    self.assertNotIn(words, answer.messages)

    def test_what_the_scene_writes_wins(self):
        seed = 20260728
        print("seed", seed)
        draw = random.Random(seed)
        for _ in range(12):
            name = draw.choice(sorted(MATERIALS))
            law = draw.choice(laws(name))
            also = ("Yield Stress",) if law == "Linear Elastic" else ()  # known for warnings
            known = {key: value for key, value in constants(name).items() if key in ("Density",) + NEEDS[law] + also}
            own = {key: value * draw.uniform(0.97, 0.999) for key, value in known.items() if isinstance(value, float) and draw.random() < 0.5}
            with self.subTest(name, law=law, own=own):
                content = {"Material From Library": name, **own}
                if law != laws(name)[0]:
                    content["Model"] = law
                scene = scene_of(content).set("Time > Maximum Steps", 1)
                (use,) = self.library_of(scene)
                self.assertEqual((use["where"], use["material"]), ("Materials > Polymer", name))
                self.assertEqual(set(use["written"]), set(own) | ({"Model"} & set(content)))
                expected = {key: value for key, value in known.items() if key not in own}
                if "Model" not in content:
                    expected["Model"] = law
                if law == "J2 Plastic" and "Yield Stress" not in own:
                    expected.update({key: value for key, value in constants(name).items()
                                     if key.startswith(("Saturation", "Hardening"))})
                self.assert_values(use["values"], expected)

    def test_is_the_scene_with_the_constants_written(self):
        c = constants("PMMA")
        written = scene_of({"Model": "Linear Elastic", **{key: c[key] for key in ("Density", "Young Modulus", "Poisson Ratio")}})
        named = scene_of({"Material From Library": "PMMA"})
        rows = []
        for scene in (written, named):
            scene.set("Bodies > Plate > Angular Velocity", [10.0])
            self.library_of(scene)
            with open(self.path("out", "history.csv"), encoding="utf-8") as file:
                rows.append(file.read())
        self.assertGreater(len(rows[0].splitlines()), 100)
        self.assertEqual(rows[0], rows[1])

    def test_option_set_wins(self):
        scene = scene_of({"Material From Library": "4340 Steel"}).set("Time > Maximum Steps", 1)
        (use,) = self.library_of(scene, "--set", "Materials:Polymer:Yield Stress=1 GPa")
        self.assertEqual(use["written"], ["Yield Stress"])
        self.assertEqual([key for key in use["values"] if key.startswith(("Saturation", "Hardening"))], [])
        (use,) = self.library_of(scene, "--set", "Materials:Polymer:Material From Library=PMMA")
        self.assertEqual((use["material"], use["values"]["Model"]), ("PMMA", "Linear Elastic"))

    def test_own_toughness_wins(self):
        scene = cracked({"Toughness From Library": "PMMA", "Toughness": "1000"}, {"Material From Library": "PMMA"})
        _, use = self.library_of(scene.set("Time > Maximum Steps", 1))
        self.assertEqual((use["where"], use["values"], use["written"]), ("Propagation", {}, ["Toughness"]))

    def test_heat_needs_its_section(self):
        scene = scene_of({"Material From Library": "PMMA"}).set("Time > Maximum Steps", 1)
        (cold,) = self.library_of(scene)
        self.assertEqual([key for key in cold["values"] if key in HEAT], [])
        (warm,) = self.library_of(scene.set("Thermal", {"Initial Temperature": 293.0}))
        self.assert_values({key: value for key, value in warm["values"].items() if key in HEAT},
                           {key: constants("PMMA")[key] for key in HEAT})
        rigid = scene_of({"Material From Library": "PMMA", "Model": "Rigid"}).set("Time > Maximum Steps", 1)
        rigid.remove("Bodies > Plate > Velocity").set("Thermal", {"Initial Temperature": 293.0, "Mechanics": False})
        (use,) = self.library_of(rigid)
        self.assertEqual(set(use["values"]), {"Density", *HEAT})

    def test_continues_from_a_checkpoint(self):
        scene = scene_of({"Material From Library": "PMMA"}).set("Time > Final Time", 2e-4)
        scene.set("Output", {"Checkpoint Interval": 1e-4})
        first = self.library_of(scene)
        longer = scene.set("Time > Final Time", 4e-4)
        self.assertEqual(self.library_of(longer, "--restart", self.path("out", "checkpoint.h5")), first)
        answer = rhegma(self.write("scene.xml", longer.text()), "--restart", self.path("out", "checkpoint.h5"), "--set",
                        "Materials:Polymer:Material From Library=Epoxy", "--output", self.path("other"))
        self.assertEqual(answer.status, 1, answer)
        self.assertIn("Materials > Polymer > ", answer.messages)

    def test_wrong_names_and_laws(self):
        where = "Materials > Polymer"
        for given, words in (("PMA", ['no material "PMA"', "did you mean PMMA?"]),
                             ("steel", ["4340 Steel, 4340 Steel Hard, Maraging Steel 300 or Mild Steel?"]),
                             ("qqqqqq", ["it has ", "PMMA, PMMA Slow, "])):
            self.write("scene.xml", scene_of({"Material From Library": given}).text())
            self.assert_refused(["scene.xml"], [(f"{where} > Material From Library", words)])
        for content in ({}, {"Density": 1000.0, "C10": 1e5, "C01": 1e5, "Bulk Modulus": 1e9}):
            scene = scene_of({"Material From Library": "PMMA", "Model": "Mooney-Rivlin", **content})
            self.write("scene.xml", scene.text())
            self.assert_refused(["scene.xml"], [(f"{where} > Model", ["Mooney-Rivlin", "of PMMA for Linear Elastic and J2 Plastic"])])
        self.write("scene.xml", cracked({"Toughness From Library": "Epoxi"}, {"Material From Library": "Epoxy"}).text())
        self.assert_refused(["scene.xml"], [("Propagation > Toughness From Library", ["Epoxi", "did you mean Epoxy?"])])
        self.write("scene.xml", cracked({}, {"Material From Library": "Epoxy"}).text())
        self.assert_refused(["scene.xml"], [("Propagation > Toughness", ["is missing"])])


class Print(ProgramTest):
    def test_list_has_all(self):
        answer = rhegma("--materials")
        self.assertEqual((answer.status, answer.messages), (0, ""))
        blocks = dict(re.findall(r"^(\S[^:\n]*): (.*?)\n\n", answer.output + "\n\n", re.M | re.S))
        for name, material in MATERIALS.items():
            lines = blocks[name].splitlines()
            self.assertIn(material.get("temperature"), blocks[name])
            self.assertIn(material.get("rate"), blocks[name])
            for one in material:
                line = next(line for line in lines if line.startswith(f"    {one.get('name'):<25}"))
                for words in (one.get("value"), one.get("unit"), one.get("range"), one.get("source")):
                    self.assertIn(words or "", line)
            for quantity, value in derived(name).items():
                for line in lines:
                    if line.startswith(f"    {quantity:<25}"):
                        self.assertAlmostEqual(float(line[len(quantity) + 4 :].split()[0]) / value, 1.0, delta=1e-3)
        for key, citation in SOURCES.items():
            self.assertIn(f"  {key}: {citation}\n", answer.output)

    def test_block_can_be_pasted(self):
        for name in MATERIALS:
            with self.subTest(name):
                answer = rhegma("--materials", *name.split(" "))
                self.assertEqual((answer.status, answer.messages), (0, ""))
                start = answer.output.index("<ParameterList")
                end = answer.output.index("</ParameterList>") + len("</ParameterList>")
                scene = scene_of({"Model": "Linear Elastic"}).set("Bodies > Plate > Material", name)
                text = scene.set("Materials", {}).text()
                pasted = text.replace('<ParameterList name="Materials" />',
                                      f'<ParameterList name="Materials">{answer.output[start:end]}</ParameterList>')
                self.assertNotEqual(pasted, text)
                check = rhegma(self.write("scene.xml", pasted), "--check")
                self.assertEqual(check.status, 0, check)
                ElementTree.fromstring(f"<all>{answer.output}</all>")  # its comments are XML, too
                for one in MATERIALS[name]:
                    if one.tag == "Parameter":
                        self.assertIn(one.get("source"), answer.output)

    def test_unknown_name(self):
        self.assert_refused(["--materials", "PMMMA"], [("", ['no material "PMMMA"', "did you mean PMMA"])])

    def test_docs_have_the_tables(self):
        with open(os.path.join(SOURCE, "docs", "reference", "materials.md"), encoding="utf-8") as file:
            page = file.read()
        answer = rhegma("--materials-markdown")
        self.assertEqual(answer.status, 0, answer)
        self.assertIn(answer.output, page)
        self.assertEqual(answer.output.count("\n") - 2, len(MATERIALS))
        for name in MATERIALS:
            self.assertIn(f"\n| {name} | ", answer.output)
        self.assertLessEqual(len(page.splitlines()), 250)


del ProgramTest
if __name__ == "__main__":
    unittest.main()
