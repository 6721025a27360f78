#!/usr/bin/env python3
"""K_I and K_II along the rim of a crack in the shape of a spherical cap under pressure on its faces, by finite elements, apart from the program.

Rings of biquadratic elements in the meridian plane, in polar coordinates about the centre of the sphere, so that the cap is a line of nodes; they
shrink towards its rim. G is the change of strain energy with the angle of the cap, by central differences; the ratio of the modes is that of the
jumps of displacement behind the rim, extrapolated to it. An equal tension from all sides gives the same K. With "plane" the crack is an arc of a
circle in plane strain, whose closed form (Muskhelishvili 1953) checks the elements.

    xml_inputs/references/cap_crack.py [plane] [POISSON [ANGLE [SMALLEST ...]]]     angle from the middle to the rim in degrees, smallest element
                                                                in radii of the sphere; needs numpy and scipy

Prints K over (2 / pi) p sqrt(pi a), a the radius of the rim; for an arc over p sqrt(pi a).
"""
import math
import sys

import numpy as np
import scipy.sparse as sparse
import scipy.sparse.linalg as linalg

GROWTH, FAR = 1.3, 60.0  # of an element over the one before it; radius of the body in radii of the sphere
POINT = math.sqrt(0.6)
GAUSS = [(-POINT, 5 / 9), (0.0, 8 / 9), (POINT, 5 / 9)]


def graded(length, first, largest=None):
    """Positions from 0 to `length` with growing distances."""
    at, step = [0.0], first
    while at[-1] + step < length:
        at.append(at[-1] + step)
        step = min(step * GROWTH, largest or 1e9)
    if len(at) > 1 and length - at[-1] < 0.6 * (at[-1] - at[-2]):
        at.pop()
    return np.array(at + [length])


def with_middles(x):
    return np.sort(np.concatenate([x, 0.5 * (x[1:] + x[:-1])]))


def shape(s):
    return np.array([s * (s - 1) / 2, 1 - s * s, s * (s + 1) / 2]), np.array([s - 0.5, -2 * s, s + 0.5])


def solve(poisson, alpha, smallest, plane):
    """Strain energy (modulus 1, pressure 1, radius 1; plane: of half the body), and jumps behind the rim: distances, normal and tangential ones."""
    inner, outer = graded(1.0, smallest, 0.1), graded(FAR - 1.0, smallest)
    rho = with_middles(np.concatenate([1.0 - inner[::-1], 1.0 + outer[1:]]))
    near, away = graded(alpha, smallest, 0.1), graded(math.pi - alpha, smallest, 0.1)
    theta = with_middles(np.concatenate([alpha - near[::-1], alpha + away[1:]]))
    nr, nt = len(rho), len(theta)
    sphere, rim = int(np.argmin(abs(rho - 1))), int(np.argmin(abs(theta - alpha)))
    number = np.arange(nr * nt).reshape(nr, nt)
    upper = np.full(nt, -1)
    upper[:rim] = nr * nt + np.arange(rim)  # the nodes of the outer face
    total = nr * nt + rim
    R, Z = rho[:, None] * np.sin(theta), rho[:, None] * np.cos(theta)
    # Elements in blocks of nodes [element, 9]
    ids, rs, zs = [], [], []
    for i in range(0, nr - 2, 2):
        for j in range(0, nt - 2, 2):
            block = number[i:i + 3, j:j + 3].copy()
            if i == sphere:
                own = upper[j:j + 3]
                block[0] = np.where(own >= 0, own, block[0])
            ids.append(block.ravel())
            rs.append(R[i:i + 3, j:j + 3].ravel())
            zs.append(Z[i:i + 3, j:j + 3].ravel())
    ids, rs, zs = np.array(ids), np.array(rs), np.array(zs)
    lame, shear = poisson / ((1 + poisson) * (1 - 2 * poisson)), 0.5 / (1 + poisson)
    D = np.full((4, 4), 0.0)
    D[:3, :3] = lame
    D[:3, :3] += 2 * shear * np.eye(3)
    D[3, 3] = shear
    K = np.zeros((len(ids), 18, 18))
    for s, ws in GAUSS:
        for t, wt in GAUSS:
            (a, da), (b, db) = shape(s), shape(t)
            N, Ns, Nt = np.outer(a, b).ravel(), np.outer(da, b).ravel(), np.outer(a, db).ravel()
            J = np.stack([np.stack([rs @ Ns, zs @ Ns], -1), np.stack([rs @ Nt, zs @ Nt], -1)], 1)
            inverse = np.linalg.inv(J)
            grad = np.einsum("eij,jn->ein", inverse, np.stack([Ns, Nt]))
            r = rs @ N
            B = np.zeros((len(ids), 4, 18))
            B[:, 0, 0::2], B[:, 2, 1::2] = grad[:, 0], grad[:, 1]
            B[:, 1, 0::2] = 0 if plane else N / r[:, None]
            B[:, 3, 0::2], B[:, 3, 1::2] = grad[:, 1], grad[:, 0]
            weight = ws * wt * abs(np.linalg.det(J)) * (1 if plane else 2 * math.pi * r)
            K += np.einsum("e,eki,kl,elj->eij", weight, B, D, B, optimize=True)
    dofs = np.stack([2 * ids, 2 * ids + 1], -1).reshape(len(ids), 18)
    A = sparse.csr_matrix((K.ravel(), (np.repeat(dofs, 18, 1).ravel(), np.tile(dofs, (1, 18)).ravel())), (2 * total, 2 * total))
    f = np.zeros(2 * total)
    for j in range(0, rim, 2):
        for s, ws in GAUSS:
            N, dN = shape(s)
            at, slope = N @ theta[j:j + 3], dN @ theta[j:j + 3]
            area = ws * slope * (1 if plane else 2 * math.pi * math.sin(at))
            for k in range(3):
                low = number[sphere, j + k]
                high = upper[j + k] if upper[j + k] >= 0 else low
                for node, sign in ((low, -1), (high, 1)):
                    f[2 * node] += sign * N[k] * area * math.sin(at)
                    f[2 * node + 1] += sign * N[k] * area * math.cos(at)
    fixed = np.zeros(2 * total, bool)
    axis = np.concatenate([number[:, 0], number[:, -1], [upper[0]]])
    fixed[2 * axis] = True
    fixed[2 * number[0]] = True  # the centre, where all nodes are one point
    fixed[2 * number[-1, 0] + 1] = True  # a far point
    free = ~fixed
    # The nodes of the centre move together along the axis.
    tie = np.arange(2 * total)
    tie[2 * number[0] + 1] = 2 * number[0, 0] + 1
    keep = free & (tie == np.arange(2 * total))
    column = np.full(2 * total, -1)
    column[keep] = np.arange(keep.sum())
    rows = np.where(free & (column[tie] >= 0))[0]
    P = sparse.csr_matrix((np.ones(len(rows)), (rows, column[tie[rows]])), (2 * total, keep.sum()))
    u = P @ linalg.spsolve((P.T @ A @ P).tocsc(), P.T @ f)
    behind = np.arange(1, rim - 3)  # the elements at the rim have no singular functions
    low, high, at = number[sphere, behind], upper[behind], theta[behind]
    jump = np.stack([u[2 * high] - u[2 * low], u[2 * high + 1] - u[2 * low + 1]])
    normal = jump[0] * np.sin(at) + jump[1] * np.cos(at)
    tangent = jump[0] * np.cos(at) - jump[1] * np.sin(at)
    return 0.5 * f @ u, alpha - at, normal, tangent


def intensities(poisson, alpha, smallest, plane):
    step = 1e-3
    rate = (solve(poisson, alpha + step, smallest, plane)[0] - solve(poisson, alpha - step, smallest, plane)[0]) / (2 * step)
    release = rate / (1 if plane else 2 * math.pi * math.sin(alpha))
    _, distance, normal, tangent = solve(poisson, alpha, smallest, plane)
    use = (distance > 8 * smallest) & (distance < 0.3)
    ratio = np.polyfit(distance[use], tangent[use] / normal[use], 3)[-1]
    scale = (1 if plane else 2 / math.pi) * math.sqrt(math.pi * math.sin(alpha))
    mode1 = math.sqrt(release / (1 - poisson**2) / (1 + ratio**2))
    return mode1 / scale, ratio * mode1 / scale


def main():
    words = sys.argv[1:]
    plane = "plane" in words
    given = [float(word) for word in words if word != "plane"]
    poisson, degrees = (given + [0.3, 45.0][len(given):])[:2]
    alpha = math.radians(degrees)
    for smallest in given[2:] or [4e-3, 2e-3, 1e-3]:
        print("Poisson %g, %g degrees, smallest element %g: K_I %.4f, K_II %.4f" % (
            (poisson, degrees, smallest) + intensities(poisson, alpha, smallest, plane)), flush=True)
    if plane:
        factor = 1 / (1 + math.sin(alpha / 2)**2)
        print("closed form: K_I %.4f, K_II %.4f" % (factor * math.cos(alpha / 2), -factor * math.sin(alpha / 2)))


if __name__ == "__main__":
    main()
