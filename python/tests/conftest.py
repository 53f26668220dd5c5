"""What the tests share."""

import os
import pathlib
import subprocess
import sys

import pytest

import stridor

ROOT = pathlib.Path(__file__).resolve().parents[2]


def needed(name):
    """A package that the tests need; where CI is set its absence is a failure."""
    try:
        return __import__(name)
    except ImportError:
        if os.environ.get("CI"):
            raise
        pytest.skip(f"{name} is not installed")


@pytest.fixture(autouse=True)
def own_folder(tmp_path, monkeypatch):
    """Each test works in a folder of its own."""
    monkeypatch.chdir(tmp_path)


@pytest.fixture
def squeal():
    return stridor.case("squeal")


@pytest.fixture
def program():
    """Runs the program, and gives what it printed."""

    def run(*arguments):
        command = [os.environ["STRIDOR_PROGRAM"], *arguments]
        return subprocess.run(command, check=True, capture_output=True, text=True).stdout

    return run


@pytest.fixture
def small_chart():
    """How a chart of few cells is made; `more` goes to `stridor.chart`."""

    def make(**more):
        axes = {"x": stridor.axis("preload", 2, 4000, 6), "y": stridor.axis("mu_d", 0.0, 0.8, 5)}
        return stridor.chart(stridor.case("noise-chart"), **{**axes, **more})

    return make


def python(text, **more):
    """Runs Python text in an interpreter of its own."""
    return subprocess.run([sys.executable, "-B", "-c", text], capture_output=True, text=True, timeout=120, **more)
