"""Asks whether a pause, a cut or a gain changes what `stridor classify` hears.

    python3 invariance.py FOLDER=TABLE.csv ... [--program build/stridor] [--only WORDS]

Each clip is changed in each of the ways below, and heard. Printed is a table: for each way the number of clips that
get another category than the clip as it is, of those of sure label the number that is right, and the same of noises and
of creaks alone. A pause is digital silence, or room noise 45 dB below the clip. Every clip has a seed of its own: the
table is always the same. Of a clip of several channels the louder one is taken, in the last row their mean.

Needs NumPy and soundfile.
"""

import argparse
import csv
import os
import subprocess
import tempfile

import numpy as np
import soundfile

LONGEST = 12.0  # s
ROOM = -45.0  # dB of the room's noise below the clip
BELOW = 10.0 ** (ROOM / 20.0)


def room(samples, rate, seconds, random):
    """Noise that falls by 6 dB an octave above 100 Hz, so far below the clip."""
    count = int(seconds * rate)
    spectrum = np.fft.rfft(random.normal(size=count))
    spectrum /= 1.0 + np.fft.rfftfreq(count, 1.0 / rate) / 100.0
    noise = np.fft.irfft(spectrum, count)
    return noise / noise.std() * samples.std() * BELOW


def silence(rate, seconds):
    return np.zeros(int(seconds * rate))


def later(samples, rate):
    """The clip begun 0.2 s later, if at least half of it stays."""
    first = int(0.2 * rate)
    return samples[first:] if len(samples) > 2 * first else samples


def stereo(samples, level):
    """The clip on the left, and on the right the same so many dB softer."""
    return np.column_stack([samples, samples * 10.0 ** (-level / 20.0)])


# of the louder channel x, and the mean of all channels, the mix
KINDS = {
    "unchanged": lambda x, mix, rate, random: x,
    "silence of 0.7 s in front": lambda x, mix, rate, random: np.concatenate([silence(rate, 0.7), x]),
    "silence of 5 s in front": lambda x, mix, rate, random: np.concatenate([silence(rate, 5.0), x]),
    "room noise of 0.7 s in front": lambda x, mix, rate, random: np.concatenate([room(x, rate, 0.7, random), x]),
    "room noise of 5 s in front": lambda x, mix, rate, random: np.concatenate([room(x, rate, 5.0, random), x]),
    "room noise of 2 s behind": lambda x, mix, rate, random: np.concatenate([x, room(x, rate, 2.0, random)]),
    "twice in a row": lambda x, mix, rate, random: np.concatenate([x, x]),
    "twice, room noise of 1 s between": lambda x, mix, rate, random: np.concatenate([x, room(x, rate, 1.0, random), x]),
    "begun 0.2 s later": lambda x, mix, rate, random: later(x, rate),
    "20 dB softer": lambda x, mix, rate, random: 0.1 * x,
    "stereo, both alike": lambda x, mix, rate, random: stereo(x, 0.0),
    "stereo, the right 1.4 dB softer": lambda x, mix, rate, random: stereo(x, 1.4),
    "stereo, the right 3 dB softer": lambda x, mix, rate, random: stereo(x, 3.0),
    "stereo, the right silent": lambda x, mix, rate, random: stereo(x, np.inf),
    "the mix of its channels": lambda x, mix, rate, random: mix,
}


def read_table(folder, table):
    with open(table, newline="") as text:
        rows = list(csv.DictReader(text))
    for row in rows:
        whole = os.path.join(folder, row["file"])
        row["path"] = whole if os.path.exists(whole) else os.path.join(folder, os.path.basename(row["file"]))
    return rows


def read_clip(path):
    """The louder channel of a clip, the mean of its channels, and the rate [Hz]. The louder one has a peak of 0.5."""
    samples, rate = soundfile.read(path, always_2d=True)
    samples = samples[: int(LONGEST * rate)]
    louder = samples[:, np.argmax((samples**2).sum(axis=0))]
    scale = 0.5 / max(np.abs(louder).max(), 1e-9)
    return scale * louder, scale * samples.mean(axis=1), rate


def heard(program, folder):
    """Category of each file in a folder, by its name without an ending. A file that cannot be heard has none."""
    table = os.path.join(folder, "rows.csv")
    subprocess.run([program, "classify", folder, "--csv", table], capture_output=True)
    with open(table, newline="") as text:
        text.readline()  # facts of the table
        return {os.path.splitext(os.path.basename(row["file"]))[0]: row["category"] for row in csv.DictReader(text)}


def categories(program, rows, change, kind):
    with tempfile.TemporaryDirectory() as folder:
        for place, row in enumerate(rows):
            louder, mix, rate = read_clip(row["path"])
            changed = change(louder, mix, rate, np.random.default_rng([place, kind]))
            soundfile.write(os.path.join(folder, f"{place}.wav"), changed, rate, subtype="FLOAT")
        found = heard(program, folder)
    return [found.get(str(place), "") for place in range(len(rows))]


def line(rows, found, usual):
    def right(wanted):
        chosen = [(row, word) for row, word in zip(rows, found) if row["confidence"] == "high" and wanted(row)]
        return f"{sum(word in row['expected'].split('|') for row, word in chosen)} of {len(chosen)}"

    def noise(row):
        return "none" not in row["expected"].split("|")

    def creak(row):
        return noise(row) and "creak" in row["expected"].split("|")

    other = sum(one != two for one, two in zip(found, usual))
    return f"{other} of {len(rows)} | {right(lambda row: True)} | {right(noise)} | {right(creak)}"


def main():
    parser = argparse.ArgumentParser(description="Asks whether pauses, cuts and gains change what is heard.")
    parser.add_argument("clips", nargs="+", metavar="FOLDER=TABLE.csv")
    parser.add_argument("--program", default="build/stridor")
    parser.add_argument("--only", metavar="WORDS", default="", help="ways whose name has these words, such as stereo")
    options = parser.parse_args()
    rows = [row for pair in options.clips for row in read_table(*pair.split("=", 1))]
    print("| | another category | sure clips right | noises | creaks |\n| --- | --- | --- | --- | --- |")
    usual = None
    for kind, (name, change) in enumerate(KINDS.items()):
        if usual and options.only not in name:
            continue
        found = categories(options.program, rows, change, kind)
        usual = usual or found
        print(f"| {name} | {line(rows, found, usual)} |", flush=True)


if __name__ == "__main__":
    main()
