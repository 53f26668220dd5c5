#!/usr/bin/env python3
"""Prints lines and branches per module from a gcovr summary; single core sources that lie low go to stderr.

Usage: table.py SUMMARY.json, as `gcovr --json-summary` writes it. Exit code 1 if a core module lies below the share.
"""

import collections
import json
import pathlib
import sys

from core import CORE

LEAST = 95.0  # [%] of the lines of each core module


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
    failed = False
    for module, c in sorted(modules.items()):
        lines = percent(c["line_covered"], c["line_total"])
        failed = failed or (module in CORE and lines < LEAST)
        branches = percent(c["branch_covered"], c["branch_total"])
        print(f"| `{module}` | {lines:.1f} % of {c['line_total']} | {branches:.1f} % of {c['branch_total']} |")
    for lines, missed, name in sorted(low):
        print(f"{name}: {lines:.1f} % of its lines; missed: {missed}", file=sys.stderr)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
