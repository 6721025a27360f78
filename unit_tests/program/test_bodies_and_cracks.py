#!/usr/bin/env python3
"""Cracked bodies that meet other bodies, against closed forms, conservation laws and the same bodies without one of the two.

Positions relative to the cells, angles and friction are drawn; RHEGMA_SEED in the environment chooses them, and is printed."""

import math
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
sys.dont_write_bytecode = True

from drawn_scenes import DrawnScenes  # noqa: E402
from program import rhegma  # noqa: E402
from scenes import Scene  # noqa: E402

ROUNDING = 1e-12  # sums over thousands of steps and particles
DENSITY, YOUNG = 8000.0, 200e9
SOUND = math.sqrt(YOUNG / DENSITY)  # without lateral contraction waves in bars, plates and solids have this speed


def steel(poisson=0.0):
    return {"Model": "Linear Elastic", "Density": DENSITY, "Young Modulus": YOUNG, "Poisson Ratio": poisson}


def box(lower, upper, **more):
    return {"Material": "Steel", "Shape": "Box", "Lower Corner": lower, "Upper Corner": upper, **more}


class BodiesAndCracks(DrawnScenes):
    def assert_conserves(self, history, scale):
        """Momentum to rounding. \\a scale: that of the moving body."""
        for axis in [c for c in history if c.startswith("momentum_")]:
            values = history[axis]
            self.assertLess(max(abs(v - values[0]) for v in values), ROUNDING * scale, axis)

    def smallest_difference(self, times, ours, other_times, theirs, delay):
        """The largest difference of two histories, the second one later by the part of `delay` with which it is smallest."""

        def value(time):
            if time <= other_times[0]:
                return theirs[0]
            k = next((k for k, t in enumerate(other_times) if t >= time), len(other_times) - 1)
            part = (time - other_times[k - 1]) / (other_times[k] - other_times[k - 1])
            return theirs[k - 1] + part * (theirs[k] - theirs[k - 1])

        return min(max(abs(a - value(t - delay * part / 20.0)) for t, a in zip(times, ours)) for part in range(21))

    def struck_plate(self, low, high, time=2.4e-5, cell=2e-3, dimension=2, gap=0.0, margin=0.0):
        """A plate with a crack from the middle of its left edge to its centre, and a projectile that comes to the edge from `low` to
        `high`, in fractions of the height of 0.1 m, over a gap in cells. Both lie anywhere in the cells, the struck edge `margin` cells off the nodes."""
        at = [self.rng.uniform(margin, 1.0 - margin) * cell] + [self.rng.uniform(0.0, cell) for _ in range(dimension - 1)]
        depth = at[2:], [z + 4.0 * cell for z in at[2:]]
        x, y = at[:2]
        end = [x + 0.05, y + 0.05]
        crack = [x, y + 0.05, *end]
        if dimension == 3:
            crack = []
            for along, z in ((x, depth[0][0]), (end[0], depth[0][0]), (end[0], depth[1][0]), (x, depth[1][0])):
                crack += [along, end[1], z]
        return Scene(
            {
                "Domain": {
                    "Dimension": dimension,
                    **({"Plane": "Strain"} if dimension == 2 else {}),
                    "Cell Size": cell,
                    "Lower Corner": [-0.08 - 6.0 * cell, -4.0 * cell] + [-4.0 * cell] * (dimension - 2),
                    "Upper Corner": [0.1 + 8.0 * cell, 0.1 + 6.0 * cell] + [10.0 * cell] * (dimension - 2),
                },
                "Time": {"Final Time": time},
                "Materials": {"Steel": steel()},
                "Bodies": {
                    "Projectile": box([x - gap * cell - 0.08, y + 0.1 * low, *depth[0]], [x - gap * cell, y + 0.1 * high, *depth[1]], Velocity=[10.0] + [0.0] * (dimension - 1)),
                    "Plate": box([x, y, *depth[0]], [x + 0.1, y + 0.1, *depth[1]]),
                },
                "Cracks": {"Notch": {"Points": crack}},
                "Body Contact": {},
                "Energy Release": {**({"Crack Closure": False} if dimension == 2 else {})},
                "Output": {"Fields": False, "Checkpoints": False, "History Interval": time / 24.0},
            }
        ), at

    def test_a_struck_plate_is_loaded_as_by_the_pressure_of_the_impact(self):
        """Equal impedances: the struck part of the edge bears rho c v / 2 until the wave is back from the end of the projectile or from
        the front of the crack. The projectile ends at the mouth of the crack, and strikes one lip."""
        scene, (x, y) = self.struck_plate(0.0, 0.5)
        scene.set("Output > History Interval", 2e-7)
        summary, history = self.run_scene(scene)
        loaded = scene.copy().remove("Bodies > Projectile").remove("Body Contact")
        pressure = 0.5 * DENSITY * SOUND * 10.0
        loaded.set(
            "Boundaries",
            {"Impact": {"Type": "Traction", "Body": "Plate", "From": [x, y], "To": [x, y + 0.05], "Stress": [pressure, 0.0]}},
        )
        other, imposed = self.run_scene(loaded, name="loaded")
        start = history["kinetic"][0]
        self.assert_conserves(history, summary["bodies"][0]["mass"] * 10.0)
        self.assertLess(max(abs(r) for r in history["residual"]), 0.005 * start)
        times, force = history["time"], history["Projectile - Plate.contact_force_x"]
        before = [k for k, t in enumerate(times) if t <= 2.0e-5][-1]
        given = sum(force[k] * (times[k] - times[k - 1]) for k in range(1, before + 1))
        # The pressure rises while the wave crosses a cell.
        self.assertLess(abs(given / (pressure * 0.05 * times[before]) - 1.0), 2e-3 / (SOUND * times[before]))
        # The pressure of contact rises later, by at most the time in which the wave crosses a cell.
        for name, most in (("G_J", 0.03), ("K_II", 0.015)):
            ours, theirs = (columns["Notch.0." + name] for columns in (history, imposed))
            self.assertLess(self.smallest_difference(times, ours, imposed["time"], theirs, 2e-3 / SOUND), most * max(abs(b) for b in theirs), name)
        self.assertGreater(summary["energy"]["contact"], 0.0)

    def test_both_lips_are_struck_alike(self):
        """Along a crack a plane wave does not see it: everything is as in the plate without a crack. Over a gap, as with none rounding
        decides at which nodes the bodies touch in the first step, and not just beyond a row of nodes: a light field of the projectile that
        presses on both faces gives its impulse to the first of them, which changes results by up to 3e-4."""
        for dimension, cell in ((2, 2.5e-3), (3, 5e-3)):
            scene, at = self.struck_plate(0.0, 1.0, 3e-5, cell, dimension, self.rng.uniform(0.01, 0.03), 0.2)
            scene.remove("Energy Release")
            summary, history = self.run_scene(scene)
            whole, without = self.run_scene(scene.copy().remove("Cracks"), name="whole")
            with self.subTest(dimension=dimension, at=at):
                self.assert_conserves(history, summary["bodies"][0]["mass"] * 10.0)
                for name in ("kinetic", "strain", "contact"):
                    most = max(abs(v) for v in without["kinetic"])
                    self.assertLess(max(abs(a - b) for a, b in zip(history[name], without[name])), 1e-9 * most, name)
                pair, other = summary["body_contact"][0], whole["body_contact"][0]
                self.assertEqual(pair["first_touch"], other["first_touch"])
                self.assertLess(abs(pair["impulse"][0] / other["impulse"][0] - 1.0), 1e-9)

    def test_a_bar_in_two_halves(self):
        """A bar that a crack cuts in the middle, its faces in contact: the bar that strikes it stops, and the second half flies off."""
        cells = 60
        cell = 0.1 / cells
        x, y = (self.rng.uniform(0.0, cell) for _ in range(2))
        middle = x + 0.2
        scene = Scene(
            {
                "Domain": {"Dimension": 2, "Cell Size": cell, "Lower Corner": [-4.0 * cell] * 2, "Upper Corner": [0.3 + 14.0 * cell, 10.0 * cell]},
                "Time": {"Final Time": 3.8 * 0.1 / SOUND},
                "Materials": {"Steel": steel()},
                "Bodies": {
                    "Striker": box([x, y], [x + 0.1, y + 4.0 * cell], Velocity=[1.0, 0.0]),
                    "Bar": box([x + 0.1, y], [x + 0.3, y + 4.0 * cell]),
                },
                "Cracks": {"Cut": {"Points": [middle, y - cell, middle, y + 5.0 * cell]}},
                "Contact": {"Law": "Frictionless"},
                "Body Contact": {},
                "Output": {"Fields": False, "Checkpoints": False, "History Interval": 1e-6},
            }
        )
        summary, history = self.run_scene(scene)
        mass, start = summary["bodies"][0]["mass"], 0.5 * summary["bodies"][0]["mass"]
        self.assert_conserves(history, mass)
        # As two bars in impact (docs/explanation/verification/bodies-in-contact.md): 2 % of the speed with 50 cells.
        self.assertLess(abs(summary["bodies"][0]["velocity"][0]), 0.02)
        self.assertLess(abs(2.0 * summary["bodies"][1]["velocity"][0] - 1.0), 0.02)
        # One half moves at 1, the other rests: twice the kinetic energy of the mean motion.
        self.assertLess(abs(history["kinetic"][-1] / start - 1.0), 0.05)

    def incline(self, angle, friction, turned, cracked):
        """A block on a plane that is turned through the cells; a crack runs from the middle of the block's base to its centre."""
        cell, g = 0.0125, 10.0
        at = [self.rng.uniform(0.0, cell) for _ in range(2)]
        c, s = math.cos(turned), math.sin(turned)

        def out(x, y):
            return [c * x - s * y, s * x + c * y]

        corners = [out(x, y) for x in (-0.2, 0.5) for y in (-0.1, 0.1)]
        around = {"Material": "Soft", "Rotation": math.degrees(turned), "Rotation Centre": at}
        held = {}
        for k in range(8):
            a, b = (out(-0.2 + 0.7 * (k + n) / 8.0, -0.05) for n in (0, 1))
            held[f"Base {k}"] = {
                "Type": "Velocity",
                "Components": "xy",
                "Value": [0.0, 0.0],
                "Lower Corner": [at[0] + min(a[0], b[0]) - 1e-6, -9.0],
                "Upper Corner": [at[0] + max(a[0], b[0]), at[1] + min(a[1], b[1])],
            }
        crack = [a + b for point in ((0.0, 0.0), (0.0, 0.05)) for a, b in zip(at, out(*point))]
        return Scene(
            {
                "Domain": {
                    "Dimension": 2,
                    "Cell Size": cell,
                    "Lower Corner": [min(x[d] for x in corners) - 4.0 * cell for d in range(2)],
                    "Upper Corner": [max(x[d] for x in corners) + 6.0 * cell for d in range(2)],
                },
                "Time": {"Final Time": 0.1},
                "Materials": {"Soft": {"Model": "Linear Elastic", "Density": 1000.0, "Young Modulus": 1e7, "Poisson Ratio": 0.3}},
                "Bodies": {
                    "Plane": box([at[0] - 0.2, at[1] - 0.1], [at[0] + 0.5, at[1]], **around),
                    "Block": box([at[0] - 0.05, at[1]], [at[0] + 0.05, at[1] + 0.1], **around),
                },
                "Boundaries": {
                    "Weight": {"Type": "Gravity", "Acceleration": out(g * math.sin(angle), -g * math.cos(angle))},
                    **held,
                },
                **({"Cracks": {"Notch": {"Points": crack}}, "Contact": {"Law": "Frictionless"}} if cracked else {}),
                "Body Contact": {"Law": "Coulomb", "Friction Coefficient": friction},
                "Output": {"Fields": False, "Checkpoints": False, "History Interval": 5e-3},
            }
        )

    def test_a_cracked_block_slides(self):
        """The block shakes when its weight is applied at once, so that its speed is off by a few mm/s at any time."""
        for turned in (0.0, self.rng.uniform(0.05, 0.7), self.rng.uniform(-0.7, -0.05)):
            angle, friction = self.rng.uniform(0.6, 0.9), self.rng.choice([0.2, 0.4])
            scene = self.incline(angle, friction, turned, True)
            summary, _ = self.run_scene(scene)
            with self.subTest(turned=turned, angle=angle, friction=friction):
                v = summary["bodies"][1]["velocity"]
                along = math.cos(turned) * v[0] + math.sin(turned) * v[1]
                exact = 10.0 * (math.sin(angle) - friction * math.cos(angle)) * 0.1
                self.assertLess(abs(along - exact), 0.01)
                heat = friction * summary["bodies"][1]["mass"] * 10.0 * math.cos(angle) * 0.05 * exact
                self.assertLess(abs(summary["energy"]["friction"] - heat), 0.05 * (heat + summary["energy"]["kinetic"]))

    def test_a_turned_impact(self):
        """The struck plate turned through the cells has the G of the one along them, and conserves both components of momentum."""
        results = []
        for angle in (0.0, self.rng.choice((-1.0, 1.0)) * self.rng.uniform(5.0, 40.0)):
            scene, (x, y) = self.struck_plate(0.0, 0.5, 2.0e-5)
            turn = math.radians(angle)
            c, s = math.cos(turn), math.sin(turn)
            for body in ("Projectile", "Plate"):
                scene.set(f"Bodies > {body} > Rotation", angle).set(f"Bodies > {body} > Rotation Centre", [x, y])
            scene.set("Bodies > Projectile > Velocity", [10.0 * c, 10.0 * s])
            scene.set("Cracks > Notch > Points", [v for a in (0.0, 0.05) for v in (x + c * a - s * 0.05, y + s * a + c * 0.05)])
            if angle != 0.0:
                scene.set("Domain > Lower Corner", [-0.18, -0.16]).set("Domain > Upper Corner", [0.18, 0.18])
            summary, history = self.run_scene(scene)
            self.assert_conserves(history, summary["bodies"][0]["mass"] * 10.0)
            self.assertLess(max(abs(r) for r in history["residual"]), 0.005 * history["kinetic"][0])
            results.append((angle, history["Notch.0.G_J"][-1], summary["body_contact"][0]["impulse"]))
        (_, straight, impulse), (angle, turned, vector) = results
        with self.subTest(angle=angle):
            self.assertLess(abs(turned / straight - 1.0), 0.05)
            self.assertLess(abs(math.hypot(*vector) / impulse[0] - 1.0), 0.02)

    def test_an_end_that_sticks_out_does_not_cut_the_other_body(self):
        scene, (x, y) = self.struck_plate(0.2, 0.8, 1.5e-5)
        points = scene["Cracks > Notch > Points"]
        _, plain = self.run_scene(scene)
        scene.set("Cracks > Notch > Points", [x - 3.5e-3, *points[1:]])
        _, over = self.run_scene(scene, name="over")
        for name in ("kinetic", "strain", "Notch.0.G_J", "Projectile - Plate.contact_force_x"):
            self.assertEqual(plain[name], over[name], name)

    def test_a_crack_through_two_bodies_is_refused(self):
        scene, (x, y) = self.struck_plate(0.2, 0.8, 1e-6)
        points = scene["Cracks > Notch > Points"]
        scene.set("Cracks > Notch > Points", [x - 0.02, *points[1:]])
        self.assert_refused(
            [self.write("wrong.xml", scene.text())],
            [("Cracks > Notch", ["Plate", "20 mm into Projectile", "Bonded To"])],
        )
        scene.set("Bodies > Plate > Bonded To", "Projectile")
        answer = rhegma(self.write("bonded.xml", scene.text()), "--check")
        self.assertEqual(answer.status, 0, answer)

    def test_fronts_that_are_wrong_do_not_choose_another_body(self):
        """A crack right through the plate, which has no front there, and 3 mm into the projectile."""
        scene, (x, y) = self.struck_plate(0.2, 0.8, 1e-6)
        scene.set("Cracks > Notch > Points", [x - 3e-3, y + 0.04, x + 0.11, y + 0.04]).set("Cracks > Notch > Fronts", "Last")
        scene.remove("Energy Release")
        answer = rhegma(self.write("wrong.xml", scene.text()), "--check")
        self.assertEqual(answer.status, 1, answer)
        self.assertIn("Fronts = Last makes a front of the end", answer.messages)
        self.assertIn("no material ahead", answer.messages)

    def test_what_is_refused(self):
        scene, _ = self.struck_plate(0.2, 0.8, 1e-6)
        for changes, words in (
            ({"Cracks > Formulation": "Broken Cell", "Cracks > Front Springs": False}, "Dual Field"),
            ({"Adaptivity > Levels": 1}, "equal cells"),
            ({"Combustion > Notch > Burn Law": "Vieille"}, "gas that leaves a crack does not see a body"),
        ):
            answer = rhegma(self.write("wrong.xml", scene.varied(changes).text()), "--check")
            self.assertEqual(answer.status, 1, answer)
            self.assertIn(words, answer.messages)

    def test_cracked_bodies_on_both_sides(self):
        """A crack in each of two bodies: momentum, and no more energy than at the start. Cracks that meet at less than three cells stop
        the run."""
        scene, (x, y) = self.struck_plate(0.0, 1.0, 1.5e-5)
        scene.set("Cracks > Other", {"Points": [x - 0.04, y + 0.03, x, y + 0.03]}).remove("Energy Release")
        summary, history = self.run_scene(scene)
        self.assert_conserves(history, summary["bodies"][0]["mass"] * 10.0)
        start = history["kinetic"][0]
        self.assertLess(max(abs(r) for r in history["residual"]), 0.005 * start)
        self.assertLess(max(k + s for k, s in zip(history["kinetic"], history["strain"])), 1.005 * start)
        for name in ("Projectile", "Plate"):
            scene.set(f"Bodies > {name} > Velocity", [300.0 if name == "Projectile" else 0.0, 0.0])
        scene.set("Bodies > Projectile > Lower Corner", [x - 0.08, y]).set("Bodies > Projectile > Upper Corner", [x - 0.008, y + 0.1])
        scene.set("Cracks > Other > Points", [x - 0.04, y + 0.05, x - 0.008, y + 0.05]).set("Time > Final Time", 3e-5)
        answer = rhegma(self.write("meet.xml", scene.text()), "--quiet", "--output", self.path("meet"))
        self.assertEqual(answer.status, 2, answer)
        self.assertIn("Other", answer.messages)
        self.assertIn("closer than three cells", answer.messages)

    def test_a_crack_grows_under_an_impact(self):
        """Momentum, the balance of energy, and that new faces have taken their toughness. The crack runs towards a body that lies on the
        plate, which is reported where it comes into the domain integral, and does not go on in it."""
        scene, (x, y) = self.struck_plate(0.0, 0.5, 5e-5)
        scene.set("Bodies > Projectile > Velocity", [30.0, 0.0]).set("Bodies > Cover", box([x, y + 0.1], [x + 0.1, y + 0.13]))
        scene.set("Domain > Upper Corner", [0.13, 0.16]).set("Propagation > Toughness", "8000")
        scene.set("Energy Release > Inner Radius", 0.01).set("Energy Release > Outer Radius", 0.02)
        summary, history = self.run_scene(scene)
        front = summary["cracks"][0]["fronts"][0]
        # Away from the struck half.
        self.assertGreater(front["turn"], 50.0)
        self.assertGreater(front["position"][1], y + 0.08)
        self.assertLess(front["position"][1], y + 0.1 + 1e-3)
        self.assertTrue([w for w in summary["warnings"] if "Energy Release: the body Cover comes within" in w], summary["warnings"])
        self.assert_conserves(history, summary["bodies"][0]["mass"] * 30.0)
        self.assertLess(abs(summary["propagation"]["dissipated_fraction"] - 1.0), 0.02)
        self.assertLess(max(abs(r) for r in history["residual"]), 0.005 * history["kinetic"][0])

    def test_continues_from_a_checkpoint(self):
        scene, _ = self.struck_plate(0.0, 0.8, 2e-5)
        scene.remove("Output > Checkpoints").set("Output > Checkpoint Interval", 4e-6).set("Propagation > Toughness", "2000")
        summary, whole = self.run_scene(scene, name="whole")
        self.run_scene(scene, "--set", f"Time:Maximum Steps={summary['steps'] // 2}", name="part")
        _, rest = self.run_scene(scene, "--restart", self.path("part", "checkpoint.h5"), name="part")
        for column, values in whole.items():
            self.assertEqual(values[-1], rest[column][-1], column)


if __name__ == "__main__":
    unittest.main()
