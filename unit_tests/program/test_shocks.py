#!/usr/bin/env python3
"""Copper in shocks and at high rates: symmetric plate impact against the Hugoniot, and Taylor's cylinder against published lengths."""

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

DENSITY, C0, SLOPE, GAMMA = 8960.0, 3940.0, 1.489, 2.02
COPPER = {"Material From Library": "OFHC Copper", "Model": "High-Rate Solid", "Equation Of State": "Mie-Grueneisen"}
LENGTH = 20e-3  # of each plate [m]


def hugoniot(particle_speed):
    """Shock speed, pressure and compression behind a shock into material at rest."""
    speed = C0 + SLOPE * particle_speed
    return speed, DENSITY * speed * particle_speed, particle_speed / speed


def release_speed(pressure, compression, target):
    """Speed in undeformed coordinates of the wave on which the isentrope from a Hugoniot state has fallen to a pressure: dp/d eta =
    f' + Gamma p, c = sqrt(dp/d eta / rho), integrated by the method of Runge and Kutta."""
    def slope(eta, p):
        h = 1e-6
        rise = (cold(eta + h) - cold(eta - h)) / (2 * h)
        return rise + GAMMA * p

    def cold(eta):
        if eta < 0:
            return DENSITY * C0**2 * eta
        return DENSITY * C0**2 * eta * (1 - 0.5 * GAMMA * eta) / (1 - SLOPE * eta) ** 2

    eta, p, step = compression, pressure, -compression / 2000
    while p > target:
        a = slope(eta, p)
        b = slope(eta + 0.5 * step, p + 0.5 * step * a)
        c = slope(eta + 0.5 * step, p + 0.5 * step * b)
        d = slope(eta + step, p + step * c)
        eta, p = eta + step, p + step * (a + 2 * b + 2 * c + d) / 6
    return math.sqrt(slope(eta, p) / DENSITY)


def impact(speed, material, end, cell):
    """Two plates of one material, one row of cells between planes of symmetry."""
    def plate(low, high, velocity):
        return {"Material": "Copper", "Shape": "Box", "Lower Corner": [low, 0.0], "Upper Corner": [high, cell],
                "Velocity": [velocity, 0.0]}

    def mirror(position, side):
        return {"Type": "Symmetry", "Axis": "y", "Position": position, "Side": side}

    return Scene({
        "Domain": {"Dimension": 2, "Plane": "Strain", "Lower Corner": [-LENGTH - 20 * cell, -2 * cell],
                   "Upper Corner": [LENGTH + 40 * cell, 3 * cell], "Cell Size": cell},
        "Time": {"Final Time": end},
        "Materials": {"Copper": material},
        "Bodies": {"Flyer": {**plate(-LENGTH, 0.0, speed), "Bonded To": "Target"}, "Target": plate(0.0, LENGTH, 0.0)},
        "Boundaries": {"Below": mirror(0.0, "Lower"), "Above": mirror(cell, "Upper")},
        "Output": {"Field Interval": end / 200, "History Interval": end / 100, "Checkpoints": False},
    })


def frames(folder):
    """Time, reference position, pressure and velocity of the particles at each written time."""
    with h5py.File(os.path.join(folder, "fields.h5"), "r") as file:
        steps = sorted((float(file[name].attrs["time"]), name) for name in file if "time" in file[name].attrs)
        for time, name in steps:
            group = file[name]["particles"]
            stress = numpy.asarray(group["stress"])  # xx, yy, zz, and shear
            place = numpy.asarray(group["position"])[:, 0] - numpy.asarray(group["displacement"])[:, 0]
            yield time, place, -stress[:, :3].sum(axis=1) / 3, numpy.asarray(group["velocity"])[:, 0]


def crossing(times, values, level, falls=False):
    """The first time at which a curve passes a level, by straight lines between its points."""
    sign = -1.0 if falls else 1.0
    for k in range(1, len(times)):
        before, after = sign * (values[k - 1] - level), sign * (values[k] - level)
        if before < 0 <= after:
            return times[k - 1] - before * (times[k] - times[k - 1]) / (after - before)
    return math.nan


class Impact(ProgramTest):
    def run_scene(self, scene):
        answer = rhegma(self.write("scene.xml", scene.text()), "--output", self.path("out"), "--quiet")
        self.assertEqual(answer.status, 0, answer)
        with open(self.path("out", "summary.json"), encoding="utf-8") as file:
            return json.load(file)

    def shocked(self, speed, material, tolerance, release):
        shock, pressure, compression = hugoniot(0.5 * speed)
        cell = 1e-4
        fan = release_speed(pressure, compression, 0.5 * pressure)
        end = LENGTH / shock + 0.8 * LENGTH / fan if release else 0.9 * LENGTH / shock
        summary = self.run_scene(impact(speed, material, end, cell))
        probes = {name: ([], []) for name in (0.25, 0.5, 0.75)}
        plateau = []
        for time, place, p, velocity in frames(self.path("out")):
            if 0.5 * LENGTH / shock < time < 0.9 * LENGTH / shock:
                # Away from the interface, where the impact of the first step leaves some heat, and from the front.
                behind = (place > 0.1 * shock * time) & (place < 0.7 * shock * time)
                plateau.append((p[behind].mean(), velocity[behind].mean()))
            for name, (times, values) in probes.items():
                times.append(time)
                values.append(p[abs(place - name * LENGTH) < 0.5 * cell].mean())
        found = numpy.mean(plateau, axis=0)
        arrivals = [crossing(*probes[name], 0.5 * pressure) for name in (0.25, 0.75)]
        measured = 0.5 * LENGTH / (arrivals[1] - arrivals[0])
        energy, start = summary["energy"], 0.5 * DENSITY * LENGTH * cell * speed**2
        print(f"{speed} m/s: p {found[0] / 1e9:.4f} GPa ({found[0] / pressure - 1:+.2%}), up {found[1]:.2f} m/s, Us {measured:.1f} "
              f"m/s ({measured / shock - 1:+.2%}), residual {energy['residual'] / start:+.2e}")
        self.assertAlmostEqual(found[0] / pressure, 1.0, delta=tolerance)
        self.assertAlmostEqual(found[1] / (0.5 * speed), 1.0, delta=tolerance)
        self.assertAlmostEqual(measured / shock, 1.0, delta=tolerance)
        self.assertLess(abs(energy["residual"]), 0.005 * start)
        if release:
            times, values = probes[0.5]
            after = [k for k, t in enumerate(times) if t > LENGTH / shock]
            arrival = crossing([times[k] for k in after], [values[k] for k in after], 0.5 * pressure, falls=True)
            expected = LENGTH / shock + 0.5 * LENGTH / fan
            print(f"release at half pressure: {arrival * 1e6:.4f} us, closed form {expected * 1e6:.4f} us ({arrival / expected - 1:+.2%})")
            self.assertAlmostEqual(arrival / expected, 1.0, delta=0.015)

    def test_the_hugoniot_without_strength(self):
        """A solid without shear stress, so that the release wave has a closed form, too."""
        fluid = {"Model": "High-Rate Solid", "Density": DENSITY, "Young Modulus": 1e7, "Poisson Ratio": 0.3,
                 "Equation Of State": "Mie-Grueneisen", "Hugoniot Speed": C0, "Hugoniot Slope": SLOPE, "Grueneisen Coefficient": GAMMA}
        for speed in (500.0, 1000.0):
            with self.subTest(speed=speed):
                self.shocked(speed, fluid, 0.015, True)

    def test_copper_of_the_library(self):
        """With its strength: the pressure, the mean of the stresses, is that of the Hugoniot."""
        for speed in (500.0, 1000.0):
            with self.subTest(speed=speed):
                self.shocked(speed, COPPER, 0.015, False)

    def test_a_random_speed(self):
        seed = random.SystemRandom().randrange(10**6)
        speed = random.Random(seed).uniform(300.0, 1500.0)
        print(f"seed {seed}: {speed:.1f} m/s")
        self.shocked(speed, COPPER, 0.02, False)


class Heating(ProgramTest):
    def test_by_the_law_or_by_the_scene(self):
        """A block that all nodes stretch evenly. Without heat the law warms itself, with the section Thermal the scene does: both have
        the same stress, and the temperature that follows from the plastic work."""
        rate, end, size = 2e3, 1e-4, 4e-3
        found = {}
        for heated in (False, True):
            scene = Scene({
                "Domain": {"Dimension": 3, "Lower Corner": [-2e-3] * 3, "Upper Corner": [size + 4e-3] * 3, "Cell Size": 1e-3},
                "Time": {"Final Time": end},
                "Materials": {"Copper": {"Material From Library": "OFHC Copper", "Model": "High-Rate Solid", "Reference Temperature": 293.0,
                                         **({"Thermal Expansion": 0.0, "Conductivity": 0.0} if heated else {})}},
                "Bodies": {"Block": {"Material": "Copper", "Shape": "Box", "Lower Corner": [0.0] * 3, "Upper Corner": [size] * 3}},
                "Boundaries": {"All": {"Type": "Velocity", "Lower Corner": [-1.0] * 3, "Upper Corner": [1.0] * 3, "Box Motion": "Fixed",
                                       "Field": f"{rate}*x, {-0.4 * rate}*y, {-0.4 * rate}*z"}},
                "Output": {"Fields": False, "Checkpoints": False},
            })
            if heated:
                scene.set("Thermal", {"Initial Temperature": 293.0})
            answer = rhegma(self.write("scene.xml", scene.text()), "--output", self.path("out"), "--quiet")
            self.assertEqual(answer.status, 0, answer)
            with open(self.path("out", "summary.json"), encoding="utf-8") as file:
                found[heated] = json.load(file)
        rise = 0.9 * found[False]["energy"]["plastic"] / (DENSITY * 383.0 * size**3)
        stresses = [found[heated]["bodies"][0]["stress"]["xx"] for heated in (False, True)]
        print(f"rise {found[True]['temperature']['peak_rise']:.3f} K, by plastic work {rise:.3f}; stress {stresses}")
        self.assertGreater(rise, 5.0)
        self.assertAlmostEqual(found[True]["temperature"]["peak_rise"] / rise, 1.0, delta=2e-3)
        self.assertAlmostEqual(stresses[1] / stresses[0], 1.0, delta=1e-3)


class Rest(ProgramTest):
    def test_flow_in_equilibrium(self):
        """A sheet that is drawn by 2 % in a second, so slowly that the rate does not count: the stress along it is A + B alpha^n, alpha the
        logarithmic strain less the elastic one. The softening by the heat of that work, 0.9 x 3 MJ/m3 / (rho c) = 1 K, is 0.1 %."""
        scene = Scene({
            "Domain": {"Dimension": 2, "Plane": "Stress", "Lower Corner": [-0.5, -0.5], "Upper Corner": [1.5, 1.0], "Cell Size": 0.125},
            "Time": {"Analysis": "Quasi-Static", "Final Time": 1.0, "Load Steps": 20},
            "Materials": {"Copper": {"Material From Library": "OFHC Copper", "Model": "High-Rate Solid"}},
            "Bodies": {"Sheet": {"Material": "Copper", "Shape": "Box", "Lower Corner": [0.0, 0.0], "Upper Corner": [1.0, 0.5]}},
            "Boundaries": {
                "Left": {"Type": "Symmetry", "Axis": "x", "Position": 0.0, "Side": "Lower"},
                "Below": {"Type": "Symmetry", "Axis": "y", "Position": 0.0, "Side": "Lower"},
                "Right": {"Type": "Velocity", "Lower Corner": [0.99, -0.5], "Upper Corner": [1.5, 1.0], "Components": "x",
                          "Value": [0.02, 0.0], "Box Motion": "Fixed"},
            },
            "Output": {"Fields": False},
        })
        answer = rhegma(self.write("scene.xml", scene.text()), "--output", self.path("out"), "--quiet")
        self.assertEqual(answer.status, 0, answer)
        with open(self.path("out", "summary.json"), encoding="utf-8") as file:
            found = json.load(file)["bodies"][0]["stress"]["xx"]
        stress = 0.0
        for _ in range(50):
            stress = 90e6 + 292e6 * (math.log(1.02) - stress / 124e9) ** 0.31
        print(f"stress {found / 1e6:.2f} MPa, closed form {stress / 1e6:.2f} ({found / stress - 1:+.2%})")
        self.assertAlmostEqual(found / stress, 1.0, delta=0.003)


class Wrong(ProgramTest):
    def refused(self, material, where, words, more=()):
        scene = impact(500.0, material, 1e-7, 1e-4)
        for path, value in more:
            scene.set(path, value)
        self.write("scene.xml", scene.text())
        self.assert_refused(["scene.xml"], [(f"Materials > Copper > {where}", words)])

    def test_constants(self):
        self.refused({**COPPER, "Johnson-Cook A": 0.0}, "Johnson-Cook A", ["above 0"])
        self.refused({**COPPER, "Melting Temperature": 100.0}, "Melting Temperature", ["give Melting Temperature > Transition Temperature"])
        self.refused({**COPPER, "Grueneisen Coefficient": 5.0}, "Grueneisen Coefficient", ["< 2 Hugoniot Slope"])
        self.refused(COPPER, "Equation Of State", ["internal energy", "Equation Of State = Elastic"], [("Thermal", {"Initial Temperature": 293.0})])
        self.refused(COPPER, "Equation Of State", ["plane stress"], [("Domain > Plane", "Stress")])


class Taylor(ProgramTest):
    def hit(self, material, radius, length, speed, density):
        """A quarter of a cylinder that hits a wall without friction, 80 us later: lengths, and the residual of the energy balance as a
        fraction of the kinetic energy at the start."""
        cell = radius / 8

        def mirror(axis):
            return {"Type": "Symmetry", "Axis": axis, "Position": 0.0, "Side": "Lower"}

        def cut(corner):
            return {"Operation": "Cut", "Shape": "Box", "Lower Corner": [-1.0] * 3, "Upper Corner": corner}

        scene = Scene({
            "Domain": {"Dimension": 3, "Lower Corner": [-3 * cell] * 3, "Upper Corner": [21 * cell, 21 * cell, length + 4 * cell],
                       "Cell Size": cell},
            "Time": {"Final Time": 8e-5},
            "Materials": {"Copper": material},
            "Bodies": {"Rod": {"Material": "Copper", "Shape": "Cylinder", "From": [0, 0, 0], "To": [0, 0, length], "Radius": radius,
                               "Velocity": [0.0, 0.0, -speed],
                               "Operations": {"West": cut([0.0, 1.0, 1.0]), "South": cut([1.0, 0.0, 1.0])}}},
            "Boundaries": {"Wall": mirror("z"), "East": mirror("x"), "North": mirror("y")},
            "Output": {"Checkpoints": False},
        })
        answer = rhegma(self.write("scene.xml", scene.text()), "--output", self.path("out"), "--quiet")
        self.assertEqual(answer.status, 0, answer)
        with h5py.File(self.path("out", "fields.h5"), "r") as file:
            last = max((float(file[name].attrs["time"]), name) for name in file if "time" in file[name].attrs)[1]
            group = file[last]["particles"]
            x = numpy.asarray(group["position"])
            start = x - numpy.asarray(group["displacement"])
            # Each particle reaches half of its present edges beyond its centre.
            gradient = numpy.asarray(group["deformation"]).reshape(-1, 3, 3)
            reach = 0.5 * abs(numpy.einsum("pij,pej->pei", gradient, numpy.asarray(group["edges"]).reshape(-1, 3, 3))).sum(axis=1)
        # Those next to the axis x, where the surface of the undeformed cylinder lies on faces of cells.
        outer = numpy.where(start[:, 1] < 0.5 * cell, x[:, 0] + reach[:, 0], 0.0)
        with open(self.path("out", "summary.json"), encoding="utf-8") as file:
            residual = json.load(file)["energy"]["residual"]
        residual /= 0.25 * math.pi * radius**2 * length * density * 0.5 * speed**2
        return {"length": 1e3 * (x[:, 2] + reach[:, 2]).max(), "foot": 2e3 * outer[x[:, 2] < cell].max(),
                "fifth": 2e3 * outer[abs(x[:, 2] - 0.2 * length) < 0.5 * cell].max()}, residual

    def compare(self, found, residual, published, tolerance):
        for name, value in published.items():
            print(f"{name}: {found[name]:.3f} mm, published {value} ({found[name] / value - 1:+.2%})")
        print(f"residual {residual:+.2e} of the kinetic energy")
        for name, value in published.items():
            self.assertAlmostEqual(found[name] / value, 1.0, delta=tolerance, msg=name)
        self.assertLess(abs(residual), 0.01)

    def test_with_linear_hardening(self):
        """The copper bar of Kamoulakos (1990) and Zhu and Cescotto (1995), a benchmark of codes: lengths of 21.42 to 21.47 mm and radii of the
        foot of 6.97 to 7.18 mm are published. The middles of both, within 2 %."""
        bar = {"Model": "High-Rate Solid", "Density": 8930.0, "Young Modulus": 117e9, "Poisson Ratio": 0.35, "Johnson-Cook A": 400e6,
               "Johnson-Cook B": 100e6}
        self.compare(*self.hit(bar, 3.2e-3, 32.4e-3, 227.0, 8930.0), {"length": 21.445, "foot": 14.15}, 0.02)

    def test_with_the_constants_of_johnson_and_cook(self):
        """25.4 by 7.62 mm at 190 m/s against the cylinder that was shot (Johnson and Cook 1983; Holmquist and Johnson 1988). The constants are
        those of tests in torsion and tension, with which the law is stiffer than this cylinder: 6 and 8 cells per radius give
        the same length within 0.1 %, which is too large by 6.6 %. Lengths within 8 %."""
        self.compare(*self.hit(COPPER, 3.81e-3, 25.4e-3, 190.0, DENSITY), {"length": 16.2, "foot": 13.5, "fifth": 10.1}, 0.08)


if __name__ == "__main__":
    unittest.main()
