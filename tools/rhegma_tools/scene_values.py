"""The values of a scene file, and a copy of the scene from which the program writes its state before any motion."""

import copy
import os
import xml.etree.ElementTree as ElementTree

from rhegma.problem import Problem
from rhegma.scene import move_files
from rhegma.values import split_array

from .scene_study import read_scene
from .unit_factor import in_si


def as_values(element):
    """A list of parameters as {name: text, or such a list}, in the order of the file; numbers in SI units."""
    return {entry.get("name"): as_values(entry) if entry.tag == "ParameterList"
            else in_si(entry.get("name"), (entry.get("value") or "").strip(), entry.get("unit")) for entry in element}


def lists(values, *names):
    """[(name, values)] of the sublists of a list at names within lists; empty where there is none."""
    for name in names:
        values = values.get(name)
        if not isinstance(values, dict):
            return []
    return [(name, one) for name, one in values.items() if isinstance(one, dict)]


def number(values, name, default=None):
    """A number of a list, or the default where it is absent."""
    try:
        return float(values[name])
    except (KeyError, TypeError, ValueError):
        return default


def array(values, name, default=None):
    """An array of a list as numbers, or the default where it is absent."""
    try:
        return [float(text) for text in split_array(values[name], name)]
    except (Problem, AttributeError, KeyError, TypeError, ValueError):
        return default


def find_or_add(element, name):
    """The sublist of this name, made where there is none."""
    found = next((entry for entry in element if entry.tag == "ParameterList" and entry.get("name") == name), None)
    return ElementTree.SubElement(element, "ParameterList", name=name) if found is None else found


def write_value(root, path, value, kind="string"):
    """Sets a parameter. path: names from the outermost list inwards; kind: its type where the scene lacks it. \\return whether it does"""
    for name in path[:-1]:
        root = find_or_add(root, name)
    found = next((entry for entry in root if entry.tag == "Parameter" and entry.get("name") == path[-1]), None)
    lacks = found is None
    if lacks:
        found = ElementTree.SubElement(root, "Parameter", name=path[-1], type=kind)
    found.set("value", value)
    found.attrib.pop("unit", None)  # that of the value before
    return lacks


def remove(root, *path):
    """Removes a parameter or a list, where it is there."""
    for name in path[:-1]:
        root = next((entry for entry in root if entry.get("name") == name), None)
        if root is None:
            return
    for entry in [entry for entry in root if entry.get("name") == path[-1]]:
        root.remove(entry)


class Scene:
    """A scene file with the values of --set. path: of the file; settings: texts such as "Domain:Cell Size=1e-3"."""

    def __init__(self, path, settings=()):
        self.path, self.settings = path, list(settings)
        self.root = read_scene(path)
        self.added = []  # parameters that the scene lacks, as lists of names: of what type they are the program knows
        for setting in settings:
            name, equals, value = setting.partition("=")
            names = [part.strip() for part in name.split(":")]
            if not equals or len(names) < 2:
                raise Problem(f'--set is "{setting}"; write it as Section:Parameter=value.')
            if write_value(self.root, names, value.strip()):
                self.added.append(names)
        folder = os.path.dirname(os.path.abspath(path))
        move_files(self.root, lambda file: os.path.join(folder, file))  # a copy of the scene is elsewhere
        self.values = as_values(self.root)

    def ask_types(self, type_of):
        """Gives the parameters of --set that the scene lacks their types. type_of: (path such as "Time:Load Steps") -> such as "int", or None"""
        for names in self.added:
            kind = type_of(":".join(names))
            entry = self.root
            for name in names:
                entry = next(child for child in entry if child.get("name") == name)
            if kind:
                entry.set("type", kind)

    @property
    def dimension(self):
        return 3 if self.values.get("Domain", {}).get("Dimension") == "3" else 2

    def still(self, without=(), dynamic=True):
        """The text of a copy that ends after one step and writes its fields. without: sections that are left out; dynamic: an analysis of
        equilibrium becomes one of motion, whose step costs next to nothing."""
        root = copy.deepcopy(self.root)
        for section in ("Reference", *without):
            remove(root, section)
        write_value(root, ["Time", "Maximum Steps"], "1", "int")
        write_value(root, ["Output", "Fields"], "true", "bool")
        write_value(root, ["Output", "Checkpoints"], "false", "bool")
        for name in ("Checkpoint Interval", "Checkpoint Minutes", "Field Interval"):
            remove(root, "Output", name)
        if dynamic:
            for name in ("Analysis", "Initial State", "Load Steps", "Rigid Modes"):
                remove(root, "Time", name)
            if self.values.get("Thermal", {}).get("Conduction") == "Steady":
                remove(root, "Thermal", "Conduction")
        return ElementTree.tostring(root, encoding="unicode")
