#!/usr/bin/env python3
"""Split beams with a cohesive interface by plain finite elements and by beam theory: references for
xml_inputs/verification/cohesive_*_static.xml.

    cohesive_beams.py [dcb] [enf] [mmb] [--size 0.5e-3] [--steps 60] [--csv FILE]

Two arms of biquadratic elements, plane strain, small strain; between them a bilinear law with one damage variable (Camanho and Davila,
NASA TM-2002-211737; mixed mode by Benzeggagh and Kenane), integrated at three Gauss points of each edge. Columns of nodes move as grips do.
Newton's method with the tangent of the law, displacement control. Nothing here is shared with the program. Needs numpy and scipy.

dcb: ends of both arms are moved apart. G = (w P)^2 / (E' I) with w = a + chi h; of it and of the opening of the ends 2 P w^3 / (3 E' I) the
effective length w can be eliminated, so that P^2 opening is known while the crack grows, whatever the process zone does.
enf: three-point bending of the cracked beam; mmb: its upper arm is lifted at the end as well.
"""
import argparse
import csv
import math
import sys

import numpy as np
import scipy.sparse as sparse
import scipy.sparse.linalg as linalg

# The beam of the scenes [m, Pa, J/m2].
MODULUS, POISSON = 70e9, 0.3
LENGTH, ARM, CRACK = 0.1, 4e-3, 0.04
GI, GII, TENSION, SHEAR, STIFFNESS, EXPONENT = 300.0, 900.0, 20e6, 40e6, 2e14, 2.0
LEFT, RIGHT = 5e-3, 0.095  # supports of the bent beams; loads act midway
PLANE = MODULUS / (1 + POISSON) / (1 - 2 * POISSON) * np.array(
    [[1 - POISSON, POISSON, 0], [POISSON, 1 - POISSON, 0], [0, 0, 0.5 - POISSON]])
EFFECTIVE = MODULUS / (1 - POISSON**2)
GAUSS = [(-math.sqrt(0.6), 5 / 9), (0.0, 8 / 9), (math.sqrt(0.6), 5 / 9)]


def shape(s):
    return np.array([s * (s - 1) / 2, 1 - s * s, s * (s + 1) / 2]), np.array([s - 0.5, -2 * s, s + 0.5])


class Law:
    """Tractions and tangent of the bilinear law at many points; `secant` is 1 - d."""

    def __init__(self):
        self.normal = STIFFNESS
        self.ratio = (SHEAR / TENSION) ** 2 * GI / GII  # of the stiffness in shear
        self.start = [TENSION**2 / 2 / STIFFNESS, SHEAR**2 / 2 / (self.ratio * STIFFNESS)]

    def __call__(self, gap, slip, secant, bonded):
        g = np.maximum(gap, 0.0)
        square = g**2 + self.ratio * slip**2
        size = np.sqrt(square)
        mode = np.where(square > 0, self.ratio * slip**2 / np.where(square > 0, square, 1), 0.0)
        mix, by = mode**EXPONENT, EXPONENT * mode ** (EXPONENT - 1)
        energy, start = GI + (GII - GI) * mix, self.start[0] + (self.start[1] - self.start[0]) * mix
        first, end = np.sqrt(2 * start / self.normal), 0
        end = 2 * energy / (self.normal * first)
        safe = np.maximum(size, 1e-30)
        loaded = np.where(size <= first, 1.0, np.maximum(0.0, first * (end - size) / (safe * (end - first))))
        grows = bonded & (loaded < secant)
        now = np.where(grows, loaded, secant)
        hold = now * bonded
        tension = np.where(gap > 0, hold * self.normal * gap, self.normal * gap)
        shear = hold * self.ratio * self.normal * slip
        tangent = np.zeros((len(gap), 2, 2))
        tangent[:, 0, 0] = np.where(gap < 0, self.normal, hold * self.normal)
        tangent[:, 1, 1] = hold * self.ratio * self.normal
        falls = grows & (size < end)
        dfirst = (self.start[1] - self.start[0]) * by / (self.normal * first)
        dend = 2 * ((GII - GI) * by - energy * dfirst / first) / (self.normal * first)
        length = end - first
        bysize = -first * end / (length * safe**2)
        bymode = (dfirst * (end - size) + first * dend - first * (end - size) * (dend - dfirst) / length) / (length * safe)
        for j, (at, ratio, turn) in enumerate(((g, 1.0, -mode), (slip, self.ratio, 1 - mode))):
            part = ratio * at / safe
            change = np.where(falls, bysize * part + bymode * 2 * part / safe * turn, 0.0)
            tangent[:, 0, j] += self.normal * g * change
            tangent[:, 1, j] += self.ratio * self.normal * slip * change
        return tension, shear, now, tangent


class Beam:
    """Both arms; nodes of an arm are column by column from its lower side."""

    def __init__(self, size):
        self.columns = 2 * round(LENGTH / size) + 1
        self.rows = 2 * max(2, round(ARM / (2 * size))) + 1
        self.x = np.linspace(0, LENGTH, self.columns)
        self.arm = self.columns * self.rows
        self.count = 4 * self.arm
        i, j = np.meshgrid(np.arange((self.columns - 1) // 2), np.arange((self.rows - 1) // 2), indexing="ij")
        number = np.arange(self.arm).reshape(self.columns, self.rows)
        nodes = np.stack([number[2 * i.ravel() + a, 2 * j.ravel() + b] for a in range(3) for b in range(3)], 1)
        block = self.block(LENGTH / (self.columns - 1) * 2, ARM / (self.rows - 1) * 2)
        rows, columns, values = [], [], []
        for arm in range(2):
            dofs = np.stack([2 * (nodes + arm * self.arm), 2 * (nodes + arm * self.arm) + 1], -1).reshape(len(nodes), 18)
            rows.append(np.repeat(dofs, 18, 1).ravel())
            columns.append(np.tile(dofs, (1, 18)).ravel())
            values.append(np.tile(block.ravel(), len(nodes)))
        self.bulk = sparse.csr_matrix((np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))), (self.count, self.count))
        # Points of the interface: lower arm 0, upper arm 1.
        points, faces = [], []
        edge = LENGTH / (self.columns - 1) * 2
        for e in range((self.columns - 1) // 2):
            for s, w in GAUSS:
                points.append((self.x[2 * e] + edge * (s + 1) / 2, w * edge / 2))
                faces.append((shape(s)[0], [2 * e + a for a in range(3)]))
        self.at, self.area = np.array(points).T
        entries = [], [], []
        for k, (weights, columns_of) in enumerate(faces):
            for weight, column in zip(weights, columns_of):
                for node, sign in ((self.node(0, column, self.rows - 1), -1), (self.node(1, column, 0), 1)):
                    for d in range(2):  # rows: gap, then slip of each point
                        entries[0].append(2 * k + (1 - d))
                        entries[1].append(2 * node + d)
                        entries[2].append(sign * weight)
        self.jump = sparse.csr_matrix((entries[2], (entries[0], entries[1])), (2 * len(points), self.count))

    @staticmethod
    def block(dx, dy):
        found = np.zeros((18, 18))
        for s, ws in GAUSS:
            for t, wt in GAUSS:
                (a, da), (b, db) = shape(s), shape(t)
                gx, gy = np.outer(da, b).ravel() * 2 / dx, np.outer(a, db).ravel() * 2 / dy
                B = np.zeros((3, 18))
                B[0, 0::2], B[1, 1::2], B[2, 0::2], B[2, 1::2] = gx, gy, gy, gx
                found += ws * wt / 4 * dx * dy * B.T @ PLANE @ B
        return found

    def node(self, arm, column, row):
        return arm * self.arm + column * self.rows + row

    def grip(self, arm, x):
        """Vertical unknowns of the column of nodes at x of an arm."""
        column = int(np.argmin(abs(self.x - x)))
        return [2 * self.node(arm, column, r) + 1 for r in range(self.rows)]


def solve(beam, grips, largest, steps, tolerance=1e-9):
    """Rows (factor of the displacements, force of each grip, energy dissipated, failed to, work of the grips). \\param grips (unknowns, displacement at 1)"""
    law = Law()
    bonded = beam.at > CRACK
    secant, u = np.ones(len(beam.at)), np.zeros(beam.count)
    held = np.concatenate([dofs for dofs, _ in grips] + [[2 * beam.node(0, beam.columns - 1, 0)]])
    free = np.setdiff1d(np.arange(beam.count), held)
    rows, factor, step = [], 0.0, largest / steps
    work, before = 0.0, np.zeros(beam.count)
    while factor < largest * (1 - 1e-9):
        target = min(factor + step, largest)
        trial = u.copy()
        for dofs, displacement in grips:
            trial[dofs] = target * displacement
        move = (trial - u)[held]
        trial = u.copy()
        for iteration in range(25):
            jump = (beam.jump @ trial).reshape(-1, 2)
            tension, shear, now, tangent = law(jump[:, 0], jump[:, 1], secant, bonded)
            tractions = np.stack([tension * beam.area, shear * beam.area], 1).ravel()
            force = beam.bulk @ trial + beam.jump.T @ tractions
            if iteration > 0 and np.abs(force[free]).max() < tolerance * np.abs(force).max():
                break
            blocks = sparse.block_diag([t * a for t, a in zip(tangent, beam.area)], format="csr")
            matrix = sparse.csr_matrix(beam.bulk + beam.jump.T @ blocks @ beam.jump)[free]
            trial[free] += linalg.splu(sparse.csc_matrix(matrix[:, free])).solve(-force[free] - matrix[:, held] @ move)
            trial[held] += move
            move = 0.0 * move
        else:
            step /= 2
            if step < largest / steps / 4096:
                print("no equilibrium at a factor of", factor, file=sys.stderr)
                break
            continue
        work += 0.5 * (force + before) @ (trial - u)
        u, secant, factor, before = trial, now, target, force
        stored = 0.5 * u @ (beam.bulk @ u) + 0.5 * np.sum(tractions.reshape(-1, 2) * jump)
        failed = beam.at[bonded & (secant <= 1e-3)]
        rows.append([factor] + [float(force[dofs].sum()) for dofs, _ in grips] + [work - stored, failed.max() if len(failed) else CRACK, work])
        step = min(step * (2 if iteration < 8 else 1), largest / steps)
    return rows


def dcb(size, steps, opening=1.6e-3):
    """Columns: opening, force, dissipated, failed to; and the force of beam theory as the crack grows."""
    beam = Beam(size)
    rows = solve(beam, [(beam.grip(1, 0.0), 0.5), (beam.grip(0, 0.0), -0.5), (beam.grip(1, LENGTH), 0.0), (beam.grip(0, LENGTH), 0.0)], opening, steps)
    inertia = ARM**3 / 12
    theory = lambda d: math.sqrt(2 / 3 * GI**1.5 * math.sqrt(EFFECTIVE * inertia) / d)
    return ["opening", "force", "dissipated", "failed_to", "work", "beam_theory"], [[r[0], r[1], *r[5:], theory(r[0])] for r in rows]


def enf(size, steps, deflection=2.0e-3):
    beam = Beam(size)
    middle = 0.5 * (LEFT + RIGHT)
    grips = [(beam.grip(1, middle), -1.0), (beam.grip(0, LEFT), 0.0), (beam.grip(0, RIGHT), 0.0)]
    rows = solve(beam, grips, deflection, steps)
    return ["deflection", "force", "dissipated", "failed_to", "work"], [[r[0], -r[1], *r[4:]] for r in rows]


def mmb(size, steps, deflection=0.8e-3):
    """The upper arm is lifted at the left support by twice as much as its middle is pressed down."""
    beam = Beam(size)
    middle = 0.5 * (LEFT + RIGHT)
    grips = [(beam.grip(1, middle), -1.0), (beam.grip(1, LEFT), 2.0), (beam.grip(0, LEFT), 0.0), (beam.grip(0, RIGHT), 0.0)]
    rows = solve(beam, grips, deflection, steps)
    return ["deflection", "force", "lift", "dissipated", "failed_to", "work"], [[r[0], -r[1], r[2], *r[5:]] for r in rows]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("tests", nargs="*")
    parser.add_argument("--size", type=float, default=1e-3)
    parser.add_argument("--steps", type=int, default=60)
    parser.add_argument("--csv")
    options = parser.parse_args()
    for name in options.tests or ["dcb", "enf", "mmb"]:
        names, rows = {"dcb": dcb, "enf": enf, "mmb": mmb}[name](options.size, options.steps)
        out = csv.writer(open(options.csv.replace("NAME", name), "w") if options.csv else sys.stdout)
        out.writerow(names)
        out.writerows([[f"{v:.6g}" for v in row] for row in rows])


if __name__ == "__main__":
    main()
