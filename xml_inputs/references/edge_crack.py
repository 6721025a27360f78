#!/usr/bin/env python3
"""Static energy release rate of the edge crack of xml_inputs/examples/edge_crack.xml by finite elements, apart from the program.

The handbook's formula is for an endless strip, for displacements without bound on the rotation, and good to half a percent of K. Here the
strip has its length, and the deflection of its line of action counts, which a tension straightens: Saint Venant-Kirchhoff's law in plane
stress, solved by Newton's method. The upper half is divided into elements with biquadratic functions that shrink towards the tip. G is the
change of the potential energy with the length of the crack, by central differences with two steps, of which the error of the second order
is taken out.

    xml_inputs/references/edge_crack.py [STRESS [SMALLEST_ELEMENT ...]]        in Pa, m; needs numpy and scipy
"""
import sys

import numpy as np
import scipy.sparse as sparse
import scipy.sparse.linalg as linalg

E, NU, STRESS, WIDTH, HEIGHT, CRACK, HANDBOOK = 3e9, 0.35, 5e6, 0.04, 0.04, 0.01, 584.4
STIFFNESS = E / (1 - NU**2) * np.array([[1, NU, 0], [NU, 1, 0], [0, 0, (1 - NU) / 2]])  # plane stress
GROWTH = 1.25  # of an element over the one before it
POINT = np.sqrt(0.6)  # Gauss, three points
GAUSS = [(-POINT, 5 / 9), (0.0, 8 / 9), (POINT, 5 / 9)]


def graded(length, first):
    """Positions from 0 to `length` with growing distances."""
    at, step = [0.0], first
    while at[-1] + step < length:
        at.append(at[-1] + step)
        step *= GROWTH
    if length - at[-1] < 0.5 * step / GROWTH:
        at.pop()
    return np.array(at + [length])


def with_middles(at):
    both = np.empty(2 * len(at) - 1)
    both[::2], both[1::2] = at, 0.5 * (at[1:] + at[:-1])
    return both


def quadratic(s):
    """The three functions on -1 .. 1, and their slopes."""
    return np.array([s * (s - 1) / 2, 1 - s * s, s * (s + 1) / 2]), np.array([s - 0.5, -2 * s, s + 0.5])


class Strip:
    """The upper half with a crack of some length. It is pulled by a stress at its top, or by a force per thickness at its arm's end
    (shear that is parabolic over the arm), which makes it a double cantilever beam."""

    def __init__(self, crack, first, stress, width=WIDTH, height=HEIGHT, force=0.0):
        X = np.concatenate([crack - graded(crack, first)[::-1], crack + graded(width - crack, first)[1:]])
        Y = graded(height, first)
        x, columns = with_middles(X), 2 * len(Y) - 1
        i, j = (a.ravel() for a in np.meshgrid(np.arange(len(X) - 1), np.arange(len(Y) - 1), indexing="ij"))
        nodes = np.stack([(2 * i + p) * columns + 2 * j + q for p in range(3) for q in range(3)], axis=1)
        self.unknowns = np.stack([2 * nodes, 2 * nodes + 1], axis=2)  # element, node, axis
        self.width, self.height = np.diff(X)[i], np.diff(Y)[j]
        self.load = np.zeros(2 * len(x) * columns)
        for k in range(len(X) - 1):
            for p, part in enumerate((1 / 6, 4 / 6, 1 / 6)):
                self.load[2 * ((2 * k + p) * columns + columns - 1) + 1] += stress * (X[k + 1] - X[k]) * part
        y = with_middles(Y)
        for k in range(len(Y) - 1):
            for p, part in enumerate((1 / 6, 4 / 6, 1 / 6)):
                shape = 6 * y[2 * k + p] * (height - y[2 * k + p]) / height**3
                self.load[2 * (2 * k + p) + 1] += force * shape * (Y[k + 1] - Y[k]) * part
        held = [2 * k * columns + 1 for k in range(len(x)) if x[k] > crack - 1e-12] + [2 * (len(x) - 1) * columns]
        self.free = np.setdiff1d(np.arange(len(self.load)), held)

    def solve(self):
        """\\return the potential energy per thickness [J/m]"""
        u = np.zeros(len(self.load))
        for _ in range(12):
            energy, force, K = self.assemble(u)
            residual = (self.load - force)[self.free]
            if np.linalg.norm(residual) < 1e-6 * np.linalg.norm(self.load):  # the energy is off by its square
                return energy - self.load @ u
            u[self.free] += linalg.spsolve(K[self.free][:, self.free], residual)
        raise RuntimeError("Newton's method does not converge")

    def assemble(self, u):
        """\\return strain energy, nodal forces, tangent"""
        count, size = len(self.width), len(self.load)
        of = u[self.unknowns]
        K, force, energy = np.zeros((count, 9, 2, 9, 2)), np.zeros((count, 9, 2)), 0.0
        for s, one in GAUSS:
            for t, other in GAUSS:
                (f, df), (g, dg) = quadratic(s), quadratic(t)
                slope = np.stack([np.outer(2 / self.width, np.outer(df, g).ravel()),
                                  np.outer(2 / self.height, np.outer(f, dg).ravel())], axis=2)  # element, node, axis
                volume = self.width * self.height / 4 * one * other
                F = np.eye(2) + np.einsum("eni,enj->eij", of, slope)
                strain = 0.5 * (np.einsum("eki,ekj->eij", F, F) - np.eye(2))
                green = np.stack([strain[:, 0, 0], strain[:, 1, 1], 2 * strain[:, 0, 1]], axis=1)
                S = green @ STIFFNESS
                energy += 0.5 * np.sum(volume * np.einsum("ek,ek->e", S, green))
                # dE = B du, rows xx, yy, 2 xy
                B = np.empty((count, 3, 9, 2))
                B[:, 0] = slope[:, :, 0, None] * F[:, None, :, 0]
                B[:, 1] = slope[:, :, 1, None] * F[:, None, :, 1]
                B[:, 2] = slope[:, :, 0, None] * F[:, None, :, 1] + slope[:, :, 1, None] * F[:, None, :, 0]
                force += volume[:, None, None] * np.einsum("ek,ekni->eni", S, B)
                flat = B.reshape(count, 3, 18)
                K += (volume[:, None, None] * (flat.transpose(0, 2, 1) @ STIFFNESS @ flat)).reshape(K.shape)
                tensor = np.stack([S[:, 0], S[:, 2], S[:, 2], S[:, 1]], axis=1).reshape(-1, 2, 2)
                geometric = np.einsum("e,eni,eij,emj->enm", volume, slope, tensor, slope)
                for axis in range(2):
                    K[:, :, axis, :, axis] += geometric
        at = self.unknowns.reshape(count, 18)
        rows, cols = np.repeat(at, 18, axis=1), np.tile(at, (1, 18))
        whole = sparse.csc_matrix((K.ravel(), (rows.ravel(), cols.ravel())), (size, size))
        return energy, np.bincount(at.ravel(), force.ravel(), size), whole


def release(first, stress, crack=CRACK, **strip):
    """G of the whole strip, of which this is half [J/m2]."""
    slopes = [-2 * (Strip(crack + d, first, stress, **strip).solve() - Strip(crack - d, first, stress, **strip).solve()) / (2 * d)
              for d in (0.04 * crack, 0.02 * crack)]
    return (4 * slopes[1] - slopes[0]) / 3


if __name__ == "__main__":
    load = float(sys.argv[1]) if len(sys.argv) > 1 else STRESS
    linear = HANDBOOK * (load / STRESS)**2
    for smallest in [float(a) for a in sys.argv[2:]] or [4e-5, 1e-5, 2.5e-6]:
        G = release(smallest, load)
        print(f"{load:g} Pa, smallest element {smallest:g} m: G = {G:.6g} J/m2, {100 * (G / linear - 1):+.2f} % of the handbook's {linear:.6g}",
              flush=True)
