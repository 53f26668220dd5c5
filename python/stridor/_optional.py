"""Packages that are imported only where they are used, and what to do where one is missing."""

from __future__ import annotations

import importlib
from typing import Any

_debian = {"xarray": "python3-xarray", "pandas": "python3-pandas", "matplotlib": "python3-matplotlib",
           "numpy": "python3-numpy", "netCDF4": "python3-netcdf4"}


def needed(name: str, what: str) -> Any:
    """The module `name`, without which there is no `what`."""
    try:
        return importlib.import_module(name)
    except ImportError as error:
        package = name.split(".")[0]
        raise ImportError(f"{what} needs {package} (Debian: {_debian[package]}; pip: {package})") from error


def progress_bar(total_unit: str) -> Any:
    """tqdm's bar, or nothing where tqdm is not there."""
    try:
        return importlib.import_module("tqdm.auto").tqdm(total=0, unit=total_unit, leave=False)
    except ImportError:
        return None
