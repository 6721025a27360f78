"""Shared libraries of material laws: compiles them and looks what is in them."""

import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile

from rhegma.problem import Problem

from .output_file import replacing

INCLUDES = os.path.join(os.path.dirname(os.path.realpath(__file__)), "includes")

# By the end of the file's name: the variable that chooses the compiler, the compiler, and its options. Local arrays of Fortran must not
# be static, for several threads call a law at the same time. Fixed lines may be as long as Abaqus allows them to be.
FORTRAN = ("FC", "gfortran", ["-frecursive", "-ffixed-line-length-none", "-ffree-line-length-none", "-std=legacy", "-I", INCLUDES])
COMPILERS = {
    ".c": ("CC", "cc", ["-lm"]),
    ".cpp": ("CXX", "c++", []),
    ".cc": ("CXX", "c++", []),
    ".cxx": ("CXX", "c++", []),
    ".f": FORTRAN,
    ".for": FORTRAN,
    ".f90": FORTRAN,
    ".f95": FORTRAN,
}
PACKAGES = {"cc": "gcc", "c++": "g++", "gfortran": "gfortran"}
COMMON = ["-O3", "-march=native", "-fno-math-errno", "-shared", "-fPIC"]


def build(source, library, flags=()):
    """Compiles a source into a shared library. The library is replaced only if it compiles. Throws Problem."""
    end = os.path.splitext(source)[1].lower()
    if end not in COMPILERS:
        raise Problem(f"{source}: must be a source in C, C++ or Fortran: a file that ends in {', '.join(sorted(COMPILERS))}.")
    if not os.path.isfile(source):
        raise Problem(f"{source}: there is no such file.")
    variable, usual, options = COMPILERS[end]
    compiler = os.environ.get(variable, usual).split()
    if not compiler or shutil.which(compiler[0]) is None:
        raise Problem(f"{source}: needs the compiler {compiler[0] if compiler else usual}, which is not there; install it, on Debian or Ubuntu with "
                      f"apt-get install {PACKAGES[usual]}, or set {variable}.")
    folder = os.path.dirname(os.path.abspath(library))
    if not os.path.isdir(folder):
        raise Problem(f"{library}: there is no folder {folder}.")
    with replacing(library, [source]) as made, tempfile.TemporaryDirectory() as own:
        modules = ["-J", own] if (variable, compiler[0]) == ("FC", "gfortran") else []
        command = [*compiler, *COMMON, source, "-o", made, *options, *modules, *flags]
        answer = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace", check=False)
        if answer.returncode != 0:
            raise Problem(f"{source}: does not compile:\n{answer.stdout.strip()}")
        if answer.stdout.strip():
            print(answer.stdout.strip())
        if not os.path.isfile(made):
            raise Problem(f"{source}: {' '.join(compiler)} ends without an error and without a library; set {variable} to a compiler.")


def symbols(library):
    """Names that a library defines."""
    answer = subprocess.run(["nm", "-D", "--defined-only", library], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)
    if answer.returncode != 0:
        raise Problem(f"{library}: its names can't be read: {answer.stderr.strip()}")
    return {line.split()[-1].split("@")[0] for line in answer.stdout.splitlines() if line.strip()}


# Of a process that loads a library: its arguments are the library, the file for the answer, and names of numbers.
LOAD = """import ctypes, json, os, sys
library, answer, *names = sys.argv[1:]
def number(opened, name):
    try:
        return ctypes.c_ushort.in_dll(opened, name).value
    except ValueError:
        return None
try:
    opened = ctypes.CDLL(library)
    found = {name: number(opened, name) for name in names}
except OSError as error:
    found = str(error)
with open(answer, "w") as file:
    json.dump(found, file)
os._exit(0)
"""
LONGEST_LOAD = 60.0  # [s]


def numbers_of(library, names):
    """{name: the number that a library has, or None}. The library is loaded by a process of its own, since its code runs then. A Problem where it can't be
    loaded, or ends that process."""
    with tempfile.TemporaryDirectory() as folder:
        answer = os.path.join(folder, "answer.json")
        try:
            process = subprocess.run([sys.executable, "-c", LOAD, os.path.abspath(library), answer, *names], stdin=subprocess.DEVNULL,
                                     stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=LONGEST_LOAD, check=False)
        except subprocess.TimeoutExpired:
            raise Problem(f"{library}: is not loaded after {LONGEST_LOAD:g} s; look at what it does when it is loaded.") from None
        if not os.path.exists(answer):
            code = process.returncode
            how = f"signal {-code} ({signal.strsignal(-code)})" if code < 0 else f"exit status {code}"
            raise Problem(f"{library}: ends the program that loads it, with {how}; look at what it does when it is loaded.")
        with open(answer, encoding="utf-8") as file:
            found = json.load(file)
    if isinstance(found, str):
        raise Problem(f"{library}: can't be loaded: {found}")
    return found


def laws_of(library, source, behaviour=None):
    """A line for each law of a library: its name, its interface and how many constants and state variables it says to have. behaviour: the name of
    a further function that is a law."""
    names = symbols(library)
    found = [(name.rstrip("_"), "VUMAT" if name.startswith("vumat") else "UMAT") for name in sorted(names) if re.fullmatch(r"v?umat_?", name)]
    found += [(name[: -len("_Tridimensional")], "MFront") for name in sorted(names) if name.endswith("_Tridimensional")]
    if behaviour is not None:
        if not names & {behaviour, behaviour.lower(), behaviour + "_", behaviour.lower() + "_"}:
            raise Problem(f"{source}: has no function {behaviour}.")
        found.append((behaviour, "VUMAT or UMAT"))
    if not found:
        others = sorted(name for name in names if not name.startswith("_"))
        raise Problem(f"{source}: has no function vumat, umat or NAME_Tridimensional, but {', '.join(others[:8]) or 'no function at all'}; "
                      "give the name of the law with --behaviour; a function of C++ needs extern \"C\".")
    counted = (("constants", "nMaterialProperties"), ("state variables", "nInternalStateVariables"))
    numbers = numbers_of(library, [f"{name}_{symbol}" for name, _ in found for _, symbol in counted])
    lines = []
    for name, interface in found:
        line = f"Behaviour: {name}, Interface: {interface}"
        for what, symbol in counted:
            count = numbers[f"{name}_{symbol}"]
            line += f", {what}: {count if count is not None else 'not exported'}"
        lines.append(line)
    return lines
