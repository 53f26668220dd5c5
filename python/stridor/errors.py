"""What may go wrong, each kind as an exception of its own.

All of them are an `Error` and the exception that Python has for such a thing: who catches `ValueError` or `OSError`
need not know this package.
"""

from __future__ import annotations

from typing import NamedTuple, Optional, Sequence, Tuple

__all__ = ["Error", "InputError", "NumericalError", "Interrupted", "FileError", "Place"]


class Place(NamedTuple):
    """Where in a file a problem stands.

    Examples
    --------
    >>> import stridor
    >>> try:
    ...     stridor.from_toml("[joint]\\nmas = 1\\n", name="mine.toml")
    ... except stridor.InputError as error:
    ...     error.place.file, error.place.line, error.place.column
    ('mine.toml', 2, 1)
    """

    file: str
    """Its name, as it was given."""
    line: int
    """[1] from 1; 0: unknown."""
    column: int
    """[1] from 1; 0: unknown."""
    source_line: str = ""
    """The line itself, where it is known."""


Complaint = Tuple[str, str, str, Optional[Place]]


class Error(Exception):
    """What a user, a file or the machine caused: the base of all exceptions of this package.

    Attributes
    ----------
    what, why, suggestion : str
        What is wrong, why it is wrong, and what to do; the last two may be empty.
    place : Place or None
        Where it stands in a file.
    complaints : tuple
        All that is wrong, each as (what, why, suggestion, place): a file may have several faults. The attributes
        above are those of the first.

    Examples
    --------
    >>> import stridor
    >>> case = stridor.case("squeal")
    >>> try:
    ...     case.contact.kinetic_friction = 0.9
    ... except stridor.Error as error:
    ...     print(error.what)
    ...     print(error.suggestion)
    mu_d = 0.9 exceeds mu_s = 0.8
    Swap them?
    """

    what: str
    why: str
    suggestion: str
    place: Optional[Place]
    complaints: Tuple[Complaint, ...]

    def __init__(self, message: str, complaints: Sequence[Complaint] = ()) -> None:
        super().__init__(message)
        self.complaints = tuple(complaints) or ((message, "", "", None),)
        self.what, self.why, self.suggestion, self.place = self.complaints[0]

    @classmethod
    def _of(cls, message: str, complaints: Sequence[Complaint]) -> Error:
        return cls(message, complaints)

    @classmethod
    def _saying(cls, complaints: Sequence[Complaint]) -> Error:
        """One whose message says these, as the library puts it; their places are left out of it."""
        texts = [what + (f" ({why})." if why and suggestion else f" ({why})" if why else "." if suggestion else "") +
                 (f" {suggestion}" if suggestion else "") for what, why, suggestion, _ in complaints]
        return cls._of("\n".join(texts), complaints)

    def __reduce__(self) -> Tuple[object, ...]:
        return type(self), (str(self), self.complaints)


class InputError(Error, ValueError):
    """A file, a name, a value or a combination of values that is wrong; a `ValueError`.

    Examples
    --------
    >>> import stridor
    >>> stridor.case("squeel")
    Traceback (most recent call last):
    ...
    stridor.errors.InputError: there is no case "squeel". Did you mean "squeal"?
    """


class NumericalError(Error, ArithmeticError):
    """A computation that has no valid answer; an `ArithmeticError`.

    Examples
    --------
    >>> import stridor
    >>> issubclass(stridor.NumericalError, ArithmeticError)
    True
    """


class Interrupted(Error, KeyboardInterrupt):
    """A computation that was stopped by Ctrl-C; a `KeyboardInterrupt`. What a chart has computed by then is kept.

    Examples
    --------
    >>> import stridor
    >>> issubclass(stridor.Interrupted, KeyboardInterrupt)
    True
    """


class FileError(Error, OSError):
    """A file, a disk or another program that failed; an `OSError`.

    Examples
    --------
    >>> import stridor
    >>> try:
    ...     stridor.read("missing.toml")
    ... except OSError as error:
    ...     print(type(error).__name__)
    FileError
    """


class _MissingField(InputError, AttributeError):
    """An attribute that no field has: `hasattr` and completion ask for an AttributeError."""

