"""Numbers that no quantity has, wrong times and wrong damping. See wrong_physics.py for what a template is."""

import re

from file_scene import value_of, where


def no_step(scene, rng):
    """the final time is shorter than a step"""
    if not scene.moves() or not scene.has("Time > Final Time"):
        return None
    factor = 10 ** rng.uniform(-12, -7)
    scene.scale({"Final Time", "History Interval", "Field Interval", "Checkpoint Interval"}, factor)
    return where("Time", "Final Time")


def endless(scene, rng):
    """the final time is millions of times too long"""
    if not scene.moves() or scene.has("Time > Maximum Steps"):
        return None
    factor = 10 ** rng.uniform(6.5, 12)
    scene.scale({"Final Time", "History Interval", "Field Interval", "Checkpoint Interval"}, factor)
    return where("Time", "Final Time")


def heavy_damping(scene, rng):
    """the damping is in other units"""
    if not scene.moves() or not scene.lists("Bodies"):
        return None
    scene.set("Damping", {"Mass Rate": 10 ** rng.uniform(12, 16)} if not scene.has("Damping") else {
        "Mass Rate": max(scene.get("Damping > Mass Rate", 1e5), 1e5) * 10 ** rng.uniform(6, 8)})
    return where("Damping", "Mass Rate")


def damping_that_never_settles(scene, rng):
    """Mass Rate is far below what brings the body to rest"""
    if not scene.get("Damping > Stop When Settled") == "true" or any(
            scene.has(f"Damping > {v} Viscosity") for v in ("Shear", "Bulk")):
        return None
    scene.set("Damping > Mass Rate", rng.uniform(1, 10))
    return where("Damping", "Mass Rate") + ".* settled"


def rare_samples(scene, rng):
    """Stop When Settled is to see rest in samples that the run does not take"""
    if scene.get("Damping > Stop When Settled") != "true" or not scene.moves():
        return None
    most = scene.get("Time > Final Time") / (int(scene.get("Damping > Settled Samples", 5)) - 1)
    interval = most * 10 ** rng.uniform(0.1, 3)
    scene.set(*("Output > History Interval", interval) if scene.has("Output") else ("Output", {"History Interval": interval}))
    return where("Output", "History Interval")


NUMBERS = [("Domain > Thickness", [1e308, 1e-12]), ("Density", [1e30, 1e-30, -1200.0, 1e6]),
           ("Young Modulus", [1e40, -3e9, 1e-3]), ("Time > Final Time", [1e300, -1.0, 1e-100]),
           ("Value", [1e30, 1e200]), ("Force", [1e60]), ("Stress", [1e60]), ("Radius", [1e-40, 1e300, -1.0]),
           ("Poisson Ratio", [0.7, -2.0]), ("Specific Heat", [1e-20, 1e30, -5.0]), ("Conductivity", [1e20, -1.0]),
           ("Initial Temperature", [1e9, 20.0, -100.0]), ("Mass Rate", [1e200, -1.0]), ("Cell Size", [1e-80, 1e300]),
           ("Flame Temperature", [1e30, -4.0]), ("Acceleration", [1e40]), ("Velocity", [1e60]), ("CFL", [1e6, -1.0])]


def senseless_number(scene, rng):
    """a number that no quantity has"""
    found = []
    for section in scene.root:
        for element in section.iter("Parameter"):
            for name, values in NUMBERS:
                last = name.rsplit(" > ", 1)[-1]
                if element.get("name") == last and (" > " not in name or name.startswith(section.get("name"))):
                    if element.get("type") in ("double", "Array(double)") and section.get("name") != "Reference":
                        if scene.moves() or last not in ("Young Modulus", "Poisson Ratio", "Density"):
                            found.append((section.get("name"), element, values))
    if not found:
        return None
    section, element, values = rng.choice(found)
    value = rng.choice(values)
    old = value_of(element)
    scene.put(element, [value for x in old] if isinstance(old, list) else value)
    return re.escape(element.get("name")) + "|" + re.escape(section)


def damping_by_pic(scene, rng):
    """PIC damps waves"""
    if not scene.moves() or any(scene.has(s) for s in ("Mass Matrix", "Body Contact", "Rigid Tools")):
        return None
    scene.set("Time > PIC Fraction", rng.uniform(0.5, 1.0))
    return where("Time", "PIC Fraction")
