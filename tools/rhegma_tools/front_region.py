"""Particles around the fronts of cracks: those whose stress a picture must show."""

import numpy as np

from .front_picture import border

AROUND = 4.0  # particle edges around a front
AHEAD, NEAR = 2.0, 1.4  # particle edges: how far ahead of a front material must be, and how near to that point on both sides of the crack
CHUNK = 4_000_000  # distances at a time


def ends_of(crack):
    """(points (k, 3), unit vectors out of the crack and normal to it (k, 3)) of the ends of cracks in 2D and of the edges of their surfaces in 3D."""
    if crack.is_surface:
        edges = border(crack.cells)
        owner = {tuple(sorted(pair)): cell for cell in crack.cells for pair in (cell[[0, 1]], cell[[1, 2]], cell[[2, 0]])}
        cells = np.array([owner[tuple(edge)] for edge in edges]).reshape(-1, 3)
        at, along = crack.points[edges].mean(axis=1), crack.points[edges[:, 1]] - crack.points[edges[:, 0]]
        corner = crack.points[cells]
        normal = unit(np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]))
        out = unit(np.cross(along, normal))
        inward = np.einsum("ij,ij->i", out, at - corner.mean(axis=1)) < 0.0
        out[inward] *= -1.0
        return at, out, normal
    number, count = np.unique(crack.cells, return_counts=True)
    last = number[count == 1]
    cells = np.array([crack.cells[np.flatnonzero((crack.cells == v).any(axis=1))[0]] for v in last]).reshape(-1, 2)
    other = np.where(cells[:, 0] == last, cells[:, 1], cells[:, 0])
    out = unit(crack.points[last] - crack.points[other])
    return crack.points[last], out, np.stack([-out[:, 1], out[:, 0], np.zeros(len(out))], axis=1)


def unit(vectors):
    size = np.linalg.norm(vectors, axis=1, keepdims=True)
    return np.divide(vectors, size, out=np.zeros_like(vectors), where=size > 0.0)


def material_ahead(position, ahead, normal, reach):
    """Whether (k) particles are as near as that to points on both sides of the plane through each."""
    found = np.zeros((2, len(ahead)), dtype=bool)
    step = max(1, CHUNK // max(len(ahead), 1))
    for start in range(0, len(position), step):
        arm = position[start:start + step, None, :] - ahead[None, :, :]
        near, side = np.linalg.norm(arm, axis=2) < reach, np.einsum("nki,ki->nk", arm, normal)
        for i, sign in enumerate((1.0, -1.0)):
            found[i] |= (near & (sign * side > 0.1 * reach)).any(axis=0)
    return found.all(axis=0)


def distances(points, to):
    """Distance (n) of each point to the nearest of others."""
    step = max(1, CHUNK // max(len(to), 1))
    parts = [np.linalg.norm(points[start:start + step, None, :] - to[None, :, :], axis=2).min(axis=1) for start in range(0, len(points), step)]
    return np.concatenate(parts) if parts else np.zeros(0)


def near_any(position, points, reach):
    """Indices of the particles in the cells, as large as the reach, of any of the points and next to them."""
    low = position.min(axis=0) - 2.0 * reach
    shape = np.ceil((position.max(axis=0) - low) / reach).astype(np.int64) + 3

    def keys(places):
        return (places[..., 0] * shape[1] + places[..., 1]) * shape[2] + places[..., 2]

    around = np.stack(np.meshgrid(*3 * [[-1, 0, 1]], indexing="ij"), axis=-1).reshape(-1, 3)
    places = np.floor((points - low) / reach).astype(np.int64)[:, None, :] + around
    places = places[np.all((places >= 0) & (places < shape), axis=2)]
    return np.flatnonzero(np.isin(keys(np.floor((position - low) / reach).astype(np.int64)), keys(places)))


def at_fronts(fields):
    """Whether particles (n) are within a few edges of a crack front, which has material ahead of it; all false where there is none."""
    near = np.zeros(len(fields.position), dtype=bool)
    if fields.crack is None or len(near) == 0:
        return near
    at, out, normal = ends_of(fields.crack)
    chosen = near_any(fields.position, at, AROUND * fields.size)
    if len(chosen) == 0 or len(at) == 0:
        return near
    fronts = at[material_ahead(fields.position[chosen], at + AHEAD * fields.size * out, normal, NEAR * fields.size)]
    if len(fronts):
        near[chosen] = distances(fields.position[chosen], fronts) <= AROUND * fields.size
    return near
