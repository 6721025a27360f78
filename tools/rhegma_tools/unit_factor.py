"""Numbers of a scene in SI units, by the library of units that the program uses (UDUNITS-2)."""

import ctypes
import ctypes.util
import functools
import re

from rhegma.problem import Problem

MISSING = "The scene has units, but libudunits2 is not there, so the picture can't be drawn; install it, on Debian or Ubuntu with apt-get install libudunits2-0."
UTF8, DEFINITION = 2, 8
OWN = {"deg": "arc_degree", "degs": "arc_degree"}  # names that the program adds
IN_DEGREES = ("Rotation",)  # parameters that are in degrees without a unit
DEGREE = 0.017453292519943295
NUMBER = re.compile(r"^\s*[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?\s*$")
QUANTITY = re.compile(r"^\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?|\{[^}]*\})\s*([A-Za-z%\u00b5\u03bc\u00b0].*|1\s*/.*)$")


@functools.lru_cache(maxsize=1)
def library():
    """(the library, its system of units); a Problem where there is none."""
    name = ctypes.util.find_library("udunits2")
    if name is None:
        raise Problem(MISSING)
    units = ctypes.CDLL(name)
    for function in ("ut_read_xml", "ut_parse"):
        getattr(units, function).restype = ctypes.c_void_p
    units.ut_set_error_message_handler.argtypes, units.ut_set_error_message_handler.restype = [ctypes.c_void_p], ctypes.c_void_p
    units.ut_set_error_message_handler(ctypes.cast(units.ut_ignore, ctypes.c_void_p))  # the program has its own messages
    units.ut_read_xml.argtypes = [ctypes.c_char_p]
    units.ut_parse.argtypes = [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_int]
    units.ut_format.argtypes = [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_size_t, ctypes.c_uint]
    system = units.ut_read_xml(None)
    if not system:
        raise Problem(MISSING)
    return units, system


@functools.lru_cache(maxsize=None)
def si_of(unit):
    """(factor, offset) with x unit = factor * (x + offset) in SI units; (1, 0) of what is no unit, of which the program says so."""
    units, system = library()
    named = re.sub(r"[A-Za-z]+", lambda word: OWN.get(word.group(), word.group()), unit.strip())
    parsed = units.ut_parse(system, named.encode(), UTF8)
    text = ctypes.create_string_buffer(400)
    if not parsed or units.ut_format(parsed, text, len(text), DEFINITION) < 0:
        return 1.0, 0.0
    # Such as "1000000 m-1.kg.s-2", "K @ 273.15" or "0.556 (K @ 459.67)".
    meaning = text.value.decode()
    factor = re.match(r"^([-+.\deE]+)(?=\s|$)", meaning)
    offset = re.search(r"@\s*([-+.\deE]+)", meaning)
    return float(factor.group(1)) if factor else 1.0, float(offset.group(1)) if offset else 0.0


def in_si(name, text, unit):
    """The value of a parameter in SI units, as text: of "2" with the unit "mm", of "2 mm", or of "{0, 5} MPa"; any other as it is."""
    quantity = None if NUMBER.match(text) else QUANTITY.match(text)
    if unit is None and quantity:
        text, unit = quantity.groups()
    if unit is None:
        return text
    numbers = text.strip().strip("{}").replace(",", " ").split()
    try:
        values = [float(number) for number in numbers]
    except ValueError:
        return text  # a table or an expression
    factor, offset = si_of(unit)
    factor = factor / DEGREE if name in IN_DEGREES else factor
    converted = [repr(float(f"{factor * (value + offset):.15g}")) for value in values]
    return "{" + ", ".join(converted) + "}" if text.strip().startswith("{") or len(values) != 1 else converted[0]
