"""Quantities by which particles are coloured: their names, units and values."""

import numpy as np

from . import style

NAMES = {"principal": "largest principal stress", "mises": "von Mises stress", "temperature": "temperature",
         "principal_stress": "largest principal stress", "energy_density": "elastic energy density"}
UNITS = {"principal": "Pa", "mises": "Pa", "von_mises": "Pa", "stress": "Pa", "velocity": "m/s", "displacement": "m", "position": "m",
         "temperature": "K", "mass": "kg", "principal_stress": "Pa", "energy_density": "J/m³", "edge": "m", "edges": "m"}
VECTOR, TENSOR = ("x", "y", "z"), ("xx", "yy", "zz", "xy", "yz", "xz")
MATRIX = tuple(one + other for one in VECTOR for other in VECTOR)


def parts_of(quantity):
    """(field, component or "") of a quantity such as "velocity:x"."""
    name, _, component = quantity.partition(":")
    return name, component


def components_of(values):
    """Names of the components of a field (n) or (n, components)."""
    count = 1 if values.ndim == 1 else values.shape[1]
    return {1: (), 3: VECTOR, 6: TENSOR, 9: MATRIX}.get(count, tuple(str(i) for i in range(count)))


def component_values(values, component):
    """A component of a field; without one, the values of a scalar or the magnitude of a vector. None where there is no such component."""
    names = components_of(values)
    if not names:
        return None if component else values.reshape(len(values))
    if component:
        return values[:, names.index(component)] if component in names else None
    return np.linalg.norm(values, axis=1) if names == VECTOR else None


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
