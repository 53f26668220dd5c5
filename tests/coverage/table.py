#!/usr/bin/env python3
"""Prints lines and branches per module from a gcovr summary, and the core sources whose lines are covered too little.

Usage: table.py SUMMARY.json, as `gcovr --json-summary` writes it. Exit code 1 if a core source lies below the share.
"""

import collections
import json
import pathlib
import sys

CORE = ("model", "integration", "analysis", "classification", "sweep")
LEAST = 95.0  # [%] of the lines of each core source


def percent(covered: int, total: int) -> float:
    return 100.0 if total == 0 else 100.0 * covered / total


def main() -> int:
    files = json.loads(pathlib.Path(sys.argv[1]).read_text())["files"]
    modules: dict[str, collections.Counter] = {}
    low = []
    for file in files:
        module = pathlib.PurePath(file["filename"]).parts[2]
        counter = modules.setdefault(module, collections.Counter())
        for key in ("line_covered", "line_total", "branch_covered", "branch_total"):
            counter[key] += file[key]
        lines = percent(file["line_covered"], file["line_total"])
        if module in CORE and lines < LEAST:
            low.append((lines, file["line_total"] - file["line_covered"], file["filename"]))

    print("| module | lines | branches |\n| --- | --- | --- |")
    for module, c in sorted(modules.items()):
        lines = percent(c["line_covered"], c["line_total"])
        branches = percent(c["branch_covered"], c["branch_total"])
        print(f"| `{module}` | {lines:.1f} % of {c['line_total']} | {branches:.1f} % of {c['branch_total']} |")
    for lines, missed, name in sorted(low):
        print(f"{name}: {lines:.1f} % of its lines, {missed} are missed", file=sys.stderr)
    return 1 if low else 0


if __name__ == "__main__":
    sys.exit(main())
