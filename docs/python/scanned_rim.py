"""Scanned rim: propagates the scatter of the points to standard errors of the radii and of the spin.

    python3 docs/python/scanned_rim.py scanned_rim.svg
"""
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from scipy.optimize import curve_fit

import stemware

r = np.linspace(-0.8e-3, 0.8e-3, 41) + 30e-3  # scan of a circle of radius 3 mm, scatter 5 micrometres
z = 3e-3 - np.sqrt(9e-6 - (r - 30e-3)**2) + np.random.default_rng(1).normal(0, 5e-6, r.size)


def arc(r, R, crown, lowest):
    return lowest + crown - np.sqrt(crown**2 - (r - R)**2)


(R, crown, lowest), C = curve_fit(arc, r, z, (30e-3, 3e-3, 0))
s = np.sqrt(np.diag(C))[:2]
print(f"contact radius {1e3 * R:.3f} ± {1e3 * s[0]:.3f} mm, crown radius {1e3 * crown:.2f} ± {1e3 * s[1]:.2f} mm")
rims = [(R, crown), (R - s[0], crown), (R + s[0], crown), (R, crown - s[1]), (R, crown + s[1])]
found = stemware.solve([{"Glass/Contact radius": a, "Glass/Crown radius": b} for a, b in rims])
w = found["omega_terminal"].astype(float)
g = np.array([w[2] - w[1], w[4] - w[3]]) / (2 * s)
print(f"terminal spin {w[0]:.4f} ± {np.sqrt(g @ C[:2, :2] @ g):.4f} rad/s by the scatter of the points")

figure, ax = plt.subplots(figsize=(5, 3), layout="constrained")
ax.plot(1e3 * r, 1e6 * z, "k.", ms=4, label="points")
ax.plot(1e3 * r, 1e6 * arc(r, R, crown, lowest), "C0", label="circle")
ax.set(xlabel="r (mm)", ylabel="z (µm)")
ax.legend()
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "scanned_rim.svg")
