"""The table of cracks and their fronts: state, G and K with their estimated errors, growth."""

from . import style
from .answers import is_number
from .html_text import element
from .inner_nodes import leaves_out
from .report_facts import all_fronts, grown_by, largest_release, short

MODES = ("K_I", "K_II", "K_III")


SMALL = 1.0e-9  # of the largest value of a kind: rounding, printed as 0


class Column:
    """heading: without unit; unit: with room for a prefix; values: a number or None of each front; errors: the same, of the
    estimates; ranges: (lowest, highest) along a front, or None; range_errors: the estimates of their errors; largest: of all columns
    with which this one is compared."""

    def __init__(self, heading, unit, values, errors=None, ranges=None, largest=None, range_errors=None):
        self.heading, self.values = heading, values
        unknown = [None] * len(values)
        self.errors, self.ranges, self.range_errors = errors or unknown, ranges or unknown, range_errors or unknown
        self.largest = largest_of(values) if largest is None else largest
        root = " √m" if unit.endswith("√m") else ""
        self.factor, scaled = style.scale(self.largest, unit.replace(" √m", "")) if unit not in ("m/s", "") else (1.0, unit)
        self.unit = scaled + root

    @property
    def empty(self):
        return not any(is_number(value) for value in self.values)

    def title(self):
        return f"{self.heading} [{self.unit}]" if self.unit else self.heading

    def text(self, value):
        return "0" if abs(value) <= SMALL * self.largest else short(value * self.factor)

    def cell(self, i):
        """A front's value; its range along the front in a line below. The mean of a mode that changes its sign along the front is near
        zero and says nothing: the range alone is written."""
        if changes_sign(self.ranges[i]):
            text = f"{self.text(self.ranges[i][0])} to {self.text(self.ranges[i][1])}"
            return text + (f" ± {self.range_errors[i] * self.factor:.2g}" if is_number(self.range_errors[i]) else "")
        if not is_number(self.values[i]):
            return "-"
        text = self.text(self.values[i])
        if is_number(self.errors[i]):
            text += f" ± {self.errors[i] * self.factor:.2g}"
        if self.ranges[i] is None:
            return text
        return [text, element("br"), f"({self.text(self.ranges[i][0])} to {self.text(self.ranges[i][1])})"]


def changes_sign(pair):
    return pair is not None and pair[0] < 0.0 < pair[1]


def largest_of(*lists):
    return max((abs(value) for values in lists for value in values if is_number(value)), default=0.0)


def state_of(front):
    """What became of a front, in words."""
    status = front.get("status")
    if front.get("stopped"):
        return "stopped numerically"
    arrival = (front.get("arrival") or {}).get("what")
    if status == "ended" and arrival:
        return str(arrival)
    if status:
        return str(status)
    return "closed" if front.get("closed") else "growth not computed"


def no_longer_exists(front):
    """Whether a front has ended, and its G and K are zero because it has no nodes any more."""
    values = [front[key] for key in ("G_J", "G_closure", *MODES) if is_number(front.get(key))]
    return bool(front.get("ended")) and bool(values) and not any(values)


def without_values(front):
    """A front without the values at the end of the run; the largest ones stay."""
    return {key: value for key, value in front.items() if not key.startswith(("G_J", "G_closure", "K_"))}


def columns_of(fronts, in_equilibrium):
    """Columns of numbers of fronts [(crack, number, entry)]. in_equilibrium: times are those of load steps and are left out"""
    entries = [without_values(front) if no_longer_exists(front) else front for _, _, front in fronts]

    def values(key):
        return [front.get(key) for front in entries]

    def ranges(key):
        pairs = [(front.get(f"{key}_min"), front.get(f"{key}_max")) for front in entries]
        return [pair if is_number(pair[0]) and is_number(pair[1]) else None for pair in pairs]

    releases, most = values("G_J"), [largest_release(front) for front in entries]
    largest, largest_k = largest_of(releases, most), largest_of(*(values(mode) for mode in MODES), *(pair or () for mode in MODES for pair in ranges(mode)))
    along = any(is_number(front.get("G_J_max")) for _, _, front in fronts)  # in 3D, where the mean along a front and its largest node differ
    inner = any(leaves_out(front) for _, _, front in fronts)
    mean, node = ("mean ", " of an inner node" if inner else " of a front node") if along else ("", "")
    columns = [Column(f"{mean}G", "J/m²", releases, values("G_J_error_estimate"), ranges("G_J"), largest)]
    if not (in_equilibrium and most == releases):  # of one load step
        columns.append(Column(f"largest {mean}G", "J/m²", most, largest=largest))
    for mode in MODES:
        heading = mode + " along the front" if all(changes_sign(pair) for pair in ranges(mode)) else mean + mode
        columns.append(Column(heading, "Pa √m", values(mode), values(f"{mode}_error_estimate"), ranges(mode), largest_k, values("K_extremes_error_estimate")))
    columns.append(Column(f"largest G{node} / toughness", "", values("closest_to_initiation")))
    if inner:
        columns.append(Column("largest G of a node at the surface / toughness", "", values("closest_at_surface")))
    if not in_equilibrium:
        columns += [Column("initiated at", "s", values("initiated")), Column("mean speed", "m/s", values("mean_speed"))]
    columns.append(Column("grew by", "m", [grown_by(front) for front in entries]))
    return [column for column in columns if not column.empty]


def positions(fronts):
    """(heading, texts) of the positions of fronts."""
    known = [front.get("position") or [] for _, _, front in fronts]
    factor, unit = style.scale(max((abs(x) for position in known for x in position if is_number(x)), default=0.0), "m")
    texts = [", ".join(f"{x * factor:.4g}" if abs(x * factor) > 1e-6 else "0" for x in position if is_number(x)) or "-" for position in known]
    return f"position [{unit}]", texts


def front_table(summary):
    """(head, rows, indices of columns of numbers) of all fronts, those with the largest G first; None where there are none."""
    fronts = all_fronts(summary)
    if not fronts:
        return None
    fronts.sort(key=lambda entry: -(largest_release(entry[2]) or 0.0))
    columns = columns_of(fronts, "equilibrium" in summary)
    head = ["crack and front", "state", *(column.title() for column in columns)]
    rows = [[f"{name}, {number}", state_of(front), *(column.cell(i) for column in columns)] for i, (name, number, front) in enumerate(fronts)]
    if all(len(front.get("position") or []) < 3 for _, _, front in fronts):  # in 3D it is a mean along the front
        where, texts = positions(fronts)
        head.append(where)
        rows = [row + [text] for row, text in zip(rows, texts)]
    return head, rows, range(2, 2 + len(columns))
