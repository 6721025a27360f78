#!/usr/bin/env python3
"""Half length and burnt mass of a crack that its burning gas drives, in equilibrium, in a plate of finite width.

With a constant rate of burning dm/dt = 4 rho r a, in units of the mass mu = m R T / (2 Gc), d mu/dt = a / tau. From p V = m R T,
K = p sqrt(pi a sec(pi a / W)) (Feddersen) and V = (2 / p) int 2 K^2 / E' da (the work of the pressure that is released),

    mu = (Gc(v) / Gc) (2 / (a sec(pi a / W))) int_0^a x sec(pi x / W) dx,

a for an infinite plate with a constant toughness. The speed v of the front is that of the growth, a / tau.

    gas_driven_crack.py [START [TAU [END [WIDTH [SPEED]]]]]    [m, s, s, m, m/s]; Gc(v) = Gc (1 + v / SPEED)
"""
import math
import sys

start, tau, end, width, speed = [float(v) for v in sys.argv[1:]] + [7.5e-3, 1.6e-3, 3.3578e-3, 0.2, 1000.0][len(sys.argv) - 1:]


def secant(a):
    return 1 / math.cos(math.pi * a / width)


def mass(a, v):
    n = 400
    integral = sum((i + 0.5) * a / n * secant((i + 0.5) * a / n) for i in range(n)) * a / n
    return (1 + v / speed) * 2 * integral / (a * secant(a))


a, mu = start, mass(start, 0.0)
time, steps = mu * tau / a, 1000
dt = (end - time) / steps
print("initiated at %.4g s" % time)
for _ in range(steps):
    mu += dt * a / tau
    low, high = a, 1.05 * a
    if mass(low, low / tau) < mu:
        for _ in range(40):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if mass(middle, middle / tau) < mu else (low, middle)
        a = low
print("half length %.5g m, m R T / (2 Gc) %.5g m, ratio %.4f" % (a, mu, a / mu))
