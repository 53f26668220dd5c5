"""Axes of charts."""

from __future__ import annotations

from typing import NamedTuple, Optional, Union

from . import _stridor
from ._given import plain, whole

__all__ = ["Axis", "axis"]


class Axis(NamedTuple):
    """A quantity of a case and the values it takes. `axis` makes it.

    Examples
    --------
    >>> import stridor
    >>> stridor.Axis("contact.preload", 2.0, 4000.0, 160, "log").text
    'contact.preload=2.0 N:4000.0 N:160:log'
    """

    parameter: str
    """Its key, the last part of it or its symbol."""
    start: Union[float, str]
    """[the quantity's unit], or text with a unit."""
    stop: Union[float, str]
    """[the quantity's unit], or text with a unit."""
    points: int = 40
    """[1] Number of values, both ends included."""
    scale: Optional[str] = None
    """"linear" or "log"; None: what is usual for the quantity."""

    @property
    def text(self) -> str:
        """As the program's `--x` has it."""
        unit = _stridor.unit_of(self.parameter)
        ends = f"{self.parameter}={_end(self.start, unit)}:{_end(self.stop, unit)}:{self.points}"
        return ends if self.scale is None else f"{ends}:{self.scale}"


def _end(end: Union[float, str], unit: str) -> str:
    """With its unit: the other end's is not its own."""
    given = plain(end)
    if isinstance(given, str):
        return given
    return repr(given) if unit == "1" else f"{given!r} {unit}"


def axis(
    parameter: str,
    start: Union[float, str],
    stop: Union[float, str],
    points: int = 40,
    *,
    scale: Optional[str] = None,
) -> Axis:
    """An axis of a chart.

    Parameters
    ----------
    parameter : str
        A quantity: its key ("contact.preload"), the last part of it ("preload") or its symbol ("F").
    start, stop : float or str
        Both ends, which belong to it, in the quantity's unit or with one of their own ("4 kN").
    points : int
        Number of values.
    scale : {"linear", "log"}, optional
        How they are spaced; without it as is usual for the quantity.

    Examples
    --------
    >>> import stridor
    >>> stridor.axis("preload", 2, "4 kN", 160, scale="log")
    Axis(parameter='preload', start=2, stop='4 kN', points=160, scale='log')
    """
    return Axis(parameter, start, stop, whole("points", points), scale)
