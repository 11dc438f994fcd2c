"""Free sliding: motion of a ring, a disc and a body with a Hertzian pressure after a push, by scipy's solve_ivp on ring.wrench.

    python3 docs/python/slide.py slide.svg
"""
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
from scipy.integrate import solve_ivp

from stemware import ring

R, mu, mass, g = 0.03, 0.3, 0.3, 9.81
bodies = {"ring": ring.Pressure.ring(R), "disc": ring.Pressure.disc(R), "Hertz": ring.Pressure.hertz(R)}
figure, ax = plt.subplots(layout="constrained")
for name, body in bodies.items():
    def rate(t, y, body=body, inertia=mass * body.mean_power(2)):  # y: speed, omega, distance, angle
        T = ring.wrench(body, max(y[0], 1e-9), y[1], mu=mu, normal_force=mass * g)
        return [T.force_x / mass, T.torque / inertia, y[0], y[1]]

    def nearly_at_rest(t, y):  # v and omega vanish simultaneously; friction is undefined there
        return abs(y[0]) + abs(y[1]) * R - 1e-6
    nearly_at_rest.terminal = True  # type: ignore[attr-defined]
    path = solve_ivp(rate, (0, 2), [1.0, 20.0, 0, 0], events=nearly_at_rest, rtol=1e-9, atol=1e-12)
    speed, omega, distance, _ = path.y
    print(f"{name:5s} stops after {distance[-1]:.4f} m and {path.t[-1]:.4f} s, omega R / v = {omega[-1] * R / speed[-1]:.3f}")
    ax.plot(speed, omega * R, label=name)
ax.set(xlabel="speed (m/s)", ylabel="ωR (m/s)")
ax.legend()
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "slide.svg")
