"""The notebooks are executed, as scripts and in a kernel; what they state stands in them as assertions."""

import importlib.util
import json
import os
import subprocess
import sys

import pytest
from conftest import ROOT, needed

FOLDER = ROOT / "docs" / "notebooks"
NAMES = ["first_steps", "design_study", "recording_to_design", "own_structure"]

_spec = importlib.util.spec_from_file_location("to_ipynb", FOLDER / "to_ipynb.py")
to_ipynb = importlib.util.module_from_spec(_spec)
_spec.loader.exec_module(to_ipynb)

# each figure must have drawn something, with its axes named
CHECK = """
import matplotlib.pyplot as plt
for number in plt.get_fignums():
    for axes in plt.figure(number).axes:
        assert axes.has_data() and (axes.get_xlabel() or axes.get_ylabel()), number
print("figures:", len(plt.get_fignums()))
"""


def script(name):
    return (FOLDER / f"{name}.py").read_text(encoding="utf-8")


def test_all_of_them_are_tested():
    assert sorted(path.stem for path in FOLDER.glob("*.py")) == sorted([*NAMES, "to_ipynb"])


@pytest.mark.parametrize("name", NAMES)
def test_it_runs_as_a_script(name, tmp_path):
    needed("xarray"), needed("matplotlib")
    (tmp_path / "checked.py").write_text(script(name) + CHECK, encoding="utf-8")
    done = subprocess.run([sys.executable, "-B", "-W", "error::UserWarning", "checked.py"], capture_output=True,
                          text=True, timeout=120,
                          env={**os.environ, "MPLBACKEND": "agg", "TMPDIR": str(tmp_path)})
    assert done.returncode == 0, done.stderr
    assert int(done.stdout.split("figures:")[1]) >= 2


@pytest.mark.parametrize("name", NAMES)
def test_it_runs_as_a_notebook(name, tmp_path, monkeypatch):
    needed("xarray"), needed("matplotlib")
    nbformat, nbclient = needed("nbformat"), needed("nbclient")
    needed("ipykernel")
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    monkeypatch.delenv("MPLBACKEND", raising=False)
    notebook = nbformat.reads(json.dumps(to_ipynb.notebook_of(script(name))), as_version=4)
    nbformat.validate(notebook)
    nbclient.NotebookClient(notebook, timeout=120, kernel_name="python3").execute(cwd=str(tmp_path))
    shown = [output for cell in notebook.cells for output in cell.get("outputs", [])]
    assert sum("image/png" in output.get("data", {}) for output in shown) >= 2
    assert any("text/html" in output.get("data", {}) for output in shown)


def test_a_script_and_its_notebook_hold_the_same():
    for name in NAMES:
        cells = to_ipynb.cells_of(script(name))
        assert cells[0][0] == "markdown" and cells[0][1].startswith("# ") and len(cells) >= 8
        assert any("**Limits.**" in text for kind, text in cells if kind == "markdown")
        for kind, text in cells:
            assert kind == "code" or not text.startswith("# %%")
            if kind == "code":
                compile(text, name, "exec")
