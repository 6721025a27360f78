#!/usr/bin/env python3
"""Cracks and what goes with them give on several ranks what they give on one."""

import json
import os
import sys
import unittest
import xml.etree.ElementTree as ElementTree

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

import numpy  # noqa: E402
from program import SOURCE  # noqa: E402
from ranks import WITH_SPRINGS, OnRanks  # noqa: E402
from scenes import plate  # noqa: E402


def turned_plate():
    """The notch goes through all of the domain's middle, where ranks meet; the plate turns and flies."""
    scene = plate().remove("Boundaries").remove("Energy Release")
    scene.set("Domain > Upper Corner", [2.0, 1.6]).set("Domain > Lower Corner", [-0.6, -0.6])
    scene.set("Cracks > Notch > Points", [0.0, 0.43, 0.35, 0.43, 0.62, 0.61])
    scene.set("Bodies > Plate > Velocity", [200.0, 0.0]).set("Bodies > Plate > Angular Velocity", [200.0])
    return scene.set("Time > Final Time", 3e-3)


def block():
    """A block in three dimensions with a crack from one face to its middle."""
    scene = plate().remove("Energy Release")
    scene.set("Domain", {"Dimension": 3, "Lower Corner": [-0.2] * 3, "Upper Corner": [1.2, 1.2, 0.8]})
    scene.set("Domain > Cell Size", 0.1)
    scene.set("Bodies > Plate > Lower Corner", [0.0] * 3).set("Bodies > Plate > Upper Corner", [1.0, 1.0, 0.6])
    corners = [-0.1, 0.51, -0.1, 0.5, 0.51, -0.1, 0.5, 0.51, 0.7, -0.1, 0.51, 0.7]
    scene.set("Cracks", {"Notch": {"Points": corners}})
    scene.remove("Boundaries").set("Bodies > Plate > Angular Velocity", [0.0, 0.0, 100.0])
    return scene


def burning(scene, **ignition):
    """A flame that spreads over the notch while gas flows out of its mouth."""
    flame = {"Burn Law": "Vieille", "Burn Coefficient": 1e-5, "Burn Exponent": 0.7, "Gas Constant": 320.0,
             "Flame Temperature": 2500.0, "Initial Temperature": 300.0, "Initial Pressure": 2e5, "Outside Pressure": 1e5,
             "Initial Gap": 1e-3, "Flame Speed": 200.0, "Venting": True}
    return scene.set("Combustion", {"Notch": {**flame, **ignition}})


class Cracks(OnRanks):
    def test_a_notch_its_energy_release_and_its_closure(self):
        self.agree(self.write(plate().set("Energy Release > Crack Closure", True)))

    def test_update_schemes_and_functions(self):
        for scheme, functions in (("USF", "Linear"), ("USL", "GIMP"), ("USAVG", "GIMP")):
            scene = plate().set("Time > Update Scheme", scheme).set("Domain > Shape Functions", functions)
            self.agree(self.write(scene), ranks=(3,), within=WITH_SPRINGS)

    def test_without_springs(self):
        self.agree(self.write(plate().set("Cracks > Front Springs", False)), ranks=(2,))

    def test_cells_that_are_cut(self):
        for formulation in ("Broken Cell", "Corrected Broken Cell"):
            scene = plate().set("Cracks > Formulation", formulation)
            scene.set("Cracks > Notch > Points", [0.0, 0.43, 0.3, 0.43, 0.55, 0.52])
            scene.remove("Energy Release")
            self.agree(self.write(scene))

    def test_cracks_that_cross_ranks_as_they_move(self):
        fields = self.agree(self.write(turned_plate()))
        self.assertGreater(numpy.min(fields["displacement"][:, 0]), 0.2, "the plate has not flown")
        self.assertTrue(numpy.any(fields["side"] > 0) and numpy.any(fields["side"] < 0))

    def test_cracks_of_ranks_that_change(self):
        scene = turned_plate().set("Load Balance", {"Threshold": 1.05, "Interval": 5})
        self.agree(self.write(scene), ranks=(4,))

    def test_three_dimensions(self):
        self.agree(self.write(block()))


class BetweenFaces(OnRanks):
    def test_pressure_on_faces(self):
        scene = plate().remove("Boundaries").set("Face Pressure", {"Notch": {"Pressure": "1e5 * sin(3000 * t)"}})
        self.agree(self.write(scene))

    def test_pressure_in_three_dimensions(self):
        scene = block().set("Face Pressure", {"Notch": {"Pressure": "1e5"}})
        self.agree(self.write(scene), ranks=(3,))

    def test_contact(self):
        for law in ({"Law": "Coulomb", "Friction Coefficient": 0.3}, {"Law": "Stick"}):
            scene = plate().remove("Energy Release").set("Contact", law)
            scene.set("Cracks > Notch > Points", [0.5, -0.1, 0.5, 0.7])
            scene.set("Boundaries > Pull > Stress", [-1e6, 3e5])
            # Points that are about to slip do so a little more or less: the motion is as stable as before, but
            # stresses next to the crack hang on what last digits made of it.
            self.agree(self.write(scene), "--set", "Time:Maximum Steps=60", within=1e-8)

    def test_contact_by_visibility(self):
        scene = plate().remove("Energy Release").set("Contact", {"Law": "Visibility"})
        scene.set("Cracks > Formulation", "Broken Cell").set("Cracks > Notch > Points", [0.5, -0.1, 0.5, 0.7])
        scene.set("Boundaries > Pull > Stress", [-1e6, 3e5])
        self.agree(self.write(scene), ranks=(2, 4))

    def test_contact_in_three_dimensions(self):
        scene = block().set("Contact", {"Law": "Coulomb", "Friction Coefficient": 0.3})
        scene.set("Bodies > Plate > Angular Velocity", [0.0, 30.0, -100.0])
        self.agree(self.write(scene), ranks=(4,))


class Burning(OnRanks):
    """Faces on all ranks burn into one gas, which has what the particles of all ranks lose."""

    def burns(self, scene, ranks):
        fields = self.agree(self.write(scene), ranks=ranks)
        self.assertGreater(numpy.max(fields["burnt_over_remaining_mass"]), 1e-3)
        for count in (1, *ranks):
            with open(os.path.join(self.folder, f"on{count}", "summary.json"), encoding="utf-8") as file:
                summary = json.load(file)
            self.assertGreater(summary["cracks"][0]["gas"]["vented_mass"], 0.0)
            # A sum of n numbers is right to n units in the last place.
            rounding = 2.3e-16 * summary["particles"]
            self.assertLess(abs(summary["combustion"]["mass_kept"] - 1.0), rounding, f"{count} ranks")

    def test_a_flame_in_a_crack_that_crosses_ranks(self):
        self.burns(burning(turned_plate(), **{"Ignition Point": [0.1, 0.43]}), (2, 3, 4))

    def test_faces_that_the_gas_warms_and_that_catch_fire_by_it(self):
        scene = burning(turned_plate(), **{"Ignition Lower Corner": [0.0, 0.3], "Ignition Upper Corner": [0.2, 0.5],
                                           "Wall Heat Fraction": 0.2, "Heat Transfer Coefficient": 1e5,
                                           "Ignition Temperature": 301.0})
        scene.set("Thermal", {"Initial Temperature": 300.0}).set("Materials > Polymer > Specific Heat", 1e3)
        self.burns(scene.set("Materials > Polymer > Conductivity", 0.2), (2, 3))

    def test_gas_that_flows_along_a_crack_that_crosses_ranks(self):
        self.burns(burning(turned_plate(), **{"Ignition Point": [0.1, 0.43], "Gas Model": "Flow"}), (2, 3))

    def test_ranks_that_change(self):
        scene = burning(turned_plate(), **{"Ignition Point": [0.1, 0.43]})
        self.burns(scene.set("Load Balance", {"Threshold": 1.05, "Interval": 5}), (4,))

    def test_three_dimensions(self):
        self.burns(burning(block(), **{"Ignition Point": [0.1, 0.51, 0.3]}), (3,))


class Propagation(OnRanks):
    """A strip whose crack runs for a third of its length."""

    def setUp(self):
        super().setUp()
        scene = os.path.join(SOURCE, "xml_inputs", "verification", "strip_running_fast.xml")
        self.strip = (scene, "--set", "Domain:Cell Size=0.00125", "--set", "Time:Final Time=1.4e-4")
        self.strip += ("--set", "Propagation:Start Time=1e-4", "--set", "Propagation:Toughness=5*(1+v/300)")

    def test_a_crack_that_runs_through_ranks(self):
        fields = self.agree(*self.strip, within=1e-9)
        self.assertTrue(numpy.any(fields["side"] != 0))
        with open(os.path.join(self.folder, "on4", "summary.json"), encoding="utf-8") as file:
            front = json.load(file)["cracks"][0]["fronts"][0]
        self.assertGreater(front["increments"], 10)

    def joining(self):
        """The notch runs into a crack across its path, in the middle of the domain, where ranks meet."""
        scene = plate().set("Cracks > Across", {"Points": [0.6, 0.13, 0.62, 0.77]})
        scene.set("Cracks > Notch > Points", [-0.1, 0.43, 0.31, 0.43])
        scene.set("Boundaries > Pull", {"Type": "Traction", "Body": "Plate", "From": [0.0, 1.0], "To": [1.0, 1.0],
                                        "Stress": [0.0, 1e6]})
        scene.set("Energy Release", {"Inner Radius": 0.06, "Outer Radius": 0.12})
        return scene.set("Propagation", {"Toughness": "20*(1 + v/200)"})

    def test_a_crack_that_joins_another(self):
        self.agree(self.write(self.joining()), within=1e-9, ranks=(2, 3))
        with open(os.path.join(self.folder, "on3", "summary.json"), encoding="utf-8") as file:
            self.assertTrue(any("joined crack Across" in w for w in json.load(file)["warnings"]))

    def test_gas_that_passes_from_one_crack_to_another(self):
        scene = burning(self.joining(), Venting=False, **{"Ignition Point": [0.1, 0.43]})
        gas = {"Burn Law": "Vieille", "Burn Coefficient": 0.0, "Burn Exponent": 1.0, "Gas Constant": 320.0,
               "Flame Temperature": 2500.0, "Initial Gap": 1e-3}
        self.agree(self.write(scene.set("Combustion > Across", gas)), within=1e-9, ranks=(3,))
        with open(os.path.join(self.folder, "on3", "summary.json"), encoding="utf-8") as file:
            summary = json.load(file)
        passed = [crack["gas"]["passed_mass"] for crack in summary["cracks"]]
        self.assertGreater(max(passed), 0.0)
        self.assertLess(abs(sum(passed)), 1e-12 * max(passed))
        self.assertLess(abs(summary["combustion"]["mass_kept"] - 1.0), 1e-12)

    def test_a_penny_that_grows(self):
        """A front in three dimensions, which sets out long before the end of its loading."""
        scene = os.path.join(SOURCE, "xml_inputs", "examples", "penny_growth.xml")
        penny = (scene, "--set", "Time:Maximum Steps=110", "--set", "Propagation:Start Time=0")
        penny += ("--set", "Propagation:Toughness=0.05*(1 + v/200)")
        one = self.run_on(1, *penny)
        area = one[1]["Penny.area"]
        self.assertGreater(area[-1], area[0])
        self.assertAlmostEqual(area[-1] / one[0]["cracks"][0]["area"], 1.0, places=12)
        for count in (2, 3):
            other = self.run_on(count, *penny)
            self.assertEqual(other[0]["ranks"], count)
            self.compare(one, other)
        with open(os.path.join(self.folder, "on3", "summary.json"), encoding="utf-8") as file:
            front = json.load(file)["cracks"][0]["fronts"][0]
        self.assertGreater(front["increments"], 10)

    def test_a_penny_that_grows_in_small_cells(self):
        """The same in cells that follow the front, with substeps, where a law that falls as faces open
        pushes two states apart, and with coupled nodes, whose solves end at 1e-12 of their right side."""
        for name, *more in (("short_steps", "Time:Maximum Steps=60"),
                            ("partial", "Time:Maximum Steps=90", "Mass Matrix:Solver Tolerance=1e-12")):
            scene = os.path.join(SOURCE, "xml_inputs", "verification", f"penny_growth_{name}.xml")
            more += ["Propagation:Start Time=0", "Propagation:Toughness=0.05*(1 + v/200)"]
            self.agree(scene, *(word for one in more for word in ("--set", one)), within=1e-9, ranks=(3,))
            with open(os.path.join(self.folder, "on3", "summary.json"), encoding="utf-8") as file:
                front = json.load(file)["cracks"][0]["fronts"][0]
            self.assertGreater(front["increments"], 10, name)

    def test_its_heat(self):
        """A front that heats its surroundings, with faces across which no heat flows."""
        scene = plate()
        scene.root = ElementTree.parse(self.strip[0]).getroot()
        for name, value in (("Specific Heat", 1400.0), ("Conductivity", 20.0)):
            scene.set("Materials > Polymer > " + name, value)
        heat = {"Initial Temperature": 300.0, "Front Heat Fraction": 0.9, "Front Radius": 0.003}
        self.agree(self.write(scene.set("Thermal", heat)), *self.strip[1:], within=1e-9, ranks=(3,))


class Heat(OnRanks):
    """Faces that conduct, also where ranks meet and where the plate turns through them."""

    def heated(self, scene, faces):
        for name, value in (("Specific Heat", 1400.0), ("Conductivity", 2e5)):
            scene.set("Materials > Polymer > " + name, value)
        scene.set("Bodies > Plate > Temperature Field", "300 + 50*x + 90*y")
        return scene.set("Thermal", {"Initial Temperature": 300.0, "Crack Faces": {"Notch": faces}})

    def test_faces_that_conduct(self):
        for faces in ({"Conduction": "Always", "Conductance": 1e6}, {"Conduction": "When Closed"}):
            fields = self.agree(self.write(self.heated(turned_plate(), faces)))
            self.assertTrue(numpy.any(fields["side"] != 0))

    def test_implicit_and_super_steps(self):
        """Solves end at 1e-8 of their right side, and those of different ranks elsewhere below that."""
        scene = self.heated(turned_plate(), {"Conduction": "Always", "Conductance": 1e6})
        scene.set("Materials > Polymer > Conductivity", 2e7).set("Thermal > Conduction", "Implicit")
        self.agree(self.write(scene), within=1e-6, ranks=(3,))
        scene.set("Thermal > Crack Faces", {}).set("Thermal > Conduction", "Super Time Stepping")
        self.agree(self.write(scene), ranks=(3,))

    def test_faces_that_conduct_3d(self):
        self.agree(self.write(self.heated(block(), {"Conduction": "Always", "Conductance": 1e6})), ranks=(3,))


class MassMatrices(OnRanks):
    """Each solve ends at 1e-12 of its right side, two a step for a hundred steps."""

    SOLVED = 2e-10

    def run_with(self, matrix, **options):
        scene = plate().remove("Energy Release").set("Mass Matrix", matrix)
        self.agree(self.write(scene), within=self.SOLVED, **options)

    def test_full(self):
        self.run_with({"Type": "Full", "Solver Tolerance": 1e-12})

    def test_full_with_heat(self):
        scene = plate().remove("Energy Release").set("Mass Matrix", {"Type": "Full", "Solver Tolerance": 1e-12})
        scene.set("Materials > Polymer > Specific Heat", 1400.0).set("Materials > Polymer > Thermal Expansion", 7e-5)
        scene.set("Thermal", {"Initial Temperature": 300.0}).set("Damping", {"Shear Viscosity": 10.0})
        # Gradients of temperatures that differ by hundredths of a kelvin have ten times the round-off.
        self.agree(self.write(scene), within=10 * self.SOLVED, ranks=(3,))

    def test_full_between_supports(self):
        scene = plate().set("Mass Matrix", {"Type": "Full", "Solver Tolerance": 1e-12, "Velocity Update": "PIC"})
        scene.set("Boundaries", {"Wall": {"Type": "Symmetry", "Axis": "x", "Position": 1.0}})
        scene.set("Bodies > Plate > Velocity", [-3.0, 1.0])
        self.agree(self.write(scene), ranks=(2, 4))

    def test_partial(self):
        self.run_with({"Type": "Partial", "Solver Tolerance": 1e-12})

    def test_series(self):
        self.run_with({"Type": "FMPM", "Order": 3}, ranks=(3,))
        self.run_with({"Type": "Lumped", "Velocity Update": "XPIC"}, ranks=(2,))

    def test_matrices_of_ranks_that_change(self):
        scene = turned_plate().remove("Cracks").set("Load Balance", {"Threshold": 1.05, "Interval": 5})
        scene.set("Mass Matrix", {"Type": "Full", "Solver Tolerance": 1e-12})
        self.agree(self.write(scene), ranks=(4,))


if __name__ == "__main__":
    unittest.main()
