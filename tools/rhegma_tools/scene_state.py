"""What the program understands of a scene: its messages, and its fields after one step, from a run in a folder of its own."""

import os
import re
import tempfile

from rhegma.fields import read_fields
from rhegma.problem import Problem
from rhegma.program import FINISHED, capture, check_file, errors_of, lines_of
from rhegma.summary import read_summary


class State:
    """fields, summary: of the first step; forces: {name of a load: its total force as text}; warnings: lines of the program"""

    def __init__(self, fields, summary, forces, warnings):
        self.fields, self.summary, self.forces, self.warnings = fields, summary, forces, warnings


def forces_of(report):
    """{name: "600 N along (0, 1)"} from the lines of --check."""
    found = {}
    for line in report.splitlines():
        name, colon, text = line.strip().partition(": ")
        if colon and name.startswith("Boundaries > ") and " along " in text:
            found[name[len("Boundaries > "):]] = text
    return found


def check(scene, program):
    """(forces, warnings) of rhegma --check; a Problem with its message where the scene is wrong."""
    report, messages = check_file(scene.path, program, scene.settings)
    return forces_of(report), [line for line in lines_of(messages) if line.startswith("warning: ")]


def type_of(path, program):
    """The type of a parameter, such as "Time:Load Steps", as the program describes it; None where it does not know it."""
    status, text, _ = capture([program, "--describe", path])
    name = path.rpartition(":")[2]
    found = re.search(rf"^ +{re.escape(name)} +([A-Za-z]+(?:\([a-z]+\))?)", text, re.MULTILINE) if status == 0 else None
    return found and found.group(1)


def attempts(scene):
    """Copies of the scene, the cheapest first: some sections belong to an analysis of equilibrium only, and Domain > Accuracy chooses other
    cells for it than for motion."""
    equilibrium = scene.values.get("Time", {}).get("Analysis", "Dynamic") != "Dynamic"
    if equilibrium and "Accuracy" in scene.values.get("Domain", {}):
        yield scene.still(dynamic=False)
    yield scene.still()
    if equilibrium:
        yield scene.still(without=("Propagation",))
        yield scene.still(dynamic=False)


def first_step(scene, program, folder):
    """Runs the scene for one step. \\return the folder of its results"""
    path, results = os.path.join(folder, "scene.xml"), os.path.join(folder, "results")
    messages = ""
    for text in attempts(scene):
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        status, _, messages = capture([program, path, "--output", results, "--quiet"])
        if status in FINISHED:
            return results
    raise Problem("\n".join(errors_of(messages)) or f"{program} can't run the scene: exit status {status}.")


def state_of(scene, program):
    """The State of a scene before any motion."""
    forces, warnings = check(scene, program)
    scene.ask_types(lambda path: type_of(path, program))
    with tempfile.TemporaryDirectory(prefix="rhegma-scene-") as folder:
        results = first_step(scene, program, folder)
        fields = read_fields(results)
        if fields is None:
            raise Problem(f"{program} wrote no fields of the scene.")
        fields.position = fields.position - fields.displacement
        fields.displacement = 0.0 * fields.displacement
        return State(fields, read_summary(results) or {}, forces, warnings)
