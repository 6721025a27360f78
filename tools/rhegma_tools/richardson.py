"""The observed order of a value over cell sizes, and its limit for vanishing cells (L. F. Richardson, Phil. Trans. R. Soc. A 210
(1911) 307; orders and unequal ratios: P. J. Roache, J. Fluids Eng. 116 (1994) 405)."""

import math

LOWEST, HIGHEST = 0.5, 3.0  # orders that are believed: those of the method are 1 and 2
ROUNDING = 1.0e-6  # of a value; equilibrium is accepted with forces out of balance by this fraction
RESOLVED = 0.25  # as --twice: a value that moves by more is not extrapolated


class Limit:
    """Of a value for vanishing cell size. order and value: None where the order is not observable, why then says it in a
    sentence; low and high: smallest and largest of the limits that are taken for possible, or None."""

    def __init__(self, order=None, value=None, low=None, high=None, why=None):
        self.order = order
        self.value = value
        self.low = low
        self.high = high
        self.why = why


def extrapolate(sizes, values, order):
    """The limit of values a + b size^order at two sizes."""
    (coarse, fine), (one, other) = sizes, values
    return other + (other - one) / ((coarse / fine) ** order - 1.0)


def observed_order(sizes, values):
    """p of a + b size^p through values at three falling sizes; None where the values do not move in one direction or the
    order is outside 0.01 to 20."""
    first, second = values[0] - values[1], values[1] - values[2]
    if second == 0.0 or first / second <= 0.0:
        return None

    def excess(order):
        return (sizes[0] ** order - sizes[1] ** order) / (sizes[1] ** order - sizes[2] ** order) - first / second

    sizes = [size / sizes[1] for size in sizes]  # powers of metres could underflow
    low, high = 0.01, 20.0
    if excess(low) > 0.0 or excess(high) < 0.0:
        return None
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if excess(middle) > 0.0 else (middle, high)
    return 0.5 * (low + high)


def reason_against(sizes, values, order):
    """Why an order that three values give is not believed; None where it is."""
    if order is not None:
        if LOWEST <= order <= HIGHEST:
            return None
        return f"the observed order, {order:.2g}, is not between {LOWEST:g} and {HIGHEST:g}"
    first, second = values[0] - values[1], values[1] - values[2]
    if first * second <= 0.0:
        return "the values do not move in one direction"
    return "the values move by as much from size to size, or only once"


def find_limit(sizes, values):
    """The Limit of values at cell sizes, largest size first. The order is that of the three finest cells.

    low and high enclose the limits of orders 2 and 1 of the two finest cells, which --twice prints, the limit of the observed
    order, and with four or more sizes that of the three cells before the finest. Values a + b h^p have their limit in there
    for any believed p, values a + b h + c h^2 where b and c have one sign."""
    count = len(sizes)
    if count < 2:
        return Limit(why="a limit needs at least three cell sizes")
    scale = max(abs(value) for value in values[-2:])
    if scale == 0.0 or max(values) - min(values) <= ROUNDING * max(abs(value) for value in values):
        return Limit(value=values[-1], low=values[-1], high=values[-1], why="the values of all cells agree, so they have no order")
    move = abs(values[-1] - values[-2]) / scale
    if move > RESOLVED:
        return Limit(why=f"the value moves by {100.0 * move:.3g} % between the two finest cells: not resolved")
    limits = [extrapolate(sizes[-2:], values[-2:], order) for order in (1.0, 2.0)]
    if count < 3:
        return Limit(low=min(limits), high=max(limits), why=f"the order needs three cell sizes, and there are {count}")
    order = observed_order(sizes[-3:], values[-3:])
    why = reason_against(sizes[-3:], values[-3:], order)
    if why:
        return Limit(low=min(limits), high=max(limits), why=why)
    value = extrapolate(sizes[-2:], values[-2:], order)
    limits.append(value)
    if count > 3:
        before = observed_order(sizes[-4:-1], values[-4:-1])
        if before is not None and LOWEST <= before <= HIGHEST:
            limits.append(extrapolate(sizes[-3:-1], values[-3:-1], before))
    assert all(math.isfinite(limit) for limit in limits)
    return Limit(order, value, min(limits), max(limits))
