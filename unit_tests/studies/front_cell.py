#!/usr/bin/env python3
"""Constants of the front springs in 2D, from the near field of a front in a patch of cells.

The rim of a patch of square cells moves as the near field of K_I or K_II (Williams, J. Appl. Mech. 24 (1957) 109). Nodes are split
and springs act as in packages/cracks, and particles that the crack passes through are divided along it. At rest the strain
energy exceeds that of the near field by G times the distance by which the crack of the cells ends behind the front: its lag. The constants make the lag small for any position of the front in
its cell, any angle to the cells and both modes. No body and no load enters. With particles at their starting places, linear
functions and GIMP are the same.

Heat passes between the fields of the same nodes. Its conductance comes from the same patch with the temperature of an insulating
crack across a flux on the rim, sqrt(r) sin(theta / 2), and the conductivity in place of E': that is mode III.

    front_cell.py            print the lag of the law of the constants in packages/cracks/FrontCell.hpp, in cells
    front_cell.py --heat     the same of the conductance
    front_cell.py --opening  force and opening of a node while the front moves through its cell, for a crack along the cells
    front_cell.py --before   the same of the law that 3D has
    front_cell.py --fit      fit the constants (some minutes) and write them to that file
"""
import argparse
import os
import re

import numpy as np
import scipy.optimize
import scipy.sparse
import scipy.sparse.linalg
import scipy.stats

HEAT = 3  # mode III: temperature across an insulating crack
MODE_II = 0.15  # weight in the fit: isotropic springs that are right in mode I lag by a few hundredths of a cell in mode II
HEADER = os.path.join(os.path.dirname(__file__), "../../packages/cracks/FrontCell.hpp")
NAMES = ["stiffness", "range", "lag", "lagTurned", "onCrack"]
ANGLES = [0, 4, 15, 30, 45]
RADIUS = 7  # of the patch in cells
REMOTE, REMOTE_HEAT = 0.012, 0.0  # excess energy of bilinear cells far from the front, which is no lag [cells]
SIDE_TOLERANCE, BAND = 0.097, 3.0  # packages/cracks/Sides.hpp, CrackGeometry.hpp
LEAST_DISTANCE = {True: 0.05, False: 0.003}  # with limited springs, without: packages/cracks/SpringConstants.hpp
CFL = 0.4


def parts(mode):
    """Values of a node."""
    return 1 if mode == HEAT else 2


def displacement(x, z, mode, nu, side):
    """Near field in plane stress for E = 1, K = 1; side +1 and -1 continue a face beyond the crack. That of heat for a
    conductivity of 1 is as large that G is 1: half the integral of the square of the gradient falls by 1 per length."""
    r, t = np.hypot(x, z), np.arctan2(z, x)
    t = np.where((side > 0) & (t < -np.pi / 2), t + 2 * np.pi, t)
    t = np.where((side < 0) & (t > np.pi / 2), t - 2 * np.pi, t)
    k, f, c, s = (3 - nu) / (1 + nu), np.sqrt(r / (2 * np.pi)) * (1 + nu), np.cos(t / 2), np.sin(t / 2)
    if mode == HEAT:
        return np.sqrt(4 * r / np.pi) * s, np.zeros_like(r)
    if mode == 1:
        return f * c * (k - 1 + 2 * s * s), f * s * (k + 1 - 2 * c * c)
    return f * s * (k + 1 + 2 * c * c), -f * c * (k - 1 - 2 * s * s)


def stress(x, z, mode):
    """xx, zz, xz of the near field for K = 1."""
    r, t = np.hypot(x, z), np.arctan2(z, x)
    f, c, s = 1 / np.sqrt(2 * np.pi * r), np.cos(t / 2), np.sin(t / 2)
    c3, s3 = np.cos(1.5 * t), np.sin(1.5 * t)
    if mode == HEAT:  # the flux, as work on the first value alone
        return -s / np.sqrt(np.pi * r), np.zeros_like(r), c / np.sqrt(np.pi * r)
    if mode == 1:
        return f * c * (1 - s * s3), f * c * (1 + s * s3), f * s * c * c3
    return -f * s * (2 + c * c3), f * s * c * c3, f * c * (1 - s * s3)


def local(t, x, z):
    return t[0] * x + t[1] * z, -t[1] * x + t[0] * z


def exact_energy(front, t, mode, nu):
    """Strain energy of the near field in the patch, by the work on its rim."""
    n = 4000
    along = (np.arange(n) + 0.5) / n * 2 * RADIUS - RADIUS
    energy = 0.0
    for axis in (0, 1):
        for sign in (-1, 1):
            point = [along, along]
            point[axis] = np.full(n, float(sign * RADIUS))
            x, z = local(t, point[0] - front[0], point[1] - front[1])
            nx, nz = local(t, sign * (axis == 0), sign * (axis == 1))
            ux, uz = displacement(x, z, mode, nu, np.zeros(n))
            xx, zz, xz = stress(x, z, mode)
            energy += 0.5 * np.sum(ux * (xx * nx + xz * nz) + uz * (xz * nx + zz * nz)) * 2 * RADIUS / n
    return energy


class NewLaw:
    """Where nodes open and the springs between their fields; constants as in FrontCell.hpp."""

    def __init__(self, constants, moving=False, conductance=None):
        self.__dict__.update(dict(zip(NAMES, constants)))
        self.beyond = 2.0  # z from which no particle gives a node a second field
        if conductance is not None:
            self.stiffness, self.onCrack = conductance, 0.0
        self.least = LEAST_DISTANCE[moving]

    def ahead(self, c, z):
        return np.full(len(z), (self.lag + self.lagTurned * (1 - c)) / c)

    def opens(self, behind, c, z):
        return behind > self.least - self.ahead(c, z)

    def spring(self, behind, c, z, mass, other):
        xi = np.maximum(behind + self.ahead(c, z), self.least)
        end = self.range / c
        share = np.sqrt(2 * np.minimum(mass, other) / np.maximum(mass + other, 1e-30))
        return self.stiffness * (1 + self.onCrack * np.maximum(0, 1 - 2 * z)) * np.maximum(end - xi, 0) / xi * share


class OldLaw:
    beyond = 1.0

    def ahead(self, c, z):
        return np.full(len(z), -0.02 if c > np.cos(np.radians(5)) else 0.03)

    def opens(self, behind, c, z):
        return behind > -self.ahead(c, z)

    def spring(self, behind, c, z, mass, other):
        xi = np.maximum(behind * np.sqrt(c) + 0.05, 1e-6)
        return 0.1 * np.maximum(1 - xi, 0) / xi * np.maximum(1 - z, 0)


def clip(corners, z):
    """The part of a convex polygon where z, of each corner, is positive: its area and centroid."""
    kept = []
    for i in range(len(corners)):
        j = (i + 1) % len(corners)
        if z[i] > 0:
            kept.append(corners[i])
        if (z[i] > 0) != (z[j] > 0):
            kept.append(corners[i] + z[i] / (z[i] - z[j]) * (corners[j] - corners[i]))
    if len(kept) < 3:
        return 0.0, corners[0]
    x, y = (np.array(kept) - kept[0]).T
    twice = x * np.roll(y, -1) - np.roll(x, -1) * y
    area = 0.5 * twice.sum()
    centre = [(twice * (v + np.roll(v, -1))).sum() / (6 * max(area, 1e-30)) for v in (x, y)]
    return area, kept[0] + np.array(centre)


def material_points(front, t, particles):
    """Cells, places in them, volumes and sides of the particles: those that the crack passes through are two."""
    edge, half = 2 * RADIUS + 1, 0.5 / particles
    cell = np.stack(np.meshgrid(np.arange(edge - 1), np.arange(edge - 1), indexing="ij"), -1).reshape(-1, 2)
    places = (np.arange(particles) + 0.5) / particles
    cells = np.concatenate([cell] * particles**2)
    place = np.concatenate([np.tile([a, b], (len(cell), 1)) for a in places for b in places])
    volume = np.full(len(cells), 1.0 / particles**2)
    x, z = local(t, *(cells + place - RADIUS - front).T)
    own = np.where(z >= -1e-6, 1, -1)
    reach = half * np.abs(t).sum()
    extra = []
    for k in np.nonzero((np.abs(z) < reach) & (x < 2 * half))[0]:
        corners = place[k] + half * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
        cx, cz = local(t, *(cells[k] + corners - RADIUS - front).T)
        next_x, next_z = np.roll(cx, -1), np.roll(cz, -1)
        crossed = (cz > 0) != (next_z > 0)
        meets = (cx + cz / np.where(crossed, cz - next_z, 1) * (next_x - cx))[crossed]
        if len(meets) == 0 or meets.max() > 1e-9:  # the front is inside, or ahead
            continue
        for sign in (1, -1):
            area, centre = clip(corners, sign * cz)
            if area > 1e-9:
                extra.append((cells[k], centre, area, sign))
        volume[k] = 0
    whole = volume > 0
    parts = [(cells[whole], place[whole], volume[whole], own[whole])]
    if extra:
        parts.append(tuple(np.array(v) for v in zip(*extra)))
    return [np.concatenate(v) for v in zip(*parts)]


def assemble(front, t, split, side, nu, particles, mode):
    """Rows, columns and values of the stiffness, and the mass of each field: nodes, then enriched fields."""
    n = parts(mode)
    edge = 2 * RADIUS + 1
    enriched = np.cumsum(split) - 1 + len(split)
    mass = np.zeros(len(split) + split.sum())
    law = np.array([[1, nu, 0], [nu, 1, 0], [0, 0, (1 - nu) / 2]]) / (1 - nu**2)
    cell, place, volume, own = material_points(front, t, particles)
    row, strain = np.zeros((len(cell), 4 * n), int), np.zeros((len(cell), 3, 4 * n))
    if mode == HEAT:
        law = np.diag([1.0, 0.0, 1.0])  # of both components of the gradient
    for k, (i, j) in enumerate(((0, 0), (1, 0), (0, 1), (1, 1))):
        nx, nz = (v if far else 1 - v for v, far in ((place[:, 0], i), (place[:, 1], j)))
        dx, dz = (2 * i - 1) * nz, (2 * j - 1) * nx
        node = (cell[:, 0] + i) * edge + cell[:, 1] + j
        field = np.where(split[node] & (side[node] != own), enriched[node], node)
        np.add.at(mass, field, nx * nz * volume)
        strain[:, 0, n * k], strain[:, 2, n * k], row[:, n * k] = dx, dz, n * field
        if mode != HEAT:
            strain[:, 1, 2 * k + 1], strain[:, 2, 2 * k + 1], row[:, 2 * k + 1] = dz, dx, 2 * field + 1
    stiffness = np.einsum("pai,ab,pbj,p->pij", strain, law, strain, volume)
    size = 4 * n
    return [np.repeat(row, size, 1).ravel(), np.tile(row, (1, size)).ravel(), stiffness.ravel()], mass, enriched


def add_springs(entries, stiffness, enriched, n):
    node = np.nonzero(stiffness)[0]
    rows, columns, values = [entries[0]], [entries[1]], [entries[2]]
    for d in range(n):
        a, b, k = n * node + d, n * enriched[node] + d, stiffness[node]
        rows += [a, b, a, b]
        columns += [a, b, b, a]
        values += [k, k, -k, -k]
    return np.concatenate(rows), np.concatenate(columns), np.concatenate(values)


class LimitedLaw(NewLaw):
    """That of springs which explicit steps limit, along the cells."""

    def __init__(self, stiffness, range_, lag, mid_cell):
        super().__init__([stiffness, range_, lag, 0.0, 0.0], True)
        self.mid_cell = mid_cell

    def ahead(self, c, z):
        return self.lag + self.mid_cell * np.maximum(0, 2 * np.minimum(z, 1 - z))


def solve(law, front, degrees, mode, nu=0.33, particles=2, cfl=0.0):
    """Equilibrium of the patch: displacements, stiffness with springs, and opening and spring of nodes with two fields."""
    t = np.array([np.cos(np.radians(degrees)), np.sin(np.radians(degrees))])
    edge, c = 2 * RADIUS + 1, max(abs(t))
    nodes = np.stack(np.meshgrid(np.arange(edge), np.arange(edge), indexing="ij"), -1).reshape(-1, 2) - RADIUS
    x, z = local(t, *(nodes - front).T)
    away = np.abs(z) / c
    split = law.opens(-x, c, away) & (np.abs(z) < BAND)
    side = np.where(z > -SIDE_TOLERANCE, 1, -1)
    entries, mass, enriched = assemble(front, t, split, side, nu, particles, mode)
    own, other = mass[: len(nodes)], np.where(split, mass[np.minimum(enriched, len(mass) - 1)], 0)
    joined = split & (own > 0) & (other > 0)
    # the largest stable in explicit steps, HoldingForce.hpp; there is none at rest
    most = own * other / np.maximum(own + other, 1e-30) / (max(cfl, 1e-9) ** 2 * (1 - nu**2))
    k = np.where(joined & (away < law.beyond), np.minimum(law.spring(-x, c, away, own, other), most), 0)
    n = parts(mode)
    rows, columns, values = add_springs(entries, k, enriched, n)
    size = n * len(mass)
    K = scipy.sparse.csr_matrix((values, (rows, columns)), (size, size)) + 1e-9 * scipy.sparse.identity(size)
    u, fixed = np.zeros(size), np.zeros(size, bool)
    rim = np.max(np.abs(nodes), 1) == RADIUS
    for at, sign, index in ((rim, side, np.arange(len(nodes))), (rim & split, -side, enriched)):
        i = np.nonzero(at)[0]
        a, b = displacement(x[i], z[i], mode, nu, np.where(np.abs(z[i]) < BAND, sign[i], 0))
        u[n * index[i]] = a if mode == HEAT else a * t[0] - b * t[1]
        fixed[n * index[i]] = True
        if mode != HEAT:
            u[2 * index[i] + 1], fixed[2 * index[i] + 1] = a * t[1] + b * t[0], True
    free = ~fixed
    u[free] = scipy.sparse.linalg.spsolve(K[free][:, free].tocsc(), -K[free][:, fixed] @ u[fixed])
    at = np.nonzero(joined & (away < 1))[0]
    across = n - 1
    opening = side[at] * (u[n * at + across] - u[n * enriched[at] + across])
    return u, K, {tuple(nodes[i]): (o, k[i]) for i, o in zip(at, opening)}


def lag(law, front, degrees, mode, nu=0.33, particles=2, cfl=0.0):
    """By how many cells the crack of the cells ends behind its front."""
    u, K, _ = solve(law, front, degrees, mode, nu, particles, cfl)
    t = np.array([np.cos(np.radians(degrees)), np.sin(np.radians(degrees))])
    return 0.5 * u @ (K @ u) - exact_energy(front, t, mode, nu) - (REMOTE_HEAT if mode == HEAT else REMOTE)


def opening(law, away, nu, particles):
    """Of a node of a crack along the cells at a distance from it: openings and forces while a front under K_I moves through the
    cell behind it, in units of K sqrt(h) / E' and K sqrt(h). A crack between two rows has a node in each: the forces of both."""
    found = []
    for behind in np.linspace(0.0, 0.7, 8):
        _, _, springs = solve(law, np.array([behind, away]), 0.0, 1, nu, particles, CFL)
        column = [(o, k * o) for (x, z), (o, k) in springs.items() if x == 0 and k > 0]
        found.append((behind, column[0][0], sum(force for _, force in column)))
    return found


def lags(law, degrees, mode, points, **more):
    return np.array([lag(law, p, degrees, mode, **more) for p in points])


def positions(number, seed):
    return scipy.stats.qmc.Sobol(2, seed=seed).random(number)


def print_openings(nu, particles):
    """The forces against the straight line through them: their slope, that of the constants, and the area below the line."""
    text = open(HEADER).read()
    law = LimitedLaw(*[float(v) for v in re.search(r"namespace limited\n.*?stiffness = ([0-9.]+), range = ([0-9.]+), lag = ([0-9.]+), "
                                                   r"lagMidCell = ([0-9.]+);", text, re.S).groups()])
    for away in (0.0, 0.25, 0.5):
        found = np.array(opening(law, away, nu, particles))
        slope, strength = np.polyfit(found[:, 1], found[:, 2], 1)
        print("crack %.2f cells from the node: front behind it, opening / (K sqrt(h) / E'), force / (K sqrt(h)), of the line" % away)
        for behind, o, force in found:
            print("  %5.2f  %.3f  %.3f  %.3f" % (behind, o, force, strength + slope * o))
        print("  slope %.3f (-%.3f of the constants), area below the line %.3f Gc h" % (slope, law.stiffness, -0.5 * strength**2 / slope))


def read_constants():
    text = open(HEADER).read()
    return [float(re.search(r"double %s = ([-0-9.e]+);" % n, text).group(1)) for n in NAMES]


def read_conductance():
    return float(re.search(r"double conductance = ([0-9.e]+);", open(HEADER).read()).group(1))


def write_constants(constants, conductance):
    text = open(HEADER).read()
    for name, value in list(zip(NAMES, constants)) + [("conductance", conductance)]:
        text = re.sub(r"(double %s = )[-0-9.e]+;" % name, lambda m: "%s%s;" % (m.group(1), float("%.3g" % value)), text, count=1)
    open(HEADER, "w").write(text)


def fit():
    points = positions(16, 3)

    def cost(x):
        if x[0] <= 0 or x[1] <= 0:
            return 1.0
        law, total = NewLaw(x), 0.0
        for degrees in ANGLES:
            for mode, weight in ((1, 1.0), (2, MODE_II)):
                total += weight * np.mean(lags(law, degrees, mode, points) ** 2)
        return np.sqrt(total / len(ANGLES))

    start = np.array([0.22, 1.0, 0.235, 0.3, 0.1])
    corners = [start] + [start + step for step in np.diag([0.03, 0.1, 0.05, 0.1, 0.3])]
    found = scipy.optimize.minimize(cost, start, method="Nelder-Mead",
                                    options={"maxfev": 120, "initial_simplex": corners})
    print("root of the weighted mean square of both modes: %.4f cells" % found.fun)
    return found.x


def fit_conductance(constants):
    """Nodes open where those constants say."""
    points = positions(16, 3)
    cost = lambda a: sum(np.mean(lags(NewLaw(constants, False, a), angle, HEAT, points) ** 2) for angle in ANGLES)
    return scipy.optimize.minimize_scalar(cost, bounds=(0.2, 1.2), method="bounded", options={"xatol": 0.005}).x


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--fit", action="store_true")
    options.add_argument("--before", action="store_true")
    options.add_argument("--heat", action="store_true")
    options.add_argument("--opening", action="store_true")
    options.add_argument("--moving", action="store_true", help="with the limits of explicit steps of coupled masses")
    options.add_argument("--positions", type=int, default=64, help="of the front in its cell")
    options.add_argument("--particles", type=int, default=2, help="of a cell along an axis")
    options.add_argument("--poisson", type=float, default=0.33)
    chosen = options.parse_args()
    if chosen.opening:
        print_openings(chosen.poisson, chosen.particles)
        return
    if chosen.fit:
        constants = fit()
        write_constants(constants, fit_conductance(constants))
    law = OldLaw() if chosen.before else NewLaw(read_constants(), chosen.moving, read_conductance() if chosen.heat else None)
    points = positions(chosen.positions, 11)  # others than those of the fit
    print("lag in cells: angle, %s" % ("mean, scatter, least, largest of heat" if chosen.heat else
                                       "mode I mean, scatter, least, largest; mode II the same"))
    for degrees in ANGLES + [10, 22, 37]:
        row = []
        for mode in (HEAT,) if chosen.heat else (1, 2):
            v = lags(law, degrees, mode, points, nu=chosen.poisson, particles=chosen.particles,
                     cfl=CFL if chosen.moving else 0.0)
            row += [v.mean(), v.std(), v.min(), v.max()]
        print("%5.1f  " % degrees + "  ".join("%+.3f" % v for v in row), flush=True)


if __name__ == "__main__":
    main()
