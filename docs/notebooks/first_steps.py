# %% [markdown]
# # First steps: does it squeal, which way, and why?
#
# A rubber lip rubs on a glass plate that moves to and fro, 4 mm at 5 Hz. It weighs 100 g, leans by 70° and is pressed
# with 20 N. *Does it make a noise, in which direction, and what could be done?* The numbers are Table 1, column 2, of
# the paper that Stridor's model comes from.

# %%
import matplotlib.pyplot as plt
import numpy as np
import stridor

case = stridor.case("squeal")
case

# %% [markdown]
# Numbers are SI units, angles degrees, and text carries its unit. What makes no sense is refused at once:

# %%
case.contact.preload = "20 N"
try:
    case.contact.kinetic_friction = 0.9
except stridor.InputError as error:
    print(error)

# %% [markdown]
# ## The verdict
#
# The program computes one second of motion, and judges each direction by itself.

# %%
motion = stridor.simulate(case)
motion

# %%
for phase in motion.phases:
    print(f"{phase.name:7} {phase.category:7} slips {phase.slip:5.1%} of the time, "
          f"{phase.joint_level:.0f} dB re 1 nm/s")
assert (motion.going.category, motion.coming.category) == ("squeal", "none")

# %% [markdown]
# It squeals while the plate goes, and is quiet while it comes: nothing but the sign of the velocity differs. A level
# here is one of vibration, not a sound pressure: how loud it is in the room is not known to the model.
#
# ## What it does
#
# The velocity of the lip, and below it the normal force with the state of the contact. The lip lifts off, flies, hits
# the glass and is thrown off again, hundreds of times a second. It is pressed with 20 N, and hits with many times that.

# %%
trace = motion.trace(0.12, 0.28, "50 us")
closer = trace.sel(time=slice(0.20, 0.21))
words = closer.state

figure, (whole, detail) = plt.subplots(2, figsize=(8, 5.5), layout="constrained")
whole.plot(1e3 * trace.time, trace.velocity.sel(dof="x1"), linewidth=0.6, color="#004488", label="lip")
whole.plot(1e3 * trace.time, trace.surface_velocity, color="#BB5566", label="glass")
whole.set(xlabel="time [ms]", ylabel="velocity along the glass [m/s]",
          title="it squeals while the glass goes (150 to 250 ms), and hardly moves while it comes")
whole.legend(loc="upper right")
for state, colour in (("stick", "#004488"), ("slip", "#DDAA33"), ("separation", "#DDDDDD")):
    detail.fill_between(1e3 * closer.time, 0, 1, where=words == state, transform=detail.get_xaxis_transform(),
                        color=colour, alpha=0.35, linewidth=0, step="post", label=state)
detail.plot(1e3 * closer.time, closer.normal_force, color="black", linewidth=0.9)
detail.set(xlabel="time [ms]", ylabel="normal force [N]", title="10 ms of the squeal")
detail.legend(loc="upper right", ncols=3)

# %% [markdown]
# ## Which friction begins it?
#
# Two answers, by two ways. *Stability* asks whether a small disturbance of steady sliding grows. *Runs* show where the
# motion ends up, which also holds for large ones. One call computes all points on all processors.

# %%
scan = stridor.stability(case, over=stridor.axis("contact.kinetic_friction", 0, 0.79))
onset = scan.going.boundaries[0]
friction = np.linspace(0.02, 0.78, 77)
runs = stridor.evaluate(case, {"contact.kinetic_friction": friction})
category = np.asarray(runs.category.sel(direction="going"))
step = friction[1] - friction[0]
last_quiet = friction[category == "none"].max()
always = friction[category != "squeal"].max() + step
print(f"stability: steady sliding flutters above mu_d = {onset:.3f}")
print(f"runs: the last quiet one at mu_d = {last_quiet:.2f}, all squeal from {always:.2f} on")
print(f"of those below {last_quiet:.2f}, {(category[friction < last_quiet] == 'squeal').sum()} squeal")

figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6), layout="constrained")
for direction, colour in (("going", "#BB5566"), ("coming", "#004488")):
    figures = runs.sel(direction=direction)
    left.plot(friction, figures.growth_rate, color=colour, label=direction)
    right.plot(friction, figures.joint_level, ".-", color=colour, markersize=3, linewidth=0.6, label=direction)
left.axhline(0, color="grey", linewidth=0.8)
left.set(xlabel="kinetic friction [1]", ylabel="growth of a disturbance [1/s]", title="stability")
right.set(xlabel="kinetic friction [1]", ylabel="level of the lip [dB re 1 nm/s]", title="runs")
for axes in (left, right):
    axes.axvline(onset, color="grey", linestyle=":", linewidth=1)
    axes.legend()
assert 0.4 < last_quiet < onset < always < 0.5
assert runs.category.sel(direction="coming").isin(["none", "undecided"]).mean() > 0.9

# %% [markdown]
# Where going leaves zero on the left, two modes meet at one frequency: *mode coupling*, which depends on the direction
# of sliding because the lip leans. It needs no friction that falls with speed: a coating helps only as far as it lowers
# friction.
#
# The runs jump a little before the dotted onset. At each reversal the lip gets a kick, and a large motion can keep
# itself alive where a small one dies out. Between the last quiet run and the first that always squeals, most are
# *undecided*: a change as small as the errors of the computation would change the word. So stability explains the
# squeal, and runs decide it. The few that squeal at low friction are some 20 dB weaker: what rings after a reversal,
# near a threshold of the verdict. Look at the figures before you believe a word.
#
# ## Hear it, play with it
#
# In a notebook the next line is a player. `stridor.explore(case)` opens the page with sliders in a cell.

# %%
stridor.listen(case, direction="going", seconds=0.4)

# %% [markdown]
# **Limits.** The lip is one mass and two springs, the glass another; friction is Coulomb's. Such a model says what kind
# of noise to expect and what moves its borders. It does not say how many decibels reach an ear.
