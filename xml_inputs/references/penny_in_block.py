#!/usr/bin/env python3
"""A penny crack under pressure in the middle of a block, by finite elements, apart from the program.

An eighth of the square between its diagonal and an axis, half of the height, in elements of second order (27 nodes)
whose edges fall to 1e-4 of the radius at the front. From the volume V = C p at three radii come, over those of the
infinite body (Sneddon, Proc. R. Soc. A 187 (1946) 229), V, K of G = p^2 / 2 dC/dA, and the radius to which the gas of
given m R T = p V = 2 Gc C / (dC/dA) drives the crack.

    xml_inputs/references/penny_in_block.py RADIUS HALF_WIDTH HALF_HEIGHT [RADIUS ...]      (needs numpy and scipy)
"""
import sys

import numpy as np
import scipy.sparse as sparse
import scipy.sparse.linalg as linalg

E, NU = 3e9, 0.3
LAME, SHEAR = E * NU / ((1 + NU) * (1 - 2 * NU)), E / (2 * (1 + NU))
SMALLEST = 1e-4  # of the edges of elements over the largest
GAUSS, WEIGHT = np.array([-np.sqrt(0.6), 0, np.sqrt(0.6)]), np.array([5, 8, 5]) / 9


def graded(count, towards_end):
    """Ends of intervals on 0 to 1 whose lengths go down in a geometric row."""
    ends = np.concatenate([[0], np.cumsum(SMALLEST ** (np.arange(count) / (count - 1)))])
    ends /= ends[-1]
    return ends if towards_end else 1 - ends[::-1]


def with_middles(ends):
    return np.sort(np.concatenate([ends, (ends[1:] + ends[:-1]) / 2]))


def hat(x):
    return np.array([x * (x - 1) / 2, 1 - x * x, x * (x + 1) / 2])


def slope(x):
    return np.array([x - 0.5, -2 * x, x + 0.5])


def volume(radius, half_width, half_height, around=3, out=12, up=14):
    """Volume of the crack under unit pressure [m3/Pa]; elements around an eighth of it, inside as outside of it, up."""
    s = with_middles(np.concatenate([graded(out, True)[:-1], 1 + graded(out, False)]))  # front at 1
    angle, z = with_middles(np.linspace(0, np.pi / 4, around + 1)), with_middles(graded(up, False)) * half_height
    s, angle, z = np.meshgrid(s, angle, z, indexing="ij")
    r = np.where(s <= 1, s * radius, radius + (s - 1) * (half_width / np.cos(angle) - radius))
    place = np.stack([r * np.cos(angle), r * np.sin(angle), z], -1).reshape(-1, 3)
    own = np.arange(s.size).reshape(s.shape)
    node = own.copy()
    node[0] = own[0, :1]  # on the axis
    corners = [
        (slice(i, i + 3), slice(j, j + 3), slice(k, k + 3))
        for i in range(0, s.shape[0] - 1, 2)
        for j in range(0, s.shape[1] - 1, 2)
        for k in range(0, s.shape[2] - 1, 2)
    ]
    nodes = np.array([node[c].ravel() for c in corners])
    places = place[np.array([own[c].ravel() for c in corners])]
    law = np.diag([2 * SHEAR] * 3 + [SHEAR] * 3)
    law[:3, :3] += LAME
    stiffness = np.zeros((len(nodes), 81, 81))
    for a, wa in zip(GAUSS, WEIGHT):
        for b, wb in zip(GAUSS, WEIGHT):
            for c, wc in zip(GAUSS, WEIGHT):
                factors = [(slope(a), hat(b), hat(c)), (hat(a), slope(b), hat(c)), (hat(a), hat(b), slope(c))]
                slopes = np.array([np.einsum("i,j,k->ijk", *f).ravel() for f in factors])
                jacobian = np.einsum("an,enx->eax", slopes, places)
                g = np.einsum("exa,an->exn", np.linalg.inv(jacobian), slopes)
                strain = np.zeros((len(nodes), 6, 81))
                for row, (i, j) in enumerate([(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2)]):
                    strain[:, row, i::3] = g[:, j]
                    strain[:, row, j::3] = g[:, i]
                size = abs(np.linalg.det(jacobian)) * wa * wb * wc
                stiffness += np.einsum("e,eia,ij,ejb->eab", size, strain, law, strain, optimize=True)
    freedom = (3 * nodes[:, :, None] + np.arange(3)).reshape(len(nodes), 81)
    rows, columns = np.repeat(freedom, 81, 1).ravel(), np.tile(freedom, (1, 81)).ravel()
    total = 3 * s.size
    matrix = sparse.coo_matrix((stiffness.ravel(), (rows, columns)), (total, total))

    force = np.zeros(total)
    for i in range(0, 2 * out, 2):
        for j in range(0, s.shape[1] - 1, 2):
            flat = (slice(i, i + 3), slice(j, j + 3), 0)
            here, at = node[flat].ravel(), place[own[flat].ravel()][:, :2]
            for a, wa in zip(GAUSS, WEIGHT):
                for b, wb in zip(GAUSS, WEIGHT):
                    slopes = np.array([np.outer(slope(a), hat(b)).ravel(), np.outer(hat(a), slope(b)).ravel()])
                    size = abs(np.linalg.det(slopes @ at)) * wa * wb
                    np.add.at(force, 3 * here + 2, np.outer(hat(a), hat(b)).ravel() * size)

    diagonal = node[1:, -1, :].ravel()  # held across it by stiff springs
    across, springs = np.array([1, -1, 0]) / np.sqrt(2), 10 * E
    for i in range(2):
        for j in range(2):
            values = np.full(len(diagonal), springs * across[i] * across[j])
            matrix = matrix + sparse.coo_matrix((values, (3 * diagonal + i, 3 * diagonal + j)), matrix.shape)
    held = [3 * node[2 * out :, :, 0].ravel() + 2, 3 * node[:, 0, :].ravel() + 1, 3 * node[0, 0, :].ravel()]
    free = np.setdiff1d(np.unique(freedom), np.concatenate(held))
    matrix = matrix.tocsr()[free][:, free].tocsc()
    return 16 * force[free] @ linalg.spsolve(matrix, force[free])  # eight sectors, two faces


def main():
    half_width, half_height = float(sys.argv[2]), float(sys.argv[3])
    for radius in [float(sys.argv[1])] + [float(x) for x in sys.argv[4:]]:
        step = 0.01 * radius
        less, here, more = (volume(a, half_width, half_height) for a in (radius - step, radius, radius + step))
        slope_of_volume = (more - less) / (np.pi * ((radius + step) ** 2 - (radius - step) ** 2))
        v = here / (16 * (1 - NU**2) * radius**3 / (3 * E))
        k = np.sqrt(slope_of_volume / 2 * E / (1 - NU**2)) / (2 * np.sqrt(radius / np.pi))
        print(f"a = {radius:g}: V x {v:.4f}, K x {k:.4f}, radius at given m R T x {k / np.sqrt(v):.4f}", flush=True)


if __name__ == "__main__":
    main()
