#!/usr/bin/env python3
"""Bodies whose shape comes from a file: the same results as of other shapes, and messages for wrong files."""

import json
import os
import random
import shutil
import subprocess
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

import h5py  # noqa: E402
import numpy  # noqa: E402
from part_files import ascii_stl, binary_stl, bracket, brick  # noqa: E402
from program import PATIENCE, PROGRAM, SOURCE, ProgramTest, rhegma  # noqa: E402
from ranks import LAUNCHER, ROOT, ROUND_OFF  # noqa: E402
from scenes import Scene, ball, plate  # noqa: E402

LOW, HIGH = [0.0, 0.0, 0.0], [0.012, 0.006, 0.01]


def cracked_block(shape):
    """A block with an edge crack through its thickness, pulled in static equilibrium. shape: parameters of the body"""
    return Scene({
        "Domain": {"Dimension": 3, "Lower Corner": [-0.003] * 3, "Upper Corner": [0.015, 0.009, 0.013], "Cell Size": 0.001},
        "Time": {"Analysis": "Static", "Final Time": 1e-3},
        "Materials": {"Polymer": {"Model": "Linear Elastic", "Density": 1200.0, "Young Modulus": 3e9, "Poisson Ratio": 0.3}},
        "Bodies": {"Block": {"Material": "Polymer", **shape}},
        "Boundaries": {
            "Foot": {"Type": "Velocity", "Lower Corner": [-0.003, -0.003, -0.003], "Upper Corner": [0.015, 0.009, 0.0], "Value": [0.0, 0.0, 0.0]},
            "Pull": {"Type": "Traction", "Body": "Block", "Corner": [0.0, 0.0, 0.01], "Edge 1": [0.012, 0.0, 0.0], "Edge 2": [0.0, 0.006, 0.0],
                     "Stress": [0.0, 0.0, 1e6]}},
        "Cracks": {"Notch": {"Points": [0.0, 0.0, 0.0053, 0.0053, 0.0, 0.0053, 0.0053, 0.006, 0.0053, 0.0, 0.006, 0.0053]}},
        "Energy Release": {},
    })


def box():
    return {"Shape": "Box", "Lower Corner": LOW, "Upper Corner": HIGH}


def falling(path, **more):
    """The falling ball as a part from a file."""
    return ball().set("Bodies > Ball", {"Material": "Rubber", "Shape": "File", "File": path, **more})


class PartsTest(ProgramTest):
    def stl(self, name, content):
        with open(self.path(name), "wb") as file:
            file.write(content if isinstance(content, bytes) else content.encode())
        return name

    def run_scene(self, name, scene, *arguments, **more):
        path = self.write(name + ".xml", scene.text())
        answer = rhegma(path, "--output", self.path(name), "--quiet", *arguments, **more)
        self.assertEqual(answer.status, 0, answer)
        with open(self.path(name, "summary.json"), encoding="utf-8") as file:
            return json.load(file), answer

    def checked(self, scene):
        """What --check says on standard error."""
        self.write("checked.xml", scene.text())
        answer = rhegma("checked.xml", "--check", cwd=self.folder)
        self.assertEqual(answer.status, 0, answer)
        return answer.messages + answer.output


class SameResults(PartsTest):
    def test_energy_release_rate_of_a_block(self):
        """Triangles in any order, some of them turned round: G is that of a Box."""
        seed = random.randrange(2**32)
        print(f"{self.id()}: seed {seed}", file=sys.stderr)
        chance = numpy.random.default_rng(seed)
        triangles = chance.permutation(brick(LOW, HIGH))
        turned = chance.choice(12, 3, replace=False)
        triangles[turned] = triangles[turned][:, ::-1]
        self.stl("block.stl", ascii_stl(triangles))
        wanted, _ = self.run_scene("box", cracked_block(box()))
        found, _ = self.run_scene("part", cracked_block({"Shape": "File", "File": "block.stl"}))
        self.assertIn("3 triangles", " ".join(found["warnings"]))
        of = lambda summary: summary["cracks"][0]["fronts"][0]["G_J"]  # noqa: E731
        self.assertGreater(of(wanted), 0.0)
        self.assertAlmostEqual(of(found) / of(wanted), 1.0, delta=1e-12)

    def test_plane_bodies(self):
        """The notched plate from a file of polygons; and a hole is a polygon inside another."""
        self.write("plate.txt", "# a plate\n0 0\n1 0\n1 1\n0 1\n")
        wanted, _ = self.run_scene("box", plate())
        shape = {"Material": "Polymer", "Shape": "File", "File": "plate.txt"}
        found, _ = self.run_scene("part", plate().set("Bodies > Plate", shape))
        self.assertEqual(found["cracks"], wanted["cracks"])
        self.write("plate.txt", "0 0\n1 0\n1 1\n0 1\n\n0.7 0.1\n0.9 0.1\n0.9 0.3\n0.7 0.3\n")
        scene = plate().remove("Cracks").remove("Energy Release").set("Bodies > Plate", shape)
        hole, _ = self.run_scene("hole", scene)
        self.assertEqual(wanted["particles"] - hole["particles"], 4 * 4 * 4)  # of cells of 0.05, four particles each

    @unittest.skipUnless(shutil.which("mpirun"), "without mpirun")
    def test_on_two_ranks(self):
        self.stl("part.stl", binary_stl(bracket(50.0, 12.0, 40.0)))
        scene = falling("part.stl", Scale=1e-3, Origin=[-0.05, -0.05, -0.02], Rotation=27.0)
        scene.set("Output", {"Fields": True})
        self.run_scene("one", scene)
        self.run_scene("two", scene, launcher=(*LAUNCHER, "-np", "2"), **ROOT)
        energies = []
        for name in ("one", "two"):
            with open(self.path(name, "summary.json"), encoding="utf-8") as file:
                energies.append(json.load(file)["energy"])
        for kind in ("kinetic", "strain", "external_work"):
            self.assertAlmostEqual(energies[1][kind], energies[0][kind], delta=ROUND_OFF * energies[0]["external_work"])

    def test_a_run_goes_on_from_its_checkpoint(self):
        self.stl("part.stl", binary_stl(bracket(50.0, 12.0, 40.0)))
        scene = falling("part.stl", Scale=1e-3, Origin=[-0.05, -0.05, -0.02])
        scene.set("Output", {"Checkpoint Interval": 2e-4})
        self.run_scene("whole", scene)
        self.run_scene("broken", scene, "--set", "Time:Final Time=5e-4")
        elsewhere = self.path("elsewhere")  # from which the path of the file is another one
        os.mkdir(elsewhere)
        answer = rhegma(os.path.join("..", "broken.xml"), "--output", self.path("broken"), "--quiet", "--restart",
                        self.path("broken", "checkpoint.h5"), cwd=elsewhere)
        self.assertEqual(answer.status, 0, answer)
        final = []
        for name in ("whole", "broken"):
            with h5py.File(self.path(name, "checkpoint.h5"), "r") as file:
                final.append(file["run"].attrs["time"])
        self.assertEqual(final[0], final[1])
        with open(self.path("whole", "history.csv")) as whole, open(self.path("broken", "history.csv")) as broken:
            rows = [[float(x) for x in file.read().splitlines()[-1].split(",")[:2]] for file in (whole, broken)]
        numpy.testing.assert_allclose(rows[1], rows[0], rtol=ROUND_OFF)  # the first part ends with a shorter step


class Messages(PartsTest):
    def test_wrong_files(self):
        """Each ends with one sentence that says what is wrong, and where."""
        triangles = brick([-0.05] * 3, [0.05] * 3)
        broken = triangles.copy()
        broken[4, 1, 2] = numpy.nan
        other = brick([0.0, -0.01, -0.02], [0.06, 0.03, 0.04])
        for name, content, words in (
                ("empty", b"", ["the file is empty"]),
                ("letter", b"Dear reader, this is no part. " * 10, ["is no STL file"]),
                ("open", binary_stl(triangles[:-1]), ["not closed", "3 edges belong to one triangle only", "across"]),
                ("overlap", binary_stl(numpy.concatenate([triangles, other])), ["two of its shells touch or overlap", "such as near ("]),
                ("number", binary_stl(broken), ["triangle 5 has a coordinate that is no number"]),
                ("short", binary_stl(triangles)[:-20], ["cut short"]),
        ):
            self.stl(name + ".stl", content)
            for arguments in ([], ["--check"]):
                self.write("scene.xml", falling(name + ".stl").text())
                self.assert_refused(["scene.xml", *arguments], [("Bodies > Ball > File", [name + ".stl: ", *words])])
        self.write("scene.xml", falling("none.stl").text())
        self.assert_refused(["scene.xml"], [("Bodies > Ball > File", ["none.stl: there is no such file"])])
        self.write("scene.xml", falling("part.step").text())
        self.assert_refused(["scene.xml"], [("Bodies > Ball > File", [".stl or .obj"])])

    def test_a_triangle_turned_round_is_mended(self):
        triangles = brick([-0.05] * 3, [0.05] * 3)
        triangles[6] = triangles[6][::-1]
        self.stl("part.stl", binary_stl(triangles))
        text = self.checked(falling("part.stl"))
        self.assertIn("Bodies > Ball > File: part.stl: 1 triangle, at (", text)
        self.assertIn("was oriented against the triangles around and turned", text)

    def test_millimetres(self):
        """A file in millimetres without a scale: refused if it does not fit, a question if it does."""
        self.stl("part.stl", binary_stl(brick([-50.0] * 3, [50.0] * 3)))
        self.write("scene.xml", falling("part.stl").text())
        self.assert_refused(["scene.xml"], [("Bodies > Ball > Scale", ["numbers of the file are metres", "100 m along x", "write Scale = 0.001"])])
        scene = falling("part.stl").set("Domain", {"Dimension": 3, "Lower Corner": [-100.0] * 3, "Upper Corner": [100.0] * 3, "Cell Size": 20.0})
        self.assertIn("Bodies > Ball > Scale: without it, numbers of the file are metres, so the shape is 100 x 100 x 100 m; "
                      "is the file in millimetres?", self.checked(scene))
        self.assertNotIn("Scale", self.checked(scene.set("Bodies > Ball > Scale", 1.0)))
        self.assertNotIn("Scale", self.checked(falling("part.stl").raw("Bodies > Ball > Scale", "string", "1 mm")))

    def test_wrong_polygons(self):
        self.write("bow.txt", "0 0\n1 1\n1 0\n0 0.9\n")
        self.write("scene.xml", plate().set("Bodies > Plate", {"Material": "Polymer", "Shape": "File", "File": "bow.txt"}).text())
        self.assert_refused(["scene.xml"], [("Bodies > Plate > File", ["bow.txt: the polygon that begins at line 1 meets itself"])])


class Pictures(PartsTest):
    def test_a_scene_is_drawn(self):
        self.stl("part.stl", ascii_stl(bracket(50.0, 12.0, 40.0)))
        scene = self.write("scene.xml", falling("part.stl", Scale=1e-3, Origin=[-0.05, -0.05, -0.02], Rotation=10.0).text())
        picture = self.path("scene.png")
        tool = os.path.join(SOURCE, "tools", "rhegma-plot")
        done = subprocess.run([sys.executable, tool, "--scene", scene, "--rhegma", PROGRAM, "--output", picture], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, timeout=PATIENCE, check=False)
        self.assertEqual(done.returncode, 0, done.stdout.decode())
        self.assertGreater(os.path.getsize(picture), 10000)


if __name__ == "__main__":
    unittest.main()
