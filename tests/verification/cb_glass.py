"""CB-glass by CalculiX: the states of docs/verification/cb_glass.json, with calculix_foot.py. No code of the program.

The foot "crown" of calculix_foot.py on a mat of 1e10 Pa/m, the moment at -90 degrees. Harmonics and the largest pressure are
taken at its Gauss points; share: the azimuths of the Gauss points in contact. The terminal spin is the zero of
tau_z = sum f (x t_y - y t_x), t = -mu (v - omega y, omega x) / |v_rel|, over the same points. torque_change: tau_z at half
the terminal spin of the harmonics up to 6, on a ring of radius R, minus tau_z of the first harmonic only, over |tau_z| at rest.

/usr/bin/python3 cb_glass.py > cb_glass.json (CalculiX and numpy as in calculix_foot.py; ten minutes)
"""
import json
import sys
import time

import numpy as np
from calculix_foot import Foot, N, R

mu, v, K = 0.3, 0.35, 1e10


def torque(foot, force, omega):
    x, y = foot.positions[..., 0], foot.positions[..., 1]
    slip_x, slip_y = v - omega * y, omega * x
    return float((-mu * force * (x * slip_y - y * slip_x) / np.hypot(slip_x, slip_y)).sum())


def terminal_spin(foot, force):
    slow, fast = 0.0, -v / R
    for _ in range(60):
        middle = (slow + fast) / 2
        if torque(foot, force, middle) < 0:
            slow = middle
        else:
            fast = middle
    return slow


def torque_of_harmonics(a, b, omega):
    """tau_z [N m] of a load (harmonics over a_0) on a ring of radius R, by the midpoint rule."""
    theta = (np.arange(20000) + 0.5) * 2 * np.pi / 20000
    density = N * sum(a[n] * np.cos(n * theta) + b[n] * np.sin(n * theta) for n in range(len(a)))
    slip_x, slip_y = v - omega * R * np.sin(theta), omega * R * np.cos(theta)
    lever = np.cos(theta) * slip_y - np.sin(theta) * slip_x
    return float(-mu * R * np.mean(density * lever / np.hypot(slip_x, slip_y)))


def torque_change(a, b, terminal_spin):
    first, all_of_them = (torque_of_harmonics(a[:n], b[:n], terminal_spin / 2) for n in (2, None))
    return (all_of_them - first) / abs(torque_of_harmonics(a, b, 0.0))


def main():
    started = time.time()
    foot = Foot("crown", 48, (80, 3))
    states = []
    for m in (0.5, 1.225, 1.52):
        load = foot.press(K, m, direction=-np.pi / 2)
        force = foot.forces
        # The mesh is uniform round the axis: every azimuth of Gauss points has the same angular weight.
        azimuths = np.round(foot.theta % (2 * np.pi), 9)
        loaded = np.unique(azimuths[force > 0]).size / np.unique(azimuths).size
        spin = terminal_spin(foot, force)
        states.append({"moment_ratio": m, "a_over_a0": load["a_over_a0"], "b_over_a0": load["b_over_a0"],
                       "share_of_azimuths": loaded, "peak_pressure": float((force / foot.weights).max()),
                       "tau_at_rest": torque(foot, force, 0.0), "terminal_spin": spin,
                       "torque_change": torque_change(load["a_over_a0"], load["b_over_a0"], spin)})
        print(m, f"{time.time() - started:.0f} s", file=sys.stderr, flush=True)
    print(json.dumps({"about": __doc__.strip(), "states": states}, indent=1))


if __name__ == "__main__":
    main()
