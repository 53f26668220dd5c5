"""`pip install .` as users type it, without the network, of the module that lies in the build folder."""

import base64
import csv
import hashlib
import io
import os
import subprocess
import sys
import tarfile
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent.parent
BUILT = os.environ["STRIDOR_BUILD_FOLDER"]
sys.path.insert(0, str(ROOT / "python"))
backend = pytest.importorskip("backend")


def run(*command, code=0, **options):
    # the package of the build folder must not be found in place of the installed one
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    environment.update(PIP_DISABLE_PIP_VERSION_CHECK="1", PYTHONDONTWRITEBYTECODE="1")
    done = subprocess.run(
        [str(word) for word in command], env=environment, capture_output=True, text=True, check=False, **options
    )
    assert done.returncode == code, done.stdout + done.stderr
    return done.stdout + done.stderr


@pytest.fixture(scope="module")
def venv(tmp_path_factory):
    folder = tmp_path_factory.mktemp("venv")
    run(sys.executable, "-m", "venv", "--system-site-packages", folder)
    return folder


def files_of(venv):
    # what pip itself compiles when it starts is no part of it
    return sorted(str(file) for file in venv.rglob("*") if "__pycache__" not in str(file))


def where_installed(venv, folder):
    return run(venv / "bin/python", "-c", "import stridor; print(stridor.__file__)", cwd=folder).strip()


def test_a_package_is_installed_used_and_removed(venv, tmp_path):
    before = files_of(venv)
    run(venv / "bin/pip", "install", "--no-index", f"--config-settings=built={BUILT}", ROOT)
    assert where_installed(venv, tmp_path).startswith(str(venv))
    use = "import stridor; print(stridor.simulate(stridor.case('squeal')).going.category, stridor.__version__)"
    assert run(venv / "bin/python", "-c", use, cwd=tmp_path) == f"squeal {backend.project()[0]}\n"
    engines = "import xarray; print('stridor' in xarray.backends.list_engines())"
    assert run(venv / "bin/python", "-c", engines, cwd=tmp_path).endswith("True\n")
    assert backend.project()[0] in run(venv / "bin/stridor", "--version", cwd=tmp_path)
    shown = run(venv / "bin/pip", "show", "stridor")
    assert f"Version: {backend.project()[0]}" in shown
    assert "Requires: numpy" in shown
    run(venv / "bin/pip", "uninstall", "--yes", "stridor")
    assert files_of(venv) == before
    assert "No module named 'stridor'" in run(venv / "bin/python", "-c", "import stridor", code=1, cwd=tmp_path)


def alone():
    """The environment of one who has no other Stridor."""
    return {name: value for name, value in os.environ.items() if not name.startswith(("STRIDOR", "PYTHON"))} | {
        "PATH": "/usr/bin:/bin"}


@pytest.mark.parametrize("option", [[], ["--no-deps", "--target", "folder"]], ids=["environment", "folder"])
def test_the_explorer_is_there_after_it(venv, tmp_path, option):
    run(venv / "bin/pip", "install", "--no-index", f"--config-settings=built={BUILT}", *option, ROOT, cwd=tmp_path)
    use = ("import stridor\n"
           "with stridor.explore('squeal', browser='none') as explorer:\n"
           "    print(explorer._process.args[0], explorer.url)\n")
    path = {"PYTHONPATH": "folder"} if option else {}
    done = subprocess.run([venv / "bin/python", "-c", use], cwd=tmp_path, env={**alone(), **path}, text=True,
                          capture_output=True)
    assert done.returncode == 0, done.stderr
    program, link = done.stdout.split()
    assert Path(program).is_relative_to(tmp_path / "folder" if option else venv) and link.startswith("http://localhost")
    if not option:
        run(venv / "bin/pip", "uninstall", "--yes", "stridor")


def test_what_is_not_there_is_said_with_a_way_to_get_it(venv, tmp_path):
    run(venv / "bin/pip", "install", "--no-index", f"--config-settings=built={BUILT}", ROOT)
    for program in ("stridor", "stridor-mpi"):
        (venv / "bin" / program).unlink(missing_ok=True)
    use = ("import stridor\n"
           "axes = {'x': stridor.axis('preload', 2, 4000, 3), 'y': stridor.axis('mu_d', 0.0, 0.8, 3)}\n"
           "for call in (lambda: stridor.explore('squeal'),\n"
           "             lambda: stridor.chart('noise-chart', **axes, out='out', launcher=['mpirun'])):\n"
           "    try:\n"
           "        call()\n"
           "    except stridor.FileError as error:\n"
           "        print(error.what, '-', error.suggestion)\n")
    done = subprocess.run([venv / "bin/python", "-c", use], cwd=tmp_path, env=alone(), text=True, capture_output=True)
    assert done.returncode == 0, done.stderr
    explorer, cluster = done.stdout.splitlines()
    assert explorer.startswith("the program stridor is not found") and "pip install" in explorer
    assert cluster.startswith("the program stridor-mpi is not found") and "libopenmpi-dev" in cluster
    run(venv / "bin/pip", "uninstall", "--yes", "stridor")


def test_an_editable_package_is_that_of_the_build_folder(venv, tmp_path):
    before = files_of(venv)
    run(venv / "bin/pip", "install", "--no-index", f"--config-settings=built={BUILT}", "-e", ROOT)
    assert Path(where_installed(venv, tmp_path)).is_relative_to(Path(BUILT).resolve())
    run(venv / "bin/pip", "uninstall", "--yes", "stridor")
    assert files_of(venv) == before


def test_the_same_bytes_every_time(tmp_path):
    contents = []
    for name in ("one", "two"):
        (tmp_path / name).mkdir()
        wheel = backend.build_wheel(tmp_path / name, {"built": BUILT})
        contents.append((tmp_path / name / wheel).read_bytes())
    assert contents[0] == contents[1]


def test_a_wheel_has_all_that_is_installed_and_says_its_hashes(tmp_path):
    with zipfile.ZipFile(tmp_path / backend.build_wheel(tmp_path, {"built": BUILT})) as wheel:
        names = wheel.namelist()
        about = f"stridor-{backend.project()[0]}.dist-info"
        rows = list(csv.reader(io.StringIO(wheel.read(f"{about}/RECORD").decode())))
        for name, digest, size in rows[:-1]:
            content = wheel.read(name)
            found = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
            assert (digest, int(size)) == (f"sha256={found}", len(content)), name
    assert [row[0] for row in rows] == names
    assert rows[-1] == [f"{about}/RECORD", "", ""]
    written = {f"stridor/{file.name}" for file in (ROOT / "python/stridor").glob("*") if file.is_file()}
    module = {name for name in names if name.endswith(".so")}
    assert len(module) == 1
    assert written | module == {name for name in names if name.startswith("stridor/")}
    assert {"stridor/py.typed", "stridor/_stridor.pyi"} <= written
    with zipfile.ZipFile(next(tmp_path.glob("*.whl"))) as wheel:
        program = wheel.getinfo(f"stridor-{backend.project()[0]}.data/scripts/stridor")
    assert program.external_attr >> 16 & 0o111


def test_what_it_needs_is_known_before_it_is_built(tmp_path):
    about = tmp_path / backend.prepare_metadata_for_build_wheel(tmp_path, {"built": "/nowhere"})
    (tmp_path / "wheel").mkdir()
    with zipfile.ZipFile(tmp_path / "wheel" / backend.build_wheel(tmp_path / "wheel", {"built": BUILT})) as wheel:
        for name in ("METADATA", "WHEEL", "entry_points.txt"):
            assert (about / name).read_bytes() == wheel.read(f"{about.name}/{name}")


def test_an_archive_of_the_sources_is_what_git_knows(tmp_path):
    if not (ROOT / ".git").exists():
        pytest.skip("not a git checkout")
    packed = tmp_path / backend.build_sdist(tmp_path)
    content = packed.read_bytes()
    backend.build_sdist(tmp_path)
    assert packed.read_bytes() == content
    stem = f"stridor-{backend.project()[0]}"
    with tarfile.open(packed) as archive:
        names = archive.getnames()
        assert {f"{stem}/PKG-INFO", f"{stem}/pyproject.toml", f"{stem}/CMakeLists.txt"} <= set(names)
        assert not [name for name in names if name.startswith(f"{stem}/build")]
        assert archive.getmember(f"{stem}/dev").mode & 0o111


def test_the_page_is_left_out_where_it_cannot_be_made(tmp_path, monkeypatch, capfd):
    monkeypatch.setattr(backend, "ROOT", tmp_path)
    (tmp_path / "explorer/node_modules").mkdir(parents=True)
    for name, text in (("node", "exit 0"), ("npm", "touch asked; exit 1")):
        (tmp_path / name).write_text(f"#!/bin/sh\n{text}\n")
        (tmp_path / name).chmod(0o755)
    monkeypatch.setenv("PATH", f"{tmp_path}:/usr/bin:/bin")
    assert not backend.has_page({"page": "off"}) and not (tmp_path / "explorer/asked").exists()
    assert not backend.has_page({}) and (tmp_path / "explorer/asked").exists()
    assert "the explorer has no page" in capfd.readouterr().err
    (tmp_path / "explorer/node_modules/.package-lock.json").write_text("{}")
    assert backend.has_page({})
    monkeypatch.setenv("PATH", "/nowhere")
    assert not backend.has_page({})


def test_a_folder_without_the_module_is_refused(tmp_path, capfd):
    (tmp_path / "cmake_install.cmake").write_text("# installs nothing\n")
    with pytest.raises(SystemExit, match="installs no Python package"):
        backend.build_wheel(tmp_path, {"built": str(tmp_path)})
    assert not list(tmp_path.glob("*.whl"))
