#!/usr/bin/env python3
"""fronts.h5 and fronts.csv: G, K and speed along fronts in 3D over time.

In the environment:
RHEGMA_KILLS  runs that are killed (6)
RHEGMA_SEED   seed of the moments of the kills
as in RHEGMA_KILLS=50 RHEGMA_SEED=3 python3 test_fronts_over_time.py.
"""

import csv
import json
import os
import random
import signal
import sys
import time
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

import h5py  # noqa: E402
import numpy  # noqa: E402
from program import PATIENCE, SOURCE, rhegma  # noqa: E402
from ranks import LAUNCHER, ROOT, ROUND_OFF, WITH_SPRINGS  # noqa: E402
from restart_case import RestartTest, scene  # noqa: E402
from test_full_disk import files_up_to  # noqa: E402

sys.path.insert(0, os.path.join(SOURCE, "tools"))
from rhegma.fronts import read_series  # noqa: E402
from rhegma_tools.whole_folder import check_folder  # noqa: E402

PENNY = os.path.join(SOURCE, "xml_inputs", "examples", "penny_growth.xml")
# Two cells a radius: the numbers are not those of a penny, but it grows, and the number of its front nodes changes.
COARSE = ["Domain:Cell Size=2e-3", "Propagation:Start Time=2e-5", "Time:Final Time=6e-5", "Output:Checkpoint Interval=3e-6"]
COLUMNS = ["time", "crack", "front", "node", "s", "x", "y", "z", "G", "K_I", "K_II", "K_III", "speed"]
KILLS = int(os.environ.get("RHEGMA_KILLS", "6"))


def changed(*values):
    return [part for value in (*COARSE, *values) for part in ("--set", value)]


class FrontsOverTime(RestartTest):
    def run_penny(self, folder, *values, more=(), **launch):
        answer = rhegma(PENNY, "--output", folder, "--quiet", *changed(*values), *more, **launch)
        self.assertIn(answer.status, (0, 4), answer)  # 4: the references are for smaller cells

    def rows(self, folder):
        return list(csv.DictReader(self.file(folder, "fronts.csv").decode().splitlines()))

    def tables(self, folder):
        """{(time, name of the front): {column: values}} of fronts.h5."""
        with h5py.File(os.path.join(folder, "fronts.h5"), "r") as file:
            return {(float(group.attrs["time"]), name): {column: table[()] for column, table in front.items()}
                    for group in file.values() for name, front in group.items()}

    def history(self, folder):
        return list(csv.DictReader(self.file(folder, "history.csv").decode().splitlines()))

    def test_both_files_hold_the_same(self):
        folder = self.path("out")
        self.run_penny(folder, "Output:Front Values=With History", "Output:Fields=false")
        rows, tables = self.rows(folder), self.tables(folder)
        self.assertEqual(list(rows[0]), COLUMNS)
        self.assertEqual(len(tables), len(self.history(folder)))
        self.assertGreater(len({len(table["s"]) for table in tables.values()}), 1, "the number of nodes never changes")
        self.assertEqual(sum(len(table["s"]) for table in tables.values()), len(rows))
        for row in rows:
            table, k = tables[float(row["time"]), f"{row['crack']}.{row['front']}"], int(row["node"])
            for name in ("s", "G", "K_I", "K_II", "K_III", "speed"):
                self.assertEqual(float(row[name]), table[name][k])
            self.assertEqual([float(row[axis]) for axis in "xyz"], list(table["position"][k]))
        for table in tables.values():
            steps = numpy.linalg.norm(numpy.diff(table["position"], axis=0), axis=1)
            numpy.testing.assert_allclose(numpy.diff(table["s"]), steps, rtol=1e-12)

    def test_they_agree_with_history_and_summary(self):
        """Each row of the history has the range of G over the nodes, the summary the nodes at the end."""
        folder = self.path("out")
        self.run_penny(folder, "Output:Front Values=With History", "Output:Fields=false")
        samples = read_series(folder)["Penny.0"]
        history = self.history(folder)
        self.assertEqual([sample.time for sample in samples], [float(row["time"]) for row in history])
        for sample, row in zip(samples, history):
            for name, column in (("G", "G_J"), ("K_I", "K_I"), ("K_II", "K_II"), ("K_III", "K_III")):
                values = getattr(sample, name)
                self.assertEqual((values.min(), values.max()), (float(row[f"Penny.0.{column}_min"]), float(row[f"Penny.0.{column}_max"])))
            self.assertEqual(sample.speed.max(), float(row["Penny.0.speed"]))
        nodes = json.loads(self.file(folder, "summary.json"))["cracks"][0]["fronts"][0]["front_nodes"]
        self.assertEqual(samples[-1].s.tolist(), nodes["arc_length"])
        self.assertEqual(samples[-1].G.tolist(), nodes["G_J"])
        self.assertEqual(samples[-1].position.tolist(), nodes["position"])

    def test_with_the_fields_by_default(self):
        folder = self.path("out")
        self.run_penny(folder, "Output:Field Interval=1e-5")
        with h5py.File(os.path.join(folder, "fields.h5"), "r") as file:
            frames = [float(frame.attrs["time"]) for frame in file.values()]
        # At the start nothing has been computed yet.
        self.assertEqual([time for time, _ in self.tables(folder)], frames[1:])
        self.assertEqual(check_folder(folder).faults, [])

    def test_none_where_there_is_no_use_for_them(self):
        for name, values in (("none", ["Output:Front Values=None"]), ("no fields", ["Output:Fields=false"])):
            self.run_penny(self.path(name), *values)
            self.assertEqual([file for file in os.listdir(self.path(name)) if file.startswith("fronts")], [])
        self.run_to_its_end(self.write("plate.xml", scene().text()), self.path("plate"))
        self.assertEqual([file for file in os.listdir(self.path("plate")) if file.startswith("fronts")], [])

    def test_stopped_and_gone_on(self):
        values = ["Output:Front Values=With History", "Output:Field Interval=2e-6"]
        whole, broken = self.path("whole"), self.path("broken")
        self.run_penny(whole, *values)
        run = self.start(PENNY, "--output", broken, "--quiet", *changed(*values))
        self.wait_for(run, os.path.join(broken, "fronts.csv"))
        time.sleep(0.1)
        run.send_signal(signal.SIGTERM)
        run.wait(PATIENCE)
        self.assertEqual(run.returncode, 2, run.stderr.read())
        self.assertEqual(check_folder(broken).faults, [])
        checkpoint = os.path.join(broken, "checkpoint.h5")
        self.run_penny(self.path("elsewhere"), *values, more=("--restart", checkpoint))
        self.run_penny(broken, *values, more=("--restart", checkpoint))
        for folder in (broken, self.path("elsewhere")):
            self.assertEqual(self.file(folder, "fronts.csv"), self.file(whole, "fronts.csv"))
            mine, theirs = self.tables(folder), self.tables(whole)
            self.assertEqual(list(mine), list(theirs))
            for key, table in mine.items():
                for name, column in table.items():
                    numpy.testing.assert_array_equal(column, theirs[key][name])
            self.assertEqual(check_folder(folder).faults, [])

    def test_killed_runs_leave_readable_files_and_go_on(self):
        values = ["Output:Front Values=With History", "Output:Fields=false"]
        seed = int(os.environ.get("RHEGMA_SEED", random.randrange(10**6)))
        print(f"RHEGMA_SEED={seed}")
        chosen = random.Random(seed)
        whole, folder = self.path("whole"), self.path("out")
        begin = time.monotonic()
        self.run_penny(whole, *values)
        duration = time.monotonic() - begin
        checkpoint, seen = os.path.join(folder, "checkpoint.h5"), 0
        for _ in range(KILLS):
            restart = ("--restart", checkpoint) if os.path.exists(checkpoint) else ()
            run = self.start(PENNY, "--output", folder, "--quiet", *changed(*values), *restart)
            time.sleep(chosen.uniform(0.2, 0.8) * duration)
            run.kill()
            run.wait(PATIENCE)
            if os.path.exists(os.path.join(folder, "fronts.csv")):
                seen += 1
                self.assertEqual(check_folder(folder).faults, [])
                written = self.tables(folder)
                expected = self.tables(whole)
                for key, table in written.items():
                    numpy.testing.assert_array_equal(table["G"], expected[key]["G"])
        self.assertGreater(seen, 0)
        restart = ("--restart", checkpoint) if os.path.exists(checkpoint) else ()
        self.run_penny(folder, *values, more=restart)
        self.assertEqual(self.file(folder, "fronts.csv"), self.file(whole, "fronts.csv"))

    def test_ranks_write_the_same(self):
        values = ["Output:Front Values=With History", "Output:Fields=false"]
        one, two = self.path("one"), self.path("two")
        self.run_penny(one, *values)
        self.run_penny(two, *values, launcher=(*LAUNCHER, "-np", "2"), **ROOT)
        mine, theirs = (read_series(folder)["Penny.0"] for folder in (one, two))
        self.assertEqual([len(sample.s) for sample in mine], [len(sample.s) for sample in theirs])
        numpy.testing.assert_allclose([sample.time for sample in theirs], [sample.time for sample in mine], rtol=ROUND_OFF)
        for column in ("s", "position", "G", "K_I", "speed"):
            largest = max(numpy.abs(getattr(sample, column)).max() for sample in mine)
            for one_sample, other in zip(mine, theirs):
                numpy.testing.assert_allclose(getattr(other, column), getattr(one_sample, column), rtol=0, atol=WITH_SPRINGS * largest,
                                              err_msg=f"{column} at {other.time}")

    def test_a_full_disk_stops_the_run_and_it_goes_on(self):
        """Files may not grow beyond a size that fronts.h5 reaches; the history and the checkpoint are smaller."""
        values = ["Output:Front Values=With History", "Output:Fields=false"]
        whole, folder = self.path("whole"), self.path("out")
        self.run_penny(whole, *values)
        limit = 220_000
        self.assertGreater(os.path.getsize(os.path.join(whole, "fronts.h5")), limit)
        for name in ("history.csv", "fronts.csv"):
            self.assertLess(os.path.getsize(os.path.join(whole, name)), limit)
        none = "Output:Checkpoint Interval=1"
        answer = rhegma(PENNY, "--output", folder, "--quiet", *changed(*values, none), preexec=files_up_to(limit))
        self.assertEqual(answer.status, 2, answer)
        self.assertIn("fronts.h5", answer.messages)
        self.assertIn("can't be written", answer.messages)
        self.assertEqual(len([fault for fault in check_folder(folder).faults if "not all could be written" not in fault]), 0)
        written = self.tables(folder)
        self.assertGreater(len(written), 10)
        self.assertLess(len(written), len(self.tables(whole)))

    def test_damaged_files_are_set_aside(self):
        values = ["Output:Front Values=With History", "Output:Fields=false"]
        folder = self.path("out")
        self.run_penny(folder, *values)
        os.rename(self.path("out", "fronts.csv"), self.path("kept.csv"))
        answer = rhegma(PENNY, "--output", folder, "--restart", os.path.join(folder, "checkpoint.h5"), *changed(*values, "Time:Final Time=6.4e-5"))
        self.assertIn(answer.status, (0, 4), answer)
        self.assertIn("does not hold the values along fronts", answer.messages)
        self.assertTrue(os.path.exists(os.path.join(folder, "fronts.unread.h5")))
        self.assertGreater(min(time for time, _ in self.tables(folder)), 6e-5)


if __name__ == "__main__":
    unittest.main()
