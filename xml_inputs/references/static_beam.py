#!/usr/bin/env python3
"""Static energy release rate of the double cantilever beam by a direct solve, apart from the program.

Particles of linear functions sit at their initial positions, as integration points. At rest K U = f holds whatever the
mass matrix, the damping and the order of the step, so a run that has settled must agree. Prints the error of J (weight
interpolated like the motion, and by unbroken functions) and of the change of strain energy dU/da for three methods to cut
cells; with --limit the largest stable CFL number of MUSL, from the eigenvalues of M^-1 Mc M^-1 K.

    xml_inputs/references/static_beam.py [--limit] CELLS_PER_ARM [CELLS_PER_ARM ...]        (needs numpy and scipy)
"""
import sys

import numpy as np
import scipy.sparse as sparse
import scipy.sparse.linalg as linalg

E, NU, RHO, ARM, LENGTH, CRACK, FORCE, REFERENCE = 3e9, 0.33, 1200.0, 0.01, 0.1, 0.05, 100.0, 0.12873
STIFFNESS = E / (1 - NU**2) * np.array([[1, NU, 0], [NU, 1, 0], [0, 0, (1 - NU) / 2]])
TIE, AT_FRONT = 0.1, 0.25  # cells: nodes so little below the crack count as above it, behind the front as at it


class Beam:
    """The beam on a grid whose rows lie `offset` cells below the crack's; formulation Dual, Broken or Corrected."""

    def __init__(self, cells, offset, formulation, crack=CRACK):
        self.dx, self.formulation, self.crack = ARM / cells, formulation, crack
        self.origin = np.array([-2.0, -2.0 - offset]) * self.dx
        self.rows = 2 * cells + 6
        self.lattice = (int(round(LENGTH / self.dx)) + 6) * self.rows
        along, across = int(round(LENGTH / self.dx)) * 2, 4 * cells
        self.volume = self.dx**2 / 4
        self.points = [((i + 0.5) * self.dx / 2, (j + 0.5) * self.dx / 2) for i in range(along) for j in range(across)]
        self.unbroken = [self.stencil(x, y) for x, y in self.points]
        self.broken = [self.cut(s, 1 if y > ARM else -1) for s, (x, y) in zip(self.unbroken, self.points)]

    def place(self, node):
        return self.origin + np.array(divmod(node % self.lattice, self.rows)) * self.dx

    def side(self, node):
        x, y = self.place(node)
        if self.crack - x <= AT_FRONT * self.dx:
            return 0
        return 1 if y - ARM > -TIE * self.dx else -1

    def stencil(self, x, y):
        at = (np.array([x, y]) - self.origin) / self.dx
        cell = np.floor(at + 1e-9).astype(int)
        (u, v), found = at - cell, {}
        for i, wx, gx in ((0, 1 - u, -1), (1, u, 1)):
            for j, wy, gy in ((0, 1 - v, -1), (1, v, 1)):
                node = (cell[0] + i) * self.rows + cell[1] + j
                found[node] = np.array([wx * wy, gx * wy / self.dx, wx * gy / self.dx])
        return found

    def cut(self, stencil, side):
        hidden = {n: w for n, w in stencil.items() if self.side(n) == -side}
        seen = {n: w.copy() for n, w in stencil.items() if n not in hidden}
        if self.formulation == "Broken" and seen:
            for n in seen:
                seen[n] += sum(hidden.values(), np.zeros(3)) / len(seen)
        if self.formulation == "Dual":
            seen.update({n + self.lattice: w for n, w in hidden.items()})
        if self.formulation == "Corrected":
            for n, w in hidden.items():
                k = 1
                while self.side(n + k * side) == -side:
                    k += 1
                for stand_in, share in ((n + k * side, 1 + k), (n + (k + 1) * side, -k)):
                    seen[stand_in] = seen.get(stand_in, np.zeros(3)) + share * w
        return seen

    def assemble(self):
        entries, masses = ([], [], []), ([], [], [])
        self.mass = np.zeros(2 * self.lattice)
        for stencil in self.broken:
            nodes = np.array(list(stencil))
            w = np.array(list(stencil.values()))
            B = np.zeros((3, 2 * len(nodes)))
            B[0, 0::2], B[1, 1::2], B[2, 0::2], B[2, 1::2] = w[:, 1], w[:, 2], w[:, 2], w[:, 1]
            dofs = np.stack([2 * nodes, 2 * nodes + 1], 1).ravel()
            for lists, ids, block in ((entries, dofs, self.volume * B.T @ STIFFNESS @ B),
                                      (masses, nodes, RHO * self.volume * np.outer(w[:, 0], w[:, 0]))):
                lists[0].append(np.repeat(ids, len(ids)))
                lists[1].append(np.tile(ids, len(ids)))
                lists[2].append(block.ravel())
            np.add.at(self.mass, nodes, RHO * self.volume * w[:, 0])
        build = lambda lists, n: sparse.csr_matrix(
            (np.concatenate(lists[2]), (np.concatenate(lists[0]), np.concatenate(lists[1]))), (n, n))
        return build(entries, 4 * self.lattice), build(masses, 2 * self.lattice)

    def solve(self):
        K, _ = self.assemble()
        f = np.zeros(4 * self.lattice)
        ends = (np.arange(8 * round(ARM / self.dx)) + 0.5) * self.dx / 4
        for side in (1, -1):
            height = np.array([y for y in ends if (y > ARM) == (side > 0)])
            share = 1 - ((height - ARM - side * ARM / 2) / (ARM / 2))**2
            for y, s in zip(height, share / share.sum()):
                held = {n: w[0] for n, w in self.cut(self.stencil(1e-12, y), side).items() if self.mass[n] > 0}
                for n, w in held.items():
                    f[2 * n + 1] += side * FORCE * s * w / sum(held.values())
        fixed = np.abs(K.diagonal()) < 1e-12 * K.diagonal().max()
        column, row = round((LENGTH - self.origin[0]) / self.dx), round((ARM - self.origin[1]) / self.dx)
        last = column * self.rows + row
        fixed[[2 * last, 2 * last + 1]] = True
        if self.formulation != "Broken":  # eq. 3 holds the body's rotation by itself
            fixed[2 * (last - 4 * self.rows) + 1] = True
        free, U = np.where(~fixed)[0], np.zeros(4 * self.lattice)
        U[free] = linalg.spsolve(K[free][:, free].tocsc(), f[free])
        return U

    def integrate(self, U, inner=3e-3, outer=9e-3):
        """J with the weight like the motion, J with the weight by unbroken functions, and the strain energy."""
        weight = lambda n: np.clip((outer - np.hypot(*(self.place(n) - (self.crack, ARM)))) / (outer - inner), 0, 1)
        like, unlike, energy = 0.0, 0.0, 0.0
        for whole, stencil in zip(self.unbroken, self.broken):
            g = sum(np.outer(U[[2 * n, 2 * n + 1]], w[1:]) for n, w in stencil.items())
            e = np.array([g[0, 0], g[1, 1], g[0, 1] + g[1, 0]])
            s = STIFFNESS @ e
            W, sigma = 0.5 * s @ e, np.array([[s[0], s[2]], [s[2], s[1]]])
            energy += self.volume * W
            for seen, is_like in ((stencil, True), (whole, False)):
                dq = sum(weight(n) * w[1:] for n, w in seen.items())
                J = self.volume * ((sigma @ dq) @ g[:, 0] - W * dq[0])
                like, unlike = (like + J, unlike) if is_like else (like, unlike + J)
        return like, unlike, energy

    def limit(self):
        """Largest CFL number at which MUSL is stable."""
        K, Mc = self.assemble()
        used = np.repeat(self.mass > 1e-13, 2)
        root = sparse.diags(1 / np.sqrt(np.repeat(self.mass, 2)[used]))
        K, Mc = root @ K[used][:, used] @ root, root @ sparse.kron(Mc, np.eye(2)).tocsr()[used][:, used] @ root
        fastest = abs(linalg.eigs(Mc @ K, k=1, which="LM", tol=1e-4, return_eigenvectors=False)[0])
        feedback = linalg.eigsh(Mc, k=1, which="LA", return_eigenvectors=False)[0]
        return 2 / np.sqrt(fastest) * np.sqrt(STIFFNESS[0, 0] / RHO) / self.dx, feedback


def main():
    sizes = [int(word) for word in sys.argv[1:] if word != "--limit"]
    if not sizes:
        sys.exit(__doc__)
    percent = lambda value: f"{100 * (value / REFERENCE - 1):8.2f}"
    for cells in sizes:
        for offset in (0.0, 0.0999, 0.5) if "--limit" in sys.argv else (0.0, 0.5):
            for formulation in ("Dual", "Broken", "Corrected"):
                head = f"{cells:3d} cells an arm, crack {offset:.2f} cells above a row, {formulation:9s}"
                if "--limit" in sys.argv:
                    print(head, "largest CFL %.3f, largest eigenvalue of M^-1 Mc %.3f" %
                          Beam(cells, offset, formulation).limit(), flush=True)
                    continue
                like, unlike, _ = (beam := Beam(cells, offset, formulation)).integrate(beam.solve())
                energies = []
                for crack in (CRACK - beam.dx, CRACK + beam.dx):
                    other = Beam(cells, offset, formulation, crack)
                    energies.append(other.integrate(other.solve())[2])
                rate = (energies[1] - energies[0]) / (2 * beam.dx)
                print(head, "J", percent(like), " J, unbroken weight", percent(unlike), " dU/da", percent(rate), "%",
                      flush=True)


main()
