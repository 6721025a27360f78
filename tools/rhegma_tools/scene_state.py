"""What the program understands of a scene: its messages, and its fields before any motion, which it writes when it checks the scene."""

import os
import tempfile

from rhegma.fields import read_fields
from rhegma.problem import Problem
from rhegma.program import capture, errors_of
from rhegma.summary import read_summary


class State:
    """fields, summary: before any step; forces: {name of a load: its total force as text}; warnings: lines of the program"""

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


def write_state(scene, program, folder):
    """Has the program check the scene and write its state before any motion into a folder; a Problem with its message where the scene is wrong."""
    settings = [part for setting in scene.settings for part in ("--set", setting)]
    status, _, messages = capture([program, scene.path, "--check", "--quiet", "--state", folder, *settings])
    if status != 0:
        raise Problem("\n".join(errors_of(messages)) or f"{program} can't check the scene: exit status {status}.")


def state_in(folder):
    """The State of a scene that a program has written."""
    fields, summary = read_fields(folder), read_summary(folder, "check.json")
    if fields is None or summary is None:
        raise Problem(f"{folder} has no fields.h5 and check.json, which rhegma SCENE.xml --check --state writes.")
    fields.position = fields.position - fields.displacement
    fields.displacement = 0.0 * fields.displacement
    return State(fields, summary, forces_of("\n".join(summary.get("loads") or [])), [f"warning: {text}" for text in summary.get("warnings") or []])


def state_of(scene, program):
    """The State of a scene before any motion, as the program understands it."""
    with tempfile.TemporaryDirectory(prefix="rhegma-scene-") as folder:
        write_state(scene, program, os.path.join(folder, "state"))
        return state_in(os.path.join(folder, "state"))
