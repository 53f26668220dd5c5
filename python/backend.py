"""The build backend of `pip install .` (PEP 517 and 660): CMake builds the module and the programs, this makes a wheel.

It needs nothing but Python, CMake and a compiler. `stridor` has the page of its explorer where Node.js and npm are
found, which fetches what the page is bundled with; nothing else is fetched. `stridor-mpi` comes along where MPI is.
Config settings, as in `pip install --config-settings=build-folder=DIR .`:

build-folder
    Where CMake builds; `build-pip` of the checkout. It is kept, so that the next time takes seconds.
built
    A build folder that has the module already: it is taken from there, and nothing is built.
page
    `off`: the explorer has no page, and nothing is fetched.

STRIDOR_JOBS limits how many compilers run at a time.
"""

import base64
import csv
import gzip
import hashlib
import io
import os
import re
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
# the same bytes whenever it is built; the oldest time that a ZIP archive can say
FIRST_TIME = (1980, 1, 1, 0, 0, 0)
# lets xarray open stores of charts: open_dataset(..., engine="stridor")
ENTRY_POINTS = """\
[xarray.backends]
stridor = stridor.xarray_backend:StoreBackend
"""
METADATA = """\
Metadata-Version: 2.1
Name: stridor
Version: {version}
Summary: {summary}
License: MIT
Classifier: License :: OSI Approved :: MIT License
Classifier: Operating System :: POSIX :: Linux
Classifier: Topic :: Scientific/Engineering :: Physics
Classifier: Typing :: Typed
Requires-Python: >=3.9
Requires-Dist: numpy
Provides-Extra: all
Requires-Dist: matplotlib; extra == "all"
Requires-Dist: netCDF4; extra == "all"
Requires-Dist: pandas; extra == "all"
Requires-Dist: tqdm; extra == "all"
Requires-Dist: xarray; extra == "all"
Description-Content-Type: text/markdown

"""
WHEEL = "Wheel-Version: 1.0\nGenerator: stridor\nRoot-Is-Purelib: false\nTag: {tag}\n"


def project():
    """The version and the summary, which CMakeLists.txt alone knows."""
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    found = re.search(r'project\(stridor\s+VERSION (\S+)\s+DESCRIPTION "([^"]*)"', text)
    return found.group(1), found.group(2)


def metadata():
    version, summary = project()
    readme = (ROOT / "docs/guide/python.md").read_text(encoding="utf-8")
    return METADATA.format(version=version, summary=summary) + readme


def wheel_file():
    tag = f"{sys.version_info.major}{sys.version_info.minor}"
    platform = re.sub(r"[-.]", "_", sysconfig.get_platform())
    return WHEEL.format(tag=f"cp{tag}-cp{tag}-{platform}")


def wheel_name():
    tag = re.search("Tag: (.*)", wheel_file()).group(1)
    return f"stridor-{project()[0]}-{tag}.whl"


def about_name():
    return f"stridor-{project()[0]}.dist-info"


def run(*command):
    # pip hides what the system has installed, NumPy included, from the interpreters that a backend starts
    hidden = {"PYTHONPATH", "PYTHONNOUSERSITE"}
    environment = {name: value for name, value in os.environ.items() if name not in hidden}
    try:
        subprocess.run([str(word) for word in command], check=True, env=environment)
    except FileNotFoundError:
        sys.exit(f"{command[0]} is not found. Install it (Debian: cmake)?")
    except subprocess.CalledProcessError as error:
        sys.exit(f"{command[0]} failed with exit status {error.returncode}; what it says stands above.")


def has_page(settings):
    """Whether the explorer's page can be made: what bundles it is there, or can be fetched."""
    if settings.get("page") == "off" or not (shutil.which("node") and shutil.which("npm")):
        return False
    folder = ROOT / "explorer"
    if (folder / "node_modules" / ".package-lock.json").exists():
        return True
    fetch = ["npm", "ci", "--no-audit", "--no-fund", "--loglevel=error", "--fetch-retries=1"]
    if subprocess.run(fetch, cwd=folder, check=False).returncode == 0:
        return True
    print("npm cannot fetch what the explorer's page is bundled with: the explorer has no page.", file=sys.stderr)
    return False


def configure(folder, settings):
    """Lets CMake make the folder for this interpreter; one that was made for another is made anew."""
    options = [
        "-DCMAKE_BUILD_TYPE=Release",
        "-DSTRIDOR_TESTS=OFF",
        f"-DSTRIDOR_PAGE={'ON' if has_page(settings) else 'OFF'}",
        "-DSTRIDOR_PYTHON=ON",
        f"-DPython_EXECUTABLE={sys.executable}",
    ]
    cache = folder / "CMakeCache.txt"
    if cache.exists():
        if f"={sys.executable}\n" not in cache.read_text(encoding="utf-8"):
            options.append("--fresh")
    elif shutil.which("ninja"):
        options += ["-G", "Ninja"]
    run("cmake", "-S", ROOT, "-B", folder, *options)


def built(settings):
    """The build folder with the module in it."""
    settings = settings or {}
    if "built" in settings:
        return Path(settings["built"]).resolve()
    folder = Path(settings.get("build-folder", ROOT / "build-pip")).resolve()
    configure(folder, settings)
    jobs = os.environ.get("STRIDOR_JOBS") or str(os.cpu_count() or 2)
    run("cmake", "--build", folder, "--target", "stridor_wheel", "-j", jobs)
    return folder


def package_of(folder, scratch):
    """The package as CMake installs it: bytes by name."""
    run("cmake", "--install", folder, "--component", "python", "--prefix", scratch)
    found = list(Path(scratch).rglob("stridor/__init__.py"))
    if len(found) != 1:
        sys.exit(f"{folder} installs no Python package. Was it configured with -DSTRIDOR_PYTHON=ON?")
    package = found[0].parent
    if not (package / f"_stridor{sysconfig.get_config_var('EXT_SUFFIX')}").exists():
        sys.exit(f"The module in {folder} is not for {sys.executable}.")
    return {f"stridor/{file.relative_to(package)}": file.read_bytes() for file in package.rglob("*") if file.is_file()}


def programs_of(folder, scratch):
    """The programs that were built, for the folder of commands: bytes by name."""
    run("cmake", "--install", folder, "--component", "wheel", "--strip", "--prefix", scratch)
    scripts = f"stridor-{project()[0]}.data/scripts"
    return {f"{scripts}/{file.name}": file.read_bytes() for file in Path(scratch).glob("bin/*")}


def write_wheel(file, files):
    """A wheel of the files, with what pip wants to know about it."""
    about = about_name()
    files = dict(sorted(files.items()))
    files[f"{about}/METADATA"] = metadata().encode()
    files[f"{about}/WHEEL"] = wheel_file().encode()
    files[f"{about}/entry_points.txt"] = ENTRY_POINTS.encode()
    files[f"{about}/LICENSE"] = (ROOT / "LICENSE").read_bytes()
    record = io.StringIO()
    rows = csv.writer(record, lineterminator="\n")
    for name, content in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        rows.writerow([name, f"sha256={digest}", len(content)])
    rows.writerow([f"{about}/RECORD", "", ""])
    files[f"{about}/RECORD"] = record.getvalue().encode()
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            entry = zipfile.ZipInfo(name, FIRST_TIME)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = (0o100755 if name.endswith(".so") or ".data/scripts/" in name else 0o100644) << 16
            archive.writestr(entry, content)


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    """Lets pip look for what the package needs before anything is compiled."""
    about = Path(metadata_directory) / about_name()
    about.mkdir()
    (about / "METADATA").write_text(metadata(), encoding="utf-8")
    (about / "WHEEL").write_text(wheel_file(), encoding="utf-8")
    (about / "entry_points.txt").write_text(ENTRY_POINTS, encoding="utf-8")
    return about.name


prepare_metadata_for_build_editable = prepare_metadata_for_build_wheel


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    with tempfile.TemporaryDirectory() as scratch:
        folder = built(config_settings)
        files = {**package_of(folder, Path(scratch) / "package"), **programs_of(folder, Path(scratch) / "programs")}
    write_wheel(Path(wheel_directory) / wheel_name(), files)
    return wheel_name()


def build_editable(wheel_directory, config_settings=None, metadata_directory=None):
    """For `pip install -e .`: the package of the build folder, whose Python files are links into the checkout."""
    folder = built(config_settings) / "python"
    write_wheel(Path(wheel_directory) / wheel_name(), {"stridor.pth": f"{folder}\n".encode()})
    return wheel_name()


def build_sdist(sdist_directory, config_settings=None):
    """What git knows, as it stands in the checkout."""
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, check=False)
    if listed.returncode != 0:
        sys.exit("An archive of the sources needs a git checkout.")
    stem = f"stridor-{project()[0]}"
    names = sorted(os.fsdecode(name) for name in listed.stdout.split(b"\0") if name)
    contents = {name: (ROOT / name) for name in names if (ROOT / name).is_file()}
    packed = Path(sdist_directory) / f"{stem}.tar.gz"
    with packed.open("wb") as file, gzip.GzipFile("", "wb", fileobj=file, mtime=0) as stream:
        with tarfile.open(fileobj=stream, mode="w", format=tarfile.PAX_FORMAT) as archive:
            add(archive, f"{stem}/PKG-INFO", metadata().encode(), 0o644)
            for name, path in contents.items():
                add(archive, f"{stem}/{name}", path.read_bytes(), path.stat().st_mode & 0o755)
    return packed.name


def add(archive, name, content, mode):
    entry = tarfile.TarInfo(name)
    entry.size, entry.mode = len(content), mode
    archive.addfile(entry, io.BytesIO(content))
