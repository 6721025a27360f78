"""Finds a Python that has the packages a tool needs, and turns a user's mistake into a message."""

import argparse
import importlib
import os
import sys

from rhegma.problem import Problem

SYSTEM_PYTHON = "/usr/bin/python3"
TRIED = "RHEGMA_TOOLS_TRIED_SYSTEM_PYTHON"


class Arguments(argparse.ArgumentParser):
    """A command line whose mistakes are Problems, so that they exit with 1 like all others."""

    def error(self, message):
        raise Problem(f"{message}; {self.prog} --help shows what it takes.")


def missing(packages):
    """Those of the packages that this interpreter can't import."""
    absent = []
    for package in packages:
        try:
            importlib.import_module(package)
        except ImportError:
            absent.append(package)
    return absent


def need(*packages):
    """Starts the running script again under the system's Python if this one lacks a package; exits if both do."""
    absent = missing(packages)
    if not absent:
        return
    here = os.path.realpath(sys.executable or "")
    if TRIED not in os.environ and os.path.exists(SYSTEM_PYTHON) and here != os.path.realpath(SYSTEM_PYTHON):
        os.environ[TRIED] = sys.executable or "python3"
        sys.stdout.flush()
        os.execv(SYSTEM_PYTHON, [SYSTEM_PYTHON] + sys.argv)
    tool = os.path.basename(sys.argv[0])
    tried = [os.environ[TRIED]] if TRIED in os.environ else []
    print(
        f"{tool}: needs the Python packages {', '.join(packages)}, and {' and '.join(tried + [sys.executable])} "
        f"lack{'' if tried else 's'} {', '.join(absent)}; install them, on Debian or Ubuntu with "
        f"apt-get install {' '.join('python3-' + name.lower() for name in packages)}.",
        file=sys.stderr,
    )
    sys.exit(1)


def run(main):
    """Exits with what main returns; a Problem becomes a message and status 1."""
    tool = os.path.basename(sys.argv[0])
    for stream in (sys.stdout, sys.stderr):
        stream.reconfigure(errors="replace")  # a terminal without the letters of units and names
    try:
        sys.exit(main(sys.argv[1:]))
    except Problem as problem:
        print(f"{tool}: {problem}", file=sys.stderr)
        sys.exit(1)
    except BrokenPipeError:  # the reader of our output, such as head, has gone
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        sys.exit(1)
    except KeyboardInterrupt:
        print(f"{tool}: interrupted.", file=sys.stderr)
        sys.exit(130)
