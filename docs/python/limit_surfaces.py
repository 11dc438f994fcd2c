"""Limit surfaces of six contacts, and the approximations in simulators.

    python3 docs/python/limit_surfaces.py limit_surfaces.svg
"""
import os
import sys
import tempfile
import warnings
from typing import Any, Dict, Tuple

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from stemware import figures, ring

R = 0.03
# Stands for a pressure of another program: a crowned ring with the moment ratio 0.7.
r, theta = np.linspace(0.8 * R, R, 41), np.arange(64) * 2 * np.pi / 64
p = np.outer(1 - ((r - 0.9 * R) / (0.1 * R))**2, 1 + 0.7 * np.sin(theta))
with tempfile.TemporaryDirectory() as folder:
    file = os.path.join(folder, "pressure.csv")
    rows = np.column_stack([np.repeat(r, theta.size), np.tile(theta, r.size), p.ravel()])
    np.savetxt(file, rows, delimiter=",", header="r (m),theta (rad),pressure (Pa)", comments="")
    leaning = ring.stack_from_csv(file)
loads: Dict[str, Tuple[Any, Dict[str, Any]]] = {
    "disc": (ring.Pressure.disc(R), {}),
    "annulus, 0.7 R to R": (ring.Pressure.annulus(0.7 * R, R), {}),
    "Hertz": (ring.Pressure.hertz(R), {}),
    "crowned ring": (ring.Pressure(lambda r: 1 - ((r - 0.9 * R) / (0.1 * R))**2, 0.8 * R, R), {}),
    "ring, moment ratio 0.7": (ring.RingStack.first_harmonic(normal_force=1.0, moment=(0.35 * R, 0), radius=R),
                               {"about": "centre of pressure"}),
    "crown from a CSV, 0.7": (leaning, {"about": "centre of pressure"}),
}
warnings.simplefilter("ignore")  # the table has the error of each form
figure, axes = plt.subplots(1, 6, figsize=(15.5, 3.4), layout="constrained")
print("                        arm/R  stands for it    lies outside by     its wrench in one slip is off by")
for ax, (name, (load, options)) in zip(axes, loads.items()):
    s = ring.limit_surface(load, n=1441, **options)
    forms = {"ellipsoid": s.ellipsoid()}
    if isinstance(load, ring.Pressure):
        forms.update({"Padé, order 1": s.pade(1), "Padé, order 2": s.pade(2)})
    for form, (force, torque) in forms.items():
        excess = 100 * s.excess(force, torque)
        wrong = 100 * np.hypot(force - s.force, torque - s.torque).max()
        low, high = (round(x, 1) + 0.0 for x in (excess.min(), excess.max()))  # + 0.0: prints -0.0 as 0.0
        print(f"{name:22s} {s.arm / R:6.4f}  {form:14s} {low:+6.1f} … {high:+5.1f} %   {wrong:5.1f} %")
    figures.limit_surface(s, ax).set_title(name, fontsize=9)
axes[0].legend(fontsize=7)
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "limit_surfaces.svg")
