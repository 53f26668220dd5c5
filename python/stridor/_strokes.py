"""A contact over a history of strokes."""

from __future__ import annotations

import json
from typing import Any, Dict, List, Optional, Tuple

from . import _stridor
from ._case import CaseOrName, as_case

__all__ = ["StrokeHistory", "strokes"]


class StrokeHistory:
    """Strokes of a contact that friction heats and wears.

    Attributes
    ----------
    strokes : list of dict
        Those that were computed: "number", "temperature" [degC], "worn_depth" [m], "preload_share" [1],
        "friction_power" [W], and for each direction "verdict" and "figures".
    stretches : dict of str to list of dict
        For each direction "from" and "to" (stroke) and "verdict".
    ended : str or None
        Why it ended before its last stroke.

    Examples
    --------
    >>> import stridor
    >>> case = stridor.case("creak")
    >>> case.set({"drive.kind": "constant", "drive.velocity": 0.1})
    >>> history = stridor.strokes(case, 100, 1.0, wear=(1e-13, 1e-5, 5e-4))
    >>> history.stretches["going"][0]["from"]
    1
    """

    def __init__(self, document: Dict[str, Any]) -> None:
        self._document = document
        self.strokes: List[Dict[str, Any]] = document["strokes"]
        self.stretches: Dict[str, List[Dict[str, Any]]] = document["stretches"]
        self.ended: Optional[str] = document["ended"]

    def to_dict(self) -> Dict[str, Any]:
        """Returns what `stridor strokes --json` prints.

        Examples
        --------
        >>> import stridor
        >>> case = stridor.case("creak")
        >>> case.set({"drive.kind": "constant", "drive.velocity": 0.1})
        >>> stridor.strokes(case, 10, 1.0, wear=(1e-13, 1e-5, 5e-4)).to_dict()["schema"]
        'stridor.strokes/1'
        """
        return self._document


def strokes(
    case: CaseOrName,
    count: int,
    duration: float,
    pause: float = 0.0,
    heating: Optional[Tuple[float, float]] = None,
    wear: Optional[Tuple[float, float, float]] = None,
) -> StrokeHistory:
    """Runs a case stroke after stroke: friction heats the parts and wears the contact down.

    Parameters
    ----------
    case : Case or str
        The name of one that comes along will do.
    count : int
        How many strokes.
    duration, pause : float
        Time of sliding in each stroke, and after each [s].
    heating : tuple, optional
        Thermal resistance [K/W] and time constant [s].
    wear : tuple, optional
        Worn volume for each joule of friction [m^3/J], area that rubs [m^2], and worn depth after which nothing presses
        any more [m].

    Returns
    -------
    StrokeHistory
        Its first stroke is the case itself.

    Raises
    ------
    InputError
        For neither heating nor wear, and for what would change nothing.

    Examples
    --------
    >>> import stridor
    >>> case = stridor.case("creak")
    >>> case.set({"drive.kind": "constant", "drive.velocity": 0.1})
    >>> stridor.strokes(case, 10, 1.0, wear=(1e-13, 1e-5, 5e-4)).strokes[0]["preload_share"]
    1.0
    """
    return StrokeHistory(json.loads(_stridor.strokes(as_case(case)._handle, count, duration, pause, heating, wear)))
