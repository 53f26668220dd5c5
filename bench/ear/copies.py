"""Finds clips that are the same sound: of the same bytes, or near copies by their spectrograms.

    python3 copies.py FOLDER=TABLE.csv OTHER_FOLDER=OTHER_TABLE.csv

prints the pairs of a clip of the first table and one of the second, and returns 1 if there are any. train.py refuses to
learn from a clip that stands in a table it is told to keep aside.

A sketch of a clip is its level in third octaves from 200 Hz to 6.3 kHz every 50 ms, as far as the rate holds them, in
dB, at most 50 below the greatest. Two clips are near copies if the sketches correlate by more than 0.97 where the one
is laid over the other for 0.5 s or more, wherever that is: codecs, gains, cuts and other rates leave such copies.
Shorter clips are compared by their bytes alone, for a few frames are alike by chance. Needs NumPy and soundfile.
"""

import csv
import hashlib
import os
import sys

import numpy as np
import soundfile

LONGEST = 12.0  # s
FRAME = 0.05  # s
BANDS = 200.0 * 2.0 ** (np.arange(16) / 3.0)  # Hz, centres
DEPTH = 50.0  # dB
ALIKE = 0.97
LEAST_FRAMES = 10
WORTH_A_LOOK = 0.8  # correlation of the mean spectra below which no frames are compared


def sketch(path):
    """Levels in dB, shape [frame][band], without what the rate does not hold."""
    samples, rate = soundfile.read(path, always_2d=True)
    samples = samples[: int(LONGEST * rate)].mean(axis=1)
    size = int(FRAME * rate)
    if len(samples) < size:
        samples = np.pad(samples, (0, size - len(samples)))
    frames = samples[: len(samples) // size * size].reshape(-1, size) * np.hanning(size)
    power = np.abs(np.fft.rfft(frames, axis=1)) ** 2
    frequency = np.fft.rfftfreq(size, 1.0 / rate)
    held = [band for band in BANDS if band * 2.0 ** (1.0 / 6.0) < 0.45 * rate]
    columns = [power[:, (frequency >= band / 2.0 ** (1.0 / 6.0)) & (frequency < band * 2.0 ** (1.0 / 6.0))].sum(axis=1)
               for band in held]
    levels = 10.0 * np.log10(np.array(columns).T + 1e-20)
    return np.maximum(levels, levels.max() - DEPTH)


def correlation(one, two):
    one, two = one - one.mean(), two - two.mean()
    norm = np.sqrt((one**2).sum() * (two**2).sum())
    return (one * two).sum() / norm if norm > 0.0 else 0.0


def are_alike(one, two):
    if min(len(one), len(two)) < LEAST_FRAMES:
        return False
    bands = min(one.shape[1], two.shape[1])
    one, two = one[:, :bands], two[:, :bands]
    if correlation(one.mean(axis=0), two.mean(axis=0)) < WORTH_A_LOOK:
        return False
    for lag in range(LEAST_FRAMES - len(two), len(one) - LEAST_FRAMES + 1):
        first, second = one[max(0, lag):], two[max(0, -lag):]
        count = min(len(first), len(second))
        if correlation(first[:count], second[:count]) > ALIKE:
            return True
    return False


def clips_of(folder, table):
    """Path, hash of the bytes, and sketch of each clip of a table."""
    found = []
    with open(table, newline="") as text:
        for row in csv.DictReader(text):
            whole = os.path.join(folder, row["file"])
            path = whole if os.path.exists(whole) else os.path.join(folder, os.path.basename(row["file"]))
            with open(path, "rb") as clip:
                found.append((path, hashlib.sha256(clip.read()).hexdigest(), sketch(path)))
    return found


def copies(ones, others):
    """Pairs of paths, and how they are alike."""
    for path, digest, one in ones:
        for other_path, other_digest, other in others:
            if digest == other_digest:
                yield path, other_path, "same bytes"
            elif are_alike(one, other):
                yield path, other_path, "near copy"


def main():
    ones, others = (clips_of(*pair.split("=", 1)) for pair in sys.argv[1:3])
    found = list(copies(ones, others))
    for path, other, how in found:
        print(f"{path} = {other} ({how})")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
