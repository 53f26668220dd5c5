"""Where a run ends, and runs that begin there or go on."""

from __future__ import annotations

import json
import os
from typing import Any, Dict, List, Optional, Union

from . import _stridor
from ._case import Case, CaseOrName, as_case
from .errors import InputError

__all__ = ["EndState", "Following", "end_state", "follow", "read_end_state"]


class EndState:
    """Where a run stands at its end.

    Attributes
    ----------
    time : float
        Since the first start [s].
    displacement, velocity : list of float
        Of each degree of freedom, from the preloaded rest [m], [m/s].
    contacts : list of str
        What each contact does: "slip", "stick" or "separation".

    Examples
    --------
    >>> import stridor
    >>> case = stridor.case("squeal")
    >>> state = stridor.end_state(case)
    >>> state.time, state.contacts
    (1.0, ['slip'])
    """

    def __init__(self, text: str) -> None:
        try:
            document = json.loads(text)
            self._text = text
            self.time: float = document["time"]
            self.displacement: List[float] = document["displacement"]
            self.velocity: List[float] = document["velocity"]
            self.contacts: List[str] = document["contacts"]
        except (ValueError, KeyError, TypeError) as error:
            raise InputError(f"this is no end state of a run: {error}") from None

    def to_json(self) -> str:
        """Returns the document that `simulate --end-state` writes.

        Examples
        --------
        >>> import stridor
        >>> stridor.end_state("creak").to_json().startswith("{")
        True
        """
        return self._text

    def save(self, path: Union[str, os.PathLike[str]]) -> None:
        """Writes the document to a file.

        Examples
        --------
        >>> import stridor, tempfile, os
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     stridor.end_state("creak").save(os.path.join(folder, "end.json"))
        """
        _stridor.write_file(os.fspath(path), self._text + "\n")

    def begun(self, case: CaseOrName) -> Case:
        """Returns a case that begins in this state, perhaps with other quantities, as a run of its own.

        Examples
        --------
        >>> import stridor
        >>> case = stridor.case("squeal")
        >>> state = stridor.end_state(case)
        >>> case.contact.preload = 30
        >>> state.begun(case).run.initial
        'given'
        """
        return Case._of(_stridor.begun_in(as_case(case)._handle, self._text))

    def __repr__(self) -> str:
        return f"<stridor.EndState at {self.time:g} s: {', '.join(self.contacts)}>"


def end_state(case: CaseOrName, start: Optional[EndState] = None) -> EndState:
    """Runs a case to its end and returns where it stands there.

    Parameters
    ----------
    case : Case or str
        The name of one that comes along will do.
    start : EndState, optional
        Goes on with that run of the same case; `run.duration` counts from its begin.

    Returns
    -------
    EndState
        `stridor.simulate(case, start=state)` goes on with it.

    Examples
    --------
    >>> import stridor
    >>> case = stridor.case("squeal")
    >>> half = stridor.end_state(case)
    >>> case.run.duration = 2
    >>> whole, gone_on = stridor.end_state(case), stridor.end_state(case, start=half)
    >>> whole.displacement == gone_on.displacement
    True
    """
    text = start.to_json() if start is not None else ""
    return EndState(_stridor.end_state(as_case(case)._handle, text))


def read_end_state(path: Union[str, os.PathLike[str]]) -> EndState:
    """Reads what `simulate --end-state` or `EndState.save` wrote.

    Examples
    --------
    >>> import stridor, tempfile, os
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = os.path.join(folder, "end.json")
    ...     stridor.end_state("creak").save(file)
    ...     stridor.read_end_state(file).time
    1.0
    """
    with open(path, encoding="utf-8") as file:
        return EndState(file.read().rstrip("\n"))


class Following:
    """A motion that was followed along a quantity, up and then down.

    Attributes
    ----------
    key : str
        The quantity.
    runs : list of dict
        In the order in which they were run: "way" ("up", "down"), "value", and for each direction "verdict" and
        "figures".
    hysteresis : dict of str to list of float
        For each direction the values at which the ways have other verdicts.

    Examples
    --------
    >>> import stridor
    >>> case = stridor.case("squeak")
    >>> case.set({"drive.kind": "constant", "drive.velocity": -0.1})
    >>> followed = stridor.follow(case, "mu_d=0.1:0.3:3")
    >>> [run["value"] for run in followed.runs]
    [0.1, 0.2, 0.3, 0.2, 0.1]
    """

    def __init__(self, document: Dict[str, Any]) -> None:
        self._document = document
        self.key: str = document["over"]["parameter"]
        self.runs: List[Dict[str, Any]] = document["runs"]
        self.hysteresis: Dict[str, List[float]] = document["hysteresis"]

    def to_dict(self) -> Dict[str, Any]:
        """Returns what `stridor follow --json` prints.

        Examples
        --------
        >>> import stridor
        >>> case = stridor.case("squeak")
        >>> case.set({"drive.kind": "constant", "drive.velocity": -0.1})
        >>> stridor.follow(case, "mu_d=0.1:0.3:2").to_dict()["schema"]
        'stridor.following/1'
        """
        return self._document


def follow(case: CaseOrName, over: str) -> Following:
    """Follows a motion along a quantity, up and then down: each run begins where the one before has ended.

    Parameters
    ----------
    case : Case or str
        The name of one that comes along will do.
    over : str
        "KEY=FROM:TO[:POINTS]", as `stridor follow --over` takes it.

    Returns
    -------
    Following
        Where its ways differ, the system has hysteresis.

    Examples
    --------
    >>> import stridor
    >>> case = stridor.case("squeak")
    >>> case.set({"drive.kind": "constant", "drive.velocity": -0.1})
    >>> stridor.follow(case, "mu_d=0.1:0.3:2").key
    'contact.kinetic_friction'
    """
    return Following(json.loads(_stridor.follow(as_case(case)._handle, over)))
