"""Charts by the program for clusters, on the ranks of an MPI job."""

from __future__ import annotations

import os
import pathlib
import re
import signal
import subprocess
from typing import Dict, List, Sequence, Type

from . import _stridor
from ._program import ends_with_its_parent, found
from .errors import Error, FileError, InputError, Interrupted, NumericalError

_patience = 15.0  # [s] for a job that was told to stop: ranks keep what they have within one
# by the program's exit code
_errors: Dict[int, Type[Error]] = {2: InputError, 3: NumericalError, 4: Interrupted, 5: FileError}


def launched(launcher: Sequence[str], study: _stridor.StudyHandle, folder: pathlib.Path, threads: int) -> None:
    """Has a study computed in its folder by `LAUNCHER stridor-mpi chart`, which goes on with what is there."""
    if isinstance(launcher, str) or not all(isinstance(word, str) for word in launcher):
        raise InputError(f'launcher = {launcher!r} is no list of words. Write ["mpirun", "-n", "64"].')
    put_study(study, folder / "chart.toml")
    command = [*launcher, found("stridor-mpi"), "chart", str(folder / "chart.toml"), "--out", str(folder),
               "--files", "csv,boundaries,nc", *(["--threads", str(threads)] if threads else [])]
    try:
        process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                   text=True, errors="replace", start_new_session=True,
                                   preexec_fn=ends_with_its_parent())
    except OSError as error:
        raise FileError(f"{launcher[0]} cannot be started ({error.strerror})") from None
    try:
        said, _ = process.communicate()
    except BaseException as error:
        _end(process)
        if isinstance(error, KeyboardInterrupt):
            raise Interrupted(f"stopped; the same call goes on with {folder}") from None
        raise
    if process.returncode != 0:
        kind = _errors.get(process.returncode, Error)
        raise kind(_reason(said) or f"{launcher[0]} ended with {process.returncode}")


def put_study(study: _stridor.StudyHandle, path: pathlib.Path) -> None:
    """The study's file, for all ranks; another chart's is left alone."""
    text = study.toml()
    if path.exists():
        if _stridor.read_study(str(path)).toml() != text:
            raise InputError(f"{path.parent} holds another chart. Choose another folder, or remove it.")
        return
    _stridor.write_file(str(path), text)


def _end(process: subprocess.Popen[str]) -> None:
    process.send_signal(signal.SIGTERM)
    try:
        process.communicate(timeout=_patience)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.communicate()


def _reason(said: str) -> str:
    """What the program said of its end, without what the launcher adds; all of it where there is no such line."""
    lines: List[str] = re.findall(r"^(?:stridor(?:-mpi)?: error: |help: )(.*)$", said, re.MULTILINE)
    return "\n".join(dict.fromkeys(lines)) or said.strip()
