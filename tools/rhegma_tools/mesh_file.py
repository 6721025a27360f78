"""Writes files of bodies: polygons of a drawing as text, and a STEP file as triangles by gmsh."""

import os
import shutil

import numpy as np

from rhegma.problem import Problem
from rhegma.program import capture

from .output_file import replacing, text_to

GMSH = "gmsh is not on the PATH; it makes the triangles of STEP files. Install it, on Debian or Ubuntu with apt-get install gmsh."
CURVATURE = 40  # edges of triangles around a full circle


def write_polygons(polygons, path, source):
    """Writes polygons [m]: two numbers a line, an empty line between polygons. source: path of the drawing, which is named in a comment"""
    blocks = ["\n".join(f"{x:.9g} {y:.9g}" for x, y in points) + "\n" for points in polygons]
    with text_to(path, [source]) as file:
        file.write(f"# polygons of {os.path.basename(source)}, in metres\n" + "\n".join(blocks))


def convert_step(path, output, size=None):
    """Writes the triangles of a STEP file as a binary STL file in metres. size: largest edge of a triangle [m], or None"""
    if not os.path.isfile(path):
        raise Problem(f"there is no file {path}; give a STEP file or an SVG drawing.")
    gmsh = shutil.which("gmsh")
    if gmsh is None:
        raise Problem(GMSH)
    with replacing(output, [path]) as temporary:
        command = [gmsh, path, "-2", "-format", "stl", "-bin", "-o", temporary, "-setstring", "Geometry.OCCTargetUnit", "M",
                   "-clcurv", str(CURVATURE), *(["-clmax", repr(size)] if size else [])]
        status, text, messages = capture(command)
        if status != 0 or not os.path.exists(temporary):
            errors = [line for line in (text + messages).splitlines() if "Error" in line]
            raise Problem(f"gmsh can't convert {path}: " + (errors[0].partition(":")[2].strip() if errors else f"exit status {status}."))


def triangles_of(path):
    """(n, 3, 3) corners of the triangles of a binary STL file; None of another file."""
    row = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("more", "<u2")])
    with open(path, "rb") as file:
        data = file.read()
    count = int.from_bytes(data[80:84], "little")
    if len(data) < 84 or len(data) != 84 + count * row.itemsize:
        return None
    return np.frombuffer(data, row, count, 84)["corners"].astype(float)


def volume_of(triangles):
    """Of the body that they enclose, where their corners run counter-clockwise seen from outside."""
    first, second, third = (triangles[:, k] for k in range(3))
    return float((first * np.cross(second, third)).sum() / 6.0)


def describe(path):
    """What an STL file holds, so that a wrong unit shows: "1,234 triangles from (0, 0, 0) m to (0.1, 0.02, 0.02) m, volume 4e-05 m3"."""
    triangles = triangles_of(path)
    if triangles is None or len(triangles) == 0:
        return "triangles in metres"
    low, high = (", ".join(f"{x:.6g}" for x in end) for end in (triangles.min((0, 1)), triangles.max((0, 1))))
    return f"{len(triangles):,} triangles from ({low}) m to ({high}) m, volume {volume_of(triangles):.6g} m3"
