"""The values of a scene file."""

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


def write_value(root, path, value):
    """Sets a parameter. path: names from the outermost list inwards"""
    for name in path[:-1]:
        root = find_or_add(root, name)
    found = next((entry for entry in root if entry.tag == "Parameter" and entry.get("name") == path[-1]), None)
    if found is None:
        found = ElementTree.SubElement(root, "Parameter", name=path[-1], type="string")  # the program knows which
    found.set("value", value)
    found.attrib.pop("unit", None)  # that of the value before


class Scene:
    """A scene file with the values of --set. path: of the file; settings: texts such as "Domain:Cell Size=1e-3"."""

    def __init__(self, path, settings=()):
        self.path, self.settings = path, list(settings)
        self.root = read_scene(path)
        for setting in settings:
            name, equals, value = setting.partition("=")
            names = [part.strip() for part in name.split(":")]
            if not equals or len(names) < 2:
                raise Problem(f'--set is "{setting}"; write it as Section:Parameter=value.')
            write_value(self.root, names, value.strip())
        folder = os.path.dirname(os.path.abspath(path))
        move_files(self.root, lambda file: os.path.join(folder, file))
        self.values = as_values(self.root)

    @property
    def dimension(self):
        return 3 if self.values.get("Domain", {}).get("Dimension") == "3" else 2
