"""The explorer in one HTML file: in a notebook's cell without a server, or for somebody without Stridor."""

from __future__ import annotations

import os
import pathlib
import subprocess
from typing import Optional, Union

from . import _html
from ._case import CaseOrName, as_case
from ._given import files
from ._program import found
from .errors import FileError, InputError

__all__ = ["Page", "page"]

_height = 820  # [px] of the frame
_failed_file = 5  # the program's exit code where a file failed


class Page:
    """The explorer with a case, as the bytes of one HTML file. `page` makes it; in a notebook it is the cell's output.

    Examples
    --------
    >>> import stridor
    >>> stridor.page("squeal").save("seal.html")  # doctest: +SKIP
    """

    def __init__(self, content: bytes) -> None:
        self._content = content

    @property
    def content(self) -> bytes:
        """The bytes of the file.

        Examples
        --------
        >>> import stridor
        >>> stridor.page("squeal").content[:15]  # doctest: +SKIP
        b'<!doctype html>'
        """
        return self._content

    def save(self, path: Union[str, os.PathLike[str]]) -> None:
        """Writes the file, which a double click opens on any machine.

        Parameters
        ----------
        path : path
            "seal.html".

        Raises
        ------
        FileError
            Where it cannot be written.

        Examples
        --------
        >>> import stridor
        >>> stridor.page("squeal").save("seal.html")  # doctest: +SKIP
        """
        with files(f"write {os.fspath(path)}"):
            pathlib.Path(path).write_bytes(self._content)

    def __repr__(self) -> str:
        return f"<the explorer as an HTML file of {len(self._content) / 1e6:.1f} MB>"

    def _repr_html_(self) -> str:
        return _html.frame(self._content, _height, "Stridor's explorer")


def page(case: Optional[CaseOrName] = None) -> Page:
    """Makes the explorer with a case as one HTML file: sliders, chart, sounds, all computed in the browser.

    No server listens, so it works where `explore` cannot: in a notebook on a hub far away, in a saved notebook, in a
    mail. A notebook that is saved with it grows by 2 MB.

    Parameters
    ----------
    case : Case or str, optional
        What the page begins with, or the name of one that comes along; without it the paper's four.

    Returns
    -------
    Page

    Raises
    ------
    InputError
        For a case that leans on another file: a sampled drive.
    FileError
        Where the program is not there, or was built without the page.

    Examples
    --------
    >>> import stridor
    >>> stridor.page("squeal").save("seal.html")  # doctest: +SKIP
    """
    text = "" if case is None else as_case(case).to_toml()
    command = [found("stridor"), "page", *(["-"] if case is not None else [])]
    try:
        done = subprocess.run(command, input=text.encode(), capture_output=True, check=False)
    except OSError as error:
        raise FileError(f"the page cannot be made ({error})") from None
    if done.returncode != 0:
        kind = FileError if done.returncode == _failed_file else InputError
        raise kind(done.stderr.decode("utf-8", "replace").strip().replace("stridor: error: ", ""))
    return Page(done.stdout)
