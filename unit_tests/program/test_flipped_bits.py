#!/usr/bin/env python3
"""Bits that are flipped in what a run left: the numbers are whole, or somebody is told.

In the environment:
RHEGMA_FLIPS  bits that are flipped in each kind of file, one at a time (25)
RHEGMA_SEED   seed of the flips (one of the clock; it is printed)
as in RHEGMA_FLIPS=200 python3 test_flipped_bits.py.
"""

import os
import random
import shutil
import subprocess
import sys
import time
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

import h5py  # noqa: E402
import numpy  # noqa: E402
from program import SOURCE, rhegma  # noqa: E402
from restart_case import RestartTest, scene  # noqa: E402

sys.path.insert(0, os.path.join(SOURCE, "tools"))
from rhegma_tools.whole_folder import check_folder  # noqa: E402

FLIPS = int(os.environ.get("RHEGMA_FLIPS", "25"))
SEED = int(os.environ.get("RHEGMA_SEED", time.time_ns() % 10**9))
CHECK = os.path.join(SOURCE, "tools", "rhegma-check")


def check_tool(folder):
    result = subprocess.run([sys.executable, CHECK, folder], capture_output=True, text=True)
    return result.returncode, result.stdout, result.stderr


class Flips(RestartTest):
    """A flip of one bit that changes a number is found."""

    def whole_run(self):
        path = self.write("scene.xml", scene(**{"Checkpoint Interval": 1e-3}).text())
        self.run_to_its_end(path, self.path("out"))
        self.assertEqual(check_tool(self.path("out")), (0, *check_tool(self.path("out"))[1:2], ""))
        return path

    def contents(self, folder):
        try:
            return self.fields(folder)
        except (OSError, RuntimeError, KeyError, ValueError, TypeError):
            return None

    def same(self, found, before):
        return found is not None and sorted(found) == sorted(before) and all(
            numpy.array_equal(table, before[name]) for name, table in found.items()
        )

    def test_flips(self):
        print(f"seed {SEED}", file=sys.stderr)
        generator = random.Random(SEED)
        scene_path = self.whole_run()
        folder = self.path("out")
        before = self.fields(folder)
        indices = self.indices(os.path.join(folder, "fields.h5"))
        counts = {}
        for name in ("fields.h5", "checkpoint.h5", "history.csv", "summary.json", "fields.xdmf", "manifest.json", "scene"):
            path = scene_path if name == "scene" else os.path.join(folder, name)
            with open(path, "rb") as file:
                content = file.read()
            found = idle = 0
            for k in range(FLIPS):
                bit = generator.randrange(8 * len(content))
                if name == "fields.h5" and k % 2:  # most of it are numbers
                    bit = 8 * generator.choice(indices) + generator.randrange(8)
                damaged = bytearray(content)
                damaged[bit // 8] ^= 1 << bit % 8
                with open(path, "wb") as file:
                    file.write(damaged)
                if check_folder(folder).faults:
                    found += 1
                else:
                    idle += 1
                    self.assertEqual(name, "fields.h5", f"seed {SEED}: bit {bit} of {name} is missed")
                    # Space between tables, or an index that no reader needs.
                    self.assertTrue(self.same(self.contents(folder), before), f"seed {SEED}: bit {bit} of {name}")
            with open(path, "wb") as file:
                file.write(content)
            counts[name] = (found, idle)
        self.assertEqual(check_folder(folder).faults, [])
        self.assertGreater(counts["fields.h5"][0], FLIPS // 2, counts)
        print(f"flips found, without effect: {counts}", file=sys.stderr)

    def indices(self, path):
        """Bytes of a file of fields that are not numbers of its tables."""
        numbers = []
        with h5py.File(path, "r") as file:

            def keep(_, item):
                if isinstance(item, h5py.Dataset):
                    chunks = (item.id.get_chunk_info(k) for k in range(item.id.get_num_chunks()))
                    numbers.extend((chunk.byte_offset, chunk.byte_offset + chunk.size) for chunk in chunks)

            file.visititems(keep)
        found, end = [], 0
        for begin, after in sorted(numbers) + [(os.path.getsize(path),) * 2]:
            found += range(end, begin)
            end = max(end, after)
        return found

    def test_restart_after_a_flip(self):
        """In fields.h5, each second one in its indices, where HDF5 loses its way: the run goes on with messages of its own
        alone, and either its fields are those of the first run or they are new and the damaged ones lie next to them."""
        generator = random.Random(SEED)
        content = scene(**{"Checkpoint Interval": 5e-4}).set("Time > Final Time", 1e-3)
        scene_path = self.write("scene.xml", content.text())
        whole, folder = self.path("whole"), self.path("out")
        self.run_to_its_end(scene_path, whole)
        before = self.fields(whole)
        fields = self.file(whole, "fields.h5")
        indices = self.indices(os.path.join(whole, "fields.h5"))
        self.assertGreater(len(indices), 1000)
        # First the heap of names and other parts of the indices, by the marks at their beginnings.
        marks = (b"FHDB", b"FRHP", b"BTHD", b"BTLF", b"FSHD", b"OHDR", b"OCHK")
        places = [fields.find(mark) + 13 for mark in marks]
        self.assertGreater(min(places), 12, "a mark is not there")
        places += [generator.choice(indices) if k % 2 else generator.randrange(len(fields)) for k in range(FLIPS)]
        set_aside = 0
        for at in places:
            bit = generator.randrange(8)
            where = f"seed {SEED}: bit {bit} of byte {at}"
            shutil.rmtree(folder, ignore_errors=True)
            shutil.copytree(whole, folder)
            damaged = bytearray(fields)
            damaged[at] ^= 1 << bit
            self.write(os.path.join("out", "fields.h5"), bytes(damaged))
            if at in places[: len(marks)]:
                self.assertNotEqual(check_folder(folder).faults, [], where)
            # Memory that is new or was freed holds no zeros, which would hide that it is used.
            answer = rhegma(scene_path, "--output", folder, "--quiet", "--restart", os.path.join(folder, "checkpoint.h5"),
                            MALLOC_PERTURB_="85")
            self.assertEqual(answer.status, 0, f"{where}: {answer}")
            if answer.messages:
                set_aside += 1
                self.assert_messages(answer.messages, [("warning", ["fields.h5 does not hold", "fields.unread.h5"])])
                self.assertEqual(self.file(folder, "fields.unread.h5"), bytes(damaged), where)
            else:
                self.assertTrue(self.same(self.contents(folder), before), where)
        self.assertGreater(set_aside, len(places) // 2)
        print(f"flips before a restart: {set_aside} of {len(places)} set aside, the others without effect", file=sys.stderr)

    def test_each_damaged_file_is_kept(self):
        """A second damaged file takes another name than the first."""
        checkpoint = self.checkpoint_of(self.path("out"))
        kept = []
        for k in (1, 2, 3):
            shutil.copy(checkpoint, self.path("checkpoint.h5"))
            self.write(os.path.join("out", "fields.h5"), f"half a file, the number {k}")
            arguments = (self.path("scene.xml"), "--output", self.path("out"), "--quiet", "--restart", checkpoint)
            answer = rhegma(*arguments)
            shutil.copy(self.path("checkpoint.h5"), checkpoint)
            self.assertEqual(answer.status, 0, answer)
            kept.append("fields.unread.h5" if k == 1 else f"fields.unread.{k}.h5")
            self.assert_messages(answer.messages, [("warning", ["fields.h5 does not hold", "HDF5 can't open it", kept[-1]])])
            for number, name in enumerate(kept, 1):
                self.assertEqual(self.file(self.path("out"), name).decode(), f"half a file, the number {number}")

    def test_fields_that_are_missing_are_missed(self):
        checkpoint = self.checkpoint_of(self.path("out"))
        os.remove(self.path("out", "fields.h5"))
        answer = rhegma(self.path("scene.xml"), "--output", self.path("out"), "--quiet", "--restart", checkpoint)
        self.assertEqual(answer.status, 0, answer)
        self.assert_messages(answer.messages, [("warning", ["there is no", "fields.h5", "new fields"])])

    def test_restart_names_the_frame(self):
        checkpoint = self.checkpoint_of(self.path("out"))
        path = os.path.join(self.path("out"), "fields.h5")
        tables = self.fields(self.path("out"))
        content = bytearray(self.file(self.path("out"), "fields.h5"))
        at = content.find(tables["t00000/particles/position"].tobytes()[:64])
        self.assertGreater(at, 0)
        content[at + 8] ^= 1
        with open(path, "wb") as file:
            file.write(content)
        self.assertIn("t00000", check_tool(self.path("out"))[2])
        answer = rhegma(self.path("scene.xml"), "--output", self.path("out"), "--quiet", "--restart", checkpoint)
        self.assertEqual(answer.status, 0, answer)
        self.assert_messages(answer.messages, [("warning", ["fields.h5", "damage in t00000", "fields.unread.h5"])])

    def test_missing_files(self):
        self.whole_run()
        for name in ("fields.h5", "history.csv", "summary.json", "fields.xdmf", "checkpoint.h5"):
            aside = self.path("aside")
            shutil.move(self.path("out", name), aside)
            self.assertIn(f"{name} is missing", check_tool(self.path("out"))[2])
            shutil.move(aside, self.path("out", name))


if __name__ == "__main__":
    unittest.main()
