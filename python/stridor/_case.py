"""Cases: what is simulated."""

from __future__ import annotations

import json
import os
import warnings as _warnings
from typing import Any, Dict, Iterator, List, Mapping, Tuple, Union

from . import _fields, _html, _stridor
from ._given import Value, items_of, plain, whole_text
from .errors import InputError

__all__ = ["Case", "case", "case_names", "from_toml", "read"]

_longest_text = 65536  # [bytes] of a case file


class Case:
    """A rubbing system, how it is driven, how long it is watched and how it is judged.

    Values stand in sections, as in a case file: `case.contact.preload`. Numbers are SI, angles in degrees; text
    carries its unit. A case can always be simulated: who sets a value that is out of its range, or that contradicts
    another, gets an `InputError`, and the case stays as it was.

    Cases are made by `case`, `read` and `from_toml`. They are compared by what they say, copied and pickled.

    Parameters
    ----------
    text : str
        A case file (TOML), as `to_toml` writes it.

    Examples
    --------
    >>> import stridor
    >>> case = stridor.case("squeal")
    >>> case.contact.preload
    20.0
    >>> case.contact.preload = "0.2 kN"
    >>> case.contact.preload
    200.0
    >>> case == eval(repr(case))
    True
    """

    __slots__ = ("_handle",)
    __hash__ = None  # type: ignore[assignment]
    _handle: _stridor.CaseHandle

    def __init__(self, text: str) -> None:
        self._handle = _stridor.from_toml(text, "<text>")

    @classmethod
    def _of(cls, handle: _stridor.CaseHandle) -> Case:
        made = cls.__new__(cls)
        made._handle = handle
        return made

    @property
    def title(self) -> str:
        """What this case is, in a few words."""
        return str(self._handle.value("title"))

    @title.setter
    def title(self, value: str) -> None:
        self.set({"title": value})

    @property
    def joint(self) -> _fields.Joint:
        """The rubbed joint; of several joints ``case.joint["lip2"]``."""
        return _fields.Joint(self, "joint")

    @property
    def plate(self) -> _fields.Plate:
        """The plate that moves under the joint."""
        return _fields.Plate(self, "plate")

    @property
    def structure(self) -> _fields.Structure:
        """Of a structure of the user's own: what scales it, and what a builder made it of."""
        return _fields.Structure(self, "structure")

    @property
    def contact(self) -> _fields.Contact:
        """Preload and friction; of several joints ``case.contact["lip2"]``."""
        return _fields.Contact(self, "contact")

    @property
    def temperature(self) -> _fields.Temperature:
        """The temperature, where properties follow it."""
        return _fields.Temperature(self, "temperature")

    @property
    def drive(self) -> _fields.Drive:
        """How the plate is moved."""
        return _fields.Drive(self, "drive")

    @property
    def run(self) -> _fields.Run:
        """How long the system is watched, and how its motion is computed."""
        return _fields.Run(self, "run")

    @property
    def verdict(self) -> _fields.Verdict:
        """The thresholds of the verdict."""
        return _fields.Verdict(self, "verdict")

    @property
    def joints(self) -> List[str]:
        """The names of several joints; none where there is only one."""
        return self._handle.joints()

    def __setattr__(self, name: str, value: object) -> None:
        if name in ("_handle", "title"):
            object.__setattr__(self, name, value)
        else:
            self.set({name: value})

    def __getitem__(self, key: str) -> Value:
        """A value by its key, its last part or its symbol: ``case["mu_d"]``."""
        return self._handle.value(whole_text(key))

    def __setitem__(self, key: str, value: object) -> None:
        self.set({key: value})

    def __iter__(self) -> Iterator[str]:
        return iter(self.keys())

    def __len__(self) -> int:
        return len(self.keys())

    def keys(self) -> List[str]:
        """The keys of all that belongs to this case.

        Examples
        --------
        >>> import stridor
        >>> stridor.case("squeal").keys()[:3]
        ['title', 'joint.mass', 'joint.axial_stiffness']
        """
        return self._handle.keys()

    def text(self, key: str) -> str:
        """A value as a case file has it, with its unit.

        Examples
        --------
        >>> import stridor
        >>> stridor.case("squeal").text("contact.preload")
        '20 N'
        """
        return self._handle.text(whole_text(key))

    def set(self, values: Mapping[str, object]) -> None:
        """Sets several values at once, so that they are held against each other only in the end.

        Parameters
        ----------
        values : mapping
            By key, last part of a key or symbol; numbers in SI units (angles in degrees), or text with a unit.

        Raises
        ------
        InputError
            For what `--set` of the program refuses. The case then stays as it was.

        Examples
        --------
        >>> import stridor
        >>> case = stridor.case("squeal")
        >>> case.set({"drive.kind": "constant", "drive.velocity": "50 mm/s"})
        >>> case.drive.velocity
        0.05
        """
        given = [(whole_text(str(key)), plain(value)) for key, value in items_of("values by key", values)]
        self._handle = self._handle.changed(given)

    def replace(self, values: Mapping[str, object]) -> Case:
        """A copy with other values, as `set` takes them.

        Examples
        --------
        >>> import stridor
        >>> stridor.case("squeal").replace({"mu_d": 0.1}).contact.kinetic_friction
        0.1
        """
        other = self.copy()
        other.set(values)
        return other

    def copy(self) -> Case:
        """Another case that says the same.

        Examples
        --------
        >>> import stridor
        >>> case = stridor.case("squeal")
        >>> case.copy() == case
        True
        """
        return Case._of(self._handle)

    def to_toml(self, *, comments: bool = False) -> str:
        """The case as a file.

        Parameters
        ----------
        comments : bool
            Whether each key is explained.

        Examples
        --------
        >>> import stridor
        >>> print(stridor.case("squeal").to_toml().splitlines()[3])
        mass = "0.1 kg"
        """
        return self._handle.to_toml(comments)

    def to_dict(self) -> Dict[str, Any]:
        """The case as nested dictionaries of plain values, as the program's JSON has it.

        Examples
        --------
        >>> import stridor
        >>> stridor.case("squeal").to_dict()["contact"]["preload"]
        20.0
        """
        document: Dict[str, Any] = json.loads(self._handle.json())
        return document

    def save(self, path: Union[str, os.PathLike[str]]) -> None:
        """Writes the case as a file with comments.

        Examples
        --------
        >>> import stridor
        >>> stridor.case("squeal").save("mine.toml")
        >>> stridor.read("mine.toml") == stridor.case("squeal")
        True
        """
        _stridor.write_file(os.fspath(path), self.to_toml(comments=True))

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Case):
            return NotImplemented
        return self._handle.equals(other._handle)

    def __copy__(self) -> Case:
        return self.copy()

    def __deepcopy__(self, memo: object) -> Case:
        return self.copy()

    def __reduce__(self) -> Tuple[object, ...]:
        return _unpickled, (self._handle.packed(),)

    def __repr__(self) -> str:
        text = self.to_toml()
        if len(text) > _longest_text:
            return f"<case with a structure of {len(self.to_dict()['structure']['rows'])} rows: {self.title}>"
        if "\\" in text or '"""' in text or "\r" in text:
            return f"stridor.Case({text!r})"
        return f'stridor.Case("""\n{text}""")'

    def _repr_html_(self) -> str:
        start = case("squeal")
        known = set(start.keys())
        rows = []
        for key in self.keys():
            text = _html.escaped(self.text(key))
            is_changed = key not in known or self.text(key) != start.text(key)
            rows.append((f"<code>{_html.escaped(key)}</code>", f"<b>{text}</b>" if is_changed else text))
        summary = f"Case <b>{_html.escaped(self.title or 'without a title')}</b> ({len(rows)} values)"
        return _html.folding(summary, _html.table(rows))


def _unpickled(packed: bytes) -> Case:
    return Case._of(_stridor.unpacked(packed))


CaseOrName = Union[Case, str]


def as_case(given: object) -> Case:
    """A case, or the one that comes along under a name."""
    if isinstance(given, Case):
        return given
    if isinstance(given, str) and ("/" in given or given.endswith(".toml")):
        raise InputError(f'"{given}" is no case. Read the file: stridor.read("{given}").')
    if isinstance(given, str):
        return case(whole_text(given))
    raise InputError(f"{given!r} is no case. Give what stridor.case, stridor.read or stridor.structure makes.")


def case(name: str) -> Case:
    """A case that comes along, as `stridor init NAME` writes it.

    Parameters
    ----------
    name : str
        One of `case_names`.

    Returns
    -------
    Case
        Of a chart its base case.

    Examples
    --------
    >>> import stridor
    >>> stridor.case("squeal").title
    'squeal: mode coupling while going (Table 1, column 2)'
    """
    return Case._of(_stridor.ready_case(name))


def case_names() -> List[str]:
    """The names that `case` takes.

    Examples
    --------
    >>> import stridor
    >>> stridor.case_names()[:4]
    ['squeal', 'squeak', 'creak', 'quiet']
    """
    return _stridor.ready_names()


def read(path: Union[str, os.PathLike[str]]) -> Case:
    """Reads a case file.

    Parameters
    ----------
    path : path
        A TOML file; of a chart's file the base case is read.

    Returns
    -------
    Case

    Raises
    ------
    InputError
        With the place of what is wrong in the file.
    FileError
        For what cannot be read.

    Warns
    -----
    UserWarning
        For keys that mean nothing for this case.

    Examples
    --------
    >>> import stridor
    >>> stridor.case("creak").save("creak.toml")
    >>> stridor.read("creak.toml").contact.preload
    2000.0
    """
    name = os.fspath(path)
    handle = _stridor.read(name)
    for text in _stridor.warnings(name):
        _warnings.warn(text, stacklevel=2)
    return Case._of(handle)


def from_toml(text: str, *, name: str = "<text>") -> Case:
    """Reads a case out of text.

    Parameters
    ----------
    text : str
        TOML, as in a file.
    name : str
        What errors call it.

    Examples
    --------
    >>> import stridor
    >>> stridor.from_toml(stridor.case("squeal").to_toml()) == stridor.case("squeal")
    True
    """
    return Case._of(_stridor.from_toml(text, name))
