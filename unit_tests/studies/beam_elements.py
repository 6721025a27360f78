"""G of the double cantilever beam of xml_inputs/verification/dcb_static.xml by plain finite elements: what a solver made for statics needs.

One arm between the plane of the crack and its upper surface, biquadratic elements that shrink towards the front, plane stress, a direct
solution. G is the change of the work of the load with the crack length, by the central difference of two solutions. Needs numpy and scipy.
"""
import math

import numpy as np
import scipy.sparse as sparse
import scipy.sparse.linalg as linalg

MODULUS, POISSON, ARM, LENGTH, CRACK, FORCE = 3e9, 0.33, 0.01, 0.1, 0.05, 100.0
STIFFNESS = MODULUS / (1 - POISSON**2) * np.array([[1, POISSON, 0], [POISSON, 1, 0], [0, 0, (1 - POISSON) / 2]])
GROWTH = 1.5  # of an element over the one next to it
POINT = math.sqrt(0.6)
GAUSS = [(-POINT, 5 / 9), (0.0, 8 / 9), (POINT, 5 / 9)]


def graded(length, first, largest):
    """Positions from 0 to `length`; distances grow from about `first` to `largest`."""
    steps = [first]
    while sum(steps) < length:
        steps.append(min(steps[-1] * GROWTH, largest))
    return np.concatenate([[0.0], np.cumsum(steps)]) * length / sum(steps)


def with_middles(x):
    return np.sort(np.concatenate([x, 0.5 * (x[1:] + x[:-1])]))


def shape(s):
    return np.array([s * (s - 1) / 2, 1 - s * s, s * (s + 1) / 2]), np.array([s - 0.5, -2 * s, s + 0.5])


def stiffness_of(dx, dy):
    """Stiffness of rectangles with edges dx and dy, shape (elements, 18, 18); nodes column by column."""
    found = np.zeros((len(dx), 18, 18))
    for s, ws in GAUSS:
        for t, wt in GAUSS:
            (a, da), (b, db) = shape(s), shape(t)
            gx, gy = np.outer(da, b).ravel() * 2 / dx[:, None], np.outer(a, db).ravel() * 2 / dy[:, None]
            B = np.zeros((len(dx), 3, 18))
            B[:, 0, 0::2], B[:, 1, 1::2], B[:, 2, 0::2], B[:, 2, 1::2] = gx, gy, gy, gx
            found += (ws * wt / 4 * dx * dy)[:, None, None] * (B.transpose(0, 2, 1) @ STIFFNESS @ B)
    return found


def displacement(crack, largest, smallest):
    """Of the load at the end of the arm [m], and the number of unknowns."""
    x = np.concatenate([crack - graded(crack, smallest, largest)[::-1], crack + graded(LENGTH - crack, smallest, largest)[1:]])
    y = graded(ARM, smallest, largest)
    columns, rows = 2 * len(x) - 1, 2 * len(y) - 1
    number = np.arange(columns * rows).reshape(columns, rows)
    i, j = np.meshgrid(2 * np.arange(len(x) - 1), 2 * np.arange(len(y) - 1), indexing="ij")
    nodes = np.stack([number[i.ravel() + a, j.ravel() + b] for a in range(3) for b in range(3)], 1)
    dofs = np.stack([2 * nodes, 2 * nodes + 1], -1).reshape(len(nodes), 18)
    blocks = stiffness_of(np.diff(x)[i.ravel() // 2], np.diff(y)[j.ravel() // 2])
    count = 2 * columns * rows
    matrix = sparse.csc_matrix((blocks.ravel(), (np.repeat(dofs, 18, 1).ravel(), np.tile(dofs, (1, 18)).ravel())), (count, count))
    load = np.zeros(count)
    for k in range(len(y) - 1):  # a parabola of shear stress, as in the scene
        for t, weight in GAUSS:
            at = y[k] + (t + 1) / 2 * (y[k + 1] - y[k])
            stress = 1.5 * FORCE / ARM * (1 - (2 * at / ARM - 1)**2)
            load[2 * number[0, 2 * k:2 * k + 3] + 1] += weight / 2 * (y[k + 1] - y[k]) * stress * shape(t)[0]
    free = np.ones(count, bool)
    free[2 * number[with_middles(x) > crack - 1e-9, 0] + 1] = False  # the plane of symmetry ahead of the front
    free[2 * number[-1, 0]] = False
    free = np.where(free)[0]
    moved = linalg.spsolve(matrix[free][:, free], load[free])
    return moved @ load[free] / FORCE, len(free)


def release(largest, smallest):
    """G [J/m2] and the unknowns of one of its two solutions."""
    (less, _), (more, count) = (displacement(CRACK + step, largest, smallest) for step in (-1e-4, 1e-4))
    return FORCE * (more - less) / 2e-4, count
