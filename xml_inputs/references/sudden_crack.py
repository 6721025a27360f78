#!/usr/bin/env python3
"""K_I(t) of a crack that appears suddenly in a plate under tension, by finite elements, apart from the program.

The plate is in equilibrium under a stress before; its change is that of a pressure of this size that starts to act on the faces of the crack
at t = 0. A quarter of the plate by symmetry, with equal bilinear elements, lumped mass and central differences (plane strain). K_I^2
is E' times the energy release rate by virtual crack closure (Rybicki and Kanninen, Eng. Fract. Mech. 9 (1977) 931): the force at the tip
times the opening of the next node. The error of the closure, of the order of an element, is that at rest, where Richardson's limit of two
meshes is known. Until waves of the other tip arrive (t = 2 a / c_d) the closed form of a half plane crack holds (Freund, Dynamic Fracture
Mechanics (Cambridge 1990), eq. 2.5.44).

    xml_inputs/references/sudden_crack.py [POISSON_RATIO [ELEMENTS ...]]        elements along half the crack; needs numpy and scipy
"""
import sys

import numpy as np
import scipy.sparse as sparse
import scipy.sparse.linalg as linalg

SIZE = 4.0  # of the quarter, in half lengths of the crack: waves return from its edges after 2 (SIZE - 1) a / c_d or later
UNTIL = 5.5  # [a / c_d]


def element_stiffness(nu):
    """Of a square element, with E' = E / (1 - nu^2) = 1; nodes (0,0), (1,0), (1,1), (0,1)."""
    law = np.array([[1 - nu, nu, 0], [nu, 1 - nu, 0], [0, 0, (1 - 2 * nu) / 2]]) * (1 - nu**2) / ((1 + nu) * (1 - 2 * nu))
    stiffness = np.zeros((8, 8))
    for s in (-1, 1):
        for t in (-1, 1):
            x, y = 0.5 + 0.5 * s / np.sqrt(3), 0.5 + 0.5 * t / np.sqrt(3)
            dx, dy = np.array([-(1 - y), 1 - y, y, -y]), np.array([-(1 - x), -x, x, 1 - x])
            b = np.zeros((3, 8))
            b[0, ::2], b[1, 1::2], b[2, ::2], b[2, 1::2] = dx, dy, dy, dx
            stiffness += 0.25 * b.T @ law @ b
    return stiffness, law[0, 0]


class Quarter:
    """Elements of unit size, density 1 and E' = 1; the crack is 0 <= x < `crack` on y = 0, under a unit pressure."""

    def __init__(self, nu, crack):
        self.crack, self.columns = crack, int(SIZE * crack) + 1
        n = self.columns - 1
        self.stiffness, modulus = element_stiffness(nu)
        self.speed = np.sqrt(modulus)  # of dilatational waves
        i, j = (a.ravel() for a in np.meshgrid(np.arange(n), np.arange(n), indexing="ij"))
        nodes = np.stack([i * (n + 1) + j, (i + 1) * (n + 1) + j, (i + 1) * (n + 1) + j + 1, i * (n + 1) + j + 1], axis=1)
        unknowns = np.stack([2 * nodes, 2 * nodes + 1], axis=2).reshape(len(nodes), 8)
        count = 2 * (n + 1)**2
        rows, cols = np.repeat(unknowns, 8, axis=1).ravel(), np.tile(unknowns, (1, 8)).ravel()
        self.matrix = sparse.csr_matrix((np.tile(self.stiffness.ravel(), len(nodes)), (rows, cols)), shape=(count, count))
        self.mass = np.bincount(unknowns.ravel(), minlength=count) / 4.0
        node = np.arange((n + 1)**2)
        x, y = node // (n + 1), node % (n + 1)
        self.held = np.zeros(count, dtype=bool)
        self.held[2 * node[x == 0]] = True  # u_x = 0
        self.held[2 * node[(y == 0) & (x >= crack)] + 1] = True  # u_y = 0 ahead of the tip
        self.load = np.zeros(count)
        pressed = node[(y == 0) & (x <= crack)]
        self.load[2 * pressed + 1] = np.where((x[pressed] == 0) | (x[pressed] == crack), 0.5, 1.0)
        self.tip, self.behind = 2 * (crack * (n + 1)) + 1, 2 * ((crack - 1) * (n + 1)) + 1

    def release(self, u):
        """Energy release rate: half of the force on the tip's node times the opening of both faces behind it. The force is that of the
        plate whose faces are free: that of the pressure, and the unit stress before."""
        return abs((float((self.matrix[self.tip] @ u)[0]) - 1.0) * u[self.behind])

    def at_rest(self):
        free = np.flatnonzero(~self.held)
        u = np.zeros(len(self.load))
        u[free] = linalg.spsolve(self.matrix[free][:, free].tocsc(), self.load[free])
        return np.sqrt(self.release(u))

    def in_motion(self):
        """(c_d t / a, K)"""
        step = 0.5 / self.speed
        u, v = np.zeros(len(self.load)), np.zeros(len(self.load))
        times, found = [], []
        for k in range(1, int(UNTIL * self.crack / self.speed / step) + 1):
            force = self.load - self.matrix @ u
            force[self.held] = 0.0
            v += step * (0.5 if k == 1 else 1.0) * force / self.mass
            u += step * v
            times.append(k * step * self.speed / self.crack)
            found.append(np.sqrt(self.release(u)))
        return np.array(times), np.array(found)


def curves(nu, meshes):
    """(c_d t / a, [K / (stress sqrt(pi a)) of each mesh], the same at rest without the error of the meshes)"""
    times = np.linspace(0.05, UNTIL - 0.05, 541)
    quarters = [Quarter(nu, crack) for crack in meshes]
    rest = [one.at_rest() / np.sqrt(np.pi * one.crack) for one in quarters]
    limit = rest[-1] + (rest[-1] - rest[-2]) / (meshes[-1] / meshes[-2] - 1.0)
    found = []
    for one, static in zip(quarters, rest):
        t, k = one.in_motion()
        found.append(np.interp(times, t, k) / np.sqrt(np.pi * one.crack) * limit / static)
    return times, found, limit


def main():
    nu = float(sys.argv[1]) if len(sys.argv) > 1 else 0.22
    meshes = [int(n) for n in sys.argv[2:]] or [32, 64]
    times, found, rest = curves(nu, meshes)
    early = 2.0 * np.sqrt(times * (1 - 2 * nu)) / (1 - nu) / np.pi
    print(f"K_I / (stress sqrt(pi a)); at rest {rest:.4f}")
    print("c_d t / a   closed form   " + "   ".join(f"{n} elements" for n in meshes))
    for t in (0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0, 4.5, 5.0):
        k = int(np.argmin(abs(times - t)))
        closed = f"{early[k]:.4f}" if t <= 2.0 else "      "
        print(f"{t:.2f}         {closed}        " + "       ".join(f"{one[k]:.4f}" for one in found))
    for n, one in zip(meshes, found):
        k = int(np.argmax(one))
        print(f"largest, {n} elements: {one[k]:.4f} at {times[k]:.2f} a / c_d")


if __name__ == "__main__":
    main()
