#!/usr/bin/env python3
"""The lag of the front springs in 3D, from the near field of a straight front at any angle in the plane of its crack.

The crack lies along the cells, and its front runs along (p, q) in its plane: the cells repeat along the front, so one period of them is
computed. Beyond a distance from the front, nodes move as the near field of K_I, K_II or K_III in plane strain. As in front_cell.py, the lag
is the excess of the strain energy over that of the field, divided by G: the crack of the cells ends by so much behind its front. Nothing
is fitted here: the constants are those that front_cell.py finds in 2D (packages/cracks/FrontCell.hpp).

    front_cell_3d.py              mean and scatter of the lag over positions of the front in its cell, and the energy of the springs
    front_cell_3d.py --before     the same of the law for limited springs
"""
import argparse
import math

import numpy as np
import scipy.sparse
import scipy.sparse.linalg
import scipy.stats

import front_cell

RADIUS = 7  # of the cells that are computed, around the front
BAND, SIDE_TOLERANCE = front_cell.BAND, front_cell.SIDE_TOLERANCE
FRONTS = [(1, 0), (3, 1), (2, 1), (3, 2), (1, 1)]
CORNERS = np.array([[a, b, c] for a in (0, 1) for b in (0, 1) for c in (0, 1)])


def moduli(nu):
    """Young's and the shear modulus for E' = 1."""
    return 1 - nu * nu, 0.5 * (1 - nu)


def displacement(x, z, mode, nu, side):
    """Near field ahead of the front, along it and across the crack, for G = 1; side +1 and -1 continue a face."""
    mu, k = moduli(nu)[1], 3 - 4 * nu
    r, t = np.hypot(x, z), np.arctan2(z, x)
    t = np.where((side > 0) & (t < -np.pi / 2), t + 2 * np.pi, t)
    t = np.where((side < 0) & (t > np.pi / 2), t - 2 * np.pi, t)
    c, s, none = np.cos(t / 2), np.sin(t / 2), np.zeros_like(r)
    f = np.sqrt(r / (2 * np.pi)) / (2 * mu)
    if mode == 1:
        return f * c * (k - 1 + 2 * s * s), none, f * s * (k + 1 - 2 * c * c)
    if mode == 2:
        return f * s * (k + 1 + 2 * c * c), none, -f * c * (k - 1 - 2 * s * s)
    return none, math.sqrt(2 / mu) * np.sqrt(2 * r / np.pi) * s, none


def stress(x, z, mode, nu):
    """xx, yy, zz, xy, xz, yz in the same axes."""
    mu = moduli(nu)[1]
    r, t = np.hypot(x, z), np.arctan2(z, x)
    f, c, s = 1 / np.sqrt(2 * np.pi * r), np.cos(t / 2), np.sin(t / 2)
    c3, s3, none = np.cos(1.5 * t), np.sin(1.5 * t), np.zeros_like(r)
    if mode == 3:
        return none, none, none, -math.sqrt(2 * mu) * f * s, none, math.sqrt(2 * mu) * f * c
    if mode == 1:
        xx, zz, xz = f * c * (1 - s * s3), f * c * (1 + s * s3), f * s * c * c3
    else:
        xx, zz, xz = -f * s * (2 + c * c3), f * s * c * c3, f * c * (1 - s * s3)
    return xx, nu * (xx + zz), zz, none, xz, none


class NewLaw:
    def __init__(self, constants, conductance=None):
        self.law = front_cell.NewLaw(constants)

    def opens(self, behind):
        return self.law.opens(behind, 1.0, np.zeros_like(behind))

    def spring(self, behind, away, mass, other):
        return self.law.spring(behind, 1.0, away, mass, other)


class OldLaw:
    def opens(self, behind):
        return behind > 0.02

    def spring(self, behind, away, mass, other):
        return front_cell.OldLaw().spring(behind, 1.0, away, mass, other)


class Cells:
    """One period of cells around a front through the plane's point `from_node` cells ahead of a node, the crack `height` above one."""

    def __init__(self, along, from_node, height):
        self.period, self.offset, self.height = along, from_node, height
        self.length = math.hypot(*along)
        self.tangent = np.array(along) / self.length
        self.ahead = np.array([-self.tangent[1], self.tangent[0]])
        p = along[0]
        j = np.arange(-8 * RADIUS, 8 * RADIUS)
        self.plane = np.array([(i, k) for i in range(p) for k in j if abs(self.ahead @ (i + 0.5, k + 0.5)) < RADIUS])
        self.cell = np.concatenate([np.column_stack([self.plane, np.full(len(self.plane), k)]) for k in range(-RADIUS, RADIUS)])
        corners = self.in_period((self.cell[:, None, :] + CORNERS).reshape(-1, 3))
        self.node, number, count = np.unique(corners, axis=0, return_inverse=True, return_counts=True)
        self.corner = number.reshape(-1, 8)
        self.rim = count < 8
        self.x, self.z = self.local(self.node)

    def in_period(self, points):
        times = points[:, 0] // self.period[0]
        return np.column_stack([points[:, d] - times * self.period[d] for d in (0, 1)] + [points[:, 2]])

    def local(self, points):
        """Ahead of the front and above the crack."""
        return points[:, :2] @ self.ahead - self.offset, points[:, 2] - self.height


def material_points(cells, particles):
    """Cells, places in them, volumes and sides of the particles: those that the crack passes through are two."""
    half, count = 0.5 / particles, len(cells.cell)
    places = (np.arange(particles) + 0.5) / particles
    place = np.concatenate([np.tile([a, b, c], (count, 1)) for a in places for b in places for c in places])
    index = np.tile(np.arange(count), particles**3)
    x, z = cells.local(cells.cell[index] + place)
    volume, own = np.full(len(index), 1.0 / particles**3), np.where(z >= -1e-6, 1, -1)
    cut = (np.abs(z) < half - 1e-9) & (x + half * np.abs(cells.ahead).sum() <= 0)
    parts = [(index[~cut], place[~cut], volume[~cut], own[~cut])]
    for sign in (1, -1):
        height = half + sign * z[cut]
        moved = place[cut].copy()
        moved[:, 2] += sign * (half - height / 2)
        parts.append((index[cut], moved, height / particles**2, np.full(cut.sum(), sign)))
    return [np.concatenate(v) for v in zip(*parts)]


def assemble(cells, split, side, enriched, nu, particles):
    """Entries of the stiffness matrix, and the mass of each field."""
    young, mu = moduli(nu)
    law = np.diag([2 * mu] * 3 + [mu] * 3)
    law[:3, :3] += young * nu / ((1 + nu) * (1 - 2 * nu))
    index, place, volume, own = material_points(cells, particles)
    strain, row = np.zeros((len(index), 6, 24)), np.zeros((len(index), 24), int)
    mass = np.zeros(len(cells.node) + split.sum())
    for k, corner in enumerate(CORNERS):
        weight = [place[:, d] if far else 1 - place[:, d] for d, far in enumerate(corner)]
        slope = [(2 * corner[d] - 1) * weight[(d + 1) % 3] * weight[(d + 2) % 3] for d in range(3)]
        node = cells.corner[index, k]
        field = np.where(split[node] & (side[node] != own), enriched[node], node)
        np.add.at(mass, field, weight[0] * weight[1] * weight[2] * volume)
        for d in range(3):
            strain[:, d, 3 * k + d], row[:, 3 * k + d] = slope[d], 3 * field + d
        for shear, (a, b) in ((3, (0, 1)), (4, (1, 2)), (5, (0, 2))):
            strain[:, shear, 3 * k + a], strain[:, shear, 3 * k + b] = slope[b], slope[a]
    stiffness = np.einsum("pai,ab,pbj,p->pij", strain, law, strain, volume, optimize=True)
    return [np.repeat(row, 24, 1).ravel(), np.tile(row, (1, 24)).ravel(), stiffness.ravel()], mass


def exact_energy(cells, mode, nu):
    """Strain energy of the near field in the cells of a period, by the work on their outer faces."""
    n = 24
    at = (np.arange(n) + 0.5) / n
    a, b = (v.ravel() for v in np.meshgrid(at, at, indexing="ij"))
    inside = set(map(tuple, cells.plane))

    def work(points, normal):
        x, z = cells.local(points)
        u = displacement(x, z, mode, nu, np.zeros_like(x))
        xx, yy, zz, xy, xz, yz = stress(x, z, mode, nu)
        nx, ny, nz = cells.ahead @ normal[:2], cells.tangent @ normal[:2], normal[2]
        pull = xx * nx + xy * ny + xz * nz, xy * nx + yy * ny + yz * nz, xz * nx + yz * ny + zz * nz
        return 0.5 * sum(np.sum(u[d] * pull[d]) for d in range(3)) / n**2

    energy = 0.0
    for i, j in cells.plane:
        for axis, sign in ((0, 1), (0, -1), (1, 1), (1, -1)):
            beyond = np.array([[i + sign * (axis == 0), j + sign * (axis == 1), 0]])
            if tuple(cells.in_period(beyond)[0][:2]) in inside:
                continue
            for k in range(-RADIUS, RADIUS):
                face = np.column_stack([i + a, j + a, k + b])
                face[:, axis] = (i, j)[axis] + (sign > 0)
                energy += work(face, np.array([sign * (axis == 0), sign * (axis == 1), 0.0]))
        for sign in (1, -1):
            energy += work(np.column_stack([i + a, j + b, np.full(n * n, float(sign * RADIUS))]), np.array([0.0, 0.0, sign]))
    return energy


def lag(law, along, from_node, height, mode, nu=0.3, particles=2):
    """By how many cells the crack of the cells ends behind its front, and the energy of the springs over G and a cell."""
    cells = Cells(along, from_node, height)
    x, z, count = cells.x, cells.z, len(cells.node)
    split = law.opens(-x) & (np.abs(z) < BAND)
    side = np.where(z > -SIDE_TOLERANCE, 1, -1)
    enriched = np.cumsum(split) - 1 + count
    entries, mass = assemble(cells, split, side, enriched, nu, particles)
    own, other = mass[:count], np.where(split, mass[np.minimum(enriched, len(mass) - 1)], 0)
    k = np.where(split & (own > 0) & (other > 0), law.spring(-x, np.abs(z), own, other), 0)
    rows, columns, values = front_cell.add_springs(entries, k, enriched, 3)
    size = 3 * len(mass)
    K = scipy.sparse.csr_matrix((values, (rows, columns)), (size, size)) + 1e-9 * scipy.sparse.identity(size)
    u, fixed = np.zeros(size), np.zeros(size, bool)
    for at, sign, number in ((cells.rim, side, np.arange(count)), (cells.rim & split, -side, enriched)):
        i = np.nonzero(at)[0]
        ahead, tangent, across = displacement(x[i], z[i], mode, nu, np.where(np.abs(z[i]) < BAND, sign[i], 0))
        for d in (0, 1):
            u[3 * number[i] + d] = ahead * cells.ahead[d] + tangent * cells.tangent[d]
        u[3 * number[i] + 2] = across
        for d in range(3):
            fixed[3 * number[i] + d] = True
    free = ~fixed
    u[free] = scipy.sparse.linalg.spsolve(K[free][:, free].tocsc(), -K[free][:, fixed] @ u[fixed])
    node = np.nonzero(k)[0]
    jump = u.reshape(-1, 3)[node] - u.reshape(-1, 3)[enriched[node]]
    return ((0.5 * u @ (K @ u) - exact_energy(cells, mode, nu)) / cells.length - front_cell.REMOTE,
            0.5 * np.sum(k[node] * np.sum(jump**2, 1)) / cells.length)


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--before", action="store_true")
    options.add_argument("--positions", type=int, default=8, help="of the front in its cell")
    options.add_argument("--particles", type=int, default=2, help="of a cell along an axis")
    chosen = options.parse_args()
    law = OldLaw() if chosen.before else NewLaw(front_cell.read_constants())
    points = front_cell.positions(chosen.positions, 5)
    print("angle of the front to the cells; of modes I, II, III: lag, its scatter [cells]; energy of springs [G cells]")
    for along in FRONTS:
        row = []
        for mode in (1, 2, 3):
            found = np.array([lag(law, along, a, b, mode, particles=chosen.particles) for a, b in points])
            row.append("%+.3f %.3f; %.3f" % (found[:, 0].mean(), found[:, 0].std(), found[:, 1].mean()))
        print("%5.1f   " % math.degrees(math.atan2(along[1], along[0])) + "   ".join(row), flush=True)


if __name__ == "__main__":
    main()
