#!/usr/bin/env python3
"""Two cylinders with flat far sides that are pressed on each other, by plane elements: what finite blocks change in Hertz's contact.

    pressed_cylinders.py [WIDTH HEIGHT] [ELEMENTS]     size of each block in half widths of Hertz's contact, and elements in a half width

The far side of each block is held. Without friction between them, and with the shape of both given as a gap x^2 / (2 R), both blocks have the same stress,
whatever their moduli are (equal Poisson ratios), so that one block on a rigid parabola is solved. Units: the half width a, E* and p0 of Hertz are 1.
The nodes in contact are found by turns: no tension in contact, no overlap outside.
"""
import sys

import numpy
import scipy.sparse
import scipy.sparse.linalg

POISSON = 0.3
GAUSS = 1.0 / numpy.sqrt(3.0)


def strain_matrix(xi, eta, h):
    """Strains xx, yy, xy in a square of edge h by its 8 displacements."""
    slopes = numpy.array([[eta - 1.0, 1.0 - eta, 1.0 + eta, -1.0 - eta], [xi - 1.0, -1.0 - xi, 1.0 + xi, 1.0 - xi]]) / (2.0 * h)
    matrix = numpy.zeros((3, 8))
    matrix[0, 0::2] = matrix[2, 1::2] = slopes[0]
    matrix[1, 1::2] = matrix[2, 0::2] = slopes[1]
    return matrix


class Block:
    """A block of nx by ny squares, held at its base."""

    def __init__(self, width, height, elements):
        self.h, self.nx, self.ny = 1.0 / elements, round(width * elements), round(height * elements)
        young = 2.0 * (1.0 - POISSON**2)  # two equal blocks: 1 / E* = 2 (1 - nu^2) / E
        first = young / ((1.0 + POISSON) * (1.0 - 2.0 * POISSON))
        self.law = first * numpy.array([[1.0 - POISSON, POISSON, 0.0], [POISSON, 1.0 - POISSON, 0.0], [0.0, 0.0, 0.5 - POISSON]])
        points = [strain_matrix(xi, eta, self.h) for xi in (-GAUSS, GAUSS) for eta in (-GAUSS, GAUSS)]
        stiffness = sum(b.T @ self.law @ b for b in points) * self.h**2 / 4.0
        i, j = (part.ravel() for part in numpy.meshgrid(numpy.arange(self.nx), numpy.arange(self.ny), indexing="ij"))
        corners = numpy.stack([self.node(i, j), self.node(i + 1, j), self.node(i + 1, j + 1), self.node(i, j + 1)], axis=1)
        self.numbers = numpy.stack([2 * corners, 2 * corners + 1], axis=2).reshape(-1, 8)
        rows, columns = numpy.repeat(self.numbers, 8, axis=1).ravel(), numpy.tile(self.numbers, (1, 8)).ravel()
        matrix = scipy.sparse.coo_matrix((numpy.tile(stiffness.ravel(), len(corners)), (rows, columns))).tocsc()
        base = self.node(numpy.arange(self.nx + 1), 0)
        free = numpy.ones(matrix.shape[0], bool)
        free[2 * base] = free[2 * base + 1] = False
        self.free = numpy.flatnonzero(free)
        self.solver = scipy.sparse.linalg.splu(matrix[self.free][:, self.free])
        self.unknowns = matrix.shape[0]

    def node(self, i, j):
        return i * (self.ny + 1) + j

    def displacement(self, numbers, forces):
        load = numpy.zeros(self.unknowns)
        load[numbers] = forces
        found = numpy.zeros(self.unknowns)
        found[self.free] = self.solver.solve(load[self.free])
        return found

    def largest_von_mises(self, displacement):
        """In the middles of the squares below the first row."""
        stress = displacement[self.numbers] @ strain_matrix(0.0, 0.0, self.h).T @ self.law
        x, y, xy = stress.T
        z = POISSON * (x + y)
        values = numpy.sqrt(0.5 * ((x - y) ** 2 + (y - z) ** 2 + (z - x) ** 2) + 3.0 * xy**2)
        return values.reshape(self.nx, self.ny)[:, self.ny // 2 : -1].max()


def contact(block, elements):
    """Surface nodes around the middle: their numbers, positions and forces under Hertz's load pi / 2."""
    middle = block.nx // 2
    columns = numpy.arange(middle - 2 * elements, middle + 2 * elements + 1)
    numbers = 2 * block.node(columns, block.ny) + 1
    compliance = numpy.stack([block.displacement(number, 1.0)[numbers] for number in numbers], axis=1)
    x = (columns - 0.5 * block.nx) * block.h
    # Two cylinders: each bears half of the gap x^2 / (2 R); with a = E* = p0 = 1, R is 1 / 2.
    gap = 0.5 * x**2
    closed = numpy.abs(x) < 1.0
    for _ in range(100):
        k = numpy.flatnonzero(closed)
        matrix = numpy.ones((len(k) + 1, len(k) + 1))
        matrix[:-1, :-1], matrix[:-1, -1], matrix[-1, -1] = compliance[numpy.ix_(k, k)], -1.0, 0.0
        answer = numpy.linalg.solve(matrix, numpy.append(-gap[k], 0.5 * numpy.pi))
        forces = numpy.zeros(len(x))
        forces[k] = answer[:-1]
        now = numpy.where(closed, forces > 0.0, compliance @ forces + gap < answer[-1] - 1e-12)
        if (now == closed).all():
            return numbers, x, forces
        closed = now
    raise RuntimeError("the nodes in contact did not settle")


def main():
    width, height = (float(value) for value in (sys.argv[1:3] or (12, 6)))
    elements = int(sys.argv[3]) if len(sys.argv) > 3 else 16
    block = Block(width, height, elements)
    numbers, x, forces = contact(block, elements)
    inside = numpy.abs(x) <= 0.8
    slope, square = numpy.polyfit(x[inside] ** 2, (forces[inside] / block.h) ** 2, 1)
    print(f"half width {numpy.sqrt(-square / slope):.4f} of Hertz's, pressure {numpy.sqrt(square):.4f} p0, "
          f"largest von Mises stress {block.largest_von_mises(block.displacement(numbers, -forces)):.4f} p0")


if __name__ == "__main__":
    main()
