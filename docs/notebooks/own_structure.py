# %% [markdown]
# # A structure of your own: where do two modes meet?
#
# Textbooks show mode coupling with two rows of numbers: a mass on two springs that lean, pressed on something that
# moves. *Can the onset of squeal be computed by hand, does the program find the same, and what do more contacts do?*
# Matrices come in as NumPy or SciPy arrays.

# %%
import matplotlib.pyplot as plt
import numpy as np
import stridor

mass, plate_mass = 0.1, 0.4  # [kg]
axial, flexural, plate_stiffness = 1e7, 1e6, 1e6  # [N/m]
angle = np.deg2rad(70.0)  # of the lip, from the plate

M = np.diag([mass, mass, plate_mass])  # rows: lip along x, lip across y, plate across y
along = np.array([np.cos(angle), np.sin(angle)])
across = np.array([-np.sin(angle), np.cos(angle)])
K = np.zeros((3, 3))
K[:2, :2] = axial * np.outer(along, along) + flexural * np.outer(across, across)
K[2, 2] = plate_stiffness
C = np.zeros((3, 3))
C[:2, :2] = np.eye(2)  # [N*s/m]
C[2, 2] = 1.0
print(K)

# %% [markdown]
# ## By hand
#
# While the lip slides on the plate, both have one motion across, y, and friction is mu N against the motion:
#
#     m x'' + k_xx x + k_xy y = s mu N,        (m + M) y'' + k_xy x + (k_yy + K) y = 0,
#     N = m y'' + k_xy x + k_yy y              with s = 1 while the plate goes, -1 while it comes
#
# Friction puts a term into the matrices of x that has no partner across the diagonal, so their eigenvalues may leave
# the imaginary axis.

# %%
def fastest_growth(mu, direction):
    """The largest real part of all eigenvalues of steady sliding [1/s]."""
    pull = -direction * mu
    m = np.array([[mass, pull * mass], [0.0, mass + plate_mass]])
    c = np.array([[C[0, 0], pull * C[1, 1]], [0.0, C[1, 1] + C[2, 2]]])
    k = np.array([[K[0, 0] + pull * K[0, 1], K[0, 1] + pull * K[1, 1]], [K[0, 1], K[1, 1] + K[2, 2]]])
    inverse = np.linalg.inv(m)
    state = np.block([[np.zeros((2, 2)), np.eye(2)], [-inverse @ k, -inverse @ c]])
    return np.linalg.eigvals(state).real.max()


friction = np.linspace(0.0, 0.8, 401)
growth = {direction: np.array([fastest_growth(mu, direction) for mu in friction]) for direction in (1, -1)}
print({direction: f"{rates.max():.1f} 1/s at most" for direction, rates in growth.items()})
low, high = 0.0, 0.8  # halved until they are one number
for _ in range(50):
    middle = (low + high) / 2
    low, high = (low, middle) if fastest_growth(middle, 1) > 0 else (middle, high)
by_hand = high
print(f"onset by hand, going: {by_hand:.5f}")

# %% [markdown]
# ## By the program
#
# The contact joins lip and plate: its gap opens when the lip goes up against the plate, its tangent is the lip's x.

# %%
lip = stridor.structure(
    title="a leaning lip on a plate", mass=M, stiffness=K, damping=C, rows=["x", "y", "plate"],
    contacts=[{"name": "edge", "normal": "y -plate", "tangent": "x"}],
    values={"preload": "20 N", "mu_s": 0.8, "mu_d": 0.6, "drive.kind": "constant", "drive.velocity": "0.1 m/s"})
scan = stridor.stability(lip, over=stridor.axis("contact.kinetic_friction", 0, 0.8))
program = scan.going.boundaries[0]
print(f"onset by the program, going: {program:.5f}; coming: {scan.coming.kind} throughout")

figure, axes = plt.subplots(figsize=(7, 3.6), layout="constrained")
for direction, colour in ((1, "#BB5566"), (-1, "#004488")):
    axes.plot(friction, growth[direction], color=colour, label=f"by hand, s = {direction:+d}")
axes.axvline(program, color="black", linestyle=":", linewidth=1, label=f"the program: {program:.4f}")
axes.set(xlabel="kinetic friction [1]", ylabel="fastest growth [1/s]", title="two modes meet")
axes.legend()
assert abs(by_hand - program) < 1e-5

# %% [markdown]
# The same lip comes with the program as the case *squeal*: its onset is that of our matrices, and so is the verdict.

# %%
ready = stridor.stability(stridor.case("squeal"), over=stridor.axis("contact.kinetic_friction", 0, 0.8))
print("the case that comes along:", round(ready.going.boundaries[0], 5))
motion = stridor.simulate(lip)
print(motion)
assert abs(ready.going.boundaries[0] - program) < 1e-6
motion

# %% [markdown]
# ## Five lips
#
# What no ready case has: five lips in a row on one plate, each a little softer than its neighbour. The matrices grow by
# `numpy.kron`; the plate's row is shared.

# %%
lips = 5
softer = np.linspace(1.1, 0.9, lips)
M5 = np.diag(np.r_[np.full(2 * lips, mass), plate_mass * lips])
K5 = np.zeros((2 * lips + 1, 2 * lips + 1))
C5 = np.eye(2 * lips + 1)
for k in range(lips):
    K5[2 * k: 2 * k + 2, 2 * k: 2 * k + 2] = softer[k] * K[:2, :2]
K5[-1, -1] = C5[-1, -1] = lips
K5[-1, -1] *= plate_stiffness
rows = [f"{axis}{k + 1}" for k in range(lips) for axis in "xy"] + ["plate"]
contacts = [{"name": f"lip{k + 1}", "normal": f"y{k + 1} -plate", "tangent": f"x{k + 1}"} for k in range(lips)]
row_of_lips = stridor.structure(
    title="five lips on a plate", mass=M5, stiffness=K5, damping=C5, rows=rows, contacts=contacts,
    values={"preload": "100 N", "mu_s": 0.8, "mu_d": 0.6, "drive.kind": "constant", "drive.velocity": "0.1 m/s",
            "run.duration": "0.5 s", "run.window": "0.25 s"})
together = stridor.simulate(row_of_lips)
phase = together.to_dict()["phases"][0]
for contact in phase["contacts"]:
    rates = contact["rates"]
    print(f"{contact['name']}: {contact['verdict']['category']:7} slips {rates['slip']:.1%} of the time")
together

# %%
history = together.trace(0.4, 0.42, "20 us")
figure, axes = plt.subplots(figsize=(8, 3.6), layout="constrained")
for k in range(lips):
    axes.plot(1e3 * history.time, history.velocity.sel(dof=f"x{k + 1}") + k, linewidth=0.8)
axes.set(xlabel="time [ms]", ylabel="velocity along the plate [m/s], 1 m/s apart", title="five lips, 20 ms",
         yticks=range(lips), yticklabels=[f"lip{k + 1}" for k in range(lips)])

# %% [markdown]
# **Limits.** Matrices of up to 2000 rows are taken, up to ten contacts are fast. Parts of a finite-element program are
# reduced before (`stridor structure reduce`), and keep their units and nodes.
