"""Studies of one scene that need no file: its runs at several cell sizes."""

import os

from rhegma.problem import Problem
from rhegma.scene import read_xml

from .lengths import metres
from .study_file import CELL, Run, Study


def read_scene(path):
    """The top list of a scene."""
    root = read_xml(path, "scene")
    if root.tag != "ParameterList" or root.get("name") == "Study":
        raise Problem(f"{path} is no scene; a study has the cell sizes of its families in its Sweep.")
    return root


def study_of_cells(path, texts):
    """A study of a scene at cell sizes [m], one run for each, coarse cells first."""
    read_scene(path)
    try:
        sizes = {metres(text): text for text in texts}
    except ValueError:
        raise Problem(f"--cell-sizes {' '.join(texts)}: must be numbers, in metres or with a unit: m, cm, mm or um.")
    if not all(0.0 < size < float("inf") for size in sizes):
        raise Problem(f"--cell-sizes {' '.join(texts)}: must be above zero and finite.")
    if len(sizes) < 3:
        raise Problem(f"--cell-sizes: an order and a limit need three sizes, and there are {len(sizes)}; for two, use rhegma --twice.")
    scene = os.path.abspath(path)
    name = os.path.splitext(os.path.basename(path))[0]
    runs = [Run(name, scene, {CELL: sizes[size]}, [], []) for size in sorted(sizes, reverse=True)]
    return Study(path, name, runs, [CELL])
