"""Parts as STL files: lists of triangles (n, 3, 3) with normals outwards."""

import struct

import numpy


def brick(low, high):
    """A box of 12 triangles."""
    corners = numpy.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], dtype=float)
    corners = numpy.array(low) + corners * (numpy.array(high) - numpy.array(low))
    sides = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    return numpy.array([corners[list(t)] for a, b, c, d in sides for t in ((a, b, c), (a, c, d))])


def bracket(side, hole, thickness, pieces=8, holes=(True, True, True)):
    """An L of three square plates of a side, with round holes of a radius. pieces: of a side"""
    count, triangles = 4 * pieces, []

    def quadrangle(a, b, c, d):
        triangles.extend([[a, b, c], [a, c, d]])

    for (x0, y0), has_hole in zip(((0, 0), (1, 0), (0, 1)), holes):
        steps = numpy.arange(pieces) / pieces
        ones, zeros = numpy.ones(pieces), numpy.zeros(pieces)
        square = numpy.vstack([numpy.c_[steps, zeros], numpy.c_[ones, steps], numpy.c_[1 - steps, ones], numpy.c_[zeros, 1 - steps]])
        square = side * (square + [x0, y0])
        middle = side * numpy.array([x0 + 0.5, y0 + 0.5])
        turn = 2 * numpy.pi * numpy.arange(count) / count - 0.75 * numpy.pi
        circle = middle + hole * numpy.c_[numpy.cos(turn), numpy.sin(turn)]
        low, high = (lambda p: [*p, 0.0]), (lambda p: [*p, thickness])
        for k in range(count):
            a, b, c, d = square[k], square[(k + 1) % count], circle[(k + 1) % count], circle[k]
            if has_hole:
                quadrangle(high(a), high(b), high(c), high(d))
                quadrangle(low(a), low(d), low(c), low(b))
                quadrangle(low(d), high(d), high(c), low(c))
            else:
                triangles.extend([[high(a), high(b), high(middle)], [low(a), low(middle), low(b)]])
            across = 0.5 * (a + b)
            common = (across[0] == side and across[1] < side) or (across[1] == side and across[0] < side)
            if not common:
                quadrangle(low(a), low(b), high(b), high(a))
    return numpy.array(triangles)


def ascii_stl(triangles):
    lines = ["solid part"]
    for triangle in triangles:
        lines += ["facet normal 0 0 0", "outer loop", *("vertex " + " ".join(repr(float(c)) for c in x) for x in triangle), "endloop", "endfacet"]
    return "\n".join([*lines, "endsolid part", ""])


def binary_stl(triangles):
    record = numpy.zeros(len(triangles), dtype=[("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("mark", "<u2")])
    record["corners"] = triangles
    return b" " * 80 + struct.pack("<I", len(triangles)) + record.tobytes()
