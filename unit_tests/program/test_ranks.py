#!/usr/bin/env python3
"""A run on several ranks gives what one rank gives, up to round-off that has grown."""

import json
import os
import signal
import subprocess
import sys
import time
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

import h5py  # noqa: E402
import numpy  # noqa: E402
from program import PATIENCE, PROGRAM, SOURCE, environment, rhegma  # noqa: E402
from ranks import LAUNCHER, ROOT, OnRanks  # noqa: E402
from scenes import ball, plate  # noqa: E402


def whole_plate():
    """The plate without its notch."""
    scene = plate().remove("Cracks").remove("Energy Release")
    return scene


def held_plate():
    """Everything that the method's own boundaries offer, and damping."""
    scene = whole_plate()
    scene.set("Boundaries > Weight", {"Type": "Gravity", "Acceleration": [30.0, -981.0]})
    scene.set("Boundaries > Wall", {"Type": "Symmetry", "Axis": "x", "Position": 0.0})
    scene.set(
        "Boundaries > Grip",
        {
            "Type": "Velocity",
            "Lower Corner": [-0.1, 0.9],
            "Upper Corner": [0.3, 1.1],
            "Components": "y",
            "Value": [0.0, 0.2],
        },
    )
    scene.set("Damping", {"Mass Rate": 200.0, "Shear Viscosity": 1000.0})
    return scene


def flying_plate():
    """It turns and flies through half of the domain, so that ranks hand on all that they have."""
    scene = whole_plate().remove("Boundaries")
    scene.set("Domain > Upper Corner", [3.0, 1.6])
    scene.set("Domain > Lower Corner", [-0.6, -0.6])
    scene.set("Bodies > Plate > Velocity", [300.0, 0.0])
    scene.set("Bodies > Plate > Angular Velocity", [200.0])
    scene.set("Time > Final Time", 6e-3)
    return scene


class Ranks(OnRanks):
    def test_loads_supports_and_damping(self):
        self.agree(self.write(held_plate()))

    def test_linear_functions_and_usf(self):
        scene = held_plate().set("Domain > Shape Functions", "Linear").set("Time > Update Scheme", "USF")
        self.agree(self.write(scene), ranks=(3,))

    def test_particles_that_change_ranks(self):
        fields = self.agree(self.write(flying_plate()))
        self.assertGreater(numpy.min(fields["displacement"][:, 0]), 0.5, "the plate has not flown")

    def test_ranks_with_less_to_do_get_more(self):
        """A body that flies out of the boxes of its ranks; alone on one of them it is four times as much as the mean."""
        scene = flying_plate().set("Domain > Cell Size", 0.02)
        scene.set("Load Balance", {"Threshold": 1000.0})
        left = self.run_on(4, self.write(scene))[0]["load_balance"]
        self.assertEqual(left["divisions"], 0)
        self.assertGreater(left["largest_imbalance"], 1.5)
        scene.set("Load Balance > Threshold", 1.05)
        self.agree(self.write(scene), ranks=(4,))
        with open(os.path.join(self.folder, "on4", "summary.json"), encoding="utf-8") as file:
            balanced = json.load(file)
        self.assertGreater(balanced["load_balance"]["divisions"], 1)
        self.assertLess(balanced["load_balance"]["imbalance"], 1.1)
        self.assertLess(balanced["load_balance"]["largest_imbalance"], 1.2)

    def test_columns_and_rows_of_cells(self):
        """Cuts on the first or last cells of a body; each particle is on one rank all the same."""
        for wide, ranks in ((0.05, (2, 3)), (0.1, (3, 5)), (0.2, (5, 8))):
            for size in ([wide, 1.0], [1.0, wide]):
                scene = whole_plate().remove("Boundaries").set("Bodies > Plate > Upper Corner", size)
                scene.set("Bodies > Plate > Angular Velocity", [50.0])
                self.agree(self.write(scene), "--set", "Time:Maximum Steps=10", ranks=ranks)

    def test_velocities_that_jump_at_a_position(self):
        """A node on two ranks is on one side of the jump."""
        scene = whole_plate().remove("Boundaries")
        jump = {"Type": "Velocity", "Field": "x < 0.65 ? 0.5 : 0, 0", "Components": "x"}
        corners = {"Lower Corner": [0.0, 0.0], "Upper Corner": [1.0, 0.2]}
        self.agree(self.write(scene.set("Boundaries", {"Jump": {**jump, **corners}})), ranks=(2, 3, 4))

    def test_a_history_that_can_not_be_made(self):
        out = os.path.join(self.folder, "out")
        os.makedirs(os.path.join(out, "history.csv", "in the way"))
        scene = self.write(whole_plate())
        answer = rhegma(scene, "--output", out, launcher=(*LAUNCHER, "-np", "3"), **ROOT)
        self.assertEqual(answer.status, 1, answer)
        self.assertEqual(answer.messages.count("rhegma:"), 1, answer)

    def test_a_scene_that_one_rank_can_not_read(self):
        scene = self.write(whole_plate())
        launcher = (*LAUNCHER, "-np", "1", PROGRAM, scene, ":", "-np", "1")
        answer = rhegma(os.path.join(self.folder, "missing.xml"), launcher=launcher, **ROOT)
        self.assertEqual(answer.status, 1, answer)
        self.assertIn("does not exist", answer.messages)

    def test_more_ranks_than_cells_along_the_body(self):
        self.agree(self.write(whole_plate()), "--set", "Time:Maximum Steps=20", ranks=(12,))

    def test_three_dimensions(self):
        scene = ball().set("Bodies > Ball > Velocity", [40.0, 10.0, -20.0])
        scene.set("Bodies > Ball > Angular Velocity", [0.0, 300.0, 100.0])
        self.agree(self.write(scene))

    def test_heat(self):
        """Conduction, a source that moves, a surface and thermal strain, in a plate that flies from rank to rank."""
        scene = flying_plate()
        for name, value in (("Specific Heat", 1400.0), ("Conductivity", 2e5), ("Thermal Expansion", 7e-5)):
            scene.set("Materials > Polymer > " + name, value)
        scene.set("Boundaries", {"Air": {"Type": "Convection", "Body": "Plate", "From": [1.0, 0.0], "To": [1.0, 1.0],
                                         "Coefficient": 1e6, "Ambient Temperature": 250.0}})
        spot = {"Type": "Ball", "Centre": [0.5, 0.5], "Velocity": [250.0, 0.0], "Radius": 0.2, "Power": 1e9}
        scene.set("Thermal", {"Initial Temperature": 300.0, "Sources": {"Spot": spot},
                              "Probes": {"Ahead": {"Point": [1.6, 0.5]}}})
        self.agree(self.write(scene))

    def test_rubber(self):
        scene = os.path.join(SOURCE, "xml_inputs", "verification", "rubber_bar.xml")
        self.agree(scene, "--set", "Time:Maximum Steps=100", ranks=(2,))

    def test_a_signal_to_one_rank_stops_all(self):
        scene = self.write(whole_plate().set("Time > Final Time", 10.0).set("Output", {"History Interval": 1e-3}))
        run = subprocess.Popen(
            [*LAUNCHER, "-np", "3", PROGRAM, scene, "--output", os.path.join(self.folder, "out")],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            env=environment(ROOT),
        )
        self.addCleanup(run.stdout.close)
        self.addCleanup(run.stderr.close)
        self.addCleanup(run.kill)
        history = os.path.join(self.folder, "out", "history.csv")
        for _ in range(10 * PATIENCE):
            time.sleep(0.1)
            if os.path.exists(history) and os.path.getsize(history) > 0:
                break
        children = subprocess.run(["pgrep", "-P", str(run.pid)], stdout=subprocess.PIPE, check=True).stdout.split()
        self.assertEqual(len(children), 3)
        os.kill(int(children[-1]), signal.SIGTERM)
        _, messages = run.communicate(timeout=PATIENCE)
        self.assertEqual(run.returncode, 2, messages)
        self.assertEqual(messages.decode().count("the run was stopped by SIGTERM"), 1, messages)
        with open(os.path.join(self.folder, "out", "summary.json"), encoding="utf-8") as file:
            self.assertIn("SIGTERM", json.load(file)["status"])

    def test_a_run_that_bursts_says_so_once(self):
        scene = whole_plate().set("Boundaries > Pull > Stress", [1e13, 0.0]).set("Time > Retries", 0)
        answer = rhegma(self.write(scene), "--quiet", launcher=(*LAUNCHER, "-np", "3"), **ROOT)
        self.assertEqual(answer.status, 2, answer)
        self.assertEqual(answer.messages.count("the run stopped at t ="), 1, answer)


class Fields(OnRanks):
    """All ranks write into one file, of whose layout the first one sees."""

    def scene(self):
        scene = plate().set("Time > Final Time", 1e-2)
        return self.write(scene.set("Output", {"History Interval": 1e-3, "Field Interval": 2e-4}))

    def test_meshes_are_whole(self):
        path, times = self.scene(), ("--set", "Time:Final Time=4e-4")
        for count in (1, 3):
            self.run_on(count, path, *times)
            with h5py.File(os.path.join(self.folder, f"on{count}", "fields.h5"), "r") as file:
                self.assertEqual(sorted(file), ["t00000", "t00001", "t00002"])
                meshes = file["t00002"]
                self.assertEqual(sorted(meshes), ["cracks", "leaves", "particles"])
                particles, cells = meshes["particles"], meshes["leaves"]
                self.assertEqual(len(particles["position"]), 1600)
                self.assertEqual(sorted(particles["cells"][()].ravel()), list(range(1600)))
                self.assertLess(numpy.max(cells["cells"][()]), len(cells["points"]))

    def test_a_full_disk(self):
        disk = os.path.join(self.folder, "disk")
        os.mkdir(disk)
        mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=1500k", "rhegma-test", disk], capture_output=True)
        if mounted.returncode != 0:
            self.skipTest("only root can mount a small disk here: " + mounted.stderr.decode().strip())
        self.addCleanup(subprocess.run, ["umount", disk], check=True)
        out = os.path.join(disk, "out")
        answer = rhegma(self.scene(), "--output", out, "--quiet", launcher=(*LAUNCHER, "-np", "3"), **ROOT)
        self.assertEqual(answer.status, 2, answer)
        ours = [line for line in answer.messages.splitlines() if line.startswith("rhegma:")]
        self.assertEqual(len(ours), 1, answer)
        self.assertIn(os.path.join(out, "fields.h5") + " can't be written; is the disk full", ours[0])
        with h5py.File(os.path.join(out, "fields.h5"), "r") as file:
            self.assertGreaterEqual(len(file), 1)
            for snapshot in file.values():
                self.assertEqual(len(snapshot["particles"]["position"]), 1600)
                self.assertTrue(numpy.all(snapshot["particles"]["mass"][()] > 0.0))


if __name__ == "__main__":
    unittest.main()
