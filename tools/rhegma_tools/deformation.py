"""Where particles and cracks are drawn when displacements are magnified."""

import math

import numpy as np

VISIBLE = 0.02  # of the body's size: a smaller displacement is magnified ...
WANTED = 0.08  # ... to at most this


STRAIN = 0.4  # largest magnified gradient of the displacement of nearly all particles: with 1, a compressed particle would have no size
MOST_PARTICLES = 0.99


def gradients(deformation):
    """Magnitude of the displacement gradient (n) of each particle: the largest stretch of a line, other than by magnified rotation, is below it."""
    return np.linalg.norm(deformation - np.eye(3), ord=2, axis=(1, 2))


def automatic_magnification(position, displacement, deformation):
    """1 where the displacement is visible as it is; else 1, 2 or 5 times a power of ten. deformation: F (n, 3, 3); magnified, it turns no more than a
    few particles inside out"""
    size = float(np.max(np.ptp(position, axis=0)))
    largest = float(np.max(np.linalg.norm(displacement, axis=1)))
    # Displacements that rounding alone can give are not worth a look.
    if largest >= VISIBLE * size or largest <= 1.0e-12 * size:
        return 1.0
    strained = float(np.quantile(gradients(deformation), MOST_PARTICLES))
    exact = min(WANTED * size / largest, STRAIN / max(strained, 1.0e-300))
    if exact < 1.0:
        return 1.0
    power = 10.0 ** math.floor(math.log10(exact))
    return max(1.0, max(step * power for step in (1.0, 2.0, 5.0) if step * power <= exact * (1.0 + 1.0e-9)))


def crack_normals(crack):
    """A unit normal at every vertex: the mean over its cells; zero where a vertex has none."""
    corner = crack.points[crack.cells]
    if crack.is_surface:
        normal = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    else:
        along = corner[:, 1] - corner[:, 0]
        normal = np.stack([-along[:, 1], along[:, 0], np.zeros(len(along))], axis=1)
    sums = np.zeros_like(crack.points)
    for i in range(crack.cells.shape[1]):
        np.add.at(sums, crack.cells[:, i], normal)
    length = np.linalg.norm(sums, axis=1, keepdims=True)
    return np.divide(sums, length, out=np.zeros_like(sums), where=length > 0.0)


ON_FACE = 0.25  # of its last segment: an end that is nearer than this to another crack lies on it


def joined_ends(crack):
    """Ends of polylines that lie on another crack: vertex -> (a point of that crack, its normal to the end's side)."""
    joined = {}
    if crack.is_surface:
        return joined
    neighbours = [set() for _ in crack.points]
    for i, j in crack.cells:
        neighbours[i].add(j)
        neighbours[j].add(i)
    start, along = crack.points[crack.cells[:, 0]], np.diff(crack.points[crack.cells], axis=1)[:, 0]
    squared = np.maximum(np.einsum("ij,ij->i", along, along), 1.0e-300)
    for v in (v for v, others in enumerate(neighbours) if len(others) == 1):
        own, reached = {v}, [v]
        while reached:
            more = neighbours[reached.pop()] - own
            own |= more
            reached += more
        others = [s for s, (i, _) in enumerate(crack.cells) if i not in own]
        if not others:
            continue
        point, (before,) = crack.points[v], neighbours[v]
        fraction = np.clip(np.einsum("ij,ij->i", point - start[others], along[others]) / squared[others], 0.0, 1.0)
        foot = start[others] + fraction[:, None] * along[others]
        nearest = int(np.argmin(np.linalg.norm(point - foot, axis=1)))
        back = crack.points[before] - foot[nearest]
        if np.linalg.norm(point - foot[nearest]) < ON_FACE * np.linalg.norm(crack.points[before] - point):
            normal = np.array([-along[others[nearest]][1], along[others[nearest]][0], 0.0])
            joined[v] = (foot[nearest], normal if back @ normal > 0.0 else -normal)
    return joined


def crack_displacement(crack, position, displacement):
    """Displacement of every vertex, midway between the faces: the mean of the nearest particles' on either side. An
    end on another crack moves with the particles on its own side of that."""
    normal, joined = crack_normals(crack), joined_ends(crack)
    result = np.zeros_like(crack.points)
    for v, point in enumerate(crack.points):
        arm = position - point
        squared = np.einsum("ij,ij->i", arm, arm)
        if v in joined:
            foot, toward = joined[v]
            squared = np.where((position - foot) @ toward > 0.0, squared, np.inf)
        near = np.argpartition(squared, min(15, len(squared) - 1))[:16]
        near = near[np.isfinite(squared[near])]
        above = arm[near] @ normal[v] > 0.0
        sides = []
        for side in (near[above], near[~above]):
            if side.size:
                weight = 1.0 / (squared[side] + 1.0e-300)
                sides.append(weight @ displacement[side] / weight.sum())
        result[v] = np.mean(sides, axis=0)
    return result


def opening_power(crack, front, far, position, displacement):
    """The power of the distance from a front with which faces open up to the next vertex, from the particles halfway:
    1/2 near a front of an elastic body, 2 between the arms of a beam."""
    middle = 0.5 * (crack.points[front] + crack.points[far])
    normal = crack.opening[far] / np.linalg.norm(crack.opening[far])
    arm = position - middle
    across, squared = arm @ normal, np.einsum("ij,ij->i", arm, arm)
    sides = [np.flatnonzero(across > 0.0), np.flatnonzero(across <= 0.0)]
    if min(side.size for side in sides) < 2:
        return 1.0
    moved = [displacement[side[np.argsort(squared[side])[:2]]].mean(axis=0) @ normal for side in sides]
    fraction = (moved[0] - moved[1]) / np.linalg.norm(crack.opening[far])
    return float(np.clip(-np.log2(fraction), 0.5, 2.0)) if fraction > 0.0 else 2.0


def curved_at_fronts(crack, faces, position, displacement):
    """Segments (s, 2, 3) of each of the two faces of a polyline. Vertices are cells apart; up to the last one from a
    front, where the faces meet, they are drawn with a power of the distance."""
    one, other = faces
    middle, half = 0.5 * (one + other), 0.5 * (one - other)
    closed = np.linalg.norm(crack.opening, axis=1) == 0.0
    lines = ([], [])
    for i, j in crack.cells:
        fraction = np.linspace(0.0, 1.0, 17 if closed[i] != closed[j] else 2)[:, None]
        centre = (1.0 - fraction) * middle[i] + fraction * middle[j]
        if closed[i] and not closed[j]:
            apart = fraction ** opening_power(crack, i, j, position, displacement) * half[j]
        elif closed[j] and not closed[i]:
            apart = (1.0 - fraction) ** opening_power(crack, j, i, position, displacement) * half[i]
        else:
            apart = (1.0 - fraction) * half[i] + fraction * half[j]
        for line, points in zip(lines, (centre + apart, centre - apart)):
            line += list(np.stack([points[:-1], points[1:]], axis=1))
    return [np.array(line) for line in lines]


def magnified_faces(crack, position, displacement, magnification):
    """Both faces' vertices (v, 3) as drawn. An undeformed crack is closed, so its opening is a displacement too."""
    middle = crack.points
    if magnification != 1.0:
        middle = middle + (magnification - 1.0) * crack_displacement(crack, position, displacement)
    half = 0.5 * magnification * crack.opening
    return middle + half, middle - half
