#!/usr/bin/env python3
"""Whether Domain > Accuracy keeps its promise for cracks at rest in 2D: random scenes, of which the rule knows none.

    accuracy_at_rest.py PROGRAM [--seed N] [--number N] [--accuracy "3 %" ...] [--families NAME ...]     needs numpy and scipy

Scenes are drawn from these families (by default the first three), each in static equilibrium, with 2 x 2 or 3 x 3 particles a cell, linear functions or GIMP
(GIMP alone below 3 %, for which Accuracy refuses linear functions):

    inclined  a crack anywhere in a square of 6 to 80 half lengths, at any angle, under tension at any angle up to 60 degrees from its
              normal; the square's edges move as in the infinite plate (Westergaard), so that G is known in closed form
    strip     an edge crack through 5 to 60 % of a strip under tension, G by finite elements (xml_inputs/references/edge_crack.py)
    beam      a double cantilever beam with arms of 8 to 12 mm and a crack of 25 to 70 mm, G by the same elements
    beside    a crack with one to three neighbours, cracks and round holes, a twelfth to two of its half lengths away, in a wide plate
              under tension that opens all fronts (xml_inputs/references/cracks_and_holes.py); errors relative to G, or to a fifth of the scene's largest G

Prints the error of G_J at all fronts for each accuracy, how many of them are within it, and what the scenes cost.
"""
import argparse
import concurrent.futures
import json
import math
import os
import random
import re
import subprocess
import sys
import tempfile

INPUTS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../xml_inputs")
sys.path.insert(0, os.path.join(INPUTS, "references"))
sys.dont_write_bytecode = True

MODULUS, POISSON, STRESS = 3e9, 0.33, 5e4
FAMILIES = ("inclined", "inclined", "inclined", "strip", "beam")


def read(name):
    with open(os.path.join(INPUTS, name), encoding="utf-8") as file:
        return file.read()


def replaced(text, *pairs):
    for old, new in pairs:
        assert old in text, old
        text = text.replace(old, new)
    return text


def inclined(pick, widest=40):
    """A crack in a square whose edges move as in the infinite plate: text of the scene, G at each front."""
    a = 5e-3
    half = a * math.exp(pick.uniform(math.log(3), math.log(widest)))
    angle, turn = pick.uniform(-90, 90), math.radians(pick.uniform(-60, 60))
    x, y = (pick.uniform(2 * a - half, half - 2 * a) for _ in range(2))
    c, s = math.cos(turn), math.sin(turn)
    dx, dy = a * math.cos(math.radians(angle)), a * math.sin(math.radians(angle))
    text = replaced(read("verification/inclined_crack_static.xml"),
                    ("0.01625", "@domain@"), ("0.015", "@edge@"), ("0.00019", "(@x@)"), ("0.00013", "(@y@)"),
                    ("cos(30*pi/180)", "cos(%r*pi/180)" % angle), ("sin(30*pi/180)", "sin(%r*pi/180)" % angle),
                    ("P = 1e6*c*c; T = 1e6*s*c; N = 1e6*(s*s - c*c);",
                     "P = %r; T = (%r); N = (%r);" % (1e6 * c * c, -1e6 * s * c, 1e6 * (s * s - c * c))))
    text = re.sub(r"\{-0\.00414[^}]*\}", "{%r, %r, %r, %r}" % (x - dx, y - dy, x + dx, y + dy), text)
    # The cells may be as large as a quarter of the square, and nodes on its edge are held.
    rim = text.index('name="Rim"')
    text = text[:rim].replace("@edge@", repr(half)) + text[rim:].replace("@edge@", repr(half * (1 - 1e-7)))
    text = replaced(text, ("@domain@", repr(2 * half)), ("@x@", repr(x)), ("@y@", repr(y)))
    return text, [math.pi * a * 1e12 * c * c / MODULUS] * 2


def distance(crack, z):
    """From a point to a straight crack."""
    along = crack[1] - crack[0]
    s = min(1.0, max(0.0, ((z - crack[0]) / along).real))
    return abs(z - crack[0] - s * along)


def apart(one, other):
    """Between two shapes, cracks (start, end) or holes (centre, radius); negative where cracks cross."""
    if isinstance(one[1], float) and isinstance(other[1], float):
        return abs(one[0] - other[0]) - one[1] - other[1]
    if isinstance(one[1], float):
        return distance(other, one[0]) - one[1]
    if isinstance(other[1], float):
        return distance(one, other[0]) - other[1]
    sides = [[((z - a[0]) / (a[1] - a[0])).imag for z in b] for a, b in ((one, other), (other, one))]
    if all(first * second < 0 for first, second in sides):
        return -1.0
    return min(min(distance(one, z) for z in other), min(distance(other, z) for z in one))


def placed(pick, first):
    """The crack `first` and its neighbours: cracks, holes."""
    half = abs(first[1] - first[0]) / 2
    shapes, wanted = [first], pick.choice([2, 2, 3, 4])
    while len(shapes) < wanted:
        centre = complex(pick.uniform(-4, 4), pick.uniform(-4, 4)) * half
        size = half * math.exp(pick.uniform(math.log(0.15), math.log(1.5)))
        turn = pick.uniform(0, math.pi)
        tip = size * complex(math.cos(turn), math.sin(turn))
        shape = pick.choice([(centre - tip, centre + tip), (centre, size)])
        gap = half * math.exp(pick.uniform(math.log(0.08), math.log(2)))
        if 0.8 * gap < min(apart(shape, other) for other in shapes) < gap:
            shapes.append(shape)
    return [s for s in shapes if not isinstance(s[1], float)], [s for s in shapes if isinstance(s[1], float)]


def beside(pick):
    import cracks_and_holes  # needs numpy

    while True:
        turn = pick.uniform(0, math.pi)
        tip = 5e-3 * complex(math.cos(turn), math.sin(turn))
        cracks, holes = placed(pick, (-tip, tip))
        pull = math.pi / 2 + turn + math.radians(pick.uniform(-50, 50))
        c, s = math.cos(pull), math.sin(pull)
        stress = 1e6 * c * c, 1e6 * s * s, 1e6 * c * s
        intensities = cracks_and_holes.intensities(cracks, holes, stress)
        if min(k.real for k in intensities) > 0:  # all fronts open
            break
    half = 30 * 5e-3
    text = read("verification/inclined_crack_static.xml")
    strain = [(stress[k] - POISSON * stress[1 - k]) / MODULUS for k in range(2)] + [(1 + POISSON) * stress[2] / MODULUS]
    field = "(%r*x + (%r)*y)/2e-5, ((%r)*x + %r*y)/2e-5" % (strain[0], strain[2], strain[2], strain[1])
    text = re.sub(r'(name="Field" type="string" value=")[^"]*"', lambda found: found[1] + field + '"', text)
    rim = text.index('name="Rim"')
    text = text[:rim].replace("0.015", repr(half)) + text[rim:].replace("0.015", repr(half * (1 - 1e-7)))
    text = replaced(text, ("0.01625", repr(2 * half)))
    cuts = "".join('<ParameterList name="Hole %d"><Parameter name="Operation" type="string" value="Cut"/>'
                   '<Parameter name="Shape" type="string" value="Ball"/><Parameter name="Centre" type="Array(double)" value="{%r, %r}"/>'
                   '<Parameter name="Radius" type="double" value="%r"/></ParameterList>' % (k, z.real, z.imag, r) for k, (z, r) in enumerate(holes))
    if holes:
        body = text.index("</ParameterList>", text.index('name="Plate"'))
        text = text[:body] + '<ParameterList name="Operations">' + cuts + "</ParameterList>" + text[body:]
    lines = "".join('<ParameterList name="Notch %d"><Parameter name="Points" type="Array(double)" value="{%r, %r, %r, %r}"/></ParameterList>'
                    % (k, a.real, a.imag, b.real, b.imag) for k, (a, b) in enumerate(cracks))
    text = re.sub(r'(<ParameterList name="Cracks">).*?</ParameterList>\s*</ParameterList>', lambda found: found[1] + lines + "</ParameterList>",
                  text, flags=re.S)
    return text, [abs(k) ** 2 / MODULUS for k in intensities]


def by_elements(crack, **strip):
    """G [J/m2] of a crack in small strain, plane stress."""
    import edge_crack  # needs numpy and scipy

    edge_crack.STIFFNESS = MODULUS / (1 - POISSON**2) * edge_crack.np.array([[1, POISSON, 0], [POISSON, 1, 0], [0, 0, (1 - POISSON) / 2]])
    return edge_crack.release(min(crack, strip["width"] - crack) / 250, crack=crack, **strip)


def strip(pick):
    width = pick.uniform(0.02, 0.06)
    height = width * pick.uniform(1.2, 2.0)
    a, off = width * pick.uniform(0.05, 0.6), width * pick.uniform(-0.03, 0.03)
    text = replaced(read("examples/edge_crack.xml"), ('"Poisson Ratio" type="double" value="0.35"', '"Poisson Ratio" type="double" value="0.33"'))
    for pattern, new in ((r'<ParameterList name="Damping">.*?</ParameterList>', ""),
                         (r'(<ParameterList name="Time">).*?</ParameterList>',
                          r'\1<Parameter name="Analysis" type="string" value="Static"/>'
                          r'<Parameter name="Final Time" type="double" value="1e-3"/>'
                          r'<Parameter name="Rigid Modes" type="string" value="Remove"/></ParameterList>')):
        text = re.sub(pattern, new, text, flags=re.S)
    sets = {"Domain:Lower Corner": "{%r, %r}" % (-0.3 * width, -0.3 * width),
            "Domain:Upper Corner": "{%r, %r}" % (1.3 * width, 2 * height + 0.3 * width),
            "Bodies:Strip:Upper Corner": "{%r, %r}" % (width, 2 * height),
            "Boundaries:Top:From": "{%r, %r}" % (width, 2 * height), "Boundaries:Top:To": "{0, %r}" % (2 * height),
            "Boundaries:Top:Stress": "{0, %r}" % STRESS, "Boundaries:Bottom:Stress": "{0, %r}" % -STRESS,
            "Boundaries:Bottom:To": "{%r, 0}" % width,
            "Cracks:Notch:Points": "{0, %r, %r, %r}" % (height + off, a, height + off)}
    return (text, sets), [by_elements(a, stress=STRESS, width=width, height=height)]


def beam(pick):
    arm, a = pick.uniform(0.008, 0.012), pick.uniform(0.025, 0.07)
    sets = {"Domain:Upper Corner": "{0.11, %r}" % (2 * arm + 0.01), "Bodies:Beam:Upper Corner": "{0.1, %r}" % (2 * arm),
            "Boundaries:Upper Arm:From": "{0, %r}" % arm, "Boundaries:Upper Arm:To": "{0, %r}" % (2 * arm),
            "Boundaries:Lower Arm:To": "{0, %r}" % arm, "Boundaries:Upper Arm:Force": "{0, 1}", "Boundaries:Lower Arm:Force": "{0, -1}",
            "Cracks:Notch:Points": "{0, %r, %r, %r}" % (arm, a, arm)}
    return (read("verification/dcb_static.xml"), sets), [by_elements(a, stress=0.0, width=0.1, height=arm, force=1.0)]


def with_usual_answers(text, sets, pick):
    """A scene with the default contours, without references, and with random functions and particles."""
    for section in ("Reference", "Output"):
        text = re.sub(r'<ParameterList name="%s">.*?\n  </ParameterList>' % section, "", text, flags=re.S)
    text = re.sub(r'<ParameterList name="Energy Release">.*?</ParameterList>', '<ParameterList name="Energy Release"/>', text, flags=re.S)
    body = re.search(r'<ParameterList name="(Plate|Strip|Beam)">', text)[1]
    return text, dict(sets, **{"Domain:Shape Functions": pick.choice(["Linear", "GIMP"]),
                               "Bodies:%s:Particles Per Cell" % body: pick.choice([2, 3])})


def draw(seed, k, families=FAMILIES):
    """\\return (family, text, overrides, G at each front)"""
    pick = random.Random(1000 * seed + k)
    family = families[k % len(families)]
    scene, exact = {"inclined": inclined, "strip": strip, "beam": beam, "beside": beside}[family](pick)
    text, sets = scene if isinstance(scene, tuple) else (scene, {})
    text, sets = with_usual_answers(text, sets, pick)
    return family, text, sets, exact


def measure(program, scene, accuracy):
    """\\return (errors of G at the fronts, particles, seconds of the whole process)"""
    _, text, sets, exact = scene
    if float(accuracy[:-1]) < 3:
        sets = dict(sets, **{"Domain:Shape Functions": "GIMP"})
    text = re.sub(r'<Parameter name="Cell Size"[^>]*/>', '<Parameter name="Accuracy" type="string" value="%s"/>' % accuracy, text)
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "scene.xml")
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        command = [program, path, "--output", os.path.join(folder, "out"), "--quiet"]
        for name, value in sets.items():
            command += ["--set", "%s=%s" % (name, value)]
        child = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        messages = child.stderr.read()
        _, status, usage = os.wait4(child.pid, 0)
        if os.waitstatus_to_exitcode(status) != 0:
            print(" ".join(command) + "\n" + messages, file=sys.stderr, flush=True)
            return [1.0] * len(exact), 0, 0.0
        with open(os.path.join(folder, "out", "summary.json"), encoding="utf-8") as file:
            found = json.load(file)
    values = [front["G_J"] for crack in found["cracks"] for front in crack["fronts"]]
    if len(values) != len(exact):
        return [1.0] * len(exact), found["particles"], usage.ru_utime + usage.ru_stime  # a front counts as broken through
    errors = [(value - right) / max(right, 0.2 * max(exact)) for value, right in zip(values, exact)]
    return errors, found["particles"], usage.ru_utime + usage.ru_stime


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("program")
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--number", type=int, default=100, help="of scenes")
    options.add_argument("--accuracy", nargs="*", default=["10 %", "3 %", "1 %"])
    options.add_argument("--families", nargs="*", default=FAMILIES, choices=sorted(set(FAMILIES)) + ["beside"])
    chosen = options.parse_args()
    print("seed %d" % chosen.seed, flush=True)
    scenes = [draw(chosen.seed, k, chosen.families) for k in range(chosen.number)]
    print("%8s %9s %7s %8s %8s %8s %8s %10s %9s" % ("accuracy", "family", "fronts", "within", "rms %", "95th %", "worst %", "particles",
                                                   "CPU s"), flush=True)
    for accuracy in chosen.accuracy:
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            found = list(pool.map(lambda scene: measure(chosen.program, scene, accuracy), scenes))
        for family in sorted(set(chosen.families)) + ["all"]:
            rows = [(k, row) for k, (scene, row) in enumerate(zip(scenes, found)) if family in (scene[0], "all")]
            errors = sorted((abs(error), error, k) for k, row in rows for error in row[0])
            within = sum(error[0] <= 0.01 * float(accuracy[:-1]) for error in errors) / len(errors)
            print("%8s %9s %7d %7.1f%% %8.2f %8.2f %+8.2f %10d %9.2f   worst: scene %d"
                  % (accuracy, family, len(errors), 100 * within, 100 * math.sqrt(sum(e * e for e, _, _ in errors) / len(errors)),
                     100 * errors[math.ceil(0.95 * len(errors)) - 1][0], 100 * errors[-1][1],
                     sorted(row[1] for _, row in rows)[len(rows) // 2], sorted(row[2] for _, row in rows)[len(rows) // 2], errors[-1][2]),
                  flush=True)


if __name__ == "__main__":
    main()
