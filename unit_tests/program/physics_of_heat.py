"""Wrong heat and temperatures. See wrong_physics.py for what a template is."""

import re

from file_scene import value_of, where


def source_of_nothing(scene, rng):
    """a heat source has no power up to the end"""
    names = scene.lists("Thermal > Sources")
    if not names:
        return None
    name = rng.choice(names)
    scene.set(f"Thermal > Sources > {name} > History",
              rng.choice(["0", f"0:0, {scene.get('Time > Final Time') * 10 ** rng.uniform(4, 7)}:1"]))
    return where("Thermal", "Sources", name)


def source_too_strong(scene, rng):
    """the power of a heat source evaporates its body"""
    names = scene.lists("Thermal > Sources")
    if not names:
        return None
    name = rng.choice(names)
    for element in scene.find(f"Thermal > Sources > {name}").iter("Parameter"):
        if element.get("name") in ("Power", "Power Density"):
            scene.put(element, value_of(element) * 10 ** rng.uniform(6, 9))
    return where("Thermal", "Sources", name)


def probe_away(scene, rng):
    """a probe is off the bodies"""
    if not scene.has("Thermal") or not scene.cell:
        return None
    corner, sign = rng.choice([("Lower Corner", -1), ("Upper Corner", 1)])
    away = [x + sign * rng.uniform(5, 500) * scene.cell for x in scene.get(f"Domain > {corner}")]
    probes = {"Far": {"Point": away}}
    if scene.has("Thermal > Probes"):
        scene.set("Thermal > Probes > Far", probes["Far"])
    else:
        scene.set("Thermal > Probes", probes)
    return where("Thermal", "Probes", "Far")


def heated_material(scene, rng):
    """Name of a material of a body in a scene with heat, or None."""
    bodies = scene.lists("Bodies")
    return scene.get(f"Bodies > {rng.choice(bodies)} > Material") if scene.has("Thermal") and bodies else None


def reference_in_celsius(scene, rng):
    """the reference temperature is in degrees Celsius"""
    name = heated_material(scene, rng)
    if name is None or scene.get("Thermal > Mechanics") == "false":
        return None
    scene.set(f"Materials > {name} > Reference Temperature", rng.uniform(5, 60))
    return where("Materials", name, "Reference Temperature")


def table_in_celsius(scene, rng):
    """a table of temperature is in degrees Celsius"""
    name = heated_material(scene, rng)
    place = f"Materials > {name} > Specific Heat"
    if name is None or not isinstance(scene.get(place), float) or scene.get("Thermal > Initial Temperature") < 200:
        return None
    heat = scene.get(place)
    scene.set(place, f"{rng.uniform(5, 20)}:{heat}, {rng.uniform(80, 130)}:{heat * rng.uniform(1.05, 1.5)}")
    return re.escape(place)


def strained_by_heat(scene, rng):
    """the thermal expansion is in 1e-3 per kelvin"""
    name = heated_material(scene, rng)
    place = f"Materials > {name} > Thermal Expansion"
    if name is None or scene.get("Thermal > Mechanics") == "false" or not isinstance(scene.get(place), float):
        return None
    if not 0 < scene.get(place) < 5e-4:  # of a scene in round numbers
        return None
    scene.set(place, 1e3 * scene.get(place))
    return re.escape(place)


def conductivity_of_nothing(scene, rng):
    """a conductivity is in other units"""
    name = heated_material(scene, rng)
    place = f"Materials > {name}"
    values = [scene.get(f"{place} > {p}") for p in ("Conductivity", "Specific Heat", "Density")] if name else [None]
    if not all(isinstance(v, float) and v > 0.0 for v in values):
        return None
    scene.set(place + " > Conductivity", values[1] * values[2] * 10 ** rng.uniform(-13.0, -9.5))
    return re.escape(place) + ": its thermal diffusivity"


def burning(scene, rng):
    """Path of a crack that burns, or None."""
    names = scene.lists("Combustion")
    return f"Combustion > {rng.choice(names)}" if names else None


def burns_at_once(scene, rng):
    """the burn coefficient is in mm/s and MPa"""
    place = burning(scene, rng)
    if place is None or scene.get(place + " > Burn Law", "Vieille") != "Vieille":
        return None
    scene.set(place + " > Burn Exponent", rng.uniform(0.7, 0.95)).set(place + " > Burn Coefficient", rng.uniform(1.0, 10.0))
    scene.set(place + " > Initial Pressure", 10 ** rng.uniform(5.0, 7.0))
    return re.escape(place) + ": its faces burn at"


def impossible_flame(scene, rng):
    """the flame is hotter or colder than any"""
    place = burning(scene, rng)
    if place is None:
        return None
    scene.set(place + " > Flame Temperature", rng.choice([rng.uniform(20.0, 390.0), 10 ** rng.uniform(4.0, 6.0)]))
    return re.escape(place + " > Flame Temperature")
