"""The explorer: a page on which a case is live, in a notebook's cell or in the browser."""

from __future__ import annotations

import atexit
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import threading
from typing import Any, List, Optional, Type
from urllib.parse import urlsplit

from . import _html
from ._case import CaseOrName, as_case
from ._given import files, whole
from ._program import ends_with_its_parent, found
from .errors import Error, FileError, InputError

__all__ = ["Explorer", "explore"]

_height = 720  # [px] of the frame
_start = 60.0  # [s] in which a program that begins says its link


class Explorer:
    """A running explorer. `explore` makes it.

    It ends with the object's `close`, with a `with` block, and with this process however that ends. In a notebook it
    shows its page in the cell.

    Examples
    --------
    >>> import stridor
    >>> with stridor.explore(stridor.case("squeal"), browser="none") as explorer:
    ...     explorer.url.startswith("http://localhost:")
    True
    """

    def __init__(self, command: List[str], text: str) -> None:
        self._owner = os.getpid()
        self._process: Optional[subprocess.Popen[str]] = None
        self._links: List[str] = []
        self._error: Optional[Exception] = None
        self._changed = threading.Condition()
        with files("make a temporary file"):
            self._complaints: Any = tempfile.TemporaryFile("w+", encoding="utf-8", errors="replace")
        # the child ends with the thread that started it: this one lives as long as the child
        self._thread = threading.Thread(target=self._serve, args=(command, text), name="stridor explore", daemon=True)
        self._thread.start()
        with self._changed:
            self._changed.wait_for(lambda: self._links or not self._thread.is_alive() or self._error, timeout=_start)
        if not self._links:
            self.close()
            raise self._failure()
        atexit.register(self.close)

    @property
    def url(self) -> str:
        """The newest link. Each opens once; the next one follows as soon as it was used."""
        return self._links[-1]

    @property
    def is_running(self) -> bool:
        """Whether the program still answers."""
        return self._process is not None and self._process.poll() is None

    def close(self) -> None:
        """Ends the program. What was shown in frames stays as it is, and answers no more.

        Examples
        --------
        >>> import stridor
        >>> explorer = stridor.explore(stridor.case("squeal"), browser="none")
        >>> explorer.close()
        >>> explorer.is_running
        False
        """
        if os.getpid() != self._owner:  # a copy by fork: it is not its child
            return
        atexit.unregister(self.close)
        if self._process is not None and self._process.poll() is None:
            self._process.terminate()
            try:
                self._process.wait(timeout=5)
            except subprocess.TimeoutExpired:
                self._process.kill()
        self._thread.join(timeout=5)

    def wait(self) -> None:
        """Waits until the program ends; Ctrl-C ends it. A script calls it to stay.

        Examples
        --------
        >>> import stridor
        >>> explorer = stridor.explore(stridor.case("squeal"), browser="none")
        >>> explorer.close()
        >>> explorer.wait()
        """
        try:
            while self._thread.is_alive():
                self._thread.join(timeout=0.2)
        except KeyboardInterrupt:
            self.close()

    def _serve(self, command: List[str], text: str) -> None:
        try:
            self._process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                             stderr=self._complaints, text=True, encoding="utf-8",
                                             start_new_session=True, preexec_fn=ends_with_its_parent())
            assert self._process.stdin is not None and self._process.stdout is not None
            try:
                self._process.stdin.write(text)
                self._process.stdin.close()
            except BrokenPipeError:
                pass  # it says why
            for line in self._process.stdout:
                self._add(line.strip())
            self._process.wait()
        except (OSError, ValueError) as error:  # a null byte in what it is told
            self._error = error
        with self._changed:
            self._error = self._error or Error("the explorer has ended")
            self._changed.notify_all()

    def _add(self, link: str) -> None:
        with self._changed:
            self._links.append(link)
            self._changed.notify_all()

    def _failure(self) -> Exception:
        if isinstance(self._error, (OSError, ValueError)):
            kind = FileError if isinstance(self._error, OSError) else InputError
            return kind(f"the explorer cannot be started ({self._error})")
        self._complaints.seek(0)
        text = self._complaints.read().strip().replace("stridor: error: ", "")
        return InputError(text or "the explorer did not start")

    def __enter__(self) -> Explorer:
        return self

    def __exit__(self, kind: Optional[Type[BaseException]], value: Optional[BaseException], trace: object) -> None:
        self.close()

    def __repr__(self) -> str:
        return f"<explorer at {self.url}>" if self.is_running else "<explorer that has ended>"

    def _repr_html_(self) -> str:
        if not self.is_running:
            return _html.escaped(repr(self)[1:-1])
        return (f'<iframe src="{_html.escaped(self.url)}" width="100%" height="{_height}" style="border:0" '
                f'allow="autoplay; clipboard-write" title="Stridor\'s explorer"></iframe>')


def explore(
    case: Optional[CaseOrName] = None,
    *,
    frame: Optional[str] = None,
    threads: int = 0,
    browser: str = "",
) -> Explorer:
    """Starts the explorer with a case: in a notebook its page is the cell's output, else the browser opens it.

    The program `stridor explore` runs beside this process and ends with it. Only who has its link sees it, on this
    machine alone; only `frame` may show it in a frame.

    Parameters
    ----------
    case : Case or str, optional
        What the page begins with, or the name of one that comes along; without it the paper's squeal.
    frame : str, optional
        The origin of the notebook's page, as the browser shows it: "http://127.0.0.1:8888". Without it what the
        notebook's server says of itself, else "http://localhost:8888".
    threads : int
        [1] For charts; 0: one per processor.
    browser : {"", "none"}
        "none" only gives the link. Without it the link is printed outside of notebooks, and opened where there is a
        screen.

    Returns
    -------
    Explorer

    Raises
    ------
    InputError
        For an origin that is none, or is of another machine.
    FileError
        Where the program is not there.

    Examples
    --------
    >>> import stridor
    >>> with stridor.explore(stridor.case("creak"), frame="http://127.0.0.1:8888", browser="none") as explorer:
    ...     explorer.url.startswith("http://127.0.0.1:")
    True
    """
    if browser not in ("", "none"):
        raise InputError(f'browser = "{browser}" is not one of its choices. Choose "" or "none".')
    if frame is not None and not isinstance(frame, str):
        raise InputError(f"frame = {frame!r} is no origin. Write \"http://127.0.0.1:8888\".")
    text = "" if case is None else as_case(case).to_toml()
    command = [found("stridor"), "explore", *(["-"] if case is not None else []),
               "--frame", _notebook_origin() if frame is None else frame, "--threads", str(whole("threads", threads))]
    is_shown_elsewhere = browser == "none" or _is_notebook()
    explorer = Explorer(command + ["--no-browser"] * is_shown_elsewhere, text)
    if not is_shown_elsewhere:
        print(explorer.url)
    return explorer


def _is_notebook() -> bool:
    """Whether this process is a notebook's kernel."""
    ipython = sys.modules.get("IPython")
    shell: Any = ipython.get_ipython() if ipython is not None else None
    return getattr(shell, "kernel", None) is not None


def _notebook_origin() -> str:
    """What the server that started this kernel has written about itself: its address, without what opens it."""
    usual = "http://localhost:8888"
    server = os.environ.get("JPY_PARENT_PID", "")
    if not server.isdigit():
        return usual
    for name in ("jpserver", "nbserver"):
        try:
            about = json.loads((_runtime_folder() / f"{name}-{server}.json").read_text(encoding="utf-8"))
            parts = urlsplit(str(about["url"]))
            port = parts.port
        except (OSError, ValueError, KeyError, TypeError):
            continue
        # a server of all addresses is opened by this machine's name for itself
        host = "127.0.0.1" if parts.hostname == "127.0.0.1" else "localhost"
        return f"{parts.scheme}://{host}" + (f":{port}" if port else "")
    return usual


def _runtime_folder() -> pathlib.Path:
    named = os.environ.get("JUPYTER_RUNTIME_DIR")
    if named:
        return pathlib.Path(named)
    data = os.environ.get("XDG_DATA_HOME") or str(pathlib.Path.home() / ".local" / "share")
    return pathlib.Path(os.environ.get("JUPYTER_DATA_DIR") or str(pathlib.Path(data) / "jupyter")) / "runtime"
