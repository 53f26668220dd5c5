"""A strip of rubber on a moving surface by Siconos' Moreau-Jean stepping: time per step and shares of the contacts.

    python3 bench/peers/siconos_strip.py COLUMNS STEP DURATION

The strip is that of tests/support/structures/meshed_strip.hpp with mu_s = mu_d = 0.5: Siconos knows one coefficient.
The surface is a body of its own, so heavy that friction does not slow it. Needs python3-siconos (4.4).
"""

import sys
import time

import numpy as np
import siconos.kernel as sk
import siconos.numerics as sn

LENGTH, HEIGHT, LAYERS, YOUNG, POISSON, DENSITY, PRESSED = 0.04, 0.01, 4, 5e6, 0.4, 1100.0, 1e-4
FRICTION, VELOCITY, SURFACE_MASS = 0.5, 0.1, 1e12


def element(width, depth):
    law = YOUNG / ((1 + POISSON) * (1 - 2 * POISSON)) * np.array(
        [[1 - POISSON, POISSON, 0], [POISSON, 1 - POISSON, 0], [0, 0, 0.5 - POISSON]])
    corner = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
    stiffness = np.zeros((8, 8))
    for x in (-3 ** -0.5, 3 ** -0.5):
        for y in (-3 ** -0.5, 3 ** -0.5):
            along, across = 1 + corner[:, 0] * x, 1 + corner[:, 1] * y
            dx, dy = 0.5 * corner[:, 0] * across / width, 0.5 * corner[:, 1] * along / depth
            strain = np.zeros((3, 8))
            strain[0, 0::2] = strain[2, 1::2] = dx
            strain[1, 1::2] = strain[2, 0::2] = dy
            stiffness += width * depth / 4 * strain.T @ law @ strain
    return stiffness


def strip(columns):
    """Mass, damping, stiffness, load of the free rows; two rows a node, the contacts' nodes first."""
    across = columns + 1
    rows, every = 2 * across * LAYERS, 2 * across * (LAYERS + 1)
    each = element(LENGTH / columns, HEIGHT / LAYERS)
    stiffness, mass = np.zeros((every, every)), np.zeros(every)
    for j in range(LAYERS):
        for i in range(columns):
            nodes = [i + j * across, i + 1 + j * across, i + 1 + (j + 1) * across, i + (j + 1) * across]
            at = [2 * node + c for node in nodes for c in (0, 1)]
            stiffness[np.ix_(at, at)] += each
            mass[at] += DENSITY * LENGTH / columns * HEIGHT / LAYERS / 4
    top = np.zeros(every - rows)
    top[1::2] = -PRESSED
    push = -stiffness[:rows, rows:] @ top
    K, m = stiffness[:rows, :rows], mass[:rows]
    moves = [row for row in range(rows) if row >= 2 * across or row % 2 == 0]
    rest = np.zeros(rows)
    rest[moves] = np.linalg.solve(K[np.ix_(moves, moves)], push[moves])
    force = K @ rest - push
    load = np.zeros(rows)
    load[1:2 * across:2] = -force[1:2 * across:2]
    root = np.sqrt(m)
    square, shape = np.linalg.eigh(K / root[:, None] / root[None, :])
    C = root[:, None] * (shape * (0.02 * np.sqrt(square))) @ shape.T * root[None, :]
    return np.diag(m), C, K, load, across


def main():
    columns, step, duration = int(sys.argv[1]), float(sys.argv[2]), float(sys.argv[3])
    M, C, K, load, contacts = strip(columns)
    n = len(load)
    extended = np.zeros((n + 1, n + 1))
    mass, damping, stiffness = extended.copy(), extended.copy(), extended.copy()
    mass[:n, :n], damping[:n, :n], stiffness[:n, :n] = M, C, K
    mass[n, n] = SURFACE_MASS
    velocity = np.zeros(n + 1)
    velocity[n] = VELOCITY
    velocity[0:2 * contacts:2] = [4e-4 if i % 2 == 0 else -3e-4 for i in range(contacts)]
    body = sk.LagrangianLinearTIDS(np.zeros(n + 1), velocity, mass, stiffness, damping)
    body.setFExtPtr(np.append(load, 0.0))
    model = sk.NonSmoothDynamicalSystem(0.0, duration)
    model.insertDynamicalSystem(body)
    interactions = []
    for k in range(contacts):
        H = np.zeros((2, n + 1))
        H[0, 2 * k + 1] = 1.0
        H[1, 2 * k] = 1.0
        H[1, n] = -1.0
        interaction = sk.Interaction(sk.NewtonImpactFrictionNSL(0.0, 0.0, FRICTION, 2), sk.LagrangianLinearTIR(H))
        model.link(interaction, body)
        interactions.append(interaction)
    problem = sk.FrictionContact(2, sn.SICONOS_FRICTION_2D_NSGS)
    options = problem.numericsSolverOptions()
    options.iparam[sn.SICONOS_IPARAM_MAX_ITER] = 1000
    options.dparam[sn.SICONOS_DPARAM_TOL] = 1e-8
    simulation = sk.TimeStepping(model, sk.TimeDiscretisation(0.0, step), sk.MoreauJeanOSI(0.5), problem)
    stick = slip = opened = steps = 0
    spent = 0.0
    while simulation.hasNextEvent():
        begin = time.process_time()
        simulation.computeOneStep()
        spent += time.process_time() - begin
        steps += 1
        if steps * step > 0.25 * duration and steps % 5 == 0:
            for interaction in interactions:
                normal = interaction.lambda_(1)[0]
                rate = abs(interaction.y(1)[1])
                if not normal > 0.0:
                    opened += 1
                elif rate < 1e-6 * VELOCITY:
                    stick += 1
                else:
                    slip += 1
        simulation.nextStep()
    total = max(1, stick + slip + opened)
    print(f"Siconos {columns} columns, h {step:g} s: {1e6 * spent / steps:.1f} us a step, "
          f"{spent / (steps * step):.2f} s per simulated second; "
          f"stick {stick / total:.4f} slip {slip / total:.4f} open {opened / total:.4f}")


if __name__ == "__main__":
    main()
