#!/usr/bin/env python3
"""Makes a Jupyter notebook of a `# %%` script: `to_ipynb.py first_steps.py > first_steps.ipynb`."""

import json
import sys

MARK = "# %%"
TEXT = "# %% [markdown]"


def cells_of(script):
    """(kind, text) of each cell; what stands before the first mark is none."""
    cells = []
    for line in script.splitlines():
        if line.startswith(MARK):
            cells.append(("markdown" if line.startswith(TEXT) else "code", []))
        elif cells:
            kind, lines = cells[-1]
            lines.append(line[2:] if kind == "markdown" and line.startswith("# ") else
                         "" if kind == "markdown" and line == "#" else line)
    return [(kind, "\n".join(lines).strip("\n")) for kind, lines in cells]


def notebook_of(script):
    """The notebook (nbformat 4.5), without outputs."""
    cells = []
    for number, (kind, text) in enumerate(cells_of(script)):
        cell = {"cell_type": kind, "id": f"cell-{number}", "metadata": {}, "source": text.splitlines(keepends=True)}
        cells.append(cell if kind == "markdown" else {**cell, "execution_count": None, "outputs": []})
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    return {"cells": cells, "metadata": {"kernelspec": kernel}, "nbformat": 4, "nbformat_minor": 5}


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8") as file:
        print(json.dumps(notebook_of(file.read()), indent=1, ensure_ascii=False))
