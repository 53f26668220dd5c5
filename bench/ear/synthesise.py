"""Makes sounds of known category, for the ear of `stridor classify` to be fitted to.

    python3 synthesise.py COUNT FOLDER [--dry]

Writes 4 COUNT sounds as 16-bit WAV files, CATEGORY_SEED.wav, and table.csv with the columns that train.py reads. The
categories take turns: none, squeal, squeak, creak. With --dry come, to 150 of each, 40 rows of dry clicks (creaks), and
what looks like them and is none: rain (15) and steps (7); the ear is not fitted to these. Each sound is drawn from its
own seed, so that the same COUNT gives the same files. The sounds are caricatures: each keeps what tells its category,
and lets all the rest vary widely.

Two choices run through the file. What is a ratio to the ear (frequencies, times) is drawn evenly in its logarithm.
Levels are drawn in decibels. A change in the order of the draws changes every sound.

Needs NumPy, SciPy and soundfile (Debian: python3-scipy, python3-soundfile).
"""

import argparse
import csv
import os
from concurrent.futures import ProcessPoolExecutor

import numpy as np
import soundfile
from scipy.signal import butter, fftconvolve, lfilter, sosfilt

CATEGORIES = ["none", "squeal", "squeak", "creak"]
RATES, RATE_SHARES = [16000, 22050, 44100, 48000], [0.1, 0.2, 0.5, 0.2]  # [Hz], [1]
SHORTEST, LONGEST = 0.35, 4.0  # [s] of a sound
SHORTEST_FRICTION = 0.5  # [s] of a squeal, a squeak or a creak
HIGHEST = 0.45  # [1] highest partial, as a share of the sampling rate
SILENCE = 1e-12  # added to a divisor that may be zero
FORMANTS = np.array([  # [Hz] the lowest three of seven vowels
    [730, 1090, 2440], [270, 2290, 3010], [300, 870, 2240], [530, 1840, 2480], [570, 840, 2410], [440, 1020, 2240],
    [660, 1720, 2410],
])

# In all functions `draw` is the source of random numbers, `rate` the sampling rate [Hz], `count` the number of samples.


def evenly_in_logarithm(draw, low, high):
    """A frequency or a time between two bounds: each octave is equally likely, as the ear counts."""
    return np.exp(draw.uniform(np.log(low), np.log(high)))


def gain(level):
    """Factor [1] of a level [dB]."""
    return 10 ** (level / 20)


def stretched(values, count):
    """A slow course through `values`, for what changes much slower than the samples do."""
    return np.interp(np.arange(count), np.linspace(0, count, len(values)), values)


def modes(draw, rate, number=None, frequencies=(150, 6000), decays=(0.003, 0.05)):
    """Impulse response of a panel of wood, sheet or plastic: a few decaying modes, since every knock is heard through
    a body. `frequencies` [Hz], `decays` [s] to 1/e."""
    number = number or draw.integers(4, 14)
    time = np.arange(int(0.35 * rate)) / rate
    response = np.zeros_like(time)
    for _ in range(number):
        frequency = evenly_in_logarithm(draw, frequencies[0], min(frequencies[1], HIGHEST * rate))
        # high modes die sooner
        decay = evenly_in_logarithm(draw, *decays) * min(1, (800 / frequency) ** 0.3)
        response += draw.normal() * np.exp(-time / decay) * np.sin(2 * np.pi * frequency * time)
    return response / np.sqrt((response**2).sum())


def room(draw, rate):
    """Impulse response of a room: the direct sound and a dull decaying noise, since reverberation blurs impulses."""
    reverberation = evenly_in_logarithm(draw, 0.15, 1.5)  # [s] to -60 dB
    time = np.arange(int(reverberation * rate)) / rate
    response = draw.normal(size=len(time)) * np.exp(-6.91 * time / reverberation)
    response = sosfilt(butter(1, min(HIGHEST * rate, draw.uniform(2000, 8000)), fs=rate, output="sos"), response)
    response /= np.sqrt((response**2).sum())
    response *= gain(-draw.uniform(0, 18))
    response[0] += 1
    return response


def coloured_noise(draw, rate, count, slope=None):
    """Steady noise between two soft edges, falling by `slope` (0 white, 2 brown): hiss, rumble and all that hides a
    sound."""
    slope = draw.uniform(0, 2) if slope is None else slope
    spectrum = np.fft.rfft(draw.normal(size=count))
    frequency = np.fft.rfftfreq(count, 1 / rate)
    spectrum *= np.maximum(frequency, 20) ** (-slope / 2)
    low = evenly_in_logarithm(draw, 20, 800)
    high = evenly_in_logarithm(draw, 2000, 0.49 * rate)
    spectrum *= 1 / np.sqrt(1 + (low / np.maximum(frequency, 1)) ** 4) / np.sqrt(1 + (frequency / high) ** 6)
    noise = np.fft.irfft(spectrum, count)
    return noise / noise.std()


def unsteady(draw, rate, count, pace, depth):
    """A gain that wanders `pace` times a second by `depth` [dB]: no hand and no machine rubs evenly."""
    points = max(4, int(count / rate * pace) + 3)
    return gain(stretched(draw.normal(size=points) * depth, count))


def fading(draw, count):
    """A gain from zero up and back to zero: a sound that starts and ends, fast or slowly."""
    rise, fall = int(draw.uniform(0.005, 0.2) * count), int(draw.uniform(0.005, 0.3) * count)
    course = np.ones(count)
    course[:rise] = np.linspace(0, 1, rise)
    if fall:
        course[-fall:] *= np.linspace(1, 0, fall) ** draw.uniform(0.5, 2)
    return course


def pitch(draw, rate, count, start, drift, jitter):
    """A frequency [Hz] that wanders slowly by `drift` and quickly by `jitter` [octaves], since no real tone stands
    still."""
    points = max(4, int(count / rate * 6) + 3)
    wander = np.cumsum(draw.normal(size=points)) * drift / np.sqrt(points)
    wander = stretched(wander - wander.mean(), count)
    points = max(8, int(count / rate * 80) + 3)
    return start * 2 ** (wander + stretched(draw.normal(size=points), count) * jitter)


def tone_kind(draw):
    """How the partials of a tone lie. Most squeals are harmonic; tyres and belts are narrow noise."""
    return draw.choice(["harmonic", "inharmonic", "noise"], p=[0.45, 0.2, 0.35])


def tone(draw, rate, frequency, kind):
    """A tone that follows `frequency` [Hz, one per sample] with partials of one kind: what all squeals and squeaks are
    made of."""
    count = len(frequency)
    sound = np.zeros(count)
    phase = 2 * np.pi * np.cumsum(frequency) / rate
    number, slope = draw.integers(1, 10), draw.uniform(0.3, 2)
    top = frequency.max()
    if kind == "harmonic":
        for order in range(1, number + 1):
            if top * order < HIGHEST * rate:
                sound += draw.uniform(0.2, 1) * order**-slope * np.sin(order * phase + draw.uniform(0, 6.28))
    elif kind == "inharmonic":
        ratio = 1.0
        for _ in range(number):
            if top * ratio < HIGHEST * rate:
                sound += draw.uniform(0.2, 1) * ratio**-slope * np.sin(ratio * phase + draw.uniform(0, 6.28))
            ratio *= draw.uniform(1.15, 2.2)
    else:
        # slow noise on the sine and the cosine of each harmonic gives a narrow band
        width = frequency.mean() / draw.uniform(15, 60)
        points = max(8, int(count / rate * width * 2) + 4)
        for order in range(1, draw.integers(2, 5)):
            if top * order > HIGHEST * rate:
                break
            even, odd = (stretched(draw.normal(size=points), count) for _ in range(2))
            sound += order**-slope * (even * np.cos(order * phase) + odd * np.sin(order * phase))
    return sound / (sound.std() + SILENCE)


def creak(draw, rate, count):
    """A creak: separate stick-slip releases at an irregular, gliding interval, ringing through wood, for that is how
    doors and floors sound."""
    sound = np.zeros(count)
    time, end = draw.uniform(0, 0.1), count / rate
    first, last = np.exp(draw.uniform(np.log(6), np.log(60), size=2))  # [Hz] releases a second
    jitter, depth, bend = draw.uniform(0.02, 0.3), draw.uniform(1, 6), draw.uniform(0.3, 3)
    while time < end:
        share = (time / end) ** bend
        pace = first ** (1 - share) * last**share
        sound[int(time * rate)] += gain(draw.normal() * depth) * draw.choice([-1, 1])
        time += np.exp(draw.normal() * jitter) / pace
        if draw.random() < 0.01:
            # the door stops for a moment
            time += draw.uniform(0.05, 0.4)
    body = modes(draw, rate)
    # a release lasts 0.2 to 1.5 ms
    width = int(draw.uniform(0.0002, 0.0015) * rate) + 1
    sound = np.convolve(sound, np.hanning(width + 2)[1:-1], "same")
    return fftconvolve(sound, body)[:count] * unsteady(draw, rate, count, 3, 3)


def squeal(draw, rate, count):
    """A squeal: one steady tone as long as the sound, for brakes, belts and wheels in curves hold their tone."""
    start = min(evenly_in_logarithm(draw, 350, 6000), 0.3 * rate)
    frequency = pitch(draw, rate, count, start, draw.uniform(0, 0.12), draw.uniform(0, 0.004))
    sound = tone(draw, rate, frequency, tone_kind(draw))
    return sound * unsteady(draw, rate, count, draw.uniform(2, 20), draw.uniform(0, 3)) * fading(draw, count)


def squeak(draw, rate, count):
    """A squeak: short tones that glide and jump, one or many, for shoes, hinges and toys start and stop."""
    sound = np.zeros(count)
    at = int(draw.uniform(0, 0.1) * rate)
    centre = min(evenly_in_logarithm(draw, 300, 4000), 0.25 * rate)
    kind = tone_kind(draw)
    many = draw.random() < 0.75
    while at < count:
        length = int((draw.uniform(0.05, 0.3) if many else draw.uniform(0.25, 0.7)) * rate)
        length = min(length, count - at)
        if length < int(0.03 * rate):
            break
        glide = draw.uniform(-1, 1) * draw.uniform(0.05, 1.2)
        share = np.linspace(0, 1, length)
        bend = draw.uniform(-0.5, 0.5) * draw.random()
        octaves = draw.normal() * 0.35 + glide * (share - 0.5) + bend * np.sin(np.pi * share)
        frequency = np.minimum(centre * 2**octaves, 0.4 * rate)
        sound[at:at + length] += tone(draw, rate, frequency, kind) * fading(draw, length) * gain(draw.normal() * 3)
        pause = draw.uniform(0, 0.05) if draw.random() < 0.5 else draw.uniform(0.03, 0.5)
        at += length + int(pause * rate)
        if not many and draw.random() < 0.5:
            break
    return sound


def rubbing(draw, rate, count):
    """Rubbing without a tone, such as sanding or dragging: noise that swells, the nearest neighbour of friction that
    is heard."""
    noise = coloured_noise(draw, rate, count)
    return noise * unsteady(draw, rate, count, draw.uniform(0.5, 12), draw.uniform(0, 6)) * fading(draw, count)


def gravel(draw, rate, count):
    """Gravel, crackle or a shower of grains: impulses at random times through small hard bodies, which a creak must
    not be mistaken for."""
    pace = evenly_in_logarithm(draw, 5, 300)
    number = draw.poisson(pace * count / rate)
    grains = np.zeros(count)
    at = draw.integers(0, count, number)
    grains[at] += gain(draw.normal(size=number) * draw.uniform(3, 10)) * draw.choice([-1, 1], number)
    sound = np.zeros(count)
    for _ in range(3):
        some = grains * (draw.random(count) < 0.4)
        sound += fftconvolve(some, modes(draw, rate, frequencies=(500, 9000), decays=(0.0005, 0.008)))[:count]
    return sound / (sound.std() + SILENCE) + coloured_noise(draw, rate, count) * gain(-draw.uniform(-5, 20))


def wind(draw, rate, count):
    """Wind: noise through a resonance that wanders, which whistles a little and is still no squeal."""
    centre, quality = evenly_in_logarithm(draw, 150, 1500), draw.uniform(1, 7)
    noise = draw.normal(size=count)
    sound = np.zeros(count)
    block = int(0.05 * rate)
    memory = np.zeros(2)
    draw.normal()  # one number is not used
    octaves = 0.0
    for first in range(0, count, block):
        octaves = 0.97 * octaves + draw.normal() * 0.08
        angle = 2 * np.pi * min(centre * 2**octaves, 0.4 * rate) / rate
        width = np.sin(angle) / (2 * quality)
        forward = np.array([width, 0, -width]) / (1 + width)
        backward = np.array([1, -2 * np.cos(angle) / (1 + width), (1 - width) / (1 + width)])
        sound[first:first + block], memory = lfilter(forward, backward, noise[first:first + block], zi=memory)
    swelling = sound / sound.std() * unsteady(draw, rate, count, 1.5, 4)
    return swelling + coloured_noise(draw, rate, count, 1.5) * gain(-draw.uniform(5, 25))


def thump(draw, rate, count):
    """One to three thumps, as of doors and boxes: short noise through a large body, an impulse that is alone."""
    sound = np.zeros(count)
    for _ in range(draw.integers(1, 4)):
        at = int(draw.uniform(0, 0.8) * count)
        body = modes(draw, rate, frequencies=(50, 3000), decays=(0.01, 0.15))
        knock = fftconvolve(draw.normal(size=int(draw.uniform(0.001, 0.02) * rate)), body)
        knock /= knock.std()
        length = min(len(knock), count - at)
        sound[at:at + length] += knock[:length] * gain(draw.normal() * 5)
    return sound + coloured_noise(draw, rate, count) * gain(-draw.uniform(20, 50))


def engine(draw, rate, count):
    """An engine or a motor: many orders of a low speed that drifts, since a tone alone makes no squeal."""
    start = evenly_in_logarithm(draw, 25, 250)
    frequency = pitch(draw, rate, count, start, draw.uniform(0, 0.8), 0.003)
    phase = 2 * np.pi * np.cumsum(frequency) / rate
    sound = np.zeros(count)
    slope = draw.uniform(0.5, 1.5)
    # half orders are those of a four-stroke engine
    for order in np.arange(1, 30) / draw.choice([1, 2]):
        if frequency.max() * order < HIGHEST * rate:
            sound += draw.uniform(0.1, 1) * order**-slope * np.sin(order * phase + draw.uniform(0, 6.3))
    return sound / sound.std() + coloured_noise(draw, rate, count, 1.5) * gain(-draw.uniform(-3, 20))


def water(draw, rate, count):
    """Running water: many bubbles, each a short rising tone, which is a chirp and still no squeak."""
    sound = np.zeros(count)
    number = draw.poisson(evenly_in_logarithm(draw, 20, 300) * count / rate)
    for _ in range(number):
        at = draw.integers(0, count)
        frequency = evenly_in_logarithm(draw, 400, 5000)
        decay = draw.uniform(3, 12) / frequency
        length = min(int(6 * decay * rate), count - at)
        time = np.arange(length) / rate
        loudness = gain(draw.normal() * 6)
        rising = 2 * np.pi * frequency * (1 + draw.uniform(0, 3) * time) * time
        sound[at:at + length] += loudness * np.exp(-time / decay) * np.sin(rising)
    return sound / (sound.std() + SILENCE) + coloured_noise(draw, rate, count, 1) * gain(-draw.uniform(5, 30))


def voice(draw, rate, count):
    """Speech and shouts: pulses of the glottis and breath through formants that jump, with pauses, for a voice glides
    as a squeak does."""
    frequency = pitch(draw, rate, count, evenly_in_logarithm(draw, 85, 320), draw.uniform(0.1, 0.8),
                      draw.uniform(0.001, 0.01))
    periods = np.floor(np.cumsum(frequency) / rate)
    pulses = np.zeros(count)
    pulses[1:] = periods[1:] > periods[:-1]
    pulses = sosfilt(butter(1, min(0.4 * rate, draw.uniform(300, 1500)), fs=rate, output="sos"), pulses)
    pulses /= pulses.std() + SILENCE
    breath = draw.normal(size=count)
    size = draw.uniform(0.85, 1.25)  # of the formants, as throats differ
    memories = [np.zeros(2) for _ in range(3)]
    sound = np.zeros(count)
    at = 0
    while at < count:
        length = min(int(draw.uniform(0.05, 0.2) * rate), count - at)
        part = slice(at, at + length)
        chance = draw.random()
        formants = FORMANTS[draw.integers(len(FORMANTS))] * size
        # a vowel, a hiss or a pause
        is_vowel, is_hiss = chance < 0.65, 0.65 <= chance < 0.82
        pulse_share, breath_share = (1, 0.02) if is_vowel else (0, 0.35) if is_hiss else (0, 0)
        source = pulses[part] * pulse_share + breath[part] * breath_share
        if is_hiss:
            source = np.diff(source, prepend=0) * 2
        place = np.arange(length)
        source = source * np.minimum(1, np.minimum(place, length - place) / (0.01 * rate))
        spoken = np.zeros(length)
        for order, memory in enumerate(memories):
            angle = 2 * np.pi * min(formants[order], 0.42 * rate) / rate
            radius = np.exp(-np.pi * (60 + 40 * order) / rate)
            backward = [1, -2 * radius * np.cos(angle), radius * radius]
            formant, memories[order] = lfilter([1 - radius], backward, source, zi=memory)
            spoken += formant * 0.6**order
        if is_hiss:
            spoken = spoken * 0.1 + source * 0.1
        sound[part] = spoken * gain(draw.normal() * 3)
        at += length
    return sound / (sound.std() + SILENCE)


def click(draw, rate):
    """A dry click: noise of some tenths of a millisecond in a wide band, without a body that rings."""
    length = 4 * max(2, int(evenly_in_logarithm(draw, 1e-4, 1.5e-3) * rate))
    knock = draw.normal(size=length) * np.exp(-4 * np.arange(length) / length)
    band = [evenly_in_logarithm(draw, 200, 2500), min(HIGHEST * rate, evenly_in_logarithm(draw, 3000, 16000))]
    return sosfilt(butter(1, band, "band", fs=rate, output="sos"), knock)


def dry_row(draw, rate, count):
    """A row of dry clicks, 8 to 200 a second: releases of stick and slip at a body that does not ring. Their pace
    glides and wavers, and so do their heights."""
    pace, glide = evenly_in_logarithm(draw, 8, 200), draw.normal() * 0.4  # [Hz], [octaves]
    waver, spread = draw.uniform(0.02, 0.25), draw.uniform(1, 6)  # [1] of an interval, [dB] of the heights
    is_one = draw.random() < 0.5  # the same click each time
    one = click(draw, rate)
    sound = np.zeros(count + rate)
    duration = count / rate
    instant = 0.02
    while instant < duration - 0.02:
        here = one if is_one else click(draw, rate)
        at = int(instant * rate)
        sound[at:at + len(here)] += gain(draw.normal() * spread) * here
        octaves = glide * (instant / duration - 0.5)
        instant += max(0.3, 1 + waver * draw.normal()) / (pace * 2**octaves)
    return sound[:count] * unsteady(draw, rate, count, 2, draw.uniform(0, 6))


def rain(draw, rate, count):
    """Drops on a hard ground: the same clicks at instants that know nothing of each other."""
    spread = draw.uniform(2, 9)
    sound = np.zeros(count + rate)
    for _ in range(draw.poisson(evenly_in_logarithm(draw, 5, 300) * count / rate)):
        drop = click(draw, rate)
        at = draw.integers(0, count)
        sound[at:at + len(drop)] += gain(draw.normal() * spread) * drop
    return sound[:count]


def steps(draw, rate, count):
    """Steps: an even row, of one to four dull noises a second."""
    pace = draw.uniform(1.2, 4)
    sound = np.zeros(count + 2 * rate)
    instant = draw.uniform(0, 0.3)
    while instant < count / rate:
        length = int(evenly_in_logarithm(draw, 0.02, 0.15) * rate)
        step = draw.normal(size=length) * np.exp(-4 * np.arange(length) / length)
        highest = min(HIGHEST * rate, evenly_in_logarithm(draw, 400, 5000))
        step = sosfilt(butter(1, highest, fs=rate, output="sos"), step)
        at = int(instant * rate)
        sound[at:at + length] += step * gain(draw.normal() * 2)
        instant += (1 + 0.08 * draw.normal()) / pace
    return sound[:count]


# a name that stands twice is twice as likely
SOURCES = {
    "creak": [creak],
    "squeal": [squeal],
    "squeak": [squeak],
    "none": [rubbing, rubbing, gravel, gravel, wind, thump, engine, water, voice, voice, engine],
}


# so many for each of COUNT: dry rows, and what looks like them
DRY = [("creak", dry_row, 0.27), ("none", rain, 0.1), ("none", steps, 0.05)]


def recorded(draw, rate, sound, category, through_panels=0.3):
    """The sound as a microphone gets it: perhaps through a panel, perhaps in a room, with noise, at some level. None
    gets no more noise, for most of it is noise by itself."""
    if draw.random() < through_panels:
        panel = modes(draw, rate, number=draw.integers(8, 30), decays=(0.001, 0.01))
        sound = fftconvolve(sound, panel)[:len(sound)]
    if draw.random() < 0.6:
        sound = fftconvolve(sound, room(draw, rate))
    sound = sound / (sound.std() + SILENCE)
    if category != "none" and draw.random() < 0.8:
        noise = coloured_noise(draw, rate, len(sound)) * gain(-draw.uniform(0, 40))
        sound = sound + noise * unsteady(draw, rate, len(sound), 2, 2)
    return sound * gain(draw.uniform(-30, -3))


def synthesise(seed, category):
    """Samples [1], sampling rate [Hz] and source of the sound of a seed: rates and lengths vary as in real clips."""
    draw = np.random.default_rng(seed)
    rate = int(draw.choice(RATES, p=RATE_SHARES))
    count = int(evenly_in_logarithm(draw, SHORTEST, LONGEST) * rate)
    sources = SOURCES[category]
    source = sources[draw.integers(len(sources))]
    if category != "none":
        count = max(count, int(SHORTEST_FRICTION * rate))
    return recorded(draw, rate, source(draw, rate, count), category), rate, source.__name__


def synthesise_dry(seed, source):
    """The same of clicks and steps, which no panel rings to."""
    draw = np.random.default_rng(seed)
    rate = int(draw.choice(RATES, p=RATE_SHARES))
    count = int(evenly_in_logarithm(draw, SHORTEST_FRICTION, LONGEST) * rate)
    sound = source(draw, rate, count)
    sound = sound / (sound.std() + SILENCE) + coloured_noise(draw, rate, count) * gain(-draw.uniform(15, 50))
    return recorded(draw, rate, sound, "none", through_panels=0), rate, source.__name__


def write_sound(job):
    """Writes one sound, scaled down if it would clip, and returns its row of the table."""
    folder, seed, category, source = job
    sound, rate, source = synthesise_dry(seed, source) if source else synthesise(seed, category)
    name = f"{category}_{seed}.wav"
    sound = np.clip(sound / max(1, np.abs(sound).max()), -1, 1)
    soundfile.write(os.path.join(folder, name), sound, rate, subtype="PCM_16")
    return [name, "synthetic", name, source, category, "synthetic", "own"]


def main():
    parser = argparse.ArgumentParser(description="Makes sounds of known category.")
    parser.add_argument("count", type=int, metavar="COUNT", help="sounds of each category")
    parser.add_argument("folder", metavar="FOLDER")
    parser.add_argument("--dry", action="store_true", help="rows of dry clicks, rain and steps as well")
    options = parser.parse_args()
    os.makedirs(options.folder, exist_ok=True)
    jobs = [(options.folder, seed, CATEGORIES[seed % 4], None) for seed in range(4 * options.count)]
    for category, source, share in DRY if options.dry else []:
        jobs += [(options.folder, len(jobs) + k, category, source) for k in range(int(share * options.count))]
    with ProcessPoolExecutor(os.cpu_count()) as pool:
        rows = list(pool.map(write_sound, jobs, chunksize=8))
    with open(os.path.join(options.folder, "table.csv"), "w", newline="") as text:
        table = csv.writer(text)
        table.writerow(["file", "repository", "path", "label", "expected", "confidence", "licence"])
        table.writerows(rows)


if __name__ == "__main__":
    main()
