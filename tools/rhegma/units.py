"""Units of the columns of history.csv and of the fields of particles; all are SI units."""

from __future__ import annotations

import re

# Columns of the whole run.
_OF_RUN = {
    "time": "s",
    **{name: "J" for name in ("kinetic", "strain", "tools", "interfaces", "thermal", "heat", "external_work", "damped", "contact", "fracture", "merged",
                              "stabilised", "combustion", "plastic", "filtered", "residual")},
    "momentum_x": "kg m/s", "momentum_y": "kg m/s", "momentum_z": "kg m/s",
    "temperature_highest": "K", "temperature_lowest": "K", "load_factor": "", "pieces": "", "largest_piece": "kg",
}
# Last parts of the names of other columns, such as G_J of Notch.0.G_J. NAME.largest and NAME.smallest depend on the scene.
_OF_PARTS = {
    "G_J": "J/m2", "G_closure": "J/m2", "G_closure_lumped": "J/m2", "K_I": "Pa sqrt(m)", "K_II": "Pa sqrt(m)", "K_III": "Pa sqrt(m)",
    "length": "m", "speed": "m/s", "x": "m", "y": "m", "z": "m", "stopped": "", "temperature": "K",
    "force_x": "N", "force_y": "N", "force_z": "N", "velocity_x": "m/s", "velocity_y": "m/s", "velocity_z": "m/s", "work": "J",
    "friction": "J", "displacement": "m", "displacement_x": "m", "displacement_y": "m", "displacement_z": "m",
    "opening": "m", "area": "m2", "pressure": "Pa", "pressure_lowest": "Pa", "pressure_highest": "Pa", "burnt_mass": "kg",
    "gas_temperature": "K", "face_temperature": "K",
    **{f"{which}_{axis}": "m" for which in ("largest", "smallest") for axis in "xyz"},
}

FIELD_UNITS = {
    "stress": "Pa", "von_mises": "Pa", "principal_stress": "Pa", "velocity": "m/s", "displacement": "m", "position": "m",
    "temperature": "K", "mass": "kg", "energy_density": "J/m3", "damage": "", "edge": "m", "edges": "m",
}


def unit_of_column(name: str) -> str | None:
    """Unit of a column of history.csv: "" for numbers without a unit, None where it isn't known."""
    if name in _OF_RUN:
        return _OF_RUN[name]
    _, point, last = name.rpartition(".")
    return _OF_PARTS.get(re.sub(r"_(min|max)$", "", last)) if point else None
