#!/usr/bin/env python3
"""Cells that refine, and particles that split and merge, give on several ranks what they give on one."""

import json
import os
import sys
import unittest
import xml.etree.ElementTree as ElementTree

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

import h5py  # noqa: E402
import numpy  # noqa: E402
from program import SOURCE  # noqa: E402
from ranks import OnRanks  # noqa: E402
from scenes import plate  # noqa: E402
from test_ranks_of_effects import block, turned_plate  # noqa: E402

# What is asked for; a particle in small cells sees more sums than one in large ones.
SAME = 1e-9

BOX = {"Maximum Level": 2, "Middle": {"Lower Corner": [0.4, 0.1], "Upper Corner": [0.7, 0.5], "Level": 2}}


def body():
    """A plate without a crack that flies and turns through cells refined where ranks meet."""
    scene = turned_plate().remove("Cracks")
    scene.set("Domain > Upper Corner", [1.8, 1.4]).set("Domain > Lower Corner", [-0.4, -0.4])
    return scene


class Cells(OnRanks):
    def adaptivity(self, name):
        with open(os.path.join(self.folder, name, "summary.json"), encoding="utf-8") as file:
            return json.load(file)["adaptivity"]

    def same_cells(self, ranks):
        one = self.adaptivity("on1")
        for count in ranks:
            self.assertEqual(self.adaptivity(f"on{count}"), one)
        return one

    def test_a_body_at_rest_in_cells_of_three_sizes(self):
        scene = plate().remove("Cracks").remove("Energy Release").set("Adaptivity", BOX)
        self.agree(self.write(scene), within=SAME)
        self.assertGreater(self.same_cells((2, 3, 4))["particles_added"], 100)

    def test_a_body_that_splits_and_merges_as_it_moves(self):
        """Its particles change their ranks and their sizes, families across ranks become one again."""
        self.agree(self.write(body().set("Adaptivity", BOX)), "--set", "Output:Checkpoint Interval=1.0", within=SAME)
        self.assertGreater(self.same_cells((2, 3, 4))["families_merged"], 20)
        for count in (1, 2, 3, 4):
            # What splits takes ids that are free on all ranks.
            with h5py.File(os.path.join(self.folder, f"on{count}", "checkpoint.h5"), "r") as file:
                ids = file["particles"]["id"][()].ravel()
            self.assertEqual(len(set(ids)), len(ids), f"{count} ranks")

    def test_cells_that_follow_what_moves(self):
        """The same, divided anew whenever ranks have more to do than others."""
        path = os.path.join(SOURCE, "xml_inputs", "examples", "hot_spot.xml")
        self.agree(path, "--set", "Time:Final Time=3", "--set", "Domain:Cell Size=0.005", ranks=(3,), within=SAME)
        one = self.same_cells((3,))
        self.assertGreater(one["families_merged"], 50)
        self.assertGreater(one["changes_of_cells"], 10)

    def test_cells_of_ranks_that_change(self):
        scene = body().set("Adaptivity", BOX).set("Load Balance", {"Threshold": 1.05, "Interval": 5})
        self.agree(self.write(scene), ranks=(4,), within=SAME)
        self.same_cells((4,))

    def test_three_dimensions(self):
        corners = {"Lower Corner": [0.4, 0.2, 0.0], "Upper Corner": [0.7, 0.6, 0.5], "Level": 1}
        scene = block().remove("Cracks").set("Adaptivity", {"Maximum Level": 1, "Middle": corners})
        self.agree(self.write(scene), ranks=(3,), within=SAME)
        self.assertGreater(self.same_cells((3,))["particles_added"], 100)


class CracksInThem(OnRanks):
    def test_a_notch_in_smaller_cells(self):
        scene = plate().set("Adaptivity", {"Maximum Level": 2})
        scene.set("Energy Release > Crack Closure", True)
        self.agree(self.write(scene), within=SAME)

    def test_a_crack_that_moves_through_cells_and_ranks(self):
        fields = self.agree(self.write(turned_plate().set("Adaptivity", {"Maximum Level": 1})), ranks=(3, 4), within=SAME)
        self.assertTrue(numpy.any(fields["side"] > 0) and numpy.any(fields["side"] < 0))

    def test_a_mass_that_is_unlumped_where_ranks_meet(self):
        """Of a node that particles of one rank alone couple, the lumped mass is its owner's."""
        path = os.path.join(SOURCE, "xml_inputs", "verification", "dcb_adaptive_partial.xml")
        scene = plate()
        scene.root = ElementTree.parse(path).getroot()
        self.agree(self.write(scene.remove("Sub-Cycling")), "--set", "Time:Maximum Steps=60", ranks=(4,), within=SAME)


class Substeps(OnRanks):
    """Whether a particle takes them must not hang on round-off, or the ranks' motions differ at once."""

    def agree_in_steps(self, scene, **options):
        self.agree(self.write(scene), within=SAME, **options)
        extra = {}
        for name in sorted(os.listdir(self.folder)):
            if name.startswith("on"):
                with open(os.path.join(self.folder, name, "summary.json"), encoding="utf-8") as file:
                    extra[name] = json.load(file)["subcycling"]["extra_particle_steps"]
        self.assertGreater(extra["on1"], 0)
        self.assertEqual(set(extra.values()), {extra["on1"]})

    def test_a_body_in_flight_and_rotation(self):
        self.agree_in_steps(body().set("Adaptivity", BOX).set("Sub-Cycling", {"Levels": 2}))

    def test_a_body_that_its_motion_warms(self):
        scene = body().set("Adaptivity", BOX).set("Sub-Cycling", {"Levels": 2}).set("Thermal", {"Initial Temperature": 300.0})
        for name, value in (("Specific Heat", 1400.0), ("Conductivity", 2e3), ("Thermal Expansion", 7e-5)):
            scene.set(f"Materials > Polymer > {name}", value)
        self.agree_in_steps(scene, ranks=(3,))

    def test_ranks_that_change(self):
        """The means of forces go with the nodes to their new ranks."""
        scene = body().set("Adaptivity", BOX).set("Sub-Cycling", {"Levels": 2})
        self.agree_in_steps(scene.set("Load Balance", {"Threshold": 1.05, "Interval": 5}), ranks=(4,))

    def test_a_notch_with_springs(self):
        self.agree_in_steps(plate().set("Adaptivity", {"Maximum Level": 2}).set("Sub-Cycling", {"Levels": 2}))

    def test_a_mass_that_is_partly_unlumped(self):
        """J apart, which `CracksInThem` compares."""
        scene = plate().set("Adaptivity", {"Maximum Level": 2}).set("Sub-Cycling", {"Levels": 2})
        scene.remove("Energy Release").set("Mass Matrix", {"Type": "Partial", "Solver Tolerance": 1e-12})
        self.agree_in_steps(scene.set("Time > Maximum Steps", 40), ranks=(3,))

    def test_contact_that_follows_the_nodes(self):
        path = os.path.join(SOURCE, "xml_inputs", "verification", "contact_slap_adaptive.xml")
        self.agree(path, "--set", "Time:Maximum Steps=60", ranks=(2,), within=1e-8)

    def test_contact_on_the_line_where_ranks_part(self):
        """Pulses from both ends meet in the closed crack at mid-length: it stays there, and so does momentum."""
        scene = plate()
        scene.root = ElementTree.parse(os.path.join(SOURCE, "xml_inputs", "verification", "contact_pulse_adaptive.xml")).getroot()
        pulse = scene.find("Boundaries > Pulse").find("Parameter[@name='History']").get("value")
        scene.set("Boundaries > Other Pulse", {"Type": "Traction", "Body": "Bar", "From": [0.0, 0.08], "To": [0.004, 0.08]})
        scene.set("Boundaries > Other Pulse > Stress", [0.0, -1e5]).set("Boundaries > Other Pulse > History", pulse)
        path = self.write(scene.remove("Reference"))
        self.agree(path, "--set", "Time:Final Time=2.5e-5", ranks=(2,), within=1e-8, columns=lambda name: "momentum" not in name)
        for count in (1, 2):
            summary, history, _ = self.run_on(count, path, "--set", "Time:Final Time=2.5e-5")
            given = numpy.max(numpy.abs(history["Pulse.force_y"])) * 8.7e-6
            self.assertLess(numpy.max(numpy.abs(history["momentum_y"])), 1e-12 * given, f"{count} ranks")

    def test_three_dimensions(self):
        corners = {"Lower Corner": [0.4, 0.2, 0.0], "Upper Corner": [0.7, 0.6, 0.5], "Level": 1}
        scene = block().remove("Cracks").set("Adaptivity", {"Maximum Level": 1, "Middle": corners})
        self.agree_in_steps(scene.set("Sub-Cycling", {"Levels": 1}), ranks=(3,))


if __name__ == "__main__":
    unittest.main()
