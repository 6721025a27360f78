"""Runs on several ranks compared with one."""

import csv
import json
import os
import re
import shutil
import tempfile
import unittest

import h5py
import numpy
from program import rhegma

LAUNCHER = ("mpirun", "--oversubscribe")
ROOT = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}

# Sums in another order differ in their last digits, about 1e-16 a step; the motion of these bodies is stable, so that
# some hundred steps add up to less than this fraction of the largest value.
ROUND_OFF = 1e-10


# The forces of springs at a front go with the difference of two fields, and their stiffness with 1 / xi, the distance of a node from
# where it opens: of springs with xi > 0.05 cells 1.6e-10 of the stress was measured with all update schemes. Now xi > 0.003, and the
# rounding of the distance counts 17 times as much: 2.7e-9.
WITH_SPRINGS = 30.0 * ROUND_OFF

# Crack closure recovers displacement with a mass matrix whose least eigenvalue is a thousandth of its row sums', which
# blows up what differs by as much.
CLOSURE = 1e3

ENERGIES = ("kinetic", "strain", "external_work", "residual", "damped", "contact", "merged", "plastic", "thermal",
            "heat", "fracture", "stabilised", "filtered")


def kind_of(name):
    """Columns of one kind are compared relative to the largest of all."""
    if name in ENERGIES:
        return "energy"
    if name.startswith("momentum"):
        return "momentum"
    if "temperature" in name:
        return "temperature"
    last = name.rpartition(".")[2]
    for kind in ("force", "K", "G"):
        if last.startswith(kind + "_"):
            return kind
    return "length" if last in ("x", "y", "length") else name


def without_numbers(message):
    """They differ by round-off."""
    return re.sub(r"[0-9.]+(e[-+][0-9]+)?", "#", message)


@unittest.skipUnless(shutil.which("mpirun"), "without mpirun")
class OnRanks(unittest.TestCase):
    """Runs a scene on several ranks and compares."""

    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = self.temporary.name
        self.addCleanup(self.temporary.cleanup)

    def write(self, scene):
        with open(os.path.join(self.folder, "scene.xml"), "w", encoding="utf-8") as file:
            file.write(scene.text())
        return os.path.join(self.folder, "scene.xml")

    def run_on(self, ranks, scene, *arguments, into=None, with_fields=True):
        """Summary, columns of the history and the particles' last fields, ordered by where they started, if wanted."""
        out = os.path.join(self.folder, into or f"on{ranks}")
        launcher = (*LAUNCHER, "-np", str(ranks)) if ranks > 1 else ()
        answer = rhegma(
            scene,
            *("--output", out, "--quiet", "--set", f"Output:Fields={str(with_fields).lower()}"),
            *arguments,
            launcher=launcher,
            **ROOT,
        )
        self.assertIn(answer.status, (0, 4), answer)  # 4: too few steps for the scene's reference
        with open(os.path.join(out, "summary.json"), encoding="utf-8") as file:
            summary = json.load(file)
        with open(os.path.join(out, "history.csv"), encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        history = {name: numpy.array([float(row[name]) for row in rows]) for name in rows[0]}
        if not with_fields:
            return summary, history, {}
        with h5py.File(os.path.join(out, "fields.h5"), "r") as file:
            last = file[sorted(file)[-1]]["particles"]
            fields = {name: last[name][()] for name in last if name != "cells"}
        start = numpy.round(fields["position"] - fields["displacement"], 9)
        order = numpy.lexsort(start.T)
        return summary, history, {name: values[order] for name, values in fields.items()}

    def scales_of(self, summary, history):
        """The size relative to which round-off in each column of the history counts."""
        energy = max(numpy.max(numpy.abs(history[name])) for name in ("kinetic", "strain"))
        mass = sum(body["mass"] for body in summary["bodies"])
        kinds = {}
        for name, values in history.items():
            if numpy.all(numpy.isfinite(values)):
                kind = kind_of(name)
                kinds[kind] = max(kinds.get(kind, 0.0), numpy.max(numpy.abs(values)))
        heats = [numpy.max(numpy.abs(history[name])) for name in ("thermal", "heat") if name in history]
        kinds["energy"] = max(energy, *heats, 0.0)
        kinds["temperature"] = 300.0
        kinds["momentum"] = (2.0 * mass * energy) ** 0.5
        return {name: kinds[kind_of(name)] for name in history}

    def agree(self, scene, *arguments, ranks=(2, 3, 4), within=ROUND_OFF, closure=CLOSURE, columns=None):
        """Columns: which of the history are compared, by name, and no fields then; all of both by default."""
        one = self.run_on(1, scene, *arguments, with_fields=columns is None)
        for count in ranks:
            other = self.run_on(count, scene, *arguments, with_fields=columns is None)
            self.assertEqual(other[0]["ranks"], count)
            self.compare(one, other, within, closure, columns)
        return one[2]

    def compare(self, one, other, within=ROUND_OFF, closure=CLOSURE, columns=None):
        """What run_on gave for the same scene twice."""
        (summary, history, fields), (other, others, theirs) = one, other
        scales, count = self.scales_of(summary, history), other["ranks"]
        self.assertEqual((other["steps"], other["particles"]), (summary["steps"], summary["particles"]))
        # Advice for a scene in equilibrium on ranks also says that contact is for one rank.
        alone = " and start the program without mpirun"
        self.assertEqual(*([without_numbers(w).replace(alone, "") for w in s["warnings"]] for s in (other, summary)))
        self.assertEqual(list(others), list(history))
        for body, counted in zip(summary["bodies"], other["bodies"]):
            # A sum of n numbers is right to n units in the last place.
            rounding = 2.3e-16 * max(summary["particles"], 2000)
            self.assertLess(abs(counted["mass"] / body["mass"] - 1.0), rounding, body["name"])
        for name, values in history.items():
            if columns is not None and not columns(name):
                continue
            differs = numpy.abs(others[name] - values) / (scales[name] or 1.0)
            if kind_of(name) == "K":
                # Roots of a G near zero have half its digits: their squares are compared.
                differs = numpy.abs(others[name] * numpy.abs(others[name]) - values * numpy.abs(values)) / (scales[name] ** 2 or 1.0)
            worst = numpy.max(differs)
            most = within * closure if "G_closure" in name else within
            self.assertLess(worst, most, f"{name} on {count} ranks")
        for name, values in fields.items() if columns is None else ():
            self.assertEqual(theirs[name].shape, values.shape, name)
            scale = numpy.max(numpy.abs(values)) or 1.0
            differs = numpy.abs(theirs[name] - values) / scale
            if name in ("side", "crack_normal"):
                # Whether a particle is near enough to a crack to have them may hang on the last digit.
                differs[(values == 0) | (theirs[name] == 0)] = 0.0
            worst = numpy.max(differs)
            self.assertLess(worst, within, f"{name} on {count} ranks")
