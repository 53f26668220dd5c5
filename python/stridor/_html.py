"""Cards for notebooks: inline styles only, readable on light and dark pages."""

from __future__ import annotations

import html
from typing import Iterable, Sequence

_cell = "padding:0.15em 0.8em;text-align:left"
_colours = {"none": "#8a8a8a", "squeal": "#BB5566", "squeak": "#DDAA33", "creak": "#004488", "undecided": "#666666"}


def escaped(text: object) -> str:
    """Text that a page shows as it is."""
    return html.escape(str(text), quote=True)


def table(rows: Iterable[Sequence[str]], heading: Sequence[str] = ()) -> str:
    """Rows of HTML pieces as a table."""
    lines = ""
    if heading:
        lines = "<tr>" + "".join(f'<th style="{_cell}">{each}</th>' for each in heading) + "</tr>"
    for row in rows:
        lines += "<tr>" + "".join(f'<td style="{_cell}">{each}</td>' for each in row) + "</tr>"
    return f'<table style="border-collapse:collapse">{lines}</table>'


def badge(category: str) -> str:
    """A category with its colour; the word says the same."""
    colour = _colours.get(category, "#666666")
    style = f"border-left:0.6em solid {colour};padding-left:0.4em;font-weight:bold"
    return f'<span style="{style}">{escaped(category)}</span>'


def folding(summary: str, body: str, state: str = "") -> str:
    """A body that opens under its summary; `state` may be "open"."""
    return f"<details {state}><summary>{summary}</summary>{body}</details>"


# the letters of windows-1252 as browsers read it; Python leaves five bytes out
_letters = "".join(bytes([byte]).decode("cp1252" if byte not in (0x81, 0x8D, 0x8F, 0x90, 0x9D) else "latin-1")
                   for byte in range(256))


def frame(page: bytes, height: int, title: str) -> str:
    """A frame that holds a whole page in windows-1252, as the page in one file is; it asks nobody for it."""
    text = page.decode("latin-1").translate(dict(enumerate(_letters)))
    text = text.replace("&", "&amp;").replace('"', "&quot;")
    return (f'<iframe srcdoc="{text}" width="100%" height="{height}" style="border:0" '
            f'allow="autoplay; clipboard-write" title="{escaped(title)}"></iframe>')
