#!/usr/bin/env python3
"""K_I of circumferential cracks in round bars by plain finite elements, relative to the fit of Benthem and Koiter.

Bilinear axisymmetric elements of one half of the bar; G by the change of energy over two elements. Independent of the program: it says by how
much the fit, with which xml_inputs/verification/ring_crack_static.xml is compared, is off.

    unit_tests/studies/round_bars.py"""

import math
import os
import sys

import numpy
import scipy.sparse
import scipy.sparse.linalg

sys.path.insert(0, os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", "program"))
sys.dont_write_bytecode = True

from round_bodies import POISSON, ring_intensity  # noqa: E402

RADIUS, HALF = 1.0, 2.5  # of the bar, and half of its length


def stiffness(inner, size):
    """Of the square element between the radii inner and inner + size, with Young's modulus 1: 2 x 2 points of Gauss."""
    lame, shear = POISSON / (1 + POISSON) / (1 - 2 * POISSON), 0.5 / (1 + POISSON)
    law = numpy.full((4, 4), 0.0)
    law[:3, :3] = lame
    law += numpy.diag([2 * shear] * 3 + [shear])
    matrix = numpy.zeros((8, 8))
    corners = numpy.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
    for point in corners / math.sqrt(3):
        along = 1 + corners * point
        radius = inner + 0.5 * size * (1 + point[0])
        strain = numpy.zeros((4, 8))
        strain[0, 0::2] = strain[3, 1::2] = corners[:, 0] * along[:, 1] / (2 * size)
        strain[1, 1::2] = strain[3, 0::2] = corners[:, 1] * along[:, 0] / (2 * size)
        strain[2, 0::2] = 0.25 * along[:, 0] * along[:, 1] / radius
        matrix += strain.T @ law @ strain * (2 * math.pi * radius * size**2 / 4)
    return matrix


def energy(count, ligament):
    """Of the whole bar under unit tension. \\param count of elements along the radius \\param ligament its radius in elements"""
    size = RADIUS / count
    rows = round(HALF / size)
    node = numpy.arange((count + 1) * (rows + 1)).reshape(count + 1, rows + 1)
    first, second, values = [], [], []
    for i in range(count):
        block = stiffness(i * size, size)
        for j in range(rows):
            corner = numpy.array([node[i, j], node[i + 1, j], node[i + 1, j + 1], node[i, j + 1]])
            unknown = numpy.stack([2 * corner, 2 * corner + 1], axis=1).ravel()
            first.append(numpy.repeat(unknown, 8))
            second.append(numpy.tile(unknown, 8))
            values.append(block.ravel())
    number = 2 * node.size
    matrix = scipy.sparse.csr_matrix((numpy.concatenate(values), (numpy.concatenate(first), numpy.concatenate(second))),
                                     shape=(number, number))
    force = numpy.zeros(number)
    for i in range(count):
        low, high = i * size, (i + 1) * size
        force[2 * node[i, rows] + 1] += 2 * math.pi * size * (low / 3 + high / 6)
        force[2 * node[i + 1, rows] + 1] += 2 * math.pi * size * (low / 6 + high / 3)
    held = numpy.concatenate([2 * node[0], 2 * node[:ligament + 1, 0] + 1])
    free = numpy.setdiff1d(numpy.arange(number), held)
    solution = scipy.sparse.linalg.spsolve(matrix[free][:, free].tocsc(), force[free])
    return force[free] @ solution  # of both halves


def main():
    print("ligament / radius | elements along the radius | K over the fit")
    for fraction in (0.3, 0.4, 0.5, 0.7):
        for count in (60, 120):
            ligament = round(fraction * count)
            area = math.pi * ((ligament + 1) ** 2 - (ligament - 1) ** 2) * (RADIUS / count) ** 2
            release = (energy(count, ligament - 1) - energy(count, ligament + 1)) / area
            ratio = math.sqrt(release / (1 - POISSON**2)) / ring_intensity(fraction * RADIUS, RADIUS, 1.0)
            print(f"{fraction} | {count} | {ratio:.4f}", flush=True)


if __name__ == "__main__":
    main()
