#!/usr/bin/env python3
"""Fields on request, and their extremes in the history."""

import csv
import json
import os
import shutil
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

import h5py  # noqa: E402
import numpy  # noqa: E402
from program import rhegma  # noqa: E402
from ranks import LAUNCHER, ROOT, ROUND_OFF  # noqa: E402
from restart_case import RestartTest  # noqa: E402
from scenes import plate  # noqa: E402

DENSITY = 1200.0  # [kg/m3] of the plate


def pulled():
    scene = plate().set("Output", {"Principal Stress": True, "Energy Density": True, "Field Interval": 2.5e-4})
    return scene.set("Measure", {"Extremes": {"Peak": {"Field": "Principal Stress"}, "Energy": {"Field": "Energy Density"},
                                              "Fastest": {"Field": "Speed", "Body": "Plate"}}})


class RequestedFields(RestartTest):
    def frames(self, folder):
        with h5py.File(os.path.join(folder, "fields.h5"), "r") as file:
            return [(float(frame.attrs["time"]), {name: table[()] for name, table in frame["particles"].items()}) for frame in file.values()]

    def history(self, folder):
        return {float(row["time"]): {name: float(value) for name, value in row.items()}
                for row in csv.DictReader(self.file(folder, "history.csv").decode().splitlines())}

    def test_the_last_frame_is_written_once(self):
        """50 times 2e-6 s is a rounding error less than the end, 1e-4 s: programs that read both frames take them for one time."""
        self.assertLess(50 * 2e-6, 1e-4)
        scene = plate().set("Time > Final Time", 1e-4).set("Output", {"Field Interval": 2e-6, "History Interval": 1e-4})
        folder = self.path("out")
        answer = rhegma(self.write("scene.xml", scene.text()), "--output", folder)  # with a warning: no wave crosses the plate in so short a time
        self.assertEqual(answer.status, 0, answer)
        times = [time for time, _ in self.frames(folder)]
        self.assertEqual((len(times), times[-1]), (51, 1e-4))

    def test_fields_and_extremes_agree(self):
        folder = self.path("out")
        # Of a body without a crack: the strain energy of the history has that of front springs as well.
        self.run_to_its_end(self.write("scene.xml", pulled().remove("Cracks").remove("Energy Release").text()), folder)
        history, frames = self.history(folder), self.frames(folder)
        self.assertEqual(len(frames), 5)
        for time, particles in frames[1:]:
            xx, yy, zz, xy, yz, xz = particles["stress"].T
            tensor = numpy.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]).transpose(2, 0, 1)
            largest = numpy.linalg.eigvalsh(tensor)[:, -1]
            scale = numpy.abs(particles["stress"]).max()
            numpy.testing.assert_allclose(particles["principal_stress"], largest, rtol=0, atol=1e-13 * scale)
            row = history[time]
            # Densities are per undeformed volume, as the sum over the body is the strain energy.
            energy = (particles["energy_density"] * particles["mass"] / DENSITY).sum()
            self.assertAlmostEqual(energy, row["strain"], delta=1e-12 * row["strain"])
            for name, values in (("Peak", particles["principal_stress"]), ("Energy", particles["energy_density"]),
                                 ("Fastest", numpy.linalg.norm(particles["velocity"], axis=1))):
                for what, index in (("largest", values.argmax()), ("smallest", values.argmin())):
                    self.assertAlmostEqual(row[f"{name}.{what}"], values[index], delta=1e-14 * numpy.abs(values).max())
                    where = numpy.array([row[f"{name}.{what}_{axis}"] for axis in "xy"])
                    # Two particles that mirror each other may have the same value but for round-off.
                    at = numpy.linalg.norm(particles["position"][:, :2] - where, axis=1).argmin()
                    self.assertAlmostEqual(values[at], values[index], delta=1e-12 * numpy.abs(values).max())
        summary = json.loads(self.file(folder, "summary.json"))["extremes"]["Peak"]
        self.assertEqual(summary["largest"], history[frames[-1][0]]["Peak.largest"])

    @unittest.skipUnless(shutil.which("mpirun"), "without mpirun")
    def test_ranks_find_the_same(self):
        path = self.write("scene.xml", pulled().text())
        self.run_to_its_end(path, self.path("one"))
        answer = rhegma(path, "--output", self.path("two"), "--quiet", launcher=(*LAUNCHER, "-np", "2"), **ROOT)
        self.assertEqual(answer.status, 0, answer)
        one, two = self.history(self.path("one")), self.history(self.path("two"))
        self.assertEqual(len(one), len(two))
        for name in ("Peak.largest", "Peak.smallest", "Energy.largest", "Fastest.largest"):
            mine, theirs = (numpy.array([row[name] for row in rows.values()]) for rows in (one, two))
            numpy.testing.assert_allclose(theirs, mine, rtol=0, atol=ROUND_OFF * numpy.abs(mine).max(), err_msg=name)

    def test_a_body_that_does_not_exist(self):
        scene = pulled().set("Measure > Extremes > Fastest > Body", "Plaet")
        self.assert_refused((self.write("scene.xml", scene.text()),), [("Measure > Extremes > Fastest > Body", ["Plaet"])])

    def test_a_field_that_does_not_exist(self):
        scene = pulled().set("Measure > Extremes > Fastest > Field", "Spede")
        self.assert_refused((self.write("scene.xml", scene.text()),), [("Measure > Extremes > Fastest > Field", ["Speed"])])

    def test_without_stress(self):
        scene = pulled().remove("Cracks").remove("Energy Release").remove("Boundaries").set("Thermal", {"Mechanics": False, "Initial Temperature": 300.0})
        scene.set("Materials > Polymer > Specific Heat", 1400.0).set("Materials > Polymer > Conductivity", 0.2)
        answer = rhegma(self.write("scene.xml", scene.text()), "--check")
        self.assertEqual(answer.status, 1, answer)
        self.assertIn("Measure > Extremes > Peak > Field = Principal Stress: without mechanics only Temperature changes", answer.messages)

    def test_temperature(self):
        """Of a bar between 300 and 400 K, with motion and without; refused where the scene has none."""
        hot = pulled().remove("Cracks").remove("Energy Release").set("Measure > Extremes", {"Hot": {"Field": "Temperature", "Body": "Plate"}})
        self.assert_refused((self.write("scene.xml", hot.text()),), [("Measure > Extremes > Hot > Field = Temperature", ["section Thermal"])])
        hot.set("Materials > Polymer > Specific Heat", 1400.0).set("Materials > Polymer > Conductivity", 2e6)  # through a cell in the time of the run
        edge = {"Type": "Temperature", "Lower Corner": [-1.0, -1.0], "Upper Corner": [0.01, 2.0], "Temperature": 400.0}
        for mechanics in (True, False):
            scene = hot.set("Thermal", {"Mechanics": mechanics, "Initial Temperature": 300.0}).set("Boundaries > Edge", edge)
            if not mechanics:
                scene.remove("Boundaries > Pull")
            scene.set("Output", {"Field Interval": 2.5e-4})
            folder = self.path(f"mechanics_{mechanics}")
            answer = rhegma(self.write("scene.xml", scene.text()), "--output", folder)  # with a warning: no solid conducts so well
            self.assertEqual(answer.status, 0, answer)
            history = self.history(folder)
            for time, particles in self.frames(folder)[1:]:
                values = particles["temperature"].ravel()
                self.assertEqual((history[time]["Hot.largest"], history[time]["Hot.smallest"]), (values.max(), values.min()))
                self.assertLess(history[time]["Hot.largest_x"], 0.1)


if __name__ == "__main__":
    unittest.main()
