"""Components of the fields of particles by their names."""

from __future__ import annotations

import numpy as np

VECTOR, TENSOR = ("x", "y", "z"), ("xx", "yy", "zz", "xy", "yz", "xz")
MATRIX = tuple(one + other for one in VECTOR for other in VECTOR)


def parts_of(quantity: str) -> tuple[str, str]:
    """(field, component or "") of a quantity such as "velocity:x"."""
    name, _, component = quantity.partition(":")
    return name, component


def components_of(values: np.ndarray) -> tuple[str, ...]:
    """Names of the components of a field (n) or (n, components)."""
    count = 1 if values.ndim == 1 else values.shape[1]
    return {1: (), 3: VECTOR, 6: TENSOR, 9: MATRIX}.get(count, tuple(str(i) for i in range(count)))


def component_values(values: np.ndarray, component: str) -> np.ndarray | None:
    """A component of a field; without one, the values of a scalar or the magnitude of a vector. None where there is no such component."""
    names = components_of(values)
    if not names:
        return None if component else values.reshape(len(values))
    if component:
        return values[:, names.index(component)] if component in names else None
    return np.linalg.norm(values, axis=1) if names == VECTOR else None
