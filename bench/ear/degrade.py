"""Copies clips as recorders and rooms would leave them, for train.py to ask how much the ear loses.

    python3 degrade.py OUT FOLDER=TABLE.csv ...

Writes OUT/KIND/*.wav with table.csv (the clip's own row) for each KIND below. Every clip has a seed of its own, so the
copies are always the same. Needs NumPy, SciPy and soundfile; lame and oggenc (Debian: lame, vorbis-tools).
"""

import csv
import os
import subprocess
import sys
import tempfile
from concurrent.futures import ProcessPoolExecutor
from math import gcd

import numpy as np
import soundfile
from scipy.signal import fftconvolve, resample_poly

LONGEST = 12.0  # s


def at_rate(samples, rate, new_rate):
    if new_rate >= rate:
        return samples, rate
    common = gcd(new_rate, rate)
    return resample_poly(samples, new_rate // common, rate // common), new_rate


def in_room(samples, rate, seconds, random):
    """A diffuse tail that falls by 60 dB in `seconds`, as strong as the direct sound."""
    time = np.arange(int(seconds * rate)) / rate
    tail = random.normal(size=len(time)) * np.exp(-6.91 * time / seconds)
    tail /= np.sqrt((tail**2).sum())
    tail[0] += 1.0
    return fftconvolve(samples, tail)[: len(samples) + len(tail) // 2], rate


def with_room_noise(samples, rate, decibels, random):
    """Noise that falls by 6 dB an octave above 100 Hz, as rooms and recorders have it, so far below the clip."""
    spectrum = np.fft.rfft(random.normal(size=len(samples)))
    spectrum /= 1.0 + np.fft.rfftfreq(len(samples), 1.0 / rate) / 100.0
    noise = np.fft.irfft(spectrum, len(samples))
    return samples + noise / noise.std() * samples.std() * 10.0 ** (-decibels / 20.0), rate


def coded(samples, rate, write, read):
    with tempfile.TemporaryDirectory() as folder:
        before, packed, after = (os.path.join(folder, name) for name in ("a.wav", "b", "c.wav"))
        soundfile.write(before, samples, rate, subtype="PCM_16")
        subprocess.run([*write, before, packed], check=True, capture_output=True)
        subprocess.run([*read, packed, after], check=True, capture_output=True)
        return soundfile.read(after)


def by_mp3(samples, rate):
    return coded(samples, rate, ["lame", "--quiet", "-b", "64"], ["lame", "--quiet", "--decode"])


def by_ogg(samples, rate):
    with tempfile.TemporaryDirectory() as folder:
        before, packed = os.path.join(folder, "a.wav"), os.path.join(folder, "b.ogg")
        soundfile.write(before, samples, rate, subtype="PCM_16")
        run = ["oggenc", "-Q", "-b", "64", before, "-o", packed]
        if subprocess.run(run, capture_output=True).returncode:  # there is no such rate for so few samples a second
            return samples, rate
        return soundfile.read(packed)


KINDS = {
    "unchanged": lambda x, rate, random: (x, rate),
    "mp3_64": lambda x, rate, random: by_mp3(x, rate),
    "ogg_64": lambda x, rate, random: by_ogg(x, rate),
    "rate_16_kHz": lambda x, rate, random: at_rate(x, rate, 16000),
    "rate_8_kHz": lambda x, rate, random: at_rate(x, rate, 8000),
    "room_0.3_s": lambda x, rate, random: in_room(x, rate, 0.3, random),
    "room_0.8_s": lambda x, rate, random: in_room(x, rate, 0.8, random),
    "room_1.5_s": lambda x, rate, random: in_room(x, rate, 1.5, random),
    "noise_20_dB": lambda x, rate, random: with_room_noise(x, rate, 20.0, random),
    "noise_10_dB": lambda x, rate, random: with_room_noise(x, rate, 10.0, random),
}


def degrade(job):
    place, path, out = job
    samples, rate = soundfile.read(path, always_2d=True, frames=-1)
    samples = samples[: int(LONGEST * rate)]
    samples = samples[:, np.argmax((samples**2).sum(axis=0))]
    samples = 0.5 * samples / max(np.abs(samples).max(), 1e-9)
    name = f"{place}.wav"
    for number, (kind, change) in enumerate(KINDS.items()):
        changed, new_rate = change(samples, rate, np.random.default_rng([place, number]))
        changed = 0.5 * changed / max(np.abs(changed).max(), 1e-9)
        soundfile.write(os.path.join(out, kind, name), changed, new_rate, subtype="PCM_16")
    return name


def main():
    out, pairs = sys.argv[1], [pair.split("=", 1) for pair in sys.argv[2:]]
    rows, jobs = [], []
    for folder, table in pairs:
        with open(table, newline="") as text:
            for row in csv.DictReader(text):
                whole = os.path.join(folder, row["file"])
                path = whole if os.path.exists(whole) else os.path.join(folder, os.path.basename(row["file"]))
                jobs.append((len(jobs), path, out))
                rows.append(row)
    for kind in KINDS:
        os.makedirs(os.path.join(out, kind), exist_ok=True)
    with ProcessPoolExecutor() as pool:
        names = list(pool.map(degrade, jobs))
    for kind in KINDS:
        with open(os.path.join(out, kind, "table.csv"), "w", newline="") as text:
            writer = csv.writer(text)
            columns = ["repository", "label", "expected", "confidence", "sha256"]
            writer.writerow(["file", *columns])
            for name, row in zip(names, rows):
                writer.writerow([name, *(row.get(key, "") for key in columns)])


if __name__ == "__main__":
    main()
