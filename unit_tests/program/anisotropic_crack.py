"""Closed forms of cracks in orthotropic bodies in 2D, by Stroh's formalism.

The program has them by Lekhnitskii's complex parameters and the compliance; here they follow from the stiffness
and an eigenvalue problem (Ting, Anisotropic Elasticity, chapters 5 and 11), so that one checks the other.

    python3 unit_tests/program/anisotropic_crack.py      prints the references of xml_inputs/verification
"""

import itertools
import math

import numpy

PAIRS = [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2)]


def own_stiffness(young, poisson, shear):
    """C_ijkl [Pa] along the material's axes; Poisson's ratios 12, 23, 13 and shear moduli alike."""
    compliance = numpy.diag([1 / y for y in young] + [1 / g for g in shear]).astype(float)
    for (i, j), nu in zip([(0, 1), (1, 2), (0, 2)], poisson):
        compliance[i, j] = compliance[j, i] = -nu / young[i]
    matrix = numpy.linalg.inv(compliance)
    C = numpy.zeros((3, 3, 3, 3))
    for (I, (i, j)), (K, (k, l)) in itertools.product(enumerate(PAIRS), repeat=2):
        for a, b in {(i, j), (j, i)}:
            for c, d in {(k, l), (l, k)}:
                C[a, b, c, d] = matrix[I, K]
    return C


def turned(C, angle):
    """Of axes that are turned by an angle [rad] about z."""
    c, s = math.cos(angle), math.sin(angle)
    R = numpy.array([[c, -s, 0], [s, c, 0], [0, 0, 1.0]])  # columns: the material's axes in the body
    return numpy.einsum("ia,jb,kc,ld,abcd->ijkl", R, R, R, R, C)


def in_plane(C, plane_stress):
    """The 2 x 2 x 2 x 2 part; in plane stress with s_zz = 0."""
    Q = C[:2, :2, :2, :2].copy()
    if plane_stress:
        Q -= numpy.einsum("ij,kl->ijkl", C[:2, :2, 2, 2], C[2, 2, :2, :2]) / C[2, 2, 2, 2]
    return Q


def release_matrix(Q):
    """H of J = k.H k with k = (K_I, K_II) of a crack along x: half of the inverse of L = -2 i B B^T."""
    A, R, T = Q[:, 0, :, 0], Q[:, 0, :, 1], Q[:, 1, :, 1]
    inverse = numpy.linalg.inv(T)
    N = numpy.block([[-inverse @ R.T, inverse], [R @ inverse @ R.T - A, -R @ inverse]])
    values, vectors = numpy.linalg.eig(N)
    upper = [k for k in range(4) if values[k].imag > 0]
    # 2 a.b = 1 of each
    columns = [vectors[:, k] / numpy.sqrt(2 * vectors[:2, k] @ vectors[2:, k]) for k in upper]
    B = numpy.array([v[2:] for v in columns]).T
    L = (-2j * B @ B.T).real
    half = 0.5 * numpy.linalg.inv(L)  # rows along the crack and across it
    return half[::-1, ::-1]


def central_crack(young, poisson, shear, fibres, crack, half_length, stress, plane_stress):
    """(K_I, K_II, G) of a crack in a large plate under a uniform stress along y; angles from x [rad]."""
    Q = in_plane(turned(own_stiffness(young, poisson, shear), fibres - crack), plane_stress)
    K = numpy.array([math.cos(crack) ** 2, math.sin(crack) * math.cos(crack)]) * stress * math.sqrt(math.pi * half_length)
    return K[0], K[1], K @ release_matrix(Q) @ K


CARBON = dict(young=(140e9, 10e9, 10e9), poisson=(0.3, 0.4, 0.3), shear=(5e9, 3.5e9, 5e9))

if __name__ == "__main__":
    for degrees in (0, 30, 60, 90):
        K1, K2, G = central_crack(**CARBON, fibres=math.radians(degrees), crack=0.0, half_length=0.01, stress=1e6, plane_stress=False)
        print(f"fibres at {degrees:2d} degrees: K_I = {K1:.6g} Pa m^0.5, K_II = {K2:.3g}, G = {G:.6g} J/m2")
