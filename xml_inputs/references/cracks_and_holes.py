#!/usr/bin/env python3
"""K at the tips of straight cracks near one another and near round holes, in an infinite plate under tension. Needs numpy.

    cracks_and_holes.py          checks itself against closed forms and prints the differences

Complex potentials (N. I. Muskhelishvili, Some Basic Problems of the Mathematical Theory of Elasticity, 1953): a crack is a density of
dislocations F(s) / sqrt(1 - s^2), integrated by the rule of Gauss and Chebyshev (F. Erdogan and G. D. Gupta, Quart. Appl. Math. 29 (1972)
525); a hole is a series of poles at its centre. Faces and holes bear no tractions and no dislocation is left in a crack: linear equations, solved
by least squares. Nothing hangs on elastic constants, as no hole bears a force.
"""
import cmath
import math

import numpy as np


class Crack:
    def __init__(self, start, end, count=80):
        self.centre, self.half = (start + end) / 2, (end - start) / 2
        self.count = count
        self.nodes = np.cos((2 * np.arange(1, count + 1) - 1) * np.pi / (2 * count))
        self.at = self.centre + self.half * self.nodes
        between = np.cos(np.arange(1, count) * np.pi / count)
        self.points = self.centre + self.half * between
        self.tangents = np.full(count - 1, self.half / abs(self.half))

    def parts(self, z):
        """Of unknowns F: what they and their conjugates add to Phi and to conj(z) Phi' + Psi. Arrays of shape (len(z), count)."""
        far = 1 / (z[:, None] - self.at[None, :])
        weight = np.pi / self.count
        bar = np.conj(z[:, None] - self.at[None, :])
        return weight * far, -weight * bar * far**2, weight * far  # Phi by F; sheared part by F, by conj(F)

    def tips(self, unknowns):
        """K_I - i K_II at the start and the end."""
        angle = np.arccos(self.nodes)
        order = np.arange(self.count)
        series = 2 / self.count * np.cos(np.outer(order, angle)) @ unknowns
        series[0] /= 2
        turn = 2 * math.pi**1.5 * abs(self.half) / self.half / math.sqrt(abs(self.half))
        return -turn * np.sum(series * (-1.0) ** order), turn * np.sum(series)


class Hole:
    def __init__(self, centre, radius, count=120):
        self.centre, self.radius, self.count = centre, radius, count
        round_ = np.exp(2j * np.pi * (np.arange(4 * count) + 0.5) / (4 * count))
        self.points = centre + radius * round_
        self.tangents = 1j * round_

    def parts(self, z):
        """The same for its poles: those of Phi, then those of Psi."""
        order = np.arange(2, self.count + 2)
        w = (z - self.centre) / self.radius
        poles = w[:, None] ** -order[None, :]
        zero = np.zeros_like(poles)
        sheared = -np.conj(w)[:, None] * order[None, :] * poles / w[:, None]
        return np.hstack([poles, zero]), np.hstack([sheared, poles]), np.hstack([zero, zero])


def intensities(cracks, holes, stress):
    """K_I - i K_II [Pa m^0.5] at both tips of each crack, in order.

    cracks: pairs of complex positions [m]; holes: pairs of a complex centre and a radius [m]; stress: xx, yy, xy far away [Pa]
    """
    parts = [Crack(*crack) for crack in cracks] + [Hole(*hole) for hole in holes]
    z = np.concatenate([part.points for part in parts])
    turn = np.concatenate([part.tangents for part in parts]) ** 2
    xx, yy, xy = stress
    far = (xx + yy) / 2 + turn * ((yy - xx) / 2 + 1j * xy)
    rows = []
    by, by_conjugate = [], []
    for part in parts:
        phi, sheared, sheared_conjugate = part.parts(z)
        by.append(phi + turn[:, None] * sheared)
        by_conjugate.append(np.conj(phi) + turn[:, None] * sheared_conjugate)
    by, by_conjugate = np.hstack(by), np.hstack(by_conjugate)
    right = -far
    closed = np.zeros((len(cracks), by.shape[1]), complex)
    column = 0
    for row, part in enumerate(parts[:len(cracks)]):
        closed[row, column:column + part.count] = 1 / part.count
        column += part.count
    by = np.vstack([by, closed])
    by_conjugate = np.vstack([by_conjugate, 0 * closed])
    right = np.concatenate([right, np.zeros(len(cracks))])
    # u by + conj(u) by_conjugate = right, in real and imaginary parts
    real, imaginary = by + by_conjugate, 1j * (by - by_conjugate)
    matrix = np.block([[real.real, imaginary.real], [real.imag, imaginary.imag]])
    scale = np.linalg.norm(matrix, axis=0)
    scale[scale == 0] = 1
    found = np.linalg.lstsq(matrix / scale, np.concatenate([right.real, right.imag]), rcond=1e-13)[0] / scale
    unknowns = found[:by.shape[1]] + 1j * found[by.shape[1]:]
    tips, column = [], 0
    for part in parts[:len(cracks)]:
        tips += part.tips(unknowns[column:column + part.count])
        column += part.count
    return tips


def check():
    """Prints the difference from closed forms, and returns the largest."""
    worst = 0.0

    def compare(name, found, exact):
        nonlocal worst
        off = abs(found - exact) / abs(exact)
        worst = max(worst, off)
        print("%-60s %12.6f %+12.6fi   off by %.1e" % (name, found.real, found.imag, off))

    a, angle = 0.7, 0.4
    tip = a * cmath.exp(1j * angle)
    one = intensities([(-tip, tip)], [], (0, 1, 0))
    exact = math.sqrt(math.pi * a) * (math.cos(angle) ** 2 - 1j * math.sin(angle) * math.cos(angle))
    compare("one inclined crack, start", one[0], exact)
    compare("one inclined crack, end", one[1], exact)
    # Two collinear cracks from b to c on both sides of the middle (W. T. Koiter, Ing. Arch. 28 (1959) 168).
    b, c = 0.2, 1.0
    ratio = elliptic(1 - (b / c) ** 2)
    two = intensities([(-c, -b), (b, c)], [], (0, 1, 0))
    root = math.sqrt(math.pi / (c * c - b * b))
    compare("two collinear cracks, inner", two[2], root * (c * c * ratio - b * b) / math.sqrt(b))
    compare("two collinear cracks, outer", two[3], root * c * c * (1 - ratio) / math.sqrt(c))
    # A small crack beside a hole has the stress of Kirsch there.
    r, x, tiny = 1.0, 1.5, 1e-4
    beside = intensities([(x - tiny, x + tiny)], [(0, r)], (0, 1, 0))
    hoop = 1 + r * r / (2 * x * x) + 3 * r**4 / (2 * x**4)
    compare("a small crack beside a hole", beside[1], hoop * math.sqrt(math.pi * tiny))
    return worst


def elliptic(m):
    """E(m) / K(m) of complete elliptic integrals, by the mean of arithmetic and geometric means."""
    a, b, total, power = 1.0, math.sqrt(1 - m), 1 - m / 2, 1.0
    for _ in range(12):
        c = (a - b) / 2
        a, b = (a + b) / 2, math.sqrt(a * b)
        total -= power * c * c
        power *= 2
    return total


if __name__ == "__main__":
    if check() > 2e-4:
        raise SystemExit("off by more than 2e-4")
