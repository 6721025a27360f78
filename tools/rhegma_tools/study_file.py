"""Reads a study: a scene, what is measured in its runs, and families of settings to run it with."""

import difflib
import itertools
import math
import os
import re

from rhegma.problem import Problem
from rhegma.scene import read_xml
from rhegma.values import split_array

from .lengths import METRES, unit_of

CELL = "Domain:Cell Size"

FORMAT = """\
A study is a Teuchos parameter list named Study:

  <ParameterList name="Study">
    <Parameter name="Scene" type="string" value="../verification/dcb_h8.xml"/>    relative to the study
    <Parameter name="Title" type="string" value="Double cantilever beam"/>        optional; title of the pictures
    <Parameter name="Error Of" type="string" value="cracks.0.fronts.0.G_J"/>      path in summary.json
    <Parameter name="Error Label" type="string" value="G"/>                       optional: label of the axis
    <Parameter name="Reference Value" type="double" value="0.12873"/>             the exact result
    <Parameter name="Source" type="string" value="finite elements"/>              optional; source of the value
    <Parameter name="Curve Of" type="string" value="Notch.0.G_J"/>                optional: a column of history.csv
    <Parameter name="Curve Divided By" type="double" value="0.1"/>                drawn over time in curves.png, divided by this
    <Parameter name="Curve Label" type="string" value="G / G of beam theory"/>    optional: label of the axis
    <Parameter name="Value Label" type="string" value="toughness [J/m2]"/>        optional: axes of values.png
    <Parameter name="At Label" type="string" value="speed [m/s]"/>
    <ParameterList name="Sweep">
      <ParameterList name="GIMP">                                                 a family: a line in study.png
        <Parameter name="Combine" type="string" value="Zip"/>                     or Product; default Zip
        <Parameter name="Group" type="string" value="GIMP"/>                      families of a group share a colour
        <Parameter name="Domain:Cell Size" type="Array(string)" value="{2.5e-3, 1.25e-3}"/>
        <Parameter name="Time:CFL" type="Array(string)" value="{0.4, 0.2}"/>
        <Parameter name="Time:Final Time" type="string" value="2" unit="ms"/>     with a unit, as in a scene
        <Parameter name="Domain:Shape Functions" type="string" value="GIMP"/>     the same in all of its runs
      </ParameterList>
    </ParameterList>
  </ParameterList>

Error Of can be an array of paths, with an array of the same length as Reference Value. The error is then the root of the
sum of squared deviations, over the root of the sum of squared references. It has no zero where one deviation changes its sign.

A parameter of a family is a parameter of the scene: its path, with colons between the parts. Zip runs the first values of
all arrays together, then the second ones, so all arrays have the same length; Product runs every combination. Values that
are arrays themselves are written in braces: {{0, 0}, {1, 0}}. A family can have its own Scene, Error Of, Reference Value and
Curve Of.

A family with a Value is drawn in values.png:

  Value          expression of "at", of [paths] in summary.json of the run, and of [[paths]] in summary.json of the run with
                 the same number in the family Compared With
  At             array of numbers, one for each run; "at" in expressions
  Drawn At       optional: expression for the horizontal axis instead of At; "drawn" in Value
  True           optional: expression of "at" for the exact value
"""

STUDY_NAMES = ["Scene", "Title", "Error Of", "Error Label", "Reference Value", "Source", "Curve Of", "Curve Divided By", "Curve Label",
               "Value Label", "At Label", "Sweep"]
FAMILY_NAMES = ["Combine", "Group", "Scene", "Error Of", "Reference Value", "Curve Of", "Value", "At", "Drawn At", "Compared With",
                "True"]


class Curve:
    """A column of history.csv that is drawn over time, in multiples of `unit`."""

    def __init__(self, unit, label):
        self.unit = unit
        self.label = label


class Run:
    """One run: a family, its scene and its settings {path: value}, and what is measured in it: quantities, paths in
    summary.json, and as many references."""

    def __init__(self, family, scene, settings, quantities, references, group=None, column=None):
        self.family = family
        self.group = group or family
        self.column = column
        self.scene = scene
        self.settings = settings
        self.quantities = quantities
        self.references = references
        self.value = self.at = self.drawn = self.twins = self.true = None  # of values.png

    @property
    def quantity(self):
        return ", ".join(self.quantities)

    @property
    def reference(self):
        """The reference, or the root of the sum of the squares of several."""
        return self.references[0] if len(self.references) == 1 else math.hypot(*self.references)


class Study:
    """runs: all, in the order of the families; swept: paths whose value changes in a family, in order; curve: None
    where none is drawn; source: of the reference values, or None; error_label: of the axis, or None."""

    def __init__(self, path, title, runs, swept, curve=None, source=None):
        self.value_label = self.at_label = self.error_label = None
        self.curve = curve
        self.source = source
        self.path = path
        self.title = title
        self.runs = runs
        self.swept = swept


def name_of(element, where):
    name = element.get("name")
    if not name:
        raise Problem(f"{where}: a {element.tag} has no name.")
    return name


def read_value(element, where):
    """A list of strings for an array, a string for all else."""
    value = element.get("value")
    if value is None:
        raise Problem(f"{where}: has no value.")
    # A unit is left to the program, which converts it: each value gets it as a text, such as "2 mm".
    unit = element.get("unit", "").strip()
    unit = " " + unit if unit else ""
    if element.get("type", "").replace(" ", "").startswith("Array("):
        return [entry + unit for entry in split_array(value, where)]
    return value.strip() + unit


def read_text(values, name, where):
    if name not in values:
        raise Problem(f"{where} > {name}: is missing; write <Parameter name=\"{name}\" type=\"string\" value=\"...\"/>.")
    if not isinstance(values[name], str) or not values[name]:
        raise Problem(f"{where} > {name}: must be one string.")
    return values[name]


def read_number(values, name, where):
    """None where it is absent."""
    if name not in values:
        return None
    try:
        number = float(values[name])
    except (TypeError, ValueError):
        raise Problem(f"{where} > {name}: must be a number, not {values[name]}.")
    if number != number or abs(number) == float("inf"):
        raise Problem(f"{where} > {name}: must be a finite number.")
    return number


def read_measured(values, own, where):
    """(paths, references) of what the error of a family's runs is taken of."""
    paths = values.get("Error Of")
    if not isinstance(paths, list):
        paths = [read_text(values, "Error Of", where if "Error Of" in own else "Study")]
    where = where if "Reference Value" in own else "Study"
    if "Reference Value" not in values:
        raise Problem("Study > Reference Value: is missing; write the exact answer for Error Of as a double.")
    given = values["Reference Value"]
    given = given if isinstance(given, list) else [given]
    references = [read_number({"Reference Value": text}, "Reference Value", where) for text in given]
    if len(references) != len(paths):
        raise Problem(f"{where} > Reference Value: has {len(references)} numbers for the {len(paths)} paths of Error Of; "
                      "give one for each.")
    return paths, references


def combine(values, how, where):
    """[{path: value}] of a family's arrays."""
    arrays = {path: value for path, value in values.items() if isinstance(value, list)}
    fixed = {path: value for path, value in values.items() if isinstance(value, str)}
    if how == "Product":
        rows = itertools.product(*arrays.values())
    elif how == "Zip":
        lengths = {path: len(value) for path, value in arrays.items()}
        if len(set(lengths.values())) > 1:
            lengths_text = ", ".join(f"{path} has {n}" for path, n in lengths.items())
            raise Problem(f"{where}: Zip needs arrays of one length, but {lengths_text} values; make them equal or "
                          "set Combine to Product.")
        rows = zip(*arrays.values()) if arrays else [()]
    else:
        raise Problem(f"{where} > Combine: must be Zip or Product, not {how}.")
    # In the order of the file, so that a table's columns follow it.
    found = [dict(fixed, **dict(zip(arrays, row))) for row in rows]
    return [{path: row[path] for path in values} for row in found]


def as_list(value):
    return value if isinstance(value, list) else [value]


def read_scene(text, study_path, where):
    scene = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(study_path)), text))
    if not os.path.isfile(scene):
        raise Problem(f"{where} > Scene: there is no file {scene}; the path is relative to the study.")
    return scene


def read_family(element, study, study_path):
    """(runs, swept paths) of one family; study: {name: value} of what holds for all families."""
    where = f"Sweep > {name_of(element, 'Sweep')}"
    values = {}
    for child in element:
        name = name_of(child, where)
        if child.tag != "Parameter":
            raise Problem(f"{where} > {name}: is a list; write its parameters as {name}:Parameter.")
        if name in values:
            raise Problem(f"{where} > {name}: appears twice.")
        values[name] = read_value(child, f"{where} > {name}")
    own = {name: values.pop(name) for name in FAMILY_NAMES if name in values}
    for path in values:
        near = difflib.get_close_matches(path, FAMILY_NAMES, 1)
        if near and ":" not in path:
            raise Problem(f"{where} > {path}: is unknown; write {near[0]}.")
        if not re.fullmatch(r"[^:=]+(:[^:=]+)+", path):
            raise Problem(f"{where} > {path}: is no path of a scene's parameter; write Section:Parameter, "
                          "such as Domain:Cell Size.")
    for size in as_list(values.get(CELL, [])):
        if unit_of(size) not in METRES:
            raise Problem(f"{where} > {CELL}: {size} is in a unit that a study does not sort by; write m, cm, mm or um.")
    merged = dict(study, **own)
    scene = read_scene(read_text(merged, "Scene", where if "Scene" in own else "Study"), study_path, where)
    quantities, references = read_measured(merged, own, where)
    column = read_text(merged, "Curve Of", where if "Curve Of" in own else "Study") if "Curve Of" in merged else None
    group = read_text(own, "Group", where) if "Group" in own else None
    rows = combine(values, own.get("Combine", "Zip"), where)
    runs = [Run(element.get("name"), scene, row, quantities, references, group, column) for row in rows]
    read_values(own, runs, where)
    return runs, [path for path, value in values.items() if isinstance(value, list)]


def read_values(own, runs, where):
    """What values.png has of a family."""
    if "Value" not in own:
        for name in ("At", "Drawn At", "Compared With", "True"):
            if name in own:
                raise Problem(f"{where} > {name}: there is no Value; add one.")
        return
    at = own.get("At")
    if not isinstance(at, list) or len(at) != len(runs):
        raise Problem(f"{where} > At: must be an array of a number for each of the {len(runs)} runs.")
    for run, text in zip(runs, at):
        run.value = read_text(own, "Value", where)
        run.at = read_number({"At": text}, "At", where)
        run.drawn = read_text(own, "Drawn At", where) if "Drawn At" in own else None
        run.twins = read_text(own, "Compared With", where) if "Compared With" in own else None
        run.true = read_text(own, "True", where) if "True" in own else None


def read_curve(values, runs):
    """How curves are drawn; None where no family has any."""
    unit = read_number(values, "Curve Divided By", "Study")
    if unit == 0.0:
        raise Problem("Study > Curve Divided By: must not be 0.")
    if not any(run.column for run in runs):
        for name in ("Curve Divided By", "Curve Label"):
            if name in values:
                raise Problem(f"Study > {name}: there is no curve; add Curve Of, a column of history.csv.")
        return None
    label = read_text(values, "Curve Label", "Study") if "Curve Label" in values else None
    return Curve(1.0 if unit is None else unit, label)


def read_study(path):
    """A study from its file; raises a Problem with a message for any mistake in it."""
    root = read_xml(path, "study")
    if root.tag != "ParameterList" or root.get("name") != "Study":
        raise Problem(f"{path} is no study: its top must be <ParameterList name=\"Study\">; --help shows the format.")
    values, sweep = {}, None
    for child in root:
        name = name_of(child, "Study")
        if name not in STUDY_NAMES:
            near = difflib.get_close_matches(name, STUDY_NAMES, 1)
            raise Problem(f"Study > {name}: is unknown; " + (f"write {near[0]}." if near else
                          f"a study has {', '.join(STUDY_NAMES)}."))
        if name == "Sweep":
            sweep = child
        else:
            values[name] = read_value(child, f"Study > {name}")
    if sweep is None or len(sweep) == 0:
        raise Problem("Study > Sweep: is missing or empty; it holds a list of settings for every family of runs.")
    runs, swept, seen = [], [], set()
    for element in sweep:
        name = name_of(element, "Sweep")
        if element.tag != "ParameterList":
            raise Problem(f"Sweep > {name}: is no list; put the settings into <ParameterList name=\"a family\">.")
        if name in seen:
            raise Problem(f"Sweep > {name}: two families have this name.")
        seen.add(name)
        more, paths = read_family(element, values, path)
        runs += more
        swept += [p for p in paths if p not in swept]
    texts = {name: read_text(values, name, "Study") for name in ("Title", "Source") if name in values}
    labels = [read_text(values, name, "Study") if name in values else None for name in
              ("Value Label", "At Label", "Error Label")]
    title = texts.get("Title") or os.path.splitext(os.path.basename(path))[0]
    study = Study(path, title, runs, swept, read_curve(values, runs), texts.get("Source"))
    study.value_label, study.at_label, study.error_label = labels
    return study


def choose_families(study, names):
    """The study with the runs of these families only."""
    families = list(dict.fromkeys(run.family for run in study.runs))
    for name in names:
        if name not in families:
            near = difflib.get_close_matches(name, families, 1)
            raise Problem(f"--family {name}: the study has no such family; it has {', '.join(families)}"
                          + (f" (did you mean {near[0]}?)." if near else "."))
    study.runs = [run for run in study.runs if run.family in names]
