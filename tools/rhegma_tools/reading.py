"""Reads the folder of a run, and says what of it can't be read."""

import os

from rhegma.problem import Problem


def read_bytes(path):
    """The content of a file. An OSError, with its path, where it can't be read."""
    try:
        with open(path, "rb") as file:
            return file.read()
    except OSError as error:
        raise OSError(error.errno, error.strerror, path) from None


def attempt(check, folder, *arguments, found, failed=None):
    """What a check gives; where a file can't be read, that is a fault, and it gives `failed`. arguments: those before `found`"""
    try:
        return check(*arguments, found)
    except OSError as error:
        found.faults.append(f"{error.filename or folder} can't be read ({error.strerror}).")
        return failed


def refuse_unreadable(folder):
    """A Problem where a path is no folder whose files can be found."""
    if not os.path.exists(folder):
        raise Problem(f"there is no folder {folder}; give the folder that a run wrote.")
    if not os.path.isdir(folder):
        raise Problem(f"{folder} is no folder; give the folder that a run wrote.")
    try:
        os.listdir(folder)
        os.stat(os.path.join(folder, os.curdir))  # needs the right to enter it, as its files do
    except OSError as error:
        raise Problem(f"the folder {folder} can't be read ({error.strerror}).")
