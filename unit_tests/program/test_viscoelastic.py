#!/usr/bin/env python3
"""Waves in a viscoelastic bar against their closed form, and relaxation in equilibrium."""

import cmath
import json
import math
import os
import random
import sys
import unittest

import h5py
import numpy

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from program import ProgramTest, rhegma  # noqa: E402
from scenes import Scene  # noqa: E402


class Polymer:
    """A Prony series of random constants; times around one, in units of `time`."""

    def __init__(self, seed, terms, time):
        draw = random.Random(seed)
        self.density, self.young, self.poisson = 1200.0, 3e9, draw.uniform(0.2, 0.4)
        self.times = [time * 10 ** draw.uniform(-1.0, 1.0) for _ in range(terms)]
        self.shear = [draw.uniform(0.2, 0.6) / terms for _ in range(terms)]
        self.bulk = [draw.uniform(0.0, 0.4) / terms for _ in range(terms)]
        print(f"seed {seed}: {terms} terms, times {self.times}, shear {self.shear}, bulk {self.bulk}")

    def parameters(self):
        return {"Model": "Viscoelastic", "Density": self.density, "Young Modulus": self.young, "Poisson Ratio": self.poisson,
                "Relaxation Times": self.times, "Shear Fractions": self.shear, "Bulk Fractions": self.bulk}

    @property
    def moduli(self):
        return self.young / (2 * (1 + self.poisson)), self.young / (3 * (1 - 2 * self.poisson))

    def constrained(self, omega):
        """Complex modulus K + 4/3 G of waves exp(i omega t)."""
        G, K = self.moduli
        relaxed = lambda fractions: 1 - sum(g / (1 + 1j * omega * t) for g, t in zip(fractions, self.times))  # noqa: E731
        return K * relaxed(self.bulk) + 4 / 3 * G * relaxed(self.shear)

    def held(self, time):
        """Fractions of G and K at a time after a step of strain."""
        left = lambda fractions: 1 - sum(g * -math.expm1(-time / t) for g, t in zip(fractions, self.times))  # noqa: E731
        return left(self.shear), left(self.bulk)


class Case(ProgramTest):
    def run_scene(self, scene):
        answer = rhegma(self.write("scene.xml", scene.text()), "--output", self.path("out"), "--quiet")
        self.assertEqual(answer.status, 0, answer)
        with open(self.path("out", "summary.json"), encoding="utf-8") as file:
            return json.load(file)


class Waves(Case):
    def wave(self, terms, seed):
        """One row of cells between planes of symmetry, whose end moves as sin(omega t). k follows from the amplitudes of the particles'
        velocity over one period, and is omega sqrt(rho / M)."""
        period = 2e-5
        omega = 2 * math.pi / period
        polymer = Polymer(seed, terms, 1 / omega)
        k = omega * cmath.sqrt(polymer.density / polymer.constrained(omega))
        length = 2 * math.pi / k.real
        cell = length / 48
        ends, end = 5 * length, 6.5 * period

        def mirror(position, side):
            return {"Type": "Symmetry", "Axis": "y", "Position": position, "Side": side}

        scene = Scene({
            "Domain": {"Dimension": 2, "Plane": "Strain", "Lower Corner": [-3 * cell, -2 * cell], "Upper Corner": [ends + 3 * cell, 3 * cell],
                       "Cell Size": cell},
            "Time": {"Final Time": end},
            "Materials": {"Polymer": polymer.parameters()},
            "Bodies": {"Bar": {"Material": "Polymer", "Shape": "Box", "Lower Corner": [0.0, 0.0], "Upper Corner": [ends, cell]}},
            "Boundaries": {
                "Below": mirror(0.0, "Lower"), "Above": mirror(cell, "Upper"),
                "End": {"Type": "Velocity", "Lower Corner": [-2.5 * cell, -2 * cell], "Upper Corner": [0.25 * cell, 3 * cell],
                        "Components": "x", "Value": [0.01, 0.0], "Box Motion": "Fixed",
                        "History": f"sin({omega!r}*t)*(t < {period!r} ? sin({0.25 * omega!r}*t)^2 : 1)"},
            },
            "Output": {"Field Interval": period / 24, "History Interval": period / 24, "Checkpoints": False},
        })
        summary = self.run_scene(scene)
        with h5py.File(self.path("out", "fields.h5"), "r") as file:
            frames = sorted((float(file[name].attrs["time"]), name) for name in file if "time" in file[name].attrs)
            frames = [frame for frame in frames if frame[0] > end - period + 1e-3 * period]
            x = numpy.asarray(file[frames[0][1]]["particles"]["position"])[:, 0]
            sums = sum(numpy.asarray(file[name]["particles"]["velocity"])[:, 0] * cmath.exp(-1j * omega * time) for time, name in frames)
        part = (x > 0.5 * length) & (x < 2.0 * length)
        order = numpy.argsort(x[part])
        logarithm = numpy.log(numpy.abs(sums[part][order])) + 1j * numpy.unwrap(numpy.angle(sums[part][order]))
        slope = numpy.polyfit(x[part][order], logarithm, 1)[0]
        found = 1j * slope
        print(f"phase speed {omega / found.real:.2f} m/s ({k.real / found.real - 1:+.3%}), attenuation {-found.imag:.4g} 1/m "
              f"({found.imag / k.imag - 1:+.3%})")
        self.assertAlmostEqual(found.real / k.real, 1.0, delta=0.02)
        self.assertAlmostEqual(found.imag / k.imag, 1.0, delta=0.02)
        energy = summary["energy"]
        self.assertGreater(energy["plastic"], 0.1 * energy["external_work"])
        self.assertLess(abs(energy["residual"]), 0.005 * energy["external_work"])

    def test_of_one_and_five_terms(self):
        for terms in (1, 5):
            with self.subTest(terms=terms):
                self.wave(terms, random.SystemRandom().randrange(10**6))


class Relaxation(Case):
    def test_of_a_held_block(self):
        """A block between planes of symmetry is stretched in one short load step and held: the mean stress along it is that of the moduli
        left at the end, for the small strain 1e-4."""
        polymer = Polymer(random.SystemRandom().randrange(10**6), 5, 1.0)
        strain, held = 1e-4, 2.0
        scene = Scene({
            "Domain": {"Dimension": 2, "Plane": "Strain", "Lower Corner": [-0.5, -0.5], "Upper Corner": [1.5, 1.0], "Cell Size": 0.125},
            "Time": {"Analysis": "Quasi-Static", "Final Time": held, "Load Steps": 200},
            "Materials": {"Polymer": polymer.parameters()},
            "Bodies": {"Block": {"Material": "Polymer", "Shape": "Box", "Lower Corner": [0.0, 0.0], "Upper Corner": [1.0, 0.5]}},
            "Boundaries": {
                "Left": {"Type": "Symmetry", "Axis": "x", "Position": 0.0, "Side": "Lower"},
                "Below": {"Type": "Symmetry", "Axis": "y", "Position": 0.0, "Side": "Lower"},
                "Above": {"Type": "Symmetry", "Axis": "y", "Position": 0.5, "Side": "Upper"},
                "Right": {"Type": "Velocity", "Lower Corner": [0.99, -0.5], "Upper Corner": [1.5, 1.0], "Components": "x",
                          "Value": [strain * 1e2, 0.0], "Box Motion": "Fixed", "History": "t < 1e-2 ? 1 : 0"},
            },
        })
        summary = self.run_scene(scene)
        G, K = polymer.moduli
        shear, bulk = polymer.held(held - 0.5e-2)
        expected = strain * (K * bulk + 4 / 3 * G * shear)
        found = summary["bodies"][0]["stress"]["xx"]
        print(f"stress {found:.1f} Pa, closed form {expected:.1f} ({found / expected - 1:+.3%})")
        self.assertAlmostEqual(found / expected, 1.0, delta=0.005)


if __name__ == "__main__":
    unittest.main()
