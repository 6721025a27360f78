"""How all pictures look: colours that colour-blind readers can distinguish, SI units with prefixes, no clutter."""

import contextlib
import math
import os

import matplotlib

from rhegma.problem import Problem

from .output_file import replacing

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the back end is chosen first)

# The palette of Okabe and Ito (2008), without its yellow, which is too pale for lines on paper.
COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00", "#000000"]
INK = "#222222"
QUIET = "#777777"
ALARM = "#CC0000"  # results that are not the physics': fronts that stopped numerically
DOTS_PER_INCH = 160

plt.rcParams.update(
    {
        "font.size": 10,
        "axes.titlesize": 11,
        "axes.titleweight": "bold",
        "axes.titlelocation": "left",
        "axes.labelcolor": INK,
        "axes.edgecolor": "#555555",
        "axes.linewidth": 0.8,
        "axes.spines.top": False,
        "axes.spines.right": False,
        "axes.formatter.useoffset": False,
        "axes.grid": True,
        "grid.color": "#DDDDDD",
        "grid.linewidth": 0.6,
        "axes.axisbelow": True,
        "lines.linewidth": 1.6,
        "legend.frameon": False,
        "legend.fontsize": 9,
        "figure.facecolor": "white",
    }
)

PREFIXES = [(1e9, "G"), (1e6, "M"), (1e3, "k"), (1.0, ""), (1e-3, "m"), (1e-6, "µ"), (1e-9, "n")]


def scale(largest, unit):
    """Factor and unit with the prefix that makes a magnitude a number of one to three digits."""
    if not math.isfinite(largest) or largest <= 0.0:
        return 1.0, unit
    for factor, prefix in PREFIXES:
        if largest >= factor:
            return 1.0 / factor, prefix + unit
    return 1.0 / PREFIXES[-1][0], PREFIXES[-1][1] + unit


def save(figure, path):
    """Writes a picture and closes it. path: of its file, or an open file, which gets a PNG"""
    named = isinstance(path, (str, os.PathLike))
    ending = named and os.path.splitext(path)[1][1:].lower() or "png"
    try:
        if ending not in figure.canvas.get_supported_filetypes():
            raise Problem(f"{path}: the name of a picture ends with .png, .pdf or .svg.")
        with replacing(path) if named else contextlib.nullcontext(path) as temporary:
            figure.savefig(temporary, format=ending, dpi=DOTS_PER_INCH, bbox_inches="tight", pad_inches=0.15)
    finally:
        plt.close(figure)
