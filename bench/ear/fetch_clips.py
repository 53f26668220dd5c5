"""Fetches the clips that the ear of `stridor classify` is fitted to and checked with.

    python3 fetch_clips.py FOLDER

The clips are sounds out of Debian packages. They are not copied into the project: debian_clips.csv says where each one
lies, and this program gets it from there. It writes FOLDER/develop, FOLDER/unseen and FOLDER/other, each with the clips
of that set and a table of them, develop.csv, unseen.csv and other.csv. It downloads one package at a time and deletes
it after use. A clip that is there already is kept, so that a broken run may be started again. At the end it says which
clips it could not get; then it returns 1.

A clip is the first 12 seconds of its sound. A short WAV, Ogg Vorbis, FLAC or MP3 file stays as it is. Anything else
becomes a 16-bit WAV file. Two clips are speech, which espeak-ng speaks here.

Needs Debian 12 (apt-get, dpkg-deb), espeak-ng, NumPy and soundfile (python3-soundfile). Run `apt-get update` first.
"""

import argparse
import csv
import hashlib
import io
import os
import shutil
import struct
import subprocess
import sys
import tarfile
import tempfile
import zipfile
import zlib

import numpy as np
import soundfile

LONGEST = 12.0  # [s] what is cut off later is not heard
LOUDEST = 0.999  # [1] a converted sound beyond this is scaled down to it, for 16 bits end there
KEPT = {"WAV", "WAVEX", "OGG", "FLAC", "MP3"}  # formats of files that may stay as they are
HALVES = ["develop", "unseen", "other"]
ARCHIVE = "(archive) "  # stands before a path inside an archive of the package
SPEECH = "(speech) "  # stands before a voice and its speed, in words a minute, in place of a path
SENTENCE = "The old wooden door in the hall has been painted, and the train leaves at seven in the morning."


def place_of(row):
    """Binary package of a clip, and its path in there. The package is named before a colon where it is not the source
    package."""
    package, colon, path = row["path"].partition(": ")
    return (package, path) if colon else (row["repository"], row["path"])


def download(package, version, folder):
    """Path of the Debian package, or None if that version is not to be had."""
    command = ["apt-get", "download", f"{package}={version}"]
    run = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    found = [name for name in os.listdir(folder) if name.endswith(".deb")]
    if run.returncode == 0 and found:
        return os.path.join(folder, found[0])
    reason = [line for line in run.stderr.splitlines() if line.startswith("E:")]
    print(f"{package} {version} cannot be downloaded ({' '.join(reason)}). Is `apt-get update` due?", flush=True)
    return None


def zip_member(archive, name):
    """A file of a zip or pk3 archive."""
    return zipfile.ZipFile(archive).read(name)


def wad_member(archive, name):
    """A lump of a Doom archive. A directory of offsets, sizes and names of 8 letters stands at its end."""
    content = archive.read()
    count, directory = struct.unpack("<ii", content[4:12])
    for index in range(count):
        first, size, lump = struct.unpack_from("<ii8s", content, directory + 16 * index)
        if lump.rstrip(b"\0").decode("latin1") == os.path.splitext(name)[0]:
            return content[first:first + size]
    raise KeyError(name)


def cat_member(archive, name):
    """A sound of an OpenTTD set. Offsets and sizes open the file; a sound follows its own name. The number before the
    name counts the sounds."""
    content = archive.read()
    first, size = struct.unpack_from("<II", content, 8 * int(name.split("_")[0]))
    first &= 0x7FFFFFFF
    first += 1 + content[first]
    return content[first:first + size]


def group_member(archive, name):
    """A file of an OpenClonk group, which may lie in groups inside the group."""
    content = archive.read()
    for part in name.split("/"):
        content = group_entry(content, part)
    return content


def group_entry(content, name):
    """An entry of an OpenClonk group: a scrambled header of 204 bytes, entries of 316 bytes, then the files."""
    if content[:2] in (b"\x1e\x8c", b"\x1f\x8b"):
        # gzip with its own first two bytes
        content = zlib.decompressobj(31).decompress(b"\x1f\x8b" + content[2:])
    header = bytearray(content[:204])
    for index in range(0, 202, 3):
        header[index], header[index + 2] = header[index + 2], header[index]
    header = bytes(value ^ 237 for value in header)
    if not header.startswith(b"RedWolf De"):
        raise ValueError("not a group")
    count = struct.unpack_from("<i", header, 36)[0]
    for index in range(count):
        entry = content[204 + 316 * index:204 + 316 * (index + 1)]
        if entry[:260].split(b"\0")[0].decode("latin1") == name:
            size, _, first = struct.unpack_from("<3i", entry, 268)
            first += 204 + 316 * count
            return content[first:first + size]
    raise KeyError(name)


READERS = {".pk3": zip_member, ".zip": zip_member, ".wad": wad_member, ".cat": cat_member, ".ocg": group_member}


def members(deb, paths, folder):
    """Yields path and bytes of each of `paths` that the package holds. The package is read as a stream: only archives
    are written to `folder`, one at a time."""
    inside = {}
    for path in paths:
        if path.startswith(ARCHIVE):
            inside.setdefault(path.removeprefix(ARCHIVE).split("/")[0], []).append(path)
    with subprocess.Popen(["dpkg-deb", "--fsys-tarfile", deb], stdout=subprocess.PIPE) as unpacked:
        with tarfile.open(fileobj=unpacked.stdout, mode="r|") as package:
            for member in package:
                path = member.name.removeprefix("./")
                archive = os.path.basename(path)
                if not member.isfile():
                    continue
                if path in paths:
                    yield path, package.extractfile(member).read()
                elif archive in inside:
                    reader = READERS[os.path.splitext(archive)[1].lower()]
                    with tempfile.TemporaryFile(dir=folder) as copy:
                        shutil.copyfileobj(package.extractfile(member), copy)
                        for path in inside[archive]:
                            copy.seek(0)
                            yield path, reader(copy, path.split("/", 1)[1])


def speech(paths, folder):
    """Yields path and bytes of the sentence in each voice, if espeak-ng is there."""
    spoken = os.path.join(folder, "speech.wav")
    for path in paths:
        voice, pace = path.removeprefix(SPEECH).split()
        if shutil.which("espeak-ng") is None:
            print("espeak-ng is not installed (it speaks two clips). Install it?", flush=True)
            return
        subprocess.run(["espeak-ng", "-v", voice, "-s", pace, "-w", spoken, SENTENCE], check=True)
        with open(spoken, "rb") as opened:
            yield path, opened.read()


def doom_sound(content):
    """Samples [1] and rate [Hz] of a Doom sound: rate and count, then bytes with 16 of padding at both ends."""
    _, rate, count = struct.unpack_from("<HHI", content)
    samples = np.frombuffer(content[24:8 + count - 16], np.uint8).astype(float)
    return (samples - 128) / 128, rate


def clip_of(content, path):
    """Bytes of the clip made of the bytes of a sound."""
    if path.endswith(".dmx"):
        samples, rate = doom_sound(content)
        samples = samples[:int(LONGEST * rate)]
    else:
        with soundfile.SoundFile(io.BytesIO(content)) as sound:
            rate = sound.samplerate
            short = sound.frames <= LONGEST * rate
            if short and sound.format in KEPT and (sound.format != "OGG" or sound.subtype == "VORBIS"):
                return content
            samples = sound.read(int(LONGEST * rate), always_2d=True)
        peak = np.abs(samples).max()
        if peak > LOUDEST:
            samples = samples / peak * LOUDEST
    clip = io.BytesIO()
    soundfile.write(clip, samples, rate, subtype="PCM_16", format="WAV")
    return clip.getvalue()


def write(path, content):
    """Writes a file as a whole or not at all."""
    with open(path + ".part", "wb") as written:
        written.write(content)
    os.replace(path + ".part", path)


def fetch(package, version, rows, folder):
    """Writes the clips of one package."""
    with tempfile.TemporaryDirectory(dir=folder) as scratch:
        wanted = {place_of(row)[1]: row for row in rows}
        if all(path.startswith(SPEECH) for path in wanted):
            found = speech(wanted, scratch)
        else:
            deb = download(package, version, scratch)
            found = members(deb, wanted, scratch) if deb else []
        for path, content in found:
            row = wanted[path]
            if hashlib.sha256(content).hexdigest() != row["sha256"]:
                print(f"{package}: {path} is another file than it was (its SHA-256 differs)", flush=True)
                continue
            write(os.path.join(folder, row["file"]), clip_of(content, path))


def write_tables(folder, rows):
    """Writes a table of the clips that are there, for each set. `half` is left out, for it names the table."""
    for half in HALVES:
        text = io.StringIO()
        columns = [name for name in rows[0] if name != "half"]
        table = csv.DictWriter(text, columns, extrasaction="ignore", lineterminator="\n")
        table.writeheader()
        there = [row for row in rows if os.path.exists(os.path.join(folder, row["file"]))]
        table.writerows(row for row in there if row["half"] == half)
        write(os.path.join(folder, half, f"{half}.csv"), text.getvalue().encode())


def main():
    parser = argparse.ArgumentParser(description="Fetches the clips of debian_clips.csv.")
    parser.add_argument("folder", metavar="FOLDER")
    options = parser.parse_args()
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "debian_clips.csv"), newline="") as table:
        rows = list(csv.DictReader(table))
    folder = os.path.abspath(options.folder)
    for half in HALVES:
        os.makedirs(os.path.join(folder, half), exist_ok=True)

    def missing():
        return [row for row in rows if not os.path.exists(os.path.join(folder, row["file"]))]

    packages = {}
    for row in missing():
        packages.setdefault((place_of(row)[0], row["package_version"]), []).append(row)
    for (package, version), wanted in packages.items():
        print(f"{package} {version}: {len(wanted)} clips", flush=True)
        fetch(package, version, wanted, folder)
    write_tables(folder, rows)
    lost = missing()
    print(f"{len(rows) - len(lost)} of {len(rows)} clips are there.")
    for row in lost:
        print(f"not there: {row['file']} ({row['path']})")
    return 1 if lost else 0


if __name__ == "__main__":
    sys.exit(main())
