"""Which squares of a fine lattice particles cover in the undeformed body, and so which faces of their boxes are at the surface."""

import itertools

import numpy as np

COMMON = 0.01  # of all particles: as many have an edge that is one of the lattice; others are boxes that a surface or a crack cuts
ALONG = 1 << 19  # cells of the lattice along an axis, at most
FINEST = 8  # cells of the lattice along the edge of a box, at most


class Occupancy:
    """low, high: first and last + 1 of the cells (n, 3) that each box covers, at least the one with its middle; edge: of a cell [m]"""

    def __init__(self, middle, extent, body):
        sizes, count = np.unique(np.round(extent.max(axis=1) / extent.max(), 6), return_counts=True)
        common = sizes[count >= COMMON * len(middle)]
        self.edge = float(extent.max()) * max(float(common.min()) if len(common) else 1.0, 1.0 / FINEST)
        begin = (middle - 0.5 * extent) / self.edge
        whole = np.all(np.abs(extent / self.edge - np.round(extent / self.edge)) < 1.0e-3, axis=1)
        phase = np.round((begin[whole] if whole.any() else begin) % 1.0, 3) % 1.0
        origin = np.array([np.unique(phase[:, axis], return_counts=True)[0][np.argmax(np.unique(phase[:, axis], return_counts=True)[1])] for axis in range(3)])
        begin = begin - origin
        origin = np.floor(begin.min(axis=0)) - 2.0
        begin = begin - origin
        inside = np.floor(begin + 0.5 * extent / self.edge + 1.0e-6).astype(np.int64)
        self.low = np.minimum(np.round(begin).astype(np.int64), inside)
        self.high = np.maximum(np.round(begin + extent / self.edge).astype(np.int64), inside + 1)
        self.body = body.astype(np.int64)
        self.keys = np.unique(np.concatenate([self.key(self.low[chosen] + step, self.body[chosen]) for step, chosen in self.cells()]))

    def cells(self):
        """(step (3), particles) for each cell of the boxes, counted from their first one."""
        count = self.high - self.low
        for step in itertools.product(*(range(int(most)) for most in count.max(axis=0))):
            chosen = np.flatnonzero(np.all(np.array(step) < count, axis=1))
            if len(chosen):
                yield np.array(step), chosen

    @staticmethod
    def key(cells, body):
        return ((body * ALONG + cells[:, 0]) * ALONG + cells[:, 1]) * ALONG + cells[:, 2]

    def covered(self, cells, body):
        wanted = self.key(cells, body)
        return self.keys[np.minimum(np.searchsorted(self.keys, wanted), len(self.keys) - 1)] == wanted

    def free(self, outward):
        """Whether the face (n) of each box in a direction along an axis, such as (0, 0, -1), has a cell next to it that no box of its body covers."""
        axis = int(np.argmax(np.abs(outward)))
        beyond = self.high[:, axis] if outward[axis] > 0.0 else self.low[:, axis] - 1
        result = np.zeros(len(self.low), dtype=bool)
        for step, chosen in self.cells():
            if step[axis] == 0:
                cells = self.low[chosen] + step
                cells[:, axis] = beyond[chosen]
                result[chosen] |= ~self.covered(cells, self.body[chosen])
        return result
