"""One HTML page of a run that needs no other file and no network."""

import os

import numpy as np

from rhegma.fields import read_fields
from rhegma.history import read_history
from rhegma.problem import Problem
from rhegma.summary import read_summary

from . import report_facts as facts
from .extreme_rows import HEAD, answers_without_peak, extreme_rows
from .front_table import front_table
from .html_text import Markup, data_block, element, folded, markup, picture, table
from .output_file import replacing, target_of
from .reading import attempt
from .report_pictures import field_pictures, film, front_maps, front_pictures, history_pictures, seconds
from .report_verdict import so_far, verdict
from .style import COLOURS
from .whole_folder import Found, check_scene, how_it_stands, read_manifest, went_to_its_end
from .zoom_data import rounded

HERE = os.path.dirname(os.path.realpath(__file__))
LARGEST_PAGE = 10_000_000  # bytes, as far as fewer frames of the film can make it so
FEWEST_FILM = 1_000_000  # bytes that a film may have on any page
OPEN_ROWS = 20  # of the table of fronts; more are folded
NUMBERS = 150_000  # of the columns that can be chosen, together
LARGEST_SCENE = 500_000  # characters of the scene that are shown
LONGEST_LIST = 300  # columns of the history listed in words


class Run:
    """What a folder holds. summary: {} where there is none; history: None where it has no sample; problems: why parts are missing;
    scene: path of its file, or None; twice: of rhegma --twice, or None."""

    def __init__(self, folder):
        self.folder, self.problems = folder, []
        self.twice, run = twice_of(folder)
        self.run = run
        self.summary = facts.sound(self.read(read_summary) or {}, facts.SHAPE, "summary.json", self.problems)
        self.history = self.read(read_history)
        self.fields = self.read(read_fields)
        found = Found()
        manifest = attempt(read_manifest, run, run, found=found, failed={})
        self.ended = bool(manifest.get("ended")) or (not manifest and bool(self.summary))
        self.state = None if self.ended else how_it_stands(run, [])
        attempt(check_scene, run, run, manifest, found=found)
        self.problems += found.faults
        self.scene = next((path for path in ((manifest.get("scene") or {}).get("path"), self.summary.get("scene"))
                           if isinstance(path, str) and os.path.isfile(path)), None)
        if not (self.summary or manifest or self.history is not None or self.fields is not None):
            more = f" ({self.problems[0]})" if self.problems else ""
            raise Problem(f"{folder} has no summary.json, history.csv or fields.h5 that can be read; give the folder that a run wrote{more}.")
        self.title = facts.scene_name(self.summary if self.summary else {"scene": (manifest.get("scene") or {}).get("path")}, run)

    def read(self, reader):
        """What a reader gives; where it can't, None, and the problem is kept."""
        try:
            return reader(self.run)
        except Problem as problem:
            self.problems.append(str(problem))
            return None

    def draw(self, what, *arguments):
        """Pictures that a function gives; where it can't, none, and the problem is kept."""
        try:
            return what(*arguments)
        except Problem as problem:
            if str(problem) not in self.problems:
                self.problems.append(str(problem))
            return []

    @property
    def dimension(self):
        if self.fields is not None:
            return self.fields.dimension
        momentum = self.summary.get("momentum")
        return len(momentum) if isinstance(momentum, list) and len(momentum) in (2, 3) else None


def twice_of(folder):
    """(twice.json or None, folder of the run): of rhegma --twice the run with half the cell size, which is the more accurate one."""
    path = os.path.join(folder, "twice.json")
    runs = [os.path.join(folder, name) for name in ("half", "as_is")]
    run = next((run for run in runs if os.path.isdir(run)), None)
    if os.path.exists(os.path.join(folder, "history.csv")) or not os.path.exists(path) or run is None:
        return None, folder
    return facts.sound(read_summary(folder, "twice.json"), {"answers": [{}]}, path, []), run


def read_text(name):
    with open(os.path.join(HERE, name), encoding="utf-8") as file:
        return file.read()


def notices(run):
    """Warnings of the run, its state where it has not ended, and what is missing on the page."""
    summary, parts = run.summary, []
    status = str(summary.get("status") or "")
    if run.state:
        parts.append(element("p", element("strong", run.state), " The page shows the run so far.", class_="alarm"))
    elif status and status != "finished":
        parts.append(element("p", element("strong", f"Status: {status}"), class_="alarm"))
    warnings = summary.get("warnings") or []
    if warnings:
        parts.append(element("p", element("strong", f"{len(warnings)} warning{'' if len(warnings) == 1 else 's'} of the run")))
        parts.append(element("ul", [element("li", warning) for warning in warnings]))
    if run.problems:
        parts.append(element("p", element("strong", "Missing or inconsistent")))
        parts.append(element("ul", [element("li", problem) for problem in run.problems]))
    if not parts:
        return element("p", "No warnings.", class_="calm")
    return element("div", parts, class_="notices")


def fact_list(pairs):
    return element("dl", [element("div", element("dt", name), element("dd", text)) for name, text in pairs])


def head_of(run):
    parts = [element("h1", run.title)]
    status = run.summary.get("status") if run.ended else None
    parts.append(element("p", f"Status: {status}" if status else "Status: not ended", class_="status"))
    parts.append(notices(run))
    parts.append(fact_list(facts.run_facts(run.summary or {"scene": run.scene}, run.dimension)))
    if run.twice is not None:
        parts.append(element("p", f"This page shows the run in {os.path.basename(run.run)} of rhegma --twice, and its comparison with the other."))
    return element("header", parts)


def of_which_loads(summary):
    """For which loads the values of fronts are, in words."""
    factor = (summary.get("propagation") or {}).get("load_factor")
    if not isinstance(factor, (int, float)):
        return "Values at the end of the run"
    return f"Values at the end of the run, at {factor:.4g} times the loads of the scene (K is in proportion to them in linear elastic bodies, G to their square)"


def fronts_part(summary):
    """The table of fronts; of many, the rest is folded."""
    found = front_table(summary)
    if found is None:
        return None
    head, rows, numbers = found
    parts = [element("h3", "Cracks and their fronts"), table(head, rows[:OPEN_ROWS], numbers)]
    if len(rows) > OPEN_ROWS:
        parts.append(folded(f"{len(rows) - OPEN_ROWS} more fronts", table(head, rows[OPEN_ROWS:], numbers)))
    parts.append(element("p", f"{of_which_loads(summary)}, fronts with the largest G first. ± is the estimated numerical error; in 3D mean is that along "
                         "the whole front, with the range of all its nodes in brackets; a front starts at its largest node. Largest is that of all samples. Inner nodes are "
                         "two cells or more from the surface.", class_="note"))
    return parts


def answer_part(run):
    summary = run.summary
    if not summary:
        grown = None if run.history is None else so_far(run.history)
        return grown and element("section", element("h2", "Does the crack run?"), element("p", grown, class_="verdict"))
    parts = [element("h2", "Does the crack run?" if facts.all_fronts(summary) else "Results")]
    decided = verdict(summary, run.history)
    if decided:
        parts.append(element("p", decided, class_="verdict"))
    extremes = extreme_rows(summary, run.history, run.run)
    lines = answers_without_peak(summary, extremes)
    as_list = element("ul", [element("li", answer) for answer in lines])
    parts.append(as_list if not decided else folded("What the program printed at its end, in SI units", as_list) if lines else None)
    if extremes:
        parts += [element("h3", "Largest and smallest values"), table(HEAD, extremes, [1, 2])]
    certain = facts.certainty(summary)
    if certain:
        parts += [element("h3", "How certain it is"), fact_list(certain)]
    rows = facts.reference_rows(summary)
    if rows:
        parts += [element("h3", "Comparison with the section Reference"),
                  table(("quantity", "result", "reference", "difference", "tolerance", "", "source"), rows, range(1, 5))]
    if run.twice is not None:
        parts += [element("h3", "Comparison of two cell sizes"), element("p", f"Verdict: {run.twice.get('verdict', 'none')}"),
                  table(("result", "as it is", "half the cells", "extrapolated", "verdict"), facts.twice_rows(run.twice), range(1, 4))]
    return element("section", parts, fronts_part(summary))


def figures(shown, first):
    """Figures of pictures; those with numbers are drawn again by the script. first: number of the first one, for ids"""
    parts = []
    for i, one in enumerate(shown, first):
        still = picture(one.kind, one.data, one.alt, class_=None if one.panel is None else "still")
        if one.panel is None:
            parts.append(element("figure", still, element("figcaption", one.caption)))
        else:
            parts.append(element("figure", still, element("figcaption", one.caption), data_block(f"panel-{i}", one.panel),
                                 class_="panel", data_source=f"panel-{i}"))
    return parts


def chosen_columns(history):
    """{rows, written, columns: {name: values}} of the history: every k-th row, so that the page stays small."""
    most = max(NUMBERS // max(len(history.column), 1), 2)
    kept = np.unique(np.round(np.linspace(0, len(history.time) - 1, min(most, len(history.time)))).astype(int))
    return {"rows": len(kept), "written": len(history.time), "colours": COLOURS, "columns": {name: rounded(values[kept]) for name, values in history.column.items()}}


def columns_part(history):
    """All columns of the history: to choose from where scripts run, and as a table."""
    data = chosen_columns(history)
    fewer = "" if data["rows"] == data["written"] else f" This plot has {data['rows']} of its {data['written']} rows."
    def value(samples, pick):
        finite = samples[np.isfinite(samples)]
        return f"{pick(finite):.6g}" if finite.size else "-"

    rows = [(name, value(samples, lambda v: v[-1]), value(samples, np.min), value(samples, np.max))
            for name, samples in list(history.column.items())[:LONGEST_LIST]]
    more = len(history.column) - len(rows)
    return element(
        "section", element("h2", "Columns of the history"),
        element("p", f"history.csv has {len(history.column)} columns and {len(history.time)} row{'' if len(history.time) == 1 else 's'}. "
                     f"Values are in SI units.{fewer}"),
        *([] if len(history.time) == 1 else [element("div", data_block("columns", data), class_="chooser", data_source="columns"),
                                             element("noscript", element("p", "A plot of chosen columns needs JavaScript."))]),
        folded(f"All columns{'' if more <= 0 else f' (the first {len(rows)})'}: last, lowest and highest value",
               table(("column", "last", "lowest", "highest"), rows, range(1, 4))))


def film_part(shown):
    """The frames, as a strip that scrolls; the script shows one at a time."""
    count = len(shown.frames)
    section = f", section at {shown.slice}" if shown.slice else ""
    images = [picture("png", png, f"Frame {i + 1} of {count}, at t = {seconds(time)}", class_="shown" if i == count - 1 else None,
                      data_label=f"t = {seconds(time)}") for i, (time, png) in enumerate(shown.frames)]
    fewer = f" The run wrote {shown.written} frames; {count} of them are here, so that the page stays small." if count < shown.written else ""
    size = "true displacements" if shown.magnification == 1.0 else f"displacements {shown.magnification:,.7g} times as large as they are".replace(",", " ")
    caption = f"{shown.quantity[0].upper()}{shown.quantity[1:]} [{shown.unit}]{section}; {size}. Colours and magnification are the same in all frames.{fewer}"
    return element("section", element("h2", "Film"),
                   element("figure", element("div", images, class_="frames"), element("div", class_="controls"), element("figcaption", caption), class_="film"))


def scene_part(run):
    if run.scene is None:
        return element("section", element("h2", "Scene"), element("p", "The scene file is not there any more."))
    try:
        with open(run.scene, encoding="utf-8", errors="replace") as file:
            text = file.read(LARGEST_SCENE + 1)
    except OSError as error:
        return element("section", element("h2", "Scene"), element("p", f"The scene file can't be read ({error.strerror})."))
    cut = " Only its beginning is shown." if len(text) > LARGEST_SCENE else ""
    text = "".join(c for c in text[:LARGEST_SCENE] if c >= " " or c in "\n\t")
    return element("section", element("h2", "Scene"), element("p", f"{run.scene}.{cut} Values that were given with --set are not in this file.", class_="note"),
                   folded("The scene file", element("pre", text)))


def why_no_fields(run):
    """Why a run has no fields, as the beginning of a line."""
    if run.state or not run.summary:
        return "The run has not written its first fields yet (Output > Field Interval; without it only the last ones are written)"
    if not went_to_its_end(run.summary):
        return "The run ended early, before it wrote fields (Output > Field Interval writes some on the way)"
    return "The run wrote no fields (Output > Fields)"


def page_of(run):
    """The page as text."""
    pictures = [] if run.fields is None else run.draw(field_pictures, run.run, run.summary, run.title)
    plots = [] if run.history is None else run.draw(history_pictures, run.history, run.summary, run.title)
    along = run.draw(front_pictures, run.summary) + run.draw(front_maps, run.run, run.summary, run.title)
    if run.fields is None and not any("fields.h5" in problem for problem in run.problems):
        run.problems.append(f"{why_no_fields(run)}, so there are no pictures of the body.")
    body = [head_of(run), answer_part(run)]
    if pictures:
        body.append(element("section", element("h2", "Pictures"), figures(pictures, 0)))
    if plots or along:
        hint = element("p", "Click into a plot, then turn the wheel to zoom; drag to choose a range; double click to see all again.", class_="hint")
        body.append(element("section", element("h2", "History"), hint, figures(plots, 0), figures(along, len(plots))))
    if run.history is not None:
        body.append(columns_part(run.history))
    scene = scene_part(run)
    if run.fields is not None:
        left = LARGEST_PAGE - sum(len(part) for part in [*body, scene] if part)
        moving = film(run.run, max(left * 3 // 4, FEWEST_FILM), run.problems)
        body += [] if moving is None else [film_part(moving)]
        body[0] = head_of(run)  # with what prevented the film
    body.append(scene)
    head = element("head", element("meta", charset="utf-8"), element("meta", name="viewport", content="width=device-width, initial-scale=1"),
                   element("title", run.title), element("style", Markup(read_text("report.css"))))
    script = element("script", Markup(read_text("report.js")))
    return "<!DOCTYPE html>\n" + element("html", head, element("body", element("main", markup(body)), script), lang="en") + "\n"


def write_page(folder, path):
    """Writes the page of a run. \\return (bytes, number of figures)"""
    run = Run(folder)
    read = [] if run.scene is None else [run.scene]
    target_of(path, read)  # before the pictures are drawn
    text = page_of(run).encode("utf-8", errors="replace")
    with replacing(path, read) as temporary, open(temporary, "wb") as file:
        file.write(text)
    return len(text), text.count(b"<figure")
