"""Free sliding: how a ring, a disc and a body of Hertz's pressure stop, and which way a curling stone would bend.

    python3 docs/python/slide.py slide.svg
"""
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from stemware import ring

R, mu, mass = 0.03, 0.3, 0.3
bodies = {"ring": ring.Pressure.ring(R), "disc": ring.Pressure.disc(R), "Hertz": ring.Pressure.hertz(R)}
figure, (left, right) = plt.subplots(1, 2, figsize=(8, 3.2), layout="constrained")
for name, body in bodies.items():
    path = ring.slide(body, mu=mu, mass=mass, speed=1.0, omega=20.0)
    eps = path["final_slip_ratio"]
    print(f"{name:5s} stops after {path['distance'][-1]:.4f} m and {path['time'][-1]:.4f} s, omega R / v = {eps:.10f}")
    left.plot(path["speed"], path["omega"] * R, label=name)
left.plot([0, 1], [0, 1], "k:", lw=0.8)
left.set(xlabel="speed (m/s)", ylabel="ωR (m/s)")
left.legend()

# A curling stone, as Coulomb's friction would have it: friction below the centre of mass presses the front down.
stone = ring.Pressure.ring(0.065)
for sense in (1, -1):
    path = ring.slide(stone, mu=0.01, mass=19.0, speed=2.0, omega=sense * 1.5, yaw_inertia=0.2, centre_of_mass_height=0.065)
    side = "left" if path["y"][-1] > 0 else "right"
    print(f"stone, spin {sense * 1.5:+.1f} rad/s: {path['x'][-1]:.2f} m ahead, {1e3 * abs(path['y'][-1]):.2f} mm to the {side}")
    right.plot(path["x"], 1e3 * path["y"], label=f"spin {sense * 1.5:+.1f} rad/s")
right.set(xlabel="x (m)", ylabel="y, to the left (mm)", title="a stone, constant friction")
right.legend()
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "slide.svg")
