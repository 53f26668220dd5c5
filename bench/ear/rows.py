"""Asks whether `stridor classify` hears even rows as creaks, at any pace and whatever rings.

    python3 rows.py [--program build/stridor]

198 rows of three seconds: a body of one or two tones is struck 6 to 80 times a second, at one pace or at one that
wavers by 10 %, rings off in 4 to 20 ms, and lies 30 dB above white noise. A rig that goes at one speed sounds so.
Printed is a table, a line for each body: C creak, L squeal, K squeak, . none, u undecided. Below it stand rows of dry
clicks, and rain and steps, which are none: sounds of `synthesise.py --dry`, of other seeds. All is always the same.

Needs NumPy, SciPy and soundfile.
"""

import argparse
import itertools
import json
import os
import subprocess
import tempfile

import numpy as np
import soundfile

import synthesise

RATE = 48000  # Hz
DURATION = 3.0  # s
PACES = [6, 8, 12, 16, 20, 25, 30, 40, 50, 60, 80]  # Hz
BODIES = [(2100.0, 3400.0), (700.0,), (2100.0,)]  # Hz, a second tone at 0.7 of the first
DECAYS = [0.004, 0.008, 0.02]  # s
WAVERS = [0.0, 0.1]  # of the pace, 0.7 times a second
LETTERS = {"creak": "C", "squeal": "L", "squeak": "K", "none": ".", "undecided": "u"}


def struck(tones, decay, pace, waver):
    times = np.arange(int(0.1 * RATE)) / RATE
    ring = np.exp(-times / decay) * sum(w * np.sin(2.0 * np.pi * f * times) for w, f in zip((1.0, 0.7), tones))
    samples = np.zeros(int(DURATION * RATE) + len(ring))
    instant = 0.05
    while instant < DURATION - 0.1:
        first = int(instant * RATE)
        samples[first:first + len(ring)] += ring
        instant += 1.0 / (pace * (1.0 + waver * np.sin(2.0 * np.pi * 0.7 * instant)))
    samples = samples[:int(DURATION * RATE)]
    samples += 10.0 ** (-30.0 / 20.0) * samples.std() * np.random.default_rng(4).normal(size=len(samples))
    return 0.5 * samples / np.abs(samples).max()


def letter_of(program, path):
    run = subprocess.run([program, "classify", "--json", path], capture_output=True, text=True, check=True)
    document = json.loads(run.stdout)
    return LETTERS[document["channels"][document["channel"] - 1]["verdict"]["category"]]


def tell_dry(program, path):
    """Dry rows and what looks like them, of seeds from a million on: nothing is learnt from these."""
    for _, source, share in synthesise.DRY:
        heard = ""
        for seed in range(1_000_000, 1_000_000 + int(600 * share)):
            sound, rate, name = synthesise.synthesise_dry(seed, source)
            soundfile.write(path, np.clip(sound / max(1, np.abs(sound).max()), -1, 1), rate)
            heard += letter_of(program, path)
        print(f"{name}: {heard.count('C')} of {len(heard)} are creaks, {heard.count('.')} none")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default="build/stridor")
    program = parser.parse_args().program
    print(f"| tones [Hz] | decay [ms] | waver | {PACES[0]} to {PACES[-1]} Hz | creaks |")
    print("| --- | --- | --- | --- | --- |")
    heard = ""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "row.wav")
        for tones, decay, waver in itertools.product(BODIES, DECAYS, WAVERS):
            line = ""
            for pace in PACES:
                soundfile.write(path, struck(tones, decay, pace, waver), RATE)
                line += letter_of(program, path)
            words = " and ".join(f"{tone:.0f}" for tone in tones)
            print(f"| {words} | {1000.0 * decay:.0f} | {100.0 * waver:.0f} % | `{line}` | {line.count('C')} |")
            heard += line
        print(f"\n{heard.count('C')} of {len(heard)} are creaks")
        tell_dry(program, path)


if __name__ == "__main__":
    main()
