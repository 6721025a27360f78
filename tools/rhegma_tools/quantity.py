"""Quantities by which particles are coloured: their names, units and values."""

import numpy as np

from rhegma.components import parts_of
from rhegma.units import FIELD_UNITS

from . import style

NAMES = {"principal": "largest principal stress", "mises": "von Mises stress", "temperature": "temperature",
         "principal_stress": "largest principal stress", "energy_density": "elastic energy density"}
UNITS = {"principal": "Pa", "mises": "Pa", **{name: unit.replace("m3", "m³") for name, unit in FIELD_UNITS.items()}}


def quantity_shown(fields, quantity):
    """The quantity itself, or temperature where the run had no stress."""
    return "temperature" if fields.stress is None and quantity in ("principal", "mises") else quantity


def label_of(quantity):
    """A quantity in words."""
    name, component = parts_of(quantity)
    return NAMES.get(name, name.replace("_", " ")) + (f" {component}" if component else "")


def unit_of(quantity, values):
    """Factor and unit of the values: kelvins as they are, others with a prefix."""
    unit = UNITS.get(parts_of(quantity)[0], "")
    if quantity == "temperature" or not unit or unit == "kg":
        return 1.0, unit
    return style.scale(float(np.percentile(np.abs(values), 99.5)), unit)
