"""Outlines of particles' boxes: parallelograms in a plane, cuts of parallelepipeds with a plane in 3D."""

import itertools

import numpy as np


def parallelograms(centres, edges):
    """Corners (n, 4, 2) from centres (n, 2) and two edge vectors (n, 2, 2)."""
    half = 0.5 * edges
    signs = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
    return centres[:, None, :] + np.einsum("ce,nei->nci", signs, half)


def grown(corners, by):
    """Corners moved away from the middle of their box by a factor, so that no white shows between neighbours."""
    middle = corners.mean(axis=1, keepdims=True)
    return middle + by * (corners - middle)


def reach(edges, axis):
    """Half the extent (n) of boxes along an axis."""
    return 0.5 * np.abs(edges[:, :, axis]).sum(axis=1)


# Twelve edges of a box: the corner where each begins (in half edge vectors) and the edge vector that it follows.
BEGINS = np.array([[-1 if axis == along else signs[axis - (axis > along)] for axis in range(3)]
                   for along in range(3) for signs in itertools.product((-1, 1), repeat=2)])
ALONG = np.repeat(np.arange(3), 4)


def cut(centres, edges, drawn_centres, drawn_edges, normal, where):
    """Outlines [(k, 3)], k from 3 to 6, in which the plane of this normal axis cuts boxes, and the boxes' indices.

    A box is cut as it is and its outline put where the box is drawn, which differs when displacements are magnified."""
    outlines, owners = [], []
    low = centres[:, None, normal] - where + 0.5 * np.einsum("ck,nk->nc", BEGINS, edges[:, :, normal])
    rise = edges[:, ALONG, normal]
    crossed = (low < 0.0) != (low + rise < 0.0)
    fraction = np.divide(-low, rise, out=np.zeros_like(low), where=crossed)
    begin = drawn_centres[:, None, :] + 0.5 * np.einsum("ck,nki->nci", BEGINS, drawn_edges)
    points = begin + fraction[:, :, None] * drawn_edges[:, ALONG, :]
    plane = [axis for axis in range(3) if axis != normal]
    for n in range(len(centres)):
        corner = points[n, crossed[n]]
        if len(corner) < 3:
            continue
        arm = (corner - corner.mean(axis=0))[:, plane]
        outlines.append(corner[np.argsort(np.arctan2(arm[:, 1], arm[:, 0]))])
        owners.append(n)
    return outlines, np.array(owners, dtype=int)
