"""The sections of a case and the figures of a verdict: classes made of the library's tables.

`_fields.pyi` says the same to type checkers. `python/tests/write_stubs.py` writes it, and a test holds it against the
tables.
"""

from __future__ import annotations

from typing import Any, Dict, List, Mapping

from . import _stridor
from .errors import InputError, _MissingField


class Section:
    """Some of a case's values, by name. Setting one checks it, as `Case.set` does."""

    __slots__ = ("_case", "_prefix")

    def __init__(self, case: Any, prefix: str) -> None:
        object.__setattr__(self, "_case", case)
        object.__setattr__(self, "_prefix", prefix)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        return _value(self, name)

    def __setattr__(self, name: str, value: object) -> None:
        self._case.set({f"{self._prefix}.{name}": value})

    def __dir__(self) -> List[str]:
        return [key[len(self._prefix) + 1 :] for key in self._case.keys() if key.startswith(self._prefix + ".")]

    def __repr__(self) -> str:
        lines = [f"{key} = {self._case.text(key)}" for key in self._case.keys() if key.startswith(self._prefix + ".")]
        return "\n".join(lines)

    def __getitem__(self, name: str) -> Section:
        """The same section of one of several joints, by the joint's name."""
        if name not in self._case.joints:
            names = ", ".join(self._case.joints) or "none: the case has one joint"
            raise _MissingField(f'there is no joint "{name}". The joints with names are: {names}.')
        key = f"joint.{name}"
        return type(self)(self._case, key if self._prefix == "joint" else f"{key}.{self._prefix}")


def _value(section: Section, name: str) -> Any:
    try:
        return section._case[f"{section._prefix}.{name}"]
    except InputError as error:
        raise _MissingField(str(error), error.complaints) from None


def _document(field: Mapping[str, Any]) -> str:
    unit = field["unit"]
    symbol = f" ({field['symbol']})" if field["symbol"] else ""
    values = field["values"]
    return f"{field['sentence']}{symbol}" + (f" [{values or unit}]" if unit or values else "")


class Quantity:
    """A value that is a number; it takes text with a unit, too."""

    def __init__(self, name: str, document: str) -> None:
        self._name = name
        self.__doc__ = document

    def __get__(self, section: Any, owner: object = None) -> Any:
        return self if section is None else _value(section, self._name)

    def __set__(self, section: Section, value: object) -> None:
        section.__setattr__(self._name, value)


class Word(Quantity):
    """A value that is a name out of a list, or text."""


def _class_name(section: str) -> str:
    return section.capitalize()


def _sections() -> Dict[str, List[Mapping[str, Any]]]:
    table: Dict[str, List[Mapping[str, Any]]] = {}
    for field in _stridor.fields():
        if field["section"]:
            table.setdefault(field["section"], []).append(field)
    return table


class Figures:
    """The numbers of a verdict, by name; NaN where there is none."""

    __slots__ = ("_figures",)
    _figures: Dict[str, float]

    def __init__(self, figures: Dict[str, float]) -> None:
        self._figures = figures

    def __getattr__(self, name: str) -> float:
        raise AttributeError(f'there is no figure "{name}"')


def _figure_property(name: str, unit: str, sentence: str) -> property:
    return property(lambda self: self._figures[name], doc=f"{sentence} [{unit}]")


def _make_classes() -> None:
    here = globals()
    for section, fields in _sections().items():
        members: Dict[str, Any] = {
            field["name"]: (Quantity if field["unit"] else Word)(field["name"], _document(field)) for field in fields}
        members["__slots__"] = ()
        members["__doc__"] = f"[{section}] of a case."
        members["__module__"] = __name__
        here[_class_name(section)] = type(_class_name(section), (Section,), members)
    for name, unit, sentence in _stridor.phase_figures():
        setattr(Figures, name, _figure_property(name, unit, sentence))


_make_classes()
