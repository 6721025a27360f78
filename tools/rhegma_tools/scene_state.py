"""What the program understands of a scene: its messages, and its fields after one step, from a run in a folder of its own."""

import os
import subprocess
import tempfile

from rhegma.fields import read_fields
from rhegma.problem import Problem
from rhegma.summary import read_summary

FINISHED = (0, 4)  # exit statuses of a run that wrote its fields


class State:
    """fields, summary: of the first step; forces: {name of a load: its total force as text}; warnings: lines of the program"""

    def __init__(self, fields, summary, forces, warnings):
        self.fields, self.summary, self.forces, self.warnings = fields, summary, forces, warnings


def start(command):
    """(exit status, standard output, standard error) of the program."""
    try:
        result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True, errors="replace")
    except OSError as error:
        raise Problem(f"{command[0]} can't be started ({error.strerror}).")
    return result.returncode, result.stdout, result.stderr


def lines_of(messages):
    """Messages of the program without its name."""
    return [line[len("rhegma: "):] if line.startswith("rhegma: ") else line for line in messages.splitlines() if line.strip()]


def refused(messages, what):
    """A Problem with the program's own message."""
    errors = [line for line in lines_of(messages) if not line.startswith("warning: ")]
    return Problem("\n".join(errors) or what)


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
    settings = [part for setting in scene.settings for part in ("--set", setting)]
    status, report, messages = start([program, scene.path, "--check", *settings])
    if status != 0:
        raise refused(messages, f"{program} --check ended with exit status {status}.")
    return forces_of(report), [line for line in lines_of(messages) if line.startswith("warning: ")]


def attempts(scene):
    """Copies of the scene, the cheapest first: some sections belong to an analysis of equilibrium only."""
    yield scene.still()
    if scene.values.get("Time", {}).get("Analysis", "Dynamic") != "Dynamic":
        yield scene.still(without=("Propagation",))
        yield scene.still(dynamic=False)


def first_step(scene, program, folder):
    """Runs the scene for one step. \\return the folder of its results"""
    path, results = os.path.join(folder, "scene.xml"), os.path.join(folder, "results")
    messages = ""
    for text in attempts(scene):
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        status, _, messages = start([program, path, "--output", results, "--quiet"])
        if status in FINISHED:
            return results
    raise refused(messages, f"{program} can't run the scene: exit status {status}.")


def state_of(scene, program):
    """The State of a scene before any motion."""
    forces, warnings = check(scene, program)
    with tempfile.TemporaryDirectory(prefix="rhegma-scene-") as folder:
        results = first_step(scene, program, folder)
        fields = read_fields(results)
        if fields is None:
            raise Problem(f"{program} wrote no fields of the scene.")
        fields.position = fields.position - fields.displacement
        fields.displacement = 0.0 * fields.displacement
        return State(fields, read_summary(results) or {}, forces, warnings)
