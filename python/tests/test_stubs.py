"""What type checkers are told is what is there."""

import os
import pathlib
import shutil
import subprocess
import sys

import pytest
from conftest import ROOT, needed

import stridor

PACKAGE = pathlib.Path(stridor.__file__).parent


def mypy(*arguments, **more):
    needed("mypy")
    environment = {**os.environ, "MYPYPATH": str(PACKAGE.parent), "MYPY_CACHE_DIR": os.environ.get("TMPDIR", "/tmp") +
                   f"/stridor-mypy-{os.getuid()}"}
    return subprocess.run([sys.executable, "-m", *arguments], capture_output=True, text=True, env=environment, **more)


def test_stubs_say_what_is_there(tmp_path):
    # of a copy: links into two folders are two modules of one name for mypy
    shutil.copytree(PACKAGE, tmp_path / "stridor")
    environment = {**os.environ, "PYTHONPATH": str(tmp_path), "MYPYPATH": str(tmp_path)}
    needed("mypy")
    (tmp_path / "mypy.ini").write_text("[mypy]\nignore_missing_imports = True\n")
    done = subprocess.run([sys.executable, "-m", "mypy.stubtest", "--mypy-config-file", "mypy.ini",
                           "--allowlist", str(ROOT / "python" / "tests" / "stubtest_allowed.txt"),
                           "--ignore-unused-allowlist",
                           "stridor"],
                          capture_output=True, text=True, env=environment, cwd=tmp_path)
    assert done.returncode == 0, done.stdout + done.stderr


def test_the_generated_stub_is_that_of_the_tables():
    done = subprocess.run([sys.executable, "-B", str(ROOT / "python" / "tests" / "write_stubs.py")],
                          capture_output=True, text=True, check=True)
    assert done.stdout == (ROOT / "python" / "stridor" / "_fields.pyi").read_text(encoding="utf-8")


@pytest.mark.parametrize("what", ["the package", "an example"])
def test_types_are_strict(tmp_path, what):
    shutil.copytree(PACKAGE, tmp_path / "stridor")
    path = tmp_path / "stridor" if what == "the package" else ROOT / "python" / "tests" / "typed_example.py"
    done = mypy("mypy", "--strict", "--ignore-missing-imports", "--follow-imports=silent", str(path), cwd=tmp_path)
    assert done.returncode == 0, done.stdout + done.stderr


def test_a_wrong_type_is_found(tmp_path):
    shutil.copytree(PACKAGE, tmp_path / "stridor")
    (tmp_path / "wrong.py").write_text("import stridor\ncase: int = stridor.case('squeal')\n"
                                       "stridor.case('squeal').contact.preload = [1]\n")
    done = mypy("mypy", "--strict", "--ignore-missing-imports", "--follow-imports=silent", "wrong.py", cwd=tmp_path)
    assert done.returncode == 1 and done.stdout.count("error:") == 2, done.stdout


def test_the_typed_example_runs():
    done = subprocess.run([sys.executable, "-B", str(ROOT / "python" / "tests" / "typed_example.py")],
                          capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert "squeal" in done.stdout
