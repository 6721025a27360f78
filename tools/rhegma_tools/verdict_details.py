"""What a page adds to whether a crack runs: stress intensities, the modes of shear, and the forces at which cracks start."""

from .answers import is_number
from .report_facts import readable, short

NAMED = 4  # forces named in a line
LEAST_FORCE = 0.01  # of the largest: what is less is the reaction of a guide
SHEAR, MIXED = 0.05, 0.10  # of K_I: from which on a mode of shear is named, and the criterion of 3D


def intensity_text(part, release):
    """" (K of G = 8.3 MPa √m, K_Ic = 14 MPa √m)" of a G over the toughness; empty where the scene gives no K_Ic. part: of the summary, with `K_Ic`"""
    critical = (part or {}).get("K_Ic")
    if not is_number(critical) or not is_number(release) or release <= 0.0:
        return ""
    return f" (K of G = {readable(critical * release**0.5, 'Pa √m')}, {short(release**0.5)} of K_Ic = {readable(critical, 'Pa √m')})"


def shear_text(front, when="At the end"):
    """A sentence on the modes of shear of a front at the end, where they are noticeable; in 3D also that G alone is compared."""
    ratios = [(name, abs(front[f"{name}_over_K_I"])) for name in ("K_II", "K_III") if is_number(front.get(f"{name}_over_K_I"))]
    named = [f"{name} is {100.0 * ratio:.3g} % of K_I" for name, ratio in ratios if ratio >= SHEAR]
    if not named:
        return ""
    spatial = any(name == "K_III" for name, _ in ratios) and any(ratio >= MIXED for _, ratio in ratios)
    return f" {when} {' and '.join(named)}{'; in 3D only G is compared with the toughness' if spatial else ''}."


def size_of(force):
    return sum(x * x for x in force if is_number(x)) ** 0.5 if isinstance(force, list) else 0.0


def force_text(summary, factor=None):
    """A sentence on the forces of loads and supports as the first crack starts; empty where they are not known. factor: of the loads then"""
    sizes = sorted(((size_of(force), str(name)) for name, force in (summary.get("forces_at_start") or {}).items()), key=lambda pair: -pair[0])
    sizes = [(size, name) for size, name in sizes if size > LEAST_FORCE * sizes[0][0]]
    if not sizes:
        return ""
    more = f" and {len(sizes) - NAMED} more" if len(sizes) > NAMED else ""
    named = ", ".join(f"{name} {readable(size, 'N')}" for size, name in sizes[:NAMED])
    at = f"{short(factor)} times the loads" if is_number(factor) else "that load"
    return f" Forces at {at}: {named}{more}."
