#!/usr/bin/env python3
"""The highest temperature under a disk of heat that moves over an infinite plate: the reference value of
xml_inputs/studies/hot_spot.xml.

The rise at x is the integral over the past s of P / (rho c) times the fraction of a disk's heat that has come to a
point of it: of heat let go on a disk of radius r at distance d, after s, F / (pi r^2), F the chance that a normally
distributed point around the point with variance 2 D s in each direction lies in the disk (noncentral chi-squared)."""

import numpy
from scipy.optimize import minimize_scalar
from scipy.stats import ncx2

POWER, CAPACITY, CONDUCTIVITY, RADIUS, SPEED, TIME = 1e5, 7800.0 * 500.0, 40.0, 0.0025, 0.035, 2.0
DIFFUSIVITY = CONDUCTIVITY / CAPACITY


def share(distance, age):
    """1 well inside of the disk, 0 well outside of it."""
    width = 2 * DIFFUSIVITY * age
    inside = (RADIUS - distance) / numpy.sqrt(width)
    found = numpy.where(inside > 0, 1.0, 0.0)
    near = numpy.abs(inside) < 8
    found[near] = ncx2.cdf(RADIUS**2 / width[near], 2, distance[near] ** 2 / width[near])
    return found


def rise(ahead):
    """At a point ahead of the disk's middle when it has moved for TIME; age = u^2 for the square root at its start."""
    points, weights = numpy.polynomial.legendre.leggauss(200)
    edges = numpy.concatenate([[0.0], numpy.geomspace(1e-3, numpy.sqrt(TIME), 40)])
    total = 0.0
    for begin, end in zip(edges[:-1], edges[1:]):
        u = 0.5 * (end - begin) * (points + 1) + begin
        values = 2 * u * share(numpy.abs(ahead + SPEED * u**2), u**2)
        total += 0.5 * (end - begin) * numpy.sum(weights * values)
    return POWER / CAPACITY / (numpy.pi * RADIUS**2) * total


best = minimize_scalar(lambda x: -rise(x), bounds=(-2 * RADIUS, 0.0), method="bounded", options={"xatol": 1e-9})
print(f"{-best.fun:.3f} K, {-best.x / RADIUS:.3f} radii behind the middle of the disk")
