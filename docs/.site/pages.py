"""What mkdocs.yml needs to show the pages of docs: they are written for readers on the forge, too, where lists may follow a
paragraph at once, and where links lead to code."""

import os
import re

ITEM = re.compile(r"( *)([-*]|\d+\.) +")


def widen_lists(text):
    """Lists with a blank line before them, and four blanks for each level, as Python-Markdown wants them."""
    rows, items, fence, before = [], [], False, ""  # items: where the text of each open item begins
    for row in text.splitlines():
        indent = len(row) - len(row.lstrip())
        if row.lstrip().startswith("```"):
            fence = not fence
        if not row.strip() or (fence and not items):
            rows.append(row)
            before = row
            continue
        item = None if fence else ITEM.match(row)
        lazy = before.strip() and not item and not re.match(r"[#|<]", row)
        while items and indent < items[-1] and not lazy:
            items.pop()
        if item and indent < (items[-1] if items else 0) + 4:
            if not items and before.strip():
                rows.append("")
            rows.append(" " * 4 * len(items) + f"{item.group(2)} {row[item.end():]}")
            items.append(item.end())
        elif items:
            rows.append(" " * 4 * len(items) + row[min(indent, items[-1]):])
        else:
            rows.append(row)
        before = row
    return "\n".join(rows) + "\n"


def without_links_to_code(text, page, docs):
    """Links to files outside of docs, and to folders, as plain text."""

    def plain(match):
        address = match.group(2)
        path = os.path.normpath(os.path.join(docs, os.path.dirname(page), address.partition("#")[0]))
        inside = path.startswith(docs + os.sep) and os.path.isfile(path)
        return match.group(0) if re.match(r"[a-z]+:|#", address) or inside else match.group(1)

    return re.sub(r"(?<!!)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(([^)\s]+)\)", plain, text)


def on_page_markdown(markdown, page, config, **_):
    return widen_lists(without_links_to_code(markdown, page.file.src_path, config["docs_dir"]))
