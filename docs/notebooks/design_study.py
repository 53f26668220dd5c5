# %% [markdown]
# # A design study: how much scatter does a quiet design bear?
#
# A seal rubs on glass. In production the preload scatters by 15 %, and friction changes with dust and rain. *Which
# combinations make a noise, what is the smallest change to quiet, and how sure is it?*

# %%
import matplotlib.pyplot as plt
import numpy as np
import stridor

case = stridor.case("noise-chart")
print(f"preload {case.text('contact.preload')}, mu_d {case.contact.kinetic_friction}, "
      f"drive {case.text('drive.velocity')}")
case

# %% [markdown]
# ## The map
#
# A chart over both. `refine` computes each second cell first, and the ones between only where neighbours differ.

# %%
chart = stridor.chart(case, x=stridor.axis("contact.preload", 2, 4000, 41, scale="log"),
                      y=stridor.axis("contact.kinetic_friction", 0, 0.8, 33), refine=2)
figure, plots = plt.subplots(1, 2, figsize=(10, 4), layout="constrained", sharey=True)
for direction, axes in zip(("going", "coming"), plots):
    chart.plot("category", direction=direction, ax=axes)
    chart.plot_boundaries(direction=direction, ax=axes, color="black", linewidth=0.8)
    axes.plot(case.contact.preload, case.contact.kinetic_friction, "wo", markeredgecolor="black", label="the design")
plots[0].legend(loc="lower right")
print("going: ", chart.counts("going"))
print("coming:", chart.counts("coming"))

# %% [markdown]
# Going, the design stands in the squeal, and no preload helps at its friction: the border is one of friction.
# It is better seen by numbers. Where, at each preload, does friction begin to make a noise?

# %%
cells = chart.to_xarray()
categories = cells.category.sel(direction="going")
is_quiet = np.asarray(categories == "none")
friction = np.asarray(cells.kinetic_friction)
quiet_up_to = [friction[: np.argmin(column)].max(initial=0.0) if not column.all() else friction[-1]
               for column in is_quiet.T]
for preload, limit in list(zip(np.asarray(cells.preload), quiet_up_to))[::8]:
    print(f"{preload:8.1f} N: quiet up to mu_d = {limit:.3f}")

# %% [markdown]
# ## The smallest change
#
# Friction is the tribologist's. The designer may lean the lip and choose its stiffness. `advise` looks for the smallest
# change (in shares of the usual ranges), and verifies it: from rest, from stick and from sliding, and around it.

# %%
levers = ["joint.incidence_angle", "joint.flexural_stiffness"]
advice = stridor.advise(case, over=levers)
for margin in advice.margins:
    for side in ("quiet_below", "quiet_above"):
        if margin[side]:
            limit = f"{margin[side]['value']:.4g} {margin['unit']}"
            print(f"{margin['key']}: quiet {side[6:]} {limit} (is {margin['value']:.4g})")
quieter = case.copy()
for step in advice.change["set"]:
    print(f"change {step['key']} from {step['from']:g} to {step['to']:g} {step['unit']}")
    quieter[step["key"]] = step["to"]
motion = stridor.simulate(quieter)
print("then:", ", ".join(f"{phase.name} {phase.category}" for phase in motion.phases))
assert advice.category == "squeal" and motion.whole.category == "none"

# %% [markdown]
# ## Within the tolerances
#
# The verified point may lie close to a border. What remains of it when preload, friction and the angle scatter? Each
# dot is a design of the production: 2000 runs by one call.

# %%
random = np.random.default_rng(1)
count = 2000
scatter = {"contact.preload": quieter.contact.preload * random.uniform(0.85, 1.15, count),
           "contact.kinetic_friction": np.clip(random.normal(0.6, 0.05, count), 0.0, 0.8),
           "joint.incidence_angle": quieter.joint.incidence_angle + random.uniform(-2.0, 2.0, count)}
production = stridor.evaluate(quieter, scatter)
is_noisy = np.asarray((production.category != "none").any("direction"))
share = is_noisy.mean()
half = 1.96 * np.sqrt(max(share * (1 - share), 1 / count) / count)
print(f"{share:.1%} of them are not quiet (95 %: {max(share - half, 0):.1%} to {min(share + half, 1):.1%})")

figure, axes = plt.subplots(figsize=(7, 4), layout="constrained")
for noisy, colour, name in ((False, "#BBBBBB", "quiet"), (True, "#BB5566", "not quiet")):
    chosen = is_noisy == noisy
    axes.scatter(scatter["joint.incidence_angle"][chosen], scatter["contact.kinetic_friction"][chosen], s=6,
                 color=colour, label=f"{name}: {chosen.sum()}")
axes.set(xlabel="incidence angle [deg]", ylabel="kinetic friction [1]", title="the changed design, as it is produced")
axes.legend(loc="upper left")

# %% [markdown]
# So a verified change can still be too small. The next step is to go further along it until the share is one that can
# be borne, and to see what it costs:

# %%
for factor in (1.0, 1.5, 2.0, 3.0):
    further = quieter.copy()
    for step in advice.change["set"]:
        further[step["key"]] = step["from"] + factor * (step["to"] - step["from"])
    moved = dict(scatter)
    moved["joint.incidence_angle"] = scatter["joint.incidence_angle"] + (further.joint.incidence_angle
                                                                         - quieter.joint.incidence_angle)
    shares = (stridor.evaluate(further, moved).category != "none").any("direction").mean()
    print(f"{factor:3.1f} times the change: {float(shares):6.1%} not quiet")

# %% [markdown]
# **Limits.** The scatter of friction is a guess here, and it decides. Measure it first (`stridor classify` and a
# friction test), then believe the share. Chances count designs, not minutes of noise.
