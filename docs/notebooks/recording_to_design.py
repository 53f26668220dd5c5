# %% [markdown]
# # From a recording to a design
#
# A door seal makes a noise in a cold car, and somebody held a microphone beside it. *What kind of noise is it, which
# operating point of the model sounds like that, and what would make it quiet?*
#
# Stridor brings no recording of anybody's. This one is made from a joint whose preload we hide from ourselves, with
# noise added, so that the end can be held against the truth.

# %%
import pathlib
import tempfile
import wave

import matplotlib.pyplot as plt
import numpy as np
import stridor

folder = pathlib.Path(tempfile.mkdtemp(prefix="seal-"))
hidden = stridor.case("noise-chart").replace({"contact.preload": "90 N"})
rate = 48000
trace = stridor.simulate(hidden).trace(0.5, 1.0, 1 / rate)
velocity = np.asarray(trace.velocity.sel(dof="x1"))
sound = 0.5 * velocity / abs(velocity).max()
sound = sound + 0.02 * np.random.default_rng(7).normal(size=sound.size)
with wave.open(str(folder / "microphone.wav"), "wb") as file:
    file.setnchannels(1), file.setsampwidth(2), file.setframerate(rate)
    file.writeframes((32767 * np.clip(sound, -1, 1)).astype("<i2").tobytes())

# %% [markdown]
# ## What is it?

# %%
heard = stridor.read_sound(folder / "microphone.wav").classify()
heard

# %%
window = np.hanning(sound.size)
spectrum = abs(np.fft.rfft(window * sound)) / window.sum() * 2
frequency = np.fft.rfftfreq(sound.size, 1 / rate)
pitch = frequency[np.argmax(spectrum * (frequency > 50))]
resolution = rate / sound.size
print(f"heard as {heard.category}; the strongest line is at {pitch:.1f} Hz, give or take {resolution:.0f} Hz")

figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.4), layout="constrained")
time = np.arange(sound.size) / rate
left.plot(1e3 * time[:960], sound[:960], color="#004488", linewidth=0.8)
left.set(xlabel="time [ms]", ylabel="recording [full scale]", title="20 ms of it")
right.semilogy(frequency, spectrum, color="#004488", linewidth=0.7)
right.set(xlabel="frequency [Hz]", ylabel="amplitude [full scale]", xlim=(0, 4000), ylim=(1e-5, 1),
          title="its spectrum")
right.axvline(pitch, color="#BB5566", linestyle=":")

# %% [markdown]
# ## What moves like that?
#
# Preload and friction are not known. Every cell of a chart has a pitch, so that the ones with ours can be looked for.

# %%
case = stridor.case("noise-chart")
chart = stridor.chart(case, x=stridor.axis("contact.preload", 10, 1000, 41, scale="log"),
                      y=stridor.axis("contact.kinetic_friction", 0.3, 0.8, 26), directions="going")
cells = chart.to_xarray().sel(direction="going")
pitches = np.asarray(cells.frequency)
fits = abs(pitches / pitch - 1) < 0.02
print(f"{fits.sum()} of {fits.size} cells have this pitch within 2 %")

figure, axes = plt.subplots(figsize=(7, 4), layout="constrained")
chart.plot("frequency", direction="going", ax=axes)
row, column = np.nonzero(fits)
axes.plot(np.asarray(cells.preload)[column], np.asarray(cells.kinetic_friction)[row], "o", color="none",
          markeredgecolor="#BB5566", markersize=5, label="the recording's pitch")
axes.legend(loc="lower left")

# %% [markdown]
# Where it squeals, the pitch hardly knows friction: it tells the preload. What is left are a few cells at low friction,
# which a friction test rules out. It gives mu_d = 0.60 here, and one row of the chart, looked at closely:

# %%
preloads = np.geomspace(10, 1000, 400)
runs = stridor.evaluate(case, {"contact.preload": preloads, "contact.kinetic_friction": 0.6}, directions=["going"])
line = np.asarray(runs.frequency.sel(direction="going"))
candidates = preloads[abs(line - pitch) < 2.0]
print(f"{candidates.size} of 400 preloads have {pitch:.0f} Hz within 2 Hz: "
      f"{candidates.min():.0f} N to {candidates.max():.0f} N")
print(f"the truth: {hidden.text('contact.preload')}")
assert candidates.min() <= hidden.contact.preload <= candidates.max()

figure, axes = plt.subplots(figsize=(7, 3.2), layout="constrained")
axes.semilogx(preloads, line, ".", color="#004488", markersize=3)
axes.axhspan(pitch - 2, pitch + 2, color="#BB5566", alpha=0.3)
axes.axvline(hidden.contact.preload, color="grey", linestyle=":")
axes.set(xlabel="preload [N]", ylabel="pitch [Hz]", title="mu_d = 0.6; red: the recording, dotted: the truth")

# %% [markdown]
# ## Make it quiet
#
# From the found point: how far must friction fall? Stability has an answer. Runs are asked, too, and from two starts:
# at rest, and out of steady sliding with a small disturbance.

# %%
found = case.replace({"contact.preload": float(np.median(candidates))})
onset = stridor.stability(found, over=stridor.axis("contact.kinetic_friction", 0, 0.8)).going.boundaries[0]
friction = np.linspace(0.02, 0.6, 59)
figure, axes = plt.subplots(figsize=(7, 3.6), layout="constrained")
noisy = np.zeros(friction.size, dtype=bool)
for start, marker, colour in (("rest", "o", "#BB5566"), ("sliding", ".", "#004488")):
    runs = stridor.evaluate(found.replace({"run.initial": start}), {"contact.kinetic_friction": friction},
                            directions=["going"]).sel(direction="going")
    axes.plot(friction, runs.joint_level, marker, color=colour, markersize=4, fillstyle="none", label=f"from {start}")
    noisy |= np.asarray(runs.category != "none")
axes.axvline(onset, color="grey", linestyle=":", label="onset by stability")
axes.set(xlabel="kinetic friction [1]", ylabel="level of the lip [dB re 1 nm/s]", title="two ends of one design")
axes.legend()
limit = friction[np.argmax(noisy) - 1]
print(f"steady sliding flutters above {onset:.3f}; runs are quiet from both starts up to {limit:.2f}")

# %% [markdown]
# Between the two limits the end depends on the start: out of steady sliding it stays quiet, from rest it squeals. A
# design that only passes the stability analysis squeals after the first jolt. The lower limit is the one to keep, with
# a margin:

# %%
quiet = found.replace({"contact.kinetic_friction": round(0.8 * limit, 3)})
for name, design in (("before", found), ("below the onset", found.replace({"contact.kinetic_friction": 0.95 * onset})),
                     ("below the limit", quiet)):
    phase = stridor.simulate(design).whole
    print(f"{name:15} mu_d {design.contact.kinetic_friction:.3f}: {phase.category}, "
          f"{phase.joint_level:.0f} dB re 1 nm/s")
assert stridor.simulate(quiet).whole.category == "none" and limit < onset

# %% [markdown]
# **Limits.** The pitch fits because the recording came from the model. A real seal is more than two masses: take the
# masses and stiffnesses from its modes, and expect a few percent. A category by ear and one by contact states are two
# different verdicts (`docs/methods/ear.md`); they need not agree.
