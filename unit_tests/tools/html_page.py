"""Reads an HTML page strictly, for tests: every element is closed in order, ids are unique, nothing is loaded from elsewhere."""

import html.parser
import json
import re

VOID = {"img", "input", "meta", "br"}
ADDRESS = re.compile(r"https?:|^\s*//|^\s*ftp:", re.IGNORECASE)


class Page(html.parser.HTMLParser):
    """elements: [(tag, attributes)]; text: of all but scripts and styles; scripts, styles: their texts; data: {id: value} of blocks of
    JSON; faults: what a strict reader rejects."""

    def __init__(self, text):
        super().__init__(convert_charrefs=True)
        self.elements, self.faults, self.open, self.data = [], [], [], {}
        self.pieces = {"script": [], "style": [], "text": []}
        self.feed(text)
        self.close()
        self.faults += [f"<{tag}> is not closed" for tag in self.open]
        self.text = " ".join(" ".join(self.pieces["text"]).split())
        self.ids = [attributes["id"] for _, attributes in self.elements if "id" in attributes]
        self.faults += [f"id {name} twice" for name in set(self.ids) if self.ids.count(name) > 1]

    def handle_starttag(self, tag, attributes):
        names = [name for name, _ in attributes]
        if len(set(names)) < len(names):
            self.faults.append(f"<{tag}> has an attribute twice")
        attributes = dict(attributes)
        self.elements.append((tag, attributes))
        for name, value in attributes.items():
            if name in ("src", "href", "action", "srcset", "poster") and not (value or "").startswith(("data:", "#")):
                self.faults.append(f"<{tag} {name}> loads {value[:60]}")
            if name not in ("alt", "content") and not (value or "").startswith("data:") and ADDRESS.search(value or ""):
                self.faults.append(f"<{tag} {name}> has the address {value[:60]}")
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        if not self.open or self.open[-1] != tag:
            self.faults.append(f"</{tag}> closes {self.open[-1:]}")
        else:
            self.open.pop()

    def handle_data(self, data):
        inside = self.open[-1] if self.open else ""
        if inside == "script" and self.elements[-1][1].get("type") == "application/json":
            self.data[self.elements[-1][1]["id"]] = json.loads(data)
            return
        kind = inside if inside in ("script", "style") else "text"
        self.pieces[kind].append(data)
        if kind != "text" and (ADDRESS.search(data) or "@import" in data or re.search(r"url\((?!#)", data.replace('url(#"', "url(#"))):
            self.faults.append(f"<{inside}> has an address")

    def unknown_decl(self, data):
        self.faults.append(f"unknown declaration {data[:40]}")

    def of(self, tag, **wanted):
        """Attributes of all elements of a kind with these attributes."""
        return [attributes for name, attributes in self.elements if name == tag and all(attributes.get(k) == v for k, v in wanted.items())]
