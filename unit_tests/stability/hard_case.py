"""What every hard case must keep to, and how to read it from the files of a run.

RHEGMA_STABILITY=full in the environment runs the cases at their full size; without it they are short enough for a
test. RHEGMA_STABILITY_SET=Section:Parameter=value runs them with another value of a parameter.
"""

import csv
import json
import math
import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", "program"))
sys.dont_write_bytecode = True

import h5py  # noqa: E402
from program import ProgramTest, rhegma  # noqa: E402
from scenes import Scene  # noqa: E402

# Velocities are known half a step before strains, so that the sum of both energies swings with omega dt / 2 of the
# modes that swing; those of a body of few cells reach this fraction.
FLUCTUATION = 0.5

FULL = os.environ.get("RHEGMA_STABILITY") == "full"
CHANGED = os.environ.get("RHEGMA_STABILITY_SET")


def sized(short, full):
    return full if FULL else short


def space(lower, upper, cell, **more):
    return {"Dimension": len(lower), "Lower Corner": lower, "Upper Corner": upper, "Cell Size": cell, **more}


def elastic(young=1.0, poisson=0.3, density=1.0, model="Linear Elastic"):
    """By default waves in a thin bar travel at 1 m/s."""
    return {"Model": model, "Density": density, "Young Modulus": young, "Poisson Ratio": poisson}


def box(lower, upper, material="Solid", **more):
    return {"Material": material, "Shape": "Box", "Lower Corner": lower, "Upper Corner": upper, **more}


def traction(body, start, end, stress, history="1"):
    return {"Type": "Traction", "Body": body, "From": start, "To": end, "Stress": stress, "History": history}


def walls(lower, upper, axes, velocity, history="1"):
    return {
        "Type": "Velocity",
        "Lower Corner": lower,
        "Upper Corner": upper,
        "Components": axes,
        "Value": velocity,
        "History": history,
    }


class Outcome:
    """The files of a run that has ended."""

    def __init__(self, folder):
        with open(os.path.join(folder, "history.csv"), newline="") as file:
            head, *rows = csv.reader(file)
        table = np.array([[float(value) for value in row] for row in rows])
        self.history = {name: table[:, k] for k, name in enumerate(head)}
        with open(os.path.join(folder, "summary.json")) as file:
            self.summary = json.load(file)
        with h5py.File(os.path.join(folder, "fields.h5"), "r") as file:
            last = max(file, key=lambda name: float(file[name].attrs["time"]))
            self.particles = {name: np.array(data) for name, data in file[last]["particles"].items()}

    def energy(self):
        return self.history["kinetic"] + self.history["strain"]


class HardCase(ProgramTest):
    """Runs a scene and asks of it what is asked of every hard case.

    energy    the most by which the residual of the energy balance may change after the first two tenths of the run, as a fraction
              of the largest energy that the bodies were given or hold; gains and losses, of means over a tenth
    gain      the same for gains alone, where a case loses energy by its nature
    momentum  whether nothing acts from outside: momentum is then kept to 1e-12 of the sum of all |m v|, for each
              thousand steps
    """

    def survives(self, scene, *options, energy=0.01, gain=None, momentum=False, status=0, launcher=()):
        path = self.write("scene.xml", scene.text())
        options = (*options, "--set", CHANGED) if CHANGED else options
        answer = rhegma(path, "--quiet", *options, launcher=launcher, timeout=7200)
        self.assertEqual(answer.status, status, answer)
        outcome = Outcome(self.path("scene.out"))
        self.assert_numbers(outcome)
        self.assert_energy_balance(outcome, energy, gain)
        self.assert_matter(outcome, scene)
        self.assert_fronts(outcome, float(scene.find("Domain > Cell Size").get("value")))
        if momentum:
            self.assert_momentum(outcome)
        return outcome

    def assert_numbers(self, outcome):
        for name, column in outcome.history.items():
            self.assertTrue(np.isfinite(column).all(), name)
        for name, data in outcome.particles.items():
            self.assertTrue(np.isfinite(data).all(), name)

    def assert_energy_balance(self, outcome, energy, gain):
        given = abs(outcome.energy()[0])
        for name in ("external_work", "combustion"):
            if name in outcome.history:
                given = given + np.abs(outcome.history[name]).max()
        scale = max(given, outcome.energy().max())
        residual = outcome.history["residual"]
        self.assertLessEqual(residual.max(), FLUCTUATION * scale, "energy out of nothing")
        parts = [part.mean() for part in np.array_split(residual, 10)]
        change = [part - parts[1] for part in parts[2:]]
        self.assertLessEqual(max(change), (energy if gain is None else gain) * scale, "energy out of nothing")
        if gain is None:
            self.assertGreaterEqual(min(change), -energy * scale, "energy lost")

    def assert_matter(self, outcome, scene):
        """Positive mass, volume and temperature; all of it in the domain."""
        self.assertGreater(outcome.particles["mass"].min(), 0.0)
        turned = outcome.particles["deformation"].reshape(-1, 3, 3)
        self.assertGreater(np.linalg.det(turned).min(), 0.0, "a particle is turned inside out")
        if "temperature" in outcome.particles:
            self.assertGreater(outcome.particles["temperature"].min(), 0.0)
        for end, sign in (("Lower Corner", 1.0), ("Upper Corner", -1.0)):
            corner = np.array([float(x) for x in scene.find("Domain > " + end).get("value").strip("{}").split(",")])
            beyond = sign * (outcome.particles["position"][:, : len(corner)] - corner)
            self.assertGreaterEqual(beyond.min(), 0.0, "matter outside of the domain")

    def assert_fronts(self, outcome, cell):
        """A front that has not ended has matter within a cell and a half."""
        for crack in outcome.summary.get("cracks", []):
            for front in crack.get("fronts", []):
                if front.get("ended"):
                    continue
                position = np.array(front["position"])
                self.assertTrue(np.isfinite(position).all(), crack["name"])
                away = outcome.particles["position"][:, : len(position)] - position
                nearest = math.sqrt((away**2).sum(axis=1).min())
                self.assertLessEqual(nearest, 1.5 * cell, f"a front of {crack['name']} is in the air")

    def assert_momentum(self, outcome):
        moving = np.abs(outcome.particles["mass"][:, None] * outcome.particles["velocity"]).sum()
        steps = max(1.0, outcome.summary["steps"] / 1000.0)
        for name, column in outcome.history.items():
            if name.startswith("momentum_"):
                scale = max(moving, np.abs(column).max())
                self.assertLessEqual(np.abs(column - column[0]).max(), 1e-12 * steps * scale, name)
