"""Fronts of cracks in 3D as the fields have them: edges of the crack's surface that have one triangle, with material beyond them."""

import numpy as np

from . import boxes


def front_edges(fields):
    """Numbers (k, 2) of the crack's points at the ends of each edge of its fronts."""
    crack = fields.crack
    edges = np.concatenate([crack.cells[:, [0, 1]], crack.cells[:, [1, 2]], crack.cells[:, [2, 0]]])
    third = np.concatenate([crack.cells[:, 2], crack.cells[:, 0], crack.cells[:, 1]])
    _, first, count = np.unique(np.sort(edges, axis=1), axis=0, return_index=True, return_counts=True)
    edges, third = edges[first[count == 1]], third[first[count == 1]]
    start, end, inner = crack.points[edges[:, 0]], crack.points[edges[:, 1]], crack.points[third]
    along = end - start
    middle = 0.5 * (start + end)
    outward = middle - inner
    square = np.einsum("ij,ij->i", along, along)
    outward -= np.divide(np.einsum("ij,ij->i", outward, along), square, out=np.zeros_like(square), where=square > 0.0)[:, None] * along
    size = np.linalg.norm(outward, axis=1, keepdims=True)
    beyond = middle + fields.size * np.divide(outward, size, out=np.zeros_like(outward), where=size > 0.0)
    half = 1.5 * np.stack([boxes.reach(fields.boxes(), axis) for axis in range(3)], axis=1)  # also between particles that part
    inside = [bool((np.abs(fields.position - point) <= half).all(axis=1).any()) for point in beyond]
    return edges[np.array(inside, dtype=bool)]


def lengths_of_fronts(fields):
    """How long crack fronts are along each axis (3) [m]."""
    edges = front_edges(fields)
    return np.abs(fields.crack.points[edges[:, 1]] - fields.crack.points[edges[:, 0]]).sum(axis=0)


def crossings(fields, faces, normal, where):
    """Positions [(3)] at which fronts cross a plane, as drawn: found on the crack as it is, in the middle between its faces as they have gone.
    normal: number of the axis; where: its coordinate [m]; faces: points (v, 3) of both"""
    height = fields.crack.points[:, normal] - where
    height = np.where(height == 0.0, 1.0e-300, height)  # a point on the plane counts as above it
    middle = 0.5 * (faces[0] + faces[1])
    found = []
    for i, j in front_edges(fields):
        if (height[i] > 0.0) != (height[j] > 0.0):
            part = height[i] / (height[i] - height[j])
            found.append((1.0 - part) * middle[i] + part * middle[j])
    return found
