"""Prints python/stridor/_fields.pyi, made of the library's tables, for type checkers.

    PYTHONPATH=build/python /usr/bin/python3 python/tests/write_stubs.py > python/stridor/_fields.pyi
"""

import sys
from typing import List

import stridor
from stridor import _fields


def descriptor(name: str, parents: str, gives: str, takes: str) -> List[str]:
    """What reads a field and what sets it: other types than one property has."""
    ignored = "  # type: ignore[override]" if parents else ""
    return [f"class {name}{parents}:", "    def __init__(self, name: str, document: str) -> None: ...",
            f"    @overload{ignored}",
            f"    def __get__(self, section: None, owner: object = ...) -> {name}: ...", "    @overload",
            f"    def __get__(self, section: Section, owner: object = ...) -> {gives}: ...",
            f"    def __set__(self, section: Section, value: {takes}) -> None: ...{ignored}", ""]


def stub() -> str:
    """The text of _fields.pyi."""
    lines = ["# Written by python/tests/write_stubs.py: the sections of a case and the figures of a verdict.", ""]
    lines += ["from typing import Any, Dict, Union, overload", ""]
    lines += ["class Section:", "    def __init__(self, case: Any, prefix: str) -> None: ..."]
    lines += ["    def __getattr__(self, name: str) -> Any: ..."]
    lines += ["    def __setattr__(self, name: str, value: object) -> None: ..."]
    lines += ["    def __getitem__(self, name: str) -> Any: ...", ""]
    lines += descriptor("Quantity", "", "float", "Union[float, str]")
    lines += descriptor("Word", "(Quantity)", "str", "str")
    for section, fields in _fields._sections().items():
        lines += [f"class {_fields._class_name(section)}(Section):"]
        lines += [f"    {field['name']}: {'Quantity' if field['unit'] else 'Word'}" for field in fields]
        lines += [f"    def __getitem__(self, name: str) -> {_fields._class_name(section)}: ...", ""]
    lines += ["class Figures:", "    _figures: Dict[str, float]",
              "    def __init__(self, figures: Dict[str, float]) -> None: ..."]
    lines += ["    def __getattr__(self, name: str) -> float: ..."]
    for name, _, _ in stridor._stridor.phase_figures():
        lines += ["    @property", f"    def {name}(self) -> float: ..."]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    sys.stdout.write(stub())
