"""Runs scenes."""

from __future__ import annotations

import operator
import os
import tempfile
from typing import IO, Any, Callable, Mapping, Sequence, Union

from .problem import Problem, ProgramError, RunStopped, SceneError
from .program import FINISHED, STOPPED, WRONG_SCENE, capture, check_file, errors_of, find_program, start, text_of, warnings_of
from .result import Run
from .scene import Scene

Input = Union[Scene, Mapping[str, Any], str, "os.PathLike[str]"]
REMEDY = "give its path as program, or in the environment variable RHEGMA_PROGRAM"
SCENE_FILE = "scene.xml"  # in the folder of a run
# Options of the program with which it does not run the scene, or not into the folder of the run.
OTHER_THINGS = {"--output": "give the folder as output", "--check": "rhegma.check checks a scene", "--describe": "rhegma.describe does this",
                **dict.fromkeys(("--twice", "--print-plan", "--describe-markdown", "--new", "--materials", "--materials-markdown", "--version", "--help",
                                 "-h", "--picture", "--state"), "start the program itself for it")}


def as_scene(scene: Input) -> Scene:
    """A scene from a Scene, nested dicts, or the path of an XML file. A Problem where the file can't be read."""
    if isinstance(scene, Scene):
        return scene
    if not isinstance(scene, (Mapping, str, os.PathLike)):
        raise Problem(f"{scene!r} is no scene; give the path of an XML file, a Scene or nested dicts.")
    return Scene(scene) if isinstance(scene, Mapping) else Scene.load(scene)


def make_folder(path: str) -> None:
    """A folder and those above it. A Problem where it can't be made."""
    try:
        os.makedirs(path, exist_ok=True)
    except OSError as error:
        raise Problem(f"the folder {path} can't be made ({error.strerror}).")


def file_for(scene: Scene, folder: str) -> str:
    """Writes a scene into the folder of its run, under the name of its file or as scene.xml. Returns the path. A Problem where it can't be
    written or would replace the file that it was read from."""
    file = os.path.join(folder, os.path.basename(scene.path or SCENE_FILE))
    if scene.path is not None and os.path.realpath(file) == os.path.realpath(scene.path):
        raise Problem(f"the run would overwrite its own scene {file}; choose another output.")
    scene.save(file)
    return file


def folder_of(output: str | os.PathLike[str]) -> str:
    """The path of the folder of a run or of a sweep. A Problem where it is none."""
    if not isinstance(output, (str, os.PathLike)) or not os.fspath(output):
        raise Problem(f"output is {output!r}; give the path of a folder.")
    return os.path.abspath(os.fspath(output))


def check_count(name: str, count: Any) -> None:
    """A Problem where a count is no whole number of 1 or more."""
    try:
        positive = operator.index(count) >= 1
    except TypeError:
        positive = False
    if not positive:
        raise Problem(f"{name} is {count!r}; it must be a whole number of 1 or more.")


def check_how(ranks: int, threads: int | None, options: Sequence[str], launcher: Sequence[str] | None) -> None:
    """A Problem where a run can't be started so, or would be none."""
    check_count("ranks", ranks)
    if threads is not None:
        check_count("threads", threads)
    for name, words, example in (("options", options, '["--strict"]'), ("launcher", launcher or (), '["srun", "-n", "4"]')):
        if isinstance(words, str) or not isinstance(words, Sequence) or not all(isinstance(word, (str, os.PathLike)) for word in words):
            raise Problem(f"{name} is {words!r}; it must be a list of words, such as {example}.")
    for option in options:
        remedy = OTHER_THINGS.get(str(option).partition("=")[0])
        if remedy:
            raise Problem(f"options has {option}, with which there is no run in the folder that output names; {remedy}.")


def output_of(scene: Scene, output: str | os.PathLike[str] | None) -> str:
    """The folder of a run: as given, else the name of the scene's file with .out, next to it."""
    if output is not None:
        return folder_of(output)
    if scene.path is None:
        raise Problem("give the folder of the run as output; a scene that is from no file has no default.")
    return os.path.abspath(os.path.splitext(scene.path)[0] + ".out")


def command_for(path: str, folder: str, program: str, ranks: int, launcher: Sequence[str] | None, options: Sequence[str]) -> list[str]:
    """The command that runs the scene of a file."""
    before = list(launcher) if launcher is not None else ["mpirun", "-np", str(ranks)] if ranks > 1 else []
    return [*before, program, path, "--output", folder, *options]


def printer(log: IO[bytes]) -> Callable[[], None]:
    """A function that prints what has been added to a file."""
    printed = 0

    def more() -> None:
        nonlocal printed
        while text := os.pread(log.fileno(), 1 << 20, printed):
            printed += len(text)
            print(text.decode(errors="replace"), end="", flush=True)

    return more


def outcome(run: Run, messages: str, stop_raises: bool) -> Run:
    """The run, or the exception that its exit status stands for."""
    if run.status in FINISHED:
        return run
    errors = errors_of(messages)
    if run.status == WRONG_SCENE:
        raise SceneError(errors or ["rhegma rejects the scene without a message."])
    if run.status == STOPPED:
        if stop_raises:
            raise RunStopped("\n".join(errors) or "the run stopped.", run)
        return run
    status = -1 if run.status is None else run.status
    how = f"ended by signal {-status}" if status < 0 else f"ended with exit status {status}"
    raise ProgramError(f"rhegma {how}" + (": " + "\n".join(errors) if errors else "."), status)


def run(scene: Input, *, output: str | os.PathLike[str] | None = None, ranks: int = 1, threads: int | None = None,
        options: Sequence[str] = (), program: str | os.PathLike[str] | None = None, launcher: Sequence[str] | None = None,
        show: bool = False, stop_raises: bool = True, settings: Mapping[str, Any] | None = None) -> Run:
    """Runs a scene to its end.

    scene: the path of an XML file, which the program reads as it is; or a Scene or nested dicts, which are written into the folder of the
    run under the name of the scene's file, else as scene.xml.
    output: folder of the run; default: the name of the scene's file with .out, next to it.
    ranks: number of MPI ranks; more than one are started by mpirun. threads: OMP_NUM_THREADS of each rank; default: as it is set.
    options: more options of the program, such as ["--strict"]. program: its path; default: the environment variable RHEGMA_PROGRAM,
    the PATH, or the build next to this package. launcher: words of another command than mpirun, such as ["srun", "-n", "4"].
    show: print what the program prints, while it runs. stop_raises: whether a run that stops raises; else it is returned.
    settings: {path: value}, set in a copy of the scene.

    Returns the run, also where a value of the section Reference was missed (`status` 4, `references_met`). Raises SceneError where the
    scene is wrong (exit status 1), RunStopped where the run could not continue (2), ProgramError for a defect of the program (3) or
    a signal, and Problem where there is no program, the folder can't be written or an argument makes no sense, such as the option --check."""
    check_how(ranks, threads, options, launcher)
    found = as_scene(scene).varied(settings or {})
    folder, path = output_of(found, output), find_program(program, REMEDY)
    make_folder(folder)
    file = os.fspath(scene) if isinstance(scene, (str, os.PathLike)) and not settings else file_for(found, folder)
    command = command_for(file, folder, path, ranks, launcher, options)
    environment = {} if threads is None else {"OMP_NUM_THREADS": str(threads)}
    with tempfile.TemporaryFile() as log, tempfile.TemporaryFile() as errors:
        more = printer(log) if show else None
        try:
            status, _ = start(command, log, more, errors, environment)
        except OSError as error:
            raise Problem(f"{command[0]} can't be started ({error.strerror}).")
        if more:
            more()
        messages = text_of(errors)
        done = Run(folder, status, text_of(log), warnings_of(messages), settings)
    return outcome(done, messages, stop_raises)


def check(scene: Input, *, program: str | os.PathLike[str] | None = None) -> list[str]:
    """Checks a scene without running it, and returns its warnings. A SceneError has the program's messages where the scene is wrong.
    Arguments are those of run."""
    with tempfile.TemporaryDirectory(prefix="rhegma-check-") as folder:
        file = file_for(as_scene(scene), folder)
        _, messages = check_file(file, find_program(program, REMEDY))
    return warnings_of(messages)


def describe(section: str = "", *, program: str | os.PathLike[str] | None = None) -> str:
    """What rhegma --describe prints of a section or a parameter, such as "Boundaries > Top > History"; of all where none is given.
    A Problem where there is no such one."""
    path = find_program(program, REMEDY)
    status, text, messages = capture([path, "--describe", *([section] if section else [])])
    if status != 0:
        raise Problem("\n".join(errors_of(messages)) or f"{path} --describe ended with exit status {status}.")
    return text
