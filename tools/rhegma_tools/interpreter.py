"""Finds a Python that has the packages a tool needs, and turns a user's mistake into a message."""

import argparse
import contextlib
import importlib
import io
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


def open_standard_streams():
    """Opens what is closed of the standard input, output and error, so that no file of the tool gets its number and then its text."""
    for number, name, mode in ((0, "stdin", "r"), (1, "stdout", "w"), (2, "stderr", "w")):
        if getattr(sys, name) is None:
            opened = os.open(os.devnull, os.O_RDWR)
            if opened != number:
                os.dup2(opened, number)
                os.close(opened)
            os.set_inheritable(number, True)
            setattr(sys, name, open(number, mode, encoding="utf-8", closefd=False))


class Output(io.TextIOWrapper):
    """The standard output, with the error that it had when it could not be written: failed, an OSError or None."""

    failed = None

    def write(self, text):
        """As of any text file."""
        with self.noted():
            return super().write(text)

    def flush(self):
        """As of any text file."""
        with self.noted():
            super().flush()

    @contextlib.contextmanager
    def noted(self):
        """Keeps an OSError that ends the block."""
        try:
            yield
        except OSError as error:
            self.failed = error
            raise


def note_failures():
    """Makes the standard output an Output, for a terminal without the letters of units and names, too."""
    how = {"encoding": sys.stdout.encoding, "line_buffering": sys.stdout.line_buffering, "write_through": sys.stdout.write_through}
    sys.stdout = Output(sys.stdout.detach(), errors="replace", **how)
    sys.stderr.reconfigure(errors="replace")


def give_up_output():
    """Sends what can't be written to nowhere, so that Python does not try it again when it ends."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def say(text):
    """A line on standard error, if it can be written."""
    with contextlib.suppress(OSError):
        print(text, file=sys.stderr, flush=True)


def finish(main):
    """The exit status of main, after all of its text is written; an OSError where that can't be."""
    try:
        status = main(sys.argv[1:])
    except SystemExit as end:  # such as of --help
        status = end.code
    sys.stdout.flush()
    return status


def run(main):
    """Exits with what main returns; a Problem, and a file that can't be read or written, become a message and status 1."""
    tool = os.path.basename(sys.argv[0])
    note_failures()
    try:
        sys.exit(finish(main))
    except Problem as problem:
        say(f"{tool}: {problem}")
    except BrokenPipeError:  # the reader of our output, such as head, has gone
        pass
    except OSError as error:
        if error.filename is None and sys.stdout.failed is None:
            raise  # a defect of the tool
        what = f"{error.filename} can't be used" if sys.stdout.failed is None else "the standard output can't be written"
        say(f"{tool}: {what} ({error.strerror}).")
    except KeyboardInterrupt:
        say(f"{tool}: interrupted.")
        sys.exit(130)
    with contextlib.suppress(OSError):
        sys.stdout.flush()
    if sys.stdout.failed is not None:
        give_up_output()
    sys.exit(1)


open_standard_streams()
