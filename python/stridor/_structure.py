"""Structures of the user's own, as arrays."""

from __future__ import annotations

from typing import Any, List, Mapping, Optional, Sequence, Tuple, Union

from . import _stridor
from ._case import Case
from ._given import bare, items_of, plain, whole_text
from ._optional import needed
from .errors import Error, InputError

__all__ = ["structure"]

_most_rows = 2000  # [1] of a structure: what the engines take
# in which arrays are taken; of all others without one
_units = {"mass": "kg", "stiffness": "N/m", "damping": "N*s/m", "load": "N", "initial_displacement": "m",
          "rayleigh_mass": "1/s", "rayleigh_stiffness": "s", "cubic": "N/m^3", "deflection": "m", "gap": "m",
          **_stridor.contact_units()}
_Entries = List[Tuple[str, Any]]  # key and value of a case's document; None opens a table


def structure(
    *,
    mass: Any,
    stiffness: Any,
    contacts: Sequence[Mapping[str, Any]],
    values: Mapping[str, object],
    damping: Any = None,
    rows: Sequence[str] = (),
    damping_ratio: Optional[float] = None,
    loss_factor: Optional[float] = None,
    rayleigh_mass: Optional[float] = None,
    rayleigh_stiffness: Optional[float] = None,
    load: Any = None,
    force: Any = None,
    initial_displacement: Any = None,
    initial_velocity: Any = None,
    outputs: Optional[Mapping[str, Any]] = None,
    springs: Sequence[Mapping[str, Any]] = (),
    title: str = "",
) -> Case:
    """A case with a structure of your own: M u'' + C u' + K u = loads, with rubbing contacts, and springs if wanted.

    The page on structures of one's own (docs/formats/own-structure.md) says what each key means.

    Parameters
    ----------
    mass, stiffness : array_like or sparse matrix, shape (rows, rows)
        M [kg], K [N/m]; symmetric, M positive definite. Of NumPy or SciPy; up to 2000 rows.
    contacts : sequence of mappings
        Of each contact `name`, `normal` and `tangent`, and whatever else a `[[structure.contact]]` has:
        `second_tangent`, `initial_gap` [m], `static_friction`, `kinetic_friction`, `preload_share`, `drive_share`,
        `position` [m], `initial_rest` [s]. Directions are arrays with a number for each row, or text: "y1 -y2".
    values : mapping
        Of the rest of the case by key, as `Case.set` takes them: preload, both frictions and `drive.kind` at least.
    damping : array_like or sparse matrix, optional
        C [N*s/m].
    rows : sequence of str
        Their names; without it u1, u2, ...
    damping_ratio, loss_factor : float, optional
        [1] Damping of each mode of the structure without contacts.
    rayleigh_mass, rayleigh_stiffness : float, optional
        [1/s], [s] C = alpha M + beta K.
    load, force, initial_displacement, initial_velocity : array_like, optional
        A number for each row [N], [1], [m], [1].
    outputs : mapping, optional
        By name the direction of a point whose motion is wanted.
    springs : sequence of mappings
        Of each spring beside K its `direction`, an array or text as of contacts, and whatever else a
        `[[structure.spring]]` has: `name`, `stiffness` [N/m], `cubic` [N/m^3], `force` [N] at `deflection` [m],
        `exponent`, `gap` [m], `table` as text, `interpolation`, `preload_share`.
    title : str

    Returns
    -------
    Case

    Raises
    ------
    InputError
        For matrices that do not fit, and whatever the program refuses in such a file.

    Examples
    --------
    >>> import numpy, stridor
    >>> block = stridor.structure(
    ...     rows=["x", "y"], mass=0.1 * numpy.eye(2), stiffness=[[1e5, -4e4], [-4e4, 2e5]], damping_ratio=0.01,
    ...     contacts=[{"name": "foot", "normal": [0, 1], "tangent": [1, 0]}],
    ...     values={"preload": "5 N", "mu_s": 0.8, "mu_d": 0.3, "drive.kind": "constant", "drive.velocity": 0.02})
    >>> stridor.simulate(block).whole.category
    'none'
    """
    entries: _Entries = [("title", whole_text(title)), *_values(values), ("structure", None)]
    for name, matrix in (("mass", mass), ("stiffness", stiffness), ("damping", damping)):
        if matrix is not None:
            entries.append((f"structure.{name}", _matrix(name, matrix)))
    if len(rows):
        entries.append(("structure.rows", [whole_text(str(row)) for row in rows]))
    numbers = {"damping_ratio": damping_ratio, "loss_factor": loss_factor, "rayleigh_mass": rayleigh_mass,
               "rayleigh_stiffness": rayleigh_stiffness}
    entries += [(f"structure.{name}", _number(name, number)) for name, number in numbers.items() if number is not None]
    lists = {"load": load, "force": force, "initial_displacement": initial_displacement,
             "initial_velocity": initial_velocity}
    entries += [(f"structure.{name}", _list(name, list_of)) for name, list_of in lists.items() if list_of is not None]
    entries += _outputs({} if outputs is None else outputs)
    entries += _tables("contact", contacts, "{'name': ..., 'normal': ..., 'tangent': ...}")
    entries += _tables("spring", springs, "{'direction': ..., 'cubic': ...}")
    try:
        return Case._of(_stridor.from_entries(entries))
    except Error as error:
        raise _without_place(error) from None


def _values(values: Mapping[str, object]) -> _Entries:
    return [(_stridor.key_called(whole_text(str(name))), plain(value))
            for name, value in items_of("values by key", values)]


def _array(what: str, numbers: Any) -> Any:
    numpy = needed("numpy", "a structure")
    numbers = bare(what, numbers, _units.get(what, ""))
    if hasattr(numbers, "toarray") and max(numbers.shape) <= _most_rows:  # SciPy's sparse ones
        numbers = numbers.toarray()
    try:
        made = numpy.asarray(numbers)
        is_real = made.dtype.kind in "iuf"
    except ValueError:
        is_real = False
    if not is_real:
        raise InputError(f"{what} is no array of real numbers")
    if not numpy.isfinite(made).all():
        raise InputError(f"{what} has a number that is not finite")
    return made.astype(float)


def _matrix(name: str, matrix: Any) -> Any:
    matrix = bare(name, matrix, _units[name])
    shape = getattr(matrix, "shape", None)
    if shape is not None and len(shape) == 2 and max(shape) > _most_rows:
        raise InputError(f"{name} has the shape {shape[0]} x {shape[1]} (a structure has up to {_most_rows} rows). "
                         "Reduce it first: stridor structure reduce.")
    array = _array(name, matrix)
    if array.ndim != 2 or array.shape[0] != array.shape[1] or not array.size:
        raise InputError(f"{name} has the shape {' x '.join(map(str, array.shape)) or 'of a number'} "
                         "(a matrix of a structure is square)")
    return array


def _outputs(outputs: Mapping[str, Any]) -> _Entries:
    entries: _Entries = [("structure.output", None)]
    for number, (name, direction) in enumerate(items_of("directions by name", outputs), 1):
        table = f"structure.output.{number}"
        given = whole_text(direction) if isinstance(direction, str) else _list(f"output {name}", direction)
        entries += [(table, None), (f"{table}.name", whole_text(name)), (f"{table}.direction", given)]
    return entries if len(entries) > 1 else []


def _tables(kind: str, given: Sequence[Mapping[str, Any]], example: str) -> _Entries:
    entries: _Entries = [(f"structure.{kind}", None)]
    for number, one in enumerate(given, 1):
        if not isinstance(one, Mapping):
            raise InputError(f"{one!r} is no {kind}. Write it as {example}.")
        table = f"structure.{kind}.{number}"
        entries += [(table, None), *((f"{table}.{whole_text(str(key))}", _of_table(kind, str(key), value))
                                     for key, value in one.items() if not isinstance(value, str) or value)]
    return entries if len(entries) > 1 or kind == "contact" else []


def _of_table(kind: str, key: str, value: Any) -> Any:
    if isinstance(value, str):
        return whole_text(value)
    array = _array(key, value)
    if array.ndim > 1 and max(array.shape) == array.size:  # a row or a column of a matrix
        array = array.ravel()
    if array.ndim > 1:
        raise InputError(f"{key} of a {kind} has the shape {array.shape} (it has one number for each row)")
    return array if array.size > 1 else float(array.ravel()[0]) if array.size else array


def _number(name: str, number: Union[float, str]) -> float:
    array = _array(name, number)
    if array.ndim:
        raise InputError(f"{name} is no number")
    return float(array)


def _list(name: str, numbers: Any) -> Any:
    array = _array(name, numbers)
    if array.ndim != 1:
        raise InputError(f"{name} has the shape {array.shape} (it has one number for each row)")
    return array


def _without_place(error: Error) -> Error:
    """An error of what stands in no file."""
    return error._saying([(what, why, suggestion, None) for what, why, suggestion, _ in error.complaints])
