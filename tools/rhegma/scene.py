"""Scenes: built from dicts, read from XML, changed, and written as XML."""

from __future__ import annotations

import copy
import difflib
import os
import xml.etree.ElementTree as ElementTree
from typing import Any, Callable, Mapping

from .problem import Problem
from .values import Quantity, from_text, typed

TOP = "Rhegma"


def read_xml(path: str, kind: str) -> ElementTree.Element:
    """The top element of a file. kind: "scene" or "study", for the message of the Problem where there is none"""
    if not os.path.isfile(path):
        raise Problem(f"there is no file {path}; give the XML file of a {kind}.")
    try:
        return ElementTree.parse(path).getroot()
    except ElementTree.ParseError as error:
        raise Problem(f"{path} is no XML, or it is cut off ({error}).")
    except OSError as error:
        raise Problem(f"{path} can't be read ({error.strerror}).")


def move_files(root: ElementTree.Element, moved: Callable[[str], str]) -> None:
    """Replaces the paths of files of bodies, tools and cracks, which are relative to the scene, by moved(path)."""
    for section, name in (("Bodies", "File"), ("Rigid Tools", "File"), ("Cracks", "Surface File")):
        for entry in [entry for own in root if own.get("name") == section for entry in own.iter("Parameter")]:
            if entry.get("name") == name:
                entry.set("value", moved((entry.get("value") or "").strip()))


class Scene:
    """A scene. content: nested dicts of sections and values, in the order in which the program shall see them; folder: to which paths of
    files in the scene are relative (default: the current one).

    A path of a section or a parameter is a text such as "Bodies > Plate > Material". Values are bool, int, float, str, sequences of
    numbers or of texts, NumPy arrays (row by row) and Quantity. Values without a unit are in SI units."""

    def __init__(self, content: Mapping[str, Any] | None = None, folder: str | os.PathLike[str] = "."):
        self.root = ElementTree.Element("ParameterList", name=TOP)
        self.folder = os.path.abspath(os.fspath(folder))
        self.path: str | None = None
        self._fill(self.root, content or {})

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Scene:
        """The scene of an XML file. Its comments are not kept. A Problem where it can't be read."""
        scene = cls()
        scene.path = os.fspath(path)
        scene.folder = os.path.dirname(os.path.abspath(scene.path))
        scene.root = read_xml(scene.path, "scene")
        if scene.root.tag != "ParameterList":
            raise Problem(f"{scene.path} is no scene: its top must be <ParameterList name=\"{TOP}\">.")
        return scene

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the scene as XML. Paths of files in it are changed so that they are found from the folder of the new file. A Problem
        where it can't be written."""
        path = os.path.abspath(os.fspath(path))
        other = self.copy()
        if os.path.dirname(path) != self.folder:
            move_files(other.root, lambda file: file if os.path.isabs(file) else os.path.join(self.folder, file))
        ElementTree.indent(other.root)
        try:
            with open(path, "w", encoding="utf-8") as file:
                file.write(other.text() + "\n")
        except OSError as error:
            raise Problem(f"{path} can't be written ({error.strerror}).")
        except UnicodeEncodeError as error:
            raise Problem(f"{path} can't be written: the scene has the letter {error.object[error.start]!r}, which no text of a file has.")

    def text(self) -> str:
        """The scene as XML."""
        return ElementTree.tostring(self.root, encoding="unicode")

    def copy(self) -> Scene:
        """A copy that can be changed without changing this scene."""
        return copy.deepcopy(self)

    def varied(self, values: Mapping[str, Any]) -> Scene:
        """A copy with other values. values: {path: value}, such as {"Domain > Cell Size": 1e-3}"""
        other = self.copy()
        for path, value in values.items():
            other.set(path, value)
        return other

    def as_dict(self) -> dict[str, Any]:
        """The scene as nested dicts of Python values."""
        return _as_dict(self.root, "")

    def __getitem__(self, path: str) -> Any:
        """The value of a parameter, or a section as nested dicts. A Problem where there is none."""
        return _value(self.find(path), path)

    def __setitem__(self, path: str, value: Any) -> None:
        """See set."""
        self.set(path, value)

    def __delitem__(self, path: str) -> None:
        """See remove."""
        self.remove(path)

    def __contains__(self, path: object) -> bool:
        """Whether there is such a parameter or section."""
        element: ElementTree.Element | None = self.root
        for name in str(path).split(" > "):
            element = None if element is None else _child(element, name)
        return element is not None

    def find(self, path: str) -> ElementTree.Element:
        """The XML element of a parameter or section. A Problem names similar ones where there is none."""
        element, known = self.root, ""
        for name in _names(path):
            child = _child(element, name)
            if child is None:
                names = [str(one.get("name")) for one in element]
                near = difflib.get_close_matches(name, names, 1)
                raise Problem(f"the scene has no {path}: {known or 'it'} has no {name}" + (
                    f"; did you mean {near[0]}?" if near else f", but {', '.join(names) or 'nothing'}."))
            element, known = child, f"{known} > {name}" if known else name
        return element

    def set(self, path: str, value: Any) -> Scene:
        """Changes a parameter, or adds a parameter or, from a dict, a section; sections around it are added where there are none.
        Returns this scene."""
        names = _names(path)
        parent = self.root
        for name in names[:-1]:
            child = _child(parent, name)
            parent = ElementTree.SubElement(parent, "ParameterList", name=name) if child is None else child
        there = [child for child in parent if child.get("name") == names[-1]]
        at = list(parent).index(there[0]) if there else len(parent)
        for child in there:
            parent.remove(child)
        self._fill(parent, {names[-1]: value})
        added = parent[-1]
        parent.remove(added)
        parent.insert(at, added)
        return self

    def raw(self, path: str, kind: str, text: str) -> Scene:
        """Sets a parameter of any type and text, also such that the program rejects. Returns this scene."""
        self.set(path, "")
        self.find(path).set("type", kind)
        self.find(path).set("value", text)
        return self

    def remove(self, path: str) -> Scene:
        """Removes a parameter or a section. Returns this scene. A Problem where there is none."""
        self._parent(path).remove(self.find(path))
        return self

    def rename(self, path: str, name: str) -> Scene:
        """Gives a parameter or a section another name. Returns this scene. A Problem where there is none."""
        self.find(path).set("name", name)
        return self

    def again(self, path: str, name: str | None = None) -> Scene:
        """Adds a copy of an entry next to it, under the same name or another. Returns this scene. A Problem where there is none."""
        other = copy.deepcopy(self.find(path))
        if name:
            other.set("name", name)
        self._parent(path).append(other)
        return self

    def _parent(self, path: str) -> ElementTree.Element:
        above = _names(path)[:-1]
        return self.find(" > ".join(above)) if above else self.root

    def _fill(self, element: ElementTree.Element, content: Mapping[str, Any]) -> None:
        for name, value in content.items():
            if not isinstance(name, str):
                raise Problem(f'{name!r} is no name of a parameter or a section; names are texts, such as "Domain".')
            if isinstance(value, Mapping):
                self._fill(ElementTree.SubElement(element, "ParameterList", name=name), value)
                continue
            try:
                kind, text = typed(value.value if isinstance(value, Quantity) else value)
            except Problem as problem:
                raise Problem(f"{name}: {problem}") from None
            parameter = ElementTree.SubElement(element, "Parameter", name=name, type=kind, value=text)
            if isinstance(value, Quantity):
                parameter.set("unit", value.unit)


def _names(path: str) -> list[str]:
    """Names of the sections, and of the parameter, of a path. A Problem where it is no text."""
    if not isinstance(path, str):
        raise Problem(f'{path!r} is no path of a parameter; write one such as "Domain > Cell Size".')
    return path.split(" > ")


def _child(element: ElementTree.Element, name: str) -> ElementTree.Element | None:
    return next((child for child in element if child.get("name") == name), None)


def _value(element: ElementTree.Element, path: str) -> Any:
    if element.tag == "ParameterList":
        return _as_dict(element, path)
    value = from_text(element.get("type") or "string", element.get("value") or "", path)
    unit = element.get("unit")
    return Quantity(value, unit) if unit else value


def _as_dict(element: ElementTree.Element, path: str) -> dict[str, Any]:
    names = [str(child.get("name")) for child in element]
    return {name: _value(child, f"{path} > {name}" if path else name) for name, child in zip(names, element)}
