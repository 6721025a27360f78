"""Tables of error and cost, and their positions in a page of Markdown."""

from rhegma.problem import Problem

from .output_file import text_to

LIMITS = (0.1, 0.03, 0.01, 0.003)


def percent(error):
    return f"{100.0 * float(error):.2g} %"


def seconds(time):
    return f"{float(time):.2g} s" if float(time) < 10.0 else f"{float(time):.0f} s"


def table_of(rows, cell="Domain:Cell Size"):
    """A row a family and a column a size of its cells; error and processor time in each."""
    sizes = sorted({row[cell] for row in rows}, key=float, reverse=True)
    lines = [f"| | {' | '.join(f'{1000.0 * float(size):.4g} mm' for size in sizes)} |", "|:--" + "|--:" * len(sizes) + "|"]
    for family in dict.fromkeys(row["family"] for row in rows):
        own = {row[cell]: row for row in rows if row["family"] == family}
        entries = [f"{percent(own[s]['error'])}, {seconds(own[s]['processor_seconds'])}" if s in own and own[s]["error"] else ""
                   for s in sizes]
        lines.append(f"| {family} | {' | '.join(entries)} |")
    return lines


def holds(row, rows, limit, cell):
    """Whether a run is within an error, and not by chance: those of its family on smaller cells are too."""
    return all(other["error"] and float(other["error"]) <= limit for other in rows
               if other["family"] == row["family"] and float(other[cell]) <= float(row[cell]))


def cheapest(rows, cell="Domain:Cell Size"):
    """For each of the usual errors the run that reaches it in the least processor time."""
    lines = ["| error | reached by | cells | its error | processor time |", "|--:|:--|--:|--:|--:|"]
    for limit in LIMITS:
        good = [row for row in rows if holds(row, rows, limit, cell)]
        if not good:
            lines.append(f"| {percent(limit)} | none of these | | | |")
            continue
        best = min(good, key=lambda row: float(row["processor_seconds"]))
        lines.append(f"| {percent(limit)} | {best['family']} | {1000.0 * float(best[cell]):.4g} mm | {percent(best['error'])} "
                     f"| {seconds(best['processor_seconds'])} |")
    return lines


def renew(page, name, lines):
    """Puts lines between the marks <!-- table NAME --> and <!-- end --> of a page."""
    try:
        with open(page, encoding="utf-8") as file:
            text = file.read()
    except OSError as error:
        raise Problem(f"{page} can't be read ({error.strerror}).")
    mark, end = f"<!-- table {name} -->\n", "<!-- end -->"
    begin = text.find(mark)
    stop = text.find(end, begin)
    if begin < 0 or stop < 0:
        raise Problem(f"{page} has no position for the table {name}; write {mark.strip()} and {end} there.")
    renewed = text[: begin + len(mark)] + "\n" + "\n".join(lines) + "\n\n" + text[stop:]
    with text_to(page) as file:
        file.write(renewed)
