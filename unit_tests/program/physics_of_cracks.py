"""Wrong growth and pressures of cracks. See wrong_physics.py for what a template is."""

from file_scene import where
from physics_of_units import toughness


def limit_above_waves(scene, rng):
    """Speed Limit is above the speed of Rayleigh waves"""
    if not scene.has("Propagation") or not scene.moves():
        return None
    scene.set("Propagation > Speed Limit", 10 ** rng.uniform(4.5, 9))
    return where("Propagation", "Speed Limit")


def limit_below_a_cell(scene, rng):
    """Speed Limit is so small that no front advances by a cell"""
    if not scene.has("Propagation") or not scene.moves() or not scene.cell:
        return None
    scene.set("Propagation > Speed Limit", scene.cell / scene.get("Time > Final Time") * 10 ** rng.uniform(-6, -2))
    return where("Propagation", "Speed Limit")


def speeds_in_kilometres(scene, rng):
    """the speeds of the toughness are in km/s"""
    Gc = toughness(scene)
    E = scene.get(f"Materials > {scene.lists('Materials')[0]} > Young Modulus")
    if Gc is None or not scene.moves() or not isinstance(E, float) or E < 1.1e9:
        return None
    scene.set("Propagation > Toughness", f"{Gc}*(1 + v/{rng.uniform(0.1, 0.8)})")
    return where("Propagation", "Toughness")


def no_pressure(scene, rng):
    """the pressure in a crack is zero"""
    return pressed(scene, rng, "0")


def late_pressure(scene, rng):
    """the pressure in a crack rises in other units of time"""
    end, later = scene.get("Time > Final Time"), 10 ** rng.uniform(4, 7)
    return pressed(scene, rng, rng.choice([f"0:0, {end * later}:{10 ** rng.uniform(5, 8)}",
                                           f"2e6*min(1, t/{end * later})"]))


def pressed(scene, rng, pressure):
    names = scene.lists("Face Pressure")
    if not names:
        return None
    name = rng.choice(names)
    scene.set(f"Face Pressure > {name} > Pressure", pressure)
    return where("Face Pressure", name, "Pressure")
