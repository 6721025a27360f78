"""A beam on two rollers that is struck in its middle: finite elements of a Timoshenko beam, and contact by closed forms.

Nothing of it is shared with the program. Elements have two nodes with a deflection and a rotation each, reduced integration and lumped
masses; central differences in time. A weight is a mass point. Rollers and the nose of the weight press on the beam where they touch.
Its local compression is that of a half-plane next to a cylinder, as far as the middle of the beam: Johnson, Contact Mechanics (Cambridge
1985), section 5.6, eqs. 5.56 and 5.57, in plane stress. The shear coefficient 10 (1 + nu) / (12 + 11 nu) is that of Cowper, J. Appl.
Mech. 33 (1966) 335.
"""

import numpy


class Press:
    """The force [N] of a cylinder on a plane as a function of their approach [m]; both have the thickness [m]."""

    def __init__(self, radius, depth, thickness, plane, cylinder):
        force = numpy.geomspace(1e-3, 1e5, 4000)
        line = force / thickness
        (young, poisson), (other_young, other_poisson) = plane, cylinder
        half_width = numpy.sqrt(4.0 * line * radius / numpy.pi * (1.0 / young + 1.0 / other_young))
        approach = line / (numpy.pi * young) * (2.0 * numpy.log(2.0 * depth / half_width) - poisson)
        approach += line / (numpy.pi * other_young) * (2.0 * numpy.log(2.0 * radius / half_width) - other_poisson)
        self.force, self.approach = numpy.append(0.0, force), numpy.append(0.0, approach)

    def __call__(self, approach):
        return numpy.interp(approach, self.approach, self.force) if approach > 0.0 else 0.0


class StruckBeam:
    """SI units; elastic constants are pairs of Young's modulus and Poisson's ratio."""

    elements = 96
    step = 2e-8  # s: a fifth of what an element of 1 mm allows, and short against the time of a contact

    def __init__(self, length, height, thickness, density, beam, steel):
        self.length, self.height, self.thickness = length, height, thickness
        self.young, self.poisson, self.density, self.steel = *beam, density, steel

    def hit(self, span, rollers, gap_of_rollers, nose, gap, speed, mass, end):
        """Times, forces of the weight, and forces of a roller, each microsecond. Rollers and nose are radii [m]."""
        h, nodes = self.length / self.elements, self.elements + 1
        area, inertia = self.thickness * self.height, self.thickness * self.height**3 / 12.0
        bending = self.young * inertia / h
        shear = 10.0 * (1.0 + self.poisson) / (12.0 + 11.0 * self.poisson) * self.young / (2.0 * (1.0 + self.poisson)) * area
        masses, inertias = numpy.full(nodes, self.density * area * h), numpy.full(nodes, self.density * inertia * h)
        masses[[0, -1]] *= 0.5
        inertias[[0, -1]] *= 0.5
        x = numpy.linspace(-0.5, 0.5, nodes) * self.length
        middle, ends = nodes // 2, [int(numpy.argmin(abs(x + side * 0.5 * span))) for side in (1, -1)]
        of_nose, of_roller = (Press(radius, 0.5 * self.height, self.thickness, (self.young, self.poisson), self.steel)
                              for radius in (nose, rollers))
        deflection, rotation, velocity, spin = (numpy.zeros(nodes) for _ in range(4))
        place, fall, found, per_output = gap, -speed, [], round(1e-6 / self.step)
        for number in range(round(end / self.step)):
            moment = bending * numpy.diff(rotation)
            slide = shear * (numpy.diff(deflection) / h - 0.5 * (rotation[1:] + rotation[:-1]))
            force, couple = numpy.zeros(nodes), numpy.zeros(nodes)
            force[:-1] += slide
            force[1:] -= slide
            couple[:-1] += moment + 0.5 * h * slide
            couple[1:] += 0.5 * h * slide - moment
            strike = of_nose(deflection[middle] - place)
            force[middle] -= strike
            for node in ends:
                support = of_roller(-deflection[node] - gap_of_rollers)
                force[node] += support
            if number % per_output == 0:
                found.append((number * self.step, strike, support))
            velocity += self.step * force / masses
            spin += self.step * couple / inertias
            deflection += self.step * velocity
            rotation += self.step * spin
            fall += self.step * strike / mass
            place += self.step * fall
        return numpy.array(found).T
