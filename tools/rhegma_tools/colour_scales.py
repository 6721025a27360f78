"""Colours of fields: of numbers that name something, such as pieces and bodies, one colour a number; of others a continuous scale."""

import numpy as np
from matplotlib.colors import BoundaryNorm, ListedColormap, Normalize, TwoSlopeNorm

from . import style

MOST = 20  # numbers with a colour each; of more the scale is continuous
UNKNOWN = -1  # of what has no number
GREY = "#C4C4C4"
MORE = ["#F0E442", "#332288", "#882255", "#44AA99", "#999933", "#AA4499", "#661100", "#6699CC", "#88CCEE", "#DDCC77", "#CC6677", "#117733", "#777777"]
COLOURS = style.COLOURS + MORE  # one for each of MOST numbers


STRESSES = ("principal", "mises", "stress", "von_mises", "principal_stress", "energy_density")
REST = 3.0  # per cent of all particles that may be beyond the colours on either side
FRONT = 98.0  # per cent of the particles at fronts that are within them
WORTH = 1.05  # times the colours: values beyond are named


def limits_of(values, at_fronts=None):
    """Lowest and highest value that has a colour of its own: the extreme half per cent at each end saturates, so that it does not hide the rest.
    Stresses at supports and at edges of voxels depend on the cells alone and may be larger than at the fronts of cracks: with values at these, colours end
    there, but leave out at most REST per cent of the particles at each end."""
    low, high = np.percentile(values, [0.5, 99.5])
    if at_fronts is not None and len(at_fronts):
        least, most = np.percentile(values, [REST, 100.0 - REST])
        low, high = max(low, min(np.percentile(at_fronts, 100.0 - FRONT), least)), min(high, max(np.percentile(at_fronts, FRONT), most))
    return low, high


def beyond(values, norm):
    """What the colours leave out, in words; empty where it is next to nothing."""
    texts = []
    for share, extreme, word in ((np.mean(values > norm.vmax), float(np.max(values)), "above"), (np.mean(values < norm.vmin), float(np.min(values)), "below")):
        if share > 0.0 and abs(extreme) > WORTH * max(abs(norm.vmin), abs(norm.vmax)):
            texts.append(f"{100.0 * share:.2g} % {word}, up to " + (f"{extreme:.0f}" if abs(extreme) >= 1000.0 else f"{extreme:.3g}"))
    return "; ".join(texts)


def colour_scale(values, at_fronts=None):
    """Map and limits (limits_of): diverging about zero where both signs matter."""
    low, high = limits_of(values, at_fronts)
    if high <= low:
        low, high = float(values.min()), float(values.max())
    if high <= low:
        low, high = low - 1.0, high + 1.0
    if low < -0.1 * abs(high) and high > 0.1 * abs(low):
        return "RdBu_r", TwoSlopeNorm(0.0, -max(-low, high), max(-low, high))
    if low >= 0.0 or -low <= 0.1 * high:
        return "viridis", Normalize(min(low, 0.0) if low < 0.25 * high else low, high)
    return "viridis", Normalize(low, high)


def heat_scale(values):
    """Map and limits of temperatures: from the lowest to the highest, for the peak is what one looks for."""
    low, high = float(values.min()), float(values.max())
    return "inferno", Normalize(low, high if high > low else low + 1.0)


def discrete_scale(numbers):
    """Map and limits of whole numbers, sorted and different: a colour a number, grey for UNKNOWN."""
    known = [number for number in numbers if number != UNKNOWN]
    colours = {number: COLOURS[i] for i, number in enumerate(known)}
    between = 0.5 * (np.array(numbers[:-1]) + np.array(numbers[1:]))
    bounds = np.concatenate([[numbers[0] - 0.5], between, [numbers[-1] + 0.5]])
    norm = BoundaryNorm(bounds, len(numbers))
    norm.numbers = [int(number) for number in numbers]
    return ListedColormap([colours.get(number, GREY) for number in numbers]), norm


def scale_of(quantity, values, whole=False, near=None):
    """Map and limits of the values of a quantity. whole: whether the field that was asked for has whole numbers; near: which of the values are at
    crack fronts (front_region.at_fronts). The limits have a `note` on what they leave out."""
    if whole and quantity not in ("principal", "mises", "temperature"):
        numbers = np.unique(values)
        if len(numbers) <= MOST:
            return discrete_scale(numbers)
    if quantity == "temperature":
        return heat_scale(values)
    stressed = near is not None and quantity.partition(":")[0] in STRESSES
    colours, norm = colour_scale(values, values[near] if stressed else None)
    norm.note = beyond(values, norm)
    return colours, norm


def add_bar(figure, mappable, axes, label, extend="both", **look):
    """The colour bar of a scale; of whole numbers it names them."""
    numbers = getattr(mappable.norm, "numbers", None)
    if numbers is None:
        bar = figure.colorbar(mappable, ax=axes, extend=extend, **look)
    else:
        bounds = mappable.norm.boundaries
        bar = figure.colorbar(mappable, ax=axes, spacing="uniform", ticks=0.5 * (bounds[:-1] + bounds[1:]), **look)
        bar.ax.set_yticklabels(["unknown" if number == UNKNOWN else str(number) for number in numbers])
        bar.ax.tick_params(length=0)
    note = getattr(mappable.norm, "note", "")
    bar.set_label(label + (f"\n{note}" if note else ""), labelpad=8.0)
    return bar
