"""Writes HTML: elements with escaped text and attributes. What is HTML already is marked as such."""

import base64
import html
import json


class Markup(str):
    """Text that is HTML and is not escaped again."""


VOID = ("img", "input", "meta", "br")  # elements without an end tag


def markup(part):
    """A part of a page as HTML: Markup as it is, lists joined, None as nothing, anything else escaped."""
    if part is None:
        return Markup("")
    if isinstance(part, Markup):
        return part
    if isinstance(part, (list, tuple)):
        return Markup("".join(markup(entry) for entry in part))
    return Markup(html.escape(str(part)))


def element(tag, *content, **attributes):
    """An element. content: its parts; attributes: class_ and for_ stand for words of Python, data_x for data-x; True gives an
    attribute without a value, None none."""
    text = ""
    for name, value in attributes.items():
        name = name.rstrip("_").replace("_", "-")
        if value is True:
            text += f" {name}"
        elif value is not None:
            text += f' {name}="{html.escape(str(value))}"'
    if tag in VOID:
        return Markup(f"<{tag}{text}>")
    return Markup(f"<{tag}{text}>{markup(list(content))}</{tag}>")


def table(head, rows, numbers=()):
    """A table in a box that scrolls on a narrow screen. head: names of columns; rows: cells; numbers: indices of columns whose
    cells are numbers and are aligned right."""
    def side(i):
        return "number" if i in numbers else None

    top = element("tr", [element("th", name, scope="col", class_=side(i)) for i, name in enumerate(head)])
    body = [element("tr", [element("td", cell, class_=side(i)) for i, cell in enumerate(row)]) for row in rows]
    return element("div", element("table", element("thead", top), element("tbody", body)), class_="wide")


def picture(kind, data, alt, **attributes):
    """An embedded picture. kind: png or svg+xml; data: its bytes; alt: what it shows, for readers who can't see it."""
    source = f"data:image/{kind};base64," + base64.b64encode(data).decode()
    return element("img", src=source, alt=alt, **attributes)


def data_block(name, value):
    """Data for the script, in an element with this id. value: what JSON can hold."""
    text = json.dumps(value, separators=(",", ":"), allow_nan=False).replace("<", "\\u003c")
    return element("script", Markup(text), type="application/json", id=name)


def folded(summary, *content, **attributes):
    """Content that is shown after a click."""
    return element("details", element("summary", summary), *content, **attributes)
