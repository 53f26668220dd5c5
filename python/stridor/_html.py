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
