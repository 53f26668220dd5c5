"""Draws what each figure of the ear follows, on real sounds: for each figure the clip in which it is smallest and the
one in which it is greatest.

    python3 bench/ear/show_figures.py CLIPS OUT [PROGRAM]

CLIPS has the eight clips of the documentation (chalk, door, tree, scrapes); other names are taken as they are. Writes
OUT/ear-tones.png and OUT/ear-onsets.png. The values come from `stridor classify --json`, of the loudest passage. Needs
NumPy, SciPy, soundfile and Matplotlib (Debian: python3-matplotlib).
"""

import glob
import json
import os
import subprocess
import sys

import matplotlib
import numpy as np
import soundfile
from scipy.signal import butter, medfilt, sosfilt, spectrogram

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

LONGEST = 3.0  # [s] of a passage
ZOOM = 0.7  # [s] that shows impulses
TONES = ["tone_presence", "tone_length", "tone_wander", "comb", "centre", "spread", "lone_fundamental"]
INK, MARK = "#1f4e79", "#c0392b"


def passage_of(program, path):
    """Samples and rate of the loudest passage of a clip, and its figures."""
    run = subprocess.run([program, "classify", "--json", path], capture_output=True, text=True, check=True)
    document = json.loads(run.stdout)
    passages = document["channels"][document["channel"] - 1]["verdict"]["passages"]
    loudest = max(passages, key=lambda passage: passage["energy"])
    samples, rate = soundfile.read(path, always_2d=True)
    first, last = (int(loudest[key] * rate) for key in ("from", "to"))
    return samples[first:last, document["channel"] - 1], rate, loudest["figures"]


def above(samples, rate, corner, order=4):
    return sosfilt(butter(order, min(corner, 0.25 * rate), "high", fs=rate, output="sos"), samples)


def levels(samples, rate, part):
    """Level [dB] over parts [s], and their times [s]."""
    length = max(1, round(part * rate))
    squares = (samples[:len(samples) // length * length].reshape(-1, length)**2).mean(axis=1)
    return 10 * np.log10(squares + 1e-6 * squares.max()), np.arange(len(squares)) * length / rate


def onsets_in(samples, rate):
    """Level above 1 kHz in parts of 2 ms, their times and the parts with onsets."""
    level, time = levels(above(samples, rate, 1000), rate, 0.002)
    power = 10**(level / 10)
    steps = np.zeros(len(level))
    for k in range(4, len(level) - 4):
        steps[k] = 10 * np.log10(power[k:k + 4].mean() / power[k - 4:k].mean())
    onsets = [k for k in range(4, len(level) - 4) if steps[k] >= 4.5 and steps[k] >= steps[k - 3:k + 4].max()]
    return level, time, onsets


def shown(level, time, onsets):
    """ZOOM seconds with most of the onsets that are heard."""
    if not onsets:
        return 0, ZOOM
    heard = time[[k for k in onsets if level[k] > level.max() - 25] or onsets]
    begin = heard[np.argmax([((heard >= first) & (heard < first + ZOOM)).sum() for first in heard])] - 0.02
    return begin, begin + ZOOM


def draw_spectrogram(axes, samples, rate):
    size = 2**round(np.log2(0.043 * rate))
    frequency, time, power = spectrogram(samples, rate, "hann", size, size // 2)
    decibels = 10 * np.log10(power / power.max() + 1e-9)
    axes.pcolormesh(time, frequency / 1000, decibels, vmin=-60, vmax=0, cmap="magma", shading="auto", rasterized=True)
    axes.set(ylim=(0, 8), ylabel="kHz")


def draw_spectrum(axes, samples, rate):
    size = 2**round(np.log2(0.043 * rate))
    frequency, _, power = spectrogram(samples, rate, "hann", size, size // 2)
    mean = power.mean(axis=1)
    axes.semilogx(frequency[1:], 10 * np.log10(mean[1:] / mean.max()), color=INK, linewidth=0.8)
    axes.set(xlim=(100, 16000), ylim=(-60, 3), ylabel="dB", xticks=[100, 1000, 10000],
             xticklabels=["100 Hz", "1 kHz", "10 kHz"])


def draw_wave(axes, samples, rate):
    heard = above(samples, rate, 1000)
    axes.plot(np.arange(len(heard)) / rate, heard / np.abs(heard).max(), color=INK, linewidth=0.4)
    axes.set(ylabel="above 1 kHz")


def draw_onsets(axes, samples, rate):
    level, time, onsets = onsets_in(samples, rate)
    axes.plot(time, level, color=INK, linewidth=0.7)
    axes.plot(time[onsets], level[onsets], "v", color=MARK, markersize=4)
    axes.set(xlim=shown(level, time, onsets), ylim=(level.max() - 40, level.max() + 3), ylabel="dB")


def draw_octaves(axes, samples, rate):
    for number, (low, high) in enumerate([(1000, 2000), (2000, 4000), (4000, 8000), (8000, 14000)]):
        if low >= 0.4 * rate:
            break
        band = sosfilt(butter(2, min(high, 0.47 * rate), "low", fs=rate, output="sos"), above(samples, rate, low, 2))
        level, time = levels(band, rate, 0.002)
        axes.plot(time, level - level.max() + 30 * number, color=INK, linewidth=0.6)
    axes.set(xlim=shown(*onsets_in(samples, rate)), ylim=(-35, 95), ylabel="octaves, dB")


def draw_beat(axes, samples, rate):
    level, time = levels(above(samples, rate, 1000), rate, 0.008)
    axes.plot(time, level, color=INK, linewidth=0.7)
    axes.plot(time, medfilt(level, 25), color=MARK, linewidth=1)
    axes.set(ylim=(level.max() - 40, level.max() + 3), ylabel="dB")


def draw_level(axes, samples, rate):
    level, time = levels(above(samples, rate, 100, 2), rate, 0.05)
    axes.step(time, level, color=INK, linewidth=0.9, where="post")
    axes.axhline(level.max() - 20, color=MARK, linewidth=0.8)
    axes.set(ylim=(level.max() - 45, level.max() + 3), ylabel="dB")


DRAWN = {
    "tone_presence": draw_spectrogram, "tone_length": draw_spectrogram, "tone_wander": draw_spectrogram,
    "comb": draw_spectrum, "centre": draw_spectrum, "spread": draw_spectrum, "lone_fundamental": draw_spectrum,
    "lone_impulses": draw_wave,
    "onset_rate": draw_onsets, "train": draw_onsets, "jerks": draw_onsets, "joint_jerks": draw_octaves,
    "beat": draw_beat, "lone_rhythm": draw_onsets, "level_spread": draw_level, "sounding": draw_level,
}


def draw(passages, names, path):
    figure, axes = plt.subplots(len(names), 2, figsize=(10, 1.75 * len(names)), layout="constrained")
    for row, name in zip(axes, names):
        order = sorted(passages, key=lambda clip: passages[clip][2][name])
        for panel, clip in zip(row, (order[0], order[-1])):
            samples, rate, figures = passages[clip]
            DRAWN[name](panel, samples[:int(LONGEST * rate)], rate)
            panel.set_title(f"{name} {figures[name]:.2f}: {clip}", fontsize=9, loc="left")
            panel.tick_params(labelsize=7)
            panel.yaxis.label.set_size(8)
    figure.savefig(path, dpi=80)
    plt.close(figure)


def main():
    clips, out = sys.argv[1:3]
    program = sys.argv[3] if len(sys.argv) > 3 else "build/stridor"
    passages = {os.path.splitext(os.path.basename(path))[0].replace("_", " "): passage_of(program, path)
                for path in sorted(glob.glob(os.path.join(clips, "*.ogg")))}
    names = list(next(iter(passages.values()))[2])
    draw(passages, [name for name in names if name in TONES], os.path.join(out, "ear-tones.png"))
    draw(passages, [name for name in names if name not in TONES], os.path.join(out, "ear-onsets.png"))


if __name__ == "__main__":
    main()
