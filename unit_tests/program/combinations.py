"""Random combinations of effects, formulations and schemes: tiny scenes, drawn so that every pair of choices comes together.

The choices of a parameter are read from the reference that the program prints, so that a new one is drawn by itself."""

import atexit
import functools
import itertools
import math
import os
import re
import shutil
import tempfile

from program import SOURCE, rhegma
from scenes import Scene

from rhegma_tools.law_library import build

# Choices that other tests draw, or that a scene as small as these can't show.
NOT_HERE = {"Rigid"}


class Reference:
    """What `rhegma --describe-markdown` prints."""

    def __init__(self):
        self.text = rhegma("--describe-markdown").output
        self.sections = {}
        for part in re.split(r"^#+ ", self.text, flags=re.M)[1:]:
            title, _, body = part.partition("\n")
            self.sections[title.replace("\\", "")] = body

    def choices(self, section, parameter):
        """The texts that a parameter may have, in their order."""
        row = re.search(rf"^\| {re.escape(parameter)} \|(.*)$", self.sections[section], re.M).group(1)
        allowed = re.search(r"one of ([^|;]*)", row).group(1).strip()
        return [c for c in re.split(r", | or ", allowed) if c not in NOT_HERE]

    def rejections(self):
        """Rows (combination, reason) of all tables of what does not go together."""
        rows = []
        for body in self.sections.values():
            table = re.search(r"^\| Rejected combination \|.*\n\|[-:|]*\n((?:\|.*\n)*)", body, re.M)
            if table:
                rows += [tuple(c.strip() for c in row.strip("|").split(" | ", 1)) for row in table.group(1).splitlines()]
        return [(combination, reason.rstrip("| ")) for combination, reason in rows]


def factors(reference):
    """Each factor with its levels; the first is the plainest."""
    of = reference.choices
    none = "none"
    return {
        "Dimension": ["2", "3"],
        "Plane": of("Domain", "Plane"),
        "Shape Functions": of("Domain", "Shape Functions"),
        "Formulation": of("Domain", "Formulation"),
        "Shear Strain": of("Domain", "Shear Strain"),
        "Analysis": of("Time", "Analysis"),
        "Initial State": of("Time", "Initial State"),
        "Update Scheme": of("Time", "Update Scheme"),
        "Model": of("Materials > <material>", "Model"),
        "Cracks": [none, *of("Cracks", "Formulation")],
        "Front Springs": ["yes", "no"],
        "Contact": [none, *of("Contact", "Law")],
        "Energy Release": [none, "J", "J and closure"],
        "Propagation": [none, *of("Propagation", "Direction")],
        "Load Control": of("Propagation", "Load Control"),
        "Mass Matrix": [none, *of("Mass Matrix", "Type")],
        "Velocity Update": of("Mass Matrix", "Velocity Update"),
        "Adaptivity": [none, "1", "2"],
        "Sub-Cycling": [none, "yes"],
        "Damping": [none, "Mass Rate", "Shear Viscosity"],
        "Thermal": [none, *of("Thermal", "Conduction"), "heat only"],
        "Crack Faces": of("Thermal > Crack Faces > <crack>", "Conduction"),
        "Face Pressure": [none, "yes"],
        "Combustion": [none, *of("Combustion > <crack>", "Gas Model")],
        "Body Contact": [none, *of("Body Contact", "Law")],
        "Load": ["tension", "shear", "pressed"],
        "Rotation": ["0", "20"],
    }


# A factor is what a row of the reference names: sections by their own names, parameters by theirs.
NAMED = ("Time > Analysis", "Analysis"), ("Initial State", "Initial State"), ("Update Scheme", "Update Scheme"), (
    "Shear Strain", "Shear Strain"), ("Velocity Update", "Velocity Update"), ("Model", "Model"), ("Formulation", "Cracks"), (
    "Front Springs", "Front Springs"), ("Load Control", "Load Control"), ("Domain > Formulation", "Formulation"), (
    "Thermal > Conduction", "Thermal"), ("Crack Faces", "Crack Faces"), ("PIC", "Velocity Update"), ("3D", "Dimension"), ("thermal strain", "Thermal")
SECTIONS = ("Cracks", "Contact", "Energy Release", "Propagation", "Mass Matrix", "Adaptivity", "Sub-Cycling", "Damping", "Thermal",
            "Face Pressure", "Combustion", "Body Contact")


def named_by(combination, drawn, levels):
    """Factors that a rejected combination names and that are not at their plainest."""
    found = {factor for words, factor in NAMED if words in combination}
    found |= {section for section in SECTIONS if section in combination}
    return sorted(f for f in found if drawn[f] != levels[f][0])


def effective(drawn):
    """The factors that act: what has no section has no choices within it."""
    acts = dict(drawn)
    if acts["Cracks"] == "none":
        for name in ("Front Springs", "Contact", "Energy Release", "Propagation", "Face Pressure", "Combustion"):
            acts.pop(name)
    if acts["Dimension"] == "3":
        acts.pop("Plane")
    if acts.get("Propagation", "none") == "none" or acts["Analysis"] == "Dynamic":
        acts.pop("Load Control")
    if acts["Mass Matrix"] == "none":
        acts.pop("Velocity Update")
    if acts["Cracks"] == "none" or acts["Thermal"] == "none":
        acts.pop("Crack Faces")
    return acts


def pairs_of(drawn):
    """Pairs of levels that come together, and triples of cracks, refined cells and anything else."""
    items = sorted(effective(drawn).items())
    together = set(itertools.combinations(items, 2))
    main = [i for i in items if i[0] in ("Cracks", "Adaptivity")]
    if len(main) == 2:
        together |= {(*main, other) for other in items if other not in main}
    return together


def drawn_at_random(levels, random, plain):
    """A combination; each factor is at its plainest with the probability `plain`, else anywhere."""
    return {name: all_of[0] if random.random() < plain else random.choice(all_of) for name, all_of in levels.items()}


def most_new(levels, random, seen, tries=40):
    """Of some random combinations the one with the most pairs that have not come together yet."""
    return max((drawn_at_random(levels, random, random.choice((0.3, 0.5, 0.7))) for _ in range(tries)),
               key=lambda drawn: len(pairs_of(drawn) - seen))


CELL = 1e-3  # [m]


@functools.lru_cache(maxsize=None)
def shared_law():
    """Path of a library with the equations of J2 Plastic as a VUMAT."""
    folder = tempfile.mkdtemp()
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    path = os.path.join(folder, "j2.so")
    build(os.path.join(SOURCE, "unit_tests", "laws", "j2_vumat.c"), path)
    return path


def material(model):
    """Constants of one stiffness. Metals yield at 10 MPa: at fronts, but not across what a crack leaves of a body."""
    soft = {"Model": model, "Density": 1200.0}
    if model == "Orthotropic":
        soft.update({"Young Moduli": [4e9, 2e9, 3e9], "Shear Moduli": [1.1e9, 1e9, 1.2e9], "Poisson Ratios": [0.3, 0.2, 0.25]})
    elif model == "Mooney-Rivlin":
        soft.update({"C10": 3e8, "C01": 2.6e8, "Bulk Modulus": 3e9})
    elif model == "Ogden":
        soft.update({"Moduli": [1.5e9, -5e7], "Exponents": [1.3, -3.0], "Bulk Modulus": 3e9})
    elif model == "Fluid":
        soft.update({"Equation Of State": "Tait", "Bulk Modulus": 3e9, "Viscosity": 1.0})
    else:
        soft.update({"Young Modulus": 3e9, "Poisson Ratio": 0.33})
    if model == "J2 Plastic":
        soft.update({"Yield Stress": 1e7, "Hardening Modulus": 1e8})
    elif model == "Shared Library":
        soft.update({"Library File": shared_law(), "Constants": [3e9, 0.33, 1e7, 1e8]})
    elif model == "Viscoelastic":
        soft.update({"Relaxation Times": [1e-5, 1e-3], "Shear Fractions": [0.3, 0.2]})
    elif model == "ViscoSCRAM":
        soft.update({"Relaxation Times": [1e-5, 1e-3], "Shear Fractions": [0.3, 0.2], "Initial Crack Radius": 3e-5, "Crack Length Scale": 1e-4,
                     "Crack Toughness": 3e4, "Crack Friction": 0.3, "Crack Growth Exponent": 10.0, "Maximum Crack Speed": 0.5})  # small cracks grow by a tenth in a millisecond
    elif model == "High-Rate Solid":
        soft.update({"Johnson-Cook A": 1e7, "Johnson-Cook B": 1e7, "Johnson-Cook n": 0.3, "Johnson-Cook C": 0.02})
    return soft


def scene_of(drawn, random):
    """The scene of a combination. Positions in the cells, the tilt of the crack and loads are drawn, too."""
    three = drawn["Dimension"] == "3"
    size = [10, 8, 8] if three else [16, 12]
    cells = [random.uniform(-0.45, 0.45) for _ in size]
    away = 10 if not three and drawn["Plane"] == "Axisymmetric" else 0  # cells from the axis of a ring, whatever its turn
    cells[0] += away
    low = [CELL * (n + 0.05) for n in cells]
    high = [CELL * (n + s + random.uniform(-0.2, 0.2)) for n, s in zip(cells, size)]
    axis = len(size) - 1  # cracks lie across it, loads act along it

    def vector(*numbers):
        """Two numbers along x and the loaded axis, zero along y in 3D."""
        return [numbers[0], 0.0, numbers[1]] if three else list(numbers)

    dynamic = drawn["Analysis"] == "Dynamic"
    end = (1e-5 if three else 2e-5) if dynamic else 1e-3
    body = {"Material": "Solid", "Shape": "Box", "Lower Corner": low, "Upper Corner": high}
    if drawn["Rotation"] != "0":
        body.update({"Rotation": float(drawn["Rotation"])})
        if three:
            body["Rotation Axis"] = [0.0, 1.0, 0.0]
    solid = material(drawn["Model"])
    heat = drawn["Thermal"] != "none"
    if heat:
        solid.update({"Specific Heat": 1400.0, "Conductivity": 0.2, "Thermal Expansion": 7e-5})
    domain = {
        "Dimension": len(size),
        "Lower Corner": [(away - 6) * CELL] + [-6 * CELL] * (len(size) - 1),
        "Upper Corner": [CELL * (size[0] + 9 + away)] + [CELL * (s + 9) for s in size[1:]],
        "Cell Size": CELL,
        "Shape Functions": drawn["Shape Functions"],
        "Formulation": drawn["Formulation"],
        "Shear Strain": drawn["Shear Strain"],
    }
    if not three:
        domain["Plane"] = drawn["Plane"]
    middle = [0.5 * (a + b) for a, b in zip(low, high)]
    stress = {"tension": vector(0.3e6, 2e6), "shear": vector(1.5e6, 0.5e6), "pressed": vector(0.8e6, -2e6)}[drawn["Load"]]
    # Loads act on the end of the body, wherever its turn has taken that.
    angle = math.radians(float(drawn["Rotation"])) * (-1.0 if three else 1.0)

    def turned(point):
        x, z = point[0] - middle[0], point[axis] - middle[axis]
        other = list(point)
        other[0] = middle[0] + x * math.cos(angle) - z * math.sin(angle)
        other[axis] = middle[axis] + x * math.sin(angle) + z * math.cos(angle)
        return other

    def at(x, z, y=None):
        """A point of the body: fractions along its axes."""
        point = [low[0] + x * (high[0] - low[0]), low[axis] + z * (high[axis] - low[axis])]
        if three:
            point.insert(1, low[1] + (0.5 if y is None else y) * (high[1] - low[1]))
        return turned(point)

    top = {"Type": "Traction", "Body": "Block", "Stress": stress, "History": f"min(1, t / {0.5 * end!r})"}
    if three:
        corner, along, across = at(0, 1, 0), at(1, 1, 0), at(0, 1, 1)
        top.update({"Corner": corner, "Edge 1": [b - a for a, b in zip(corner, along)],
                    "Edge 2": [b - a for a, b in zip(corner, across)]})
    else:
        top.update({"From": at(0, 1), "To": at(1, 1)})
    foot = [at(x, 0, y) for x in (0, 1) for y in (0, 1)]
    reach = 0.8 * CELL
    held = {
        "Type": "Velocity", "Value": [0.0] * len(size), "Box Motion": "Fixed",
        "Lower Corner": [min(p[i] for p in foot) - reach for i in range(len(size))],
        "Upper Corner": [max(p[i] for p in foot) + reach for i in range(len(size))],
    }
    scene = Scene({
        "Domain": domain,
        "Time": {"Final Time": end, "Analysis": drawn["Analysis"], "Update Scheme": drawn["Update Scheme"],
                 "Initial State": drawn["Initial State"]},
        "Materials": {"Solid": solid},
        "Bodies": {"Block": body},
        "Boundaries": {"Foot": held, "Top": top},
        "Output": {"History Interval": end / 10.0, "Fields": False, "Checkpoint Interval": 0.2 * end},
    })
    if not dynamic:
        scene.set("Time > Load Steps", 4)
    if drawn["Cracks"] != "none":
        add_crack(scene, drawn, at, random, three)
    if drawn["Body Contact"] != "none":
        add_striker(scene, drawn, low, high, random)
    add_effects(scene, drawn, end, heat)
    return scene


def add_striker(scene, drawn, low, high, random):
    """A second body beside the first, a part of a cell away, which hits it."""
    gap = random.uniform(0.05, 0.3) * CELL
    if drawn["Rotation"] != "0":
        gap += 4 * CELL  # beside the turned body, which it may miss
    scene.set("Bodies > Striker", {
        "Material": "Solid", "Shape": "Box", "Lower Corner": [high[0] + gap, *low[1:]],
        "Upper Corner": [high[0] + gap + 2.3 * CELL, *(0.5 * (a + b) for a, b in zip(low[1:], high[1:]))],
        "Velocity": [-random.uniform(5.0, 30.0), *[0.0] * (len(low) - 1)]})
    scene.set("Body Contact", {"Law": drawn["Body Contact"]})
    if drawn["Body Contact"] == "Coulomb":
        scene.set("Body Contact > Friction Coefficient", 0.3)


def add_crack(scene, drawn, at, random, three):
    length, height, tilt = random.uniform(0.35, 0.5), random.uniform(0.45, 0.62), random.uniform(-0.08, 0.08)
    if three:
        points = [*at(-0.05, height, -0.05), *at(length, height + tilt, -0.05), *at(length, height + tilt, 1.05),
                  *at(-0.05, height, 1.05)]
    else:
        points = [*at(0.0, height), *at(length, height + tilt)]
    cracks = {"Formulation": drawn["Cracks"], "Notch": {"Points": points}}
    if drawn["Front Springs"] == "no":
        cracks["Front Springs"] = False
    scene.set("Cracks", cracks)
    if drawn["Contact"] != "none":
        scene.set("Contact", {"Law": drawn["Contact"]})
        if drawn["Contact"] == "Coulomb":
            scene.set("Contact > Friction Coefficient", 0.3)
    if drawn["Energy Release"] != "none":
        scene.set("Energy Release", {} if three else {"Crack Closure": drawn["Energy Release"] != "J"})
    if drawn["Propagation"] != "none":
        scene.set("Propagation", {"Toughness": "1", "Direction": drawn["Propagation"], "On Stop": "Continue"})
        if drawn["Model"] == "Orthotropic" and drawn["Analysis"] == "Dynamic":
            scene.set("Propagation > Speed Limit", 800.0)  # its Rayleigh waves have no one speed
        if drawn["Analysis"] != "Dynamic":
            scene.set("Propagation > Load Control", drawn["Load Control"])
    if drawn["Face Pressure"] != "none":
        scene.set("Face Pressure", {"Notch": {"Pressure": "1e5"}})
    if drawn["Combustion"] != "none":
        scene.set("Combustion", {"Notch": {
            "Burn Law": "Vieille", "Burn Coefficient": 1e-8, "Burn Exponent": 0.9, "Gas Constant": 320.0, "Flame Temperature": 2500.0,
            "Gas Model": drawn["Combustion"], "Initial Gap": 1e-6, "Cavity Volume": 1e-9}})
        if drawn["Combustion"] == "Flow":
            scene.set("Combustion > Notch > Viscosity", 5e-5)


def add_effects(scene, drawn, end, heat):
    if drawn["Mass Matrix"] != "none":
        scene.set("Mass Matrix", {"Type": drawn["Mass Matrix"], "Velocity Update": drawn["Velocity Update"]})
    if drawn["Adaptivity"] != "none":
        scene.set("Adaptivity", {"Maximum Level": int(drawn["Adaptivity"]), "Front Cells": 2.0 if drawn["Dimension"] == "2" else 1.0})
        if drawn["Cracks"] == "none":
            scene.set("Adaptivity > Near", {
                "Lower Corner": scene["Bodies > Block > Lower Corner"], "Level": int(drawn["Adaptivity"]),
                "Upper Corner": [a + 5 * CELL for a in scene["Bodies > Block > Lower Corner"]]})
    if drawn["Sub-Cycling"] != "none":
        scene.set("Sub-Cycling", {})
    if drawn["Damping"] != "none":
        scene.set("Damping", {drawn["Damping"]: 1e4 if drawn["Damping"] == "Mass Rate" else 20.0})
    if heat:
        scene.set("Thermal", {"Initial Temperature": 300.0})
        if drawn["Thermal"] == "heat only":
            scene.set("Thermal > Mechanics", False)
        else:
            scene.set("Thermal > Conduction", drawn["Thermal"])
        if drawn["Thermal"] == "Steady":
            held = scene["Boundaries > Foot"]
            scene.set("Boundaries > Cold", {"Type": "Temperature", "Temperature": 300.0, "Lower Corner": held["Lower Corner"],
                                            "Upper Corner": held["Upper Corner"]})
        if drawn["Cracks"] != "none":
            scene.set("Thermal > Crack Faces > Notch > Conduction", drawn["Crack Faces"])
        scene.set("Thermal > Sources > Spot", {
            "Type": "Box", "Lower Corner": scene["Bodies > Block > Lower Corner"],
            "Upper Corner": [a + 4 * CELL for a in scene["Bodies > Block > Lower Corner"]],
            # What heats the body in the steps of a scene would melt it in the end.
            "Power Density": 1e5 if drawn["Thermal"] == "Steady" else 1e9})
