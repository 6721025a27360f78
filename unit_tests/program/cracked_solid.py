"""The equations of ViscoSCRAM at small strain, in rates: those of Bennett, Haberman, Johnson, Asay, Henson (J. Mech. Phys. Solids 46 (1998) 2303) and
Hackett, Bennett (Int. J. Numer. Methods Eng. 49 (2000) 1191), written from memory of these papers and compared with published code that implements them
(docs/explanation/laws-for-rates.md). They share no code with the program, but the same reading of the papers."""

import numpy

ONE = numpy.eye(3)

# PBX 9501: xml_inputs/materials/rubbers-and-energetics.xml has the sources.
MODULI = [173.9e6, 521.2e6, 908.5e6, 687.5e6]  # [Pa] of the elements that relax
RATES = [7.32e3, 7.32e4, 7.32e5, 2e6]  # [1/s]
LASTING = 350e6  # [Pa]


class CrackedSolid:
    """Constants, and the rates of a state: deviators s of the elements, the lasting one first, and the radius c of the cracks."""

    def __init__(self, poisson=0.3, radius=3e-5, scale=1e-3, toughness=5e5, friction=0.35, exponent=10.0, speed=300.0, density=1840.0,
                 moduli=MODULI, rates=RATES, lasting=LASTING):
        self.moduli = numpy.array([lasting, *moduli])
        self.rates = numpy.array([0.0, *rates])
        self.poisson, self.radius, self.scale, self.toughness, self.friction = poisson, radius, scale, toughness, friction
        self.exponent, self.speed, self.density = exponent, speed, density
        self.shear = self.moduli.sum()
        self.bulk = 2 * self.shear * (1 + poisson) / (3 * (1 - 2 * poisson))

    def parameters(self):
        """Those of the program, which wants times and fractions."""
        return {"Model": "ViscoSCRAM", "Density": self.density, "Young Modulus": 2 * self.shear * (1 + self.poisson), "Poisson Ratio": self.poisson,
                "Relaxation Times": list(1 / self.rates[1:]), "Shear Fractions": list(self.moduli[1:] / self.shear),
                "Initial Crack Radius": self.radius, "Crack Length Scale": self.scale, "Crack Toughness": self.toughness,
                "Crack Friction": self.friction, "Crack Growth Exponent": self.exponent, "Maximum Crack Speed": self.speed}

    def growth(self, c, s, mean):
        """dc/dt [m/s]. s: deviator, mean: mean stress, positive in tension [Pa]"""
        tension = max(mean, 0.0)
        K = numpy.sqrt(1.5 * numpy.pi * c * (numpy.tensordot(s, s) + 3 * tension**2))
        slope = numpy.sqrt(45 / (2 * (3 - 2 * self.friction**2))) * self.friction
        x = slope * max(-mean, 0.0) * numpy.sqrt(c) / self.toughness
        K0 = self.toughness * numpy.sqrt(1 + numpy.pi * x * (1 + x))
        change = K0 * numpy.sqrt(1 + 2 / self.exponent)
        K1 = change * (1 + self.exponent / 2) ** (1 / self.exponent)
        return self.speed * (K / K1) ** self.exponent if K < change else self.speed * (1 - (K0 / K) ** 2)

    def rates_of(self, elements, c, mean, D, W=0 * ONE):
        """Rates of the elements' deviators and of c. D, W: rate of deformation and spin; the rates of tensors are Jaumann's."""
        s = elements.sum(axis=0)
        ratio = (c / self.scale) ** 3
        dc = self.growth(c, s, mean)
        relaxing = self.rates[:, None, None] * elements
        shape = D - numpy.trace(D) / 3 * ONE
        ds = (2 * self.shear * shape - relaxing.sum(axis=0) - 3 * ratio * dc / c * s) / (1 + ratio)
        cracks = (3 * ratio * dc / c * s + ratio * ds) / (2 * self.shear)  # rate of the strain of the cracks
        rates = 2 * self.moduli[:, None, None] * (shape - cracks) - relaxing
        return rates + W @ elements - elements @ W, dc

    def strained(self, gradient, duration, steps):
        """Cauchy stress and radius after a constant gradient of the velocity, by the classical method of Runge and Kutta. [Pa], [m]"""
        D, W = 0.5 * (gradient + gradient.T), 0.5 * (gradient - gradient.T)
        h = duration / steps
        y, c = numpy.zeros((len(self.moduli), 3, 3)), self.radius
        for step in range(steps):
            rate = lambda part, dy, dc: self.rates_of(y + part * h * dy, c + part * h * dc,  # noqa: E731
                                                      self.bulk * numpy.trace(D) * (step + part) * h, D, W)
            a = rate(0.0, 0 * y, 0.0)
            b = rate(0.5, *a)
            d = rate(0.5, *b)
            e = rate(1.0, *d)
            y = y + h / 6 * (a[0] + 2 * b[0] + 2 * d[0] + e[0])
            c = c + h / 6 * (a[1] + 2 * b[1] + 2 * d[1] + e[1])
        return y.sum(axis=0) + self.bulk * numpy.trace(D) * duration * ONE, c

    def pressed(self, rate, strain):
        """Uniaxial compression without stress across, at a constant rate: strains, stresses along [Pa] and radii [m], the first two positive."""
        from scipy.integrate import solve_ivp

        axis = numpy.diag([-1.0, 0.5, 0.5])  # direction of all deviators

        def slope(time, state):
            elements, c = state[:-1, None, None] * axis, state[-1]
            mean = -0.5 * state[:-1].sum()  # s = t diag(-1, 1/2, 1/2) with the mean stress -t/2: nothing across, -3/2 t along
            # The deviator of D is d diag(-1, 1/2, 1/2): d follows from the rate along and that of the volume, 3 K tr D = -3/2 dt.
            # Its part in the rate of t is linear.
            def of(d):
                rates, dc = self.rates_of(elements, c, mean, d * axis)
                return rates[:, 1, 1] * 2.0, dc
            free, dc = of(0.0)
            held = of(1.0)[0] - free
            k = 1 / (6 * self.bulk)  # rate = d - tr D / 3, tr D = -dt / (2 K)
            d = (rate - k * free.sum()) / (1 + k * held.sum())
            return numpy.append(free + held * d, dc)

        start = numpy.append(numpy.zeros(len(self.moduli)), self.radius)
        times = numpy.linspace(0.0, strain / rate, 2001)
        found = solve_ivp(slope, (0.0, times[-1]), start, "LSODA", times, rtol=1e-9, atol=numpy.append(numpy.full(len(self.moduli), 1.0), 1e-12))
        return rate * times, 1.5 * found.y[:-1].sum(axis=0), found.y[-1]
