#!/usr/bin/env python3
"""Bodies from images of voxels: masses, the same results as of other shapes, messages for wrong images, and images from pictures."""

import json
import os
import random
import subprocess
import sys
import unittest
import zlib

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

import numpy  # noqa: E402
from program import PATIENCE, SOURCE, ProgramTest, rhegma  # noqa: E402
from scenes import Scene  # noqa: E402

DENSITY = {"Soft": 1000.0, "Hard": 2500.0}
ROUNDING = 1e-12  # of a mass: some thousand voxels and particles are added
MESH = os.path.join(SOURCE, "tools", "rhegma-mesh")


def voxels(material, path, value, size, **more):
    return {"Material": material, "Shape": "Voxels", "File": path, "Value": value, "Voxel Size": size, **more}


def scene(bodies, upper, cell, **more):
    """Bodies between the origin and a corner, without any load."""
    margin = 3.0 * cell
    return Scene({
        "Domain": {"Dimension": len(upper), "Lower Corner": [-margin] * len(upper), "Upper Corner": [x + margin for x in upper], "Cell Size": cell},
        "Time": {"Final Time": 1e-9, "Maximum Steps": 1},
        "Materials": {name: {"Model": "Linear Elastic", "Density": density, "Young Modulus": 3e6 * density, "Poisson Ratio": 0.3}
                      for name, density in DENSITY.items()},
        "Bodies": bodies,
        **more,
    })


class VoxelTest(ProgramTest):
    def chance(self):
        seed = int(os.environ.get("RHEGMA_SEED", random.randrange(2**32)))
        print(f"{self.id()}: seed {seed}", file=sys.stderr)
        return numpy.random.default_rng(seed)

    def image(self, array, name="image.npy"):
        numpy.save(self.path(name), array)
        return name

    def run_scene(self, wanted, name="out"):
        answer = rhegma(self.write(name + ".xml", wanted.text()), "--output", self.path(name), "--quiet")
        self.assertEqual(answer.status, 0, answer)
        with open(self.path(name, "summary.json"), encoding="utf-8") as file:
            return json.load(file)

    def bodies(self, wanted):
        return {body["name"]: body for body in self.run_scene(wanted)["bodies"]}

    def assert_phase(self, body, inside, size, density, rounding=ROUNDING):
        """The mass and the centre of mass are those of the voxels."""
        self.assertAlmostEqual(body["mass"] / (density * inside.sum() * size ** inside.ndim), 1.0, delta=rounding)
        middle = size * (numpy.argwhere(inside).mean(axis=0) + 0.5)
        numpy.testing.assert_allclose(body["centre"][:inside.ndim], middle, rtol=0, atol=rounding * size * max(inside.shape))


class Masses(VoxelTest):
    def test_phases_whose_cells_are_whole_voxels(self):
        """Random phases in 3D, in cells of two voxels: particles of one voxel."""
        image = self.chance().integers(0, 2, (12, 10, 8)).astype("uint8")
        path = self.image(image)
        found = self.bodies(scene({"One": voxels("Soft", path, 0, 5e-4), "Two": voxels("Hard", path, 1, 5e-4, **{"Bonded To": "One"})},
                                  [6e-3, 5e-3, 4e-3], 1e-3))
        self.assert_phase(found["One"], image == 0, 5e-4, DENSITY["Soft"])
        self.assert_phase(found["Two"], image == 1, 5e-4, DENSITY["Hard"])

    def test_phases_whose_cells_are_no_whole_voxels(self):
        """A disk of 80 voxels, 11.4 cells across: a part of a cell has the mass of the voxels in it all the same."""
        x, y = numpy.meshgrid(numpy.arange(100) + 0.5, numpy.arange(100) + 0.5, indexing="ij")
        image = (numpy.hypot(x - 51.0, y - 49.0) < 40.0).astype("int32") * 7 - 3
        path = self.image(image)
        found = self.bodies(scene({"Out": voxels("Soft", path, -3, 1e-5), "In": voxels("Hard", path, 4, 1e-5, **{"Bonded To": "Out"})},
                                  [1e-3, 1e-3], 7e-5))
        self.assert_phase(found["Out"], image == -3, 1e-5, DENSITY["Soft"], 1e-9)
        self.assert_phase(found["In"], image == 4, 1e-5, DENSITY["Hard"], 1e-9)

    def test_any_integers(self):
        image = self.chance().integers(0, 2, (9, 7))
        for kind in ("|u1", "<u2", "<i8", ">i4", ">u8", "|b1"):
            with self.subTest(kind):
                path = self.image(image.astype(kind))
                found = self.bodies(scene({"One": voxels("Soft", path, 1, 1e-3)}, [9e-3, 7e-3], 1e-3))
                self.assert_phase(found["One"], image == 1, 1e-3, DENSITY["Soft"])

    def test_turned_phases_stay_together(self):
        """A quarter turn about the middle of the image, which both values share."""
        image = self.chance().integers(0, 2, (8, 6))
        image[2:4, 1:3] = [[0, 1], [1, 0]]  # both occur
        path = self.image(image)
        turned = {"Rotation": 90.0, "Corner": [2e-3, 1e-3]}
        found = self.bodies(scene({"One": voxels("Soft", path, 0, 1e-3, **turned), "Two": voxels("Hard", path, 1, 1e-3, **{"Bonded To": "One"}, **turned)},
                                  [12e-3, 12e-3], 1e-3))
        for name, value in (("One", 0), ("Two", 1)):
            middle = 1e-3 * (numpy.argwhere(image == value).mean(axis=0) + 0.5) + [2e-3, 1e-3]
            arm = middle - [6e-3, 4e-3]
            numpy.testing.assert_allclose(found[name]["centre"][:2], [6e-3 - arm[1], 4e-3 + arm[0]], rtol=0, atol=1e-9)


class SameResults(VoxelTest):
    def stretched(self, bodies, name):
        """Two layers that are stretched across their interface, in equilibrium."""
        wanted = scene(bodies, [8e-3, 8e-3], 1e-3, **{"Boundaries": {
            "Foot": {"Type": "Velocity", "Lower Corner": [-3e-3, -1.5e-3], "Upper Corner": [11e-3, 0.1e-3], "Value": [0.0, 0.0]},
            "Grip": {"Type": "Velocity", "Lower Corner": [-3e-3, 7.9e-3], "Upper Corner": [11e-3, 9.5e-3], "Value": [0.0, 1e-5]}}})
        wanted.set("Time", {"Analysis": "Static", "Final Time": 1.0})
        return self.run_scene(wanted, name)["energy"]["strain"]

    def test_layers_are_those_of_boxes(self):
        """Adjacent phases share one motion, as bodies that are bonded do."""
        image = numpy.zeros((16, 16), dtype="uint8")
        image[:, 6:] = 9
        path = self.image(image)
        found = self.stretched({"Low": voxels("Soft", path, 0, 5e-4), "High": voxels("Hard", path, 9, 5e-4, **{"Bonded To": "Low"})}, "voxels")
        boxes = self.stretched({
            "Low": {"Material": "Soft", "Shape": "Box", "Lower Corner": [0.0, 0.0], "Upper Corner": [8e-3, 3e-3]},
            "High": {"Material": "Hard", "Shape": "Box", "Lower Corner": [0.0, 3e-3], "Upper Corner": [8e-3, 8e-3], "Bonded To": "Low"}}, "boxes")
        self.assertGreater(found, 0.0)
        self.assertAlmostEqual(found / boxes, 1.0, delta=1e-9)  # the tolerance of the equilibrium


class WrongImages(VoxelTest):
    def assert_message(self, path, words, value=1, size=1e-3, where="File"):
        self.write("scene.xml", scene({"One": voxels("Soft", path, value, size)}, [6e-3, 6e-3], 1e-3).text())
        self.assert_refused(["scene.xml", "--output", "out"], [(f"Bodies > One > {where}", words)])

    def test_say_what_is_wrong(self):
        image = numpy.arange(36, dtype="uint8").reshape(6, 6) // 12
        self.assert_message("none.npy", ["there is no such file"])
        self.assert_message(self.image(image.astype(float)), ["<f8", "integers", "astype"])
        self.assert_message(self.image(image.astype([("a", "u1")])), ["records", "integers"])
        self.assert_message(self.image(numpy.asfortranarray(image)), ["Fortran order", "ascontiguousarray"])
        self.assert_message(self.image(image.reshape(6, 3, 2)), ["3 axes", "2D"])
        self.assert_message(self.image(image[:0]), ["no voxels"])
        self.assert_message(self.image(image), ["no voxel has the value 5", "0 (12 voxels)", "1 (12 voxels)", "2 (12 voxels)"], value=5)
        self.assert_message(self.image(image), ["above 0"], size=0.0, where="Voxel Size")
        self.assert_message(self.write("text.npy", "0 1 1 0\n"), ["no .npy file", "numpy.save"])
        with open(self.path(self.image(image)), "rb") as file:
            content = file.read()
        for length, words in ((len(content) - 1, ["cut off", "6 x 6"]), (60, ["cut off"])):
            with open(self.path("short.npy"), "wb") as file:
                file.write(content[:length])
            self.assert_message("short.npy", words)

    def test_more_voxels_than_memory(self):
        """The header of an image of 10^12 voxels, in a file without content on the disk."""
        with open(self.path(self.image(numpy.zeros((2, 2), dtype="uint8"), "large.npy")), "r+b") as file:
            head = file.read(128).replace(b"(2, 2), }" + b" " * 20, b"(1000000, 1000000), }" + b" " * 8)
            self.assertIn(b"(1000000, 1000000)", head)
            file.seek(0)
            file.write(head)
            file.truncate(128 + 10**12)
        self.write("scene.xml", scene({"One": voxels("Soft", "large.npy", 1, 1e-3)}, [6e-3, 6e-3], 1e-3).text())
        answer = rhegma("scene.xml", "--check", cwd=self.folder)
        self.assertEqual(answer.status, 1, answer)
        self.assert_messages(answer.messages, [("Bodies > One > File", ["1000000 x 1000000 voxels", "GB of memory"])])


class Pictures(VoxelTest):
    def mesh(self, *arguments, status=0):
        result = subprocess.run([sys.executable, MESH, *arguments], cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=PATIENCE,
                                text=True)
        self.assertEqual(result.returncode, status, result.stdout + result.stderr)
        return result.stdout + result.stderr

    def setUp(self):
        super().setUp()
        try:
            from PIL import Image
        except ImportError:
            self.skipTest("Pillow (python3-pil), which reads pictures, is not installed")
        self.Image = Image

    def save(self, array, name):
        self.Image.fromarray(array).save(self.path(name))
        return name

    def test_rows_of_a_picture_go_down(self):
        picture = numpy.array([[10, 20, 30], [40, 50, 60]], dtype="uint8")
        said = self.mesh(self.save(picture, "grey.png"))
        self.assertIn("3 x 2 voxels, values (voxels): 10 (1), 20 (1)", said)
        numpy.testing.assert_array_equal(numpy.load(self.path("grey.npy")), [[40, 10], [50, 20], [60, 30]])
        self.mesh("grey.png", "--thresholds", "30", "60", "-o", "three.npy")
        numpy.testing.assert_array_equal(numpy.load(self.path("three.npy")), [[1, 0], [1, 0], [2, 1]])

    def test_stacks(self):
        chance = self.chance()
        layers = chance.integers(0, 65535, (4, 5, 6)).astype("uint16")
        names = [self.save(layer, f"layer{k}.png") for k, layer in enumerate(layers)]
        expected = layers[:, ::-1, :].transpose(2, 1, 0)
        self.mesh(*names, "-o", "stack.npy")
        numpy.testing.assert_array_equal(numpy.load(self.path("stack.npy")), expected)
        small = (layers // 256).astype("uint8")
        pages = [self.Image.fromarray(layer) for layer in small]
        pages[0].save(self.path("stack.tif"), save_all=True, append_images=pages[1:])
        self.mesh("stack.tif")
        array = numpy.load(self.path("stack.npy"))
        numpy.testing.assert_array_equal(array, expected // 256)
        value = int(array[0, 0, 0])
        found = self.bodies(scene({"One": voxels("Soft", "stack.npy", value, 1e-3)}, [6e-3, 5e-3, 4e-3], 1e-3))
        self.assert_phase(found["One"], array == value, 1e-3, DENSITY["Soft"])

    def test_scenes_read_pictures(self):
        """The masses are the same as of the array that the tool makes of them, for every kind of picture."""
        chance = self.chance()
        layers = chance.integers(0, 3, (3, 5, 6)).astype("uint8") * 100
        array = layers[:, ::-1, :].transpose(2, 1, 0)
        one, deep = self.Image.fromarray(layers[0]), self.Image.fromarray(layers[0].astype("uint16") * 300)
        for name, picture in (("grey.png", one), ("grey.tif", one), ("deep.png", deep), ("DEEP.TIFF", deep), ("colours.png", one.convert("RGB")),
                              ("opaque.png", one.convert("LA")), ("bits.png", one.point(lambda grey: grey > 50, mode="1")),
                              ("bits.tif", one.point(lambda grey: grey > 50, mode="1"))):
            picture.save(self.path(name))
            value, inside = 100, array[:, :, 0] == 100
            if name.lower().startswith("deep"):
                value = 30000
            elif name.startswith("bits"):
                value, inside = 1, array[:, :, 0] > 50
            with self.subTest(name):
                found = self.bodies(scene({"One": voxels("Soft", name, value, 1e-3)}, [6e-3, 5e-3], 1e-3))
                self.assert_phase(found["One"], inside, 1e-3, DENSITY["Soft"])
        pages = [self.Image.fromarray(layer) for layer in layers]
        pages[0].save(self.path("stack.tif"), save_all=True, append_images=pages[1:])
        os.mkdir(self.path("slices"))
        for page, number in zip(pages, (8, 9, 10)):  # not in the order of letters
            page.save(self.path("slices", f"slice{number}.png"))
        self.write("slices/notes.txt", "not a picture")
        for name in ("stack.tif", "slices"):
            with self.subTest(name):
                found = self.bodies(scene({"One": voxels("Soft", name, 100, 1e-3)}, [6e-3, 5e-3, 3e-3], 1e-3))
                self.assert_phase(found["One"], array == 100, 1e-3, DENSITY["Soft"])

    def test_scenes_reject_wrong_pictures(self):
        colour = numpy.zeros((2, 3, 3), dtype="uint8")
        colour[0, 0] = [255, 0, 0]
        self.save(colour, "colour.png")
        self.save(colour, "colour.tif")
        self.save(numpy.zeros((2, 3), dtype="float32"), "float.tif")
        with open(self.path(self.save(numpy.zeros((200, 300), dtype="uint8") + numpy.arange(300).astype("uint8"), "whole.png")), "rb") as file:
            with open(self.path("short.png"), "wb") as short:
                short.write(file.read()[:120])
        pages = [self.Image.fromarray(numpy.zeros((2, 3), dtype="uint8"))] * 2
        pages[0].save(self.path("stack.tif"), save_all=True, append_images=pages[1:])
        with open(self.path("stack.tif"), "rb") as file:
            content = file.read()
        with open(self.path("short.tif"), "wb") as file:
            file.write(content[:-20])
        header = b"IHDR" + (60000).to_bytes(4, "big") * 2 + bytes([16, 6, 0, 0, 0])
        data = b"IDAT" + zlib.compress(b"")
        with open(self.path("huge.png"), "wb") as file:
            file.write(b"\x89PNG\r\n\x1a\n")
            for chunk in (header, data, b"IEND"):
                file.write((len(chunk) - 4).to_bytes(4, "big") + chunk + zlib.crc32(chunk).to_bytes(4, "big"))
        self.Image.fromarray(numpy.arange(6, dtype="uint8").reshape(2, 3)).convert("P").save(self.path("palette.png"))
        os.mkdir(self.path("mixed"))
        os.mkdir(self.path("empty"))
        self.save(numpy.zeros((2, 3), dtype="uint8"), "mixed/a.png")
        self.save(numpy.zeros((3, 3), dtype="uint8"), "mixed/b.png")
        self.save(numpy.zeros((2, 3), dtype="uint8"), "grey.png")
        os.mkdir(self.path("bits"))
        self.save(numpy.zeros((2, 3), dtype="uint8"), "bits/a.png")
        wide = self.Image.fromarray(numpy.zeros((2, 3), dtype="uint16"))
        wide.save(self.path("bits", "b.png"))
        pages[0].save(self.path("bits.tif"), save_all=True, append_images=[wide])
        self.Image.fromarray(numpy.zeros((16, 16), dtype="uint8")).save(self.path("lossy.tif"), compression="jpeg")
        for name, upper, words in (("bits", [3e-3, 2e-3, 2e-3], ["b.png: it has 16 bits per pixel and the first picture 8, so that", "with as many bits"]),
                                   ("bits.tif", [3e-3, 2e-3, 2e-3], ["page 2 has 16 bits per pixel and the first picture 8, so that"]),
                                   ("lossy.tif", [16e-3, 16e-3], ["compressed by JPEG", "without loss"]),
                                   ("colour.png", [3e-3, 2e-3], ["in colour"]), ("colour.tif", [3e-3, 2e-3], ["in colour"]),
                                   ("float.tif", [3e-3, 2e-3], ["8 or 16 bits"]), ("short.png", [0.3, 0.2], ["can't be read as a PNG picture"]),
                                   ("stack.tif", [3e-3, 2e-3], ["2 pictures", "2D needs one"]), ("short.tif", [3e-3, 2e-3, 2e-3], ["cut off"]),
                                   ("huge.png", [3e-3, 2e-3], ["GB of memory"]), ("palette.png", [3e-3, 2e-3], ["palette"]), ("empty", [3e-3, 2e-3, 1e-3], ["no PNG or TIFF files"]),
                                   ("mixed", [3e-3, 2e-3, 1e-3], ["b.png", "3 x 3 pixels", "3 x 2"]), ("none.png", [3e-3, 2e-3], ["no such file"]),
                                   (self.write("text.png", "no picture") and "text.png", [3e-3, 2e-3], ["can't be read as a PNG picture"]),
                                   (self.write("text.tif", "no picture") and "text.tif", [3e-3, 2e-3], ["can't be read as a TIFF picture"]),
                                   ("grey.png", [3e-3, 2e-3], ["no voxel has the value 1", "0 (6 voxels)"])):
            self.write("scene.xml", scene({"One": voxels("Soft", name, 1, 1e-3)}, upper, 1e-3).text())
            answer = rhegma("scene.xml", "--check", cwd=self.folder)
            self.assertEqual(answer.status, 1, answer)
            with self.subTest(name):
                self.assert_messages(answer.messages, [("Bodies > One > File", words)])

    def test_wrong_pictures(self):
        colour = numpy.zeros((2, 2, 3), dtype="uint8")
        colour[0, 0] = [255, 0, 0]
        self.assertIn("is in colour", self.mesh(self.save(colour, "colour.png"), status=1))
        self.save(numpy.zeros((2, 3), dtype="uint8"), "one.png")
        self.save(numpy.zeros((3, 3), dtype="uint8"), "two.png")
        self.assertIn("two.png has 3 x 3 pixels and the first picture 3 x 2", self.mesh("one.png", "two.png", status=1))
        wide = self.Image.fromarray(numpy.zeros((2, 3), dtype="uint16"))
        wide.save(self.path("wide.png"))
        self.assertIn("wide.png has 16 bits per pixel and the first picture 8,", self.mesh("one.png", "wide.png", status=1))
        self.Image.fromarray(numpy.zeros((2, 3), dtype="uint8")).save(self.path("pages.tif"), save_all=True, append_images=[wide])
        self.assertIn("pages.tif, page 2 has 16 bits per pixel and the first picture 8,", self.mesh("pages.tif", status=1))
        self.Image.fromarray(numpy.zeros((16, 16), dtype="uint8")).save(self.path("lossy.tif"), compression="jpeg")
        self.assertIn("lossy.tif is compressed by JPEG", self.mesh("lossy.tif", status=1))
        self.assertIn("there is no file none.tif", self.mesh("none.tif", status=1))
        self.assertIn("can't be read as a picture", self.mesh(os.path.basename(self.write("text.png", "no picture")), status=1))
        self.assertIn("--thresholds does not apply", self.mesh(self.write("part.svg", "<svg/>"), "--thresholds", "3", status=1))
        self.assertFalse([name for name in os.listdir(self.folder) if name.endswith((".npy", ".part"))])


if __name__ == "__main__":
    unittest.main()
