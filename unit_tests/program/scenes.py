"""Right scenes, and changes that make them wrong."""

import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", "..", "tools"))

from rhegma.scene import Scene  # noqa: E402


def plate():
    """A square that is pulled at its right edge and has a notch: 1,600 particles, a few steps."""
    return Scene(
        {
            "Domain": {
                "Dimension": 2,
                "Lower Corner": [-0.2, -0.2],
                "Upper Corner": [1.2, 1.2],
                "Cell Size": 0.05,
            },
            "Time": {"Final Time": 1e-3},
            "Materials": {
                "Polymer": {
                    "Model": "Linear Elastic",
                    "Density": 1200.0,
                    "Young Modulus": 3e9,
                    "Poisson Ratio": 0.33,
                }
            },
            "Bodies": {
                "Plate": {
                    "Material": "Polymer",
                    "Shape": "Box",
                    "Lower Corner": [0.0, 0.0],
                    "Upper Corner": [1.0, 1.0],
                }
            },
            "Boundaries": {
                "Pull": {
                    "Type": "Traction",
                    "Body": "Plate",
                    "From": [1.0, 0.0],
                    "To": [1.0, 1.0],
                    "Stress": [1e5, 0.0],
                }
            },
            "Cracks": {"Notch": {"Points": [0.0, 0.5, 0.5, 0.5]}},
            "Energy Release": {"Inner Radius": 0.15, "Outer Radius": 0.3},
        }
    )


def too_long_a_step():
    """Stresses updated last, in steps at the limit, in a cut grid: a burst. Steps of a quarter last longer."""
    scene = plate().remove("Cracks").remove("Energy Release").remove("Boundaries")
    scene.set("Domain > Shape Functions", "Linear").set("Time > CFL", 1.0).set("Time > Update Scheme", "USL")
    scene.set("Bodies > Plate > Lower Corner", [0.02, 0.02]).set("Bodies > Plate > Rotation", 20.0)
    scene.set("Bodies > Plate > Velocity", [5.0, 3.0]).set("Bodies > Plate > Angular Velocity", [40.0])
    scene.set("Domain > Upper Corner", [1.6, 1.6]).set("Domain > Lower Corner", [-0.6, -0.6])
    return scene.set("Time > Final Time", 1e-3).set("Output", {"History Interval": 1e-5, "Field Interval": 1e-4})


def ball():
    """A falling ball in three dimensions."""
    return Scene(
        {
            "Domain": {
                "Dimension": 3,
                "Lower Corner": [-0.1, -0.1, -0.1],
                "Upper Corner": [0.1, 0.1, 0.1],
                "Cell Size": 0.02,
            },
            "Time": {"Final Time": 1e-3},
            "Materials": {
                "Rubber": {
                    "Model": "Neo-Hookean",
                    "Density": 1000.0,
                    "Young Modulus": 1e7,
                    "Poisson Ratio": 0.3,
                }
            },
            "Bodies": {
                "Ball": {"Material": "Rubber", "Shape": "Ball", "Centre": [0.0, 0.0, 0.0], "Radius": 0.06}
            },
            "Boundaries": {"Weight": {"Type": "Gravity", "Acceleration": [0.0, 0.0, -9.81]}},
        }
    )


def empty_grid(count):
    """A scene for many parts, with their positions at distances of 1, and the side of a square around them."""
    side = int(count**0.5) + 1
    scene = plate().remove("Cracks").remove("Energy Release").remove("Boundaries").remove("Bodies")
    scene.set("Domain > Lower Corner", [-1.0, -1.0]).set("Domain > Upper Corner", [side + 1.0, side + 1.0])
    scene.set("Domain > Cell Size", 0.25).set("Domain > Shape Functions", "Linear")
    scene.set("Boundaries", {"Weight": {"Type": "Gravity", "Acceleration": [0.0, -9.81]}})
    return scene, [(float(k % side), float(k // side)) for k in range(count)], float(side)


def many_bodies(count, **different):
    """Boxes of four particles each, which do not touch."""
    scene, positions, _ = empty_grid(count)
    rest = {"Material": "Polymer", "Shape": "Box", "Particles Per Cell": 1, **different}
    return scene.set("Bodies", {f"Body {k}": {"Lower Corner": [x, y], "Upper Corner": [x + 0.5, y + 0.5], **rest}
                                for k, (x, y) in enumerate(positions)})


def many_cracks(count):
    """Short cracks in one plate, a crack to 16 particles: cracks have to be three cells apart."""
    scene, positions, side = empty_grid(count)
    scene.set("Bodies", {"Plate": {"Material": "Polymer", "Shape": "Box", "Particles Per Cell": 1,
                                   "Lower Corner": [0.0, 0.0], "Upper Corner": [side, side]}})
    return scene.set("Cracks", {f"Crack {k}": {"Points": [x + 0.4, y + 0.4, x + 0.6, y + 0.4]}
                                for k, (x, y) in enumerate(positions)})
