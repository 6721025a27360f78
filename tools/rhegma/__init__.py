"""Reads, varies and runs scenes of rhegma, and reads their results as NumPy arrays.

    import rhegma

    run = rhegma.Run("dcb.out")                                    # what a run has written
    run.history["Notch.0.G_J"], run.value("cracks.Notch.fronts.0.G_J"), run.fields().stress

    scene = rhegma.Scene.load("dcb.xml")                           # or rhegma.Scene({...})
    scene["Domain > Cell Size"] = 1.25e-3
    run = rhegma.run(scene, output="fine.out", ranks=2)
    runs = rhegma.sweep(scene, {"Domain > Cell Size": [2.5e-3, 1.25e-3]}, output="cells.out")

Exceptions are Problem and those derived from it: SceneError, RunStopped, ProgramError.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .execution import check as check
    from .execution import describe as describe
    from .execution import run as run
    from .fields import Crack as Crack
    from .fields import Fields as Fields
    from .fields import Leaves as Leaves
    from .fronts import FrontSample as FrontSample
    from .history import History as History
    from .problem import Problem as Problem
    from .problem import ProgramError as ProgramError
    from .problem import RunStopped as RunStopped
    from .problem import SceneError as SceneError
    from .result import Run as Run
    from .scene import Scene as Scene
    from .sweeps import Sweep as Sweep
    from .sweeps import sweep as sweep
    from .values import Quantity as Quantity

__version__ = "0.2.0"

# Imported when they are first used: scenes can be written and run without NumPy and h5py.
_MODULES = {
    "check": "execution", "describe": "execution", "run": "execution", "Crack": "fields", "Fields": "fields", "Leaves": "fields",
    "FrontSample": "fronts", "History": "history", "Problem": "problem", "ProgramError": "problem", "RunStopped": "problem",
    "SceneError": "problem", "Run": "result", "Scene": "scene", "Sweep": "sweeps", "sweep": "sweeps", "Quantity": "values",
}
__all__ = sorted(_MODULES)


def __getattr__(name: str) -> Any:
    """A public name from its module."""
    if name not in _MODULES:
        raise AttributeError(f"module rhegma has no {name}; it has {', '.join(__all__)}.")
    return getattr(importlib.import_module(f".{_MODULES[name]}", __name__), name)


def __dir__() -> list[str]:
    """All public names."""
    return [*__all__, "__version__"]
