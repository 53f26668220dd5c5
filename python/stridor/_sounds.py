"""Sounds: motions made audible, recordings, the noise library."""

from __future__ import annotations

import base64
import json
import os
import pathlib
from typing import Any, Dict, List, Optional, Sequence, Union

from . import _html, _stridor
from ._case import CaseOrName, as_case
from ._design import _Document
from ._given import files, plain, temporary_folder
from ._optional import needed
from .errors import FileError, InputError

__all__ = ["Hearing", "Library", "Recording", "Sound", "library", "listen", "read_sound"]

Path = Union[str, os.PathLike[str]]
_largest_player = 8_000_000  # [bytes] of a sound that goes into a notebook


class Sound:
    """A motion as a sound. `listen` makes it.

    Attributes
    ----------
    about : dict
        What was made audible: `quantity`, `component`, `rate` [Hz], `duration` [s], `peak`, `rms` and `full_scale`
        [m/s or m/s^2]. It is the motion itself, and no sound pressure.

    Examples
    --------
    >>> import stridor
    >>> stridor.listen(stridor.case("squeal")).about["rate"]
    48000.0
    """

    def __init__(self, document: str, wav: bytes) -> None:
        self.about: Dict[str, Any] = json.loads(document)["sound"]
        self._document = document
        self._wav = wav

    def save(self, path: Path) -> None:
        """Writes a WAV file of 24 bits, which says what its full scale stands for, and holds its case.

        Examples
        --------
        >>> import stridor
        >>> stridor.listen(stridor.case("squeal"), seconds=0.4).save("squeal.wav")
        >>> stridor.read_sound("squeal.wav").classify().category
        'squeal'
        """
        _stridor.write_file(os.fspath(path), self._wav)

    def __repr__(self) -> str:
        return f"<sound of {self.about['duration']:g} s: {self.about['quantity']} of {self.about['of']}>"

    def _repr_html_(self) -> str:
        title = _html.escaped(repr(self)[1:-1])
        if len(self._wav) > _largest_player:
            return f"{title}, too long to be played here"
        data = base64.b64encode(self._wav).decode()
        return f'{title}<br><audio controls src="data:audio/wav;base64,{data}"></audio>'


def _chosen(what: str, word: str, words: Sequence[str]) -> str:
    if word not in words:
        raise InputError(f'{what} = "{word}" is not one of its choices. Choose {", ".join(filter(None, words))}.')
    return word


def listen(
    case: CaseOrName,
    *,
    of: str = "joint",
    quantity: str = "velocity",
    component: str = "",
    direction: str = "",
    seconds: Union[float, str] = "",
    rate: Union[float, str] = 48000.0,
) -> Sound:
    """Makes a motion audible.

    Parameters
    ----------
    case : Case or str
        The name of one that comes along will do.
    of : str
        "joint", "plate", or the name of one of several joints; of a structure of one's own a contact or a row.
    quantity : {"velocity", "acceleration"}
    component : {"", "x", "y"}
        Along or across the contact; without it x of the joint, y of the plate.
    direction : {"", "going", "coming"}
        Only these phases.
    seconds : float or str
        How much of the motion [s]; more than the run lasts simulates longer.
    rate : float or str
        Samples per second [Hz].

    Returns
    -------
    Sound
        In a notebook a player.

    Examples
    --------
    >>> import stridor
    >>> stridor.listen(stridor.case("squeal"), direction="going").about["quantity"]
    'velocity'
    """
    asked = [
        _chosen("direction", direction, ("", "going", "coming")),
        of,
        _chosen("quantity", quantity, ("velocity", "acceleration")),
        _chosen("component", component, ("", "x", "y")),
        _in(rate, "Hz"),
        _in(seconds, "s"),
    ]
    with temporary_folder() as folder:
        path = pathlib.Path(folder) / "sound.wav"
        document = _stridor.listen(as_case(case)._handle, asked, str(path))
        with files("read the sound again"):
            return Sound(document, path.read_bytes())


def _in(value: Union[float, str], unit: str) -> str:
    given = plain(value)
    return given if isinstance(given, str) else f"{given!r} {unit}"


class Hearing(_Document):
    """What is heard in a recording. `Recording.classify` makes it.

    Examples
    --------
    >>> import stridor
    >>> stridor.listen(stridor.case("creak"), seconds=0.4).save("creak.wav")
    >>> len(stridor.read_sound("creak.wav").classify().reasons) > 0
    True
    """

    def _loudest(self) -> Dict[str, Any]:
        channel: Dict[str, Any] = self._document["channels"][int(self._document["channel"]) - 1]
        return channel

    @property
    def category(self) -> str:
        """Of the loudest channel."""
        return str(self._document["category"])

    @property
    def reasons(self) -> List[str]:
        """Why, in sentences."""
        return list(self._loudest()["verdict"]["reasons"])

    @property
    def segments(self) -> List[Dict[str, Any]]:
        """The parts of the loudest channel: from and to [s], category, level and features."""
        return list(self._loudest()["verdict"]["segments"])

    def __repr__(self) -> str:
        return f"<heard as {self.category}: {' '.join(self.reasons)}>"

    def _repr_html_(self) -> str:
        return _html.badge(self.category) + " " + _html.escaped(" ".join(self.reasons))


class Recording:
    """A recording on the disk. `read_sound` makes it; it is read when something is asked of it.

    Examples
    --------
    >>> import stridor
    >>> stridor.listen(stridor.case("squeal"), seconds=0.4).save("door.wav")
    >>> stridor.read_sound("door.wav", full_scale="2 m/s").path.name
    'door.wav'
    """

    def __init__(self, path: pathlib.Path, full_scales: List[str], channel: str) -> None:
        self.path = path
        self._full_scales = full_scales
        self._channel = channel

    def classify(self) -> Hearing:
        """Hears whether it squeals, squeaks, creaks or is quiet, as `stridor classify` does.

        Examples
        --------
        >>> import stridor
        >>> stridor.listen(stridor.case("squeal"), seconds=0.4).save("door.wav")
        >>> stridor.read_sound("door.wav").classify().category
        'squeal'
        """
        return Hearing(_stridor.classify(str(self.path), self._full_scales, self._channel))

    def __repr__(self) -> str:
        return f"<recording {self.path}>"


def read_sound(path: Path, *, full_scale: Union[str, Sequence[str]] = (), channel: Union[int, str] = "") -> Recording:
    """A recording: WAV, FLAC, Ogg, MP3, AIFF, M4A, CSV, UFF 58 or MAT.

    Parameters
    ----------
    path : path
    full_scale : str, or one for each channel
        What the number 1 of the file stands for, where it does not say it: "2 Pa".
    channel : int or str
        This one alone, by its number from 1 or its name.

    Raises
    ------
    FileError
        For a file that is not there.

    Examples
    --------
    >>> import stridor
    >>> stridor.listen(stridor.case("squeal"), seconds=0.4).save("door.wav")
    >>> stridor.read_sound("door.wav", channel=1).classify().category
    'squeal'
    """
    scales = [full_scale] if isinstance(full_scale, str) else list(full_scale)
    recording = pathlib.Path(path)
    if not recording.is_file():
        raise FileError(f'cannot read "{recording}" (there is no such file)')
    return Recording(recording, scales, str(channel))


class Library:
    """A noise library. `library` makes it.

    Examples
    --------
    >>> import stridor
    >>> stridor.library("noises.sqlite").path.name
    'noises.sqlite'
    """

    def __init__(self, path: Optional[pathlib.Path]) -> None:
        self.path = path if path is not None else pathlib.Path()
        self._named = "" if path is None else str(path)

    def find(self, where: str = "", *, search: str = "", sort: str = "", **equal: object) -> List[Dict[str, Any]]:
        """The entries that meet all conditions, with all that is known of them.

        Parameters
        ----------
        where : str
            "preload > 10 N and system = brake"; comparisons are = != < <= > >= ~ (contains).
        search : str
            Words that the text of the entry holds.
        sort : str
            A field or a figure; "-preload" from the highest.
        **equal
            Fields by name: ``category="creak"``.

        Returns
        -------
        list of dict
            As `stridor library list --json` prints them.

        Examples
        --------
        >>> import stridor
        >>> try:
        ...     stridor.library("missing.sqlite").find(category="creak")
        ... except stridor.Error as error:
        ...     print("missing.sqlite" in error.what)
        True
        """
        conditions = ([where] if where else []) + [f'{name} = "{value}"' for name, value in equal.items()]
        document = json.loads(_stridor.find(self._named, conditions, search, sort))
        entries: List[Dict[str, Any]] = document["entries"]
        return entries

    def to_pandas(self, where: str = "", *, search: str = "", sort: str = "", **equal: object) -> Any:
        """The same as a table with a row for each entry.

        Returns
        -------
        pandas.DataFrame

        Examples
        --------
        >>> import stridor
        >>> try:
        ...     stridor.library("missing.sqlite").to_pandas("preload > 10 N")
        ... except stridor.Error as error:
        ...     print("missing.sqlite" in error.what)
        True
        """
        pandas = needed("pandas", "a table")
        return pandas.json_normalize(self.find(where, search=search, sort=sort, **equal))

    def __repr__(self) -> str:
        return f"<noise library {self._named or 'of this user'}>"


def library(path: Optional[Path] = None) -> Library:
    """The noise library in a file; without a name the user's own.

    Examples
    --------
    >>> import stridor
    >>> stridor.library("noises.sqlite")
    <noise library noises.sqlite>
    """
    return Library(None if path is None else pathlib.Path(path))
