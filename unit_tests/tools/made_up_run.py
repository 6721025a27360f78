"""Writes folders such as a run leaves, with made-up numbers, for the tests of the tools."""

import csv
import json
import os

import h5py
import numpy as np

G = 0.5  # energy release rate that the made-up beam settles at [J/m^2]


def write_history(folder, columns):
    with open(os.path.join(folder, "history.csv"), "w", newline="") as file:
        rows = csv.writer(file)
        rows.writerow(columns)
        rows.writerows(zip(*columns.values()))


def write_summary(folder, **more):
    summary = {"scene": "made_up.xml", "status": "finished", "cracks": [], "references": []}
    summary.update(more)
    with open(os.path.join(folder, "summary.json"), "w") as file:
        json.dump(summary, file)


def write_fields(folder, times):
    """times: [(time, {"particles": {...}, "cracks": {...}})]"""
    with h5py.File(os.path.join(folder, "fields.h5"), "w") as file:
        for i, (time, groups) in enumerate(times):
            group = file.create_group(f"t{i:05d}")
            group.attrs["time"] = time
            for name, fields in groups.items():
                for field, values in fields.items():
                    group.create_dataset(f"{name}/{field}", data=values)


def write_fronts(folder, samples):
    """fronts.h5 and fronts.csv. samples: [(time, {"CRACK.N": {"s": ..., "G": ...}})]; columns that are not given are zero"""
    names = ("s", "G", "K_I", "K_II", "K_III", "speed")
    rows = []
    with h5py.File(os.path.join(folder, "fronts.h5"), "w") as file:
        for i, (time, fronts) in enumerate(samples):
            group = file.create_group(f"t{i:05d}")
            group.attrs["time"] = time
            for name, given in fronts.items():
                s = np.asarray(given["s"], dtype=float)
                table = {column: np.asarray(given.get(column, 0 * s), dtype=float) for column in names}
                position = given.get("position", np.c_[s, 0 * s, 0 * s])
                for column, values in (*table.items(), ("position", position), ("line", given.get("line", np.zeros(len(s), int)))):
                    group.create_dataset(f"{name}/{column}", data=values)
                crack, _, number = name.rpartition(".")
                rows += [[time, crack, number, k, s[k], *position[k], *(table[column][k] for column in names[1:])] for k in range(len(s))]
    with open(os.path.join(folder, "fronts.csv"), "w", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([["time", "crack", "front", "node", "s", "x", "y", "z", *names[1:]], *rows])


def particles(start, displacement, stress, edge, body=None):
    """All particle fields from starting positions, displacements, stresses (n, 6) and the edge; boxes are undeformed. 2D
    where all start at z = 0."""
    n = len(start)
    flat = n > 0 and not np.any(start[:, 2])
    xx, yy, zz, xy, yz, xz = np.asarray(stress).T
    mises = np.sqrt(0.5 * ((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) + 3 * (xy**2 + yz**2 + xz**2))
    return {
        "position": start + displacement,
        "displacement": displacement,
        "velocity": np.zeros((n, 3)),
        "stress": stress,
        "von_mises": mises,
        "mass": np.ones(n),
        "edge": np.full(n, edge),
        "deformation": np.tile(np.eye(3).ravel(), (n, 1)),
        "edges": np.tile(edge * np.diag([1.0, 1.0, 0.0 if flat else 1.0]).ravel(), (n, 1)),
        "body": np.zeros(n, int) if body is None else body,
        "material": np.zeros(n, int),
    }


def lattice(*ranges):
    return np.stack([a.ravel() for a in np.meshgrid(*ranges, indexing="ij")], axis=-1)


def beam(folder, samples=400):
    """A double cantilever beam 100 x 20 mm, opened along its middle for 50 mm, as beam theory bends it."""
    os.makedirs(folder, exist_ok=True)
    edge = 0.625e-3
    xy = lattice(np.arange(0.5, 160) * edge, (np.arange(0.5, 32) - 16) * edge)
    start = np.c_[xy, np.zeros(len(xy))]
    length, tip, most = 0.1, 0.05, 4.0e-6  # the free end is at x = 0; opening of one arm there [m]
    upper = np.where(xy[:, 1] > 0.0, 1.0, -1.0)
    s = np.clip(1.0 - xy[:, 0] / tip, 0.0, None)
    sag = 0.5 * most * s**2 * (3.0 - s)
    displacement = np.c_[np.zeros(len(xy)), upper * sag, np.zeros(len(xy))]
    stress = np.zeros((len(xy), 6))
    arm = upper * (xy[:, 1] - upper * 5.0e-3)  # from the arm's middle, outwards
    stress[:, 0] = -2.0e5 * (xy[:, 0] / tip) * (arm / 5.0e-3) * (s > 0.0)
    r = np.hypot(xy[:, 0] - tip, xy[:, 1])
    angle = np.arctan2(xy[:, 1], xy[:, 0] - tip)
    stress[:, 1] = 4.0e3 / np.sqrt(r) * np.sin(0.5 * np.abs(angle) + np.pi / 2) ** 2 * np.exp(-r / 8.0e-3)
    vertices = np.linspace(0.0, tip, 41)
    opening = most * (1.0 - vertices / tip) ** 2 * (2.0 + vertices / tip)
    crack = {
        "points": np.c_[vertices, np.zeros((41, 2))],
        "cells": np.c_[np.arange(40), np.arange(1, 41)],
        "crack": np.zeros(40, int),
        "opening": np.c_[np.zeros(41), opening, np.zeros(41)],
    }
    still = particles(start, np.zeros_like(start), np.zeros((len(xy), 6)), edge)
    write_fields(folder, [(0.0, {"particles": still}),
                          (3.0e-3, {"particles": particles(start, displacement, stress, edge), "cracks": crack})])

    t = np.linspace(0.0, 3.0e-3, samples)
    settle = 1.0 - np.exp(-t / 4.0e-4) * np.cos(2 * np.pi * t / 1.0e-3)
    strain = 2.0e-6 * settle**2
    kinetic = 1.2e-6 * np.exp(-t / 2.0e-4) * np.sin(2 * np.pi * t / 1.0e-3) ** 2
    work = 4.0e-6 * settle
    damped = np.maximum.accumulate(np.clip(work - strain - kinetic, 0.0, None))
    write_history(folder, {
        "time": t, "kinetic": kinetic, "strain": strain, "thermal": 0 * t, "external_work": work, "damped": damped,
        "contact": 0 * t, "residual": work - strain - kinetic - damped, "momentum_x": 0 * t,
        "Notch.0.G_closure": 0.985 * G * settle, "Notch.0.G_J": G * settle,
        "Notch.0.length": np.full_like(t, tip),
    })
    quantity = "cracks.0.fronts.0."
    write_summary(
        folder, scene="xml_inputs/examples/dcb.xml", steps=1000, wall_seconds=4.0, particle_steps=5.12e6,
        cracks=[{"name": "Notch", "fronts": [{"position": [tip, 0.0], "G_J": G, "G_closure": 0.985 * G}]}],
        references=[
            {"quantity": quantity + "G_J", "reference": 0.49, "value": G, "tolerance": 0.04, "within": True},
            {"quantity": quantity + "G_closure", "reference": 0.49, "value": 0.985 * G, "tolerance": 0.04,
             "within": True},
        ])


def refined_plate(folder, levels):
    """A plate of 2 m by 1 m on two cells of 1 m; those of level 1 are four leaves."""
    corners, level = [], []
    for x, l in zip((0.0, 1.0), levels):
        edge = 0.5**l
        for i in range(2**l):
            for j in range(2**l):
                low = np.array([x + edge * i, edge * j, 0.0])
                corners += [low + edge * np.array(c) for c in ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0))]
                level.append(l)
    start = lattice(np.arange(0.25, 2.0, 0.5), np.arange(0.25, 1.0, 0.5), [0.0])
    stress = np.zeros((len(start), 6))
    stress[:, 0] = 1e6 * start[:, 0]
    leaves = {"points": np.array(corners), "cells": np.arange(len(corners)).reshape(-1, 4), "level": np.array(level)}
    write_fields(folder, [(2e-3, {"particles": particles(start, np.zeros_like(start), stress, 0.5), "leaves": leaves})])


def penny(folder):
    """A cube of edge 1 m with a round crack of radius 0.3 m at z = 0, pulled along z."""
    os.makedirs(folder, exist_ok=True)
    n = 40
    edge = 1.0 / n
    start = lattice(*3 * [(np.arange(0.5, n) - n / 2) * edge])
    x, y, z = start.T
    r = np.hypot(x, y)
    shape = np.sqrt(np.clip(0.09 - r**2, 0.0, None))
    displacement = np.c_[0 * x, 0 * y, 1.0e-4 * (np.sign(z) * shape * np.exp(-np.abs(z) / 0.2) + z)]
    stress = np.zeros((len(start), 6))
    stress[:, 2] = 1.0e6 * (1.0 - np.exp(-np.abs(z) / 0.2) * (r < 0.3) + 0.5 * np.exp(-np.hypot(r - 0.3, z) / 0.05))
    rings = np.linspace(0.0, 0.3, 7)[1:]
    points, cells = [[0.0, 0.0, 0.0]], []
    for i, ring in enumerate(rings):
        for k in range(24):
            angle = 2 * np.pi * k / 24
            points.append([ring * np.cos(angle), ring * np.sin(angle), 0.0])
            a, b = 1 + 24 * i + k, 1 + 24 * i + (k + 1) % 24
            cells += [[0, a, b]] if i == 0 else [[a - 24, a, b], [a - 24, b, b - 24]]
    points = np.array(points)
    opening = np.zeros_like(points)
    opening[:, 2] = 2.0e-4 * np.sqrt(np.clip(0.09 - (points**2).sum(axis=1), 0.0, None))
    crack = {"points": points, "cells": np.array(cells), "crack": np.zeros(len(cells), int), "opening": opening}
    write_fields(folder, [(1.0e-3, {"particles": particles(start, displacement, stress, edge), "cracks": crack})])
    t = np.linspace(0.0, 1.0e-3, 60)
    columns = {"time": t, "kinetic": 0.1 * t, "strain": 50.0 * t / 1.0e-3}
    for front in range(12):
        columns[f"Penny.{front}.G_J"] = (1.0 + 0.01 * np.cos(front)) * 120.0 * t / 1.0e-3
    write_history(folder, columns)
    write_summary(folder, scene="penny.xml")


def balls(folder):
    """Two balls of radius 0.2 m after their impact; they have moved by as much."""
    os.makedirs(folder, exist_ok=True)
    edge = 0.02
    cube = lattice(*3 * [np.arange(-9.5, 10) * edge])
    ball = cube[(cube**2).sum(axis=1) <= 0.04]
    one, two = ball - [0.2, 0.2, 0.2], ball + [0.2, 0.2, 0.2]
    start = np.r_[one, two]
    displacement = np.r_[np.full_like(one, 0.09), np.full_like(two, -0.09)]
    touch = np.linalg.norm(start + displacement, axis=1)
    stress = np.zeros((len(start), 6))
    stress[:, :3] = -3.0e6 * np.exp(-touch / 0.05)[:, None]
    stress[:, 0] += 1.5e6 * np.exp(-np.abs(touch - 0.2) / 0.04)
    body = np.repeat([0, 1], len(ball))
    write_fields(folder, [(2.0e-3, {"particles": particles(start, displacement, stress, edge, body)})])
    t = np.linspace(0.0, 2.0e-3, 100)
    dip = 40.0 * np.exp(-(((t - 1.0e-3) / 2.0e-4) ** 2))
    write_history(folder, {"time": t, "kinetic": 100.0 - dip, "strain": dip, "contact": 0 * t, "residual": 0.01 * dip})
    write_summary(folder, scene="impact_3d.xml")
