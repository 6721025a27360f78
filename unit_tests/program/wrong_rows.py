"""What rows of wrong scenes are made of.

Each row is a name, a scene, and the messages that are expected: the path of the section and words of the message, by
which it says what is wrong and what to write instead.
"""

NAN, INF = float("nan"), float("inf")

def box(lower, upper, **more):
    return dict({"Material": "Polymer", "Shape": "Box", "Lower Corner": lower, "Upper Corner": upper}, **more)


def reference(quantity):
    return {"Wanted": {"Quantity": quantity, "Value": 1.0, "Tolerance": 0.1, "Source": "none"}}


def one(where, *words):
    return [(where, words)]


MODULUS = "Materials > Polymer > Young Modulus"
RATIO = "Materials > Polymer > Poisson Ratio"
DENSITY = "Materials > Polymer > Density"
NOTCH = "Cracks > Notch > Points"
HISTORY = "Boundaries > Pull > History"
