"""Finds the program, starts it, and reads its messages."""

from __future__ import annotations

import os
import shutil
import subprocess
import time
from typing import IO, Any, Callable, Mapping, Sequence

from .problem import Problem, SceneError

FINISHED = (0, 4)  # exit statuses of a finished run; 4: a reference of the scene itself was missed
WRONG_SCENE, STOPPED = 1, 2
HERE = os.path.dirname(os.path.realpath(__file__))
# In a checkout, and where CMake has installed the package.
NEIGHBOURS = (os.path.join("..", "..", "build", "rhegma"), os.path.join("..", "..", "..", "bin", "rhegma"))


def is_program(path: str) -> bool:
    """Whether a path is that of a file that can be run."""
    return os.path.isfile(path) and os.access(path, os.X_OK)


def find_program(given: str | os.PathLike[str] | None = None, remedy: str = "give its path with --rhegma") -> str:
    """The rhegma to run: the one given, else that of the environment variable RHEGMA_PROGRAM, on the PATH, or of the build next to
    this package. remedy: end of the message of the Problem where there is none"""
    if given is not None:
        if not is_program(os.fspath(given)):
            remedy = remedy.replace("its", "rhegma's")
            raise Problem(f"there is no program {os.fspath(given)}; {remedy}.")
        return os.path.abspath(given)
    known = [os.environ.get("RHEGMA_PROGRAM"), shutil.which("rhegma"), *(os.path.normpath(os.path.join(HERE, name)) for name in NEIGHBOURS)]
    for path in known:
        if path and is_program(path):
            return os.path.abspath(path)
    raise Problem(f"rhegma is neither on the PATH nor built next to its tools; {remedy}.")


def start(command: Sequence[str], log: Any, watch: Callable[[], None] | None = None, messages: Any = None,
          environment: Mapping[str, str] | None = None) -> tuple[int, float]:
    """Runs a command to its end and calls watch() now and then. log, messages: open files of its standard output and its standard
    error (default: log). Returns the exit status, negative for a signal, and the processor time [s]. An OSError where it can't be
    started."""
    process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=log, stderr=log if messages is None else messages,
                               env=None if environment is None else {**os.environ, **environment})
    try:
        while True:
            child, status, used = os.wait4(process.pid, os.WNOHANG if watch else 0)
            if child == process.pid:
                process.returncode = os.waitstatus_to_exitcode(status)
                return process.returncode, used.ru_utime + used.ru_stime
            if watch:
                watch()
            time.sleep(0.2)
    except BaseException:  # such as a KeyboardInterrupt, which the child got too
        try:
            process.wait(timeout=10)
        except subprocess.TimeoutExpired:
            process.kill()
        raise


def capture(command: Sequence[str]) -> tuple[int, str, str]:
    """(exit status, standard output, standard error) of a short command. A Problem where it can't be started."""
    try:
        result = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                errors="replace")
    except OSError as error:
        raise Problem(f"{command[0]} can't be started ({error.strerror}).")
    return result.returncode, result.stdout, result.stderr


def text_of(file: IO[bytes]) -> str:
    """All that was written to an open file."""
    file.seek(0)
    return file.read().decode(errors="replace")


def lines_of(messages: str) -> list[str]:
    """Messages of the program without its name."""
    return [line[len("rhegma: "):] if line.startswith("rhegma: ") else line for line in messages.splitlines() if line.strip()]


def warnings_of(messages: str) -> list[str]:
    """Warnings of the program, each without the word warning."""
    start_of_one = "warning: "
    return [line[len(start_of_one):] for line in lines_of(messages) if line.startswith(start_of_one)]


def errors_of(messages: str) -> list[str]:
    """Messages of the program that are no warnings. If there are any with its name, others, such as those of mpirun, are left out."""
    own = "\n".join(line for line in messages.splitlines() if line.startswith("rhegma: "))
    return [line for line in lines_of(own or messages) if not line.startswith("warning: ")]


def check_file(path: str, program: str, settings: Sequence[str] = ()) -> tuple[str, str]:
    """(standard output, standard error) of rhegma --check. settings: as for --set, such as "Time:CFL=0.2". A SceneError with the
    program's messages where the scene is wrong."""
    options = [part for setting in settings for part in ("--set", setting)]
    status, report, messages = capture([program, path, "--check", *options])
    if status != 0:
        raise SceneError(errors_of(messages) or [f"{program} --check ended with exit status {status}."])
    return report, messages
