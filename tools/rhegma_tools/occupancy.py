"""Which squares of a fine lattice particles cover in the undeformed body, and so which faces of their boxes are at the surface."""

import numpy as np

COMMON = 0.01  # of all particles: as many have an edge that is one of the lattice; others are boxes that a surface or a crack cuts
LARGEST_TABLE = 1.0e8  # cells of the lattice of which a table says whether they are covered; of more a sorted list of keys
FINEST = 8  # cells of the lattice along the edge of a box, at most


class Occupancy:
    """low, high: first and last + 1 of the cells (n, 3) that each box covers, at least the one with its middle; edge: of a cell [m]

    seamless: a box covers a face of another one only if both have one size and are not cut. Boxes that a surface cuts are smaller than their
    share of space, and boxes of two sizes part where displacements are magnified: through such gaps one would see into the body."""

    def __init__(self, middle, extent, body, seamless=False):
        sizes, count = np.unique(np.round(extent.max(axis=1) / extent.max(), 6), return_counts=True)
        halvings = np.log2(sizes / sizes[np.argmax(count)])
        common = sizes[(count >= COMMON * len(middle)) & (np.abs(halvings - np.round(halvings)) < 1.0e-3)]
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
        self.kind = np.unique(body, return_inverse=True)[1].astype(np.int64)
        if seamless:
            edges = np.round(extent / self.edge).astype(np.int64)
            self.kind = np.where(whole, np.unique(np.c_[self.kind, edges], axis=0, return_inverse=True)[1].ravel(), -1)
        self.count = self.high.max(axis=0) + 1  # of cells along each axis, with one beyond the last
        self.groups = list(self.boxes_of_a_shape())
        covering = [(cells, of[self.kind[of] >= 0]) for cells, of in self.groups]
        keys = np.concatenate([self.key(self.low[of][:, None] + cells, self.kind[of][:, None]).ravel() for cells, of in covering])
        self.keys, self.table = np.zeros(0, dtype=np.int64), None
        if len(keys) and keys.max() < LARGEST_TABLE:
            self.table = np.zeros(int(keys.max()) + 1, dtype=bool)
            self.table[keys] = True
        else:
            self.keys = np.unique(keys)

    def boxes_of_a_shape(self):
        """(cells (c, 3) counted from the first one, particles) of the boxes that cover as many cells along each axis. There are few shapes, so that
        the work is that of the cells which are covered."""
        shape = self.high - self.low
        code = (shape[:, 0] * (shape[:, 1].max() + 1) + shape[:, 1]) * (shape[:, 2].max() + 1) + shape[:, 2]
        order = np.argsort(code, kind="stable")
        for of in np.split(order, np.flatnonzero(np.diff(code[order])) + 1):
            yield np.array(list(np.ndindex(*shape[of[0]])), dtype=np.int64), of

    def key(self, cells, kind):
        return ((kind * self.count[0] + cells[..., 0]) * self.count[1] + cells[..., 1]) * self.count[2] + cells[..., 2]

    def covered(self, cells, kind):
        """Whether a box of a kind covers each cell; none does of kind -1, nor where there are no such boxes at all."""
        wanted = self.key(cells, kind)
        if self.table is not None:
            return (kind >= 0) & (wanted < len(self.table)) & self.table[np.clip(wanted, 0, len(self.table) - 1)]
        if len(self.keys) == 0:
            return np.zeros(wanted.shape, dtype=bool)
        return (kind >= 0) & (self.keys[np.minimum(np.searchsorted(self.keys, wanted), len(self.keys) - 1)] == wanted)

    def free(self, outward):
        """Whether the face (n) of each box in a direction along an axis, such as (0, 0, -1), has a cell next to it that no box of its kind covers."""
        axis = int(np.argmax(np.abs(outward)))
        beyond = self.high[:, axis] if outward[axis] > 0.0 else self.low[:, axis] - 1
        result = np.zeros(len(self.low), dtype=bool)
        for cells, of in self.groups:
            next_to = self.low[of][:, None] + cells[cells[:, axis] == 0]
            next_to[..., axis] = beyond[of][:, None]
            result[of] = ~self.covered(next_to, self.kind[of][:, None]).all(axis=1)
        return result
