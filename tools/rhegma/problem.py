"""Exceptions of the package. Each has a message for the user; all are Problems."""

from __future__ import annotations

from typing import TYPE_CHECKING, Sequence

if TYPE_CHECKING:
    from .result import Run


class Problem(Exception):
    """A mistake of the user, or a file that can't be read, as a message."""


class SceneError(Problem):
    """The program rejects a scene (exit status 1); nothing was run. messages: one for each mistake, such as
    "Domain > Cell Size: ..."."""

    def __init__(self, messages: Sequence[str]):
        super().__init__("\n".join(messages))
        self.messages = list(messages)


class RunStopped(Problem):
    """A run could not continue (exit status 2): its message has the reason and the time. run: what it wrote until then."""

    def __init__(self, message: str, run: Run):
        super().__init__(message)
        self.run = run


class ProgramError(Problem):
    """The program failed in another way: a defect of the program (exit status 3), a signal, or a launcher that can't start it.
    status: exit status, or minus the number of the signal"""

    def __init__(self, message: str, status: int):
        super().__init__(message)
        self.status = status
