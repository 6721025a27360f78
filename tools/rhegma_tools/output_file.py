"""Where tools write: never onto what they read, onto a result of a run, or onto what is no file, and each file as a whole or not at all."""

import contextlib
import os

from rhegma.problem import Problem
from rhegma.scene import read_xml

# What the program and rhegma.run write into the folder of a run.
OF_A_RUN = {"summary.json", "history.csv", "fields.h5", "fields.xdmf", "fronts.h5", "fronts.csv", "checkpoint.h5", "manifest.json", "run.lock", "scene.xml",
            "study_run.json", "rhegma.log", "twice.json"}
MARKS = ("manifest.json", "run.lock", "summary.json", "twice.json")  # by which the folder of a run is known


def is_same(path, other):
    """Whether two paths lead to one file, also by links."""
    try:
        return os.path.samefile(path, other)
    except OSError:
        return os.path.realpath(path) == os.path.realpath(other)


def target_of(path, inputs=()):
    """The file that an output is written to: of a link what it points to. inputs: paths that the tool reads. A Problem where the output is one of
    them, a result of a run, or no regular file, such as a folder or a device."""
    target = os.path.realpath(path)
    folder, name = os.path.split(target)
    if os.path.isdir(path):
        raise Problem(f"{path} is a folder; give the name of a file to write.")
    # A path such as /dev/stdout leads to what has no name: then the path exists, and its target does not.
    if os.path.lexists(target) and not os.path.isfile(target) or os.path.exists(path) and not os.path.isfile(path):
        raise Problem(f"{path} is no regular file, so it is not replaced; give the name of a file to write.")
    if any(is_same(target, one) for one in inputs):
        raise Problem(f"{path} is a file that is read, and would be overwritten; give another name of the file to write.")
    if name in OF_A_RUN and any(os.path.exists(os.path.join(folder, mark)) for mark in MARKS):
        raise Problem(f"{path} is a file of a run, and would be overwritten; give another name of the file to write.")
    return target


def files_of(scene):
    """Paths of a scene and of the files that it names, such as those of bodies. A Problem where it can't be read."""
    texts = [entry.get("value") or "" for entry in read_xml(scene, "scene").iter("Parameter") if (entry.get("name") or "").endswith("File")]
    return [scene, *(os.path.join(os.path.dirname(os.path.abspath(scene)), text.strip()) for text in texts if text.strip())]


@contextlib.contextmanager
def replacing(path, inputs=()):
    """Gives the path of a new file next to the output, with the same ending, which replaces the output in the end. An older output stays, and nothing else
    is left, where an exception ends the block. Problems as of target_of, and where it can't be written."""
    target = target_of(path, inputs)
    temporary = f"{target}.{os.getpid()}.part{os.path.splitext(target)[1]}"
    try:
        yield temporary
        os.replace(temporary, target)
    except OSError as error:
        raise Problem(f"{path} can't be written ({error.strerror or error}).")
    finally:
        with contextlib.suppress(OSError):
            os.remove(temporary)


@contextlib.contextmanager
def text_to(path, inputs=()):
    """An open file whose text replaces the output in the end, without translation of its line ends."""
    with replacing(path, inputs) as temporary, open(temporary, "w", newline="", encoding="utf-8") as file:
        yield file
