"""Every public name has a docstring, a stub and an example that is executed."""

import doctest
import importlib
import inspect
import os

import pytest
from conftest import needed

import stridor

MODULES = ["stridor"] + [f"stridor.{name}" for name in (
    "errors", "_axis", "_case", "_chart_parts", "_chart_run", "_charts", "_design", "_evaluate", "_explorer", "_motion",
    "_sounds", "_structure", "xarray_backend")]


def public_members():
    """All names of the package, and what is public of its classes."""
    for name in stridor.__all__:
        thing = getattr(stridor, name)
        yield name, thing
        if inspect.isclass(thing) and thing.__module__.startswith("stridor"):
            for member, value in vars(thing).items():
                if not member.startswith("_") and (callable(value) or isinstance(value, (property, classmethod))):
                    yield f"{name}.{member}", value


@pytest.mark.parametrize("name, thing", list(public_members()), ids=[name for name, _ in public_members()])
def test_it_has_a_docstring(name, thing):
    document = inspect.getdoc(thing)
    assert document and document.strip().endswith((".", "`", ")", "'", "]", "True", "2")) or ">>>" in document
    is_function = callable(thing) and not isinstance(thing, property)
    if is_function and not inspect.ismodule(thing) and name not in ("Chart.boundaries",):
        assert ">>>" in document, f"{name} has no example"


def test_all_of_it_is_listed():
    found = {name for name in dir(stridor) if not name.startswith("_")}
    assert found - {"xarray_backend"} == set(stridor.__all__)


@pytest.mark.parametrize("module", MODULES)
def test_examples_do_what_they_say(module):
    needed("xarray"), needed("netCDF4"), needed("pandas"), needed("matplotlib")
    results = doctest.testmod(importlib.import_module(module))
    assert results.failed == 0 and results.attempted > 0


def test_nothing_heavy_is_imported_before_it_is_used():
    from conftest import python

    done = python("import sys, stridor; print([m for m in ('xarray', 'pandas', 'matplotlib', 'netCDF4', 'tqdm') "
                  "if m in sys.modules])", env={**os.environ})
    assert done.stdout == "[]\n", done.stderr


def test_the_version_is_the_programs(program):
    assert stridor.__version__ in program("--version")


def test_a_missing_package_is_named(squeal, monkeypatch):
    import sys

    monkeypatch.setitem(sys.modules, "xarray", None)
    with pytest.raises(ImportError, match="python3-xarray"):
        stridor.simulate(squeal).trace(0, "1 ms")
